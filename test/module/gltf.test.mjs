/**
 * glTF and STL models beside what three.js draws of them: random files of all that the format has, those of Debian's package
 * assimp-testmodels and, where the environment's GLTF_MODELS names a folder that has them, Khronos's sample models.
 *
 * Checks starlogo.models.gltf, starlogo.models.stl, starlogo.models.polygons.
 */
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { engine } from "./engine.mjs";
import { attempt, buffersOf, difference, drawnOf, partsOf, stlOf, trianglesOfModel } from "./gltf.mjs";
import { randomGltf } from "./random-gltf.mjs";

const root = fileURLToPath(new URL("../..", import.meta.url));
const { ByteArray, GltfModel, Model, ModelError, StlModel } = engine;

const ASSIMP = "/usr/share/assimp/models";
const TOLERANCE = 1e-5;
const files = (folder, pattern) => readdirSync(folder, { recursive: true }).map(String).filter((file) => pattern.test(file)).sort().map((file) => path.join(folder, file));

/** A model as it is in its file: y up, unscaled. */
function read(bytes, buffers = {}) {
	const given = Object.fromEntries(Object.entries(buffers).map(([uri, data]) => [uri, new ByteArray(data)]));
	return GltfModel.fromBytes("model", bytes, "z", Model.AS_GIVEN, given);
}

async function compareFile(file) {
	const bytes = readFileSync(file);
	let buffers = {};
	try {
		buffers = buffersOf(file, partsOf(bytes).json);
	} catch {
		// the engine says what is missing, or that it is no such file
	}
	const found = attempt(() => read(bytes, buffers), ModelError);
	if (found instanceof ModelError && !/no vertices/.test(found.message)) return `refused: ${found.message}`;
	const drawn = await drawnOf(bytes, buffers);
	if (found instanceof ModelError) return drawn.length === 0 ? null : `refused: ${found.message}`;
	return found.triangles === null && drawn.length === 0 ? null : difference(trianglesOfModel(found), drawn, TOLERANCE, true);
}

test("random files have the triangles that three.js draws of them", async () => {
	const seen = {};
	for (let seed = 1; seed <= 300; seed++) {
		const { bytes, features } = randomGltf(seed);
		for (const feature of features) seen[feature] = (seen[feature] ?? 0) + 1;
		const own = trianglesOfModel(read(bytes));
		// where joints mirror, three.js looks at the node that has the mesh, which has no part in where the mesh is
		assert.equal(difference(own, await drawnOf(bytes), TOLERANCE, features.has("skin")), null, `seed ${seed}: ${[...features]}`);
	}
	for (const feature of ["strip", "fan", "no indices", "sparse", "normalised", "stride", "matrix", "mirror", "skin", "morph", "instanced", "quantised", "binary", "text"]) {
		assert.ok(seen[feature] >= 20, `${feature}: ${seen[feature]}`);
	}
});

// what the engine refuses of them, and three.js does not look at or leaves out
const REFUSED = /draco|RecursiveNodes|IndexOutOfRange|IncorrectVertexArrays|BoxWithInfinites|SchemaFailures|wrongTypes|MissingBin|SceneWithoutNodes|texcoord_crash|Cameras|NoScene/;

test("assimp's glTF models have the triangles that three.js draws of them", { skip: !existsSync(`${ASSIMP}/glTF2`) && "the package assimp-testmodels is not installed" }, async () => {
	const all = files(`${ASSIMP}/glTF2`, /\.(gltf|glb)$/);
	const sound = all.filter((file) => !REFUSED.test(file));
	assert.ok(sound.length > 20);
	for (const file of sound) assert.equal(await compareFile(file), null, file);
});

test("assimp's STL models have the triangles that three.js reads of them", { skip: !existsSync(`${ASSIMP}/STL`) && "the package assimp-testmodels is not installed" }, () => {
	const all = files(`${ASSIMP}/STL`, /\.stl$|formatDetection/i);
	assert.equal(all.length, 9);
	for (const file of all) {
		const bytes = readFileSync(file);
		const model = StlModel.fromBytes("model", bytes, "z", Model.AS_GIVEN);
		assert.equal(difference(trianglesOfModel(model), stlOf(bytes), TOLERANCE), null, file);
	}
});

const khronos = process.env.GLTF_MODELS;

test("Khronos's sample models have the triangles that three.js draws of them", { skip: !khronos && "GLTF_MODELS names no folder that has them" }, async (t) => {
	const all = files(khronos, /\.(gltf|glb)$/);
	assert.ok(all.length > 0);
	const wrong = [];
	let count = 0;
	for (const file of all) {
		const problem = await compareFile(file);
		if (problem === null) count++;
		else if (!/refused: .*(Draco|meshopt|needs the extension|more than 1000000 vertices|expected glTF 2.0|of version 2)/.test(problem)) wrong.push(`${file}: ${problem}`);
	}
	t.diagnostic(`${count} of ${all.length} have the same triangles, the others are refused in words`);
	assert.equal(wrong.join("\n"), "");
	assert.ok(count > all.length / 2, `${count} of ${all.length}`);
});
