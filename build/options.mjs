#!/usr/bin/env node
/**
 * Checks the options (-Dname=value) of ./antw before anything is made. Options are the names that the targets' descriptions have: the
 * build's own properties, such as the folders that it empties, are none. A name that is no option is refused, with the nearest option. An
 * option that has a value in some description is refused without one. So is a value that can be none of its option's, and what
 * client-test and timing do not take: their descriptions have all their options. After --no-target the
 * program says which target is nearest to one that Ant has not found, or which ones have its name in their descriptions.
 *
 *   node build/options.mjs -DNAME=VALUE | -DNAME | OTHER ...
 *   node build/options.mjs --no-target TARGET
 *
 * Names with a dot may be Ant's own, so they pass, and so does what is no option. Ends with status 64 if an option is refused.
 */
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { thereIs } from './nearest.mjs';

const files = ['build.xml', ...readdirSync('build').filter((file) => file.endsWith('.xml')).map((file) => `build/${file}`)];
const text = files.map((file) => readFileSync(file, 'utf8')).join('\n');
const found = (pattern, where = text) => [...where.matchAll(pattern)].map(([, name]) => name);
const descriptions = found(/\bdescription="([^"]*)"/g).join('\n');
const options = [...new Set(found(/-D([a-z]+)\b(?!\.)/g, descriptions))];
const withValues = new Set(found(/-D([a-z]+)=/g, descriptions));

const described = new Map([...text.matchAll(/<target name="([\w-]+)"[^>]*\bdescription="([^"]*)"/g)].map(([, name, said]) => [name, said]));

const [flag, target] = process.argv.slice(2);
if (flag === '--no-target') {
	const saying = [...described].filter(([, said]) => said.split(/\W+/).includes(target)).map(([name]) => name);
	const near = thereIs(target, found(/<target name="(\w[\w-]*)"/g));
	refuse(`there is no target ${target}${saying.length > 0 ? `; see ${saying.join(', ')}` : near}`);
	process.exit();
}
const given = new Map(process.argv.slice(2).flatMap((argument) => {
	const [, name, value] = /^-D([^.=]+)(?:=(.*))?$/s.exec(argument) ?? [];
	return name ? [[name, value]] : [];
}));
const targets = process.argv.slice(2).filter((argument) => !argument.startsWith('-'));
const only = ['client-test', 'timing'].find((name) => name === targets.join());
const taken = only && found(/-D([a-z]+)\b/g, described.get(only));
const settings = readFileSync('src/evaluation/Settings.as', 'utf8');
const namesOf = (list) => new RegExp(`${list}:Array = \\[([^\\]]*)\\]`).exec(settings)[1].match(/\w+/g);

/** For each option whose value is checked: what is wrong with one of the parts between its commas, beside the others, or nothing. */
const PROBLEMS = {
	stall: (part) => !(Number(part) > 0 && Number(part) < Infinity) && `seconds above 0 are needed, not "${part}"`,
	sources: problemOfFolder,
	libraries: problemOfLibrary,
	player: (part) => problemOfName(part, ['ruffle', 'avmshell', ...(only ? [] : ['node'])]),
	beside: (part) => !['true', 'false'].includes(part) && `true or false is needed, not "${part}"`,
	figures: (part) => problemOfName(part, namesOf('FIGURES')),
	models: (part) => problemOfName(part, namesOf('MODELS')),
	// with folders of the user's sources there may be more
	fitters: (part) => !given.has('sources') && `-Dsources= names the folder that has ${part}`,
	colliders: (part) => !given.has('sources') && problemOfName(part, namesOf('COLLIDERS'), `; there are ${namesOf('COLLIDERS').join(', ')}, and -Dsources= names the folder of your own`),
	agents: problemOfCount,
	repetitions: problemOfCount,
};
for (const [name, value] of given) {
	const problem = value?.split(',').map((part, _, parts) => PROBLEMS[name]?.(part, parts)).find(Boolean);
	if (!options.includes(name)) {
		refuse(`there is no option -D${name}${thereIs(name, options, '-D')}`);
	} else if (taken && !taken.includes(name)) {
		refuse(`${only} does not take -D${name}; it takes -D${taken.join(', -D')}`);
	} else if (withValues.has(name) && !value) {
		refuse(`-D${name} needs a value: -D${name}=...`);
	} else if (problem) {
		refuse(`-D${name}: ${problem}`);
	}
}

function problemOfFolder(folder, all) {
	if (!existsSync(folder)) return `there is no folder ${path.resolve(folder)}`;
	if (!statSync(folder).isDirectory()) return `${folder} is a file. Name the folder in which the packages of its classes begin`;
	const outer = all.find((other) => /^(?!\.\.|$)/.test(path.relative(other, folder)));
	return outer && `${folder} is in ${outer}. Name only the folder in which the packages of its classes begin`;
}

function problemOfLibrary(file) {
	if (!existsSync(file)) return `there is no file ${path.resolve(file)}`;
	return statSync(file).isDirectory() && !readdirSync(file).some((name) => name.endsWith('.swc')) && `the folder ${file} has no SWC`;
}

function problemOfName(name, names, farther = `; there are ${names.join(', ')}`) {
	return !names.includes(name) && `there is no "${name}"${thereIs(name, names) || farther}`;
}

function problemOfCount(text) {
	return !/^[1-9]\d*$/.test(text) && `numbers of at least 1 are needed, not "${text}"`;
}

function refuse(problem) {
	console.error(`antw: ${problem}`);
	process.exitCode = 64;
}
