#!/usr/bin/env node
/**
 * Runs the SWF of a client's own tests and counts them. If it stalls or the player fails, it names what was running, and starts the player
 * again for the other tests. At the end it names those that did not run.
 *
 *   node test/runner/client-tests-run.mjs FOLDER FILE.swf SECONDS [PLAYER]
 *
 * FOLDER has tests.txt of client-tests.mjs, and gets counts.txt. What gives no sign of life for so many seconds ends the player, and so does
 * what takes ten times as long altogether. PLAYER is build/headless/run.mjs, or in tests a script in its place.
 */
import { spawn } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

/** After so many times SECONDS a test has no end, even if it traces. */
const TIMES = 10;

/** So often the player is started at most. */
const MOST_STARTS = 10;

/** So many lines of what a test traces are shown. */
const MOST_LINES = 1000;

/** The exit status of a SWF that stalls. */
const FAILED = 70;

const [folder, swf, seconds, player = fileURLToPath(new URL('../../build/headless/run.mjs', import.meta.url))] = process.argv.slice(2);

/**
 * The tests that there are: at first those that the texts of the classes name, then those that FlexUnit finds. Those of them that have
 * begun, and those that are ignored; what failed, tests or others. With their places.
 */
const tests = new Set(readFileSync(path.join(folder, 'tests.txt'), 'utf8').split('\n').filter(Boolean));
const begun = new Set();
const ignored = new Set();
const failed = new Set();
/** The names of the classes of which no test can run. */
const closed = new Set();
let run;
let now;
let limit;
let reason;
/** The lines that were traced since something began or failed. */
let lines = 0;
let isStackOfRunner = false;

/** Reads a line of the reporter that test/runner/client-tests.mjs writes, or shows one of a test. */
function readTrace(line) {
	const [, tag, name] = /^ {2}@(tests|test|begin|ignore|now)(?: (.+))?$/.exec(line) ?? [];
	if (tag === 'tests') left().forEach((each) => tests.delete(each));
	else if (tag === 'test') tests.add(name);
	else if (tag) begin(name, tag);
	else if (line.startsWith('FAILED ')) fail(line.slice(7).split(': ')[0], line);
	else if (!isOfRunner(line)) show(line);
}

/** Shows a line that a test traces. Of very many the first are shown. */
function show(line) {
	lines++;
	if (lines <= MOST_LINES) console.log(line);
}

/** Says how many lines were not shown. Those that follow are of something else. */
function endLines() {
	if (lines > MOST_LINES) console.log(`... and ${lines - MOST_LINES} lines more`);
	lines = 0;
	isStackOfRunner = false;
}

/** Notes and says what failed. No test of a class can run if its static initialiser fails, or if what is before them ends the player. */
function fail(name, said) {
	endLines();
	console.log(said);
	failed.add(name);
	const [, className] = /^(\S+)(?:, static initialiser| \[BeforeClass\])/.exec(name) ?? [];
	if (className) closed.add(className);
}

/** Notes and says what runs now: a test if the tag is "begin" or "ignore". Ends it if it takes too long. */
function begin(name, tag) {
	endLines();
	now = name;
	if (tag !== 'now') {
		begun.add(name);
		if (tag === 'ignore') ignored.add(name);
		console.log(`  ${begun.size}/${tests.size} ${tag === 'ignore' ? 'ignored: ' : ''}${name}`);
	}
	clearTimeout(limit);
	limit = setTimeout(() => {
		reason = `did not end within ${TIMES * seconds} s, ${TIMES} times -Dstall, though it traced meanwhile`;
		run.kill();
	}, TIMES * seconds * 1000);
}

