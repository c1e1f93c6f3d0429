/** Joins the stand-ins and the translated classes to one program in one scope. */
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { EXTERNALS } from "./names.mjs";
import { qnameOf } from "./signatures.mjs";
import { Program } from "./translation/translate.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const standins = join(here, "../standins/module");
const FILES = ["checks.mjs", "literals.mjs", "shown.mjs", "language.mjs", "ByteArray.mjs", "machine.mjs", "contacts.mjs"];
const SUBJECTS = ["warn", "spelling", "properties", "arguments", "angles", "frames", "shots", "handlers", "questions", "snapshots", "walks", "poses", "drawn"];
const WARNINGS = SUBJECTS.map((name) => `warnings/${name}.mjs`);

/**
 * Translates the compiler's output in a folder.
 *
 * @param roots the names of the classes to take, with all that they use; the folder may have others. If there are none, all
 */
export function translate(folder, signatures, { externals = {}, isForTests = false, roots = null } = {}) {
	const all = compiledFilesIn(folder).sort().map((file) => ({ file, source: readFileSync(join(folder, file), "utf8") }));
	const replaced = { ...EXTERNALS, ...externals };
	const files = roots === null ? all : reachable(all, roots, replaced);
	return new Program(files, replaced, signatures, isForTests);
}

/** The files of classes in a compiler's output. */
export function compiledFilesIn(folder) {
	return readdirSync(folder, { recursive: true }).filter((file) => file.endsWith(".js") && !/^(library|org|ModuleRoots)\b|\bChangedIn_\w*\.js$/.test(file));
}

/** The text of the stand-ins, and of the warnings for developers. */
export function standinsText() {
	return `${textOf(FILES)}\n${textOf(WARNINGS)}`;
}

/** The same for the minified module: warnings do nothing, and hints say nothing. It has as many lines. */
export function standinsForUsers() {
	return `${textOf(FILES)}\n${textOf(WARNINGS).split("\n").map(withoutBody).join("\n")}`;
}

/** Some files as parts of one scope, without the comments at their heads. */
function textOf(files) {
	const HEAD = /^\/\*\*[^]*?\*\/\n(?=\n|import )/;
	const texts = files.map((file) => readFileSync(join(standins, file), "utf8").replace(HEAD, ""));
	return texts.map((text) => text.replaceAll(/^import .*\n/gm, "").replaceAll(/^export /gm, "")).join("\n");
}

/** What users get of a line of the warnings: an empty function, if one begins there that is called from outside. */
function withoutBody(line) {
	const [head, kind] = /^function \$(warn|refuse|hint)\w+\([\w, ]*\)/.exec(line) ?? [];
	return head === undefined ? "" : `${head} {${kind === "hint" ? ' return "";' : ""}}`;
}

/** The files of some classes, and of all that these use, as the compiler says in each. What comes from elsewhere uses nothing. */
function reachable(all, roots, externals) {
	const byName = new Map(all.map((each) => [qnameOf(each.file), each]));
	const found = new Set();
	const open = [...roots];
	while (open.length > 0) {
		const each = byName.get(open.pop());
		if (!each || found.has(each) || qnameOf(each.file) in externals) continue;
		found.add(each);
		for (const [, listed, required] of each.source.matchAll(/Dependency List: ([^*]*)\*\/|^goog\.require\('([^']*)'\)/gm)) {
			open.push(...(listed ?? required).trim().split(","));
		}
	}
	return all.filter((each) => found.has(each));
}
