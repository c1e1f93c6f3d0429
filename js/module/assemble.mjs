/** Joins the stand-ins and the translated classes to one program in one scope. */
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { EXTERNALS } from "./names.mjs";
import { qnameOf } from "./signatures.mjs";
import { Program } from "./translate.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const standins = join(here, "../standins/module");
const FILES = ["language.mjs", "ByteArray.mjs", "machine.mjs", "contacts.mjs", "warnings.mjs"];

/**
 * Translates the compiler's output in a folder.
 *
 * @param roots the names of the classes to take, with all that they use; the folder may have others. If there are none, all
 */
export function translate(folder, signatures, { externals = {}, hasAllStatics = false, roots = null } = {}) {
	const all = namesIn(folder).sort().map((file) => ({ file, source: readFileSync(join(folder, file), "utf8") }));
	const files = roots === null ? all : reachable(all, roots);
	return new Program(files, { ...EXTERNALS, ...externals }, signatures, hasAllStatics);
}

/** The files of classes in a compiler's output. */
export function namesIn(folder) {
	return readdirSync(folder, { recursive: true }).filter((file) => file.endsWith(".js") && !/^(library|org|ModuleRoots)\b|\bChangedIn_\w*\.js$/.test(file));
}

/** The text of the stand-ins. */
export function standinsText() {
	return FILES.map((file) => readFileSync(join(standins, file), "utf8").replaceAll(/^import .*\n/gm, "").replaceAll(/^export /gm, "")).join("\n");
}

/** The files of some classes, and of all that these use, as the compiler says in each. */
function reachable(all, roots) {
	const byName = new Map(all.map((each) => [qnameOf(each.file), each]));
	const found = new Set();
	const open = [...roots];
	while (open.length > 0) {
		const each = byName.get(open.pop());
		if (!each || found.has(each)) continue;
		found.add(each);
		for (const [, listed, required] of each.source.matchAll(/Dependency List: ([^*]*)\*\/|^goog\.require\('([^']*)'\)/gm)) open.push(...(listed ?? required).trim().split(","));
	}
	return all.filter((each) => found.has(each));
}
