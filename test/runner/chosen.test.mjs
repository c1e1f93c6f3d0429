/** Tests of what -Dtest finds. */
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { choose, nearestNames, testsBefore } from './chosen.mjs';
import { BROAD, fartherTests, testFilesOf, testsOfPages } from './farther.mjs';
import { readTests, testsIn } from './test-classes.mjs';
import { root } from '../structure/sources.mjs';

const known = readTests();

/** The tests that a pattern finds in the project: "IntersectsTest" for a whole class, "BoxTest.volume" for one test. */
function found(pattern) {
	const { tests } = choose(pattern, known.classes, known.sources);
	return [...tests].flatMap(([name, list]) => list?.map((each) => `${name.split('.').pop()}.${each}`) ?? [name.split('.').pop()]);
}

test('a class of tests is found by a part of its name, in any case', () => {
	for (const pattern of ['Intersects', 'intersects', 'INTERSECTSTEST', 'starlogo.intersection.IntersectsTest', 'starlogo.intersection.intersects']) {
		assert.deepEqual(found(pattern), ['IntersectsTest'], pattern);
	}
	assert.deepEqual(found('test/starlogo/intersection/IntersectsTest.as'), ['IntersectsTest']);
	assert.ok(found('hierarch').length > 4);
	assert.deepEqual(found('noSuchName'), []);
});

test('a test is found by a part of its name, in any case, with or without its class', () => {
	for (const pattern of ['AgentTest.transform', 'agenttest#TRANSFORM', 'starlogo.agents.AgentTest.transform']) {
		assert.ok(found(pattern).length > 0 && found(pattern).every((name) => /^AgentTest\.transform/.test(name)), pattern);
	}
	const ofAnyClass = found('.sphereBox');
	assert.ok(ofAnyClass.length > 1 && ofAnyClass.every((name) => /\.\w*sphereBox/i.test(name)));
	assert.ok(found('PierceBoxes').includes('IntersectsTest.findsSegmentsThatPierceBoxes'), 'no class and no source has this name');
	assert.deepEqual(found('AgentTest.noSuchTest'), []);
});

test('a class or a test of exactly a name is taken alone, and where there is no such test those of the class are named', () => {
	const texts = (...tests) => tests.map((name) => `[Test]\n public function ${name}\n`).join('');
	const classes = new Map([['game.MeetTest', texts('two', 'twoMore')], ['game.TurtlesMeetTest', texts('two')], ['other.MeetTest', texts('two', 'three')]]);
	const of = (pattern) => [...choose(pattern, classes, new Map()).tests].map(([name, list]) => [name, ...list ?? []].join(' '));
	for (const pattern of ['meetTest.Two', 'MeetTest#two']) assert.deepEqual(of(pattern), ['game.MeetTest two', 'other.MeetTest two'], pattern);
	assert.deepEqual(of('game.MeetTest.two'), ['game.MeetTest two']);
	assert.deepEqual(of('other.MeetTest'), ['other.MeetTest']);
	assert.deepEqual(of('MeetTest'), ['game.MeetTest', 'other.MeetTest']);
	assert.deepEqual(of('MeetTest.tw'), ['game.MeetTest two twoMore', 'game.TurtlesMeetTest two', 'other.MeetTest two']);
	assert.deepEqual(choose('MeetTest.twoMore', classes, new Map()).said, ['the test: MeetTest (twoMore)']);
	assert.deepEqual(testsBefore('game.MeetTest.tow', classes), ['game.MeetTest.two', 'game.MeetTest.twoMore']);
	assert.deepEqual(testsBefore('tow', classes), []);
});

