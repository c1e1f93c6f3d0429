/** Tests that SWCs come out the same however often they are built, and are as good as before. */
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { before, test } from 'node:test';
import { strFromU8, strToU8, unzipSync, zipSync } from 'fflate';
import { inRoot } from '../../build/dist/project.mjs';
import { normaliseSwc } from '../../build/dist/swc.mjs';
import { compc, mxmlc } from './flex.mjs';

const TIME = 1700000000;
const work = inRoot('bin/generated/dist/swc-test');
const source = path.join(work, 'src/lib/Greeting.as');
let builds;

before(() => {
	rmSync(work, { recursive: true, force: true });
	mkdirSync(path.dirname(source), { recursive: true });
	writeFileSync(source, 'package lib\n{\n    public class Greeting\n    {\n        public function get text():String\n        {\n            return "hello";\n        }\n    }\n}\n');
	builds = ['one', 'other'].map((name) => {
		utimesSync(source, name.length * 1e8, name.length * 1e8);
		const file = path.join(work, `${name}.swc`);
		compc([`-source-path+=${path.join(work, 'src')}`, '-debug=true', `-output=${file}`, '-include-classes', 'lib.Greeting']);
		return readFileSync(file);
	});
});

test('two builds differ, and are the same normalised', () => {
	const [one, other] = builds;
	assert.notDeepEqual(one, other);
	assert.deepEqual(normaliseSwc(one, TIME), normaliseSwc(other, TIME));
	assert.notDeepEqual(normaliseSwc(one, TIME), normaliseSwc(one, TIME + 2));
});

test('the order of dependencies in its catalogue does not count', () => {
	const entries = unzipSync(builds[0]);
	const catalog = strFromU8(entries['catalog.xml']);
	const turned = catalog.replace(/(<dep [^>]*>)(\s*)(<dep [^>]*>)/, '$3$2$1');
	assert.notEqual(turned, catalog);
	assert.deepEqual(normaliseSwc(zipSync({ ...entries, 'catalog.xml': strToU8(turned) }), TIME), normaliseSwc(builds[0], TIME));
});

test('normalised twice is normalised', () => {
	const once = normaliseSwc(builds[0], TIME);
	assert.deepEqual(normaliseSwc(once, TIME), once);
});

test('its catalogue states the digest of its library, and the time', () => {
	const entries = unzipSync(normaliseSwc(builds[0], TIME));
	assert.deepEqual(Object.keys(entries), ['catalog.xml', 'library.swf']);
	const catalog = strFromU8(entries['catalog.xml']);
	assert.match(catalog, new RegExp(`value="${createHash('sha256').update(entries['library.swf']).digest('hex')}"`));
	assert.match(catalog, /name="lib\/Greeting" mod="1700000000000"/);
});

test('a program compiles against it', () => {
	const swc = path.join(work, 'normalised.swc');
	writeFileSync(swc, normaliseSwc(builds[0], TIME));
	const main = path.join(work, 'Main.as');
	const compile = (type) => {
		writeFileSync(main, `package\n{\n    import flash.display.Sprite;\n    import lib.Greeting;\n    public class Main extends Sprite\n    {\n        public var text:${type} = new Greeting().text;\n    }\n}\n`);
		return mxmlc([`-library-path+=${swc}`, '-static-link-runtime-shared-libraries', `-output=${path.join(work, 'main.swf')}`, '--', main]);
	};
	compile('String');
	assert.throws(() => compile('Array'), /Implicit coercion of a value of type String to an unrelated type Array/);
});
