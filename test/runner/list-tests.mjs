#!/usr/bin/env node
/**
 * Lists the tests that a machine runs: all, or those that -Dtest names.
 *
 *   node test/runner/list-tests.mjs OUT MACHINE [--test PATTERN] [--samples FOLDER] [--full]
 *
 * MACHINE is ruffle, avmshell, away3d (Ruffle, with Away3D) or node. OUT gets
 *
 *   AllTests.as        a class that lists the test classes that the machine's SWF has. The samples of the documentation in FOLDER are
 *                      test classes too
 *   choice.json        what Node runs of a choice, as run.mjs reads it
 *   tests.properties   what Ant has to know:
 *                      picked: which of AllTests.as run, if it is not all
 *                      inNode: what Node runs in place of Ruffle, as in-node.txt lists it
 *                      allocations: the tests of allocations among those picked
 *                      none: if the SWF has no test
 *                      node: if Node runs some
 *                      pages: those of the pages named that have samples in JavaScript
 *                      away3d: how many tests need Away3D, of those named and those of a named adapter
 *
 * The pattern @changed stands for the files that differ from the last commit.
 *
 * Ruffle runs the tests that the pattern names itself. Of the tests of a source it runs those that Node cannot. With --full Ruffle runs
 * all, and Node goes on with none farther off. Files that would be the same keep their times.
 */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { root } from '../structure/sources.mjs';
import { choose, chooseAll, nearestNames, testsBefore } from './chosen.mjs';
import { fartherTests, nameInNode, testsOfPages } from './farther.mjs';
import { inNodeAlone, readTests, simpleName, testsIn } from './test-classes.mjs';
import { NOT_HERE, needsPlayer } from './not-here.mjs';

const { values: { test: given, samples, full: isFull }, positionals: [out, machine] } = parseArgs({
	allowPositionals: true,
	options: { test: { type: 'string', default: '' }, samples: { type: 'string', default: '' }, full: { type: 'boolean', default: false } },
});
const isNode = machine === 'node';
const pattern = given === '@changed' ? changedFiles() : given;

/** Whether Node runs what takes Ruffle long, and goes on with tests farther off. */
const isShared = !isFull && (isNode || machine === 'ruffle');

const { classes: all, sources } = readTests();
if (!isNode) addSamples();
const needsAway3d = (name) => /^(starlogo\.away3d|docs)\.Away3d/.test(name);
const classes = new Map([...all].filter(([name]) => needsAway3d(name) === (machine === 'away3d')));

const choice = given === '' ? chooseAll(classes) : choose(pattern, classes, sources);
const { tests, ofSources, farther, named } = choice;
const ofPages = testsOfPages(choice.pages);
const ofAdapters = testsWithAway3d();
if (given !== '@changed' && tests.size + ofAdapters.length + (isNode ? ofPages : choice.pages).length === 0) refuse();

const inNode = isShared ? inNodeAlone() : new Set();
const inSwf = isNode ? new Map() : testsOfSwf();
const order = given === '' ? [] : [...tests.keys()].filter((name) => !isShared || !farther.has(name)).flatMap(leftToNode);
const beyond = isShared ? fartherTests(choice, classes, sources).filter(([name]) => !isWhollyInSwf(name)) : [];
const fartherInNode = beyond.map(nameInNode);
const files = fartherInNode.filter((name) => name.endsWith('.mjs'));

sayChoice();
write('AllTests.as', allTests([...inSwf.keys()]));
write('choice.json', JSON.stringify({ order, farther: fartherInNode, of: named }));
const known = Object.entries(properties()).filter(([, value]) => value !== false);
write('tests.properties', known.map(([name, value]) => `${name}=${value}\n`).join(''));

/**
 * The sources, test classes and pages that differ from the last commit, with commas between. Says so of other files, which have no
 * tests of their own.
 */
function changedFiles() {
	if (!existsSync(path.join(root, '.git'))) {
		console.log('FAILED -Dchanged needs a git clone, and this is none');
		process.exit(1);
	}
	const git = (...words) => execFileSync('git', words, { cwd: root, encoding: 'utf8' }).split('\n').filter((file) => file !== '');
	const changed = [...git('diff', '--name-only', 'HEAD'), ...git('ls-files', '--others', '--exclude-standard')];
	const isThere = (file) => hasTests(file) && existsSync(path.join(root, file));
	const files = changed.filter(isThere);
	const others = changed.filter((file) => !isThere(file)).map((file) => (existsSync(path.join(root, file)) ? file : `${file} (deleted)`));
	console.log(`changed since the last commit: ${files.join(', ') || 'no source and no page'}`);
	if (others.length > 0) console.log(`changed, but ${testsOfOthers(others)}`);
	return files.join(',');
}

/** Whether a file can have tests of its own: a source, a test class or a page, by its path in the project. */
function hasTests(file) {
	return /^(src|test|js\/standins\/common)\/.*\.as$|\.md$/.test(file);
}

/** What is said of files that have no tests of their own. */
function testsOfOthers(files) {
	return `./antw test alone has their tests: ${files.join(', ')}`;
}

/** Adds the samples of the documentation to the test classes. */
function addSamples() {
	for (const file of readdirSync(path.join(samples, 'docs')).filter((each) => each.endsWith('Test.as')).sort()) {
		all.set(`docs.${file.slice(0, -3)}`, readFileSync(path.join(samples, 'docs', file), 'utf8'));
	}
}

