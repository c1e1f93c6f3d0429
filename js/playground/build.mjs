#!/usr/bin/env node
/**
 * Bundles the playground into static files, and into a single one.
 *
 * node js/playground/build.mjs MODULE OUT API     MODULE is the npm package of the engine (bin/module), API the pages of its API (bin/typedoc)
 */
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { build } from "esbuild";
import { models } from "../../assets/generator/models/index.mjs";
import { palette } from "../../assets/generator/palette.mjs";
import { flatten } from "../../assets/generator/scene.mjs";
import { writeDocs } from "./docs.mjs";
import { leanThree } from "./leanthree.mjs";
import { engineInParts } from "./parts.mjs";
import { writeSingle } from "./single.mjs";
import { NPM, fewMessages, tameBlockly, tameRapier } from "./packages.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const [engine, out, api] = process.argv.slice(2).map((folder) => path.resolve(folder));
const { exports } = JSON.parse(readFileSync(path.join(engine, "package.json"), "utf8"));
const engineFile = path.join(engine, exports["."].default);
const { ColladaModel, Model, ObjModel } = await import(pathToFileURL(engineFile));

/** The page's own scripts are in these folders. */
const USERS = [here, path.join(here, "../../examples/level"), path.join(engine, "three")];

const parts = engineInParts(path.join(engine, "../generated/module/short.js"), USERS, loadedWith);

/**
 * What a script is loaded with, where the engine is divided: its view, what its view loads later, files of the user, or "" for every view. The page
 * does not use all of the adapter and the example.
 */
function loadedWith(file) {
	if (/(three[/\\](binding|terrain)|level[/\\]page)\.js$/.test(file)) return null;
	if (/formats\.js$/.test(file)) return "files";
	if (/(lateengine|queries|questions)\.js$/.test(file)) return path.relative(here, file);
	if (/inspect[/\\]fits\.js$/.test(file)) return "inspect";
	if (/sight\.js$/.test(file)) return "compare";
	return /[/\\](play|compare|measure|level)[/\\](?:\w+[/\\])?\w+\.js$/.exec(file)?.[1] ?? "";
}

/** The settings of esbuild for the page, as it is served or as a single file. */
const settings = (isSingle) => ({
	entryPoints: [path.join(here, "main.js")],
	outdir: out,
	bundle: true,
	splitting: true,
	format: "esm",
	target: "es2022",
	minify: true,
	metafile: true,
	legalComments: "none",
	chunkNames: "parts/[name]-[hash]",
	define: isSingle ? {} : parts.define,
	alias: { "starlogo-collision": engineFile, ...Object.fromEntries(["en", "de"].map((code) => [`blockly/msg/${code}`, path.join(NPM, `blockly/msg/${code}.js`)])), "starlogo-collision/three": path.join(engine, exports["./three"].default) },
	nodePaths: [NPM],
	plugins: [tameBlockly(isSingle), ...(isSingle ? [] : [parts.plugin]), tameRapier, fewMessages, leanThree],
	logLevel: "warning",
});

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const result = await build(settings(false));
parts.check(Object.keys(result.metafile.outputs));
for (const file of ["open.js", "style.css", "icon.svg"]) cpSync(path.join(here, file), path.join(out, file));
cpSync(path.join(NPM, "blockly/media"), path.join(out, "media"), { recursive: true, filter: (file) => !/\.(mp3|ogg|wav)$/.test(file) });
mkdirSync(path.join(out, "models"));
for (const model of models) writeFileSync(path.join(out, "models", `${model.name}.json`), JSON.stringify(baked(model)));
cpSync(path.join(here, "../../examples/level/level.glb"), path.join(out, "models/level.glb"));
writeFileSync(path.join(out, "LICENSES.txt"), licences());
writeDocs(path.join(here, "../.."), path.join(out, "docs"));
cpSync(api, path.join(out, "docs/api"), { recursive: true });
await writeSingle(out, "starlogo-nova.html", settings(true));

