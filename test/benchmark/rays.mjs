/** What tests and benchmarks of triangles share: models, and three-mesh-bvh around them. */
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { asset, engine } from "./games.mjs";

const { ColladaModel, Model, ObjModel } = engine;

const tools = createRequire(new URL("../../js/module/package.json", import.meta.url));
const three = await import(pathToFileURL(tools.resolve("three")));
const { MeshBVH } = await import(pathToFileURL(tools.resolve("three-mesh-bvh")));

/** A torus of 2 rings sides triangles. */
export function torus(rings, sides) {
	const vertices = [];
	const triangles = [];
	for (let i = 0; i < rings; i++) {
		for (let j = 0; j < sides; j++) {
			const [around, across] = [(2 * Math.PI * i) / rings, (2 * Math.PI * j) / sides];
			const radius = 0.35 + 0.15 * Math.cos(across);
			vertices.push(radius * Math.cos(around), radius * Math.sin(around), 0.15 + 0.15 * Math.sin(across));
			const [next, up] = [((i + 1) % rings) * sides, (j + 1) % sides];
			triangles.push(i * sides + j, next + j, next + up, i * sides + j, next + up, i * sides + up);
		}
	}
	return new Model("torus", vertices, triangles);
}

/** The dragon, the bear and a torus. */
export function rayModels(rings = 100, sides = 40) {
	return [new ColladaModel("dragon", asset("dragon.dae")), new ObjModel("bear", asset("bear.obj")), torus(rings, sides)];
}

/** three.js, a model's geometry with three-mesh-bvh's tree around it, and how many milliseconds that took; positions are of single precision as three.js's own. */
export function makeBvh(model, Numbers = Float32Array) {
	const geometry = new three.BufferGeometry();
	geometry.setAttribute("position", new three.BufferAttribute(new Numbers(model.vertices), 3));
	geometry.setIndex(new three.BufferAttribute(new Uint32Array(model.triangles), 1));
	const start = performance.now();
	const bvh = geometry.boundsTree = new MeshBVH(geometry);
	return { three, geometry, bvh, ms: performance.now() - start };
}
