/** What a client's test class has: its functions, and what does not run as it was meant. */
import { $isProbablyMisspelt } from '../../js/standins/module/warnings/spelling.mjs';

/** A mark of a class: [Suite], perhaps more metadata, and the words before "class". */
const MARKED_CLASS = /\[(Suite|RunWith|Ignore)\b[^\]]*\]\s*(?:\[[^\]]*\]\s*)*(?:\w+\s+)*class\b/g;

/** A function: its metadata, the words before "function", its name, its parameters, and its type. */
const FUNCTION = /(?<metadata>(?:\[[^\]]*\]\s*)*)(?<words>(?:\w+\s+)*)function\s+(?<name>\w+)\s*\((?<parameters>[^)]*)\)\s*(?::\s*(?<type>\w+))?/g;

/** The tags of the functions that FlexUnit runs. */
const TAGS = ['Test', 'Theory', 'Before', 'After', 'BeforeClass', 'AfterClass'];
const TAG = new RegExp(`\\[(${TAGS.join('|')})\\b`, 'i');

/** The line of a text at an index. */
export const lineAt = (text, index) => text.slice(0, index).split('\n').length;

/** The parts of each function that a text names, its line, and the reason that [Ignore] gives. */
export function functionsIn(text) {
	const source = codeOf(text);
	return [...source.matchAll(FUNCTION)].map(({ 0: all, index, groups }) => {
		const [, reason] = /\[Ignore\b/.test(groups.metadata) && /\[Ignore\b[^\]]*?("[^"\n]+")/.exec(text.slice(index, index + all.length)) || [];
		return { ...groups, reason, line: lineAt(source, index + all.indexOf('function')) };
	});
}

/**
 * What FlexUnit would leave out, and what the player does not see.
 *
 * @param {string} text the text of a test class
 * @returns {{ line: number, said: string, isError: boolean }[]} an error if tests would not run though they are marked
 */
export function problemsIn(text) {
	const source = codeOf(text);
	const ofClass = [...source.matchAll(MARKED_CLASS)].map(({ 1: mark, index }) => ({
		line: lineAt(source, index),
		said: `[${mark}] of a class does nothing here: the embedded player does not see the metadata of classes`,
		isError: false,
	}));
	const isOld = /\bextends\s+TestCase\b/.test(source);
	const ofFunctions = functionsIn(text).map((found) => ({ line: found.line, ...problemOf(found, isOld) })).filter(({ said }) => said);
	return [...ofClass, ...ofFunctions];
}

/** Whether a class is a part of the game that is named like a class of tests, as a HitTest: nothing in it is marked as a test, or looks like one. */
export function isForTheGame(text) {
	const source = codeOf(text);
	return /\bclass\b/.test(source) && !/\[(Test|Theory|Suite|RunWith)\b|\bextends\b/.test(source) && problemsIn(text).length === 0;
}

/** Whether a text marks functions as tests. */
export function hasTests(text) {
	return /\[Test\b/.test(codeOf(text));
}

/** What is wrong with a function, or null. Classes of old versions of FlexUnit, which extend TestCase, need no [Test]. */
function problemOf({ metadata, words, name, parameters, type = 'void' }, isOld) {
	const [, written] = TAG.exec(metadata) ?? [];
	const tag = TAGS.find((known) => known.toLowerCase() === written?.toLowerCase());
	const isPublic = /\bpublic\b/.test(words);
	if (!tag) {
		const near = (word) => TAGS.find((known) => $isProbablyMisspelt(word.toLowerCase(), known.toLowerCase()));
		const misspelt = [...metadata.matchAll(/\[(\w+)/g)].map(([, word]) => word).find(near);
		if (misspelt) return { said: `${name}() has [${misspelt}], which FlexUnit does not know; is [${near(misspelt)}] meant?`, isError: false };
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
