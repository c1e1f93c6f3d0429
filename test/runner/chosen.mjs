/** Which tests -Dtest names: by a class of tests, by a test, by the source file that they test, or by the page whose samples they are. */
import { existsSync } from 'node:fs';
import path from 'node:path';
import { $changesBetween } from '../../js/standins/module/warnings/spelling.mjs';
import { classOfSamples } from '../docs/samples.mjs';
import { filesBelow, root } from '../structure/sources.mjs';
import { countOf, simpleName, testsIn } from './test-classes.mjs';
import { nearestTests, testsOfNeighbours, testsOfPackage, testsOfUsers } from './users.mjs';

/** More tests than these that use a source are not the first to run. */
const MANY = 100;

/**
 * The tests that a pattern names, in any case:
 *
 * - "BoxTest" and "BoxTest.volume", with or without a package before them, take the class or the test of exactly this name alone, if
 *   there is one.
 * - "Box" takes the classes whose names contain it. If no class is "Box" or "BoxTest", it also takes the tests of the source files of
 *   that name, and the tests whose names contain it.
 * - "Box.as", with or without folders before it, takes "BoxTest" and the tests of the source file: with folders of that file alone.
 *   "starlogo.bounding.Box" is "Box" of this package.
 * - "docs/terrain.md", with or without the folder, takes the page's samples.
 * - "BoxTest.volume" takes the tests whose names contain "volume", of the classes whose names contain "BoxTest"; ".volume" takes them
 *   of all classes.
 * - Commas stand between several of these.
 *
 * The tests of a source file are the classes that use it. If none does, they are those that use a file that uses it, and so on. The
 * tests with the names of the files that use it are taken too: of its own package always, of other packages if there are fewer than
 * five tests, and so on. If no test class uses the source itself, those that stand in its package and use it are taken too. If more
 * than a hundred tests use the source, they count as farther. The samples of pages are tests of their pages alone.
 *
 * @param {string} pattern what -Dtest has
 * @param {Map<string, string>} classes the texts of the test classes, by qualified name
 * @param {Map<string, string>} sources the texts of the other files that tests use, by qualified name
 * @returns {{ tests: Map<string, string[] | null>, ofSources: Set<string>, farther: Set<string>, named: string[], pages: string[],
 *     said: string[] }} the tests of each class, null for all of them; the classes that are in it as tests of a source, not by their
 *     names; those of them that are in it because the nearest have too few tests, or many; the sources that the pattern names; the pages
 *     that it names; and why each class is in it
 */
export function choose(pattern, classes, sources) {
	const choice = emptyChoice();
	for (const part of pattern.split(',').filter((each) => each.trim() !== '')) chooseOne(part.trim(), classes, sources, choice);
	return choice;
}

/**
 * The tests of the classes that a pattern names before its last point, for one whose test there is not: all of their names with their
 * classes.
 */
export function testsBefore(pattern, classes) {
	const found = choose(pattern.replace(/[.#][^.#,]*(?=,|$)/g, ''), classes, new Map()).tests;
	return [...found.keys()].flatMap((name) => testsIn(classes.get(name)).map((test) => `${name}.${test}`));
}

/** What choose() finds if there is no pattern: all tests. */
export function chooseAll(classes) {
	return { ...emptyChoice(), tests: new Map([...classes.keys()].map((name) => [name, null])) };
}

function emptyChoice() {
	return { tests: new Map(), ofSources: new Set(), farther: new Set(), named: [], pages: [], said: [] };
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
	const added = addClasses(choice, isFile ? 'its tests' : `classes named *${wanted}*`, ofClass);
	for (const name of added) if (isFile && simpleName(name).toLowerCase() !== wanted) choice.ofSources.add(name);
	if (!isFile && ofClass.some(isOwn)) return;
	const withoutSamples = new Map([...classes].filter(([name]) => !name.startsWith('docs.')));
	for (const source of [...sources.keys()].filter(isNamed)) addTestsOf(choice, source, ofClass, withoutSamples, sources);
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
	const wantedOf = (name) => testsIn(classes.get(name)).filter((each) => isTaken(name, each) && !known(name).includes(each));
	const named = names.filter((name) => tests.get(name) !== null).map((name) => [name, wantedOf(name)]);
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
	const wanted = pattern.replace('#', '.').toLowerCase();
	const isExactly = (name, ...test) => [name, simpleName(name)].some((each) => [each, ...test].join('.').toLowerCase() === wanted);
	const exact = [...classes.keys()].filter((name) => isExactly(name) || testsIn(classes.get(name)).some((each) => isExactly(name, each)));
	addClasses(choice, 'the class', exact.filter((name) => isExactly(name)));
	addTests(choice, 'the test', classes, exact, isExactly);
	return exact.length > 0;
}

/** Adds the classes that use a source, and those of what uses it, beside its own classes of tests. */
function addTestsOf(choice, source, own, classes, sources) {
	const add = (reason, found, areFarther) => {
		for (const name of addClasses(choice, reason, found)) {
			choice.ofSources.add(name);
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

/**
 * What a pattern may mean that finds nothing: the classes, sources and pages whose names contain its own, or else the nearest as with
 * misspelt options.
 */
export function nearestNames(pattern, classes, sources) {
	const wanted = simpleName(pattern.split(/[\\/]/).pop().replace(/\.(as|md)$/i, '')).toLowerCase();
	const pages = filesBelow('docs', '.md').map((file) => path.basename(file));
	const names = [...new Set([...[...sources.keys(), ...classes.keys()].map(simpleName), ...pages])];
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

/**
 * What a pattern asks for, in small letters: a part of a class's name or a source's name, and a part of a test's name. isNamed tells
 * whether it names a source.
 */
function parse(pattern, names) {
	const isFile = /\.as$/i.test(pattern);
	const isFolder = (part) => !/^\.*$/.test(part);
	const path = isFile ? pattern.slice(0, -3).split(/[\\/]/).filter(isFolder).join('.') : pattern;
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
