#!/usr/bin/env node
/**
 * Runs the tests that need no player (every *.test.mjs below test/), and writes their counts. Prints what a failed one says. Exit
 * status: 1 if one failed.
 *
 *   node test/node-tests.mjs bin/test-reports/summary-node.txt [pages]
 *
 * With "pages" those alone that open pages, in the browser that TEST_BROWSER names; where that is not installed they are skipped, and counted.
 */
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { missing } from './headless/browsers.mjs';

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

const opensPages = (file) => /\/browsers?\.mjs['"]/.test(readFileSync(file, 'utf8'));

const [summary, which] = process.argv.slice(2);
// what opens pages takes longest, the longer files before the others: then no long one is left alone at the end
const weight = (file) => statSync(file).size + (opensPages(file) ? 1e9 : 0);
const files = testsBelow(folder).sort((a, b) => weight(b) - weight(a)).filter((file) => which !== 'pages' || opensPages(file));
if (which === 'pages' && missing) {
	console.log(`tests of pages: ${missing}`);
	writeFileSync(summary, `0 passed, 0 failed, ${files.length} skipped\n`);
	process.exit();
}
// one file more at once than there are processors: pages wait now and then
const run = spawnSync(process.execPath, ['--test', `--test-concurrency=${availableParallelism() + 1}`, ...files], { encoding: 'utf8', maxBuffer: 1e9 });
const passed = count(run.stdout, 'pass');
const failed = Math.max(count(run.stdout, 'fail'), run.status === 0 && passed > 0 ? 0 : 1);
if (failed > 0) {
	console.log(run.stdout + run.stderr);
}
const counts = `${passed} passed, ${failed} failed, ${count(run.stdout, 'skipped')} skipped`;
console.log(`tests without a player: ${counts}`);
writeFileSync(summary, `${counts}\n`);
process.exitCode = failed > 0 ? 1 : 0;
