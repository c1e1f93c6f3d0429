/**
 * Ends the process if a test does not end, and says which. Runs in a thread of its own, because a test that does not end leaves no time
 * to its own.
 *
 * workerData: { now, text, seconds, summary }. now and text share memory with the runner. now has the number of the test, the bytes of
 * its name, and how many passed, failed and were skipped before it. text has its name.
 */
import { mkdirSync, writeFileSync, writeSync } from "node:fs";
import path from "node:path";
import { Worker, isMainThread, workerData } from "node:worker_threads";

const CHECK_MS = 1000;
const NAME_BYTES = 1000;

/**
 * Begins to watch.
 *
 * @param {number} seconds of a processor that a test may take
 * @param {string | undefined} summary the file that gets the counts if a test does not end
 * @returns {(name: string, ...counts: number[]) => void} tells the name of the test that begins, and how many passed, failed and were
 *     skipped before
 */
export function watch(seconds, summary) {
	const now = new Int32Array(new SharedArrayBuffer(5 * Int32Array.BYTES_PER_ELEMENT));
	const text = new Uint8Array(new SharedArrayBuffer(NAME_BYTES));
	new Worker(new URL(import.meta.url), { workerData: { now, text, seconds, summary } }).unref();
	return (name, ...counts) => {
		now[1] = new TextEncoder().encodeInto(name, text).written;
		now.set(counts, 2);
		Atomics.add(now, 0, 1);
	};
}

/** Writes the counts of a run for the sum of all, if a file is named. */
export function writeSummary(file, passed, failed, skipped) {
	if (file === undefined) return;
	mkdirSync(path.dirname(file), { recursive: true });
	writeFileSync(file, `${passed} passed, ${failed} failed, ${skipped} skipped\n`);
}

if (!isMainThread && workerData?.now) {
	const { now, text, seconds, summary } = workerData;
	const used = () => (process.cpuUsage().user + process.cpuUsage().system) / 1e6;
	let last = -1;
	let began = 0;
	setInterval(() => {
		const number = Atomics.load(now, 0);
		if (number !== last) {
			last = number;
			began = used();
			return;
		}
		const [, bytes, passed, failed, skipped] = now;
		if (number === 0 || used() - began <= seconds) return;
		const name = new TextDecoder().decode(text.slice(0, bytes));
		writeSync(1, `FAILED ${name}: it has not ended in ${seconds} s of a processor\n`);
		writeSummary(summary, passed, failed + 1, skipped);
		process.kill(process.pid, "SIGKILL");
	}, CHECK_MS);
}
