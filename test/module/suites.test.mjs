/**
 * Suites that others have published, each in a folder that a variable of the environment names, got by hand (docs/building.md): continuous
 * queries with exact truth, Khronos's conformance suite for COLLADA, and the test files of Khronos's glTF validator.
 */
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { distanceOf, translationsIn } from "./ccd.mjs";
import { attempt, buffersOf, difference, drawnOf, partsOf, trianglesOfModel } from "./gltf.mjs";

const root = fileURLToPath(new URL("../..", import.meta.url));
const { Agent, ByteArray, ColladaModel, GltfModel, GreatLand, HierarchicalCollider, Model, ModelError } =
	await import(pathToFileURL(path.join(root, "bin/module/starlogo-collision.js")));

const { CCD_QUERIES, COLLADA_CTS, GLTF_VALIDATOR } = process.env;
const without = (name) => !process.env[name] && `${name} names no folder that has the suite`;
const filesIn = (folder, pattern) => readdirSync(folder, { recursive: true }).map(String).filter((file) => pattern.test(file)).sort();

// A touch counts up to this distance, as a fraction of the largest coordinate.
const NEAR = 1e-9;

/** Whether swept agents touch. Edges and points are triangles without area. */
function touch({ moving, fixed, way }) {
	const greatLand = new GreatLand();
	greatLand.prepareExact = true;
	const corners = (points) => [0, Math.min(1, points.length - 1), points.length - 1];
	greatLand.addModel(new Model("fixed", fixed.flat(), corners(fixed), Model.AS_GIVEN));
	greatLand.addModel(new Model("moving", moving.flat(), corners(moving), Model.AS_GIVEN));
	const collider = new HierarchicalCollider(greatLand);
	collider.exact = true;
	const agents = [new Agent("fixed"), new Agent("moving")];
	agents[1].sweeps = true;
	if (collider.findCollisions(agents).length > 0) return true;
	agents[1].moveTo(...way);
	return collider.findCollisions(agents).length > 0;
}

test("swept points and edges meet triangles and edges as exact arithmetic says", { skip: without("CCD_QUERIES") }, (t) => {
	const queries = translationsIn(CCD_QUERIES);
	const touching = queries.filter(({ isTouch }) => isTouch);
	const found = queries.filter(touch);
	assert.ok(touching.length > 100 && queries.length > 2 * touching.length, `${touching.length} of ${queries.length}`);
	assert.deepEqual(touching.filter((query) => !found.includes(query)).map(({ name }) => name), [], "missed");
	const more = found.filter(({ isTouch }) => !isTouch);
	const far = more.filter((query) => distanceOf(query) > NEAR * Math.max(...[...query.moving, ...query.fixed].flat().map(Math.abs)));
	assert.deepEqual(far.map(({ name }) => name), [], "too far for a touch");
	t.diagnostic(`${queries.length} queries, ${touching.length} touch: 0 missed, ${more.length} within the tolerance`);
});

// What the engine leaves out by its documentation, so that the pair cannot be equal: controllers are at rest, an element's own unit and up
// axis do not count, and other files are not fetched.
const LEFT_OUT = /library_controllers|\/asset\/|xml\/uri/;

// What it refuses in words: points of two coordinates; references whose vertices have another id; a camera's node without a direction.
const REFUSED = /expected the parameters X, Y and Z|there is no <vertices> with the id|expected two different points and a direction/;

