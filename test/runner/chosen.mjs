/** Which tests -Dtest names: by a class of tests, by a test, by the source file that they test, or by the page whose samples they are. */
import { existsSync } from 'node:fs';
import path from 'node:path';
import { $changesBetween } from '../../js/standins/module/warnings/spelling.mjs';
import { SAMPLES_IN_JAVASCRIPT, classOfSamples, fencesIn } from '../docs/samples.mjs';
import { definitionIn, filesBelow, packageOf, read, root, sourcesBelow, usesIn } from '../structure/sources.mjs';

/** Fewer tests than these say little of a source. */
const ENOUGH = 5;

/** More tests than these take minutes in the interpreter. */
const MANY = 100;

/** Tests that call much of the engine. What no nearer test finds, these find soonest. */
export const BROAD = ['SoakTest.whatAGameSeesFirstIsTheSameEverywhere', 'SoakTest.whatAGameSeesIsTheSameEverywhere', 'QuestionMatrixTest', 'QuestionVerdictsTest', 'ContactsOfTheFrameTest', 'PlacementsTest', 'ExactStructuresTest', 'CallsOfGamesTest'];

const simpleName = (name) => name.split('.').pop();

/** The room of a class: starlogo.models of starlogo.models.gltf.GltfReader. */
const roomOf = (name) => name.split('.').slice(0, -1).slice(0, 2).join('.');

/** The texts of the test classes, and of the files that they use, by qualified name. Tests call the stand-ins for flash.* standin.flash.*. */
export function readTests() {
	const files = [...sourcesBelow('src'), ...sourcesBelow('test'), ...sourcesBelow('js/standins/common')];
	const classes = new Map();
	const sources = new Map();
	const beside = new Map();
	for (const file of files) {
		const name = definitionIn(file).replace(/^standins\.common\.(flash\.)?/, (_, flash) => (flash ? 'standin.flash.' : ''));
		(/^test\/.*Test\.as$/.test(file) ? classes : sources).set(name, read(file));
		if (file.startsWith('test/starlogo/') && !classes.has(name)) beside.set(name, sources.get(name));
	}
	for (const [name, text] of classes) classes.set(name, withFilesBeside(name, text, beside));
	return { classes, sources };
}

/** The text of a test class, and of the files beside it that it uses: these are a part of the test. */
function withFilesBeside(name, text, beside) {
	const own = [...beside.keys()].filter((each) => packageOf(each) === packageOf(name));
	const files = usesIn(name, text, own);
	for (const file of files) files.push(...usesIn(file, beside.get(file), own).filter((each) => !files.includes(each)));
	return [text, ...files.map((file) => beside.get(file))].join('\n');
}

/** The test classes, and tests of classes, that Node runs in place of the browser's interpreter. They take long. */
export function inNodeAlone() {
	return new Set(read('test/runner/in-node.txt').split('\n').filter((line) => line !== '' && !line.startsWith('#')));
}

/**
 * The tests of what is farther from the sources that a pattern names, in the order in which they find a fault soonest: those of the sources' own room, which
 * say most; then BROAD, whose games and questions run most of the engine; then those of the room that take long; then those of other rooms that count as
 * farther, and all other classes that use the source, by any number of files between. Of these last too those that take long come after the others. Of two of a
 * kind the nearer is first.
 *
 * @param {{ tests: Map<string, string[] | null>, farther: Set<string>, named: string[] }} choice what choose() found
 * @param {Map<string, string>} classes the texts of the test classes, by qualified name
 * @param {Map<string, string>} sources the texts of the other files
 * @param {Set<string>} long the classes and tests that take long
 * @returns {[string, string][]} the class and the name of each
 */
export function fartherTests({ tests, farther, named }, classes, sources, long = inNodeAlone()) {
	const beyond = named.flatMap((source) => [...users(source, classes, sources)].flat()).filter((name) => classes.has(name) && !tests.has(name));
	const names = new Set([...farther, ...beyond]);
	const isLong = ([name, test]) => long.has(name) || long.has(`${name}.${test}`);
	const rooms = new Set(named.map(roomOf));
	const place = (each) => {
		const [name, test] = each;
		const broad = BROAD.findIndex((wanted) => [simpleName(name), `${simpleName(name)}.${test}`].includes(wanted));
		if (broad >= 0) return 1 + broad / BROAD.length;
		if (rooms.has(roomOf(name))) return isLong(each) ? 2 : 0;
		return (farther.has(name) ? 3 : 4) + (isLong(each) ? 2 : 0);
	};
	return [...names].flatMap((name) => testsIn(classes.get(name)).map((test) => [name, test])).sort((a, b) => place(a) - place(b));
}

