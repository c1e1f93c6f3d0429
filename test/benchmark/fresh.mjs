/**
 * Measures of a game of 10,000 scattered agents that need a process of their own: node [--expose-gc ...] fresh.mjs MEASURE SYSTEM
 * prints a number. module.mjs starts it.
 */
import { memoryUsage } from "node:process";
import { MODELS, SYSTEMS, makeGreatLand, rehearse, scatter } from "./games.mjs";

const COUNT = 10000;

// frames between two collections; turns of them, the first of which are for the compiler
const FRAMES = 20;
const TURNS = 15;
const WARM_UP = 5;

/** What must not be collected before it is measured. */
let held = null;

const inUse = () => {
	const { heapUsed, external } = memoryUsage();
	return heapUsed + external;
};

/** One in ten is hierarchical, for the combination of the two. */
function makeGame() {
	const game = scatter(COUNT, MODELS);
	game.agents.forEach((agent, i) => {
		agent.hierarchical = i % 10 === 0;
	});
	return game;
}

/** Bytes that a collider keeps for an agent. */
function kept(System) {
	const { agents, step } = makeGame();
	const collider = new System(makeGreatLand());
	const collect = () => {
		for (let i = 0; i < 4; i++) globalThis.gc();
		return inUse();
	};
	// agents that have moved are larger than those that have not
	for (let i = 0; i < 3; i++) step();
	const before = collect();
	for (let i = 0; i < 3; i++) {
		step();
		collider.findCollisions(agents, []);
	}
	held = [agents, collider];
	return (collect() - before) / held[0].length;
}

/** Bytes of garbage that a frame in which all move leaves. The young generation has to have room for a turn's. */
function garbage(System) {
	const game = makeGame();
	const move = rehearse(game);
	const collider = new System(makeGreatLand());
	const out = [];
	const turns = Array.from({ length: TURNS }, () => {
		globalThis.gc();
		const before = inUse();
		for (let i = 0; i < FRAMES; i++) {
			move();
			collider.findCollisions(game.agents, out);
		}
		return (inUse() - before) / FRAMES;
	});
	return turns.slice(WARM_UP).reduce((sum, bytes) => sum + bytes) / (TURNS - WARM_UP);
}

/** Milliseconds of the first frame that a collider sees, in code that has never run. */
function first(System) {
	const { agents } = makeGame();
	const collider = new System(makeGreatLand());
	const start = performance.now();
	collider.findCollisions(agents, []);
	return performance.now() - start;
}

const [measure, system] = process.argv.slice(2);
console.log({ kept, garbage, first }[measure](SYSTEMS[system]));
