/**
 * Prints the milliseconds of the processors from a level that three.js has read to its first ray, in code that has never run: node fresh-level.mjs NAME
 * FILE. The name is "engine" or "three-mesh-bvh". module.mjs copies it into a folder in which all that it imports is installed.
 */
import { readFileSync } from "node:fs";
import { BufferGeometry, Ray, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { MeshBVH } from "three-mesh-bvh";
import { Agent, AgentQueries, CombinationCollider, GreatLand } from "starlogo-collision";
import { levelFromObject } from "starlogo-collision/three";

/** Each prepares the scene, and returns how far below a place 50 above the origin it is. */
const FIRST_RAYS = {
	engine(scene) {
		const land = new GreatLand();
		land.loadTightestFit = false;
		land.addModel(levelFromObject("level", scene));
		const queries = new AgentQueries(Object.assign(new CombinationCollider(land), { exact: true }));
		queries.update([Object.assign(new Agent("level"), { hierarchical: true })]);
		return queries.cast({ x: 0, y: 0, z: 50 }, { x: 0, y: 0, z: -1 }).distance;
	},
	"three-mesh-bvh"(scene) {
		const geometries = [];
		scene.updateMatrixWorld();
		scene.traverse(({ isMesh, geometry, matrixWorld }) => {
			if (isMesh) geometries.push(new BufferGeometry().setIndex(geometry.index).setAttribute("position", geometry.attributes.position.clone()).applyMatrix4(matrixWorld));
		});
		return new MeshBVH(mergeGeometries(geometries)).raycastFirst(new Ray(new Vector3(0, 50, 0), new Vector3(0, -1, 0)), 2).distance;
	},
};

const [name, file] = process.argv.slice(2);
const bytes = readFileSync(file);
const { scene } = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), "");
const start = process.cpuUsage();
const distance = FIRST_RAYS[name](scene);
const { user, system } = process.cpuUsage(start);
console.log(JSON.stringify({ ms: (user + system) / 1000, distance }));
