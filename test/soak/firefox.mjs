#!/usr/bin/env node
/**
 * Runs the soak in Firefox, and looks from outside at what memory its processes have: all of it that is their own, and their part of what they share.
 *
 *   node test/soak/firefox.mjs TESTS FRAMES
 *
 * TESTS is what the build made of the engine and the tests together. Needs Linux, for its /proc.
 */
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { bundle, inBrowser } from "../same/browser.mjs";

const PATIENCE_MS = 4 * 3600000;
const LOOKS_MS = 2000;
const REPORT_EVERY = 30;

const [tests, frames] = process.argv.slice(2);
const firefox = process.env.FIREFOX ?? "/usr/bin/firefox-esr";
if (!existsSync(firefox)) {
	console.log(`a soak in Firefox: there is no ${firefox}`);
	process.exit();
}

/** What a file of a process says; null once it has ended. */
function read(pid, file) {
	try {
		return readFileSync(`/proc/${pid}/${file}`, "utf8");
	} catch {
		return null;
	}
}

/** The megabytes of a process and all that it has started. */
function megabytes(first) {
	const parents = new Map(readdirSync("/proc").filter((name) => /^\d+$/.test(name)).map((pid) => [Number(pid), Number(/\) \S (\d+)/.exec(read(pid, "stat"))?.[1])]));
	const isOf = (pid) => pid === first || (parents.has(pid) && isOf(parents.get(pid)));
	return [...parents.keys()].filter(isOf).reduce((sum, pid) => sum + Number(/^Pss:\s+(\d+)/m.exec(read(pid, "smaps_rollup"))?.[1] ?? 0) / 1024, 0);
}

const samples = [];
let looking = null;
const text = await inBrowser(firefox, await bundle(tests), frames, PATIENCE_MS, (pid) => {
	looking = setInterval(() => {
		samples.push(megabytes(pid));
		if (samples.length % REPORT_EVERY === 0) console.log(`  after ${samples.length * LOOKS_MS / 1000} s: ${samples.at(-1).toFixed(1)} MB`);
	}, LOOKS_MS);
});
clearInterval(looking);
// Firefox collects when it likes: the least of a quarter of the time is nearest to what is in use
const quarter = Math.ceil(samples.length / 4);
const least = [1, 2, 3].map((nth) => Math.min(...samples.slice(nth * quarter, (nth + 1) * quarter)).toFixed(1));
console.log(`${frames} frames in Firefox, all its processes: at least ${least.join(", ")} MB in the second, third and last quarter of the time, at most ${Math.max(...samples).toFixed(1)} MB\n${text}`);
process.exitCode = /FAILED/.test(text) ? 1 : 0;
