/** Tests of what is compiled anew for a quick run in Node. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { outlineOf } from './outline.mjs';
import { outdated, readSources } from './outdated.mjs';
import { read, root, sourcesBelow } from '../structure/sources.mjs';

const CLASS = `package a
{
    import b.Other;
    import b.Used;

    /** A class. */
    public class Low extends Used
    {
        public static const LIMIT:int = 3;
        private static const OWN:RegExp = /["{]/;
        private var _other:Other;
        public var call:Function = function():int
            {
                return 1;
            };

        // how often
        public function count(from:int = 0):int
        {
            return from / 2 + LIMIT;
        }

        private function half():int
        {
            return "}".length / 2;
        }
    }
}
`;

test('an outline has what others see of a class', () => {
	const same = (from, to) => assert.equal(outlineOf(CLASS.replace(from, to)), outlineOf(CLASS), from);
	const other = (from, to) => assert.notEqual(outlineOf(CLASS.replace(from, to)), outlineOf(CLASS), from);
	assert.notEqual(outlineOf(CLASS), null);
	same('// how often', '// how seldom');
	same('from / 2 + LIMIT', 'from * 2 - LIMIT');
	same('"}".length', '"{".length');
	same('_other:Other', '_another:Other');
	same('private function half():int', 'private function half(by:int):Number');
	same('    import b.Other;\n', '');
	other('import b.Used', 'import c.Used');
	other('LIMIT:int = 3', 'LIMIT:int = 4');
	other('from:int = 0', 'from:int = 1');
	other('extends Used', 'extends Other');
	other('return 1', 'return 2');
	other('private var', 'internal var');
	other('public function count', 'override public function count');
	other('// how often', 'public var often:int;');
});

test('what is not understood has no outline', () => {
	const broken = [['return 1', 'return "1'], ['/** A class. */', '/** A class.'], ['/["{]/', '/["{/'], ['            return from', '            { return from']];
	for (const [from, to] of broken) {
		assert.equal(outlineOf(CLASS.replace(from, to)), null, to);
	}
});

test('the outlines of the sources are understood', () => {
	const unknown = [...sourcesBelow('src'), ...sourcesBelow('test'), ...sourcesBelow('js/standins/common'), ...sourcesBelow('js/standins/module')].filter((file) => outlineOf(read(file)) === null);
	assert.ok(unknown.length < 5, unknown.join());
});

/** A few sources that use one another, and what is outdated when some are other ones. */
function outdatedWith(changes, included = {}) {
	const texts = { 'a.Low': 'low include "x/one.inc"', 'b.High': 'uses Low', 'c.Higher': 'uses High', 'd.Beside': 'beside include "two.inc"', 'e.Unused': 'by Node', 'x/one.inc': 'include "two.inc"', 'x/two.inc': '' };
	const sourcesOf = (given, outlines, inc) => ({
		settings: 'as ever',
		files: Object.fromEntries(Object.keys(given).filter((name) => !name.endsWith('.inc')).map((name) => [name, { file: name, hash: given[name], outline: outlines[name] ?? 'outline' }])),
		included: { 'x/one.inc': inc['one'] ?? '', 'x/two.inc': inc['two'] ?? '' },
	});
	const now = { ...texts };
	const outlines = {};
	for (const [name, text] of Object.entries(changes)) {
		if (text === null) delete now[name];
		else now[name] = text;
		if (text?.startsWith('public')) outlines[name] = text;
	}
	const found = outdated(sourcesOf(texts, {}, {}), sourcesOf(now, outlines, included), (name) => name in texts && name !== 'e.Unused', new Set(['f.NewTest']), (file) => now[file]);
	return found === null ? null : found.sort().join();
}

test('classes whose sources changed are outdated, and if they look different from outside, those that use them', () => {
	assert.equal(outdatedWith({}), '');
	assert.equal(outdatedWith({ 'a.Low': 'low inside' }), 'a.Low');
	assert.equal(outdatedWith({ 'a.Low': 'public Low' }), 'a.Low,b.High,c.Higher');
	assert.equal(outdatedWith({ 'b.High': 'public uses Low' }), 'b.High,c.Higher');
	assert.equal(outdatedWith({ 'f.NewTest': 'public test', 'b.High': 'uses Low more' }), 'b.High,f.NewTest');
	assert.equal(outdatedWith({ 'e.Unused': 'public' }), '');
	assert.equal(outdatedWith({}, { one: 'changed' }), 'a.Low');
	assert.equal(outdatedWith({}, { two: 'changed' }), 'a.Low,d.Beside');
});

test('of a class that is gone, is new or has another name, those that name it are outdated, and others only if they can see that', () => {
	assert.equal(outdatedWith({ 'e.Unused': null }), '');
	assert.equal(outdatedWith({ 'c.Higher': null }), '');
	assert.equal(outdatedWith({ 'a.Low': null }), 'b.High');
	assert.equal(outdatedWith({ 'a.Low': null, 'a.Lower': 'low', 'b.High': 'uses Lower' }), 'b.High');
	assert.equal(outdatedWith({ 'a.Low': null, 'a.Lower': 'low', 'b.High': 'public uses Lower' }), 'b.High,c.Higher');
	assert.equal(outdatedWith({ 'a.More': 'more', 'a.Low': 'low with More' }), 'a.Low');
});

/** What changed.mjs says of a translation of the sources, which are noted as given. `check` gets the translation's parent folder. */
function changedSince(noted, compiled, check) {
	const folder = mkdtempSync(path.join(tmpdir(), 'changed-'));
	for (const [name, text] of [['done', ''], ['roots/sources.json', JSON.stringify(noted)], ...compiled.map((qname) => [`out/bin/js-debug/${qname.replaceAll('.', '/')}.js`, ''])]) {
		const file = path.join(folder, 'tests', name);
		mkdirSync(path.dirname(file), { recursive: true });
		writeFileSync(file, text);
	}
	execFileSync(process.execPath, ['test/runner/changed.mjs', path.join(folder, 'tests'), path.join(folder, 'changed')], { cwd: root });
	check(folder, readFileSync(path.join(folder, 'changed/changed.properties'), 'utf8'));
	rmSync(folder, { recursive: true });
}

test('a translation loses the classes that are gone, when all that was outdated is made', () => {
	const sources = readSources();
	changedSince({ ...sources, files: { ...sources.files, 'a.GoneTest': {} } }, ['a.GoneTest'], (folder, properties) => {
		assert.equal(properties, '');
		assert.ok(!existsSync(path.join(folder, 'tests/out/bin/js-debug/a/GoneTest.js')));
		assert.deepEqual(JSON.parse(readFileSync(path.join(folder, 'tests/roots/sources.json'), 'utf8')), sources);
	});
});

test('beside classes that changed, the compiler finds those that these may be the first to use, and takes others from the SWC', () => {
	const sources = readSources();
	const [changed, first] = ['starlogo.bounding.Box', 'starlogo.handlers.nameBreeds'];
	const engine = Object.keys(sources.files).filter((qname) => sources.files[qname].file.startsWith('src/starlogo/') && qname !== first);
	const files = { ...sources.files, [changed]: { ...sources.files[changed], hash: 'of another text' } };
	changedSince({ ...sources, files }, engine, (folder, properties) => {
		const isCopied = (qname) => existsSync(path.join(folder, 'changed/src', `${qname.replaceAll('.', '/')}.as`));
		assert.match(properties, /^engine=/m);
		assert.deepEqual([changed, first, 'starlogo.bounding.Sphere'].map(isCopied), [true, true, false]);
	});
});

test('all classes are outdated if the compiler is called in another way', () => {
	const now = readSources();
	assert.deepEqual(outdated(now, now, () => true, new Set()), []);
	assert.equal(outdated({ ...now, settings: 'other' }, now, () => true, new Set()), null);
});
