/** Tests of what the runner says of a SWF that gives no sign of life. */
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { deflateSync } from 'node:zlib';
import { problemOf } from '../../build/headless/swf.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = path.join(root, 'bin/generated/stall-test');
const skip = existsSync(process.env.CHROME || '/usr/bin/chromium') ? false : 'there is no Chromium';

const STAGE = [0x78, 0x00, 0x05, 0x5f, 0x00, 0x00, 0x0f, 0xa0, 0x00]; // 550 x 400 pixels
const RATE = [0x00, 0x18, 0x01, 0x00]; // 24 a second, one frame
const SHOW = [0x40, 0x00];
const END = [0x00, 0x00];
const LOOP = [0x06, 0x03, 0x99, 0x02, 0x00, 0xfb, 0xff, 0x00]; // DoAction: a jump to itself

/** DoAction: traces a text, and then does other actions. */
function traced(text, then = [0x00]) {
	const push = [0x00, ...Buffer.from(text), 0x00];
	const actions = [0x96, push.length, 0x00, ...push, 0x26, ...then];
	return [0x3f, 0x03, actions.length, 0x00, 0x00, 0x00, ...actions];
}

/** Writes a SWF of version 6 with these tags. */
function swf(name, ...tags) {
	const body = [...STAGE, ...RATE, ...tags.flat(), ...SHOW, ...END];
	const length = body.length + 8; // below 256
	mkdirSync(folder, { recursive: true });
	const file = path.join(folder, name);
	writeFileSync(file, Buffer.from([0x46, 0x57, 0x53, 6, length, 0, 0, 0, ...body]));
	return file;
}

function run(file, seconds, ...others) {
	const run = [path.join(root, 'build/headless/run.mjs'), file, '--stall', String(seconds), ...others];
	const { status, stderr } = spawnSync(process.execPath, run, { encoding: 'utf8' });
	return { status, stderr };
}

test('a SWF that waits is told from one whose call does not end', { skip }, () => {
	rmSync(folder, { recursive: true, force: true });
	const waiting = run(swf('waiting.swf'), 30);
	assert.equal(waiting.status, 70);
	assert.match(waiting.stderr, /stalled: 30 s without a sign of life, but [1-9]\d* frames: it /);
	const looping = run(swf('looping.swf', LOOP), 15);
	assert.equal(looping.status, 70);
	assert.match(looping.stderr, /stalled: 15 s without a sign of life, and no frame in the last \d+ s: one call takes longer, or has no end/);
});

test('Ctrl+C and --seconds end a SWF that goes on, with a picture', { skip }, async () => {
	const file = swf('going-on.swf', traced('it runs'));
	const picture = path.join(folder, 'going-on.png');
	const options = [path.join(root, 'build/headless/run.mjs'), file, '--screenshot', picture];
	const interrupted = spawn(process.execPath, options, { stdio: ['ignore', 'pipe', 'inherit'] });
	await once(interrupted.stdout, 'data');
	rmSync(picture, { force: true });
	interrupted.kill('SIGINT');
	assert.deepEqual(await once(interrupted, 'exit'), [130, null]);
	assert.ok(existsSync(picture), 'the picture of Ctrl+C');
	rmSync(picture);
	const ended = spawnSync(process.execPath, [...options, '--seconds', '2'], { encoding: 'utf8' });
	assert.deepEqual([ended.status, ended.stderr], [0, 'headless: ended after 2 s\n']);
	assert.ok(existsSync(picture), 'the picture of --seconds');
	const refused = spawnSync(process.execPath, [...options, '--seconds', 'soon'], { encoding: 'utf8' });
	assert.equal(refused.status, 64);
	assert.match(refused.stderr, /--seconds must be a number greater than 0: soon/);
	const looping = run(swf('looping.swf', LOOP), 30, '--seconds', '4');
	assert.equal(looping.status, 0);
	assert.match(looping.stderr, /^headless: ended after 4 s, in the middle of one call: no frame in the last \d+ s\n$/);
});

