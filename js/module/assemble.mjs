/** Puts a program together: the stand-ins, the parsers from npm that they use, and the translated classes, in one scope. */
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { buildSync } from "esbuild";
import { EXTERNALS } from "./names.mjs";
import { Program } from "./translate.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const standins = join(here, "../standins/module");
const FILES = ["language.mjs", "ByteArray.mjs", "machine.mjs", "contacts.mjs"];

/** What the compiler wrote into a folder. */
export function translate(folder, signatures, externals = {}, hasAllStatics = false) {
	const files = readdirSync(folder, { recursive: true })
		.filter((file) => file.endsWith(".js") && !/^(library|org|ModuleRoots)\b/.test(file))
		.sort()
		.map((file) => ({ file, source: readFileSync(join(folder, file), "utf8") }));
	const own = Object.fromEntries(Object.entries(EXTERNALS).map(([qname, [, name]]) => [qname, name]));
	return new Program(files, { ...own, ...externals }, signatures, hasAllStatics);
}

/** The text of the stand-ins and of what they take from npm. */
export function standinsText() {
	const packages = new Map();
	const texts = FILES.map((file) => {
		const text = readFileSync(join(standins, file), "utf8");
		const names = [];
		const rest = text.replaceAll(/^import \{ (.*) \} from "([\w./-]+)";\n/gm, (_, list, from) => {
			packages.set(from, [...(packages.get(from) ?? []), ...list.split(", ")]);
			names.push(...list.split(", ").map((name) => [name, `${scopeName(from)}.${name}`]));
			return "";
		}).replaceAll(/^export /gm, "");
		return names.reduce((result, [name, path]) => result.replaceAll(new RegExp(String.raw`\b${name}\b`, "g"), path), rest);
	});
	return `${[...packages].map(bundled).join("\n")}\n${texts.join("\n")}`;
}

/** What is imported from npm, in a scope of its own, which is left out of a bundle that does not need it. */
function bundled([from, names]) {
	const contents = `export { ${names.join(", ")} } from "${from}";`;
	const result = buildSync({ absWorkingDir: join(here, ".."), stdin: { contents, resolveDir: here }, bundle: true, write: false, format: "iife", globalName: "npm", target: "es2022", legalComments: "none" });
	const text = result.outputFiles[0].text.replace(/^"use strict";\n/, "").replace(/^var npm = /, "");
	return `const ${scopeName(from)} = /* @__PURE__ */ ${text}`;
}

function scopeName(from) {
	return `$${from.split("/")[0]}`;
}
