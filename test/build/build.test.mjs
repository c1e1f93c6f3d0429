/** Tests of the build files. */
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { setTimeout } from 'node:timers/promises';
import { failuresIn, saidOf } from '../runner/failures.mjs';
import { OF_HASHES } from '../runner/farther.mjs';
import { read, root } from '../structure/sources.mjs';

/** The build files, by their paths in the project. */
const files = ['build.xml', ...readdirSync(path.join(root, 'build')).filter((file) => file.endsWith('.xml')).map((file) => `build/${file}`)];

test('no property has two defaults: what one file means by it another would not', () => {
	assert.ok(files.length > 5);
	const defaults = new Map();
	for (const file of files) {
		// those of targets are their own
		for (const [, name] of read(file).matchAll(/^ {4}<property name="([\w.]+)"/gm)) {
			defaults.set(name, [...(defaults.get(name) ?? []), file]);
		}
	}
	assert.ok(defaults.size > 20);
	assert.deepEqual([...defaults].filter(([, where]) => where.length > 1), []);
});

const home = mkdtempSync(path.join(tmpdir(), 'ant-'));
after(() => rmSync(home, { recursive: true }));

/** Runs antw with a program in Ant's place that prints some lines and ends with a status. */
function runAnt(lines, status, ...given) {
	mkdirSync(path.join(home, 'bin'), { recursive: true });
	writeFileSync(path.join(home, 'bin/ant'), `#!/bin/sh\ncat <<'END'\n${lines.join('\n')}\nEND\nexit ${status}\n`, { mode: 0o755 });
	// a copy, whose reports are none of a run that is going on
	writeFileSync(path.join(home, 'antw'), read('antw'), { mode: 0o755 });
	return spawnSync(path.join(home, 'antw'), given.length > 0 ? given : ['compile'], { encoding: 'utf8', env: { ...process.env, ANT_HOME: home, IVY_JAR: path.join(home, 'antw') } });
}

test('a build that fails says why last, without the lines of Ant around it', () => {
	const around = ['BUILD FAILED', '/a b/build.xml:260: The following error occurred while executing this line:', '/c d/build/x.xml:91: compc (Flex):',
		'/c/src/A.as: Error: more than one definition', '', 'Total time: 8 seconds'];
	const { stdout, status } = runAnt(['-compile:', 'FAILED ATest.is: 1, not 2', '  (no stack)', 'Java Result: 1', '', ...around], 3);
	assert.equal(status, 3);
	assert.doesNotMatch(stdout.split('Total time: 8 seconds\n')[0], /BUILD FAILED|more than one/);
	assert.equal(stdout.split('Total time: 8 seconds\n')[1], '\nFAILED ATest.is: 1, not 2\ncompc (Flex):\n/c/src/A.as: Error: more than one definition\n');
	const ofExec = ['BUILD FAILED', '/a/build/module.xml:9: exec returned: 1', '', 'Total time: 8 seconds'];
	assert.equal(runAnt(['FAILED ATest.is: 1, not 2', '', ...ofExec], 1).stdout.split('seconds\n')[1], '\nFAILED ATest.is: 1, not 2\n');
	assert.equal(runAnt(ofExec, 1).stdout.split('seconds\n')[1], '\nexec returned: 1\n');
	const refused = ['-begin:', '-Dcompare: there is no file a.json', '', 'BUILD FAILED', '/a/build/timing.xml:9: exec returned: 64', '', 'Total time: 8 seconds'];
	assert.equal(runAnt(refused, 1).stdout.split('seconds\n')[1], '\n-Dcompare: there is no file a.json\n');
	assert.doesNotMatch(runAnt(['Result: 70', ...ofExec], 1).stdout, /Result/);
	const twice = ['/c/A.as(3): col: 5 Error: one', '    x++;', '/c/A.as(9): col: 5 Error: two', '    x++;'];
	for (const [long, length] of [[`FAILED ATest.is: ${'1, not 2; '.repeat(100)}`, 299], [`FAILED ATest.is: ${'1,'.repeat(300)}`, 300]]) {
		const cut = `${long.slice(0, length)}... (the whole line: bin/test-reports/failures.txt)\n`;
		assert.equal(runAnt([long, '', ...ofExec], 1).stdout, `${cut}\nTotal time: 8 seconds\n\n${cut}`);
		assert.equal(readFileSync(path.join(home, 'bin/test-reports/failures.txt'), 'utf8'), `${long}\n`);
	}
	const whole = `FAILED test/structure: every fitter: 6 files lack OwnFitter: ${'docs/a.md, '.repeat(100)}`;
	assert.equal(runAnt([whole, '', ...ofExec], 1).stdout, `${whole}\n\nTotal time: 8 seconds\n\n${whole}\n`);
	const hashes = OF_HASHES.map((name) => `FAILED ${name}: another hash`);
	const sure = 'FAILED BTest.is: 1, not 2';
	assert.equal(runAnt([...hashes, sure, '', ...ofExec], 1).stdout.split('seconds\n')[1], `\n${[sure, ...hashes].join('\n')}\n`);
	const ofParts = ['BUILD FAILED', '/a/build.xml:2: The following error occurred while executing this line:', '/a/build.xml:9: mxmlc:', ...twice, '/a/build.xml:9: mxmlc:', ...twice, '', 'Total time: 8 seconds'];
	assert.equal(runAnt(ofParts, 1).stdout.split('seconds\n')[1], `\nmxmlc:\n${twice.join('\n')}\n`);
	const other = ['/c/A.as(3): col: 7 one', 'x++;'];
	const ofCompilers = [...ofParts.slice(0, 2), ...[twice, other].flatMap((said, i) => [`/a/build.xml:9: mxmlc${['', ' (Royale)'][i]}:`, ...said]), '', 'Total time: 8 seconds'];
	assert.equal(runAnt(ofCompilers, 1).stdout.split('seconds\n')[1], `\nmxmlc:\n${twice.join('\n')}\n`);
	const good = runAnt(['BUILD SUCCESSFUL', 'Total time: 8 seconds'], 0);
	assert.equal(good.status, 0);
	assert.equal(good.stdout, 'BUILD SUCCESSFUL\nTotal time: 8 seconds\n');
});