for (const [signal, status] of [['SIGTERM', 143], ['SIGHUP', 129]]) {
	test(`${signal} ends a SWF that goes on`, { skip }, async () => {
		const file = swf('going-on.swf', traced('it runs'));
		const player = spawn(process.execPath, [path.join(root, 'build/headless/run.mjs'), file], { stdio: ['ignore', 'pipe', 'pipe'] });
		const said = player.stderr.setEncoding('utf8').toArray();
		await once(player.stdout, 'data');
		player.kill(signal);
		assert.deepEqual(await once(player, 'exit'), [status, null]);
		assert.deepEqual(await said, []);
	});
}

test('a browser that does not start ends the run', { skip }, () => {
	const options = [path.join(root, 'build/headless/run.mjs'), swf('going-on.swf', traced('it runs'))];
	const { status, stderr } = spawnSync(process.execPath, options, { encoding: 'utf8', timeout: 60000, env: { ...process.env, CHROME: '/bin/false' } });
	assert.equal(status, 70);
	assert.match(stderr, /^headless: [^\n]*launch/);
});

test('a part that fails does not stop the others', { skip }, () => {
	const { status, stderr } = run(swf('parts.swf', LOOP), 3, '--parts', '2');
	assert.equal(status, 70);
	assert.match(stderr, /part 1\/2: the SWF stalled.*\n.*part 2\/2: the SWF stalled/);
});

/** Runs a SWF as client-test does, or a script in the player's place: what is printed, and the counts. Texts name the known tests. */
function runClient(file, known = '', seconds = '5', ...player) {
	writeFileSync(path.join(folder, 'tests.txt'), known);
	const { status, stdout } = spawnSync(process.execPath, [path.join(root, 'test/runner/client-tests-run.mjs'), folder, file, seconds, ...player], { encoding: 'utf8' });
	return { status, stdout, counts: readFileSync(path.join(folder, 'counts.txt'), 'utf8') };
}

/** The same with what a client's SWF would trace, and then a script. */
function runTraces(said, then = '', known = '') {
	mkdirSync(folder, { recursive: true });
	const script = path.join(folder, 'player.mjs');
	writeFileSync(script, `console.log(${JSON.stringify(said.join('\n'))});\n${then}\n`);
	return runClient('client.swf', known, '0.2', script);
}

test('the last test that a client\'s SWF has begun is the one that did not end', { skip }, () => {
	const said = ['  @test a.M.ends', '  @test a.M.hangs (M.as:7)', '  @test a.M.later', '  @test a.N.one', '  @test a.N.two', '  @begin a.M.ends', '  @begin a.M.hangs (M.as:7)'];
	const { status, stdout, counts } = runClient(swf('hanging.swf', traced(said.join('\n'), LOOP.slice(2))));
	assert.equal(status, 70);
	assert.match(stdout, /^ {2}1\/5 a\.M\.ends\n {2}2\/5 a\.M\.hangs \(M\.as:7\)\nFAILED a\.M\.hangs \(M\.as:7\): did not end within 5 s, and no frame in the last \d+ s: .*\nthe player starts again for the tests that are left: 3\n[^]*\nnot run: a\.M\.later, a\.N\n/);
	assert.equal(counts, '1 passed, 1 failed, 0 ignored, 3 not run');
	// the build's own reporter calls Host.exit
	const waiting = runClient(swf('waiting-client.swf', traced('  @begin game.MeetTest.waits')));
	assert.match(waiting.stdout, /^FAILED game\.MeetTest\.waits: did not end within 5 s, but \d+ frames: it (?!.*Host)/m);
});

test('what hangs before the tests of a class does not fail the test that ended before', () => {
	const said = ['  @test a.A.good', '  @test a.B.one', '  @begin a.A.good', '  @now a.A [AfterClass]', '  @now a.B [BeforeClass] (B.as:6)'];
	const { status, stdout, counts } = runTraces(said, 'console.error("headless: the SWF stalled: 6 s without a sign of life, and no frame");');
	assert.equal(status, 70);
	assert.equal(stdout, `  1/2 a.A.good\nFAILED a.B [BeforeClass] (B.as:6): did not end within 6 s, and no frame\nnot run: a.B\n${counts}\n`);
	assert.equal(counts, '1 passed, 1 failed, 0 ignored, 1 not run');
});

