#!/usr/bin/env node
import { createHash } from "node:crypto";
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { basename, dirname, extname, isAbsolute, join, relative, resolve, sep } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { $hintOfOption } from "./spelling.mjs";
import { GreatLand, HullFitter, Model, ModelLoader } from "./starlogo-collision.min.js";

const HELP = `Reads models and computes what a game needs of them when the game is built, so that no player's machine has to: writes a cooked file for every
OBJ, DAE, GLB, GLTF and STL file of a folder and of those below it, and manifest.json, which a ModelLoader finds them by. What is
there already, of the same source and options, is left as it is.

  starlogo-cook FOLDER [options]

  --out FOLDER         copies the models there, with what they need beside them, and writes beside the copies; without it, beside the models.
                       In FOLDER itself, give it to each run: to one without it the copies are models
  --up x|y|z           the axis that points up in OBJ and STL files, as load() is given it (z)
  --scaling WORD       footprint, volume or "as given", as load() is given it (footprint)
  --transforms         for loaders with usesTransforms: a file bear.slb beside bear.obj turns it
  --increment DEGREES  orientedBoxDegIncrement of the game (10)
  --min-vertices N     minVerticesToSplit (5)
  --depth N            maxDepth (10)
  --by-mean            splitByMean
  --hulls N            loadHulls, with a HullFitter of N corners, 8 or more (no hulls)
  --force              cooks again what is there
  --help               prints this`;

const MODEL = /\.(obj|dae|glb|gltf|stl)$/i;
const SCALINGS = [Model.FOOTPRINT, Model.VOLUME, Model.AS_GIVEN];
const { version } = JSON.parse(readFileSync(new URL("package.json", import.meta.url), "utf8"));
const options = {
	out: { type: "string" },
	up: { type: "string", default: "z" },
	scaling: { type: "string", default: Model.FOOTPRINT },
	transforms: { type: "boolean", default: false },
	increment: { type: "string", default: "10" },
	"min-vertices": { type: "string", default: "5" },
	depth: { type: "string", default: "10" },
	"by-mean": { type: "boolean", default: false },
	hulls: { type: "string" },
	force: { type: "boolean", default: false },
	help: { type: "boolean", default: false },
};

const { values, folder } = readArguments();
const out = resolve(values.out ?? folder);
const manifestPath = join(out, "manifest.json");
const { up, scaling, transforms, increment, "min-vertices": minVertices, depth, "by-mean": byMean, hulls } = values;
const settings = JSON.stringify([version, up, scaling, transforms, increment, minVertices, depth, byMean, hulls]);
await cookAll();

/** Cooks the files of the folder, and writes the manifest. */
async function cookAll() {
	const files = readdirSync(folder, { recursive: true }).map(String).filter(isSource).sort();
	const lastModels = readManifest();
	const models = {};
	let failures = 0;
	let kept = 0;
	for (const file of files) {
		const name = file.split(sep).join("/");
		try {
			const start = performance.now();
			const path = join(out, `${file}.cooked`);
			const last = lastModels[name];
			if (!values.force && existsSync(path) && last && last.source === hashOf(last.files)) {
				copyAll(last.files);
				models[name] = last;
				kept++;
				continue;
			}
			// if this run is interrupted, the next one cooks the file again
			delete lastModels[name];
			writeManifest({ ...lastModels, ...models });
			const { model, files: parts } = await readModel(file);
			copyAll(parts);
			const bytes = newGreatLand().cook(model, values.up, values.transforms);
			writeFileSync(path, bytes);
			models[name] = { cooked: `${name}.cooked`, source: hashOf(parts), files: parts };
			const time = (performance.now() - start).toFixed(0);
			console.log(`${relative(out, path)}: ${bytes.length} bytes for ${(model.triangles?.length ?? 0) / 3} triangles, ${time} ms`);
		} catch (error) {
			failures++;
			console.error(`${file}: ${error.message}`);
		}
	}
	writeManifest(models);
	const counts = [`${files.length - failures - kept} cooked`, kept > 0 ? `${kept} as they were` : "", failures > 0 ? `${failures} that are no models` : ""];
	console.log(counts.filter((text) => text !== "").join(", "));
	process.exitCode = failures > 0 ? 1 : 0;
}

/** Whether a path in the folder is a model's file, and none of --out. Copies that are elsewhere in the folder are models as any others. */
function isSource(file) {
	const path = join(folder, file);
	const isCopy = isIn(folder, out) && out !== folder && isIn(out, path);
	// a link that leads nowhere counts, and fails when it is read
	return MODEL.test(file) && !isCopy && (statSync(path, { throwIfNoEntry: false })?.isFile() ?? true);
}

