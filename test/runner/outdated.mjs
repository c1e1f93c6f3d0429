/** The sources of the tests that Node runs: which classes of an earlier translation are still right. */
import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { join, relative } from "node:path";
import { ROOT, SOURCES } from "../../js/module/names.mjs";
import { outlineOf } from "./outline.mjs";
import { qnameOf } from "../../js/module/signatures.mjs";

/** What the compiler is called with, its version and that of the Flex SDK, and what names the classes. */
const SETTINGS = [
	"build/module.xml",
	"build/ivy.xml",
	"package-lock.json",
	"js/module/roots.mjs",
	"js/module/names.mjs",
	"test/runner/roots.mjs",
	"test/runner/outdated.mjs",
	"test/runner/outline.mjs",
];

const hashOf = (text) => createHash("sha1").update(text).digest("hex");

/**
 * The sources as they are now.
 *
 * @returns {{ settings: string, files: Object<string, { file: string, hash: string, outline: string }>, included: Object<string,
 *     string> }} the sources by qualified name, with hashes of their texts and outlines (a source that is not understood is its own
 *     outline), and hashes of the texts that sources include. Paths are in the project's folder
 */
export function readSources() {
	const files = {};
	const included = {};
	for (const folder of [...SOURCES, join(ROOT, "test")]) {
		for (const name of readdirSync(folder, { recursive: true })) {
			const file = join(folder, name);
			const qname = qnameOf(name);
			const place = relative(ROOT, file);
			if (name.endsWith(".inc")) included[place] = hashOf(readFileSync(file, "utf8"));
			if (!name.endsWith(".as") || qname in files) continue;
			const text = readFileSync(file, "utf8");
			files[qname] = { file: place, hash: hashOf(text), outline: hashOf(outlineOf(text) ?? text) };
		}
	}
	const settings = SETTINGS.map((file) => readFileSync(join(ROOT, file), "utf8")).join();
	return { settings: hashOf(settings + process.env.FLEX_HOME), files, included };
}

/** The classes whose sources are not there any more, or have other names. */
export function gone(before, now) {
	return Object.keys(before.files).filter((qname) => !(qname in now.files));
}

/**
 * The classes whose JavaScript may differ from an earlier translation's.
 *
 * @param before what readSources() was then
 * @param now what it is now
 * @param isTranslated whether the translation has a class
 * @param roots the classes that it has to have now
 * @param read the text of a file
 * @returns {string[] | null} their qualified names; null if it may be any
 */
export function outdated(before, now, isTranslated, roots, read = (file) => readFileSync(join(ROOT, file), "utf8")) {
	if (before.settings !== now.settings) return null;
	const words = new Map();
	const wordsOf = (qname) => words.get(qname) ?? words.set(qname, new Set(read(now.files[qname].file).match(/\w+/g))).get(qname);
	const names = Object.keys(now.files);
	const isOther = (qname, what) => before.files[qname]?.[what] !== now.files[qname][what];
	const changedTexts = Object.keys({ ...before.included, ...now.included }).filter((file) => before.included[file] !== now.included[file]);
	const texts = changedTexts.map((file) => file.split(/[\\/]/).pop());
	const changed = new Set(names.filter((qname) => isOther(qname, "hash") || isOther(qname, "file")));
	if (texts.length > 0) for (const qname of names.filter((each) => includes(read(now.files[each].file)))) changed.add(qname);
	// what uses a source names it. A word that is another's name too counts
	const users = (used) => {
		const own = used.map((qname) => qname.split(".").pop());
		return names.filter((qname) => own.some((name) => wordsOf(qname).has(name)));
	};
	const isNew = (qname) => !(qname in before.files);
	let open = [...changed].filter((qname) => !isNew(qname) && (isOther(qname, "outline") || isOther(qname, "file")));
	// if others can see in a class that it uses a new one, or no longer one that is gone, it looks different itself
	for (const qname of users([...names.filter(isNew), ...gone(before, now)])) changed.add(qname);
	for (const found = new Set(open); open.length > 0; ) {
		open = users(open).filter((qname) => !found.has(qname));
		for (const qname of open) changed.add(qname) && found.add(qname);
	}
	return [...changed].filter((qname) => isTranslated(qname) || roots.has(qname));

	/** Whether a text includes one that changed, directly or by others. */
	function includes(text) {
		return [...text.matchAll(/\binclude\s+["'](?:[^"']*\/)?([^"'/]*)["']/g)].some(([, name]) => texts.includes(name)
			|| Object.keys(now.included).some((file) => file.split(/[\\/]/).pop() === name && includes(read(file))));
	}
}
