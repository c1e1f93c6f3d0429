/** What is written in a client's test class, and does not run as it was meant. */

/** A mark of a class: [Suite], perhaps more metadata, and the words before "class". */
const MARKED_CLASS = /\[(Suite|RunWith|Ignore)\b[^\]]*\]\s*(?:\[[^\]]*\]\s*)*(?:\w+\s+)*class\b/g;

/** A function: its metadata, the words before "function", its name, and its type. */
const FUNCTION = /((?:\[[^\]]*\]\s*)*)((?:\w+\s+)*)function\s+(\w+)\s*\([^)]*\)\s*(?::\s*(\w+))?/g;

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
function problemOf([, metadata, words, name, type = 'void'], isOld) {
	const tag = /\[(Test|Theory|Before|After)\b/.exec(metadata)?.[1];
	const isPublic = /\bpublic\b/.test(words);
	const error = (said) => ({ said: `${name}() ${said}`, isError: true });
	if (tag && !isPublic) return error(`has [${tag}] and is not public, so FlexUnit does not run it`);
	if (tag && type !== 'void') {
		return error(`has [${tag}] and gives ${type}: FlexUnit runs no test of a class that has such a function. It must be void`);
	}
	const isForgotten = !isOld && metadata === '' && isPublic && /^test[A-Z]/.test(name);
	return isForgotten ? { said: `${name}() has no [Test], so FlexUnit does not run it`, isError: false } : null;
}

/** A text with spaces in place of its comments, and of what is in its strings. */
function codeOf(text) {
	return text.replace(/\/\*[^]*?\*\/|\/\/.*|(["'])(?:\\.|(?!\1).)*\1/g, (part, quote = ' ') => quote + part.slice(1, -1).replace(/[^\n]/g, ' ') + quote);
}