/** The options and the folder. Wrong arguments end the program with a message. */
function readArguments() {
	let read;
	try {
		read = parseArgs({ options, allowPositionals: true });
	} catch ({ code, message }) {
		const [, name] = /^[^']*'(?:-\w, )?-{1,2}([\w-]+)/.exec(message);
		if (code === "ERR_PARSE_ARGS_UNKNOWN_OPTION") fail(thereIsNo(name));
		fail(`--${name} ${options[name].type === "boolean" ? "takes no value" : "needs a value"}`);
	}
	const { values, positionals } = read;
	if (values.help) {
		console.log(HELP);
		process.exit(0);
	}
	if (positionals.length !== 1) fail(positionals.length === 0 ? "it needs a folder of models" : `one folder at a time, not ${positionals.join(" and ")}`);
	const folder = resolve(positionals[0]);
	if (!existsSync(folder) || !statSync(folder).isDirectory()) fail(`${positionals[0]} is no folder`);
	if (!["x", "y", "z"].includes(values.up)) fail(`--up is x, y or z, not ${values.up}`);
	if (!SCALINGS.includes(values.scaling)) fail(`--scaling is footprint, volume or "as given", not ${values.scaling}`);
	if (!(Number(values.increment) >= 0.01 && Number(values.increment) <= 360)) fail(`--increment is a number of degrees of at least 0.01, not ${values.increment}`);
	const isHulls = values.hulls === undefined || /^\d{1,3}$/.test(values.hulls) && Number(values.hulls) >= 8;
	if (!isHulls) fail(`--hulls is a whole number from 8 to 999, not ${values.hulls}`);
	for (const name of ["min-vertices", "depth"]) if (!/^[1-9]\d{0,5}$/.test(values[name])) fail(`--${name} is a whole number from 1 on, not ${values[name]}`);
	return { values, folder };
}

/** What is wrong with an option that there is not: the nearest one is, or all are. */
function thereIsNo(name) {
	const names = Object.keys(options);
	return `--${name} is no option; ${$hintOfOption(name, names)}there are ${names.map((each) => `--${each}`).join(", ")}`;
}

function fail(problem) {
	console.error(`starlogo-cook: ${problem}\nstarlogo-cook --help prints what it takes`);
	process.exit(2);
}

/** The models in the manifest of the last run, without damaged entries; none if there is no manifest. */
function readManifest() {
	const isWhole = ([, model]) => Array.isArray(model?.files) && model.files.every((file) => typeof file === "string");
	try {
		return Object.fromEntries(Object.entries(JSON.parse(readFileSync(manifestPath, "utf8")).models).filter(isWhole));
	} catch {
		return {};
	}
}

/** Writes the manifest: for each model its cooked file, the files that it was read from, and the hash of these and of the options. */
function writeManifest(models) {
	mkdirSync(out, { recursive: true });
	writeFileSync(manifestPath, `${JSON.stringify({ models }, null, "\t")}\n`);
}

/** The hash of the options and of some files of the folder. One that there is not counts as empty. */
function hashOf(files) {
	const hash = createHash("sha256").update(settings);
	for (const file of files) {
		const bytes = existsSync(join(folder, file)) ? readFileSync(join(folder, file)) : "";
		hash.update(`${bytes.length} `).update(bytes);
	}
	return hash.digest("hex");
}

/** Whether a path is a folder itself, or in it. The way from one drive of Windows to another is an absolute path. */
function isIn(whole, path) {
	const way = relative(whole, path);
	return way.split(sep)[0] !== ".." && !isAbsolute(way);
}

/** Copies files that are there, if there is a folder for copies. */
function copyAll(files) {
	for (const file of files.filter((each) => out !== folder && existsSync(join(folder, each)))) {
		mkdirSync(dirname(join(out, file)), { recursive: true });
		copyFileSync(join(folder, file), join(out, file));
	}
}

/** A GreatLand with the game's settings. */
function newGreatLand() {
	const greatLand = new GreatLand();
	greatLand.orientedBoxDegIncrement = Number(values.increment);
	greatLand.hierarchies.minVerticesToSplit = Number(values["min-vertices"]);
	greatLand.hierarchies.maxDepth = Number(values.depth);
	greatLand.hierarchies.splitByMean = values["by-mean"];
	greatLand.loadHulls = values.hulls !== undefined;
	if (greatLand.loadHulls) greatLand.boundingStructures.hullFitter = new HullFitter(Number(values.hulls));
	return greatLand;
}

/** Loads a model as a game does, but from the folder. Returns it, and the files that the loader has asked for. */
async function readModel(file) {
	const files = [];
	globalThis.fetch = async (url) => {
		const path = fileURLToPath(url);
		files.push(relative(folder, path));
		return new Response(readFileSync(path));
	};
	const receiver = new GreatLand();
	receiver.loadTightestFit = false;
	receiver.loadHierarchies = false;
	const loader = new ModelLoader(receiver, 1000);
	loader.usesTransforms = values.transforms;
	const model = await loader.loadAsync(basename(file, extname(file)), pathToFileURL(join(folder, file)).href, { upAxis: values.up, scaling: values.scaling });
	return { model, files };
}
