#!/usr/bin/env node
/**
 * Checks the names of options (-Dname=value) of ./antw: a name that no build file reads is refused, with the nearest that one does.
 * After --no-target it says which target is nearest to one that Ant has not found.
 *
 *   node build/options.mjs NAME...
 *   node build/options.mjs --no-target TARGET
 *
 * Names with a dot may be Ant's own, so they pass. Ends with status 64 if a name is refused.
 */
import { readFileSync, readdirSync } from 'node:fs';
import { thereIs } from './nearest.mjs';

const files = ['build.xml', ...readdirSync('build').filter((file) => file.endsWith('.xml')).map((file) => `build/${file}`)];
const text = files.map((file) => readFileSync(file, 'utf8')).join('\n');
const found = (pattern) => [...text.matchAll(pattern)].map(([, name]) => name);
const read = new Set(found(/(?:\$\{|-D|\b(?:property|if|unless|if:set|unless:set)=")([\w-]+)/g));
// what the descriptions of the targets name, and what has a default
const offered = [...new Set(found(/(?:-D|<property name=")([a-z]+)\b(?=[=" .,;:)])/g))];

const [flag, target] = process.argv.slice(2);
if (flag === '--no-target') {
	console.error(`antw: there is no target ${target}${thereIs(target, found(/<target name="(\w[\w-]*)"/g))}`);
	process.exit(64);
}
for (const name of process.argv.slice(2)) {
	if (!name.includes('.') && !read.has(name)) {
		console.error(`antw: there is no option -D${name}${thereIs(name, offered, '-D')}`);
		process.exitCode = 64;
	}
}
