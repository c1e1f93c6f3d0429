/**
 * The browser that tests open pages in: Chromium, or what TEST_BROWSER says. Of Debian's browsers Playwright drives Chromium and, by WebDriver BiDi,
 * Firefox; for WebKit it needs a build of its own.
 */
import { existsSync } from 'node:fs';
import { chromium, firefox } from 'playwright-core';

const BROWSERS = {
	chromium: { path: process.env.CHROME || '/usr/bin/chromium', launch: (options) => chromium.launch(options) },
	firefox: {
		path: process.env.FIREFOX || '/usr/bin/firefox-esr',
		// its arguments are Chromium's; pages draw without a graphics card
		launch: ({ executablePath }) => firefox.launch({ executablePath, channel: 'moz-firefox', firefoxUserPrefs: { 'webgl.force-enabled': true } }),
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
