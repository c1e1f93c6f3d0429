/** What is written in a client's test class, and does not run as it was meant. */

/** A mark of a class: [Suite], perhaps more metadata, and the words before "class". */
const MARKED_CLASS = /\[(Suite|RunWith|Ignore)\b[^\]]*\]\s*(?:\[[^\]]*\]\s*)*(?:\w+\s+)*class\b/g;

/** A function: its metadata, the words before "function", its name, its parameters, and its type. */
const FUNCTION = /((?:\[[^\]]*\]\s*)*)((?:\w+\s+)*)function\s+(\w+)\s*\(([^)]*)\)\s*(?::\s*(\w+))?/g;

/** The tags of the functions that FlexUnit runs. */
const TAGS = ['Test', 'Theory', 'Before', 'After', 'BeforeClass', 'AfterClass'];

/**
 * What FlexUnit would leave out, and what the player does not see.
 *
 * @param {string} text the text of a test class
 * @returns {{ line: number, said: string, isError: boolean }[]} an error if tests would not run though they are marked
 */
export function problemsIn(text) {
	const source = codeOf(text);
	const lineAt = (index) => source.slice(0, index).split('\n').length;
	const ofClass = [...source.matchAll(MARKED_CLASS)].map(({ 1: mark, index }) => ({
		line: lineAt(index),
		said: `[${mark}] of a class does nothing here: the embedded player does not see the metadata of classes`,
		isError: false,
	}));
	const isOld = /\bextends\s+TestCase\b/.test(source);
	const ofFunctions = [...source.matchAll(FUNCTION)].flatMap((found) => {
		const problem = problemOf(found, isOld);
		return problem === null ? [] : [{ line: lineAt(found.index + found[0].indexOf('function')), ...problem }];
	});
	return [...ofClass, ...ofFunctions];
}

/** Whether a class is a part of the game that is named like a class of tests, as a HitTest: nothing in it is marked as a test, or looks like one. */
export function isForTheGame(text) {
	const source = codeOf(text);
	return /\bclass\b/.test(source) && !/\[(Test|Theory|Suite|RunWith)\b|\bextends\b/.test(source) && problemsIn(text).length === 0;
}

/** What is wrong with a function, or null. Classes of old versions of FlexUnit, which extend TestCase, need no [Test]. */
function problemOf([, metadata, words, name, parameters, type = 'void'], isOld) {
	const [written, tag] = [...metadata.matchAll(/\[(\w+)/g)].map(([, each]) => [each, TAGS.find((known) => known.toLowerCase() === each.toLowerCase())])
		.find(([, known]) => known) ?? [];
	const isPublic = /\bpublic\b/.test(words);
	if (!tag) {
		const isForgotten = !isOld && metadata === '' && isPublic && /^test[A-Z]/.test(name);
		return isForgotten ? { said: `${name}() has no [Test], so FlexUnit does not run it`, isError: false } : null;
	}
	const error = (said) => ({ said: `${name}() has [${written}]${said}`, isError: true });
	const stops = (has, must) => error(` and ${has}: FlexUnit runs no test of a class that has such a function. It must ${must}`);
	const isStatic = /\bstatic\b/.test(words);
	if (written !== tag) return error(`, which FlexUnit does not know: it is [${tag}]`);
	if (!isPublic) return error(' and is not public, so FlexUnit does not run it');
	if (type !== 'void') return stops(`gives ${type}`, 'be void');
	if (tag !== 'Theory' && parameters.trim() !== '') return stops('takes a parameter', 'take none');
	if (isStatic && !tag.endsWith('Class')) return stops('is static', 'not be static');
	return !isStatic && tag.endsWith('Class') ? stops('is not static', 'be static') : null;
}

/** A text with spaces in place of its comments, and of what is in its strings. */
function codeOf(text) {
	return text.replace(/\/\*[^]*?\*\/|\/\/.*|(["'])(?:\\.|(?!\1).)*\1/g, (part, quote = ' ') => quote + part.slice(1, -1).replace(/[^\n]/g, ' ') + quote);
}