/**
 * The files of tests without a player that check some sources on the module of the engine and the tests: those whose first comment says "Checks PACKAGE,
 * PACKAGE." with a source's package, or one above it.
 *
 * @param {string[]} named the sources' qualified names
 * @param {[string, string][]} [files] the path and text of each such file
 */
export function testFilesOf(named, files = filesBelow('test', '.test.mjs').map((file) => [file, read(file)])) {
	return files.filter(([, text]) => packagesIn(text).some((checked) => named.some((name) => name.startsWith(`${checked}.`)))).map(([file]) => file);
}

/** The files of tests without a player that run the samples of some pages. */
export function testsOfPages(pages) {
	return pages.some((page) => fencesIn(read(page)).some(({ language }) => language === 'js')) ? [SAMPLES_IN_JAVASCRIPT] : [];
}

/** The packages that the first comment of a test without a player says it checks. */
function packagesIn(text) {
	return (/\bChecks ((?:starlogo[\w.]+(?:,\s[\s*]*)?)+)\.\s/.exec(text.split('*/')[0])?.[1] ?? '').split(/[,\s*]+/).filter((each) => each !== '');
}

/** The names of the tests that a test class declares, in its order. */
export function testsIn(text) {
	return [...text.matchAll(/^\s*\[Test\b[^\n]*\]\s+(?:\[[^\n]*\]\s+)*public function (\w+)/gm)].map(([, name]) => name);
}

/**
 * The tests that a pattern names, in any case:
 *
 * - "BoxTest" and "BoxTest.volume", with or without a package before them, take the class or the test of exactly this name alone, if there is one.
 * - "Box" takes the classes whose names contain it. If no class is "Box" or "BoxTest", it also takes the tests of the source files of that name,
 *   and the tests whose names contain it.
 * - "Box.as", with or without folders before it, takes "BoxTest" and the tests of the source file: with folders of that file alone.
 *   "starlogo.bounding.Box" is "Box" of this package.
 * - "docs/terrain.md", with or without the folder, takes the page's samples.
 * - "BoxTest.volume" takes the tests whose names contain "volume", of the classes whose names contain "BoxTest"; ".volume" takes them of all classes.
 * - Commas stand between several of these.
 *
 * The tests of a source file are the classes that use it. If none does, they are those that use a file that uses it, and so on. The tests with the
 * names of the files that use it are taken too: of its own package always, of other packages if there are fewer than five tests, and so on. If no
 * test class uses the source itself, those that stand in its package and use it are taken too. If more than a hundred tests use the source, they
 * count as farther.
 *
 * @param {string} pattern what -Dtest has
 * @param {Map<string, string>} classes the texts of the test classes, by qualified name
 * @param {Map<string, string>} sources the texts of the other files that tests use, by qualified name
 * @returns {{ tests: Map<string, string[] | null>, usersOnly: Set<string>, farther: Set<string>, named: string[], pages: string[], said: string[] }} the tests of
 *     each class, null for all of them; the classes that are in it for what they use alone; those of them that are in it because the nearest have too few tests, or many;
 *     the sources that the pattern names; the pages that it names; and why each class is in it
 */
export function choose(pattern, classes, sources) {
	const choice = emptyChoice();
	for (const part of pattern.split(',').filter((each) => each.trim() !== '')) chooseOne(part.trim(), classes, sources, choice);
	return choice;
}

