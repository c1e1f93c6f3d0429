#!/usr/bin/env node
/**
 * Checks the options (-Dname=value) of ./antw. Options are the names that the targets' descriptions have: the build's own properties,
 * such as the folders that it empties, are none. A name that is no option is refused, with the nearest option. An option that has a
 * value in some description is refused without one. After --no-target the program says which target is nearest to one that Ant has not
 * found, or which ones have its name in their descriptions.
 *
 *   node build/options.mjs NAME= | NAME ...
 *   node build/options.mjs --no-target TARGET
 *
 * Names with a dot may be Ant's own, so they pass. Ends with status 64 if an option is refused.
 */
import { readFileSync, readdirSync } from 'node:fs';
import { thereIs } from './nearest.mjs';

const files = ['build.xml', ...readdirSync('build').filter((file) => file.endsWith('.xml')).map((file) => `build/${file}`)];
const text = files.map((file) => readFileSync(file, 'utf8')).join('\n');
const found = (pattern, where = text) => [...where.matchAll(pattern)].map(([, name]) => name);
const descriptions = found(/\bdescription="([^"]*)"/g).join('\n');
const options = [...new Set(found(/-D([a-z]+)\b(?!\.)/g, descriptions))];
const withValues = new Set(found(/-D([a-z]+)=/g, descriptions));

const [flag, target] = process.argv.slice(2);
if (flag === '--no-target') {
	const described = [...text.matchAll(/<target name="([\w-]+)"[^>]*\bdescription="([^"]*)"/g)];
	const saying = described.filter(([, , said]) => said.split(/\W+/).includes(target)).map(([, name]) => name);
	const near = thereIs(target, found(/<target name="(\w[\w-]*)"/g));
	refuse(`there is no target ${target}${saying.length > 0 ? `; see ${saying.join(', ')}` : near}`);
	process.exit();
}
for (const option of process.argv.slice(2).filter((each) => !each.includes('.'))) {
	const [name, value] = option.split('=');
	if (!options.includes(name)) {
		refuse(`there is no option -D${name}${thereIs(name, options, '-D')}`);
	} else if (withValues.has(name) && value === undefined) {
		refuse(`-D${name} needs a value: -D${name}=...`);
	}
}

function refuse(problem) {
	console.error(`antw: ${problem}`);
	process.exitCode = 64;
}
