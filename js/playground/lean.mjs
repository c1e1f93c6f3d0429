/**
 * Removes from three.js what nothing names. A bundler leaves out unused classes, but it keeps all methods of the others. three.js calls its
 * methods by their names alone, so a method whose name stands nowhere else is never called.
 */

// not in a string
const COMMENTS = [/^(\s*)\/\*[\s\S]*?\*\//gm, /^([^"'`\n]*?)\/\/.*/gm];
const NAMES = /^(?:import|export) \{[^}]*\}.*$/gm;
const CLASS = /^(?:class|function) (\w+)[^\n]*\{\n[^]*?^\}\n/gm;
const MEMBERS = [
	/^(\t)(?:static |async )?(?:get |set )?(\w+)\([^)\n]*\) \{\n[^]*?^\1\}\n/gm,
	/^(\t+)(?:async )?function (\w+)\([^)\n]*\) \{\n[^]*?^\1\}\n/gm,
	/^(\t+)this\.(\w+) = (?:async )?function ?\([^)\n]*\) \{\n[^]*?^\1\};\n/gm,
];

const withoutComments = (text) => COMMENTS.reduce((rest, comment) => rest.replace(comment, "$1"), text);

const countWords = (text) => {
	const counts = new Map();
	for (const [word] of text.matchAll(/[\w$]+/g)) counts.set(word, (counts.get(word) ?? 0) + 1);
	return counts;
};

/**
 * @param {string[]} texts files of three.js, without what is removed before
 * @param {string} users the text of all that uses them
 * @returns {string[]} the texts without methods and inner functions that nothing names
 */
export function withoutUnused(texts, users) {
	let live = texts.map((text) => withoutComments(text).replace(NAMES, "")).join("\n");
	const imported = withoutComments(users);
	for (let before = ""; before !== live; ) {
		before = live;
		const counts = countWords(live + imported);
		const isUnused = (name, times) => name !== "constructor" && counts.get(name) === times;
		live = live.replace(CLASS, (text, name) => (isUnused(name, text.split(new RegExp(`\\b${name}\\b`)).length - 1) ? "" : text));
		const written = new Map();
		for (const member of MEMBERS) for (const [, , name] of live.matchAll(member)) written.set(name, (written.get(name) ?? 0) + 1);
		const drop = (all, _, name) => (isUnused(name, written.get(name)) ? "" : all);
		for (const member of MEMBERS) live = live.replace(member, drop);
		// also in the classes that are left out
		for (const member of MEMBERS) texts = texts.map((text) => text.replace(member, drop));
	}
	return texts;
}
