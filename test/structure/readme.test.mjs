import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { choose } from '../runner/chosen.mjs';
import { readTests } from '../runner/test-classes.mjs';
import { assertNone, definitionIn, foldersIn, layout, read, root, sourcesBelow } from './sources.mjs';

const GUIDE = readdirSync(path.join(root, 'docs')).filter((file) => file.endsWith('.md')).map((file) => `docs/${file}`);
const PAGES = ['README.md', 'CONTRIBUTING.md', 'js/README.md', 'js/module/README.md', 'lib/README.md', 'test/README.md', ...GUIDE];

const lists = layout();
const isFolder = (name) => !name.includes('.');

for (const folder of ['src/starlogo', 'src/evaluation']) {
	test(`CONTRIBUTING.md lists the packages of ${folder}`, () => {
		assert.deepEqual((lists.get(folder) ?? []).filter(isFolder).sort(), foldersIn(folder));
	});
}

test('CONTRIBUTING.md lists the folders of src', () => {
	const listed = [...lists.keys()].filter((name) => /^src\/\w+$/.test(name));
	assert.deepEqual(listed.map((name) => name.slice(4)).sort(), foldersIn('src'));
});

test('test/README.md lists the folders of test', () => {
	const listed = [...read('test/README.md').matchAll(/^\| `(\w+)\/` \|/gm)].map(([, name]) => name);
	assert.deepEqual(listed.sort(), foldersIn('test').sort());
});

test('examples of -Dtest name tests that there are', () => {
	const { classes, sources } = readTests();
	const examples = [...PAGES, 'build.xml', 'antw']
		.flatMap((file) => [...read(file).matchAll(/(?<!client-test .*)-Dtest=([\w./#]+)/g)]);
	assert.ok(examples.length >= 3, 'there are some');
	for (const [example, pattern] of examples) {
		const { tests, pages } = choose(pattern, classes, sources);
		assert.ok(tests.size + pages.length > 0, `${example} matches no test`);
	}
});

test('no line of a Markdown page is over 140 characters', { skip: !existsSync(path.join(root, '.git')) && 'this is no repository' }, () => {
	const pages = execFileSync('git', ['ls-files', '*.md'], { cwd: root, encoding: 'utf8' }).trim().split('\n');
	const long = pages.flatMap((page) => read(page).split('\n').flatMap((line, i) => (line.length > 140 ? [`${page}:${i + 1} has ${line.length}`] : [])));
	assert.ok(pages.length > 30, 'there are some');
	assertNone(long);
});

/** The names that GitHub gives the parts of a page, by their headings. */
function partsOf(text) {
	const headings = text.replace(/^```[^]*?^```/gm, '').match(/^#+ .*/gm) ?? [];
	return headings.map((heading) => heading.replace(/^#+ /, '').toLowerCase().replace(/[^\p{L}\p{N}_ -]/gu, '').replaceAll(' ', '-'));
}

test('links and pictures lead somewhere', () => {
	const links = PAGES.flatMap((page) => [...read(page).matchAll(/\]\(([^)#:]*)(?:#([^)]*))?\)/g)].map(([, to, part]) => [page, to, part]));
	assert.ok(links.filter(([, to, part]) => to !== '' && part !== undefined).length > 40, 'there are some');
	const isThere = (file, part) => existsSync(path.join(root, file)) && (part === undefined || !file.endsWith('.md') || partsOf(read(file)).includes(part));
	assertNone(links.filter(([page, to, part]) => !isThere(to === '' ? page : path.join(path.dirname(page), to), part))
		.map(([page, to, part]) => `${page} has a link to ${[to, part].filter((each) => each !== undefined).join('#')}`));
});

test('paths that the pages name are there', () => {
	const named = PAGES.flatMap((page) => [...read(page).matchAll(/`((?:src|test|build|js|assets|lib|docs)\/[\w./-]*)`/g)].map(([, to]) => [page, to]));
	assert.ok(named.length > 20, 'there are some');
	// what a build or the user puts there
	const isMade = (to) => to === 'lib/away3d.swc' || to.startsWith('lib/flexunit/') || ['docs/asdoc/', 'docs/typedoc/'].includes(to) || to.includes('node_modules');
	assertNone(named.filter(([, to]) => !isMade(to) && !existsSync(path.join(root, to))).map(([page, to]) => `${page} names ${to}`));
});

test('every page of the guide is in its index, and has a table or a picture', () => {
	const index = read('docs/README.md');
	for (const page of GUIDE.filter((file) => file !== 'docs/README.md')) {
		assert.ok(index.includes(`](${path.basename(page)})`), `${page} is not in the index`);
		assert.match(read(page), /^\|---|^!\[/m, page);
	}
});

/** What the sources define: each class or function by its simple name, with its text and that of what it extends. */
const definitions = new Map(['src', 'test'].flatMap(sourcesBelow).map((file) => [definitionIn(file).split('.').pop(), read(file)]));

function isDefined(name, member) {
	const text = definitions.get(name);
	if (text === undefined || member === undefined) {
		return text !== undefined;
	}
	const base = new RegExp(`class ${name} (?:extends (\\w+))?`).exec(text)?.[1];
	return new RegExp(`(?:var|const|function(?: get| set)?) ${member}\\b`).test(text) || (base !== undefined && isDefined(base, member));
}

test('the members of classes that the pages name are there', () => {
	const named = PAGES.flatMap((page) => [...read(page).matchAll(/`([A-Z]\w*)\.(\w+)(?:\([^`]*)?`/g)].map(([, name, member]) => [page, name, member]))
		.filter(([, name, member]) => definitions.has(name) && member !== 'as');
	assert.ok(named.length > 100, 'there are some');
	assertNone(named.filter(([, name, member]) => !isDefined(name, member)).map(([page, name, member]) => `${page} names ${name}.${member}`));
});

/** Where the pages about the thesis name classes: in the last cell of a row, and in brackets at the end of an entry. */
const NAMED = { 'docs/terms.md': /^\| \d.*\|([^|]*)\|$/gm, 'docs/departures.md': /\((`[^)]*`)\)\.$/gm };

for (const [page, places] of Object.entries(NAMED)) {
	test(`the classes and members in ${page} are there`, () => {
		const names = [...read(page).matchAll(places)].flatMap(([, cell]) => [...cell.matchAll(/`(\w+)(?:\.(\w+))?`/g)]);
		assert.ok(names.length > 20, 'there are some');
		assertNone(names.filter(([, name, member]) => !isDefined(name, member)).map(([all]) => all));
	});
}

test('docs/flags.md has every flag', () => {
	const settable = (file) => [...read(file).matchAll(/^ {8}public (?:var|function set) (\w+)/gm)].map(([, name]) => name);
	const flags = ['GreatLand', 'libraries/BoundingStructuresLibrary', 'libraries/HierarchiesLibrary', 'collision/TreeCollider', 'models/ModelLoader']
		.flatMap((name) => settable(`src/starlogo/${name}.as`));
	assert.ok(flags.length > 15, 'there are some');
	const page = read('docs/flags.md');
	assertNone(flags.filter((flag) => !new RegExp(`\\b${flag}\``).test(page)));
});
