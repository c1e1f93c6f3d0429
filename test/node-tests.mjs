#!/usr/bin/env node
/**
 * Runs the tests that need no player (every *.test.mjs below test/), and adds their counts to those of the tests that ran in
 * one. Prints what a failed one says. Exit status: 1 if one failed.
 *
 *   node test/node-tests.mjs bin/test-reports/summary.txt
 */
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = path.dirname(fileURLToPath(import.meta.url));

function testsBelow(parent) {
	return readdirSync(parent, { withFileTypes: true }).flatMap((entry) => {
		const child = path.join(parent, entry.name);
		return entry.isDirectory() ? testsBelow(child) : entry.name.endsWith('.test.mjs') ? [child] : [];
	});
}

/** A count of the runner's closing lines: "# pass 12" or, in later versions of Node, "ℹ pass 12". */
function count(output, name) {
	return Number(new RegExp(`^\\S ${name} (\\d+)$`, 'm').exec(output)?.[1] ?? 0);
}

const [summary] = process.argv.slice(2);
const run = spawnSync(process.execPath, ['--test', ...testsBelow(folder).sort()], { encoding: 'utf8' });
const passed = count(run.stdout, 'pass');
const failed = Math.max(count(run.stdout, 'fail'), run.status === 0 && passed > 0 ? 0 : 1);
if (failed > 0) {
	console.log(run.stdout + run.stderr);
}
console.log(`tests without a player: ${passed} passed, ${failed} failed`);
const [played, playedFailed, skipped] = readFileSync(summary, 'utf8').match(/\d+/g).map(Number);
writeFileSync(summary, `${played + passed} passed, ${playedFailed + failed} failed, ${skipped} skipped\n`);
process.exitCode = failed > 0 ? 1 : 0;
