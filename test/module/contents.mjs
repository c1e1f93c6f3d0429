#!/usr/bin/env node
/**
 * Lists what a bundle with some names of the package has in it, by source file, largest first: its share of the gzipped bundle in kilobytes.
 *
 *   node test/module/contents.mjs Agent Model LevelShapes SeenAgents AgentRays
 *
 * It reads bin/module. A class of src/starlogo is shown with its room; all else is a stand-in or help of the module.
 */
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const KB = 1024;
const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = path.join(root, "bin/module");
const { buildSync } = createRequire(path.join(root, "js/module/package.json"))("esbuild");
const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/** The numbers of a segment of a source map. */
function numbersOf(segment) {
	const numbers = [];
	let value = 0;
	let shift = 0;
	for (const letter of segment) {
		const digit = DIGITS.indexOf(letter);
		value |= (digit & 31) << shift;
		shift += 5;
		if (!(digit & 32)) {
			numbers.push(value & 1 ? -(value >> 1) : value >> 1);
			value = shift = 0;
		}
	}
	return numbers;
}

/** The class or function that each line of the readable file belongs to. */
function ownersOf(text) {
	let owner = "";
	return text.split("\n").map((line) => (owner = /^(?:class|function|const|let) ([\w$]+)/.exec(line)?.[1].replace(/^([A-Z]\w*)\$.*/, "$1") ?? owner));
}

const names = process.argv.slice(2);
const contents = `import { ${names.join(", ")} } from "./starlogo-collision.min.js";\nglobalThis.used = [${names.join(", ")}];\n`;
const options = { bundle: true, minify: true, format: "esm", target: "es2022", write: false, sourcemap: "external", outfile: "bundle.js" };
const [map, bundle] = buildSync({ stdin: { contents, resolveDir: folder }, ...options }).outputFiles.sort((a, b) => b.path.length - a.path.length).map(({ text }) => text);
const { sources, mappings } = JSON.parse(map);
const engine = sources.findIndex((source) => source.endsWith("starlogo-collision.js"));
const owners = ownersOf(readFileSync(path.join(folder, "starlogo-collision.js"), "utf8"));
const rooms = new Map(readdirSync(path.join(root, "src/starlogo"), { recursive: true }).filter((file) => file.endsWith(".as"))
	.map((file) => [path.basename(file, ".as"), path.dirname(file)]));

const sizes = new Map();
const lines = bundle.split("\n");
let [source, line] = [0, 0];
mappings.split(";").forEach((segments, i) => {
	let column = 0;
	const starts = segments.split(",").filter(Boolean).map((segment) => {
		const [step, sourceStep = 0, lineStep = 0] = numbersOf(segment);
		[column, source, line] = [column + step, source + sourceStep, line + lineStep];
		return [column, source === engine ? owners[line] : ""];
	});
	starts.forEach(([start, owner], k) => sizes.set(owner, (sizes.get(owner) ?? 0) + (starts[k + 1]?.[0] ?? lines[i].length) - start));
});

const total = gzipSync(bundle, { level: 9 }).length / KB;
const share = (size) => ((size * total) / bundle.length).toFixed(2).padStart(6);
const sum = (entries) => [...entries.reduce((sums, [name, size]) => sums.set(name, (sums.get(name) ?? 0) + size), new Map())].sort((a, b) => b[1] - a[1]);
const roomOf = (name) => rooms.get(name) ?? "module";
const rows = (entries) => sum(entries).map(([name, size]) => `${share(size)} ${name}`);
console.log([
	`${total.toFixed(1)} KB gzipped, ${(bundle.length / KB).toFixed(0)} KB minified. By room:`, ...rows([...sizes].map(([name, size]) => [roomOf(name).split("/")[0], size])),
	"", "By file:", ...rows([...sizes].map(([name, size]) => [rooms.has(name) ? `${roomOf(name)}/${name}` : name, size])),
].join("\n"));
