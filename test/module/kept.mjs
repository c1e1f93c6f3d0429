/**
 * Bytes that the engine keeps for each triangle of a level, beyond the model, after more and more has been asked:
 * node --expose-gc kept.mjs [STEPS] prints them as JSON. The level is the example's mesh. It is placed twice, and the second time counts,
 * because the code is compiled then.
 */
import { readFileSync } from "node:fs";
import { memoryUsage } from "node:process";
import { engine } from "../benchmark/games.mjs";

const { Agent, AgentQueries, BuiltInModel, CombinationCollider, Footing, GltfModel, GreatLand, Model, RayHit, ShapeHit, Sphere, Vector3D, WalkOptions } = engine;

const STEPS = Number(process.argv[2] ?? 1000);
const WALKERS = 40;

const inUse = () => {
	for (let i = 0; i < 4; i++) globalThis.gc();
	const { heapUsed, external } = memoryUsage();
	return heapUsed + external;
};

const { vertices, triangles } = GltfModel.fromBytes("level", readFileSync(new URL("../../examples/level/level.glb", import.meta.url)), null, Model.AS_GIVEN);

/** A game in the level, and the bytes a triangle after each kind of question. */
function play(steps) {
	const model = new Model("level", vertices, triangles, Model.AS_GIVEN);
	const before = inUse();
	const bytes = {};
	const note = (name) => {
		bytes[name] = Math.round((3 * (inUse() - before)) / triangles.length);
	};
	const land = new GreatLand();
	land.loadTightestFit = false;
	land.addModel(model);
	land.loadTightestFit = true;
	land.addModel(BuiltInModel.sphere());
	note("added");

	const collider = Object.assign(new CombinationCollider(land), { exact: true });
	const queries = new AgentQueries(collider);
	const level = Object.assign(new Agent("level", "levels"), { hierarchical: true });
	const walkers = Array.from({ length: WALKERS }, (_, i) => {
		const walker = Object.assign(new Agent("sphere", "walkers"), { collideAs: "capsule", size: 0.8 });
		walker.moveTo((i % 8) * 9 - 36, (i >> 3) * 15 - 30, 8);
		return walker;
	});
	queries.update([level, ...walkers]);
	queries.cast(new Vector3D(0, 0, 50), new Vector3D(0.1, 0.05, -1), Infinity, null, new RayHit());
	note("ray");
	queries.castShape(new Sphere(new Vector3D(0, 0, 20), 0.4), 3, 2, -30, null, new ShapeHit());
	note("cast");

	const options = Object.assign(new WalkOptions(), { stepHeight: 0.3, snap: 0.3, slopeDegrees: 50, fall: 0.2 });
	const footing = new Footing();
	for (let step = 0; step < steps; step++) {
		walkers.forEach((walker, i) => {
			const angle = i + 1 + Math.floor(step / 100);
			queries.walk(walker, 0.1 * Math.cos(angle), 0.1 * Math.sin(angle), options, footing);
		});
	}
	note("walks");
	bytes.walked = walkers.filter(({ z }) => z < 8).length;

	const other = Object.assign(new Agent("level", "levels"), { hierarchical: true });
	other.moveTo(100, 0, 0);
	other.heading = 30;
	collider.areColliding(level, other);
	note("pair");
	return { bytes, kept: [model, land, queries, collider] };
}

const first = play(Math.min(STEPS, 50));
const second = play(STEPS);
console.log(JSON.stringify(second.bytes));
// both games are kept until here
if (first.kept.length !== second.kept.length) throw new Error("unlike games");
