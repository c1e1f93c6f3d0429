/**
 * Debian's WebKit, driven by the W3C's WebDriver: Playwright drives only a WebKit of its own. It is in webkit2gtk-driver, and draws in
 * three dimensions where there is a display: xvfb is one.
 */
import { spawn } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { PATIENCE, ensureDisplay } from './browsers.mjs';

const DRIVER = '/usr/bin/WebKitWebDriver';
const LIBRARIES = '/usr/lib';
// what the protocol calls an element's name
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf';

/** Why there is none; false if it is there. */
export const missing = existsSync(DRIVER) ? false : `webkit2gtk-driver is not installed: there is no ${DRIVER}`;

/** The browser that Debian has beside the library. */
function miniBrowser() {
	for (const machine of readdirSync(LIBRARIES).filter((each) => each.endsWith('-linux-gnu'))) {
		for (const library of readdirSync(path.join(LIBRARIES, machine)).filter((each) => each.startsWith('webkit2gtk-'))) {
			const file = path.join(LIBRARIES, machine, library, 'MiniBrowser');
			if (existsSync(file)) return file;
		}
	}
	throw new Error(`there is no MiniBrowser below ${LIBRARIES}`);
}

/** A page in WebKit. @param {number} port a free one on loopback, for the driver */
export async function openWebKit(port) {
	await ensureDisplay();
	const driver = spawn(DRIVER, [`--port=${port}`], { stdio: 'ignore' });
	process.on('exit', () => driver.kill());
	const base = `http://127.0.0.1:${port}/session`;

	async function ask(address, body) {
		const response = await fetch(address, { method: body ? 'POST' : 'GET', body: body && JSON.stringify(body) });
		const { value } = await response.json();
		if (!response.ok) throw new Error(`${value.error}: ${value.message}`);
		return value;
	}

	async function begin() {
		const capabilities = { alwaysMatch: { 'webkitgtk:browserOptions': { binary: miniBrowser(), args: ['--automation'] } } };
		for (const end = Date.now() + PATIENCE; ; await wait(100)) {
			try {
				return await ask(base, { capabilities });
			} catch (error) {
				// not yet listening
				if (Date.now() > end || error.cause?.code !== 'ECONNREFUSED') throw error;
			}
		}
	}

	const { sessionId, capabilities } = await begin();
	const session = `${base}/${sessionId}`;
	const page = {
		version: capabilities.browserVersion,
		goto: (url) => ask(`${session}/url`, { url }),
		/** What a function gives in the page, or what it promises. */
		evaluate: (action, ...args) => ask(`${session}/execute/async`, {
			script: `const all = [...arguments];
				const done = all.pop();
				Promise.resolve((${action})(...all)).then((value) => done({ value }), (error) => done({ error: String(error) }));`,
			args,
		}).then(({ value, error }) => {
			if (error) throw new Error(error);
			return value;
		}),
		/** Waits until a function gives something in the page that is true, and gives that. */
		async until(action, ...args) {
			for (const end = Date.now() + PATIENCE; Date.now() < end; await wait(100)) {
				const value = await page.evaluate(action, ...args);
				if (value) return value;
			}
			throw new Error(`never true: ${action}`);
		},
		async click(selector) {
			const { [ELEMENT]: id } = await ask(`${session}/element`, { using: 'css selector', value: selector });
			await ask(`${session}/element/${id}/click`, {});
		},
		/** Presses a key, and lets go of it after some milliseconds. */
		press(key, duration) {
			const actions = [{ type: 'keyDown', value: key }, { type: 'pause', duration }, { type: 'keyUp', value: key }];
			return ask(`${session}/actions`, { actions: [{ type: 'key', id: 'keys', actions }] });
		},
		picture: async () => Buffer.from(await ask(`${session}/screenshot`), 'base64'),
		async close() {
			await fetch(session, { method: 'DELETE' }).catch(() => {});
			driver.kill();
		},
	};
	return page;
}
