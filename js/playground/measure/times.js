/** Measures how long the frames of a game take, for each collision system and number of agents. Nothing here draws. */
import { Collision, CollisionBlocks } from "starlogo-collision";
import { HALF_WIDTH, ScatteredGame } from "../shared/scattered.js";
import { isUneven } from "../shared/timing.js";

/** The numbers of agents that are measured, in turn. */
export const COUNTS = [25, 50, 100, 200, 400, 800, 1600];
/** The usual number of agents in the scattered game. For other numbers the ground is wider or narrower in proportion. */
const USUAL = 150;
const WARM = 10;
/**
 * The fewest and the most samples, the least milliseconds of a sample, and the milliseconds after which no more samples are taken.
 * Browsers' clocks have steps of a tenth. Each sample has at least one frame.
 */
const [FEWEST, MOST_TIMES] = [5, 15];
const LEAST_MS = 6;
const ENOUGH_MS = 250;
/** The most frames of a sample, for a browser whose clock stands still. */
const MOST_FRAMES = 20000;
/** A system that takes longer for a frame is not measured with more agents. */
const TOO_LONG = 150;
/** The longest time, in milliseconds, that the page may stand still. */
const SLICE = 12;

/**
 * Measures all systems, beginning with few agents.
 *
 * @param {object} greatLand has the game's models
 * @param {number} most the largest number of agents
 * @param {(system: string, count: number, ms: number, isBusy: boolean) => void} onFound called with each result, in milliseconds per
 * frame, and whether something else may have taken time
 * @param {() => boolean} isWanted whether to go on
 */
export async function measureAll(greatLand, most, onFound, isWanted) {
	const slow = new Set();
	for (const count of COUNTS.filter((each) => each <= most)) {
		for (const system of CollisionBlocks.systemNames.filter((each) => !slow.has(each))) {
			const times = await timesOf(greatLand, system, count, isWanted);
			if (!isWanted()) return;
			const ms = Math.min(...times);
			onFound(system, count, ms, isUneven(times));
			if (ms > TOO_LONG) slow.add(system);
		}
	}
}

/** Samples of the milliseconds of a frame's collision detection. What else the machine does makes some longer, and none shorter. */
async function timesOf(greatLand, system, count, isWanted) {
	const game = new ScatteredGame(count, HALF_WIDTH * Math.sqrt(count / USUAL));
	const blocks = new CollisionBlocks(greatLand, game.agents);
	blocks.useCollisionSystem(system);
	let touching = 0;
	blocks.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, () => {
		touching++;
	});
	const times = [];
	let [spent, taken, frames, slice] = [0, 0, 0, performance.now()];
	for (let frame = 0; times.length < MOST_TIMES && frame < MOST_FRAMES; frame++) {
		game.step();
		const start = performance.now();
		blocks.collision.update(game.agents);
		const ms = performance.now() - start;
		spent += ms;
		if (frame >= WARM || ms > TOO_LONG) {
			taken += ms;
			frames++;
		}
		if (taken >= LEAST_MS) {
			times.push(taken / frames);
			[taken, frames] = [0, 0];
		}
		if (times.length >= FEWEST && spent > ENOUGH_MS) break;
		if (performance.now() - slice < SLICE) continue;
		await new Promise((resolve) => setTimeout(resolve));
		if (!isWanted()) return [];
		slice = performance.now();
	}
	return times.length > 0 ? times : [taken / frames];
}

/** Whether a value read from a file is a measurement of this page. */
export const isMeasured = (value) => typeof value?.machine === "string" && typeof value?.points === "object" && value.points !== null
	&& Object.values(value.points).every((points) => Array.isArray(points) && points.every((point) => Array.isArray(point) && point.length === 2 && point.every((each) => Number.isFinite(each) && each > 0)));
