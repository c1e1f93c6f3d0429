import { createRequire } from 'node:module';
import path from 'node:path';
import { chromium } from 'playwright-core';
import { PATIENCE } from './browsers.mjs';
import { serve } from './server.mjs';

const require = createRequire(import.meta.url);
const ruffle = path.dirname(require.resolve('@ruffle-rs/ruffle'));
const { version } = require('@ruffle-rs/ruffle/package.json');

const page = `<!doctype html>
<html>
<head><title>headless</title><link rel="icon" href="data:,">
<style>html, body { margin: 0; background: #fff; } ruffle-player { display: block; width: 100vw; height: 100vh; }</style>
</head>
<body><script src="/ruffle/ruffle.js"></script></body>
</html>`;

// No sandbox: root has none in a container. No background networking: nothing is looked up outside this machine.
const browserArguments = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
	'--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage'];

// A line of the player's log in the browser's console: %cLEVEL%c source:line%c text <the three styles>
const logLine = /^%c(\w+)%c ([^\s%]+)%c ([^]*?) ?color: [^;]+; background: #444 color: gray; font-style: italic color: inherit$/;
const crash = /unreachable|Unable to lock Ruffle core|panicked at|memory access out of bounds|RuntimeError/;

/**
 * Plays a SWF in Ruffle in headless Chromium.
 *
 * @param {object} options
 * @param {string} options.swf the SWF's file
 * @param {string} options.chrome the browser's path
 * @param {Record<string, string>} options.parameters what the SWF finds in loaderInfo.parameters
 * @param {Record<string, string>} options.folders further folders to serve: path to folder
 * @param {number} options.width the stage's width in pixels
 * @param {number} options.height the stage's height in pixels
 * @param {object} on what to call as the SWF plays
 * @param {(text: string) => void} on.trace for each trace()
 * @param {(text: string) => void} on.error for an error that nothing in the SWF caught
 * @param {(text: string) => void} on.crash when the player itself fails
 * @param {(file: string, text: string) => void} on.writeFile when the SWF hands over a file
 * @param {(status: number) => void} on.exit when the SWF says that it is done
 * @returns {Promise<{screenshot: (file: string) => Promise<void>, frames: () => Promise<number>, close: () => Promise<void>}>} frames:
 *     how many there were. It waits for the end of the frame that runs
 */
export async function play(options, on) {
	const swfFolder = path.dirname(path.resolve(options.swf));
	const server = await serve(page, { '/ruffle': ruffle, '/swf': swfFolder, ...options.folders });
	// who started this hears signals, takes a picture, and closes
	const isDeaf = { handleSIGHUP: false, handleSIGINT: false, handleSIGTERM: false };
	let browser = null;
	const close = async () => {
		await browser?.close();
		server.close();
	};
	try {
		browser = await chromium.launch({ executablePath: options.chrome, args: browserArguments, timeout: PATIENCE, ...isDeaf });
		const tab = await browser.newPage({ viewport: { width: options.width, height: options.height } });
		tab.setDefaultTimeout(PATIENCE);
		tab.on('crash', () => on.crash('the browser\'s page crashed, most likely out of memory'));
		tab.on('pageerror', (error) => on.crash(String(error)));
		tab.on('console', (message) => report(message.text(), on));
		await tab.addInitScript(watchMemory);
		await tab.addInitScript(countFrames);
		await tab.exposeFunction('headlessWriteFile', on.writeFile);
		await tab.exposeFunction('headlessExit', on.exit);
		await tab.goto(server.url);
		await tab.evaluate(start, {
			url: '/swf/' + path.basename(options.swf),
			parameters: options.parameters,
			name: `Ruffle ${version}`,
		});
		return {
			screenshot: (file) => tab.screenshot({ path: file }).then(() => undefined),
			frames: () => tab.evaluate(() => window.frameCount),
			close,
		};
	} catch (error) {
		await close();
		throw error;
	}
}

/** Sorts one line of the console into what the SWF said and what went wrong. */
function report(text, on) {
	const [, level, source, message] = logLine.exec(text) ?? [];
	if (source?.includes('log_adapter')) {
		on.trace(message);
	} else if (level === 'ERROR' && source.includes('avm2')) {
		on.error(message);
	} else if (crash.test(text)) {
		on.crash(message ?? text);
	}
}

/** Runs in the page before the player: finds the memory that the player's WebAssembly module works in. */
function watchMemory() {
	const { instantiate, instantiateStreaming } = WebAssembly;
	const keep = (result) => {
		window.playerMemory = (result.instance ?? result).exports.memory ?? window.playerMemory;
		return result;
	};
	WebAssembly.instantiate = (...args) => instantiate(...args).then(keep);
	WebAssembly.instantiateStreaming = (...args) => instantiateStreaming(...args).then(keep);
}

/** Runs in the page before the player. */
function countFrames() {
	window.frameCount = 0;
	const next = () => {
		window.frameCount++;
		requestAnimationFrame(next);
	};
	requestAnimationFrame(next);
}

/** Runs in the page: starts the player. */
async function start({ url, parameters, name }) {
	window.headless = {
		// the answer comes later than the call, and the SWF does not wait for it
		writeFile: (file, text) => { window.headlessWriteFile(file, text); },
		now: () => performance.now(),
		memory: () => window.playerMemory?.buffer.byteLength ?? -1,
		collect: () => {},
		player: () => name,
		exit: (status) => { window.headlessExit(status); },
	};
	const player = window.RufflePlayer.newest().createPlayer();
	document.body.append(player);
	const api = player.ruffle ? player.ruffle() : player;
	await api.load({
		url,
		parameters,
		allowScriptAccess: true,
		autoplay: 'on',
		unmuteOverlay: 'hidden',
		splashScreen: false,
		contextMenu: 'off',
		logLevel: 'info',
		maxExecutionDuration: 24 * 3600,
	});
}
