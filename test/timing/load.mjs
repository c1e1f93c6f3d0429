#!/usr/bin/env node
/**
 * Notes the load of the machine before a timing run, and says so if it is too busy. Ends with status 64 if there is no such older report.
 *
 *   node test/timing/load.mjs folder [older-report.json]
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { load, machine } from './machine.mjs';
import { olderReport } from './older.mjs';

const [folder, older] = process.argv.slice(2);
try {
	if (older) {
		olderReport(older);
	}
} catch (error) {
	console.error(error.message);
	process.exit(64);
}
mkdirSync(folder, { recursive: true });
writeFileSync(path.join(folder, 'load.txt'), String(load()));
const { cores } = machine();
console.log(`load of the machine: ${load()}, on ${cores} cores${load() > cores / 2 ? '. Something else is running: many times will be too noisy' : ''}`);
