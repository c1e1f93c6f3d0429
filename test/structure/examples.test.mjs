/** Tests of the examples' files. test/examples runs the examples. */
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { folder, groups, pages } from '../../build/examples/list.mjs';
import { assertNone, root } from './sources.mjs';

const examples = groups().flatMap((group) => group.examples);
const LONGEST = 60;

test('every page has an entry in the index, and the index is as its script writes it', () => {
	const files = [...readdirSync(folder), ...readdirSync(path.join(folder, 'flash'))].filter((file) => /\.(html|as)$/.test(file) && !/^(index|Land)\./.test(file));
	const names = files.map((file) => file.split('.')[0]).sort();
	const listed = examples.map(({ name }) => name);
	assertNone(names.filter((name) => !listed.includes(name)).map((name) => `EXAMPLES of examples/shared/page.js lacks ${name}`));
	for (const [file, text] of pages()) {
		assert.ok(readFileSync(path.join(folder, file), 'utf8') === text, `${file} is not what "node build/examples/index.mjs --cards" writes`);
	}
});

test('the pages name the player that the project has', () => {
	const [, version] = /ruffle@([\d.]+)/.exec(readFileSync(path.join(folder, 'flash/index.html'), 'utf8'));
	assert.equal(version, JSON.parse(readFileSync(path.join(root, 'package.json'))).devDependencies['@ruffle-rs/ruffle']);
});

test('an example is one file of at most 60 lines, with a picture', () => {
	for (const { name, file } of examples) {
		const lines = readFileSync(path.join(folder, file), 'utf8').trimEnd().split('\n');
		assert.ok(lines.length <= LONGEST, `${file} has ${lines.length} lines`);
		const picture = path.join(folder, `pictures/${name}.webp`);
		assert.ok(existsSync(picture), `no picture: ./antw examples-index -Dexample=${name}`);
		const { size } = statSync(picture);
		assert.ok(size > 1000 && size < 100000, `${name}.webp has ${size} bytes`);
	}
});

test('the documentation has a link to each example', () => {
	const text = readdirSync(path.join(root, 'docs')).filter((file) => file.endsWith('.md')).map((file) => readFileSync(path.join(root, 'docs', file), 'utf8')).join('');
	for (const { name, file } of examples) assert.ok(text.includes(`](../examples/${file})`), `no page of docs/ has a link to ${name}`);
});
