#!/usr/bin/env node
/**
 * Says how far an interrupted timing run was, and what makes its report; nothing if it had not begun to measure.
 *
 *   node test/timing/cut.mjs folder
 */
import { existsSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';

const [folder] = process.argv.slice(2);
const [results, start] = ['results.json', 'load.txt'].map((name) => path.join(folder, name));
// those of the last run may be there still
if (existsSync(start) && existsSync(results) && statSync(results).mtimeMs >= statSync(start).mtimeMs) {
	const { entries } = JSON.parse(readFileSync(results, 'utf8'));
	const last = entries.at(-1);
	if (last) {
		console.log(`The timing run was interrupted after ${entries.length} entries, the last of them of ${last.figure}, ${last.subject}.`);
		console.log(`\`node test/timing/report.mjs ${folder}\` makes a report of them.`);
	} else {
		console.log('The timing run was interrupted before its first entry.');
	}
}
