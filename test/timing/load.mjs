#!/usr/bin/env node
/**
 * Notes the load of the machine before a timing run, and says so if it is too busy. Ends with status 64 if there is no
 * such older report.
 *
 *   node test/timing/load.mjs folder [older-report.json]
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { isBusy, load, machine } from './machine.mjs';
import { olderReportOrEnd } from './older.mjs';

const [folder, older] = process.argv.slice(2);
olderReportOrEnd(older);
mkdirSync(folder, { recursive: true });
const start = load();
writeFileSync(path.join(folder, 'load.txt'), String(start));
const { cores } = machine();
console.log(`load of the machine: ${start}, on ${cores} cores${isBusy({ start, end: 0 }, cores) ? '. Something else is running: many times will be too noisy' : ''}`);
