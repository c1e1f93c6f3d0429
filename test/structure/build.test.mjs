/** Tests of the build files. */
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { read, root } from './sources.mjs';

test('no property has two defaults: what one file means by it another would not', () => {
	const files = ['build.xml', ...readdirSync(path.join(root, 'build')).filter((file) => file.endsWith('.xml')).map((file) => `build/${file}`)];
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