test('a late error fails no test: the one that it stops runs again in another player, and so do those after it', () => {
	const begins = ['  @tests', '  @test a.A.one', '  @test a.A.two (A.as:7)', '  @test a.B.one', '  @test a.C.no', '  @test a.C.one', '  @begin a.C.one', '  @ignore a.C.no', '  @begin a.A.one', '  @begin a.A.two (A.as:7)'];
	const goesOn = ['  @now a.B, static initialiser', '  @tests', '  @test a.A.two (A.as:7)', '  @test a.B.one', '  @begin a.A.two (A.as:7)', 'FAILED a.A.two (A.as:7): 1, not 2', '  @begin a.B.one'];
	const { status, stdout, counts } = runTraces([], `
		const without = process.argv.find((each) => each.startsWith('without=')).slice(8);
		console.log((without === '' ? ${JSON.stringify(begins)} : ['without ' + without, ...${JSON.stringify(goesOn)}]).join('\\n'));
		if (without === '') console.error('headless: the SWF threw: Error in AVM2 timer callback: Error: later\\n\\tat a::A()');`, 'a.A.one\na.A.noLonger\n');
	assert.equal(status, 70);
	assert.match(stdout, /^ {2}4\/5 a\.A\.two \(A\.as:7\)\nFAILED a late error, during a\.A\.two \(A\.as:7\): the SWF threw: Error in AVM2 timer callback: Error: later; perhaps of a timer or listener of an earlier test\. Before it ran a\.C\.one, a\.A\.one\n\tat a::A\(\)$/m);
	assert.match(stdout, /^the player starts again for the tests that are left: 2\n\nwithout a\.C,a\.A\.one\n {2}4\/5 a\.A\.two \(A\.as:7\)\nFAILED a\.A\.two \(A\.as:7\): 1, not 2\n {2}5\/5 a\.B\.one\n/m);
	assert.equal(counts, '3 passed, 2 failed, 1 ignored, 0 not run');
});

test('an error after the last test fails the run, and what a test throws that is no Error fails the test', () => {
	const said = ['  @test a.A.on', '  @begin a.A.on', '  @now the frames after the last test'];
	const throws = (what) => `console.error('headless: the SWF threw: Error dispatching event ${what}');`;
	const late = runTraces(said, throws('"enterFrame": Error: late'));
	assert.match(late.stdout, /^FAILED a late error, during the frames after the last test: the SWF threw: .* Before it ran a\.A\.on\n1 passed, 1 failed/m);
	assert.equal(late.status, 70);
	const own = runTraces(said.slice(0, 2), throws('"timerComplete": a string'));
	assert.match(own.stdout, /^FAILED a\.A\.on: the test threw what is no Error: a string\n0 passed, 1 failed/m);
});

test('of very many lines that a client\'s test traces the first are shown', () => {
	const { stdout } = runTraces(['  @test a.A.on', '  @test a.A.two', '  @begin a.A.on', ...Array(1234).fill('x'), '  @begin a.A.two', 'y']);
	assert.match(stdout, /^ {2}1\/2 a\.A\.on\n(x\n){1000}\.\.\. and 234 lines more\n {2}2\/2 a\.A\.two\ny\n2 passed/m);
});

test('a client\'s test that traces without end is ended', () => {
	const { status, stdout, counts } = runTraces(['  @test a.A.on', '  @begin a.A.on'], 'setInterval(() => console.log("on"), 50);');
	assert.equal(status, 70);
	assert.match(stdout, /^FAILED a\.A\.on: did not end within 2 s, 10 times -Dstall, though it traced meanwhile$/m);
	assert.equal(counts, '0 passed, 1 failed, 0 ignored, 0 not run');
});

