/** Tests of what ./antw client-test finds in a client's folders. */
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const script = fileURLToPath(new URL('client-tests.mjs', import.meta.url));
const folder = mkdtempSync(path.join(tmpdir(), 'client-tests-'));
mkdirSync(path.join(folder, 'src/game'), { recursive: true });
mkdirSync(path.join(folder, 'tests/game/world'), { recursive: true });
for (const file of ['src/game/Turtle.as', 'tests/MainTest.as', 'tests/game/world/TurtleTest.as', 'tests/game/TestTools.as']) {
	writeFileSync(path.join(folder, file), '');
}

const run = (...more) => spawnSync(process.execPath, [script, 'out', ...more], { cwd: folder, encoding: 'utf8' });
const written = () => readFileSync(path.join(folder, 'out/ClientTests.as'), 'utf8');

test('all test classes of all folders are run', () => {
	const { status, stdout } = run('src,tests');
	assert.equal(status, 0);
	assert.equal(stdout, '2 test classes\n');
	assert.match(written(), /CLASSES:Array = \["MainTest", "game\.world\.TurtleTest"\]/);
	assert.match(written(), /import game\.world\.TurtleTest;/);
});

test('a folder in which no packages begin is refused, with the one in which they do', () => {
	writeFileSync(path.join(folder, 'tests/game/world/TurtleTest.as'), 'package game.world\n{\n    public class TurtleTest\n    {\n        [Test]\n        public function swims():void {}\n    }\n}\n');
	assert.equal(run('src,tests').status, 0);
	for (const [named, file] of [['tests/game', 'tests/game/world/TurtleTest.as'], ['.', 'tests/game/world/TurtleTest.as']]) {
		const { status, stderr } = run(named);
		assert.equal(status, 64);
		assert.equal(stderr, `-Dsources: ${file} is of the package "game.world". Name the folder in which packages begin: ${path.resolve(folder, 'tests')}\n`);
	}
	writeFileSync(path.join(folder, 'tests/game/world/TurtleTest.as'), 'package other\n{\n    [Test]\n');
	assert.match(run('src,tests').stderr, /^-Dsources: tests\/game\/world\/TurtleTest\.as is of the package "other", so it belongs into a folder other\n$/);
});

test('a test that fails is told with its file and line', () => {
	writeFileSync(path.join(folder, 'tests/game/world/TurtleTest.as'), 'package game.world\n{\n    public class TurtleTest\n    {\n        [Test]\n        public function swims():void\n');
	run('src,tests');
	assert.match(readFileSync(path.join(folder, 'out/ClientTestsReporter.as'), 'utf8'), /"game\.world\.TurtleTest\.swims": "tests\/game\/world\/TurtleTest\.as:6"/);
});

test('a test that is ignored is told with its reason', () => {
	writeFileSync(path.join(folder, 'tests/game/world/TurtleTest.as'), ['package game.world', '{', '    public class TurtleTest', '    {',
		'        [Ignore("not yet: (slow)")]', '        [Test]', '        public function swims():void {}', '        [Ignore]', '        [Test]', '        public function dives():void {}', ''].join('\n'));
	assert.equal(run('src,tests').status, 0);
	assert.equal(readFileSync(path.join(folder, 'out/tests.txt'), 'utf8'), ['game.world.TurtleTest.swims (tests/game/world/TurtleTest.as:7, "not yet: (slow)")',
		'game.world.TurtleTest.dives (tests/game/world/TurtleTest.as:10)', ''].join('\n'));
	assert.ok(readFileSync(path.join(folder, 'out/ClientTestsReporter.as'), 'utf8').includes('"tests/game/world/TurtleTest.as:7, \\"not yet: (slow)\\""'));
});

test('what runs before and after the tests of a class has its file and line too, and its static initialiser that of the class', () => {
	writeFileSync(path.join(folder, 'tests/game/world/TurtleTest.as'), ['package game.world', '{', '    /** A class of tests. */', '    public class TurtleTest', '    {',
		'        [BeforeClass]', '        public static function begin():void {}', '        [BeforeClass(order=2)]', '        public static function fill():void {}',
		'        [Test]', '        public function swims():void {}', '        /* no more', '        [Test]', '        public function dives():void {} */', ''].join('\n'));
	assert.equal(run('src,tests').status, 0);
	const reporter = readFileSync(path.join(folder, 'out/ClientTestsReporter.as'), 'utf8');
	assert.match(reporter, /"game\.world\.TurtleTest": "tests\/game\/world\/TurtleTest\.as:4"/);
	assert.match(reporter, /"game\.world\.TurtleTest \[BeforeClass\]": "tests\/game\/world\/TurtleTest\.as:7 or tests\/game\/world\/TurtleTest\.as:9"/);
	assert.match(reporter, /"game\.world\.TurtleTest\.fill": "\[BeforeClass\]"/);
	assert.equal(readFileSync(path.join(folder, 'out/tests.txt'), 'utf8'), 'game.world.TurtleTest.swims (tests/game/world/TurtleTest.as:11)\n');
});

