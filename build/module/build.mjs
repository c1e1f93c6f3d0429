/** A first sketch: node build.mjs JS_DEBUG OUT */
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Program } from "./translate.mjs";

const [folder, out] = process.argv.slice(2);
const files = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith(".js") && !file.startsWith("library") && file.includes("/"))
	.map((file) => ({ file, source: readFileSync(join(folder, file), "utf8") }));
const standins = "/tmp/w-module/standins/module/";
const imports = {
	"language.mjs": ["vector", "resize", "values", "is", "as", "cast", "hasMembers", "bound", "string", "sort", "sortOn", "ArgumentError"],
	"ByteArray.mjs": ["ByteArray", "EOFError"],
	"machine.mjs": ["now", "uncaught", "FrameListeners", "fetchFile"],
	"xml.mjs": ["parseXml"],
};
const externals = { ArgumentError: "ArgumentError", "flash.utils.ByteArray": "ByteArray", "flash.errors.EOFError": "EOFError", "standin.Xml.parse": "parseXml", "standin.Network.fetch": "fetchFile" };
const program = new Program(files, externals);
const text = program.text();
const head = Object.entries(imports).map(([file, names]) => `import { ${names.join(", ")} } from ${JSON.stringify(standins + file)};`).join("\n");
writeFileSync(out, `${head}\n\n${text}\nMachine.now = now; Machine.uncaught = uncaught; Machine.frameListeners = new FrameListeners(() => new Event(Event.ENTER_FRAME));\nexport { ${program.names.map((q) => program.shortName(q)).join(", ")} };\n`);
console.log([...program.used].join(" "));
