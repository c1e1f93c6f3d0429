/** What three.js reads from glTF and STL files, for tests that compare the engine's readers with it. */
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

// the quick command runs these tests, and fetches three.js for no others
const folder = new URL("../../js/module/", import.meta.url);
const npm = fileURLToPath(new URL("../../build/npm-ci.mjs", import.meta.url));
spawnSync(process.execPath, [npm, fileURLToPath(folder), "three.js, and what the ES module is measured beside"], { stdio: "inherit" });

const load = (file) => import(new URL(`node_modules/three/${file}`, folder));
const { Vector3 } = await load("build/three.module.js");
const { GLTFLoader } = await load("examples/jsm/loaders/GLTFLoader.js");
const { STLLoader } = await load("examples/jsm/loaders/STLLoader.js");

// what the loader has of a browser
globalThis.self ??= globalThis;
globalThis.ProgressEvent ??= class extends Event {};
console.warn = () => {};

/** The JSON of a file, and its binary chunk. */
export function partsOf(bytes) {
	if (bytes.toString("latin1", 0, 4) !== "glTF") return { json: JSON.parse(bytes.toString("utf8")), chunk: null };
	const length = bytes.readUInt32LE(12);
	const json = JSON.parse(bytes.toString("utf8", 20, 20 + length));
	const start = 20 + length + 8;
	return { json, chunk: start < bytes.length ? bytes.subarray(start, start + bytes.readUInt32LE(start - 8)) : null };
}

/** The files beside a .gltf file that its buffers name. */
export function buffersOf(file, json) {
	const uris = (json.buffers ?? []).map((buffer) => buffer.uri).filter((uri) => uri !== undefined && !uri.startsWith("data:"));
	return Object.fromEntries(uris.map((uri) => [uri, readFileSync(path.join(path.dirname(file), decodeURIComponent(uri)))]));
}

/** The triangles that three.js draws of a file at rest: nine numbers each, y up. */
export async function drawnOf(bytes, buffers = {}) {
	const { json, chunk } = partsOf(bytes);
	const dataUri = (data) => `data:application/octet-stream;base64,${data.toString("base64")}`;
	for (const buffer of json.buffers ?? []) {
		if (buffer.uri === undefined && chunk) buffer.uri = dataUri(chunk);
		else if (buffers[buffer.uri]) buffer.uri = dataUri(buffers[buffer.uri]);
	}
	// three.js draws nothing of a file without scenes; the engine takes all of its nodes
	if (!json.scenes?.length) {
		const children = new Set((json.nodes ?? []).flatMap((node) => node.children ?? []));
		json.scenes = [{ nodes: [...(json.nodes ?? []).keys()].filter((node) => !children.has(node)) }];
	}
	// there is nothing here that decodes pictures
	delete json.materials;
	delete json.textures;
	delete json.images;
	for (const mesh of json.meshes ?? []) for (const primitive of mesh.primitives) delete primitive.material;
	const loader = new GLTFLoader();
	const { scenes, scene } = await new Promise((resolve, reject) => loader.parse(JSON.stringify(json), "", resolve, reject));
	const triangles = [];
	for (const each of json.scene === undefined ? scenes : [scene]) {
		each.updateMatrixWorld(true);
		each.traverse((object) => object.isMesh && trianglesOf(object).forEach((triangle) => triangles.push(triangle)));
	}
	return triangles;
}

function trianglesOf(mesh) {
	const { index, attributes: { position } } = mesh.geometry;
	const count = index === null ? position.count : index.count;
	const isMirrored = !mesh.isSkinnedMesh && mesh.matrixWorld.determinant() < 0;
	const corner = (i) => mesh.getVertexPosition(index === null ? i : index.getX(i), new Vector3()).applyMatrix4(mesh.matrixWorld).toArray();
	return Array.from({ length: Math.floor(count / 3) }, (_, i) => {
		const corners = [corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)];
		return (isMirrored ? [corners[0], corners[2], corners[1]] : corners).flat();
	});
}

/** The triangles of an STL file, as three.js reads it. */
export function stlOf(bytes) {
	const numbers = [...new STLLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)).attributes.position.array];
	return Array.from({ length: numbers.length / 9 }, (_, i) => numbers.slice(9 * i, 9 * i + 9));
}

/** The triangles of one of the engine's models: nine numbers each. */
export function trianglesOfModel({ vertices, triangles }) {
	const corner = (i) => vertices.slice(3 * triangles[i], 3 * triangles[i] + 3);
	return Array.from({ length: (triangles?.length ?? 0) / 3 }, (_, i) => [corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)].flat());
}

/**
 * What is different between two lists of triangles, each by any corner first and, if both sides of them do, turned round; null if nothing is
 * beyond a tolerance.
 */
export function difference(own, other, tolerance, bothSides = false) {
	if (own.length !== other.length) return `${own.length} triangles instead of ${other.length}`;
	const size = other.flat().reduce((most, value) => Math.max(most, Math.abs(value)), 1e-30);
	for (let i = 0; i < own.length; i++) {
		const around = [...own[i].slice(0, 3), ...own[i].slice(6), ...own[i].slice(3, 6)];
		const turns = (bothSides ? [own[i], around] : [own[i]]).flatMap((side) => [0, 3, 6].map((turn) => [...side.slice(turn), ...side.slice(0, turn)]));
		const error = Math.min(...turns.map((turned) => Math.max(...turned.map((value, k) => Math.abs(value - other[i][k])))));
		if (!(error <= tolerance * size)) return `triangle ${i}: ${own[i]} instead of ${other[i]}`;
	}
	return null;
}

/** What an action returns, or the error of a class that it throws. */
export function attempt(action, ErrorClass) {
	try {
		return action();
	} catch (error) {
		if (error instanceof ErrorClass) return error;
		throw error;
	}
}
