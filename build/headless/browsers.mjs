/**
 * The browser that tests open pages in: Chromium, or what TEST_BROWSER says. Of Debian's browsers Playwright drives Chromium and, by
 * WebDriver BiDi, Firefox, which draws in three dimensions only where there is a display: Debian's xvfb is one. For WebKit it needs a
 * build of its own: webkit.mjs drives Debian's.
 */
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { chromium, firefox } from 'playwright-core';

const XVFB = '/usr/bin/Xvfb';

/** Where there is no display, one that ends with this process. */
export async function ensureDisplay() {
	if (process.env.DISPLAY || !existsSync(XVFB)) return;
	const server = spawn(XVFB, ['-displayfd', '1', '-noreset', '-nolisten', 'tcp'], { stdio: ['ignore', 'pipe', 'ignore'] });
	process.on('exit', () => server.kill());
	const [number] = await once(server.stdout, 'data');
	server.stdout.unref();
	server.unref();
	process.env.DISPLAY = `:${String(number).trim()}`;
}

async function launchFirefox({ executablePath, timeout }) {
	await ensureDisplay();
	return firefox.launch({ executablePath, timeout, channel: 'moz-firefox', firefoxUserPrefs: { 'webgl.force-enabled': true } });
}

const BROWSERS = {
	chromium: { path: process.env.CHROME || '/usr/bin/chromium', launch: (options) => chromium.launch(options) },
	firefox: {
		path: process.env.FIREFOX || '/usr/bin/firefox-esr',
		// its arguments are Chromium's
		launch: launchFirefox,
	},
};

const browserName = process.env.TEST_BROWSER || 'chromium';
if (!(browserName in BROWSERS)) throw new Error(`TEST_BROWSER is ${browserName}: expected one of ${Object.keys(BROWSERS).join(', ')}`);
const browser = BROWSERS[browserName];

/** Whether it is Chromium, which alone pretends to be a phone. */
export const isChromium = browserName === 'chromium';

/** Why there is none; false if it is there. */
export const missing = existsSync(browser.path) ? false : `${browserName} is not installed: there is no ${browser.path}`;

/** What Playwright disables in Chromium. A second switch of this kind replaces Playwright's own, so ours repeats it. */
const DISABLED_BY_PLAYWRIGHT = [
	'AvoidUnnecessaryBeforeUnloadCheckSync',
	'BoundaryEventDispatchTracksNodeRemoval',
	'DestroyProfileOnBrowserClose',
	'DialMediaRouteProvider',
	'GlobalMediaControls',
	'HttpsUpgrades',
	'LensOverlay',
	'MediaRouter',
	'OptimizationHints',
	'PaintHolding',
	'RenderDocument',
	'ThirdPartyStoragePartitioning',
	'Translate',
];

/** No renderer in advance; no pages for the address bar that nobody sees. */
const DISABLED = [...DISABLED_BY_PLAYWRIGHT, 'SpareRendererForSitePerProcess', 'WebUIOmniboxPopup', 'WebUIOmniboxAimPopup'];

/** What Chromium is started with. launchFirefox leaves it out. */
const ARGUMENTS = [
	'--no-sandbox',
	// the processor draws: what is 3D by software GL, and the pages directly, which takes half as long as by software GL
	'--use-gl=angle',
	'--use-angle=swiftshader',
	'--enable-unsafe-swiftshader',
	'--disable-gpu-rasterization',
	'--disable-gpu-compositing',
	'--disable-dev-shm-usage',
	'--disable-background-networking',
	'--no-first-run',
	// one renderer a context
	'--disable-site-isolation-trials',
	`--disable-features=${DISABLED.join(',')}`,
	// a page is there for seconds: its scripts are compiled once more, and not a third time
	'--js-flags=--no-opt',
];

/** How long anything may take, in milliseconds. It ends what hangs. A machine that has other things to do is slow, and not broken. */
export const PATIENCE = 300000;

/** Gives a browser of one's own, with further arguments, which are Chromium's. Its pages wait as long as PATIENCE says. */
export async function launchOwn(args = []) {
	const started = await browser.launch({ executablePath: browser.path, args: [...ARGUMENTS, ...args], timeout: PATIENCE });
	// its pages are pages of contexts
	const newContext = started.newContext.bind(started);
	started.newContext = async (options) => {
		const context = await newContext(options);
		context.setDefaultTimeout(PATIENCE);
		return context;
	};
	return started;
}

/** The browser that the test files of this process share, and how many of them use it. */
let [shared, users] = [null, 0];

/** Gives a share of this process's browser: contexts of one's own, which end when it is closed. The last share that is closed ends the browser. */
export async function launch() {
	users++;
	shared ??= launchOwn();
	const sharedBrowser = await shared;
	const contexts = [];
	const newContext = async (options) => {
		const context = await sharedBrowser.newContext(options);
		contexts.push(context);
		return context;
	};
	return {
		newContext,
		newPage: async (options) => (await newContext(options)).newPage(),
		async close() {
			await Promise.all(contexts.map((context) => context.close()));
			if (--users > 0) return;
			shared = null;
			await sharedBrowser.close();
		},
	};
}

/**
 * Whether a line of the console says that a picture was waited for. The browser waits for it: it puts the page together on the processor.
 */
export const saysItWaits = (text) => /GPU stall due to ReadPixels/.test(text);
