#!/usr/bin/env node
/**
 * Checks the names of options (-Dname=value) of ./antw: a name that no build file reads is refused, with the nearest that one does.
 *
 *   node build/options.mjs NAME...
 *
 * Names with a dot may be Ant's own, so they pass. Ends with status 64 if a name is refused.
 */
import { readFileSync, readdirSync } from 'node:fs';
import { $changesBetween } from '../js/standins/module/warnings.mjs';

const files = ['build.xml', ...readdirSync('build').filter((file) => file.endsWith('.xml')).map((file) => `build/${file}`)];
const text = files.map((file) => readFileSync(file, 'utf8')).join('\n');
const found = (pattern) => [...text.matchAll(pattern)].map(([, name]) => name);
const read = new Set(found(/(?:\$\{|-D|\b(?:property|if|unless|if:set|unless:set)=")([\w-]+)/g));
// what the descriptions of the targets name, and what has a default
const offered = [...new Set(found(/(?:-D|<property name=")([a-z]+)\b(?=[=" .,;:)])/g))];

for (const name of process.argv.slice(2)) {
	if (!name.includes('.') && !read.has(name)) {
		const [[nearest, far]] = offered.map((each) => [each, $changesBetween(name, each)]).sort((a, b) => a[1] - b[1]);
		console.error(`antw: there is no option -D${name}${far <= Math.max(1, name.length / 3) ? `; there is -D${nearest}` : ''}`);
		process.exitCode = 64;
	}
}
