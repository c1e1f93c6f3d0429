#!/usr/bin/env node
/**
 * Runs the FlexUnit classes on the ES module's code, in Node.
 *
 *   node test/runner/run.mjs TESTS [--choice FILE] [--until FILE] [--first] [--full] [--mount /url=folder ...] [--summary FILE] [--coverage FILE]
 *
 * TESTS is what the build made of the engine and the tests together. With --choice only some of them run: FILE has JSON as list-tests.mjs writes it.
 *
 *   order    classes, or tests as CLASS.test: these run first, in this order
 *   files    files of tests without a class that run next, if none has failed: each as node --test, with TESTS as its engine
 *   farther  tests farther off, which run last, until one fails or they have taken their time. What they print is shown only of one that fails
 *   of       the sources that all these are tests of
 *
 * Once the file of --until is there, no more of files and farther begin: the player writes it when a test fails there. With --first all ends when one fails.
 * With --coverage, FILE gets a line of JSON for each test: its name, the milliseconds that it takes, and the lines of TESTS that it
 * runs. The first line has those that run when TESTS is loaded.
 */
import { spawnSync } from "node:child_process";
import { appendFileSync, existsSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { pathToFileURL } from "node:url";
import { failuresIn, saidOf } from "./failures.mjs";
import { countLines } from "./coverage.mjs";
import { mount } from "./fixtures.mjs";
import { NOT_HERE } from "./not-here.mjs";
import { watch, writeSummary } from "./watch.mjs";

const { values: options, positionals } = parseArgs({
	allowPositionals: true,
	options: { choice: { type: "string" }, until: { type: "string", default: "" }, first: { type: "boolean", default: false }, full: { type: "boolean", default: false }, mount: { type: "string", multiple: true, default: [] }, summary: { type: "string" }, coverage: { type: "string" } },
});

const linesRun = options.coverage ? countLines(positionals[0]) : () => [];
const tests = await import(pathToFileURL(path.resolve(positionals[0])));
// the one that the tests call. The file may be from another folder, and then a second one would never hear what a test waits for
const { AssumptionViolatedException, waiting } = tests.flexunit;
tests.Effort.isFull = options.full;
mount(tests, options.mount);
// the engine warns the developers of games of worlds that tests make on purpose
console.warn = () => {};
if (options.coverage) writeFileSync(options.coverage, `${JSON.stringify({ test: "", ms: 0, lines: linesRun() })}\n`);

/** Seconds of a processor, for all that is run, after which no test farther off begins. */
const ENOUGH_S = 40;

/** Seconds of a processor after which a test is taken for one that does not end, if the variable NO_END_S gives no others. */
const NO_END_S = 40;
const NO_END_FULL_S = 900;

/** A test that takes longer is named. */
const SLOW_MS = 3000;

let passed = 0;
let failed = 0;
let skipped = 0;
let leftOut = 0;
let isFarther = false;
const { log } = console;
const started = performance.now();
const only = new Set(NOT_HERE.keys());
const begins = watch(Number(process.env.NO_END_S ?? (options.full ? NO_END_FULL_S : NO_END_S)), options.summary, options.until);

process.on("uncaughtException", (error) => {
	failed++;
	log(`FAILED, outside of any test: ${error.stack}`);
	if (options.first) process.exit(1);
});

const simpleName = ({ name }) => name.split(".").pop();
const { order, files, farther, of } = { files: [], farther: [], of: [], ...options.choice && JSON.parse(readFileSync(options.choice, "utf8")) };
const classes = order ? inOrder(order) : tests.CLASSES.map((each) => ({ ...each, isRun: () => true }));
const fartherClasses = inOrder(farther);

/** Some classes and tests, by the class's name. A class whose tests follow one another is begun once. */
function inOrder(names) {
	const found = [];
	for (const [wanted, test = null] of names.map((name) => name.split("."))) {
		for (const each of tests.CLASSES.filter((other) => simpleName(other) === wanted)) {
			if (found.at(-1)?.name !== each.name) found.push({ ...each, wanted: [] });
			found.at(-1).wanted.push(test);
		}
	}
	return found.map((each) => ({ ...each, isRun: (name) => each.wanted.includes(null) || each.wanted.includes(name) }));
}

for (const each of classes) await runClass(each, () => true);
for (const file of files) if (!isOver()) runFile(file);
await runFarther();

/** Whether a test has failed, here or in the player, so that what is farther off need not run. */
function isOver() {
	return failed > 0 || existsSync(options.until);
}

/** Runs a file of tests without a player on the module that is tested. */
function runFile(file) {
	const { status, stdout, stderr } = spawnSync(process.execPath, ["--test", "--test-reporter=tap", file], { encoding: "utf8", maxBuffer: 1e9, env: { ...process.env, ENGINE: path.resolve(positionals[0]), OF: of.join(",") } });
	if (status === 0) passed++;
	else {
		failed++;
		console.log(`FAILED ${file}${ofSources()}: ${failuresIn(stdout).join("; ")}\n${saidOf(stdout)}${stderr}`);
		if (options.first) process.exit(1);
	}
}

/** What a test that fails is a test of, where its name may not say that. */
function ofSources() {
	return of.length > 0 ? ` (a test of ${of.join(", ")})` : "";
}

/** Runs one class of tests farther off after another, until one fails or they have taken their time. Says how many tests have not been run. */
async function runFarther() {
	const seconds = () => (process.cpuUsage().user + process.cpuUsage().system) / 1e6;
	const isNext = () => !isOver() && seconds() < ENOUGH_S;
	const before = passed + skipped;
	let late = 0;
	isFarther = true;
	for (const each of fartherClasses) late += await runClass(each, isNext);
	const done = passed + skipped + failed - before;
	if (farther.length > 0) console.log(`of the tests farther off ${done} ran${late > 0 ? `, ${late} did not: ${isOver() ? "one failed" : `the time for all is ${ENOUGH_S} s`}` : ""}`);
}

/** Runs the tests of a class while the next may begin, and returns how many have not been run. */
async function runClass({ name, type, metadata, isRun }, isNext) {
	const methods = (kind) => metadata.filter((each) => each.kind === kind);
	const chosen = methods("Test").filter((each) => isRun(each.name)).sort((a, b) => Number(a.args.order ?? 0) - Number(b.args.order ?? 0));
	const here = chosen.filter((each) => {
		const place = [name, `${name}.${each.name}`].find((key) => NOT_HERE.has(key));
		only.delete(place);
		return place === undefined;
	});
	leftOut += chosen.length - here.length;
	if (here.length === 0 || !isNext()) return here.length;
	await new Promise((resolve) => tests.Fixtures.load(type.FIXTURES ?? [], resolve));
	let late = 0;
	let problem = null;
	try {
		for (const each of methods("BeforeClass")) await type[each.name]();
	} catch (error) {
		problem = error;
	}
	const linesBefore = linesRun();
	for (const each of here) {
		if (!isNext()) {
			late++;
			continue;
		}
		begins(`${simpleName({ name })}.${each.name}`, passed, failed, skipped, Number(isFarther));
		const printed = [];
		if (isFarther) console.log = (...words) => printed.push(words);
		const start = performance.now();
		const error = problem ?? await run(type, each, methods);
		const ms = performance.now() - start;
		console.log = log;
		if (error instanceof AssumptionViolatedException) skipped++;
		else if (error === null) passed++;
		else {
			failed++;
			for (const words of printed) console.log(...words);
			console.log(`FAILED ${name.split(".").pop()}.${each.name}${ofSources()}: ${error.stack ?? error}`);
			if (options.first) process.exit(1);
		}
		if (options.coverage) appendFileSync(options.coverage, `${JSON.stringify({ test: `${simpleName({ name })}.${each.name}`, ms, lines: [...linesBefore, ...linesRun()] })}\n`);
		if (ms > SLOW_MS) console.log(`  ${name.split(".").pop()}.${each.name}: ${(ms / 1000).toFixed(1)} s`);
	}
	for (const each of methods("AfterClass")) await type[each.name]();
	return late;
}

/** What a test throws, or null. */
async function run(type, test, methods) {
	const expected = test.args.expects;
	try {
		const instance = new type();
		try {
			for (const each of methods("Before")) instance[each.name]();
			instance[test.name]();
			await Promise.all(waiting.splice(0));
		} finally {
			waiting.length = 0;
			for (const each of methods("After")) instance[each.name]();
		}
	} catch (error) {
		return expected && error?.name === expected.split(".").pop() ? null : error;
	}
	return expected ? new Error(`expected ${expected}, but nothing was thrown`) : null;
}

// an error that no test has caught comes in a turn of its own
await new Promise((resolve) => setTimeout(resolve));

if (!options.choice && only.size > 0) {
	failed++;
	console.log(`FAILED: no such test, though not-here.mjs lists it: ${[...only].join(", ")}`);
}
if (passed + failed + skipped === 0 && farther.length === 0 && files.length === 0) {
	failed++;
	console.log("FAILED: no test was run");
}
console.log(`on the ES module, in Node ${process.versions.node}: ${passed} passed, ${failed} failed, ${skipped} skipped, ${leftOut} not run here, in ${((performance.now() - started) / 1000).toFixed(1)} s`);
writeSummary(options.summary, passed, failed, skipped);
process.exitCode = failed === 0 ? 0 : 1;