/** The pairs [document, other] of which the suite's own scripts say that their pictures are equal. */
function pairsOf(documents) {
	const keyOf = (file, name) => `${file.includes("1_5") ? "1.5" : "1.4"} ${name}`;
	const named = {};
	for (const file of documents) (named[keyOf(file, path.basename(file, ".dae"))] ??= []).push(file);
	const inCommon = (a, b) => [...a].findIndex((letter, i) => letter !== b[i]);
	return documents.flatMap((file) => {
		const script = path.join(COLLADA_CTS, file.replace(/\.dae$/i, ".py"));
		if (!existsSync(script)) return [];
		const lines = readFileSync(script, "utf8").split("\n").filter((line) => !/^\s*#/.test(line)).join("\n");
		const calls = [...lines.matchAll(/CompareImagesAgainst\(\s*context\s*,\s*"([^"]+)"([^)]*)\)/g)];
		return calls.filter(([, , rest]) => !/False\s*$/.test(rest)).flatMap(([, name]) => {
			const others = (named[keyOf(file, name)] ?? []).slice().sort((a, b) => inCommon(b, file) - inCommon(a, file));
			return others.slice(0, 1).map((other) => [file, other]);
		});
	});
}

/** The corners of triangles and their area: what is the same however faces were cut into triangles. */
function surfaceOf(triangles) {
	const corners = triangles.flatMap((t) => [t.slice(0, 3), t.slice(3, 6), t.slice(6, 9)]).map((corner) => corner.map((x) => (Math.round(x * 1e4) || 0)).join());
	const area = triangles.reduce((sum, [ax, ay, az, bx, by, bz, cx, cy, cz]) => {
		const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az];
		return sum + Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
	}, 0);
	return `${[...new Set(corners)].sort().join(" ")}; ${area.toFixed(3)}`;
}

function isSame(a, b) {
	const [own, other] = [trianglesOfModel(a), trianglesOfModel(b)];
	return difference(own, other, 1e-4, true) === null || surfaceOf(own) === surfaceOf(other);
}

test("the documents of COLLADA's conformance suite are read or refused, and are equal where their pictures are", { skip: without("COLLADA_CTS") }, (t) => {
	const documents = filesIn(COLLADA_CTS, /\.dae$/i);
	const read = (file) => attempt(() => ColladaModel.fromBytes(file, readFileSync(path.join(COLLADA_CTS, file)), null, Model.AS_GIVEN), ModelError);
	const models = new Map(documents.map((file) => [file, read(file)]));
	const sound = documents.filter((file) => models.get(file) instanceof Model);
	assert.ok(documents.length > 1000 && sound.length > 0.8 * documents.length, `${sound.length} of ${documents.length} are read`);
	const pairs = pairsOf(documents).filter(([file]) => !LEFT_OUT.test(file));
	const refused = pairs.filter((pair) => pair.some((file) => models.get(file) instanceof ModelError));
	assert.deepEqual(refused.flat().map((file) => models.get(file)).filter((model) => model instanceof ModelError && !REFUSED.test(model.message)).map(String), []);
	const compared = pairs.filter((pair) => !refused.includes(pair));
	assert.ok(compared.length > 300, `${compared.length} pairs`);
	assert.deepEqual(compared.filter(([a, b]) => !isSame(models.get(a), models.get(b))), [], "these are not equal");
	t.diagnostic(`${documents.length} documents, ${sound.length} are read, the others are refused in words; ${compared.length} pairs are equal, ${refused.length} have a document that is refused`);
});

// What the engine refuses of valid files: what needs a newer version, data that are not in base64, other sites, buffers without data.
const UNSUPPORTED = /expected glTF 2.0|expected data in base64|a path from the file's folder on|its data are missing/;

test("the files of the glTF validator's tests are read or refused, and have the triangles that three.js draws", { skip: without("GLTF_VALIDATOR") }, async (t) => {
	const all = filesIn(GLTF_VALIDATOR, /\.(gltf|glb)$/);
	assert.ok(all.length > 300, `${all.length} files`);
	const wrong = [];
	const counts = { same: 0, nothing: 0, refused: 0 };
	for (const name of all) {
		const file = path.join(GLTF_VALIDATOR, name);
		const bytes = readFileSync(file);
		const buffers = beside(file, bytes);
		const given = Object.fromEntries(Object.entries(buffers).map(([uri, data]) => [uri, new ByteArray(data)]));
		const model = attempt(() => GltfModel.fromBytes(name, bytes, "z", Model.AS_GIVEN, given), ModelError);
		const isEmpty = model instanceof ModelError && /no vertices/.test(model.message);
		const drawn = await drawnOf(bytes, buffers).catch(() => null);
		if (model instanceof Model && drawn !== null && difference(trianglesOfModel(model), drawn, 1e-5, true) !== null) wrong.push(`${name}: other triangles`);
		if (model instanceof ModelError && drawn?.length > 0) wrong.push(`${name}: three.js draws it, but ${model.message}`);
		if (model instanceof ModelError && !isEmpty && isValid(file) && !UNSUPPORTED.test(model.message)) wrong.push(`${name} is valid, but ${model.message}`);
		counts[model instanceof Model ? "same" : (isEmpty ? "nothing" : "refused")]++;
	}
	assert.deepEqual(wrong, []);
	t.diagnostic(`${all.length} files: ${counts.same} are read, ${counts.nothing} have no mesh, ${counts.refused} are refused in words`);
});

/** The buffers that stand beside a file; none if that is no glTF file. */
function beside(file, bytes) {
	try {
		return buffersOf(file, partsOf(bytes).json);
	} catch {
		return {};
	}
}

/** Whether the validator's own report of a file has no errors. */
function isValid(file) {
	const report = `${file}.report.json`;
	return existsSync(report) && JSON.parse(readFileSync(report, "utf8")).issues.numErrors === 0;
}