test('the tests of a source are those that use it, in any case', () => {
	const files = ['sphereBox', 'SphereBox', 'spherebox.as', 'src/starlogo/intersection/sphereBox.as', 'src\\starlogo\\intersection\\sphereBox.as'];
	for (const pattern of files) {
		for (const name of ['KernelsAgreeTest', 'PairVectorsTest']) assert.ok(found(pattern).includes(name), `${pattern}: ${name}`);
	}
	assert.ok(found('Thesis').includes('GreatLandTest.flagsAreTheThesiss'), 'and what has its name');
	assert.ok(found('AgentTable').includes('AgentTableTest'));
	assert.ok(found('Matrix3D').includes('GeometryStandInsTest'), 'a stand-in');
	assert.ok(found('ModelLoader.as').includes('FormatsLoadingTest'), 'by a file beside the test, as if the test used it itself');
});

test('a path, and a name with its package, mean one source of several of that name', () => {
	const sources = new Map(['a.b.Low', 'a.c.Low', 'standin.flash.Low', 'Low'].map((name) => [name, 'public class Low']));
	const named = (pattern) => choose(pattern, new Map(), sources).named;
	assert.equal(named('Low.as').length, 4);
	for (const pattern of ['src/a/b/Low.as', './src/A/b/low.as', 'src\\a\\b\\Low.as', 'b/Low.as', '/home/x/src/a/b/Low.as']) assert.deepEqual(named(pattern).filter((name) => name !== 'Low'), ['a.b.Low'], pattern);
	assert.ok(named('js/standins/common/flash/Low.as').includes('standin.flash.Low'));
	assert.ok(!named('a.b.Low').includes('a.c.Low'));
});

test('a class with tests of its own name has these, and with .as those of what uses it too', () => {
	assert.ok(found('Box').every((name) => /Box/.test(name)));
	assert.ok(found('Box').includes('BoxTest'));
	assert.equal(found('Box.as')[0], 'BoxTest');
	assert.ok(found('Box.as').includes('IntersectsTest'));
});

test('a page is found by its path or its name, with the tests of its samples', () => {
	const classes = new Map([...known.classes, ['docs.TerrainSamplesTest', ''], ['docs.ReadmeSamplesTest', '']]);
	for (const pattern of ['docs/terrain.md', 'terrain.md', 'docs\\terrain.md']) {
		const { tests, named, pages } = choose(pattern, classes, known.sources);
		assert.deepEqual([[...tests.keys()], named, pages], [['docs.TerrainSamplesTest'], [], ['docs/terrain.md']], pattern);
	}
	assert.deepEqual([...choose('README.md', classes, known.sources).tests.keys()], ['docs.ReadmeSamplesTest']);
	assert.deepEqual(choose('noSuchPage.md', classes, known.sources).pages, []);
	assert.deepEqual(testsOfPages(['CONTRIBUTING.md', 'docs/terms.md']), []);
	assert.deepEqual(testsOfPages(['docs/queries.md']), ['test/docs/samples.test.mjs']);
});

test('for a name that nothing has the nearest are told', () => {
	const near = (pattern) => nearestNames(pattern, known.classes, known.sources);
	for (const name of ['NaiveSphereFitter', 'RitterSphereFitter']) assert.ok(near('SphereFitter').includes(name), name);
	assert.equal(near('src/starlogo/fitting/CapsulFiter.as')[0], 'CapsuleFitter');
	assert.ok(near('docs/terain.md').includes('terrain.md'));
	assert.deepEqual(near('xyzzyPlughQuux'), []);
});

test('several names are all taken', () => {
	assert.deepEqual(found('BoxTest, AgentTest.transform,noSuchName'), [...found('BoxTest'), ...found('AgentTest.transform')]);
	assert.deepEqual(found('AgentTest.transform,AgentTest'), ['AgentTest']);
	assert.deepEqual(found('AgentTest,AgentTest.transform'), ['AgentTest']);
});

test('every source of the engine has tests that use it, directly or by other files', () => {
	const own = [...known.sources.keys()].filter((name) => name.startsWith('starlogo.') && !name.startsWith('starlogo.away3d.'));
	assert.ok(own.length > 150);
	for (const name of own) assert.ok(found(`${name.split('.').pop()}.as`).length > 0, name);
});

