/** How long frames of a game take, by collision systems and numbers of agents. Nothing here draws. */
import { Collision, CollisionBlocks } from "starlogo-collision";
import { HALF_WIDTH, ScatteredGame } from "../compare/game.js";

/** The numbers of agents that are measured, in turn. */
export const COUNTS = [25, 50, 100, 200, 400, 800, 1600];
/** The number that the scattered game is made for: with others the ground is as much wider or narrower. */
const USUAL = 150;
const WARM = 10;
/** How many times are taken, and of how many milliseconds at least, since browsers' clocks go in steps of a tenth; each is of one frame or more. */
const [FEWEST, MOST_TIMES] = [5, 15];
const LEAST_MS = 6;
const ENOUGH_MS = 250;
/** How many frames a browser is asked for whose clock stands still. */
const MOST_FRAMES = 20000;
/** A system that takes longer for a frame is not asked about more agents. */
const TOO_LONG = 150;
/** How long the page may stand still. */
const SLICE = 12;

/**
 * Measures all systems, with few agents first.
 *
 * @param {object} greatLand has the game's models
 * @param {number} most the largest number of agents
 * @param {(system: string, count: number, ms: number) => void} onFound called with each result: what a frame takes
 * @param {() => boolean} isWanted whether it goes on
 */
export async function measureAll(greatLand, most, onFound, isWanted) {
	const slow = new Set();
	for (const count of COUNTS.filter((each) => each <= most)) {
		for (const system of CollisionBlocks.systemNames.filter((each) => !slow.has(each))) {
			const ms = await timeOf(greatLand, system, count, isWanted);
			if (!isWanted()) return;
			onFound(system, count, ms);
			if (ms > TOO_LONG) slow.add(system);
		}
	}
}

/** What a frame's collision detection takes, in milliseconds: the middle one of some times. */
async function timeOf(greatLand, system, count, isWanted) {
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
		if (!isWanted()) return NaN;
		slice = performance.now();
	}
	return times.length > 0 ? times.sort((a, b) => a - b)[times.length >> 1] : taken / frames;
}

/** Whether something read from outside is what this page has measured. */
export const isMeasured = (value) => typeof value?.machine === "string" && typeof value?.points === "object" && value.points !== null
	&& Object.values(value.points).every((points) => Array.isArray(points) && points.every((point) => Array.isArray(point) && point.length === 2 && point.every((each) => Number.isFinite(each) && each > 0)));