test('what a tool says of a failure is told at once, and not only when all parts have ended', () => {
	for (const file of files) assert.doesNotMatch(read(file), /<fail [^>]*\$\{[^>]*(output|problems|lint)/, file);
});

test('a collider of the reader\'s own may be called as one of the engine\'s, in a package of its own', () => {
	const cuts = [...read('build/timing.xml').matchAll(/<replaceregex pattern="([^"]*)"(?: replace="([^"]*)")? flags="g"\/>/g)];
	const included = (given) => cuts.reduce((text, [, pattern, by = '']) => text.replace(new RegExp(pattern, 'g'), by), given);
	assert.equal(included('BinCollider,CombinationCollider,game.DiscCollider,'), 'game.DiscCollider');
	assert.equal(included('game.BinCollider,BinCollider,game.Fitter'), 'game.BinCollider,game.Fitter');
	assert.equal(included('TightestFitCollider,'), '');
});

test('an option of other targets is refused where it would do nothing', () => {
	const said = (...given) => spawnSync(process.execPath, ['build/options.mjs', ...given], { cwd: root, encoding: 'utf8' }).stderr;
	assert.equal(said('client-test', '-Dsources=src', '-Dplayer=avmshell'), 'antw: client-test does not take -Dplayer; it takes -Dsources, -Dtest, -Dlibraries, -Dstall\n');
	assert.match(said('timing', '-Dstall=3'), /^antw: timing does not take -Dstall; it takes -Dfull, -Dfigures, /);
	assert.equal(said('timing', '-Dplayer=avmshell', '-Dagents=10', '-Dbeside=false', '-Dnode', '-Dfull', '-Dtiming.out=x'), '');
	// another target may take it
	assert.equal(said('timing', 'client-test', '-Dsources=src', '-Dstall=3'), '');
	assert.equal(said('test', '-Dstall=3'), '');
});

/** A program in Ant's place that makes something and does not end. It says so when it is told to. */
function hangingAnt() {
	const lines = ['mkdir -p bin/stamps/begun', 'trap "touch ended; exit 1" TERM', 'sleep 0.1', 'touch bin/stamps/begun/file', 'while :; do sleep 0.1; done'];
	writeFileSync(path.join(home, 'bin/ant'), `#!/bin/sh\n${lines.join('\n')}\n`, { mode: 0o755 });
}

for (const signal of ['SIGTERM', 'SIGINT', 'SIGKILL']) {
	test(`a run that ${signal} ends leaves no Ant behind`, async () => {
		assert.equal(runAnt([], 0).status, 0);
		hangingAnt();
		const begun = path.join(home, 'bin/stamps/begun/file');
		const ended = path.join(home, 'ended');
		const run = spawn(path.join(home, 'antw'), ['compile'], { stdio: 'ignore', env: { ...process.env, ANT_HOME: home, IVY_JAR: path.join(home, 'antw') } });
		while (!existsSync(begun)) await setTimeout(20);
		run.kill(signal);
		await once(run, 'exit');
		// who is killed can't do anything any more: the next run does
		if (signal === 'SIGKILL') assert.equal(runAnt([], 0).status, 0);
		assert.ok(existsSync(ended));
		assert.deepEqual(readdirSync(path.join(home, 'bin/stamps/runs')), []);
		rmSync(ended);
		rmSync(begun);
	});
}