test('of a stack that a client\'s SWF traces, FlexUnit\'s calls are left out, and a class that fails has passed no test', () => {
	const said = ['FAILED a.B, static initialiser (B.as:3): no: none', '  @tests', '  @test a.A.on', '  @begin a.A.on', 'Error: no', '\tat org.flexunit::Assert/fail()', '\tat a::A()',
		'\tat org.flexunit.runners::Suite/run()', '\tat flash.events::EventDispatcher/dispatchEvent()', 'FAILED a.A.on: no', '\tat a::A/on()'];
	const { status, stdout } = runTraces(said, '', 'a.A.noLonger\na.B.one (B.as:5)\n');
	assert.equal(status, 1);
	assert.equal(stdout, 'FAILED a.B, static initialiser (B.as:3): no: none\n  1/2 a.A.on\nError: no\n\tat a::A()\nFAILED a.A.on: no\n\tat a::A/on()\nnot run: a.B\n0 passed, 2 failed, 0 ignored, 1 not run\n');
});

test('a file that is no SWF, or not all of one, is not played', () => {
	const file = swf('whole.swf');
	const whole = readFileSync(file);
	const refused = (bytes) => {
		writeFileSync(path.join(folder, 'odd.swf'), bytes);
		return run(path.join(folder, 'odd.swf'), 1);
	};
	assert.match(refused('# A page of text').stderr, /^headless: .*odd\.swf is no SWF\n$/);
	assert.match(refused(whole.subarray(0, -1)).stderr, /^headless: .*odd\.swf is no whole SWF: its end is missing\n$/);
	const packed = Buffer.concat([Buffer.from('CWS'), whole.subarray(3, 8), deflateSync(whole.subarray(8))]);
	const cut = refused(packed.subarray(0, -9));
	assert.equal(cut.status, 64);
	assert.match(cut.stderr, /is no whole SWF: its end is missing, or its bytes are damaged\n$/);
	assert.equal(problemOf(packed), '');
	assert.equal(problemOf(whole), '');
});

test('a file that must not be written ends the run, and says so', () => {
	const shell = path.join(folder, 'shell');
	mkdirSync(shell, { recursive: true });
	for (const file of ['builtin.abc', 'shell_toplevel.abc']) writeFileSync(path.join(shell, file), '');
	writeFileSync(path.join(shell, 'avmshell'), '#!/bin/sh\nprintf "\\001write ../evil.txt text\\n"\nexec sleep 60\n', { mode: 0o755 });
	const name = Buffer.from('Main\0');
	const symbols = [0x04 + name.length, 0x13, 1, 0, 0, 0, ...name]; // SymbolClass: the SWF itself is a Main
	const options = [path.join(root, 'build/headless/run.mjs'), swf('writing.swf', symbols), '--player', 'avmshell', '--out', path.join(folder, 'out')];
	const { status, stderr } = spawnSync(process.execPath, options, { encoding: 'utf8', env: { ...process.env, AVMSHELL: shell } });
	assert.equal(status, 70);
	assert.match(stderr, /^headless: the SWF wants to write outside .*out: \.\.\/evil\.txt\n$/);
	assert.ok(!existsSync(path.join(folder, 'evil.txt')));
});

test('a wrong option is refused, with the nearest', () => {
	assert.deepEqual(run('a.swf', 1, '--secnds', '3'), { status: 64, stderr: 'headless: there is no option --secnds; there is --seconds\n' });
	assert.deepEqual(run('a.swf', 1, '--xyzzy'), { status: 64, stderr: 'headless: there is no option --xyzzy\n' });
	assert.deepEqual(run('a.swf', 1, '--param', 'x'), { status: 64, stderr: 'headless: expected name=value, not x\n' });
	assert.deepEqual(run('a.swf', 1, '--parts', '0'), { status: 64, stderr: 'headless: --parts must be a whole number from 1 on: 0\n' });
	assert.match(run('a.swf', 1, '--out').stderr, /^headless: [^\n]*argument missing\n$/);
});
