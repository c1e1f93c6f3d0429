import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** The project's folder. */
export const root = fileURLToPath(new URL('../..', import.meta.url));

/** Asserts that nothing of a kind is wrong. All that is stands in one line, because the last lines of a run have only the first of each test. */
export function assertNone(wrong) {
	assert.ok(wrong.length === 0, wrong.join('; '));
}

/** What a list of names lacks of those that it should have, and what it has too many or twice, as sentences; none if it has exactly these. */
export function differences(list, names, expected) {
	const tooMany = [...names];
	const lacking = expected.filter((name) => {
		const at = tooMany.indexOf(name);
		if (at >= 0) tooMany.splice(at, 1);
		return at < 0;
	});
	const said = [['lacks', lacking], ['has too many:', tooMany]].filter(([, left]) => left.length > 0);
	return said.map(([how, left]) => `${list} ${how} ${left.join(', ')}`);
}

/** A file's text, by its path in the project. */
export function read(file) {
	return readFileSync(path.join(root, file), 'utf8');
}

/** The names of the folders in a folder, sorted. */
export function foldersIn(folder) {
	return readdirSync(path.join(root, folder), { withFileTypes: true })
		.filter((entry) => entry.isDirectory()).map((entry) => entry.name).sort();
}

/** The files below a folder whose names end in one way, by their paths in the project. */
export function filesBelow(folder, ending) {
	return readdirSync(path.join(root, folder), { withFileTypes: true }).flatMap((entry) => {
		const child = `${folder}/${entry.name}`;
		return entry.isDirectory() ? filesBelow(child, ending) : entry.name.endsWith(ending) ? [child] : [];
	});
}

/** The ActionScript files below a folder, by their paths in the project. */
export function sourcesBelow(folder) {
	return filesBelow(folder, '.as');
}

/** The name that a file defines, with its package: src/starlogo/agents/Agent.as is starlogo.agents.Agent. */
export function definitionIn(file) {
	return file.split('/').slice(1).join('.').replace(/\.as$/, '');
}

/** The package of a qualified name; '' at the top. */
export function packageOf(name) {
	return name.split('.').slice(0, -1).join('.');
}

/** A source without comments, and with nothing in its strings. */
export function codeOf(text) {
	return text.replace(/\/\*[^]*?\*\/|\/\/.*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'/g, (match) => match[0] === '/' ? ' ' : '""');
}

/** The qualified names that a source imports. */
export function importsIn(text) {
	return [...codeOf(text).matchAll(/\bimport\s+([\w.*]+)\s*;/g)].map(([, name]) => name);
}

/**
 * What a source uses of some definitions: what it imports, what it names in full, and what it names of its own package.
 *
 * @param {string} name what the source defines
 * @param {string} text the source
 * @param {Iterable<string>} definitions qualified names
 * @returns {string[]} those of them that it uses
 */
export function usesIn(name, text, definitions) {
	const { full, bare } = namesIn(text);
	return [...definitions].filter((definition) => definition !== name && (packageOf(definition) === packageOf(name)
		? bare.has(definition.split('.').pop()) : full.has(definition)));
}

const namesOfTexts = new Map();

/** What a source names: with packages before it or parts after it, and word by word. A source is asked about often, and read once. */
function namesIn(text) {
	if (!namesOfTexts.has(text)) {
		const code = codeOf(text);
		const named = new Set(code.match(/[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*/g));
		const full = new Set([...named].flatMap((path) => path.split('.').map((part, i, parts) => parts.slice(0, i + 1).join('.'))));
		namesOfTexts.set(text, { full, bare: new Set(code.match(/[A-Za-z_]\w*/g)) });
	}
	return namesOfTexts.get(text);
}

/** The lists of folders and files in CONTRIBUTING.md's layout: 'src/starlogo' to ['steps', ..., 'GreatLand.as', ...]. */
export function layout() {
	const lists = new Map();
	const text = /^## What is where\n([^]*?)^## /m.exec(read('CONTRIBUTING.md'))[1];
	let list = [];
	for (const [, indent, name] of text.matchAll(/^ {4}( *)(\S+)/gm)) {
		if (indent === '') {
			list = [];
			lists.set(name.replace(/\/$/, ''), list);
		} else if (indent.length === 2) {
			list.push(name.replace(/\/$/, ''));
		}
	}
	return lists;
}