test('the list of targets leaves a run in the same folder its counts, and prints none', () => {
	assert.equal(runAnt([], 0).status, 0);
	const counts = path.join(home, 'bin/test-reports/summary-node.txt');
	mkdirSync(path.dirname(counts), { recursive: true });
	writeFileSync(counts, '1 passed, 0 failed, 0 skipped\n');
	assert.equal(runAnt(['Main targets:'], 0, '-p').stdout, 'Main targets:\n');
	assert.ok(existsSync(counts));
	rmSync(path.dirname(counts), { recursive: true });
});

test('an option reaches its check as it was given', () => {
	mkdirSync(path.join(home, 'build'), { recursive: true });
	writeFileSync(path.join(home, 'build/options.mjs'), 'console.log(...process.argv.slice(2));');
	assert.match(runAnt([], 0, 'test', '-Dtest=a b', '-Dfull').stdout, /^test -Dtest=a b -Dfull\n/);
	rmSync(path.join(home, 'build'), { recursive: true });
});

test('a second run in the folder is refused until the first has ended, or is a server\'s', async () => {
	assert.equal(runAnt([], 0).status, 0);
	hangingAnt();
	const env = { ...process.env, ANT_HOME: home, IVY_JAR: path.join(home, 'antw') };
	const run = spawn(path.join(home, 'antw'), ['compile'], { stdio: 'ignore', env });
	while (!existsSync(path.join(home, 'bin/stamps/begun/file'))) await setTimeout(20);
	const { status, stderr } = runAnt([], 0);
	assert.equal(status, 75);
	assert.match(stderr, new RegExp(`^antw: another run is going on in this folder, process ${run.pid}: `));
	rmSync(path.join(home, 'bin/stamps/making'));
	assert.equal(runAnt([], 0).status, 0);
	for (const file of ['js/playground/serve.mjs', 'build/examples/serve.mjs']) {
		const [target] = files.map(read).map((text) => text.split(`<node script="${file}">`)[0]).filter((text, i) => text !== read(files[i]));
		assert.match(target, /<delete file="\$\{stamps\}\/making" quiet="true"\/>\s+$/, file);
	}
	run.kill('SIGTERM');
	await once(run, 'exit');
	assert.equal(runAnt([], 0).status, 0);
});

test('what is made is made again after any edit of its sources: in the same second, or while it is made, or one that deletes a source', () => {
	const project = path.join(home, 'made.xml');
	writeFileSync(project, `<project default="make" basedir="." xmlns:unless="ant:unless">
		<property name="stamps" value="stamps"/>
		<property name="flex.home" value="sdk"/>
		<property name="target.player" value="11.1"/>
		<import file="${path.join(root, 'build/make.xml')}"/>
		<target name="make">
			<make file="out.txt">
				<of><fileset dir="." includes="in.txt,other.txt"/></of>
				<by><fail if="broken"/><copy file="in.txt" tofile="out.txt" overwrite="true"/><fail if="late"/></by>
			</make>
		</target>
	</project>`);
	const at = (name) => path.join(home, name);
	const time = (name) => statSync(at(name)).mtimeMs / 1000;
	const isMade = (...options) => {
		const before = statSync(at('out.txt'), { throwIfNoEntry: false })?.mtimeMs;
		spawnSync(process.env.ANT_HOME ? path.join(process.env.ANT_HOME, 'bin/ant') : 'ant', ['-q', '-f', project, ...options], { encoding: 'utf8' });
		return statSync(at('out.txt'), { throwIfNoEntry: false })?.mtimeMs !== before;
	};
	const edit = (seconds) => utimesSync(at('in.txt'), seconds, seconds);
	writeFileSync(at('in.txt'), 'one');
	assert.ok(isMade(), 'at first');
	assert.ok(!isMade(), 'nothing changed');
	edit(time('out.txt') + 0.01);
	assert.ok(isMade(), 'an edit a moment after');
	// it had been begun before the file was written
	utimesSync(at('out.txt'), time('out.txt') + 9, time('out.txt') + 9);
	edit(time('out.txt') - 1);
	assert.ok(isMade(), 'an edit while it was made');
	// its time is still to come, and an edit of that time counts until then
	edit(time('out.txt') - 60);
	writeFileSync(at('other.txt'), 'two');
	assert.ok(!isMade('-Dbroken=true'));
	assert.ok(isMade(), 'after one that failed');
	writeFileSync(at('other.txt'), 'three');
	assert.ok(isMade('-Dlate=true'));
	assert.ok(isMade(), 'after one that failed when it had written the file');
	assert.ok(!isMade());
	rmSync(at('out.txt'));
	assert.ok(isMade(), 'the file itself is gone');
	rmSync(at('other.txt'));
	assert.ok(isMade(), 'a source is gone');
	assert.ok(!isMade(), 'nothing changed since');
	for (const option of ['-Dflex.home=other', '-Dtarget.player=10.2']) {
		assert.ok(isMade(option), option);
		assert.ok(!isMade(option), `${option} again`);
		assert.ok(isMade(), `no longer ${option}`);
	}
	mkdirSync(at('build'));
	writeFileSync(at('build/ivy.xml'), 'other versions of the compiler');
	assert.ok(isMade(), 'another compiler');
	assert.ok(!isMade(), 'nothing changed since that');
});

