/** A game of agents all over the ground, and the pairs that each collision system finds in it. Nothing here draws. */
import { Agent, CollisionBlocks } from "starlogo-collision";
import { SYSTEMS, finderOf } from "./systems.js";

/** Half the width of the ground. */
export const HALF_WIDTH = 50;
const STEP = 0.3;
const SIZE = 5;

/** The shapes of its agents, used in turn. */
export const CAST = ["bear", "dragon", "fireman", "seagull", "fortress", "person"];

/**
 * The engine's own scattered scene (ScatteredScene.as). All agents walk straight on and turn a little every frame. An agent that leaves
 * comes in on the other side.
 */
export class ScatteredGame {
	agents = [];
	#random = 20150601;

	/**
	 * @param {number} count the number of agents
	 * @param {number} halfWidth half the width of their ground
	 * @param {string[]} cast their shapes, used in turn
	 */
	constructor(count, halfWidth = HALF_WIDTH, cast = CAST) {
		this.halfWidth = halfWidth;
		for (let i = 0; i < count; i++) {
			const agent = new Agent(cast[i % cast.length]);
			agent.moveTo(this.#between(-halfWidth, halfWidth), this.#between(-halfWidth, halfWidth), 0);
			agent.heading = this.#between(0, 360);
			agent.size = SIZE;
			// every other agent is hierarchical, for the combination
			agent.hierarchical = i % 2 === 0;
			this.agents.push(agent);
		}
	}

	step() {
		for (const agent of this.agents) {
			agent.heading += this.#between(-10, 10);
			const angle = (agent.heading * Math.PI) / 180;
			agent.moveTo(this.#wrapped(agent.x + STEP * Math.cos(angle)), this.#wrapped(agent.y + STEP * Math.sin(angle)), 0);
		}
	}

	#wrapped(coordinate) {
		const { halfWidth } = this;
		return coordinate > halfWidth ? coordinate - 2 * halfWidth : coordinate < -halfWidth ? coordinate + 2 * halfWidth : coordinate;
	}

	// Knuth, TAOCP 2, §3.3.4
	#between(low, high) {
		this.#random = (Math.imul(this.#random, 1664525) + 1013904223) >>> 0;
		return low + ((high - low) * this.#random) / 4294967296;
	}
}

/** The pairs that a system finds, as a map from a key to the two agents. */
export function pairsOf(system, agents) {
	const found = system.findCollisions(agents);
	const pairs = new Map();
	for (let i = 0; i < found.length; i += 2) {
		const [a, b] = found[i].id < found[i + 1].id ? [found[i], found[i + 1]] : [found[i + 1], found[i]];
		pairs.set(`${a.id} ${b.id}`, [a, b]);
	}
	return pairs;
}

/** Rounds that count for nothing, in which the browser compiles the code, rounds that count, and the frames of each. */
const [WARM, COUNTED, FRAMES] = [2, 3, 30];

/**
 * The milliseconds in which each system finds all pairs of a frame, while all agents move: the shortest of several rounds.
 *
 * @param {object} greatLand
 * @param {number} count the number of agents
 * @param {() => boolean} isWanted whether to go on
 * @returns {Promise<Record<string, number>|null>} by the systems' names; null if it is not wanted any more
 */
export async function timesOf(greatLand, count, isWanted) {
	const game = new ScatteredGame(count);
	const systemNamed = finderOf(new CollisionBlocks(greatLand, game.agents));
	// the first one only moves
	const works = [() => {}, ...SYSTEMS.map((name) => () => systemNamed(name).findCollisions(game.agents))];
	const shortest = works.map(() => Infinity);
	for (let round = 0; round < WARM + COUNTED; round++) {
		for (const [i, search] of works.entries()) {
			const start = performance.now();
			for (let frame = 0; frame < FRAMES; frame++) {
				game.step();
				search();
			}
			if (round >= WARM) shortest[i] = Math.min(shortest[i], performance.now() - start);
			await new Promise((resolve) => setTimeout(resolve));
			if (!isWanted()) return null;
		}
	}
	const [moving, ...all] = shortest;
	return Object.fromEntries(SYSTEMS.map((name, i) => [name, Math.max(0.001, (all[i] - moving) / FRAMES)]));
}

/**
 * Compares the pairs of all systems with those of a reference system, which is taken as right.
 *
 * @param {(name: string) => object} systemNamed gives the system with a name
 * @param {Agent[]} agents
 * @param {string} reference the reference system's name
 * @returns {{truth: Map, systems: Record<string, {right: Agent[][], wrong: Agent[][], missed: Agent[][]}>}} pairs of agents
 */
export function compare(systemNamed, agents, reference) {
	const truth = pairsOf(systemNamed(reference), agents);
	const systems = {};
	for (const name of SYSTEMS.filter((each) => each !== reference)) {
		const found = pairsOf(systemNamed(name), agents);
		const pick = (pairs, isWanted) => [...pairs].filter(([key]) => isWanted(key)).map(([, pair]) => pair);
		systems[name] = { right: pick(found, (key) => truth.has(key)), wrong: pick(found, (key) => !truth.has(key)), missed: pick(truth, (key) => !found.has(key)) };
	}
	return { truth, systems };
}
