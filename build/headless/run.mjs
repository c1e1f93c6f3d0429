#!/usr/bin/env node
/**
 * Runs a SWF in a headless player: prints what it traces, as it comes, and ends with its exit status.
 *
 *   node build/headless/run.mjs file.swf [options]
 *
 *   --param name=value      a value in loaderInfo.parameters (may be repeated)
 *   --mount /path=folder    a folder that the SWF can load from (may be repeated)
 *   --out folder            where the files go that the SWF hands over (default: bin)
 *   --stall seconds         how long the SWF may give no sign of life (default: 120)
 *   --seconds number        ends the run after so many seconds, with status 0, and says so (default: it goes on until the SWF ends it)
 *   --screenshot file.png   a picture of the stage at the end: when the SWF is done, when it fails, after --seconds, at Ctrl+C
 *   --size 800x600          the stage in pixels
 *   --player avmshell       Adobe's VM instead of Ruffle, for a SWF compiled for it: AVMSHELL names the folder of its shell
 *   --start file.abc        what starts the SWF there (default: bin/avm/start.abc)
 *   --no-gc                 collects no garbage there: memory then tells what was allocated
 *   --parts 4               runs the SWF so many times, with the parameter part: 1/4, 2/4 and so on (default: once, without it)
 *
 * The SWF's side of it is src/headless/Host.as. Exit status: the SWF's own; 70 when it threw, crashed the player or
 * stalled; 130 at Ctrl+C, 143 if it was told to end, 129 if its terminal is gone; 69 when there is no browser, or no shell; 64 for wrong arguments.
 */
import { access, mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { RunError, parsed, requireSwf } from './arguments.mjs';
import { play } from './player.mjs';
import { Pulse } from './pulse.mjs';
import * as avmshell from './shell.mjs';

const NO_PLAYER = 69;
const FAILED = 70;
/** The signals that end a run, and its exit status then. */
const SIGNALS = { SIGHUP: 129, SIGINT: 130, SIGTERM: 143 };

const OPTIONS = {
	out: { type: 'string', default: 'bin' },
	stall: { type: 'string', default: '120' },
	seconds: { type: 'string' },
	screenshot: { type: 'string' },
	size: { type: 'string', default: '800x600' },
	player: { type: 'string', default: 'ruffle' },
	start: { type: 'string', default: 'bin/avm/start.abc' },
	'no-gc': { type: 'boolean', default: false },
	parts: { type: 'string', default: '1' },
};

function readArguments() {
	const { swf, values, parameters, folders } = parsed(OPTIONS);
	const [, width, height] = /^(\d+)x(\d+)$/.exec(values.size) ?? [];
	const stall = Number(values.stall);
	if (!width || !(stall > 0)) {
		throw new RunError(`--size must be like 800x600 and --stall a number of seconds: ${values.size}, ${values.stall}`);
	}
	const seconds = values.seconds === undefined ? Infinity : Number(values.seconds);
	if (!(seconds > 0)) {
		throw new RunError(`--seconds must be a number greater than 0: ${values.seconds}`);
	}
	if (!['ruffle', 'avmshell'].includes(values.player)) {
		throw new RunError(`--player must be ruffle or avmshell: ${values.player}`);
	}
	const parts = Number(values.parts);
	if (!(Number.isInteger(parts) && parts > 0)) {
		throw new RunError(`--parts must be a whole number from 1 on: ${values.parts}`);
	}
	return {
		swf,
		player: values.player,
		start: values.start,
		collects: !values['no-gc'],
		parts,
		parameters,
		folders,
		out: values.out,
		stall,
		seconds,
		screenshot: values.screenshot,
		width: Number(width),
		height: Number(height),
	};
}

async function browserPath() {
	const chrome = process.env.CHROME || '/usr/bin/chromium';
	await access(chrome).catch(() => {
		throw new RunError(`there is no browser at ${chrome}: install Chromium, or name one in CHROME`, NO_PLAYER);
	});
	return chrome;
}

/** Starts the SWF in the player that was asked for. */
async function start(options, on) {
	if (options.player === 'ruffle') {
		return play({ ...options, chrome: await browserPath() }, on);
	}
	const shell = await avmshell.shellFolder().catch((error) => {
		throw new RunError(error.message, NO_PLAYER);
	});
	return avmshell.play({ ...options, shell }, on);
}

/** Plays the SWF to its end; resolves with its exit status. */
async function run(options) {
	await requireSwf(options.swf);
	const pulse = new Pulse();
	const writes = [];
	let end;
	const ended = new Promise((resolve, reject) => {
		end = { resolve, fail: (message) => reject(new RunError(message, FAILED)) };
	});
	ended.catch(() => {}); // reported below, after the player has started
	const interrupt = (signal) => end.resolve(SIGNALS[signal]);
	const signals = Object.keys(SIGNALS);
	signals.forEach((signal) => process.once(signal, interrupt));
	const player = await start(options, {
		trace: (text) => {
			pulse.sign();
			console.log(text);
		},
		error: (text) => end.fail(`the SWF threw: ${text}`),
		crash: (text) => end.fail(`the player failed (${whyItCrashed(text)}): ${text}`),
		writeFile: (file, text) => {
			pulse.sign();
			const saved = save(options.out, file, text);
			saved.catch((error) => end.fail(error.message));
			writes.push(saved);
		},
		exit: end.resolve,
	});
	pulse.watch(player, options, {
		stall: end.fail,
		time: (said) => {
			console.error(`headless: ${said}`);
			end.resolve(0);
		},
	});
	try {
		return await ended;
	} finally {
		pulse.end();
		signals.forEach((signal) => process.off(signal, interrupt));
		if (options.screenshot) {
			await mkdir(path.dirname(options.screenshot), { recursive: true });
			await player.screenshot(options.screenshot)
				.catch((error) => console.error(`headless: no screenshot: ${error.message}`));
		}
		await player.close();
		await Promise.all(writes);
	}
}

/** Why a player failed, by what it says. */
function whyItCrashed(text) {
	return /call stack/.test(text) ? 'a function calls itself without end' : 'out of memory, if the SWF allocates much in one call';
}

/** Plays all parts, one after the other, whatever happens to one. Resolves with the last exit status that is not 0. */
async function runParts(options) {
	let status = 0;
	for (let part = 1; part <= options.parts; part++) {
		const parameters = options.parts > 1 ? { ...options.parameters, part: `${part}/${options.parts}` } : options.parameters;
		status = await runPart({ ...options, parameters }) || status;
		if (Object.values(SIGNALS).includes(status)) {
			break;
		}
	}
	return status;
}

async function runPart(options) {
	try {
		return await run(options);
	} catch (error) {
		if (error.status !== FAILED) {
			throw error;
		}
		console.error(`headless: ${options.parameters.part ? `part ${options.parameters.part}: ` : ''}${error.message}`);
		return error.status;
	}
}

async function save(folder, file, text) {
	const target = path.resolve(folder, file);
	if (!target.startsWith(path.resolve(folder) + path.sep)) {
		throw new RunError(`the SWF wants to write outside ${folder}: ${file}`, FAILED);
	}
	await mkdir(path.dirname(target), { recursive: true });
	await writeFile(target, text);
}

try {
	process.exitCode = await runParts(readArguments());
} catch (error) {
	console.error(`headless: ${error instanceof RunError ? error.message : error.stack ?? error}`);
	process.exitCode = error.status ?? FAILED;
}
