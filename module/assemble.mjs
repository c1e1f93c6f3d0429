/** Puts a program together: the stand-ins, the parsers from npm that they use, and the translated classes, in one scope. */
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { buildSync } from "esbuild";
import { EXTERNALS } from "./names.mjs";
import { Program } from "./translate.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const standins = join(here, "../standins/module");
const FILES = ["language.mjs", "ByteArray.mjs", "xml.mjs", "machine.mjs"];

/** What the compiler wrote into a folder. */
export function translate(folder, signatures, externals = {}) {
	const files = readdirSync(folder, { recursive: true })
		.filter((file) => file.endsWith(".js") && !/^(library|org|ModuleRoots)\b/.test(file))
		.sort()
		.map((file) => ({ file, source: readFileSync(join(folder, file), "utf8") }));
	const own = Object.fromEntries(Object.entries(EXTERNALS).map(([qname, [, name]]) => [qname, name]));
	return new Program(files, { ...own, ...externals }, signatures);
}

/** The text of the stand-ins and of what they take from npm. */
export function standinsText() {
	const imports = new Map();
	const texts = FILES.map((file) => readFileSync(join(standins, file), "utf8").replaceAll(/^import \{ (.*) \} from "([\w./-]+)";\n/gm, (_, names, from) => {
		imports.set(from, [...(imports.get(from) ?? []), ...names.split(", ")]);
		return "";
	}).replaceAll(/^export /gm, ""));
	return `${bundled(imports)}\n${texts.join("\n")}`;
}

/** What is imported from npm, in a scope of its own. */
function bundled(imports) {
	const contents = [...imports].map(([from, names]) => `export { ${names.join(", ")} } from "${from}";`).join("\n");
	const result = buildSync({ stdin: { contents, resolveDir: here }, bundle: true, write: false, format: "iife", globalName: "npm", target: "es2022", legalComments: "none" });
	return `${result.outputFiles[0].text}const { ${[...imports.values()].flat().join(", ")} } = npm;\n`;
}

/** Sets the stand-ins' machine up; nothing of it is looked at before it is needed. */
export const SETUP = `Machine.now = now;
Machine.uncaught = uncaught;
Machine.frameListeners = new FrameListeners(() => new Event(Event.ENTER_FRAME));
`;
