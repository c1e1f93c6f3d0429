/** Which tests are tests of a source, by what uses what. */
import { packageOf, usesIn } from '../structure/sources.mjs';
import { countOf, simpleName } from './test-classes.mjs';

/** Fewer tests than these say little of a source. */
const ENOUGH = 5;

/** What uses a source, then what uses that, and so on; tests are used by nothing. */
export function* users(source, classes, sources) {
	const all = new Map([...sources, ...classes]);
	const seen = new Set([source]);
	for (let last = [source]; last.length > 0; ) {
		const next = [...all.keys()].filter((name) => !seen.has(name) && uses(name, all.get(name), last));
		yield next;
		for (const name of next) seen.add(name);
		last = next.filter((name) => !classes.has(name));
	}
}

/** The test classes that use a source, by as few files between as there can be. */
export function nearestTests(source, classes, sources) {
	for (const files of users(source, classes, sources)) {
		const found = files.filter((name) => classes.has(name));
		if (found.length > 0) return found;
	}
	return [];
}

/** The test classes with the names of the files of its own package that use a source. */
export function testsOfNeighbours(source, classes, sources) {
	const [files] = users(source, classes, sources);
	return testsNamedAs(files.filter((name) => packageOf(name) === packageOf(source)), classes);
}

/** The test classes with the names of some files. */
export function testsNamedAs(files, classes) {
	const own = new Set(files.map(testName));
	return [...classes.keys()].filter((name) => own.has(simpleName(name).toLowerCase()));
}

/** The test classes of a source's own package that use something of it, if no test class uses the source itself. */
export function testsOfPackage(source, classes, sources) {
	const [files] = users(source, classes, sources);
	if (files.some((name) => classes.has(name))) return [];
	const own = [...sources.keys()].filter((name) => packageOf(name) === packageOf(source));
	return [...classes.keys()].filter((name) => packageOf(name) === packageOf(source) && uses(name, classes.get(name), own));
}

/**
 * The test classes with the names of the files that use a source, or that use these, and so on, until there are enough tests with those
 * that are known.
 */
export function testsOfUsers(source, known, classes, sources) {
	const found = new Set(known);
	for (const files of users(source, classes, sources)) {
		if (countOf([...found], classes) >= ENOUGH) break;
		for (const name of testsNamedAs(files, classes)) found.add(name);
	}
	return [...found].filter((name) => !known.has(name));
}

/** The name that the tests of a source have, in small letters: those of the function intersects are IntersectsTest. */
function testName(source) {
	return `${simpleName(source)}Test`.toLowerCase();
}

/** Whether a file uses one of some sources. Whether it has one of their names at all is quickly told. */
function uses(file, text, names) {
	return names.some((name) => text.includes(simpleName(name))) && usesIn(file, text, names).length > 0;
}
