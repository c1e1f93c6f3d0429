/** The samples of the documentation in JavaScript, run on the module that the build has made; and that broken ones fail. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { root } from '../structure/sources.mjs';
import { fencesIn, listingsIn, moduleOf, pages, preludeOf, testClasses } from './samples.mjs';

const folder = path.join(root, 'bin/generated/docs-js');
const page = (...samples) => ({
	file: 'a.md', slug: 'a', fences: samples.map((text, i) => ({ language: /^(?:var|package) /.test(text) ? 'actionscript' : 'js', line: 10 * i + 1, text })),
});

// a copy: from a link three.js would be looked for where it leads to
rmSync(path.join(folder, 'node_modules'), { recursive: true, force: true });
mkdirSync(path.join(folder, 'node_modules'), { recursive: true });
cpSync(path.join(root, 'bin/module'), path.join(folder, 'node_modules/starlogo-collision'), { recursive: true });
symlinkSync(path.join(root, 'js/module/node_modules/three'), path.join(folder, 'node_modules/three'));

/** Runs the samples of a page in Node, and then its check. */
function run(each) {
	const file = path.join(folder, `${each.slug}.mjs`);
	const prelude = preludeOf(each.slug, '.mjs');
	writeFileSync(file, moduleOf(each));
	writeFileSync(path.join(folder, `${each.slug}.run.mjs`), `import * as samples from "./${each.slug}.mjs";
${prelude ? `import { check } from "${pathToFileURL(path.join(root, prelude))}";\nawait check(samples);` : ''}
`);
	return execFileSync(process.execPath, [path.join(folder, `${each.slug}.run.mjs`)], { encoding: 'utf8', stdio: 'pipe' });
}

for (const each of pages().filter(({ fences }) => fences.some(({ language }) => language === 'js'))) {
	test(`the samples of ${each.file} run`, () => {
		run(each);
	});
}

test('a broken sample in JavaScript fails', () => {
	assert.throws(() => run(page('import { Agent } from "starlogo-collision";\n', 'const agent = new Agent("bear").turn(30);\n')), /turn is not a function/);
	assert.match(run(page('import { Agent } from "starlogo-collision";\n', 'const agent = new Agent("bear");\nconsole.log(agent.shape);\n')), /^bear$/m);
});

test('fences are found, with their lines', () => {
	assert.deepEqual(fencesIn('a\n```js\nb\n```\n\n  ```\n  c\n    d\n  ```\n'), [
		{ language: 'js', line: 3, text: 'b' }, { language: '', line: 7, text: 'c\n  d' }]);
	assert.throws(() => fencesIn('a\n```js\nb\n'), /not closed: line 2/);
});

test('listings are found, with their lines', () => {
	assert.deepEqual(listingsIn('/**\n * <listing version="3.0">\n * var v:Vector.&lt;int&gt;;\n *     more\n * </listing>\n */'), [
		{ language: 'actionscript', line: 3, text: 'var v:Vector.<int>;\n    more' }]);
});

test('samples of a page follow one another in one test, and a class is a file', () => {
	const mine = 'package game\n{\n    public class Mine\n    {\n        var x:int;\n    }\n}';
	const files = testClasses([page('var a:Agent = new Agent("b");\n', mine, 'var mine:Mine = new Mine();\n')]);
	assert.deepEqual([...files.keys()].sort(), ['docs/ASamplesTest.as', 'game/Mine.as']);
	const generated = files.get('docs/ASamplesTest.as');
	assert.match(generated, /import game\.Mine;\n {4}import starlogo\.agents\.Agent;/);
	assert.match(generated, /a\.md:1\nvar a:Agent[^]*a\.md:21\nvar mine:Mine[^]*check\(\{ a: a, mine: mine \}\)/);
	assert.throws(() => testClasses([page(mine, mine)]), /another sample defines game\.Mine/);
	assert.throws(() => testClasses([page('var a:int;\n'), page('var b:int;\n')]), /another sample defines docs\.ASamplesTest/);
});

test('a class of a sample hides a class of the engine with its name', () => {
	const own = 'package game\n{\n    public class Sphere\n    {\n    }\n}';
	const generated = testClasses([page(own, 'var a:Sphere = new Sphere();\nvar b:Box = null;\n')]).get('docs/ASamplesTest.as');
	assert.match(generated, /import game\.Sphere;\n {4}import starlogo\.bounding\.Box;/);
	assert.doesNotMatch(generated, /starlogo\.bounding\.Sphere/);
});

test('every page with ActionScript has a test', () => {
	const all = pages();
	const shown = all.filter(({ fences }) => fences.some(({ language }) => language === 'actionscript'));
	const made = [...testClasses(all).values()].filter((text) => text.includes('SamplesTest extends'));
	assert.equal(made.length, shown.length);
	assert.ok(shown.some(({ file }) => file === 'README.md') && shown.some(({ file }) => file.startsWith('docs/')) && shown.some(({ file }) => file.startsWith('src/')));
});
