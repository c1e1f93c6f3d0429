/**
 * The browser that tests open pages in: Chromium, or what TEST_BROWSER says. Of Debian's browsers Playwright drives Chromium and, by WebDriver BiDi,
 * Firefox, which draws in three dimensions only where there is a display: Debian's xvfb is one. For WebKit it needs a build of its own: webkit.mjs drives Debian's.
 */
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { chromium, firefox } from 'playwright-core';

const XVFB = '/usr/bin/Xvfb';

/** Where there is no display, one that ends with this process. */
export async function display() {
	if (process.env.DISPLAY || !existsSync(XVFB)) return;
	const server = spawn(XVFB, ['-displayfd', '1', '-noreset', '-nolisten', 'tcp'], { stdio: ['ignore', 'pipe', 'ignore'] });
	process.on('exit', () => server.kill());
	const [number] = await once(server.stdout, 'data');
	server.stdout.unref();
	server.unref();
	process.env.DISPLAY = `:${String(number).trim()}`;
}

async function launchFirefox({ executablePath }) {
	await display();
	return firefox.launch({ executablePath, channel: 'moz-firefox', firefoxUserPrefs: { 'webgl.force-enabled': true } });
}

const BROWSERS = {
	chromium: { path: process.env.CHROME || '/usr/bin/chromium', launch: (options) => chromium.launch(options) },
	firefox: {
		path: process.env.FIREFOX || '/usr/bin/firefox-esr',
		// its arguments are Chromium's
		launch: launchFirefox,
	},
};

const name = process.env.TEST_BROWSER || 'chromium';
if (!(name in BROWSERS)) throw new Error(`TEST_BROWSER is ${name}: expected one of ${Object.keys(BROWSERS).join(', ')}`);

/** Whether it is Chromium, which alone pretends to be a phone. */
export const isChromium = name === 'chromium';

/** Why there is none; false if it is there. */
export const missing = existsSync(BROWSERS[name].path) ? false : `${name} is not installed: there is no ${BROWSERS[name].path}`;

/** Starts it. @param {string[]} args for Chromium */
export const launch = (args = ['--no-sandbox']) => BROWSERS[name].launch({ executablePath: BROWSERS[name].path, args });