/** The views' folders of words. */
const WORDS = { play: ["game"], inspect: ["lab"], compare: ["lab"], measure: ["lab"], level: ["lab"], teach: ["class", "game"] };
for (const [view, folders] of Object.entries(WORDS)) {
	const first = neededFor(`js/playground/${view}/view.js`, ...folders.map((folder) => `js/playground/languages/${folder}/en.js`));
	const editor = view === "play" ? neededFor("js/playground/play/blocks/editor.js").filter((file) => !first.includes(file)) : [];
	console.log(`${view}: ${sizes(first)}${editor.length > 0 ? `, and then for the blocks ${sizes(editor)}` : ""}`);
}
// last, because with this file the page counts as made
cpSync(path.join(here, "index.html"), path.join(out, "index.html"));
console.log(`written: ${path.relative(process.cwd(), out)}`);

/** The script files that some parts need before they run, including the page's first one and its words. */
function neededFor(...entries) {
	const { outputs } = result.metafile;
	const files = new Set();
	const add = (file) => {
		if (files.has(file)) return;
		files.add(file);
		for (const { path: other, kind } of outputs[file].imports) if (kind === "import-statement") add(other);
	};
	for (const [file, { entryPoint }] of Object.entries(outputs)) if ([...entries, "js/playground/main.js", "js/playground/languages/en.js"].some((each) => entryPoint?.endsWith(each))) add(file);
	return [...files];
}

function sizes(files) {
	const kilobytes = (size) => Math.round(files.reduce((sum, file) => sum + size(readFileSync(file)), 0) / 1024);
	return `${kilobytes((bytes) => bytes.length)} KB of script, ${kilobytes((bytes) => gzipSync(bytes).length)} KB compressed`;
}

/** A model in a short form of its file: coordinates in the file's unit with six decimals, triangles, colours. */
function baked(model) {
	const { name, format } = model;
	const [reader, ending] = format === "COLLADA" ? [ColladaModel, "dae"] : [ObjModel, "obj"];
	const { vertices, triangles, source: { unit, offset } } = reader.fromBytes(name, new Uint8Array(readFileSync(path.join(here, `../../assets/${name}.${ending}`))));
	const middle = [offset.x, offset.y, offset.z];
	const written = vertices.map((value, i) => Number((value * unit + middle[i % 3]).toFixed(6)));
	const again = new Model(name, written, triangles).vertices;
	if (vertices.some((value, i) => Math.abs(value - again[i]) > 1e-6)) throw new Error(`${name} needs more decimals`);
	return { vertices: written, triangles, colours: coloursOf(model) };
}

/** The colours of a model's triangles, in the engine's order: pairs of a count and a colour. */
function coloursOf({ build: make, format }) {
	const parts = flatten(make());
	const runs = (isOf) => parts.map(({ colour, mesh }) => [mesh.faces.filter(isOf).reduce((sum, face) => sum + face.length - 2, 0), palette[colour]]).filter(([count]) => count > 0);
	// polygons of OBJ files come after all triangles
	return format === "COLLADA" ? runs(() => true) : [...runs(({ length }) => length === 3), ...runs(({ length }) => length > 3)];
}

/** The licences of the bundled packages, except the engine's. */
function licences() {
	const files = Object.keys(result.metafile.inputs);
	const names = new Set(files.flatMap((file) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(file)?.[1] ?? []));
	const parts = [...names].sort().map((name) => {
		const folder = path.join(NPM, name);
		const { version, license } = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
		// Blockly's package has no licence file
		const file = [path.join(folder, "LICENSE"), path.join(here, "licences", `${name}.txt`)].find(existsSync);
		return `${name} ${version} (${license})\n\n${readFileSync(file, "utf8").trim()}\n`;
	});
	return [readFileSync(path.join(here, "../../LICENSE"), "utf8"), ...parts].join("\n----\n\n");
}