test('another version of a library takes the place of the one that was fetched', () => {
	assert.match(read('build.xml'), /<ivy:resolve [^]*<delete\b[^]*<ivy:retrieve (?![^>]*sync=)/);
});

test('every part of the build asks that way', () => {
	for (const file of files) assert.doesNotMatch(read(file), /<uptodate [^>]*[^/]>/, file);
});

test('tests that fail without a player are named, whatever Node prints', () => {
	const tap = 'TAP version 13\n# Subtest: a.test.mjs\n    not ok 2 - adds two\n      ---\n    ok 3 - adds three\nnot ok 1 - a.test.mjs\nnot ok 2 - later # TODO\n';
	assert.deepEqual(failuresIn(tap), ['adds two', 'a.test.mjs']);
	const said = (error) => `not ok 1 - adds two\n  ---\n  duration_ms: 1\n  location: 'a:1:2'\n  error: ${error}\n  ...\n`;
	assert.deepEqual(failuresIn(said('|-\n    docs/a.md:3: no\n    more')), ['adds two: docs/a.md:3: no']);
	assert.deepEqual([failuresIn(said("'1 is not 2'")), failuresIn(said("'2 subtests failed'"))], [['adds two: 1 is not 2'], ['adds two']]);
	const compared = '|-\n    Expected values to be equal:\n    + actual - expected\n    \n      [\n    +   3,\n    +   4\n      ]';
	assert.deepEqual(failuresIn(said(compared)), ['adds two: Expected values to be equal: 3,']);
	assert.deepEqual(failuresIn(said(compared.replace('Expected values to be equal', '3 and 4'))), ['adds two: 3 and 4']);
	const ofTexts = "|-\n    Expected values to be equal:\n    + actual - expected\n    \n    + 'a\\nb'\n    - ''";
	assert.deepEqual(failuresIn(said(ofTexts)), ["adds two: Expected values to be equal: 'a\\nb'"]);
	assert.deepEqual(failuresIn(said("|-\n    Expected values to be equal:\n    \n    'a' !== 'b'\n    ")), ["adds two: Expected values to be equal: 'a' !== 'b'"]);
	const ofLists = '|-\n    Expected values to be equal:\n    + actual - expected\n    \n    + [\n    +   [\n    +     1,\n    +   ]\n    + ]\n    - []';
	assert.deepEqual([failuresIn(said(ofLists)), failuresIn(said('"it\'s 1"'))], [['adds two: Expected values to be equal: 1,'], ["adds two: it's 1"]]);
	const failure = 'not ok 2 - adds two\n  ---\n  error: |-\n    1, not 2\n  ...';
	assert.equal(saidOf(`TAP version 13\nok 1 - adds one\n  ---\n  duration_ms: 1\n  ...\n${failure}\nok 3 - adds three\n  ---\n  ...\n1..3\n`), failure);
	assert.equal(saidOf('TAP version 13\n'), 'TAP version 13\n');
	assert.deepEqual(failuresIn('▶ a.test.mjs\n  ✖ adds two (1.5ms)\n✔ adds three (0.2ms)\n✖ failing tests:\n\n✖ adds two (1.5ms)\n'), ['adds two']);
});

