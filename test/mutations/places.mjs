/** The places of the translation that the mutations change. */

/** What is written in place of what: the first that a place has. */
const CHANGES = [
	[/ <= /g, " < "], [/ >= /g, " > "], [/ < /g, " <= "], [/ > /g, " >= "], [/ \+ /g, " - "], [/ - /g, " + "], [/ \* /g, " / "],
	[/ \+= /g, " -= "], [/ -= /g, " += "], [/ && /g, " || "], [/ \|\| /g, " && "], [/ === /g, " !== "], [/ !== /g, " === "], [/ == /g, " != "], [/ != /g, " == "],
	[/\bif \((?=.*\)\s*\{?$)/g, "if (!1 && "], [/\bif \((?=.*\)\s*\{?$)/g, "if (!0 || "], [/\btrue\b/g, "false"], [/\bfalse\b/g, "true"],
	[/\bMath\.max\b/g, "Math.min"], [/\bMath\.min\b/g, "Math.max"], [/(?<=[-+*(=,[] ?)\b0\b(?![.x])/g, "1"], [/(?<=[-+*(=,[] ?)\b1\b(?![.x]| \/ 0 \/\*)/g, "2"], [/\+\+(?=;)/g, "--"],
	[/^\s+(this\.)?[#\w.]+(\([^()]*\)| = [^;{]*);$/g, ";"],
	[/ [-+*] [\w.#$]+(?=[;,) ])/g, ""], [/ (&&|\|\|) !?[\w.#$]+(\([^()]*\))?( [<>=!]+ [\w.#$]+)?(?=[;,) ])/g, ""],
];

/** A field gets its first value: mostly another is written before it is read. */
const FIRST_VALUE = /^\s+this\.[#$\w]+ = (-?[\d.]+|null|false|true|""|\(0 \/ 0.*|-?Infinity|\w+\$[A-Z][A-Z_\d]*);$/;

/** The module's own checks of arguments, which are no lines of a source: test/module/input.test.mjs has their tests. */
const BORDER = /(?<![\w.])\$(?:an?[A-Z]|bytes|check|named|numbers|options|point|refuse|warn)\w*\(/;

/**
 * Every place in a class or function of the translation, and what may be written there.
 *
 * @param {string[]} lines the translation
 * @param {string} name
 * @returns {{ name: string, line: number, changed: string }[]} the index of each line, and its text with one change
 */
export function placesIn(lines, name) {
	// a class's static methods are functions behind it: Name$method
	const head = new RegExp(`^(const ${name} = .*)?(class|function) ${name}\\b`);
	return lines.flatMap((line, first) => (head.test(line) ? placesFrom(lines, first, name) : []));
}

/** The places between a head and its closing brace. */
function placesFrom(lines, first, name) {
	const places = [];
	let isConstructor = false;
	for (let i = first + 1; !/^\}/.test(lines[i]); i++) {
		const line = lines[i];
		isConstructor = /^\tconstructor\(/.test(line) || (isConstructor && !/^\t\}/.test(line));
		if (isConstructor && FIRST_VALUE.test(line)) continue;
		if (/^\s*(\/\/|\*|\/\*)|throw new|static #?\w+ =|requireType/.test(line) || BORDER.test(line)) continue;
		for (const [from, to] of CHANGES) for (const { index, 0: text } of line.matchAll(from)) places.push({ name, line: i, changed: line.slice(0, index) + to + line.slice(index + text.length) });
	}
	return places;
}
