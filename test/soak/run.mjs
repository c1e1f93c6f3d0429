#!/usr/bin/env node
/**
 * Runs the soak on the ES module's code, in Node: what test/Soak.as does in a player.
 *
 *   node --expose-gc test/soak/run.mjs TESTS FRAMES
 *
 * TESTS is what the build made of the engine and the tests together.
 */
import path from "node:path";
import { pathToFileURL } from "node:url";

const CHECK_EVERY = 100;

const [file, frames] = process.argv.slice(2);
const { Event, SoakRun } = await import(pathToFileURL(path.resolve(file)));

console.log(`a soak in Node ${process.versions.node}, as an ES module`);
const run = new SoakRun(Number(frames), CHECK_EVERY);
await new Promise((resolve) => {
	run.addEventListener(Event.COMPLETE, resolve);
	run.start();
});
console.log(run.problem === "" ? "the soak is well" : `the soak FAILED: ${run.problem}`);
process.exitCode = run.problem === "" ? 0 : 1;
