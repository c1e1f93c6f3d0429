/**
 * What other classes can see of an ActionScript source: its text without comments, bodies of functions and private members. As long as this
 * stays as it is, the JavaScript of other classes does too.
 */

const WORD = /[\w$]/;

/** Before a "/" that begins a regular expression. After anything else it divides. */
const BEFORE_EXPRESSION = /(?:^|[(,=:[!&|?{};+\-*%~^<>]|\b(?:return|case|in|typeof|new|else))$/;

/**
 * @param {string} source the text of a file
 * @returns {string | null} the outline; null if the source is not understood
 */
export function outlineOf(source) {
	const tokens = tokensOf(source);
	if (tokens === null) return null;
	const kept = [];
	const imports = [];
	let functions = 0;
	let at = 0;
	// what stands between two braces of packages and classes, or before the first
	let member = [];
	const open = []; // the braces of packages and classes
	while (at < tokens.length) {
		const token = tokens[at];
		if (token === "}") {
			kept.push(...member.splice(0), "}");
			if (open.pop() === undefined) return null;
			at++;
		} else if (token === "{") {
			if (member.includes("function") && !isValue(member)) {
				functions++;
				at = endOfBlock(tokens, at);
				keep(";");
			} else if (isValue(member)) {
				const end = endOfBlock(tokens, at);
				member.push(...tokens.slice(at, end));
				at = end;
			} else {
				kept.push(...member.splice(0), "{");
				open.push(token);
				at++;
			}
		} else if (token === ";") {
			if (member.includes("function") && !isValue(member)) functions++;
			keep(";");
			at++;
		} else {
			member.push(token);
			at++;
		}
		if (at < 0) return null;
	}
	if (open.length > 0) return null;
	kept.push(...member);
	// a second count, by another way: formatted sources have members of a class at eight spaces, functions of a package at four, and a
	// file's own at none
	const counted = source.match(/^(?: {4}| {8}|)(?:\w+ )*function \w/gm)?.length ?? 0;
	if (counted !== functions) return null;
	// an import counts if the outline has its name
	const names = new Set(kept);
	return [...imports.filter((name) => /\*$/.test(name) || names.has(name.split(".").pop())).sort(), kept.join(" ")].join("\n");

	function keep(end) {
		if (member[0] === "import") imports.push(member.slice(1).join(""));
		else if (!member.includes("private")) kept.push(...member, end);
		member = [];
	}
}

/** Whether a declaration goes on with the value of a field. */
function isValue(member) {
	const isOpen = (words) => words.reduce((depth, word) => depth + (word === "(" ? 1 : word === ")" ? -1 : 0), 0);
	return member.some((word, i) => word === "=" && isOpen(member.slice(0, i)) === 0);
}

/** The place after the brace that ends a block; -1 if none does. */
function endOfBlock(tokens, start) {
	let depth = 0;
	for (let at = start; at < tokens.length; at++) {
		if (tokens[at] === "{") depth++;
		else if (tokens[at] === "}" && --depth === 0) return at + 1;
	}
	return -1;
}

/** The words, literals and signs of a source, without comments; null if a string or a comment has no end. */
function tokensOf(source) {
	const tokens = [];
	let at = 0;
	while (at < source.length) {
		const character = source[at];
		const two = source.slice(at, at + 2);
		if (/\s/.test(character)) {
			at++;
			continue;
		}
		let end = at + 1;
		if (two === "//") {
			end = source.indexOf("\n", at);
			at = end < 0 ? source.length : end;
			continue;
		}
		if (two === "/*") {
			end = source.indexOf("*/", at + 2);
			if (end < 0) return null;
			at = end + 2;
			continue;
		}
		if (character === '"' || character === "'") end = endOfLiteral(source, at, character);
		else if (character === "/" && BEFORE_EXPRESSION.test(tokens.slice(-1).join(""))) end = endOfLiteral(source, at, "/");
		else if (WORD.test(character)) while (end < source.length && WORD.test(source[end])) end++;
		if (end < 0) return null;
		tokens.push(source.slice(at, end));
		at = end;
	}
	return tokens;
}

/** The place after a string or a regular expression; -1 if its line ends before it does. */
function endOfLiteral(source, start, sign) {
	let isInBrackets = false;
	for (let at = start + 1; at < source.length && source[at] !== "\n"; at++) {
		if (source[at] === "\\") at++;
		else if (sign === "/" && source[at] === "[") isInBrackets = true;
		else if (sign === "/" && source[at] === "]") isInBrackets = false;
		else if (source[at] === sign && !isInBrackets) return at + 1;
	}
	return -1;
}
