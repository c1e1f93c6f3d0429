#!/usr/bin/env node
/**
 * Runs the thesis's evaluation on the ES module's code, in Node: what src/Timing.as does in a player, without its pictures.
 *
 *   node test/timing/in-node.mjs TESTS FOLDER [name=value ...]
 *
 * TESTS is what the build made of the engine and the tests together; FOLDER gets results.json. The names are Settings' own. report.mjs says
 * whether the collisions are right.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { mount } from "../runner/fixtures.mjs";

const [file, folder, ...given] = process.argv.slice(2);
const tests = await import(pathToFileURL(path.resolve(file)));
const { ModelFiles, Plan, Results, Settings, TaskQueue } = tests;

mount(tests, ["/assets=assets"]);

const settings = new Settings(Object.fromEntries(given.map((each) => each.split(/=(.*)/s))));
// the monitor draws on Flash's stage
settings.figures = settings.figures.filter((figure) => figure !== "monitor");
const files = await new Promise((resolve, reject) => {
	const loaded = new ModelFiles(() => resolve(loaded), (text) => reject(new Error(text)), false);
});
const results = new Results();
results.settings = settings.described;
const queue = new TaskQueue(new Plan(settings, files, results, null).tasks);
console.log("the same as an ES module, in Node:");
while (!queue.work());
mkdirSync(folder, { recursive: true });
writeFileSync(path.join(folder, "results.json"), results.toText());
