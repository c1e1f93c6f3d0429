/** Tests of the languages of the page to play with: each file has the keys of the English one. test/playground/languages.test.mjs compares the words. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import path from 'node:path';
import { assertNone, differences, filesBelow, root } from './sources.mjs';

const folder = 'js/playground/languages';

/** The keys of a file's texts, those inside others with these before them. */
async function keysOf(file) {
	const { texts } = await import(pathToFileURL(path.join(root, file)).href);
	const keysIn = (words, name) => (words === null || typeof words !== 'object' ? [name] : Object.entries(words).flatMap(([key, each]) => keysIn(each, `${name}.${key}`)));
	return keysIn(texts, '');
}

test('every language of the playground has the keys of English', async () => {
	const files = filesBelow(folder, '.js').filter((file) => path.basename(file) !== 'en.js');
	assert.ok(files.length > 3);
	const wrong = await Promise.all(files.map(async (file) => differences(file, await keysOf(file), await keysOf(path.join(path.dirname(file), 'en.js')))));
	assertNone(wrong.flat());
});
