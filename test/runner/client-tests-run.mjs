#!/usr/bin/env node
/**
 * Runs the SWF of a client's own tests. If it stalls or the player fails, it names the test that was running and counts those that did
 * not run.
 *
 *   node test/runner/client-tests-run.mjs FILE.swf SECONDS COUNTS
 *
 * A test that gives no sign of life for so many seconds ends the run. COUNTS is a file for the counts. The exit status is that of
 * build/headless/run.mjs.
 */
import { spawn } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

const [swf, seconds, counts] = process.argv.slice(2);
const headless = fileURLToPath(new URL('../../build/headless/run.mjs', import.meta.url));

const begun = { count: 0, of: 0, name: 'the SWF', ignored: 0 };
const failed = new Set();
let summary = '';
let reason = '';

/** Reads a line of the reporter that test/runner/client-tests.mjs writes. */
function readTrace(line) {
	const [, number, of, isIgnored, name] = /^ {2}(\d+)\/(\d+) (ignored: )?(.+)$/.exec(line) ?? [];
	if (number) {
		Object.assign(begun, { count: Number(number), of: Number(of), name, ignored: begun.ignored + (isIgnored ? 1 : 0) });
	} else if (line.startsWith('FAILED ')) {
		failed.add(begun.name);
	} else if (/^\d+ passed, \d+ failed, \d+ ignored, 0 not run$/.test(line)) {
		summary = line;
	}
}

/** Of a message of the runner: why it has ended the run. */
function reasonIn(line) {
	const [, message] = /^headless: (.+)$/.exec(line) ?? [];
	return message?.replace(/^the SWF stalled: (\S+ s) without a sign of life/, 'did not end within $1').replace('--stall', '-Dstall=SECONDS')
		// the reporter calls it
		.replace(', or has ended without Host.exit', '');
}

const run = spawn(process.execPath, [headless, swf, '--stall', seconds], { stdio: ['ignore', 'pipe', 'pipe'] });
createInterface({ input: run.stdout }).on('line', (line) => {
	console.log(line);
	readTrace(line);
});
createInterface({ input: run.stderr }).on('line', (line) => {
	reason ||= reasonIn(line) ?? '';
	if (!reasonIn(line)) {
		console.error(line);
	}
});
run.on('close', (status) => {
	if (reason) {
		console.log(`FAILED ${begun.name}: ${reason}`);
		failed.add(begun.name);
	}
	if (!summary) {
		const passed = Math.max(begun.count - begun.ignored - failed.size, 0);
		summary = `${passed} passed, ${failed.size} failed, ${begun.ignored} ignored, ${begun.of - begun.count} not run`;
		console.log(summary);
	}
	writeFileSync(counts, summary);
	process.exitCode = status ?? 1;
});
