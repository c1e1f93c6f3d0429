/** What Node runs of a source after the tests that were chosen: the other tests that use it, and tests without a player, the nearest first. */
import { SAMPLES_IN_JAVASCRIPT, fencesIn } from '../docs/samples.mjs';
import { filesBelow, read, usesIn } from '../structure/sources.mjs';
import { inNodeAlone, simpleName, testsIn } from './test-classes.mjs';
import { testsNamedAs, users } from './users.mjs';

/** Tests that compare a hash of all that a game sees. They find most. */
const OF_GAMES = ['SoakTest.whatAGameSeesFirstIsTheSameEverywhere', 'SoakTest.whatAGameSeesIsTheSameEverywhere'];

/** All tests that compare a hash. They cannot say what is wrong. */
export const OF_HASHES = [
	...OF_GAMES,
	'FitterTest.equallyGoodBoxesAreChosenAlikeOnEveryMachine',
	'StoredFitsTest.anotherAlgorithmIsAnotherRevision',
	'StoredFitsTest.anotherHullIsAnotherRevision',
];

/** Tests that call much of the engine. What no nearer test finds, these find soonest. */
export const BROAD = [
	...OF_GAMES,
	'QuestionMatrixTest',
	'QuestionVerdictsTest',
	'ContactsOfTheFrameTest',
	'PlacementsTest',
	'ExactStructuresTest',
	'CallsOfGamesTest',
];

/** The room of a class: starlogo.models of starlogo.models.gltf.GltfMesh. */
const roomOf = (name) => name.split('.').slice(0, -1).slice(0, 2).join('.');

/** A word that more names of test classes have says nothing of what they test. */
const RARE = 8;

/** The words of a name, in small letters and without a plural's s: edge and pair of EdgePairTests. */
const wordsOf = (name) => simpleName(name).match(/[A-Z]?[a-z0-9]+|[A-Z]+/g)
	.map((word) => word.toLowerCase().replace(/ies$/, 'y').replace(/s$/, '')).filter((word) => word !== 'test');

/** Whether the names of a class and of a test have two words of a source's name. */
function haveTwoWords([name, test], source) {
	const words = [...wordsOf(name), ...wordsOf(test)];
	return wordsOf(source).filter((word) => words.includes(word)).length > 1;
}

/** The classes that name some sources, those first in which these names are the largest part of the text. */
function naming(sources, classes) {
	const countIn = (name, text) => usesIn(name, text, sources).reduce((sum, source) => sum + text.split(simpleName(source)).length - 1, 0);
	const shares = [...classes].map(([name, text]) => [name, countIn(name, text) / text.length]).filter(([, share]) => share > 0);
	return shares.sort(([, a], [, b]) => b - a).map(([name]) => name);
}

/** The names that have a word of a source's name, if few have it. */
function namesakes(sources, names) {
	const words = new Set(sources.flatMap(wordsOf));
	const having = [...words].map((word) => names.filter((name) => wordsOf(name).includes(word)));
	return new Set(having.filter((found) => found.length <= RARE).flat());
}

/**
 * The tests that use the sources that a pattern names and were not chosen to run first, in the order in which they find a fault soonest:
 * those whose names have two words of a source's name; those with the name of a file that uses the source, or that uses such a file, and
 * those of the sources' own room that have a rare word; those that name the source, the more often the sooner; the tests without a player
 * that check it; those of the room; those of other rooms that have a rare word; then BROAD, whose games and questions run most of the
 * engine; then those of the room, and with a rare word, that take long; then those of other rooms that count as farther, and all other
 * classes that use the source, by any number of files between. Of these last too those that take long come after the others. Of two of a
 * kind the nearer is first.
 *
 * @param {{ tests: Map<string, string[] | null>, farther: Set<string>, named: string[] }} choice what choose() found
 * @param {Map<string, string>} classes the texts of the test classes, by qualified name
 * @param {Map<string, string>} sources the texts of the other files
 * @param {Set<string>} long the classes and tests that take long
 * @returns {[string, string | undefined][]} the class and the name of each, or a file of tests without a player
 */
export function fartherTests({ tests, farther, named }, classes, sources, long = inNodeAlone()) {
	const usersOf = named.map((source) => [...users(source, classes, sources)]);
	const beyond = usersOf.flat(2).filter((name) => classes.has(name) && !tests.has(name));
	const names = new Set([...farther, ...beyond]);
	const isLong = ([name, test]) => long.has(name) || long.has(`${name}.${test}`);
	const rooms = new Set(named.map(roomOf));
	const ofUsers = new Set(testsNamedAs(usersOf.flatMap((files) => files.slice(0, 2)).flat(), classes));
	const isNamesake = namesakes(named, [...classes.keys()]);
	const ofNames = naming(named, classes);
	const place = (each) => {
		const [name, test] = each;
		if (test === undefined) return -1;
		if (named.some((source) => haveTwoWords(each, source))) return -4;
		const isOfRoom = rooms.has(roomOf(name));
		if (ofUsers.has(name) || (isOfRoom && isNamesake.has(name))) return -3;
		if (ofNames.includes(name) && !isLong(each)) return -2 + ofNames.indexOf(name) / ofNames.length;
		const broad = BROAD.findIndex((wanted) => [simpleName(name), `${simpleName(name)}.${test}`].includes(wanted));
		if (broad >= 0) return 1 + broad / BROAD.length;
		if (isOfRoom) return isLong(each) ? 2 : 0;
		if (isNamesake.has(name)) return isLong(each) ? 2.5 : 0.5;
		return (farther.has(name) ? 3 : 4) + (isLong(each) ? 2 : 0);
	};
	const found = [...names].flatMap((name) => testsIn(classes.get(name)).map((test) => [name, test]));
	const placed = [...found, ...testFilesOf(named).map((file) => [file])].map((each) => [each, place(each)]);
	return placed.sort(([, a], [, b]) => a - b).map(([each]) => each);
}

/** What the runner calls a class's test: without the package. A file has its path. */
export const nameInNode = ([name, test]) => (test === undefined ? name : `${simpleName(name)}.${test}`);

/**
 * The files of tests without a player that check some sources on the module of the engine and the tests: those whose first comment says
 * "Checks PACKAGE, PACKAGE." with a source's package, or one above it.
 *
 * @param {string[]} named the sources' qualified names
 * @param {[string, string][]} [files] the path and text of each such file
 */
export function testFilesOf(named, files = filesBelow('test', '.test.mjs').map((file) => [file, read(file)])) {
	const isNamed = (checked) => named.some((name) => name.startsWith(`${checked}.`));
	return files.filter(([, text]) => packagesIn(text).some(isNamed)).map(([file]) => file);
}

/** The files of tests without a player that run the samples of some pages. */
export function testsOfPages(pages) {
	return pages.some((page) => fencesIn(read(page)).some(({ language }) => language === 'js')) ? [SAMPLES_IN_JAVASCRIPT] : [];
}

/** The packages that the first comment of a test without a player says it checks. */
function packagesIn(text) {
	const [, list = ''] = /\bChecks ((?:starlogo[\w.]+(?:,\s[\s*]*)?)+)\.\s/.exec(text.split('*/')[0]) ?? [];
	return list.split(/[,\s*]+/).filter((each) => each !== '');
}
