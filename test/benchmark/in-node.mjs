#!/usr/bin/env node
/**
 * Runs the benchmarks on the ES module's code, in Node, as test/Benchmarks.as does in a player.
 *
 *   node test/benchmark/in-node.mjs TESTS NAME [/url=folder ...]
 *
 * TESTS is what the build made of the engine and the tests together. NAME is a part of the names of the benchmarks that are run.
 */
import path from "node:path";
import { pathToFileURL } from "node:url";
import { mount } from "../runner/fixtures.mjs";

const [file, wanted, ...mounts] = process.argv.slice(2);
const tests = await import(pathToFileURL(path.resolve(file)));
mount(tests, mounts);

const chosen = Object.keys(tests).filter((name) => name.endsWith("Benchmark") && name.includes(wanted));
console.log(chosen.length > 0 ? `in Node ${process.versions.node}` : `no benchmark has ${wanted} in its name`);
for (const name of chosen) {
	await new Promise((resolve) => tests.Fixtures.load(tests[name].FIXTURES ?? [], resolve));
	console.log(`${name}\n${new tests[name]().run()}`);
}
process.exitCode = chosen.length > 0 ? 0 : 1;
