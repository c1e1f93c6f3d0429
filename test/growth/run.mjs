#!/usr/bin/env node
/**
 * Measures how costs grow, on the ES module's code, in Node: what test/Growth.as does in a player.
 *
 *   node test/growth/run.mjs TESTS [ROWS]
 *
 * TESTS is what the build made of the engine and the tests together. ROWS is a part of the names of rows. Each row has a process of its
 * own, because a process tells the most memory that it has ever had, and because a row may use up all of it. A row has PATIENCE_MS.
 */
import { spawnSync } from "node:child_process";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const PATIENCE_MS = Number(process.env.PATIENCE ?? 180000);
const OPTIONS = ["--expose-gc", "--max-semi-space-size=4", "--max-old-space-size=3000"];

const [file, part = "", only = ""] = process.argv.slice(2);
const { Event, GrowthRows, GrowthRun } = await import(pathToFileURL(path.resolve(file)));

process.exitCode = only === "" ? runAll() : await runOne();

/** Measures a row in this process. */
async function runOne() {
	const run = new GrowthRun(GrowthRows.all.filter((row) => row.name === only));
	await new Promise((resolve) => {
		run.addEventListener(Event.COMPLETE, resolve);
		run.start();
	});
	return run.failures.length === 0 ? 0 : 1;
}

/** Measures each row in a process of its own. */
function runAll() {
	console.log(`in Node ${process.versions.node}, as an ES module\n${GrowthRun.head}`);
	const rows = GrowthRows.named(part);
	const failures = rows.filter((row) => {
		const { status, signal, error } = spawnSync(process.execPath, [...OPTIONS, fileURLToPath(import.meta.url), file, part, row.name],
			{ stdio: ["ignore", "inherit", "ignore"], timeout: PATIENCE_MS });
		if (status !== 0 && status !== 1) console.log(`| ${row.name} | | | | | | FAILS: ${error?.code ?? signal ?? `status ${status}`} |`);
		return status !== 0;
	}).map((row) => row.name);
	console.log(failures.length === 0 ? `nothing of ${rows.length} grows too fast` : `${failures.length} of ${rows.length} grow too fast: ${failures.join("; ")}`);
	return rows.length > 0 && failures.length === 0 ? 0 : 1;
}