test('a function that FlexUnit would leave out is named', () => {
	const file = path.join(folder, 'tests/game/world/TurtleTest.as');
	const classOf = (...lines) => writeFileSync(file, ['package game.world', '{', '    public class TurtleTest', '    {', ...lines, '    }', '}', ''].join('\n'));
	classOf('        [Test]', '        [Ignore("later")]', '        private function swims():void {}', '        // [Test]', '        private function helps():int {}');
	const hidden = run('src,tests');
	assert.equal(hidden.status, 64);
	assert.equal(hidden.stderr, 'tests/game/world/TurtleTest.as:7: error: swims() has [Test] and is not public, so FlexUnit does not run it\nFAILED client-test: no test has run, because of the errors above\n');
	classOf('        [Test(async)]', '        public function asks():int {}', '        [Before]', '        public function begin():void {}');
	const asking = run('src,tests');
	assert.equal(asking.status, 64);
	assert.match(asking.stderr, /^tests\/game\/world\/TurtleTest\.as:6: error: asks\(\) has \[Test\] and gives int: .* must be void\nFAILED .* the errors above\n$/);
	classOf('        [Theory]', '        private function dives():void {}', '        [Test(description="a[0] // is right")]', '        private function asks():void {}');
	assert.match(run('src,tests').stderr, /:6: error: dives\(\) has \[Theory\] and is not public.*\n.*:8: error: asks\(\) has \[Test\] and is not public/);
	classOf('        [Test(description="a[0] is right")]', '        public function testAsks():void {}', '        public var s:String = "[Test] private function x";');
	assert.equal(run('src,tests').stderr, '');
	classOf('        public function testSwims():void {}', '        public function tests():void {}');
	const forgotten = run('src,tests');
	assert.equal(forgotten.status, 0);
	assert.equal(forgotten.stderr, 'tests/game/world/TurtleTest.as:5: warning: testSwims() has no [Test], so FlexUnit does not run it\n');
	writeFileSync(file, '[Ignore("later")]\n[RunWith("a.Runner")]\npublic class TurtleTest\n{\n    [Ignore]\n    [Test]\n    public function swims():void {}\n');
	const ofClass = run('src,tests');
	assert.equal(ofClass.status, 0);
	assert.equal(ofClass.stderr, 'tests/game/world/TurtleTest.as:1: warning: [Ignore] of a class does nothing here: the embedded player does not see the metadata of classes\n');
	writeFileSync(file, '');
});

test('a function for which FlexUnit would run nothing of its class is named', () => {
	const file = path.join(folder, 'tests/game/world/TurtleTest.as');
	const saidOf = (...lines) => {
		writeFileSync(file, ['public class TurtleTest', '{', ...lines, '}', ''].join('\n'));
		return run('src,tests').stderr.replaceAll('tests/game/world/TurtleTest.as', '').replace(/^FAILED .*\n/m, '');
	};
	const stops = 'FlexUnit runs no test of a class that has such a function. It must';
	assert.equal(saidOf('[Test]', 'public function swims(x:int):void {}', '[Before]', 'public function begin(...all):void {}'),
		`:4: error: swims() has [Test] and takes a parameter: ${stops} take none\n:6: error: begin() has [Before] and takes a parameter: ${stops} take none\n`);
	assert.equal(saidOf('[Test]', 'public static function swims():void {}', '[BeforeClass]', 'public function begin():void {}'),
		`:4: error: swims() has [Test] and is static: ${stops} not be static\n:6: error: begin() has [BeforeClass] and is not static: ${stops} be static\n`);
	assert.equal(saidOf('[test]', 'public function swims():void {}'), ':4: error: swims() has [test], which FlexUnit does not know: it is [Test]\n');
	assert.equal(saidOf('[Theory]', 'public function swims(x:int):void {}', '[AfterClass]', 'public static function end():void {}', '[Embed(source="a")]', 'public var picture:Class;'), '');
	writeFileSync(file, '');
});