test('tests are read as they are declared', () => {
	const text = '        [Test]\n        public function one():void\n\n        [Test(expects="ArgumentError", order=2)]\n        [Ignore]\n        public function two():void\n        private function three():void\n';
	assert.deepEqual(testsIn(text), ['one', 'two']);
	const count = [...known.classes.values()].reduce((sum, each) => sum + testsIn(each).length, 0);
	const declared = [...known.classes.values()].reduce((sum, each) => sum + (each.match(/^\s*\[Test\b/gm) ?? []).length, 0);
	assert.equal(count, declared);
});

test('where more than a hundred tests use a source, all but its own are farther', () => {
	const tests = (count) => `${'[Test]\n public function one\n'.repeat(count)} import a.low;`;
	const sources = new Map([['a.low', 'package a { public function low() {} }']]);
	const chosen = (count) => choose('low.as', new Map([['a.LowTest', tests(1)], ['c.OneTest', tests(60)], ['c.TwoTest', tests(count)]]), sources);
	assert.deepEqual([...chosen(40).farther], ['c.OneTest', 'c.TwoTest']);
	assert.deepEqual([...chosen(39).farther], []);
});

test('what a source uses is followed no farther than it takes, and reasons are given', () => {
	const sources = new Map([['a.low', 'package a { public function low() {} }'], ['b.High', 'import a.low; low();'], ['support.Help', 'import a.low; low();']]);
	const classes = new Map([
		['a.HighTest', '[Test]\n public function lowIsUsed\n import b.High;'],
		['a.FarTest', '[Test]\n public function other\n import a.HighTest;'],
		['c.HelpedTest', '[Test]\n public function other\n import support.Help;'],
	]);
	const { tests, ofSources, farther, said } = choose('LOW', classes, sources);
	assert.deepEqual([...tests], [['a.HighTest', null], ['c.HelpedTest', null]]);
	assert.deepEqual([...ofSources], ['a.HighTest', 'c.HelpedTest']);
	assert.deepEqual([...farther], []);
	assert.deepEqual(said, ['classes that use a.low, directly or through other files: HighTest, HelpedTest']);
	assert.deepEqual([...choose('LowIs', classes, sources).tests], [['a.HighTest', ['lowIsUsed']]]);
	assert.deepEqual(choose('LowIs', classes, sources).said, ['tests named *lowis*: HighTest (lowIsUsed)']);
});

test('where fewer than five tests use a source, those of the files that use it are chosen too', () => {
	const tests = (count, uses) => `${'[Test]\n public function one\n'.repeat(count)} import ${uses};`;
	const sources = new Map([['a.low', 'package a { public function low() {} }'], ['b.High', 'import a.low;'], ['b.Higher', 'import b.High;']]);
	const chosen = (count, high) => choose('low', new Map([['c.NearTest', tests(count, 'a.low')], ['c.HighTest', tests(high, 'b.High')], ['c.OtherTest', tests(9, 'b.High')], ['c.HigherTest', tests(1, 'b.Higher')]]), sources);
	assert.deepEqual([...chosen(5, 4).tests.keys()], ['c.NearTest']);
	assert.deepEqual([...chosen(4, 1).tests.keys()], ['c.NearTest', 'c.HighTest']);
	assert.deepEqual([...chosen(4, 1).farther], ['c.HighTest']);
	assert.deepEqual(chosen(4, 1).said, ['classes that use a.low, directly or through other files: NearTest', 'tests of what uses a.low: HighTest']);
	assert.deepEqual([...chosen(1, 3).farther], ['c.HighTest', 'c.HigherTest']);
});

test('the tests of the files of its package that use a source are chosen with those that use it themselves', () => {
	const many = '[Test]\n public function one\n'.repeat(9);
	const sources = new Map([['a.low', 'package a { public function low() {} }'], ['a.Beside', 'low();'], ['b.High', 'import a.low;']]);
	const classes = new Map([['c.NearTest', `${many} import a.low;`], ['a.BesideTest', '[Test]\n public function one\n'], ['b.HighTest', '[Test]\n public function one\n']]);
	const { tests, farther, said } = choose('low', classes, sources);
	assert.deepEqual([...tests.keys()], ['c.NearTest', 'a.BesideTest']);
	assert.deepEqual([...farther], ['a.BesideTest']);
	assert.deepEqual(said, ['classes that use a.low, directly or through other files: NearTest', 'tests of what uses a.low: BesideTest']);
});

test('the tests of a function are found, whose name begins with a small letter', () => {
	const sources = new Map([['a.low', 'package a { public function low() {} }'], ['a.touches', 'low();']]);
	const classes = new Map([['a.TouchesTest', '[Test]\n public function one\n'], ['c.NearTest', '[Test]\n public function one\n import a.low;']]);
	assert.deepEqual([...choose('low', classes, sources).tests.keys()], ['c.NearTest', 'a.TouchesTest']);
	assert.ok(found('sphereSphere').includes('KernelsAgreeTest'));
});

test('where no test uses a source itself, the tests of its package are chosen too', () => {
	const many = '[Test]\n public function one\n'.repeat(9);
	const sources = new Map([['a.Inner', 'package a { class Inner {} }'], ['a.Table', 'Inner'], ['a.Other', ''], ['b.Else', '']]);
	const classes = new Map([['a.TableTest', `${many} Table`], ['a.BesideTest', `${many} Other`], ['a.NothingTest', `${many} import b.Else;`], ['b.ElseTest', `${many} import a.Other;`]]);
	const { tests, farther, said } = choose('Inner', classes, sources);
	assert.deepEqual([...tests.keys()], ['a.TableTest', 'a.BesideTest']);
	assert.deepEqual([...farther], ['a.BesideTest']);
	assert.deepEqual(said, ['classes that use a.Inner, directly or through other files: TableTest', 'classes of tests in the package of a.Inner: BesideTest']);
	assert.deepEqual([...choose('Table', classes, sources).tests.keys()], ['a.TableTest']);
	for (const name of ['KernelsAgreeTest', 'HullPairsTest', 'PairContactTest']) assert.ok(found('RoundKernel').includes(name), name);
});

test('all other classes that use a source by any files between have tests farther off, the nearest first', () => {
	const sources = new Map([['a.low', 'package a { public function low() {} }'], ['b.High', 'import a.low;'], ['b.Higher', 'import b.High;']]);
	const tests = (count) => '[Test]\n public function one\n'.repeat(count);
	const classes = new Map([['c.TopTest', `${tests(1)} import b.Higher;`], ['c.MiddleTest', `${tests(1)} import b.High;`], ['c.NearTest', `${tests(9)} import a.low;`], ['c.OtherTest', tests(1)]]);
	const found = (pattern) => fartherTests(choose(pattern, classes, sources), classes, sources, new Set()).map(([name]) => name);
	assert.deepEqual(found('low.as'), ['c.MiddleTest', 'c.TopTest']);
	assert.deepEqual(found('NearTest'), []);
	const all = fartherTests(choose('SweptAxes.as', known.classes, known.sources), known.classes, known.sources);
	assert.ok(all.some(([name, test]) => name.endsWith('.ExactStructuresTest') && test === 'moving'));
});

test('of the tests farther off those that name the source are first, then the room\'s own, then the broad ones, then those of the room that take long, then all others', () => {
	const sources = new Map([['s.a.low', 'package s.a { public function low() {} }'], ['s.b.High', 'import s.a.low;']]);
	const text = '[Test]\n public function one\n [Test]\n public function two\n import ';
	const of = (name, used) => [name, `${text} ${used};`];
	const classes = new Map([of('s.c.FirstTest', 's.a.low'), of('s.c.FarTest', 's.b.High'), of('s.c.LongTest', 's.b.High'), of('s.a.RoomTest', 's.b.High'), of('s.a.in.LongRoomTest', 's.b.High'), of(`s.c.${BROAD[3]}`, 's.b.High'), of(`s.c.${BROAD[2]}`, 's.b.High')]);
	const choice = { tests: new Map([['s.c.FirstTest', null]]), farther: new Set(['s.c.FirstTest']), named: ['s.a.low'] };
	const found = fartherTests(choice, classes, sources, new Set(['s.c.FirstTest.one', 's.c.LongTest', 's.a.in.LongRoomTest', `s.c.${BROAD[2]}`, `s.c.${BROAD[3]}`]));
	const both = (name) => [`${name}.one`, `${name}.two`];
	assert.deepEqual(found.map((each) => each.join('.')), ['s.c.FirstTest.two', ...both('s.a.RoomTest'), ...BROAD.slice(2, 4).flatMap((name) => both(`s.c.${name}`)), ...both('s.a.in.LongRoomTest'), ...both('s.c.FarTest'), 's.c.FirstTest.one', ...both('s.c.LongTest')]);
	const tests = [...known.classes].flatMap(([name, each]) => [name.split('.').pop(), ...testsIn(each).map((test) => `${name.split('.').pop()}.${test}`)]);
	for (const name of BROAD) assert.ok(tests.includes(name), name);
});

test('of the tests farther off those of the source\'s room come first that share a rare word of its name; those of other rooms come after the room\'s own', () => {
	const sources = new Map([['s.a.EdgePairTests', 'package s.a {}']]);
	const common = ['One', 'Two', 'Three', 'Four', 'Five', 'Six', 'Seven', 'Eight', 'Nine'].map((which) => `s.c.${which}PairTest`);
	const found = (names, long) => {
		const classes = new Map(names.map((name) => [name, '[Test]\n public function one\n']));
		return fartherTests({ tests: new Map(), farther: new Set(names), named: ['s.a.EdgePairTests'] }, classes, sources, new Set(long)).map(([name]) => name);
	};
	const broad = `s.c.${BROAD[2]}`;
	const all = [...common, broad, 's.c.EdgesTest', 's.a.RoomTest', 's.a.EdgeTest'];
	assert.deepEqual(found(all, []), ['s.a.EdgeTest', 's.a.RoomTest', 's.c.EdgesTest', broad, ...common]);
	assert.deepEqual(found(all, all), ['s.a.EdgeTest', broad, 's.a.RoomTest', 's.c.EdgesTest', ...common]);
});

test('of the tests farther off those come before the room\'s other ones that have the name of a file that uses the source, with at most one between', () => {
	const text = '[Test]\n public function one\n';
	const sources = new Map([['s.a.Low', 'package s.a {}'], ['s.a.Middle', 'new Low()'], ['s.b.High', 'import s.a.Middle;'], ['s.b.Higher', 'import s.b.High;']]);
	const names = ['s.a.RoomTest', 's.b.HigherTest', 's.b.HighTest', 's.a.MiddleTest'];
	const classes = new Map(names.map((name) => [name, text]));
	const found = fartherTests({ tests: new Map(), farther: new Set(names), named: ['s.a.Low'] }, classes, sources, new Set(['s.b.HighTest'])).map(([name]) => name);
	assert.deepEqual(found, ['s.b.HighTest', 's.a.MiddleTest', 's.a.RoomTest', 's.b.HigherTest']);
	const firstOf = (source) => fartherTests(choose(source, known.classes, known.sources), known.classes, known.sources)[0][0];
	assert.equal(firstOf('NearSearch.as'), 'starlogo.queries.AgentQueriesTest');
});

test('of the tests farther off those come before all that have two words of the source\'s name, and of those that name it the ones that do so most', () => {
	const sources = new Map([['s.a.PlatformCarry', 'package s.a {}']]);
	const text = (...names) => `[Test]\n public function ${names[0]}\n [Test]\n public function other\n ${names.slice(1).join(' ')}`;
	const use = 'import s.a.PlatformCarry;';
	const classes = new Map([['s.a.RoomTest', text('one', use)], ['s.c.OftenTest', text('one', use, 'new PlatformCarry()')], ['s.c.WalkTest', text('aPlatformCarries', 'Walk')]]);
	const found = fartherTests({ tests: new Map(), farther: new Set(classes.keys()), named: ['s.a.PlatformCarry'] }, classes, sources, new Set());
	assert.deepEqual(found.map((each) => each.join('.')), ['s.c.WalkTest.aPlatformCarries', 's.c.OftenTest.one', 's.c.OftenTest.other', 's.a.RoomTest.one', 's.a.RoomTest.other', 's.c.WalkTest.other']);
	const firstOf = (source) => fartherTests(choose(source, known.classes, known.sources), known.classes, known.sources)[0].join('.');
	assert.match(firstOf('PlatformCarry.as'), /\.(WalkPushTest\.aPlatformCarries|SnapshotTest\.aGrowingPlatformCarriesAsItWouldHave)$/);
});

test('tests without a player run with the sources of the packages that they say they check', () => {
	const files = [['one.test.mjs', '/**\n * One. Checks starlogo.a, starlogo.b.c,\n * starlogo.d.\n */\nChecks starlogo.z.'], ['two.test.mjs', '/** Checks nothing. */']];
	const found = (name) => testFilesOf([name], files);
	for (const name of ['starlogo.a.Low', 'starlogo.a.inner.Low', 'starlogo.b.c.High', 'starlogo.d.Low']) assert.deepEqual(found(name), ['one.test.mjs'], name);
	for (const name of ['starlogo.ab.Low', 'starlogo.b.High', 'starlogo.z.Low']) assert.deepEqual(found(name), [], name);
	assert.deepEqual(testFilesOf(['starlogo.search.table.AgentTable']), ['test/fuzz/kept.test.mjs']);
	assert.deepEqual(testFilesOf(['starlogo.models.gltf.GltfAccessor']), ['test/module/gltf.test.mjs']);
});

test('all of a choice can be left to Node: classes and tests by their names, a page by its samples in JavaScript', () => {
	const out = mkdtempSync(path.join(tmpdir(), 'chosen-'));
	const list = (pattern, ...options) => {
		const { status } = spawnSync(process.execPath, ['test/runner/list-tests.mjs', out, 'node', `--test=${pattern}`, ...options], { cwd: root });
		const read = (name) => readFileSync(path.join(out, name), 'utf8');
		return status === 0 ? { ...JSON.parse(read('choice.json')), ...Object.fromEntries(read('tests.properties').trim().split('\n').map((line) => line.split('='))) } : null;
	};
	const { order, farther, of, pages, none, node } = list('src/starlogo/search/ChangedRowSearch.as');
	assert.ok(order.includes('ChangedRowSearchTest') && farther.some((name) => name.startsWith('SoakTest.')));
	assert.ok(farther.indexOf('test/fuzz/kept.test.mjs') < farther.indexOf('SoakTest.whatAGameSeesIsTheSameEverywhere'));
	assert.deepEqual([of, pages, none, node], [['starlogo.search.ChangedRowSearch'], undefined, 'true', 'true']);
	assert.deepEqual(list('src/starlogo/search/ChangedRowSearch.as', '--full').farther, []);
	assert.deepEqual(list('BoxTest.rotatesAboutTheOrigin').order, ['BoxTest.rotatesAboutTheOrigin']);
	const page = list('terrain.md');
	assert.deepEqual([page.node, page.pages], [undefined, 'docs/terrain.md']);
	assert.equal(list('terms.md'), null);
	assert.notEqual(list('@changed'), null);
	assert.equal(list('noSuchTest'), null);
	const refused = (pattern) => spawnSync(process.execPath, ['test/runner/list-tests.mjs', out, 'node', `--test=${pattern}`], { cwd: root, encoding: 'utf8' }).stdout;
	for (const file of ['js/playground/inspect/fits.js', './js/module/assemble.mjs']) assert.equal(refused(file), `FAILED -Dtest: ./antw test alone has their tests: ${file}\n`);
	assert.match(refused('js/module/assemble.mjs, noSuchTest'), /^FAILED -Dtest: .*: js\/module\/assemble\.mjs\nFAILED -Dtest=noSuchTest names nothing: /);
	assert.match(refused('js/module'), /^FAILED -Dtest=js\/module names nothing: /);
	rmSync(out, { recursive: true });
});
