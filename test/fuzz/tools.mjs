/** What the games and their kinds of calls share. */
import { engine } from "../module/engine.mjs";
import { randomNumbers } from "../module/random.mjs";

export { engine };

/** What numbers may be apart by rounding, as a part of them. */
export const HAIR = 1e-9;

/** Numbers from 0 to 1. The first ones of neighbouring seeds are alike, so they are left out. */
export function numbersOf(seed) {
	const random = randomNumbers(seed);
	for (let i = 0; i < 8; i++) random();
	return random;
}

/** What random calls are made with. */
export function toolsOf(random) {
	const integer = (count) => Math.floor(random() * count);
	return { random, integer, between: (low, high) => low + (high - low) * random(), pick: (from) => from[integer(from.length)] };
}
