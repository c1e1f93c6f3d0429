/** The samples of the documentation in JavaScript, run on the module that the build has made; and that broken ones fail. */
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { read, root } from '../structure/sources.mjs';
import { fencesIn, listingsIn, missingImports, moduleOf, pages, preludeOf, testClasses, withPagesNamed } from './samples.mjs';

const folder = path.join(root, 'bin/generated/docs-js');
const page = (...samples) => ({
	file: 'a.md', slug: 'a', fences: samples.map((text, i) => ({ language: /^(?:var|package) /.test(text) ? 'actionscript' : 'js', line: 10 * i + 1, text })),
});

// a copy: from a link three.js would be looked for where it leads to
rmSync(path.join(folder, 'node_modules'), { recursive: true, force: true });
mkdirSync(path.join(folder, 'node_modules'), { recursive: true });
cpSync(path.join(root, 'bin/module'), path.join(folder, 'node_modules/starlogo-collision'), { recursive: true });
symlinkSync(path.join(root, 'js/module/node_modules/three'), path.join(folder, 'node_modules/three'));

/** What Node says of an error, below a line with its place in a page and its message. */
function whatFailed(said) {
	const [place] = /[\w./-]+\.md:\d+/.exec(said) ?? [];
	const [message] = /^\w*Error\b.*/m.exec(said) ?? [];
	return place && message ? `${place}: ${message}\n${said}` : said;
}

/** Runs the samples of a page in Node, and then its check. */
function run(each) {
	const file = path.join(folder, `${each.slug}.mjs`);
	const prelude = preludeOf(each.slug, '.mjs');
	writeFileSync(file, moduleOf(each));
	writeFileSync(path.join(folder, `${each.slug}.run.mjs`), `import * as samples from "./${each.slug}.mjs";
${prelude ? `import { check } from "${pathToFileURL(path.join(root, prelude))}";\nawait check(samples);` : ''}
`);
	const { status, stdout, stderr } = spawnSync(process.execPath, [path.join(folder, `${each.slug}.run.mjs`)], { encoding: 'utf8' });
	if (status !== 0) throw new Error(whatFailed(withPagesNamed(stderr)));
	return stdout;
}

const wanted = (process.env.OF ?? '').split(',').filter((file) => file.endsWith('.md'));
const inJavaScript = pages().filter(({ fences }) => fences.some(({ language }) => language === 'js'));
for (const each of inJavaScript.filter(({ file }) => wanted.length === 0 || wanted.includes(file))) {
	test(`the samples of ${each.file} run`, () => {
		run(each);
	});
}

test('the samples in ActionScript of a page import the classes that they name', () => {
	assert.deepEqual(missingImports(page('var a:Agent;', 'var b:Agent = new Box();')), ['a.md:1: starlogo.agents.Agent', 'a.md:11: starlogo.bounding.Box']);
	assert.deepEqual(pages().filter(({ file }) => file.endsWith('.md')).flatMap(missingImports), []);
});

/** A page's samples as a program in TypeScript. What its prelude has is of any type, but for what three.js has types of. */
function typed({ slug, fences }) {
	const prelude = preludeOf(slug, '.mjs');
	const [declared, ...ofThree] = [/^export const (\w+)/gm, /^export const (\w+) = THREE\.\1;$/gm].map((pattern) => (prelude ? [...read(prelude).matchAll(pattern)].map(([, name]) => name) : []));
	const text = moduleOf({ slug: 'none', file: slug, fences });
	const given = declared.filter((name) => new RegExp(`\\b${name}\\b`).test(text) && !new RegExp(`\\bconst ${name}\\b`).test(text)).map((name) => (ofThree.flat().includes(name)
		? `import { ${name} } from "three";` : `declare const ${name}: any;`));
	return `${given.join('\n')}\n${text}`;
}

test('TypeScript accepts the samples, with its strict checks but for parameters without types', () => {
	const tools = path.join(root, 'js/module/node_modules/typescript/bin/tsc');
	mkdirSync(path.join(folder, 'node_modules/@types'), { recursive: true });
	symlinkSync(path.join(root, 'js/adapters/three/node_modules/@types/three'), path.join(folder, 'node_modules/@types/three'));
	const types = path.join(folder, 'types');
	rmSync(types, { recursive: true, force: true });
	mkdirSync(types);
	for (const each of inJavaScript.filter(({ file }) => file.endsWith('.md'))) writeFileSync(path.join(types, `${each.slug}.mts`), typed(each));
	const compilerOptions = { target: 'es2022', module: 'nodenext', strict: true, noImplicitAny: false, noEmit: true, skipLibCheck: true, types: [], lib: ['es2023', 'dom', 'dom.iterable'] };
	writeFileSync(path.join(types, 'tsconfig.json'), JSON.stringify({ compilerOptions, include: ['*.mts'] }));
	writeFileSync(path.join(types, 'wrong.mts'), typed({ slug: 'three', fences: [{ language: 'js', line: 1, text: 'new Mesh(new BoxGeometry(), [null]);' }] }));
	const { stdout } = spawnSync(process.execPath, [tools, '-p', types], { encoding: 'utf8' });
	assert.match(stdout, /^\S*\bwrong\.mts\(\d+,\d+\): error TS2322: Type 'null' is not assignable[^\n]*\n$/, 'nothing else is wrong');
});

test('a broken sample in JavaScript fails', () => {
	assert.throws(() => run(page('import { Agent } from "starlogo-collision";\n', 'const agent = new Agent("bear").turn(30);\n')), /turn is not a function/);
	assert.match(run(page('import { Agent } from "starlogo-collision";\n', 'const agent = new Agent("bear");\nconsole.log(agent.shape);\n')), /^bear$/m);
});

test('an error in a sample names the page, and the line there', () => {
	const imported = 'import { Agent } from "starlogo-collision";';
	assert.throws(() => run(page(`${imported}\nconst first = new Agent("bear");`, `${imported}\n\nfirst.turn(30);`)), ({ message }) => /^a\.md:13: TypeError: first\.turn is not a function\n[^]*\ba\.md:13:7\n/.test(message) && !/a\.mjs/.test(message));
	const mine = 'package game\n{\n    public class Mine\n    {\n        var x:int;\n    }\n}';
	for (const [file, text] of testClasses([page('var a:Agent = null;\n', 'var b:int;\nimport game.Mine;\nvar mine:Mine = null;', mine)])) {
		mkdirSync(path.join(folder, path.dirname(file)), { recursive: true });
		writeFileSync(path.join(folder, file), text);
		const line = text.split('\n').findIndex((each) => /var (x:int|mine:Mine)/.test(each)) + 1;
		assert.equal(withPagesNamed(`${path.join(folder, file)}(${line}): col: 5 Error`), `a.md:${/Mine/.test(file) ? 25 : 13}: col: 5 Error`);
	}
	assert.equal(withPagesNamed('bin/generated/docs/docs/NoSuchTest.as(3)'), 'bin/generated/docs/docs/NoSuchTest.as(3)');
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
	assert.match(generated, /a\.md:1";\nvar a:Agent[^]*a\.md:21";\nvar mine:Mine[^]*check\(\{ a: a, mine: mine \}\)/);
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
