#!/usr/bin/env node
/**
 * Runs the tests that need no player (every *.test.mjs below test/), and writes their counts. Prints what a failed one says. Exit
 * status: 1 if one failed.
 *
 *   node test/runner/node-tests.mjs bin/test-reports/summary-node.txt node | structure | pages | samples
 *
 * With "structure" those of test/structure, and otherwise all others. With "samples" the documentation's samples in JavaScript, of the
 * pages that OF names. With "pages" those alone that open pages, in the browser that TEST_BROWSER names; where that is not installed
 * they are skipped, and counted.
 *
 * Each file has a process of its own, but those that open pages: a few processes have a share of them each, with one browser, whose
 * pages they use one after the other.
 */
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { SAMPLES_IN_JAVASCRIPT } from '../docs/samples.mjs';
import { failuresIn, saidOf } from './failures.mjs';
import { missing } from '../../build/headless/browsers.mjs';
import { filesBelow, root } from '../structure/sources.mjs';

/** A count of the runner's closing lines: "# pass 12" or, in later versions of Node, "ℹ pass 12". */
function count(output, name) {
	return Number(new RegExp(`^\\S ${name} (\\d+)$`, 'm').exec(output)?.[1] ?? 0);
}

/** What a file of tests that opens pages begins with. */
const IMPORT_OF_BROWSER = /\bimport \{[^}]*\b(begin|launch(?:Own)?)\b[^}]*\} from ['"][./\w-]*\/browsers?\.mjs['"]/;

const opensPages = (file) => IMPORT_OF_BROWSER.test(readFileSync(file, 'utf8'));

/**
 * So many processes open pages at once: one more than there are processors, as pages wait now and then. One process more runs the other
 * tests meanwhile.
 */
const AT_ONCE = availableParallelism() + 1;

/** Files that import a share of the tests each, so that all shares are of the same size. */
function sharesOf(tests) {
	const out = path.join(root, 'bin/generated/pages');
	mkdirSync(out, { recursive: true });
	const shares = Array.from({ length: AT_ONCE }, (_, i) => ({ file: path.join(out, `share-${i + 1}.test.mjs`), size: 0, lines: [] }));
	for (const test of tests) {
		const share = shares.reduce((least, each) => (each.size < least.size ? each : least));
		share.size += statSync(test).size;
		share.lines.push(`import ${JSON.stringify(pathToFileURL(test).href)};\n`);
	}
	for (const { file, lines } of shares) writeFileSync(file, lines.join(''));
	return shares.filter(({ lines }) => lines.length > 0).map(({ file }) => file);
}

const [summary, which] = process.argv.slice(2);
const isOfStructure = (file) => file.startsWith('test/structure/');
const isWanted = (file) => (which === 'samples' ? file === SAMPLES_IN_JAVASCRIPT : isOfStructure(file) === (which === 'structure'));
const tests = filesBelow('test', '.test.mjs').filter(isWanted).map((file) => path.join(root, file)).sort((a, b) => statSync(b).size - statSync(a).size);
const pages = tests.filter(opensPages);
// what opens pages takes longest, and begins first
const files = [...sharesOf(pages), ...which === 'pages' ? [] : tests.filter((file) => !pages.includes(file))];
if (which === 'pages' && missing) {
	console.log(`tests of pages: ${missing}`);
	writeFileSync(summary, `0 passed, 0 failed, ${pages.length} skipped\n`);
	process.exit();
}
const flags = ['--test', '--test-reporter=tap', `--test-concurrency=${AT_ONCE + 1}`];
const run = spawnSync(process.execPath, [...flags, ...files], { encoding: 'utf8', maxBuffer: 1e9 });
const passed = count(run.stdout, 'pass');
const failed = Math.max(count(run.stdout, 'fail'), run.status === 0 && passed > 0 ? 0 : 1);
if (failed > 0) {
	console.log(saidOf(run.stdout) + run.stderr);
	// as of all other tests: antw says them last, and those of test/structure whole
	for (const name of failuresIn(run.stdout)) console.log(`FAILED ${which === 'structure' ? 'test/structure: ' : ''}${name}`);
}
const counts = `${passed} passed, ${failed} failed, ${count(run.stdout, 'skipped')} skipped`;
console.log(`tests without a player${{ structure: ' (test/structure)', samples: ' (samples in JavaScript)' }[which] ?? ''}: ${counts}`);
writeFileSync(summary, `${counts}\n`);
process.exitCode = failed > 0 ? 1 : 0;
