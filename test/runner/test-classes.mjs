/** The test classes that there are, and the tests in them. */
import { definitionIn, packageOf, read, sourcesBelow, usesIn } from '../structure/sources.mjs';

/** A class's name without its package. */
export const simpleName = (name) => name.split('.').pop();

/**
 * The texts of the test classes, and of the files that they use, by qualified name. Tests call the stand-ins for flash.* standin.flash.*.
 */
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

/** The names of the tests that a test class declares, in its order. */
export function testsIn(text) {
	return [...text.matchAll(/^\s*\[Test\b[^\n]*\]\s+(?:\[[^\n]*\]\s+)*public function (\w+)/gm)].map(([, name]) => name);
}

/** How many tests some classes have. */
export function countOf(names, classes) {
	return names.reduce((sum, name) => sum + testsIn(classes.get(name)).length, 0);
}
