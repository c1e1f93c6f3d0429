/** How much is left to the garbage collector: needs node --expose-gc, and a young generation that has room for all that a round leaves. */
import { execFileSync } from "node:child_process";
import path from "node:path";
import { fileURLToPath } from "node:url";
import v8 from "node:v8";

/** Bytes that each of some calls leaves, in the best of several rounds: in others the compiler has worked too. The first round that leaves few is the last. */
export function garbageOf(call, { warm = 100, calls = 50, rounds = 5, few = 1024 } = {}) {
	for (let i = 0; i < warm; i++) call();
	let least = Infinity;
	for (let round = 0; round < rounds && least > few; round++) {
		globalThis.gc();
		const before = v8.getHeapStatistics().used_heap_size;
		for (let i = 0; i < calls; i++) call();
		least = Math.min(least, (v8.getHeapStatistics().used_heap_size - before) / calls);
	}
	return Math.round(least);
}

/** What a script of this folder prints as JSON, measured in a process of its own. */
export function measure(script, ...options) {
	const file = path.join(path.dirname(fileURLToPath(import.meta.url)), script);
	// compiled and collected when it is due, however busy the processors are
	const flags = ["--expose-gc", "--min-semi-space-size=64", "--max-semi-space-size=64", "--single-threaded"];
	return JSON.parse(execFileSync(process.execPath, [...flags, file, ...options], { encoding: "utf8" }));
}
