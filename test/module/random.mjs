/** Random numbers for tests that need no module. */

/** Numbers from 0 to 1, the same on every run. */
export function randomNumbers(seed) {
	let state = seed;
	return () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 4294967296;
}
