/** Rays at placed models, by their triangles, beside three-mesh-bvh's. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { engine, randomNumbers } from "./games.mjs";
import { makeBvh, rayModels } from "./rays.mjs";

const { Agent, AgentQueries, GreatLand, HierarchicalCollider, RayHit, Vector3D } = engine;

const PLACEMENTS = 100000;
const NEAR = 1e-6;

const models = rayModels();

test(`${PLACEMENTS} placements are hit where three-mesh-bvh hits them`, () => {
	const greatLand = new GreatLand();
	greatLand.loadTightestFit = false;
	const collider = new HierarchicalCollider(greatLand);
	collider.exact = true;
	const random = randomNumbers(2231);
	const between = (low, high) => low + (high - low) * random();
	const hit = new RayHit();
	const [origin, direction] = [new Vector3D(), new Vector3D()];
	for (const model of models) {
		greatLand.addModel(model);
		const { three, bvh } = makeBvh(model, Float64Array);
		const [ray, normal, inverse] = [new three.Ray(), new three.Vector3(), new three.Matrix4()];
		const agent = new Agent(model.name);
		const queries = new AgentQueries(collider);
		queries.update([agent]);
		let hits = 0;
		for (let i = 0; i < PLACEMENTS / models.length; i++) {
			agent.size = 10 ** between(-2, 2);
			[agent.heading, agent.pitch, agent.roll] = [between(0, 360), between(-90, 90), between(-90, 90)];
			agent.moveTo(between(-50, 50), between(-50, 50), between(-5, 5));
			queries.moved(agent);
			// from out of the sphere around the model to somewhere near its middle
			const angle = between(0, 2 * Math.PI);
			const height = between(-1, 1);
			const away = agent.size * between(2, 20);
			const flat = away * Math.sqrt(1 - height * height);
			origin.setTo(agent.x + flat * Math.cos(angle), agent.y + flat * Math.sin(angle), agent.z + away * height);
			const spread = 0.6 * agent.size;
			direction.setTo(agent.x + between(-spread, spread) - origin.x, agent.y + between(-spread, spread) - origin.y, agent.z + between(-spread, spread) - origin.z);
			const matrix = new three.Matrix4().fromArray(agent.transform.rawData);
			ray.origin.copy(origin);
			ray.direction.copy(direction).normalize();
			const expected = bvh.raycastFirst(ray.applyMatrix4(inverse.copy(matrix).invert()), three.DoubleSide);
			const found = queries.cast(origin, direction, Infinity, null, hit);
			const message = `${model.name}, placement ${i}`;
			assert.equal(found !== null, expected !== null, message);
			if (expected === null) continue;
			hits++;
			const distance = expected.point.applyMatrix4(matrix).distanceTo(new three.Vector3().copy(origin));
			assert.ok(Math.abs(hit.distance - distance) <= NEAR * Math.max(1, distance), `${message}: ${hit.distance}, not ${distance}`);
			normal.copy(expected.face.normal).transformDirection(matrix);
			const along = Math.abs(normal.x * hit.normal.x + normal.y * hit.normal.y + normal.z * hit.normal.z);
			assert.ok(along > 1 - NEAR, `${message}: normal ${hit.normal}`);
		}
		assert.ok(hits > 0.1 * (PLACEMENTS / models.length) && hits < 0.95 * (PLACEMENTS / models.length), `${model.name}: ${hits} hits`);
	}
});
