#!/usr/bin/env node
/**
 * Random games until one fails: test/fuzz/game.mjs.
 *
 *   node test/fuzz/run.mjs MINUTES [SEED]
 *
 * A list of calls that fails is made shorter as long as it fails in the same way, and printed as a line for found.test.mjs.
 */
import { randomNumbers } from "../module/games.mjs";
import { problemOf, randomCall } from "./game.mjs";

const CALLS = 120;

const [minutes = "10", seed = String(Date.now() % 1e9)] = process.argv.slice(2);
const end = performance.now() + 60000 * Number(minutes);

/** The same wrong, whatever the numbers in it are. */
const kindOf = (problem) => problem?.replace(/[-\d.e+]+/g, "").slice(0, 24);

function shrink(calls) {
	const kind = kindOf(problemOf(calls));
	for (let size = calls.length >> 1; size > 0; size = size > 1 ? size >> 1 : 0) {
		for (let from = calls.length - size; from >= 0; from = Math.min(from - 1, calls.length - size)) {
			const fewer = [...calls.slice(0, from), ...calls.slice(from + size)];
			if (kindOf(problemOf(fewer)) === kind) calls = fewer;
		}
	}
	return calls;
}

let games = 0;
const kinds = new Map();
console.log(`random games for ${minutes} minutes, from seed ${seed} on`);
for (let each = Number(seed); performance.now() < end; each++) {
	const random = randomNumbers(each);
	for (let i = 0; i < 8; i++) random();
	const calls = Array.from({ length: CALLS }, () => randomCall(random));
	games++;
	const problem = problemOf(calls);
	if (problem === null) continue;
	const kind = kindOf(problem);
	kinds.set(kind, (kinds.get(kind) ?? 0) + 1);
	if (kinds.get(kind) > 1) continue;
	const fewest = shrink(calls);
	console.log(`\nseed ${each}: ${problemOf(fewest)}\n${JSON.stringify(fewest).replaceAll("],[", "],\n\t[")},`);
}
console.log(`\n${games} games of ${CALLS} calls: ${kinds.size === 0 ? "nothing found" : [...kinds].map(([kind, count]) => `"${kind}" ${count} times`).join(", ")}`);
process.exitCode = kinds.size === 0 ? 0 : 1;
