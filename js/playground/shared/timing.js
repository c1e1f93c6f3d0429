/** Measures how long works take. Nothing here draws. */

/** Samples take at least this long, because the browser's clock is coarse. */
const SAMPLE_MS = 2;
/** No work is repeated any more after it has taken this long in all, but it is done twice at least. */
const MOST_MS = 600;

/**
 * Does all works round after round, and finds the shortest time of each. In the first rounds the browser compiles what they share, so none
 * of them pays for it.
 *
 * @param {{name: string, run: () => any}[]} works
 * @param {{warm: number, counted: number}} rounds the numbers of the first rounds, which count for nothing, and of those that count
 * @param {() => boolean} isWanted whether to go on
 * @returns {Promise<object[]|null>} each work's name, the result of its first run, its number of runs and its milliseconds; null if it is not
 * wanted any more
 */
export async function shortestTimes(works, { warm, counted }, isWanted) {
	const times = works.map(({ name }) => ({ name, result: undefined, runs: 0, ms: Infinity, spent: 0 }));
	for (let round = 0; round < warm + counted; round++) {
		for (const [i, { run }] of works.entries()) {
			const time = times[i];
			if (time.runs >= 2 && time.spent > MOST_MS) continue;
			const { ms, runs, result } = sample(run);
			time.result ??= result;
			time.runs += runs;
			time.spent += ms * runs;
			// a work that is too slow for more rounds has the time of its second run
			if (round >= warm || (round > 0 && time.spent > MOST_MS)) time.ms = Math.min(time.ms, ms);
			await drawing();
			if (!isWanted()) return null;
		}
	}
	return times;
}

/** Does a work as often as the clock needs. Gives the result of the first run, the number of runs, and the milliseconds of one. */
function sample(run) {
	const start = performance.now();
	const result = run();
	let runs = 1;
	let ms = performance.now() - start;
	for (; ms < SAMPLE_MS; runs++) {
		run();
		ms = performance.now() - start;
	}
	return { result, runs, ms: ms / runs };
}

/** Lets the browser draw. */
const drawing = () => new Promise((resolve) => setTimeout(resolve));

/** Whether times of the same work differ so much that something else has taken time. */
export const isUneven = (times) => times.length >= 4 && median(times) > 1.5 * Math.min(...times);

/** The middle one of some numbers; NaN if there is none. */
export const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;
