/**
 * Reads the declarations in ActionScript files, with their documentation. The sources are formatted, so the indentation gives the nesting.
 */
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const DOC = String.raw`(/\*\*(?:(?!\*/)[\s\S])*\*/\s*)?`;
const SIGNATURE = String.raw`(\([\s\S]*?\))`;
const BASES = String.raw`(?: extends ([\w, ]+?))?(?:\s+implements ([\w, ]+?))?`;
const TYPE = new RegExp(String.raw`^    ${DOC}((?:public|internal|final|dynamic|static)\s+)*(class|interface|function) (\w+)(?:${SIGNATURE}:([\w.<>*]+))?${BASES}\s*$`, "m");
const MODIFIERS = String.raw`((?:(?:override|public|protected|private|internal|engine|static|final|native)\s+)*)`;
const MEMBER = new RegExp(String.raw`^        ${DOC}${MODIFIERS}(function|var|const) (?:(get|set) )?(\w+)${SIGNATURE}?(?::([\w.<>*]+))?(?: = ([^;\n]+);)?`, "gm");

/** Classes of settings, which a literal stands for. Their constructors take one too. */
export const TAKES_LITERAL = new Set(["starlogo.queries.AgentFilter", "starlogo.queries.WalkOptions"]);

/** The qualified name of what a file declares; the file's path begins at the sources' folder. */
export const qnameOf = (file) => file.replace(/\.\w+$/, "").replaceAll(/[\\/]/g, ".");

/** Every type and package function in the folders. A file in an earlier folder replaces one of the same name in a later folder. */
export function readSignatures(folders) {
	const found = new Map();
	for (const folder of folders) {
		for (const file of readdirSync(folder, { recursive: true }).sort()) {
			const qname = qnameOf(file);
			if (!file.endsWith(".as") || found.has(qname)) continue;
			const type = readType(readFileSync(join(folder, file), "utf8"), qname);
			if (type) found.set(qname, type);
		}
	}
	return found;
}

function readType(source, qname) {
	// skips the lines between the package and the type: imports, and metadata of events
	const match = TYPE.exec(source.replace(/^    \/\*\*(?:(?!\*\/)[\s\S])*\*\/\s*\[.*\]$/gm, (text) => text.replace(/[^\n]/g, "")));
	if (!match || !/^    (?:[\w ]*\b)?public\b/m.test(match[0])) return null;
	const [, doc = "", , kind, name, signature, result, bases = "", interfaces = ""] = match;
	const list = (text) => text.split(",").map((word) => word.trim()).filter((word) => word !== "");
	const events = [...source.matchAll(/^    \[Event\(name="(\w+)", type="[\w.]*?(\w+)"\)\]$/gm)].map(([, event, eventType]) => ({ event, eventType }));
	const type = { qname, name, kind, events, doc: textOf(doc), isPrivate: /@private/.test(doc), bases: list(bases), interfaces: list(interfaces), members: [] };
	if (kind === "function") return { ...type, parameters: parametersOf(signature), result };
	for (const found of source.slice(match.index + match[0].length).matchAll(MEMBER)) type.members.push(memberOf(found, type));
	return type;
}

/** A parameter that only the engine's own classes pass, as its documentation says. It comes last. */
const INNER = /@param (\w+) for the engine alone: (?:(?!\n\s*\* @|\n\s*\*\/)[\s\S])*(?:\n\s*\* (?=@))?/;

function memberOf([, given = "", modifiers, keyword, accessor, name, parameters, result = "*", initial = null], type) {
	const words = modifiers.trim().split(/\s+/);
	const doc = given.replace(INNER, "");
	const innerName = INNER.exec(given)?.[1];
	const all = parameters ? parametersOf(parameters) : [];
	return {
		name,
		doc: textOf(doc),
		isPrivate: /@private/.test(doc),
		isPublic: words.includes("public") || type.kind === "interface",
		isProtected: words.includes("protected"),
		isStatic: words.includes("static"),
		isOverride: words.includes("override"),
		kind: keyword !== "function" ? keyword : accessor ?? (name === type.name ? "constructor" : "method"),
		parameters: all.filter((each) => each.name !== innerName),
		inner: all.find((each) => each.name === innerName) ?? null,
		result,
		initial,
	};
}

function parametersOf(text) {
	return [...text.matchAll(/(\.\.\.)?(\w+)(?::([\w.<>*]+))?(?:\s*=\s*([^,)]+))?/g)]
		.map(([, rest, name, type = "*", value]) => ({ name, type: rest ? "Array" : type, isRest: Boolean(rest), value: value?.trim() ?? null }));
}

/** A comment's text without its asterisks. */
function textOf(comment) {
	return comment.trim().replace(/^\/\*\*/, "").replace(/\*\/$/, "").split("\n").map((line) => line.replace(/^\s*\* ?/, "").trimEnd()).join("\n").trim();
}

/**
 * A member's documentation. An override without its own has its base's, and a copy has that of the other member.
 *
 * @param types the known declarations, by name
 */
export function docOf(type, member, types) {
	const [, owner, copied] = /@copy (\w*)#(\w+)/.exec(member.doc) ?? [];
	if (copied) return (owner ? types.get(owner) : type)?.members.find((other) => other.name === copied)?.doc ?? "";
	if (!/@inheritDoc/.test(member.doc)) return member.doc;
	for (const base of [...type.bases, ...type.interfaces].map((name) => types.get(name))) {
		const found = base?.members.find((other) => other.name === member.name && other.kind === member.kind);
		if (found) return member.doc.replace("@inheritDoc", docOf(base, found, types));
	}
	throw new Error(`${type.name}.${member.name} inherits no documentation`);
}

/** What a documentation says of a parameter; "" if nothing. */
export function docOfParameter(name, doc) {
	return new RegExp(String.raw`@param ${name}\s+((?:(?!\n@)[\s\S])*)`).exec(doc)?.[1] ?? "";
}

/** Whether a list of names may have null among them: the documentation says "null for" what has no name. */
export function mayHaveNull(docs) {
	return /\bnull for (?:an?|one)\b/.test(docs);
}

/** Whether a parameter takes a point or a vector that a member finds, as the documentation of the parameter says. */
export function isWritten(docs) {
	return /^(?:takes|receives)\b/.test(docs);
}

/** The Booleans that a method of the engine ends with, if they may be left out. A literal with their names may stand in the place of the first. */
export function endingBooleans(type, member) {
	if (member?.kind !== "method" || type.qname.startsWith("flash.")) return [];
	const { parameters } = member;
	return parameters.slice(parameters.findLastIndex(({ type, value }) => type !== "Boolean" || value === null) + 1);
}

/** Whether users of a class, or classes that extend it, see a member. */
export function isVisible(member) {
	return (member.isPublic || member.isProtected) && !member.isPrivate;
}
