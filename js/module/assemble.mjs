/** Joins the stand-ins and the translated classes to one program in one scope. */
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { EXTERNALS } from "./names.mjs";
import { Program } from "./translate.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const standins = join(here, "../standins/module");
const FILES = ["language.mjs", "ByteArray.mjs", "machine.mjs", "contacts.mjs"];

/** Translates the compiler's output in a folder. */
export function translate(folder, signatures, externals = {}, hasAllStatics = false) {
	const files = readdirSync(folder, { recursive: true })
		.filter((file) => file.endsWith(".js") && !/^(library|org|ModuleRoots)\b/.test(file))
		.sort()
		.map((file) => ({ file, source: readFileSync(join(folder, file), "utf8") }));
	const own = Object.fromEntries(Object.entries(EXTERNALS).map(([qname, [, name]]) => [qname, name]));
	return new Program(files, { ...own, ...externals }, signatures, hasAllStatics);
}

/** The text of the stand-ins. */
export function standinsText() {
	return FILES.map((file) => readFileSync(join(standins, file), "utf8").replaceAll(/^export /gm, "")).join("\n");
}
