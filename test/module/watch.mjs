/**
 * Ends the process if a test does not end, and says which. Runs in a thread of its own, because a test that does not end leaves no time to its own.
 *
 * workerData: { now, text, seconds }, the first two of which share memory with the runner: the number of the test, and its name in bytes, after their count.
 */
import { writeSync } from "node:fs";
import { Worker, isMainThread, workerData } from "node:worker_threads";

const CHECK_MS = 1000;
const NAME_BYTES = 1000;

/**
 * Begins to watch.
 *
 * @param {number} seconds of a processor that a test may take
 * @returns {(name: string) => void} tells the name of the test that begins
 */
export function watch(seconds) {
	const now = new Int32Array(new SharedArrayBuffer(8));
	const text = new Uint8Array(new SharedArrayBuffer(NAME_BYTES));
	new Worker(new URL(import.meta.url), { workerData: { now, text, seconds } }).unref();
	return (name) => {
		now[1] = new TextEncoder().encodeInto(name, text).written;
		Atomics.add(now, 0, 1);
	};
}

if (!isMainThread && workerData?.now) {
	const { now, text, seconds } = workerData;
	const used = () => (process.cpuUsage().user + process.cpuUsage().system) / 1e6;
	let last = -1;
	let began = 0;
	setInterval(() => {
		const number = Atomics.load(now, 0);
		if (number !== last) {
			last = number;
			began = used();
		} else if (number > 0 && used() - began > seconds) {
			writeSync(1, `FAILED ${new TextDecoder().decode(text.slice(0, now[1]))}: it has not ended in ${seconds} s of a processor\n`);
			process.kill(process.pid, "SIGKILL");
		}
	}, CHECK_MS);
}
