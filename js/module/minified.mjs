/** Makes the text of the module for users short. */
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { transformSync } from "esbuild";
import { ByteArray } from "../standins/module/ByteArray.mjs";
import { ONLY_IN_JAVASCRIPT } from "./differences.mjs";
import { standinsForUsers } from "./assemble.mjs";
import { ROOT } from "./names.mjs";

const DIGITS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";

/**
 * The settings of esbuild that give short names to the members that only the engine's classes read.
 *
 * @param {import("./translation/translate.mjs").Program} program the translated engine, whose text() was called
 * @param productionText the module's text for users
 */
export function manglingOf(program, productionText) {
	const names = namesToMangle(program, productionText);
	// $stateOf shows no names with a _, and a game's own class that extends one of these hardly has one with _$
	const mangleCache = Object.fromEntries(byUse(productionText, names.filter((name) => program.isInPublicClass(name))).map((name, i) => [name, `_$${shortName(i)}`]));
	return { mangleCache, mangleProps: new RegExp(`^(?:${names.map((name) => name.replaceAll("$", "\\$")).join("|")})$`) };
}

/** The members that may get short names: those that only the engine's classes read, by names that stand nowhere else. */
function namesToMangle(program, productionText) {
	const platform = [Array, Error, Function, Map, Math, Number, Object, RegExp, Set, String, Uint8Array].flatMap((type) => [type, type.prototype ?? type]);
	const bytes = Object.getOwnPropertyNames(ByteArray.prototype);
	const declared = readFileSync(join(ROOT, "js/module/types/byhand.d.ts"), "utf8").match(/\w+/g);
	const outside = memberNamesIn([...["three", "nova"].flatMap(adapterTexts), readFileSync(join(ROOT, "js/module/cook.mjs"), "utf8")]);
	// the stand-ins are renamed too; these names of theirs are members of the engine's classes alone
	const isOwn = (name) => /^[_$]/.test(name) || bytes.includes(name);
	const standIns = memberNamesIn([standinsForUsers(), ...Object.values(ONLY_IN_JAVASCRIPT).map((added) => added.text)]).filter((name) => !isOwn(name));
	const quoted = [...productionText.matchAll(/"([\w$]+)"/g)].map((match) => match[1]);
	const kept = new Set([...outside, ...standIns, ...quoted, ...declared, ...platform.flatMap((each) => Object.getOwnPropertyNames(each))]);
	return [...program.hiddenNames, ...bytes].filter((name) => !kept.has(name)).sort();
}

function memberNamesIn(texts) {
	return [...texts.join("\n").replaceAll(/\/\*[\s\S]*?\*\/|\/\/.*/g, "").matchAll(/[.{,]\s*([\w$]+)/g)].map((match) => match[1]);
}

function adapterTexts(folder) {
	const path = join(ROOT, "js/adapters", folder);
	return readdirSync(path).filter((file) => file.endsWith(".js")).map((file) => readFileSync(join(path, file), "utf8"));
}

/**
 * The text for bundlers and for pages, with short names for members. esbuild leaves out marks of calls without effects together with
 * white space, so they are names meanwhile. It would also drop them with the rest of the syntax, which bundlers make shorter anyway.
 * keepNames would define the name of each class and so make a dictionary of it: see #classText in translate.mjs.
 *
 * @param source the file that the map leads to
 */
export function minified(code, mangling, source) {
	// as long as the mark, so that the columns of the map are right
	const name = "__PURE_MARK__";
	const { code: written, map } = transformSync(code.replaceAll("/* @__PURE__ */", `${name}&&`), {
		minifyWhitespace: true, minifyIdentifiers: true, ...mangling, format: "esm", target: "es2022",
		sourcemap: "external", sourcesContent: false, sourcefile: source,
	});
	return { code: written.replaceAll(`${name}&&`, "/* @__PURE__ */"), map };
}

/** Names in the order of how often a text has them, the most frequent first. */
function byUse(code, names) {
	const uses = new Map(names.map((name) => [name, 0]));
	for (const [word] of code.matchAll(/[\w$]+/g)) if (uses.has(word)) uses.set(word, uses.get(word) + 1);
	return [...names].sort((a, b) => uses.get(b) - uses.get(a));
}

/** A number, written in letters and digits. */
function shortName(number) {
	const rest = Math.floor(number / DIGITS.length);
	return (rest > 0 ? shortName(rest) : "") + DIGITS[number % DIGITS.length];
}
