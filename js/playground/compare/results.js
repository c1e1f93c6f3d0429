/** The times that the collision systems take in a scattered game, and which of the pairs that they find are right. Nothing here draws. */
import { CollisionBlocks } from "starlogo-collision";
import { judge, pairsOf } from "../shared/pairs.js";
import { ScatteredGame } from "../shared/scattered.js";
import { shortestTimes } from "../shared/timing.js";
import { SYSTEMS, finderOf } from "./systems.js";

const ROUNDS = { warm: 2, counted: 3 };
/** The frames of a round. */
const FRAMES = 30;
/** The name of the work that only moves the agents. */
const MOVING = "moving";

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
	const workOf = (name, search) => ({
		name,
		run() {
			for (let frame = 0; frame < FRAMES; frame++) {
				game.step();
				search();
			}
		},
	});
	const works = [workOf(MOVING, () => {}), ...SYSTEMS.map((name) => workOf(name, () => systemNamed(name).findCollisions(game.agents)))];
	const times = await shortestTimes(works, ROUNDS, isWanted);
	if (!times) return null;
	const [moving, ...systems] = times;
	return Object.fromEntries(systems.map(({ name, ms }) => [name, Math.max(0.001, (ms - moving.ms) / FRAMES)]));
}

/**
 * Compares the pairs of all systems with those of a reference system, which is taken as right.
 *
 * @param {(name: string) => object} systemNamed gives the system with a name
 * @param {object[]} agents
 * @param {string} reference the reference system's name
 * @returns {{truth: Map, systems: Record<string, {hit: object[][], wrong: object[][], missed: object[][]}>}} pairs of agents
 */
export function compare(systemNamed, agents, reference) {
	const truth = pairsOf(systemNamed(reference), agents);
	const judged = SYSTEMS.filter((name) => name !== reference).map((name) => [name, judge(pairsOf(systemNamed(name), agents), truth)]);
	return { truth, systems: Object.fromEntries(judged) };
}
