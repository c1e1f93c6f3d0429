#!/usr/bin/env node
/**
 * Computes what a game needs of its models when the game is built, so that no player's machine has to: writes a .fits file for every
 * OBJ, DAE, ZAE, GLB and STL file of a folder and of those below it. Put them beside the models: a ModelLoader finds them there.
 *
 *   starlogo-bake FOLDER [--out FOLDER] [--up x|y|z] [--increment DEGREES] [--min-vertices N] [--depth N] [--by-mean]
 *
 * --out puts copies of the models and their .fits files elsewhere; --up is the axis that points up in OBJ files. The rest are the settings
 * that the game loads its models with: orientedBoxDegIncrement, minVerticesToSplit, maxDepth, splitByMean.
 */
import { copyFileSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { basename, dirname, extname, join, relative, resolve } from "node:path";
import { parseArgs } from "node:util";
import { GreatLand, ModelLoader } from "./starlogo-collision.min.js";

const MODEL = /\.(obj|dae|zae|glb|stl)$/i;
const options = {
	out: { type: "string" },
	up: { type: "string", default: "z" },
	increment: { type: "string" },
	"min-vertices": { type: "string" },
	depth: { type: "string" },
	"by-mean": { type: "boolean", default: false },
};

const { values, positionals } = parsed();
if (positionals.length !== 1) {
	console.error("usage: starlogo-bake FOLDER [--out FOLDER] [--up x|y|z] [--increment DEGREES] [--min-vertices N] [--depth N] [--by-mean]");
	process.exit(2);
}
const folder = resolve(positionals[0]);
const out = resolve(values.out ?? folder);
const files = readdirSync(folder, { recursive: true }).map(String).filter((file) => MODEL.test(file) && statSync(join(folder, file)).isFile()).sort();

let failures = 0;
for (const file of files) {
	const from = join(folder, file);
	const to = join(out, file);
	mkdirSync(dirname(to), { recursive: true });
	if (to !== from) copyFileSync(from, to);
	try {
		const start = performance.now();
		const model = await read(from);
		const bytes = newGame().bake(model).toUint8Array();
		writeFileSync(`${to}.fits`, bytes);
		const time = (performance.now() - start).toFixed(0);
		console.log(`${relative(out, to)}.fits: ${bytes.length} bytes for ${(model.triangles?.length ?? 0) / 3} triangles, ${time} ms`);
	} catch (error) {
		failures++;
		console.error(`${file}: ${error.message}`);
	}
}
console.log(`${files.length - failures} baked${failures > 0 ? `, ${failures} that are no models` : ""}`);
process.exitCode = failures > 0 ? 1 : 0;

function parsed() {
	try {
		return parseArgs({ options, allowPositionals: true });
	} catch (error) {
		console.error(error.message.split(". ")[0]);
		return { positionals: [] };
	}
}

/** A GreatLand with the settings that the game will have. */
function newGame() {
	const greatLand = new GreatLand();
	if (values.increment !== undefined) greatLand.orientedBoxDegIncrement = Number(values.increment);
	if (values["min-vertices"] !== undefined) greatLand.hierarchies.minVerticesToSplit = Number(values["min-vertices"]);
	if (values.depth !== undefined) greatLand.hierarchies.maxDepth = Number(values.depth);
	greatLand.hierarchies.splitByMean = values["by-mean"];
	return greatLand;
}

/** Reads a model as a game will, from a file of any kind. */
function read(file) {
	const receiver = new GreatLand();
	receiver.loadTightestFit = false;
	receiver.loadHierarchies = false;
	const loader = new ModelLoader(receiver, 1000);
	return new Promise((resolve, reject) => {
		loader.addEventListener("modelLoaded", (event) => resolve(event.model));
		loader.addEventListener("error", (event) => reject(new Error(event.text)));
		loader.loadBytes(basename(file, extname(file)), readFileSync(file), values.up);
	});
}
