import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import os from 'node:os';

const modules = new URL('../../node_modules/', import.meta.url);

/** What the run ran on; nothing that tells whose it is. */
export function machine() {
	const cpus = os.cpus();
	return {
		processor: cpus[0]?.model.trim() ?? 'unknown',
		cores: cpus.length,
		memoryGB: Math.round(os.totalmem() / 2 ** 30),
		system: `${os.type()} ${os.release()} ${os.arch()}`,
	};
}

/** How many programs wanted a processor, on average over the last minute. */
export function load() {
	return Number(os.loadavg()[0].toFixed(1));
}

/** Whether something else was running: the run itself wants one core. */
export function isBusy({ start, end }, cores) {
	return start > cores / 2 || end > cores;
}

/** Whether something else was running in a report's run. */
export function wasDisturbed({ load, machine }) {
	return Boolean(load) && isBusy(load, machine.cores);
}

/** The greatest of the loads of two runs, at the start and at the end. */
export function greatestLoad(one, other) {
	const greatest = (a, b) => (a === undefined ? b : b === undefined ? a : Math.max(a, b));
	return { start: greatest(one?.start, other.start), end: greatest(one?.end, other.end) };
}

/** The load at the start and the end of a run, in words. */
export function loadText({ start, end }, cores) {
	const others = isBusy({ start, end }, cores) ? '. Something else was running, so times and multiples may be too long, and many too noisy' : '';
	return `Load of the machine: ${start ?? '?'} before the run, ${end} after it, on ${cores} cores${others}.`;
}

/** Whether other programs took so much of the machine in a report's run that its numbers are compared with none. */
export function wasBusy({ load, machine }) {
	return Math.max(load?.start ?? 0, load?.end ?? 0) > machine.cores;
}

/** What it ran with. */
export function versions(player) {
	return {
		engine: version(new URL('../../package.json', import.meta.url)),
		commit: output('git', ['describe', '--always', '--dirty']),
		player,
		browser: output(process.env.CHROME || '/usr/bin/chromium', ['--version']),
		compiler: `flex-sdk ${version(new URL('flex-sdk/package.json', modules))}`,
		node: process.version,
	};
}

function version(file) {
	return JSON.parse(readFileSync(file, 'utf8')).version;
}

function output(command, args) {
	try {
		return execFileSync(command, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).trim().split('\n')[0];
	} catch {
		return 'unknown';
	}
}