/**
 * The tests that a SWF with Away3D runs of those that are named; none if all are run, or if what is named is a source that no adapter has.
 */
function testsWithAway3d() {
	if (given === '' || machine === 'away3d' || isNode || named.some((name) => !name.startsWith('starlogo.away3d.'))) return [];
	return [...choose(pattern, all, sources).tests].filter(([name]) => needsAway3d(name));
}

/** Says that the pattern names no tests for this command, and what is meant perhaps. Ends the program. */
function refuse() {
	const [, folder, example] = /^(?:\.\/)?examples\/(flash\/)?(\w[\w-]*)\.(?:html|as)$/.exec(pattern) ?? [];
	if (example && existsSync(path.join(root, pattern))) {
		const runs = `./antw ${folder ? 'module examples-swfs' : 'module'}, then node --test --test-name-pattern="^${example} " test/examples/examples.test.mjs`;
		console.log(`FAILED -Dtest=${pattern} names an example, and these have no tests here. Its own test: ${runs}`);
		process.exit(1);
	}
	const parts = pattern.split(',').map((part) => part.trim());
	const others = parts.filter(isOther);
	if (others.length > 0) console.log(`FAILED -Dtest: ${testsOfOthers(others)}`);
	const left = parts.filter((part) => !isOther(part));
	if (left.length === 0) process.exit(1);
	const ofClass = testsBefore(left.join(','), classes).slice(0, 100);
	const near = ofClass.length > 0 ? ofClass : left.flatMap((part) => nearestNames(part, all, sources));
	// antw says such a line last, and not the status of this program
	const thereAre = near.length > 0 ? `; there are ${near.join(', ')}` : '';
	console.log(`FAILED -Dtest=${left.join(',')} names nothing: no class of tests, no test, no source file and no page${thereAre}`);
	process.exit(1);
}

/** Whether a name of -Dtest is the path of a file of the project that has no tests of its own. */
function isOther(name) {
	const file = path.relative(root, path.resolve(root, name.replaceAll('\\', '/'))).replaceAll(path.sep, '/');
	return !/^$|^\.\./.test(file) && !hasTests(file) && Boolean(statSync(path.join(root, file), { throwIfNoEntry: false })?.isFile());
}

/** Says why tests were chosen, and which of them the SWF does not run. */
function sayChoice() {
	for (const line of choice.said) console.log(line);
	if (order.length > 0 && !isNode) console.log(`in Node only: ${order.join(', ')}`);
	if (ofAdapters.length > 0) console.log(`with Away3D: ${ofAdapters.map(([name]) => simpleName(name)).join(', ')}`);
	if (files.length + ofPages.length > 0) console.log(`in Node, without a class: ${[...files, ...ofPages].join(', ')}`);
}

/** The text of a class that lists some test classes. */
function allTests(names) {
	return `package
{
${names.map((name) => `    import ${name};`).join('\n')}

    /** The test classes that are run; generated by the build. */
    public final class AllTests
    {
        public static const CLASSES:Array = [
            ${names.join(',\n            ')}];
    }
}
`;
}

/** What Ant has to know. */
function properties() {
	const picked = given === '' ? [] : [...inSwf].flatMap(([name, list]) => list?.map((test) => `${name}.${test}`) ?? [name]);
	return {
		picked: picked.join(','),
		inNode: [...inNode].join(','),
		allocations: (given === '' ? [...inSwf.keys()] : picked).filter((name) => /AllocationTest\b/.test(name)).join(','),
		none: inSwf.size === 0,
		node: order.length + fartherInNode.length > 0,
		pages: ofPages.length > 0 && choice.pages.join(','),
		away3d: ofAdapters.length > 0 && ofAdapters.reduce((sum, [name, list]) => sum + (list ?? testsIn(all.get(name))).length, 0),
	};
}

/** The tests that the pattern names itself, and of the tests of a source those that Node cannot run. */
function testsOfSwf() {
	if (!isShared) return tests;
	return new Map([...tests].flatMap(([name, list]) => {
		if (!ofSources.has(name) || NOT_HERE.has(name) || needsPlayer(classes.get(name))) return [[name, list]];
		const here = testsIn(classes.get(name)).filter((test) => NOT_HERE.has(`${name}.${test}`));
		return here.length > 0 ? [[name, here]] : [];
	}));
}

/** Whether the SWF has all that was chosen of a class. */
function isWhollyInSwf(name) {
	return inSwf.has(name) && inSwf.get(name) === tests.get(name);
}

/** What Node runs of a class in place of the player: the class, or some of its tests, without packages. */
function leftToNode(name) {
	if (isWhollyInSwf(name)) return [];
	const wanted = tests.get(name) ?? (inSwf.has(name) ? testsIn(classes.get(name)) : null);
	return wanted?.filter((test) => !inSwf.get(name)?.includes(test)).map((test) => `${simpleName(name)}.${test}`) ?? [simpleName(name)];
}

function write(name, text) {
	mkdirSync(out, { recursive: true });
	const file = path.join(out, name);
	if (!existsSync(file) || readFileSync(file, 'utf8') !== text) writeFileSync(file, text);
}
