import assert from 'node:assert/strict';
import { test } from 'node:test';
import { foldersIn, layout, read, sourcesBelow } from './sources.mjs';

const lists = layout();
const isFolder = (name) => !name.includes('.');

for (const folder of ['src/starlogo', 'src/evaluation']) {
	test(`the README lists the packages of ${folder}`, () => {
		assert.deepEqual((lists.get(folder) ?? []).filter(isFolder).sort(), foldersIn(folder));
	});
}

test('the README lists the folders of src', () => {
	const listed = [...lists.keys()].filter((name) => /^src\/\w+$/.test(name));
	assert.deepEqual(listed.map((name) => name.slice(4)).sort(), foldersIn('src'));
});

test('examples of -Dtest name tests that there are', () => {
	const tests = sourcesBelow('test').filter((file) => file.endsWith('Test.as'))
		.map((file) => [file.split('/').pop().slice(0, -3), read(file)]);
	const examples = ['README.md', 'CONTRIBUTING.md', 'build.xml', 'antw']
		.flatMap((file) => [...read(file).matchAll(/-Dtest=([A-Za-z]\w*)(?:[.#](\w+))?/g)]);
	assert.ok(examples.length >= 3, 'there are some');
	for (const [example, classPart, testPart = ''] of examples) {
		const method = new RegExp(`\\[Test[^\\]]*\\]\\s+public function \\w*${testPart}\\w*\\(`);
		assert.ok(tests.some(([name, text]) => name.includes(classPart) && method.test(text)), `${example} matches no test`);
	}
});