/** Whether a line is one of a stack that tells nothing of the client: FlexUnit's calls, and what is below its runner's. */
function isOfRunner(line) {
	const isCall = /^\s*at /.test(line);
	isStackOfRunner = isCall && (isStackOfRunner || /^\s*at (org\.flexunit\.(runners?|internals|token)\b|flex\.lang\.reflect|global\/flash\.utils::getDefinitionByName)/.test(line));
	return isStackOfRunner || isCall && /org\.flexunit|::apply\(|^\s*at (global\$init|ClientTests\w*(\/\w+)?)?\(?\)?$/.test(line);
}

/** Of a message of the runner: why it has ended the run. */
function reasonIn(line) {
	const [, message] = /^headless: (.+)$/.exec(line) ?? [];
	return message?.replace(/^the SWF stalled: (\S+ s) without a sign of life/, 'did not end within $1').replace('--stall', '-Dstall=SECONDS')
		// the reporter calls it
		.replace(', or has ended without Host.exit', '')
		// FlexUnit calls tests in such an event, and catches Errors
		.replace(/^the SWF threw: Error dispatching event "timerComplete": (?!\w*Error\b)/, 'the test threw what is no Error: ');
}

/** A test without its place. */
function nameOf(test) {
	return test.replace(/ \(.*\)$/, '');
}

/** The class of a test. */
function classOf(test) {
	return nameOf(test).replace(/\.\w+$/, '');
}

/** The tests that can still run. */
function left() {
	return [...tests].filter((test) => !begun.has(test) && !closed.has(classOf(test)));
}

/** Some tests without their places; a class of which all are among them stands for its tests. */
function namesOf(some) {
	const inParts = [...tests].filter((test) => !some.includes(test)).map(classOf);
	return [...new Set(some.map((test) => (inParts.includes(classOf(test)) ? nameOf(test) : classOf(test))))];
}

/** If the player has ended by an error of a timer or a listener: the tests of this player that may have left it, the last ones. */
function earlierTests(ofPlayer) {
	return /^the SWF threw: Error (in|dispatching)/.test(reason) ? ofPlayer.filter((test) => test !== now && !ignored.has(test)).map(nameOf).slice(-3) : [];
}

/** Notes and says what has ended the player. A test that a late error of an earlier one has stopped can run again. */
function failPlayer(ofPlayer) {
	const earlier = earlierTests(ofPlayer);
	if (earlier.length === 0) {
		fail(now, `FAILED ${now}: ${reason}`);
	} else {
		const name = `a late error, during ${now}`;
		fail(name, `FAILED ${name}: ${reason}; perhaps of a timer or listener of an earlier test. Before it ran ${earlier.join(', ')}`);
		begun.delete(now);
	}
}

/** Plays the tests that are left. If something ends the player before their end, another one plays the rest. */
function play(start) {
	const [begunBefore, closedBefore] = [begun.size, closed.size];
	// FlexUnit fails a class of which it is to run nothing, so a class that is done is left out by its name
	const without = [...closed, ...namesOf([...begun])].join(',');
	reason = '';
	const calls = [];
	run = spawn(process.execPath, [player, swf, '--stall', seconds, '--param', `without=${without}`], { stdio: ['ignore', 'pipe', 'pipe'] });
	begin('the SWF', 'now');
	createInterface({ input: run.stdout }).on('line', readTrace);
	createInterface({ input: run.stderr }).on('line', (line) => {
		reason ||= reasonIn(line) ?? '';
		if (!reasonIn(line) && !isOfRunner(line)) calls.push(line);
	});
	run.on('close', (status) => {
		clearTimeout(limit);
		endLines();
		if (reason) failPlayer([...begun].slice(begunBefore));
		calls.forEach((line) => console.log(line));
		if (!reason) return end(start > 1 ? FAILED : status || Number(failed.size > 0));
		const isFarther = begun.size > begunBefore || closed.size > closedBefore;
		if (left().length === 0 || !isFarther || start === MOST_STARTS) return end(FAILED);
		console.log(`the player starts again for the tests that are left: ${left().length}`);
		return play(start + 1);
	});
}

/** Counts all, and ends with a status. */
function end(status) {
	const passed = [...begun].filter((test) => !failed.has(test) && !ignored.has(test));
	const notRun = [...tests].filter((test) => !begun.has(test));
	if (notRun.length > 0) console.log(`not run: ${namesOf(notRun).join(', ')}`);
	const summary = `${passed.length} passed, ${failed.size} failed, ${ignored.size} ignored, ${notRun.length} not run`;
	console.log(summary);
	writeFileSync(path.join(folder, 'counts.txt'), summary);
	process.exitCode = status;
}

play(1);
