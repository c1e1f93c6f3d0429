#!/usr/bin/env node
/**
 * Bundles the playground into static files.
 *
 *   node playground/build.mjs MODULE OUT      MODULE is the npm package of the engine (bin/module)
 */
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { models } from "../assets/generator/models/index.mjs";
import { palette } from "../assets/generator/palette.mjs";
import { flatten } from "../assets/generator/scene.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const [engine, out] = process.argv.slice(2).map((folder) => path.resolve(folder));
const npm = path.join(here, "node_modules");
const { exports } = JSON.parse(readFileSync(path.join(engine, "package.json"), "utf8"));

const STYLE = 'style:"display: none;"';
const WARNING = /[\w$]+\("Blockly\.Workspace\.getAllVariables","v12","v13","[^"]+"\);/;

/**
 * Blockly sets one style as an attribute, which the page's policy forbids: as an attribute of SVG it does the same. And it warns on
 * the console of a method of its own that it still calls.
 */
const tameBlockly = {
	name: "tame-blockly",
	setup({ onLoad, onResolve, resolve }) {
		// its keyboard plugin asks for all of it
		onResolve({ filter: /^blockly$/ }, ({ kind, resolveDir }) => resolve("blockly/core", { kind, resolveDir }));
		onLoad({ filter: /blockly_compressed\.js$/ }, ({ path: file }) => {
			const text = readFileSync(file, "utf8");
			if (!text.includes(STYLE) || !WARNING.test(text)) throw new Error(`${file} is not as it was: look whether it needs taming`);
			return { contents: text.replaceAll(STYLE, 'display:"none"').replace(WARNING, ""), loader: "js" };
		});
	},
};

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const result = await build({
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
	// the readable one: bundlers leave out what is not used of it
	alias: { "blockly/msg/en": path.join(npm, "blockly/msg/en.js"), "starlogo-collision": path.join(engine, exports["./readable"].default), "starlogo-collision/three": path.join(engine, exports["./three"].default) },
	nodePaths: [npm],
	plugins: [tameBlockly],
	logLevel: "warning",
});
for (const file of ["index.html", "style.css", "icon.svg"]) cpSync(path.join(here, file), path.join(out, file));
cpSync(path.join(npm, "blockly/media"), path.join(out, "media"), { recursive: true, filter: (file) => !/\.(mp3|ogg|wav)$/.test(file) });
cpSync(path.join(here, "../assets"), path.join(out, "models"), { recursive: true, filter: (file) => !file.includes("generat") && !file.endsWith("README.md") });
writeFileSync(path.join(out, "models/colours.json"), JSON.stringify(Object.fromEntries(models.map((model) => [model.name, coloursOf(model)]))));
writeFileSync(path.join(out, "LICENSES.txt"), licences());

for (const [view, entry] of Object.entries({ play: "play/view.js", inspect: "inspect/view.js", compare: "compare/view.js" })) {
	const files = neededFor(entry);
	console.log(`${view}: ${kilobytes(files, (bytes) => bytes.length)} KB of script, ${kilobytes(files, (bytes) => gzipSync(bytes).length)} KB compressed`);
}
console.log(`written: ${path.relative(process.cwd(), out)}`);

/** The script files that a view loads. */
function neededFor(entry) {
	const { outputs } = result.metafile;
	const files = new Set();
	const add = (file) => {
		if (files.has(file)) return;
		files.add(file);
		for (const { path: other, kind } of outputs[file].imports) if (kind === "import-statement") add(other);
	};
	for (const [file, { entryPoint }] of Object.entries(outputs)) if (entryPoint?.endsWith("playground/main.js") || entryPoint?.endsWith(`playground/${entry}`)) add(file);
	return [...files];
}

function kilobytes(files, size) {
	return Math.round(files.reduce((sum, file) => sum + size(readFileSync(file)), 0) / 1024);
}

/** The colours of a model's triangles, in the order that the engine has them in: how many of one, and that. */
function coloursOf({ build: make, format }) {
	const parts = flatten(make());
	const runs = (isOf) => parts.map(({ colour, mesh }) => [mesh.faces.filter(isOf).reduce((sum, face) => sum + face.length - 2, 0), palette[colour]]).filter(([count]) => count > 0);
	// polygons of OBJ files come after all triangles
	return format === "COLLADA" ? runs(() => true) : [...runs(({ length }) => length === 3), ...runs(({ length }) => length > 3)];
}

/** The licences of what is bundled in: of the packages that the bundle has files of, beside the engine. */
function licences() {
	const files = Object.keys(result.metafile.inputs);
	const names = new Set(files.flatMap((file) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(file)?.[1] ?? []));
	const parts = [...names].sort().map((name) => {
		const folder = path.join(npm, name);
		const { version, license } = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
		// Blockly's package brings none
		const file = [path.join(folder, "LICENSE"), path.join(here, "licences", `${name}.txt`)].find(existsSync);
		return `${name} ${version} (${license})\n\n${readFileSync(file, "utf8").trim()}\n`;
	});
	return [readFileSync(path.join(here, "../LICENSE"), "utf8"), readFileSync(path.join(engine, "LICENSES.md"), "utf8"), ...parts].join("\n----\n\n");
}
