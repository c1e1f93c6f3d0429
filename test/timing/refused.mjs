#!/usr/bin/env node
/**
 * Prints the entries that a report has left out, for a run that measures them again: each encoded as a part of an address, with semicolons
 * between them. Ends with status 64 if there is no such entry, or if a run of now can't join the report.
 *
 *   node test/timing/refused.mjs folder [figure,figure]
 */
import { existsSync } from 'node:fs';
import path from 'node:path';
import { refuse } from '../../build/refuse.mjs';
import { isLeftOut } from './figures.mjs';
import { versions } from './machine.mjs';
import { olderReport } from './older.mjs';
import { key } from './statistics.mjs';

const [folder, figures = ''] = process.argv.slice(2);
const file = path.join(folder, 'report.json');
if (!existsSync(file)) refuse(`-Drefused: there is no report ${file} yet; ./antw timing makes one`);
const report = olderReport(file);
const { commit } = versions();
if (report.versions?.commit !== commit) {
	refuse(`-Drefused: the report ${file} is of commit ${report.versions?.commit}, and this clone is at ${commit}; ./antw timing makes another`);
}
const left = report.entries.filter((entry) => isLeftOut(entry) && (figures === '' || figures.split(',').includes(entry.figure)));
if (left.length === 0) refuse(`-Drefused: the report ${file} lacks no number${figures && ` of ${figures}`}`);
console.log(left.map((entry) => encodeURIComponent(key(entry))).join(';'));