/** The tests of the classes that a pattern names before its last point, for one whose test there is not: all of their names with their classes. */
export function testsBefore(pattern, classes) {
	const found = choose(pattern.replace(/[.#][^.#,]*(?=,|$)/g, ''), classes, new Map()).tests;
	return [...found.keys()].flatMap((name) => testsIn(classes.get(name)).map((test) => `${name}.${test}`));
}

/** What choose() finds if there is no pattern: all tests. */
export function chooseAll(classes) {
	return { ...emptyChoice(), tests: new Map([...classes.keys()].map((name) => [name, null])) };
}

function emptyChoice() {
	return { tests: new Map(), usersOnly: new Set(), farther: new Set(), named: [], pages: [], said: [] };
}

/** Adds to a choice what a pattern without commas names. */
function chooseOne(pattern, classes, sources, choice) {
	const { wanted, test, isFile, isNamed } = parse(pattern, [...classes.keys(), ...sources.keys()]);
	const page = pageNamed(pattern);
	if (page !== null) {
		choice.pages.push(page);
		addClasses(choice, `samples of ${page}`, [classOfSamples(page)].filter((name) => classes.has(name)));
		return;
	}
	if (addExact(choice, pattern, classes)) return;
	const isOwn = (name) => [wanted, `${wanted}test`].includes(simpleName(name).toLowerCase());
	const ofClass = [...classes.keys()].filter((name) => (isFile ? isOwn(name) : simpleName(name).toLowerCase().includes(wanted)));
	if (test !== '') {
		addTestsWith(choice, classes, ofClass, test);
		return;
	}
	addClasses(choice, isFile ? 'its tests' : `classes named *${wanted}*`, ofClass);
	if (!isFile && ofClass.some(isOwn)) return;
	for (const source of [...sources.keys()].filter(isNamed)) addTestsOf(choice, source, ofClass, classes, sources);
	if (!isFile) addTestsWith(choice, classes, [...classes.keys()], wanted);
}

/** Adds classes of tests, and why. Returns those that were not in the choice yet. */
function addClasses({ tests, said }, reason, found) {
	const added = found.filter((name) => tests.get(name) !== null);
	for (const name of added) tests.set(name, null);
	if (added.length > 0) said.push(`${reason}: ${added.map(simpleName).join(', ')}`);
	return added;
}

/** Adds some tests of classes, and why. */
function addTests({ tests, said }, reason, classes, names, isTaken) {
	const known = (name) => tests.get(name) ?? [];
	const named = names.filter((name) => tests.get(name) !== null).map((name) => [name, testsIn(classes.get(name)).filter((each) => isTaken(name, each) && !known(name).includes(each))]);
	const found = named.filter(([, list]) => list.length > 0);
	if (found.length > 0) said.push(`${reason}: ${found.map(([name, list]) => `${simpleName(name)} (${list.join(', ')})`).join(', ')}`);
	for (const [name, list] of found) tests.set(name, [...known(name), ...list]);
}

/** Adds the tests of classes that have a part in their names. */
function addTestsWith(choice, classes, names, part) {
	addTests(choice, `tests named *${part}*`, classes, names, (name, each) => each.toLowerCase().includes(part));
}

/** Adds the classes and tests of exactly a name. Returns whether there are some. */
function addExact(choice, pattern, classes) {
	const isExactly = (...names) => [names, [simpleName(names[0]), ...names.slice(1)]].some((each) => each.join('.').toLowerCase() === pattern.replace('#', '.').toLowerCase());
	const exact = [...classes.keys()].filter((name) => isExactly(name) || testsIn(classes.get(name)).some((each) => isExactly(name, each)));
	addClasses(choice, 'the class', exact.filter((name) => isExactly(name)));
	addTests(choice, 'the test', classes, exact, isExactly);
	return exact.length > 0;
}

/** Adds the classes that use a source, and those of what uses it, beside its own classes of tests. */
function addTestsOf(choice, source, own, classes, sources) {
	const add = (reason, found, areFarther) => {
		for (const name of addClasses(choice, reason, found)) {
			choice.usersOnly.add(name);
			if (areFarther) choice.farther.add(name);
		}
	};
	const nearest = nearestTests(source, classes, sources);
	add(`classes that use ${source}, directly or through other files`, nearest, countOf(nearest, classes) > MANY);
	const inPackage = testsOfPackage(source, classes, sources).filter((name) => !nearest.includes(name));
	add(`classes of tests in the package of ${source}`, inPackage, true);
	const known = new Set([...own, ...nearest, ...inPackage, ...testsOfNeighbours(source, classes, sources)]);
	add(`tests of what uses ${source}`, [...known, ...testsOfUsers(source, known, classes, sources)], true);
	choice.named.push(source);
}

/** What a pattern may mean that finds nothing: the classes, sources and pages whose names contain its own, or else the nearest as with misspelt options. */
export function nearestNames(pattern, classes, sources) {
	const wanted = simpleName(pattern.split(/[\\/]/).pop().replace(/\.(as|md)$/i, '')).toLowerCase();
	const names = [...new Set([...[...sources.keys(), ...classes.keys()].map(simpleName), ...filesBelow('docs', '.md').map((file) => path.basename(file))])];
	const farAway = (name) => $changesBetween(wanted, name.toLowerCase().replace(/\.md$/, ''));
	const containing = names.filter((name) => name.toLowerCase().includes(wanted));
	const near = containing.length > 0 ? containing : names.filter((name) => farAway(name) <= Math.max(1, wanted.length / 3));
	return near.sort((a, b) => farAway(a) - farAway(b)).slice(0, 5);
}

/** The page that a pattern names, by its path in the project or its name in docs/; or null. */
function pageNamed(pattern) {
	const file = pattern.replaceAll('\\', '/');
	return /\.md$/.test(file) ? [file, `docs/${file}`].find((each) => existsSync(path.join(root, each))) ?? null : null;
}

/** What a pattern asks for, in small letters: a part of a class's name or a source's name, and a part of a test's name. isNamed tells whether it names a source. */
function parse(pattern, names) {
	const isFile = /\.as$/i.test(pattern);
	const path = isFile ? pattern.slice(0, -3).split(/[\\/]/).filter((part) => !/^\.*$/.test(part)).join('.') : pattern;
	const isQualified = (name) => name.includes('.') && names.some((each) => each.toLowerCase() === name.toLowerCase());
	const [, start, end] = /^(.*?)(?:[.#]([^.#]*))?$/.exec(path);
	const [whole, test = ''] = isFile || isQualified(path) ? [path] : isQualified(start) ? [start, end] : path.split(/[.#]/);
	const [wanted, ...packages] = partsOf(whole);
	// a path has folders above the packages, or only the last of these
	const isNamed = (name) => {
		const [own, ...above] = partsOf(name.replace(/^standin\./, ''));
		return own === wanted && packages.every((part, i) => i >= above.length || above[i] === part);
	};
	return { wanted, test: test.toLowerCase(), isFile, isNamed };
}

/** The parts of a qualified name, the last one first, in small letters. */
function partsOf(name) {
	return name.toLowerCase().split('.').reverse();
}

/** The test classes that use a source, by as few files between as there can be. */
function nearestTests(source, classes, sources) {
	for (const files of users(source, classes, sources)) {
		const found = files.filter((name) => classes.has(name));
		if (found.length > 0) return found;
	}
	return [];
}

/** The test classes with the names of the files of its own package that use a source. */
function testsOfNeighbours(source, classes, sources) {
	const [files] = users(source, classes, sources);
	const own = new Set(files.filter((name) => packageOf(name) === packageOf(source)).map(testName));
	return [...classes.keys()].filter((name) => own.has(simpleName(name).toLowerCase()));
}

/** The test classes of a source's own package that use something of it, if no test class uses the source itself. */
function testsOfPackage(source, classes, sources) {
	const [files] = users(source, classes, sources);
	if (files.some((name) => classes.has(name))) return [];
	const own = [...sources.keys()].filter((name) => packageOf(name) === packageOf(source));
	return [...classes.keys()].filter((name) => packageOf(name) === packageOf(source) && uses(name, classes.get(name), own));
}

/** The test classes with the names of the files that use a source, or that use these, and so on, until there are enough tests with those that are known. */
function testsOfUsers(source, known, classes, sources) {
	const found = new Set(known);
	for (const files of users(source, classes, sources)) {
		if (countOf([...found], classes) >= ENOUGH) break;
		const own = new Set(files.filter((name) => !classes.has(name)).map(testName));
		for (const name of [...classes.keys()].filter((each) => own.has(simpleName(each).toLowerCase()))) found.add(name);
	}
	return [...found].filter((name) => !known.has(name));
}

/** What uses a source, then what uses that, and so on; tests are used by nothing. */
function* users(source, classes, sources) {
	const all = new Map([...sources, ...classes]);
	const seen = new Set([source]);
	for (let last = [source]; last.length > 0; ) {
		const next = [...all.keys()].filter((name) => !seen.has(name) && uses(name, all.get(name), last));
		yield next;
		for (const name of next) seen.add(name);
		last = next.filter((name) => !classes.has(name));
	}
}

function countOf(names, classes) {
	return names.reduce((sum, name) => sum + testsIn(classes.get(name)).length, 0);
}

/** The name that the tests of a source have, in small letters: those of the function intersects are IntersectsTest. */
function testName(source) {
	return `${simpleName(source)}Test`.toLowerCase();
}

/** Whether a file uses one of some sources. Whether it has one of their names at all is quickly told. */
function uses(file, text, names) {
	return names.some((name) => text.includes(simpleName(name))) && usesIn(file, text, names).length > 0;
}
