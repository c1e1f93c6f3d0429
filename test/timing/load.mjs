#!/usr/bin/env node
/**
 * Notes the load of the machine before a timing run, and says so if it is too busy. Ends with status 64 if there is no such figure, or no
 * such older report.
 *
 *   node test/timing/load.mjs folder [figure,figure] [older-report.json]
 */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { refuse } from '../../build/refuse.mjs';
import { isBusy, load, machine } from './machine.mjs';
import { olderReportOrEnd } from './older.mjs';

const [folder, figures = '', older] = process.argv.slice(2);
const settings = readFileSync(new URL('../../src/evaluation/Settings.as', import.meta.url), 'utf8');
const known = /FIGURES:Array = \[([^\]]*)\]/.exec(settings)[1].match(/\w+/g);
const unknown = figures.split(',').find((each) => each && !known.includes(each));
if (unknown) refuse(`-Dfigures: there is no "${unknown}"; there are ${known}`);
olderReportOrEnd(older);
mkdirSync(folder, { recursive: true });
const start = load();
writeFileSync(path.join(folder, 'load.txt'), String(start));
const { cores } = machine();
console.log(`load of the machine: ${start}, on ${cores} cores${isBusy({ start, end: 0 }, cores) ? '. Something else is running: many times will be too noisy' : ''}`);