test('a name that is no option is refused, with the nearest, and so is an option without its value, and a target', () => {
	const check = (...names) => {
		const { status, stderr } = spawnSync(process.execPath, ['build/options.mjs', ...names], { cwd: root, encoding: 'utf8' });
		return [status, stderr];
	};
	assert.deepEqual(check('-Dfigure=a'), [64, 'antw: there is no option -Dfigure; there is -Dfigures\n']);
	assert.deepEqual(check('-Dcompar=a', '-Dxyzzy'), [64, 'antw: there is no option -Dcompar; there is -Dcompare\nantw: there is no option -Dxyzzy\n']);
	assert.deepEqual(check('-Dtest=a b', '-Dfull', '-Dfull=', '-Dnode', '-Dsingle', '-Dant.logger.defaults', 'test', '-Dstall=1.5', '-Dmodels=bear,cube', '-Dsources=src', '-Dcolliders=MyCollider'), [0, '']);
	for (const empty of ['-Dtest', '-Dtest=']) assert.deepEqual(check(empty), [64, 'antw: -Dtest needs a value: -Dtest=...\n']);
	// folders that the build empties
	for (const own of ['transpiled', 'module', 'bin', 'swc', 'dist', 'stamps', 'samples', 'generated']) assert.match(check(`-D${own}=a`)[1], new RegExp(`^antw: there is no option -D${own}\\b`));
	assert.doesNotMatch(check('-Dmodul=a')[1], /-Dmodule/);
	assert.deepEqual(check('--no-target', 'clienttest'), [64, 'antw: there is no target clienttest; there is client-test\n']);
	assert.deepEqual(check('--no-target', 'report'), [64, 'antw: there is no target report; see timing\n']);
	// every option that a page names is one
	const VALUES = { stall: 1, sources: 'src', libraries: 'antw', figures: 'fits', models: 'bear', agents: 1, repetitions: 1, player: 'node', beside: 'false' };
	const named = readdirSync(path.join(root, 'docs')).filter((file) => file.endsWith('.md')).flatMap((file) => [...read(`docs/${file}`).matchAll(/[ `]-D([a-z]+)\b(?!\.)/g)].map(([, name]) => name));
	assert.ok(named.length > 50);
	assert.deepEqual(check(...new Set(named.map((name) => `-D${name}=${VALUES[name] ?? 'a'}`))), [0, '']);
});

test('a value that can be none of its option\'s is refused before anything is made', () => {
	const said = (...options) => spawnSync(process.execPath, ['build/options.mjs', ...options], { cwd: root, encoding: 'utf8' }).stderr.replace(/^antw: /gm, '');
	for (const wrong of ['abc', '1.5s', '0', '-5', 'Infinity']) assert.equal(said(`-Dstall=${wrong}`), `-Dstall: seconds above 0 are needed, not "${wrong}"\n`);
	assert.equal(said('-Drepetitions=0'), '-Drepetitions: numbers of at least 1 are needed, not "0"\n');
	assert.equal(said('-Dagents=10,1.5'), '-Dagents: numbers of at least 1 are needed, not "1.5"\n');
	assert.equal(said('-Dcolliders=BinColider'), '-Dcolliders: there is no "BinColider"; there is BinCollider\n');
	assert.equal(said('-Dcolliders=my.Own'), '-Dcolliders: there is no "my.Own"; there are BinCollider, TightestFitCollider, HierarchicalCollider, CombinationCollider, and -Dsources= names the folder of your own\n');
	assert.equal(said('-Dfitters=my.Own'), '-Dfitters: -Dsources= names the folder that has my.Own\n');
	assert.equal(said('-Dfitters=my.Own', '-Dsources=src'), '');
	assert.equal(said('-Dmodels=bear,cub'), '-Dmodels: there is no "cub"; there is cube\n');
	assert.match(said('-Dfigures=xyzzy'), /^-Dfigures: there is no "xyzzy"; there are volumes, fits, .*, monitor\n$/);
	assert.equal(said('-Dsources=src/client,test,src,src'), '-Dsources: src/client is in src. Name only the folder in which the packages of its classes begin\n');
	assert.equal(said('-Dlibraries=src,antw'), '-Dlibraries: the folder src has no SWC\n');
	assert.equal(said('-Dplayer=flash'), '-Dplayer: there is no "flash"; there are ruffle, avmshell, node\n');
	assert.equal(said('timing', '-Dplayer=node'), '-Dplayer: there is no "node"; there are ruffle, avmshell\n');
	assert.equal(said('-Dbeside=maybe'), '-Dbeside: true or false is needed, not "maybe"\n');
	assert.equal(said('-Dsources=antw'), '-Dsources: antw is a file. Name the folder in which the packages of its classes begin\n');
	assert.equal(said('-Dsources=src,/no/folder', '-Dlibraries=/no/file.swc'), '-Dsources: there is no folder /no/folder\n-Dlibraries: there is no file /no/file.swc\n');
});
