/** What the measurements of the ES module share: a game of agents that walk about on SpaceLand, and the module itself, minified. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import * as engine from "../../bin/module/starlogo-collision.min.js";
import { randomNumbers } from "../module/random.mjs";

const { Agent, BinCollider, BuiltInModel, CombinationCollider, GreatLand, HierarchicalCollider, ObjModel, TightestFitCollider } = engine;

const root = fileURLToPath(new URL("../..", import.meta.url));

export { engine, randomNumbers };

/** Half the width of SpaceLand, in patches. */
export const HALF_WIDTH = 50;

/** The shapes of a mixed game. */
export const MODELS = ["sphere", "cube", "cylinder", "bear"];

/** The colliders' classes. */
export const SYSTEMS = { bins: BinCollider, "tightest fit": TightestFitCollider, hierarchical: HierarchicalCollider, combination: CombinationCollider };

/** The text of a model's file. */
export const asset = (file) => readFileSync(`${root}/assets/${file}`, "utf8");

/** The models of MODELS. */
export function makeGreatLand() {
	const greatLand = new GreatLand();
	for (const model of [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder(), new ObjModel("bear", asset("bear.obj"))]) greatLand.addModel(model);
	return greatLand;
}

/** Agents all over the ground, and functions that move all of them on by a frame. */
export function scatter(count, names, { seed = 20150601, halfWidth = HALF_WIDTH } = {}) {
	const random = randomNumbers(seed);
	const between = (low, high) => low + (high - low) * random();
	const agents = Array.from({ length: count }, (_, i) => {
		const agent = new Agent(names[i % names.length]);
		agent.moveTo(between(-halfWidth, halfWidth), between(-halfWidth, halfWidth), 0);
		agent.heading = between(0, 360);
		return agent;
	});
	const wrap = (x) => (x > halfWidth ? x - 2 * halfWidth : x < -halfWidth ? x + 2 * halfWidth : x);
	const walk = (agent) => {
		const angle = agent.heading * Math.PI / 180;
		agent.moveTo(wrap(agent.x + 0.3 * Math.cos(angle)), wrap(agent.y + 0.3 * Math.sin(angle)), 0);
	};
	const step = () => {
		for (const agent of agents) {
			agent.heading += between(-10, 10);
			walk(agent);
		}
	};
	return { agents, step, walk: () => agents.forEach(walk) };
}

/**
 * The same walk known in advance, so that a frame's time is that of moveTo and of the search alone: a function that plays some frames of
 * it to and fro, each of which moves every agent by a step.
 */
export function rehearse({ agents, walk }, frames = 8) {
	const places = Array.from({ length: frames }, () => {
		const of = new Float64Array(2 * agents.length);
		agents.forEach((agent, i) => {
			of[2 * i] = agent.x;
			of[2 * i + 1] = agent.y;
		});
		walk();
		return of;
	});
	const round = [...places, ...places.slice(1, -1).reverse()];
	let frame = 0;
	const move = () => {
		const of = round[frame % round.length];
		for (let i = 0; i < agents.length; i++) agents[i].moveTo(of[2 * i], of[2 * i + 1], 0);
		frame++;
	};
	move();
	return move;
}
