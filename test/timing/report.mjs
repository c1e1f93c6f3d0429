#!/usr/bin/env node
/**
 * Makes the report of a timing run: prints its tables, and writes report.json, report.csv and report.html.
 *
 *   node test/timing/report.mjs folder [older-report.json]
 *
 * The folder has the results.json of the run; docs/timing-report.md describes report.json. With an older report, what
 * became faster or slower since then is printed.
 */
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { comparison, tables } from './console.mjs';
import { csv } from './csv.mjs';
import { growth } from './figures.mjs';
import { machine, versions } from './machine.mjs';
import { page } from './page.mjs';
import { changes } from './statistics.mjs';

const [folder, olderFile] = process.argv.slice(2);
if (!folder) {
	console.error('usage: report.mjs folder [older-report.json]');
	process.exit(64);
}
const results = JSON.parse(await readFile(path.join(folder, 'results.json'), 'utf8'));
// first: the older report may be the one that is about to be replaced
const older = olderFile ? JSON.parse(await readFile(olderFile, 'utf8')) : undefined;
const report = {
	schema: 1,
	created: new Date().toISOString(),
	machine: machine(),
	versions: versions(results.player),
	exponents: growth(results.entries.filter((entry) => entry.figure === 'scattered')),
	entries: results.entries,
};
const file = (name) => path.join(folder, name);
await writeFile(file('report.json'), JSON.stringify(report, null, 1) + '\n');
await writeFile(file('report.csv'), csv(report.entries));
await writeFile(file('report.html'), await page(report));
const text = tables(report.entries);
await writeFile(file('timing.txt'), text + '\n');
console.log(`\n${text}\n`);
console.log('Times are medians ± half the range of the repetitions, without the fastest and the slowest fifth.');
if (older) {
	console.log('\n' + comparison(changes(older.entries, report.entries), older.created.slice(0, 16).replace('T', ' ')));
}
console.log(`\nThe report: ${file('report.html')}`);
