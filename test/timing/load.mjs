#!/usr/bin/env node
/**
 * Notes the load of the machine before a timing run, and says so if it is too busy.
 *
 *   node test/timing/load.mjs folder
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { load, machine } from './machine.mjs';

const [folder] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
writeFileSync(path.join(folder, 'load.txt'), String(load()));
const { cores } = machine();
console.log(`load of the machine: ${load()}, on ${cores} cores${load() > cores / 2 ? '. Something else is running: many times will be too noisy' : ''}`);
