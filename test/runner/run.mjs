#!/usr/bin/env node
/**
 * Runs the FlexUnit classes on the ES module's code, in Node.
 *
 *   node test/runner/run.mjs TESTS [--choice FILE] [--first] [--full] [--mount /url=folder ...] [--summary FILE]
 *   [--coverage FILE]
 *
 * TESTS is what the build made of the engine and the tests together. With --choice only some of them run: FILE has JSON as list-tests.mjs
 * writes it.
 *
 *   order    classes, tests as CLASS.test, or files of tests without a class: these run first, in this order. Such a file runs as
 *            node --test, with TESTS as its engine
 *   farther  more of these, which run last, until one fails or they have taken their time. What they print is shown only of one that fails
 *   of       the sources that all these are tests of
 *
 * A test of OF_HASHES that fails does not say what is wrong. So the others go on after it, until one does.
 *
 * With --first all ends when one fails. With --coverage, FILE gets a line of JSON for each test: its name, the milliseconds that it takes, and the lines
 * of TESTS that it runs. The first line has those that run when TESTS is loaded.
 */
import { spawnSync } from "node:child_process";
import { appendFileSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { pathToFileURL } from "node:url";
import { failuresIn, saidOf } from "./failures.mjs";
import { countLines } from "./coverage.mjs";
import { OF_HASHES } from "./farther.mjs";
import { mount } from "./fixtures.mjs";
import { NOT_HERE } from "./not-here.mjs";
import { watch, writeSummary } from "./watch.mjs";

/** Seconds of a processor, for all that is run, after which no test of choice.farther begins. */
const ENOUGH_S = 40;

/** Seconds of a processor after which a test is taken for one that does not end, if the variable NO_END_S gives no others. */
const NO_END_S = 40;
const NO_END_FULL_S = 900;

/** A test that takes longer is named. */
const SLOW_MS = 3000;

const { values: options, positionals: [module] } = parseArgs({
	allowPositionals: true,
	options: {
		choice: { type: "string" },
		first: { type: "boolean", default: false },
		full: { type: "boolean", default: false },
		mount: { type: "string", multiple: true, default: [] },
		summary: { type: "string" },
		coverage: { type: "string" },
	},
});

const linesRun = options.coverage ? countLines(module) : () => [];
const tests = await import(pathToFileURL(path.resolve(module)));
// the one that the tests call. The file may be from another folder, and then a second one would never hear what a test waits for
const { AssumptionViolatedException, waiting } = tests.flexunit;
tests.Effort.isFull = options.full;
mount(tests, options.mount);
// the engine warns the developers of games of worlds that tests make on purpose
console.warn = () => {};
noteCoverage("", 0, linesRun());

// console.log itself is another while a test farther off runs
const { log } = console;
const started = performance.now();
const counts = { passed: 0, failed: 0, skipped: 0, leftOut: 0 };
// those of OF_HASHES that have failed
let hashesFailed = 0;
// the first that has failed, but for those
let firstFailed;
const notFound = new Set(NOT_HERE.keys());
const begins = watch(Number(process.env.NO_END_S ?? (options.full ? NO_END_FULL_S : NO_END_S)), options.summary);
const choice = { farther: [], of: [], ...options.choice && JSON.parse(readFileSync(options.choice, "utf8")) };

process.on("uncaughtException", (error) => fail(`, outside of any test: ${error.stack}`));

const classes = choice.order ? inOrder(choice.order) : tests.CLASSES.map((each) => ({ ...each, isRun: () => true }));
for (const each of classes) await runClass(each);
if (choice.farther.length > 0) await runFarther(inOrder(choice.farther));

// an error that no test has caught comes in a turn of its own
await new Promise((resolve) => setTimeout(resolve));

const { passed, skipped, leftOut } = counts;
if (!options.choice && notFound.size > 0) fail(`: no such test, though not-here.mjs lists it: ${[...notFound].join(", ")}`);
if (passed + counts.failed + skipped === 0 && choice.farther.length === 0) fail(": no test was run");
const { failed } = counts;
const seconds = ((performance.now() - started) / 1000).toFixed(1);
console.log(`on the ES module, in Node ${process.versions.node}: ${passed} passed, ${failed} failed, ${skipped} skipped, `
	+ `${leftOut} not run here, in ${seconds} s`);
writeSummary(options.summary, passed, failed, skipped);
process.exitCode = failed === 0 ? 0 : 1;

/** Counts a failure and says it: what failed, then why. With --first it is the end. */
function fail(said) {
	counts.failed++;
	if (counts.failed > hashesFailed) firstFailed ??= said.trim().split(/[: ]/)[0];
	log(`FAILED${said}`);
	if (options.first) process.exit(1);
}

/** Whether a test has failed that says what is wrong, so that what is farther off need not run. */
function isOver() {
	return counts.failed > hashesFailed;
}

/** A class's name without its package. */
function simpleName({ name }) {
	return name.split(".").pop();
}

/** Some classes, tests and files, by their names. A class whose tests follow one another is begun once. */
function inOrder(names) {
	const found = [];
	for (const name of names) {
		if (name.endsWith(".mjs")) found.push({ name });
		const [wanted, test = null] = name.split(".");
		for (const each of tests.CLASSES.filter((other) => simpleName(other) === wanted)) {
			if (found.at(-1)?.name !== each.name) found.push({ ...each, wanted: [] });
			found.at(-1).wanted.push(test);
		}
	}
	return found.map((each) => ({ ...each, isRun: (name) => each.wanted.includes(null) || each.wanted.includes(name) }));
}

/** Runs a file of tests without a player on the module that is tested. */
function runFile(file) {
	const env = { ...process.env, ENGINE: path.resolve(module), OF: choice.of.join(",") };
	const { status, stdout, stderr } = spawnSync(process.execPath, ["--test", "--test-reporter=tap", file], { encoding: "utf8", maxBuffer: 1e9, env });
	if (status === 0) counts.passed++;
	else fail(` ${file}${ofSources()}: ${failuresIn(stdout).join("; ")}\n${saidOf(stdout)}${stderr}`);
}

/** What a test that fails is a test of, where its name may not say that. */
function ofSources() {
	return choice.of.length > 0 ? ` (a test of ${choice.of.join(", ")})` : "";
}

/**
 * Runs one class of tests farther off after another, until one fails or they have taken their time. Says how many tests have not been run.
 */
async function runFarther(fartherClasses) {
	const secondsUsed = () => (process.cpuUsage().user + process.cpuUsage().system) / 1e6;
	const isNext = () => !isOver() && secondsUsed() < ENOUGH_S;
	const done = () => counts.passed + counts.skipped + counts.failed;
	const before = done();
	let late = 0;
	for (const each of fartherClasses) late += await runClass(each, isNext, true);
	const why = isOver() ? `${firstFailed} failed before` : `the time for all is ${ENOUGH_S} s`;
	console.log(`of the tests that use the source, the nearest first, ${done() - before} ran${late > 0 ? `, ${late} not begun: ${why}` : ""}`);
	if (hashesFailed > 0 && !isOver()) console.log("of the tests that ran, only a hash says that something has changed");
}

/** Runs the tests of a class, or a file, while the next may begin, and returns how many have not been run. */
async function runClass({ name, type, metadata, isRun }, isNext = () => true, isFarther = false) {
	if (metadata === undefined) {
		const isRunNow = isNext();
		if (isRunNow) runFile(name);
		return isRunNow ? 0 : 1;
	}
	const methods = (kind) => metadata.filter((each) => each.kind === kind);
	const orderOf = (each) => Number(each.args.order ?? 0);
	const chosen = methods("Test").filter((each) => isRun(each.name)).sort((a, b) => orderOf(a) - orderOf(b));
	const here = chosen.filter((each) => !isNotHere(name, each));
	counts.leftOut += chosen.length - here.length;
	if (here.length === 0 || !isNext()) return here.length;
	await new Promise((resolve) => tests.Fixtures.load(type.FIXTURES ?? [], resolve));
	const problem = await thrownBy(async () => {
		for (const each of methods("BeforeClass")) await type[each.name]();
	});
	const linesBefore = linesRun();
	let late = 0;
	for (const test of here) {
		if (isNext()) await runTest(`${simpleName({ name })}.${test.name}`, () => problem ?? run(type, test, methods), linesBefore, isFarther);
		else late++;
	}
	for (const each of methods("AfterClass")) await type[each.name]();
	return late;
}

/** Whether not-here.mjs lists a test, or its class, which counts as found then. */
function isNotHere(className, { name }) {
	const place = [className, `${className}.${name}`].find((key) => NOT_HERE.has(key));
	notFound.delete(place);
	return place !== undefined;
}

/**
 * Runs a test and counts it.
 *
 * @param {string} name what it is called
 * @param {() => unknown} errorOf runs it, and gives what it throws, or null
 * @param {number[][]} linesBefore the lines that its class has run before its tests
 * @param {boolean} isFarther whether it is farther off, so that what it prints is shown only if it fails
 */
async function runTest(name, errorOf, linesBefore, isFarther) {
	begins(name, counts.passed, counts.failed, counts.skipped);
	const printed = [];
	if (isFarther) console.log = (...words) => printed.push(words);
	const start = performance.now();
	const error = await errorOf();
	const ms = performance.now() - start;
	console.log = log;
	if (error === null) counts.passed++;
	else if (error instanceof AssumptionViolatedException) counts.skipped++;
	else {
		for (const words of printed) console.log(...words);
		if (OF_HASHES.includes(name)) hashesFailed++;
		fail(` ${name}${ofSources()}: ${error.stack ?? error}`);
	}
	noteCoverage(name, ms, [...linesBefore, ...linesRun()]);
	if (ms > SLOW_MS) console.log(`  ${name}: ${(ms / 1000).toFixed(1)} s`);
}

/** Writes a test's line of --coverage. */
function noteCoverage(test, ms, lines) {
	if (!options.coverage) return;
	const write = test === "" ? writeFileSync : appendFileSync;
	write(options.coverage, `${JSON.stringify({ test, ms, lines })}\n`);
}

/** What a test throws that it should not, or the lack of what it should; null if it passes. */
async function run(type, test, methods) {
	const expected = test.args.expects;
	const error = await thrownBy(async () => {
		const instance = new type();
		try {
			for (const each of methods("Before")) instance[each.name]();
			instance[test.name]();
			await Promise.all(waiting.splice(0));
		} finally {
			waiting.length = 0;
			for (const each of methods("After")) instance[each.name]();
		}
	});
	if (!expected) return error;
	if (error === null) return new Error(`expected ${expected}, but nothing was thrown`);
	return error?.name === expected.split(".").pop() ? null : error;
}

/** What an action throws, or null. */
async function thrownBy(action) {
	try {
		await action();
		return null;
	} catch (error) {
		return error;
	}
}
