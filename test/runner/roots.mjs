#!/usr/bin/env node
/**
 * Writes the compiler's main class for the tests that Node runs: it names their classes and those of the module. Notes the sources for
 * changed.mjs.
 *
 * node test/runner/roots.mjs FOLDER
 */
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { ROOT, moduleRoots } from "../../js/module/names.mjs";
import { writeRoots } from "../../js/module/roots.mjs";
import { qnameOf } from "../../js/module/signatures.mjs";
import { needsPlayer } from "./not-here.mjs";
import { readSources } from "./outdated.mjs";

const TESTS = join(ROOT, "test");

/** What only the runners of tests and benchmarks use. */
const OF_RUNNERS = ["evaluation.ModelFiles", "evaluation.Plan", "evaluation.TaskQueue", "support.Effort", "support.Fixtures"];

/** The classes of the module, the tests and benchmarks that Node runs, and what their runners use. */
export function testRoots() {
	const files = readdirSync(TESTS, { recursive: true }).sort();
	const tests = files.filter((file) => file.endsWith("Test.as") && !needsPlayer(readFileSync(join(TESTS, file), "utf8")));
	const benchmarks = files.filter((file) => file.endsWith("Benchmark.as"));
	return [...moduleRoots(), ...[...tests, ...benchmarks].map(qnameOf), ...OF_RUNNERS];
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	writeRoots(process.argv[2], testRoots());
	writeFileSync(join(process.argv[2], "sources.json"), JSON.stringify(readSources()));
}
