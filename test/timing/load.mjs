#!/usr/bin/env node
/**
 * Notes the load of the machine before a timing run, and says so if it is too busy, or was in the older report's run. Ends with
 * status 64 if there is no such older report.
 *
 *   node test/timing/load.mjs folder [older-report.json]
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { isBusy, load, machine, wasBusy } from './machine.mjs';
import { olderReportOrEnd } from './older.mjs';

const [folder, file] = process.argv.slice(2);
const older = olderReportOrEnd(file);
mkdirSync(folder, { recursive: true });
const start = load();
writeFileSync(path.join(folder, 'load.txt'), String(start));
const { cores } = machine();
console.log(`load of the machine: ${start}, on ${cores} cores${isBusy({ start, end: 0 }, cores) ? '. Something else is running: many times will be too noisy' : ''}`);
if (older && wasBusy(older)) console.log(`Nothing will be compared with ${file}: in its run more programs ran than the machine has cores.`);
