/** Plays what pupils have handed in, to see which lessons it does. */
import { LESSONS } from "../play/builtin/library.js";
import "../play/game/lateengine.js";
import { landFor } from "../play/screen/pictures.js";
import { World } from "../play/game/world.js";

/** A lesson is done within so many frames. */
const LONGEST = 1900;
/** The longest time, in milliseconds, that the page may stand still. */
const SLICE = 12;

/** The programs that may do a lesson: the one that did it, and all that were made from it. */
function* candidates({ programs, solutions }, name) {
	const solution = solutions[name];
	if (solution) yield solution.blocks ? solution : { ...LESSONS[name].program, ...solution };
	for (const { lesson, program } of programs) if (lesson === name) yield program;
}

/**
 * The lessons that a pupil's programs do; null if models of the pupil's own cannot be read, because no program is played then. Fails if the
 * page's own models cannot be loaded.
 *
 * @param {object} work
 * @param {() => boolean} isWanted whether to go on
 * @returns {Promise<Set<string>|null>}
 */
export async function solvedBy(work, isWanted) {
	const solved = new Set();
	await landFor();
	const { greatLand } = await landFor(work.models).catch(() => ({}));
	if (!greatLand) return null;
	let begun = performance.now();
	for (const name of Object.keys(LESSONS)) {
		for (const program of candidates(work, name)) {
			if (solved.has(name)) break;
			const world = new World(greatLand);
			const memory = {};
			try {
				world.begin(program);
				for (let frame = 0; frame < LONGEST && !world.ended && !solved.has(name); frame++) {
					world.step();
					if (LESSONS[name].isDone(world, memory)) solved.add(name);
					if (performance.now() - begun < SLICE) continue;
					await new Promise((resolve) => setTimeout(resolve));
					if (!isWanted()) return solved;
					begun = performance.now();
				}
			} catch {
				// a program that fails does no lesson
			}
		}
	}
	return solved;
}
