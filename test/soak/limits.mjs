#!/usr/bin/env node
/**
 * Measures what large and hostile model files cost on the ES module's code, in Node: what test/Limits.as does in a player.
 *
 *   node --expose-gc test/soak/limits.mjs TESTS [FILES] [SIZE]
 *
 * TESTS is what the build made of the engine and the tests together; FILES and SIZE are Limits.as's parameters.
 */
import path from "node:path";
import { pathToFileURL } from "node:url";

const [file, part = "", size = "1000000"] = process.argv.slice(2);
const { Event, HostileFiles, LargeFiles, LoadRun } = await import(pathToFileURL(path.resolve(file)));

const run = (names, make, prepareExact) => new Promise((resolve) => {
	const loads = new LoadRun(names.filter((name) => name.includes(part)), make, prepareExact);
	loads.addEventListener(Event.COMPLETE, resolve);
	loads.start();
});

console.log(`in Node ${process.versions.node}, as an ES module: large models, then with prepareExact, then hostile files`);
await run(LargeFiles.names, LargeFiles.make, false);
await run(LargeFiles.names, LargeFiles.make, true);
await run(HostileFiles.names, (name) => HostileFiles.make(name, Number(size)), false);
