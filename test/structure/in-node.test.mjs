/** Tests of the list of what the browser's interpreter leaves to Node. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NOT_HERE, needsPlayer } from '../runner/not-here.mjs';
import { definitionIn, read, sourcesBelow } from './sources.mjs';

const listed = read('test/runner/in-node.txt').split('\n').filter((line) => line !== '' && !line.startsWith('#'));
const texts = new Map(sourcesBelow('test').map((file) => [definitionIn(file), read(file)]));
const classOf = (name) => (texts.has(name) ? name : name.slice(0, name.lastIndexOf('.')));

test('there is each class and test of the list', () => {
	assert.equal(new Set(listed).size, listed.length);
	assert.ok(listed.length > 0);
	for (const name of listed) {
		const text = texts.get(classOf(name));
		assert.ok(/\[Test\b/.test(text), name);
		assert.ok(texts.has(name) || new RegExp(`\\[Test\\b[^\\]]*\\]\\s+public function ${name.split('.').pop()}\\(`).test(text), name);
		assert.ok(texts.has(name) || !listed.includes(classOf(name)), `${name} is listed twice: its class is`);
	}
});

test('Node runs all of it', () => {
	for (const name of listed) {
		const own = [...NOT_HERE.keys()].filter((other) => other === name || other === classOf(name) || other.startsWith(`${name}.`));
		assert.deepEqual(own, [], name);
		assert.ok(!needsPlayer(texts.get(classOf(name))), `${name} compares with Flash's own classes`);
	}
});
