/** Tests of the adapter to three.js, with each version of three.js that it is for. What three.js says is the truth. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { peers } from "./peers.mjs";
import { Scenes, drawnCorners } from "./scenes.mjs";

const all = await peers();
const SCENES = 200;

/** The corners of a model's triangles in the world of an agent, in the axes of a scene. */
function cornersOf(model, agent, up) {
	const { rawData: m } = agent.transform;
	return model.triangles.flatMap((corner) => {
		const [x, y, z] = model.vertices.slice(3 * corner, 3 * corner + 3);
		const [a, b, c] = [0, 1, 2].map((row) => m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12]);
		return up === "y" ? [a, c, -b] : [a, b, c];
	});
}

/** The largest difference of corners, those of triangles that are mirrored being turned round. */
function differenceOf(found, { corners, flips }) {
	assert.equal(found.length, corners.length);
	let most = 0;
	flips.forEach((isFlipped, triangle) => [0, 1, 2].forEach((corner) => [0, 1, 2].forEach((axis) => {
		const other = isFlipped ? [0, 2, 1][corner] : corner;
		most = Math.max(most, Math.abs(found[9 * triangle + 3 * corner + axis] - corners[9 * triangle + 3 * other + axis]));
	})));
	return most;
}

for (const { version, THREE, engine, adapter } of all) {
	const { Agent, Model } = engine;
	const { ThreeAgentBinding, bindInstance, modelFromObject, ThreeWireframe } = adapter;

	test(`three ${version}: what is drawn in ${SCENES} random scenes is where the engine has it, whichever of the two leads`, () => {
		const scenes = new Scenes(THREE, 25);
		const { dice } = scenes;
		const land = new THREE.Scene();
		let most = 0;
		let triangles = 0;
		for (let i = 0; i < SCENES; i++) {
			const source = scenes.tree();
			const up = dice.isLuckyIn(2) ? "y" : "z";
			const landUp = dice.isLuckyIn(4) ? "y" : "z";
			scenes.place(source);
			land.add(source);
			const truth = drawnCorners(THREE, source);
			if (truth.flips.length === 0) continue;
			const model = modelFromObject("any", source, { up, scaling: [Model.FOOTPRINT, Model.VOLUME, Model.AS_GIVEN][dice.below(3)] });
			const agent = new Agent("any");
			const binding = new ThreeAgentBinding(agent, source, model, { up: landUp });
			binding.updateAgent();
			most = Math.max(most, differenceOf(cornersOf(model, agent, landUp), truth));
			const revision = JSON.stringify([agent.transform.rawData]);
			binding.updateObject();
			assert.equal(JSON.stringify([agent.transform.rawData]), revision);
			// and the agent leads
			agent.moveTo(dice.number(-5, 5), dice.number(-5, 5), dice.number(-5, 5));
			agent.heading = dice.number(-180, 180);
			agent.pitch = dice.isLuckyIn(3) ? 90 : dice.number(-180, 180);
			agent.roll = dice.number(-180, 180);
			agent.size = dice.number(0.2, 3);
			binding.updateObject();
			const drawn = drawnCorners(THREE, source);
			most = Math.max(most, differenceOf(cornersOf(model, agent, landUp), drawn));
			triangles += drawn.flips.length;
			land.remove(source);
		}
		assert.ok(most <= 1e-12, `${most}`);
		assert.ok(most > 0 && triangles > 20 * SCENES, `${triangles} triangles`);
		for (const kind of ["plain", "indexed", "interleaved", "quantized", "a draw range", "groups", "instanced", "skinned", "morphed", "mirrored", "mirrored twice",
			"levels of detail", "near gimbal lock", "placed by its matrix"]) assert.ok(scenes.counts[kind] >= SCENES / 10, `${kind}: ${scenes.counts[kind]}`);
	});
}