test('a tag that is nearly one of FlexUnit\'s is named, and so is a class with tests that is not named as one', () => {
	const file = path.join(folder, 'tests/game/world/TurtleTest.as');
	writeFileSync(file, 'public class TurtleTest extends TurtleBase\n{\n[Tset] public function swims():void {}\n[Event] public function dives():void {}\n');
	writeFileSync(path.join(folder, 'tests/game/world/LateTests.as'), 'public class LateTests { [Test] public function late():void {} }');
	writeFileSync(path.join(folder, 'tests/game/world/TurtleBase.as'), 'public class TurtleBase\n{\n[Test] public function inherited():void {}\n[Test] public function swims():void {}\n');
	assert.equal(run('src,tests').stderr, ['tests/game/world/LateTests.as: warning: has [Test], but its name does not end with Test, so it is left out',
		'tests/game/world/TurtleTest.as:3: warning: swims() has [Tset], which FlexUnit does not know; is [Test] meant?', ''].join('\n'));
	// classes of the same name as the one that they extend do not go round in a circle
	for (const each of ['src/game', 'tests/game']) writeFileSync(path.join(folder, each, 'TurtleBase.as'), 'import other.TurtleBase;\npublic class TurtleBase extends TurtleBase {}');
	assert.equal(run('src,tests').status, 0);
	// a test that a class inherits has the place of its function
	assert.equal(readFileSync(path.join(folder, 'out/tests.txt'), 'utf8'), 'game.world.TurtleTest.inherited (tests/game/world/TurtleBase.as:3)\n');
	for (const each of ['src/game/TurtleBase', 'tests/game/TurtleBase', 'tests/game/world/LateTests', 'tests/game/world/TurtleBase']) rmSync(path.join(folder, `${each}.as`));
	writeFileSync(file, '');
});

test('after the last test some frames pass, so that what it has left can throw', () => {
	run('src,tests');
	assert.match(readFileSync(path.join(folder, 'out/ClientTestsReporter.as'), 'utf8'), /testRunFinished\([^]*@now the frames after the last test[^]*ENTER_FRAME[^]*Host\.exit\(/);
});

test('the engine\'s own folder is none of the client\'s', () => {
	const { status, stderr } = run(`tests,${fileURLToPath(new URL('../../src', import.meta.url))}`);
	assert.equal(status, 64);
	assert.match(stderr, /-Dsources: \/.*src has the engine's own sources\. Folders that do not begin with "\/" count from the clone\n$/);
});

test('a class of the game whose name ends with Test is left out, and named', () => {
	writeFileSync(path.join(folder, 'src/HitTest.as'), 'package\n{\n    // extends nothing\n    public class HitTest\n    {\n        public function hits():Boolean { return true; }\n    }\n}\n');
	const { status, stdout, stderr } = run('src,tests');
	assert.equal(status, 0);
	assert.equal(stdout, '2 test classes\n');
	assert.equal(stderr, 'src/HitTest.as: has no [Test], so it is left out\n');
	rmSync(path.join(folder, 'src/HitTest.as'));
});

test('a name chooses some of them', () => {
	assert.equal(run('src,tests', 'turtle').stdout, '1 test class\n');
	assert.match(written(), /CLASSES:Array = \["game\.world\.TurtleTest"\]/);
});

test('a name with a point chooses tests of a class', () => {
	const file = path.join(folder, 'tests/game/world/TurtleTest.as');
	writeFileSync(file, ['swims', 'dives', 'divesDeep'].map((name) => `        [Test]\n        public function ${name}():void {}\n`).join(''));
	assert.equal(run('src,tests', 'TurtleTest.dive,MainTest').status, 0);
	assert.match(written(), /PICKED:Array = \["MainTest", "game\.world\.TurtleTest\.dives", "game\.world\.TurtleTest\.divesDeep"\]/);
	assert.match(written(), /CLASSES:Array = \["MainTest", "game\.world\.TurtleTest"\][^]*\.filterWith\(/);
	assert.equal(run('src,tests', 'TurtleTest.dives').status, 0);
	assert.match(written(), /PICKED:Array = \["game\.world\.TurtleTest\.dives"\]/);
	const mistyped = run('src,tests', 'turtletest.flies');
	assert.equal(mistyped.status, 64);
	assert.match(mistyped.stderr, /there are game\.world\.TurtleTest\.swims, game\.world\.TurtleTest\.dives, game\.world\.TurtleTest\.divesDeep\n$/);
	writeFileSync(file, '');
});

test('what is not there is named', () => {
	assert.match(run('src').stderr, /no file below src ends with Test\.as/);
	const { status, stderr } = run('tests', 'bear');
	assert.equal(status, 64);
	assert.match(stderr, /no class and no test matches -Dtest=bear; there are MainTest, game\.world\.TurtleTest/);
});
