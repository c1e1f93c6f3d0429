#!/usr/bin/env node
/**
 * Random games until the time is over: test/fuzz/game.mjs. If the variable MESHES names a folder, a walker goes through one of its levels after each game:
 * test/fuzz/meshes.mjs.
 *
 *   node test/fuzz/run.mjs MINUTES [SEED] [none|CHECK,CHECK...]
 *
 * A list of calls that fails is made shorter as long as it fails in the same way, and printed as a line for found.test.mjs. The third argument has the
 * checks that are left out, in place of those of open.mjs. The games run in a thread of their own, so that a call that does not end is named too.
 */
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";

/** No call takes as many seconds of the processor. A busy machine gives it few of them. */
const LONGEST_CALL = 30;

const seconds = () => process.cpuUsage().user / 1e6;

/** The same wrong, whatever the numbers in it are. */
const kindOf = (problem) => problem?.split(":")[0].replace(/-?\d[\d.e+-]*/g, "").slice(0, 40);

const linesOf = (calls) => `${JSON.stringify(calls, (_, value) => (value === Infinity ? "Infinity" : value)).replaceAll("\"Infinity\"", "Infinity").replaceAll("],[", "],\n\t[")},`;

function shrink(calls, problemOf) {
	const kind = kindOf(problemOf(calls));
	for (let size = calls.length >> 1; size > 0; size = size > 1 ? size >> 1 : 0) {
		for (let from = calls.length - size; from >= 0; from = Math.min(from - 1, calls.length - size)) {
			const fewer = [...calls.slice(0, from), ...calls.slice(from + size)];
			if (kindOf(problemOf(fewer)) === kind) calls = fewer;
		}
	}
	return calls;
}

async function play({ seed, end, left, state, found }) {
	const { problemOf } = await import("./game.mjs");
	const { gameOf } = await import("./random.mjs");
	const { OPEN } = await import("./open.mjs");
	const { levelsIn, walkMeshes } = await import("./meshes.mjs");
	const levels = process.env.MESHES ? levelsIn(process.env.MESHES) : [];
	if (left !== undefined) OPEN.clear();
	for (const check of (left ?? "none").split(",")) OPEN.add(check.trim());
	const watched = (calls) => problemOf(calls, (i) => { state[1] = i; Atomics.add(state, 2, 1); });
	const count = (kind, text) => {
		found.set(kind, (found.get(kind) ?? 0) + 1);
		if (found.get(kind) === 1) parentPort.postMessage({ text: text() });
		parentPort.postMessage({ kind });
	};
	for (let each = seed; Date.now() < end; each++) {
		state[0] = each;
		if (levels.length > 0) {
			const { through, stuck, afloat } = walkMeshes(levels, 1, each);
			for (const [kind, texts] of Object.entries({ through, stuck, afloat })) for (const text of texts) count(kind, () => `\n${kind}: ${text}`);
			Atomics.add(state, 2, 1);
		}
		const calls = gameOf(each);
		state[3]++;
		const problem = watched(calls);
		if (problem === null) continue;
		count(kindOf(problem), () => {
			const fewest = shrink(calls, watched);
			return `\nseed ${each}: ${watched(fewest)}\n${linesOf(fewest)}`;
		});
	}
}

async function main() {
	const [minutes = "10", from = String(Date.now() % 1e9), left] = process.argv.slice(2);
	const end = Date.now() + 60000 * Number(minutes);
	const state = new Int32Array(new SharedArrayBuffer(16));
	const found = new Map();
	const count = (kind) => found.set(kind, (found.get(kind) ?? 0) + 1);
	console.log(`random games for ${minutes} minutes, from seed ${from} on`);
	let seed = Number(from);
	while (Date.now() < end) {
		const worker = new Worker(new URL(import.meta.url), { workerData: { seed, end, left, state, found } });
		worker.on("message", ({ kind, text }) => (text ? console.log(text) : count(kind)));
		let calls = -1;
		let since = seconds();
		const isHanging = await new Promise((resolve, reject) => {
			const clock = setInterval(() => {
				if (calls !== state[2]) [calls, since] = [state[2], seconds()];
				else if (seconds() - since > LONGEST_CALL) resolve(true);
			}, 1000);
			worker.on("exit", () => resolve(false));
			worker.on("error", reject);
			worker.on("exit", () => clearInterval(clock));
		});
		if (!isHanging) break;
		await worker.terminate();
		console.log(`\nseed ${state[0]}: call ${state[1]} does not end`);
		count("does not end");
		seed = state[0] + 1;
	}
	console.log(`\n${state[3]} games: ${found.size === 0 ? "nothing found" : [...found].map(([kind, times]) => `"${kind}" ${times} times`).join(", ")}`);
	process.exitCode = found.size === 0 ? 0 : 1;
}

await (isMainThread ? main() : play(workerData));
