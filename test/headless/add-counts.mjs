#!/usr/bin/env node
/**
 * Adds the counts of one run of tests to those of another.
 *
 *   node test/headless/add-counts.mjs counts.txt sum.txt
 *
 * Each file says "3 passed, 0 failed, 1 skipped". The second is written anew; if it is not there, it gets the counts of the first.
 * Without a first file the run failed before it counted anything: one more failed.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

const NONE = [0, 0, 0];

function countsIn(file, otherwise) {
	return existsSync(file) ? readFileSync(file, 'utf8').match(/\d+/g).map(Number) : otherwise;
}

const [added, sum] = process.argv.slice(2);
const more = countsIn(added, [0, 1, 0]);
const [passed, failed, skipped] = countsIn(sum, NONE).map((count, i) => count + more[i]);
mkdirSync(path.dirname(sum), { recursive: true });
writeFileSync(sum, `${passed} passed, ${failed} failed, ${skipped} skipped\n`);
