/** The playground in a headless browser with software GL, as a desktop's and a phone's browser show it. */
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { isChromium, launch, saysItWaits } from '../../build/headless/browsers.mjs';
import { serve } from '../../build/headless/server.mjs';

export const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = path.join(root, 'bin/playground');

/** The sizes that everything is tried at. The processor draws: of each two by two pixels one is enough. */
export const SIZES = {
	desktop: { viewport: { width: 1366, height: 820 }, deviceScaleFactor: 0.5 },
	laptop: { viewport: { width: 1366, height: 768 }, deviceScaleFactor: 0.5 },
	phone: { viewport: { width: 390, height: 844 }, deviceScaleFactor: 0.5, hasTouch: true, ...(isChromium && { isMobile: true }) },
};

/** Drags the second of two agents in the world, with the mouse, by pixels. */
export async function dragBall(page, dx, dy) {
	const at = await page.evaluate(() => {
		const { agents: [, ball], stage: { camera, canvas } } = globalThis.playground;
		const point = camera.position.clone().set(ball.x, ball.y, ball.z + ball.size / 2).project(camera);
		const box = canvas.getBoundingClientRect();
		return { x: box.left + ((point.x + 1) / 2) * box.width, y: box.top + ((1 - point.y) / 2) * box.height };
	});
	await page.mouse.move(at.x, at.y);
	await page.mouse.down();
	await page.mouse.move(at.x + dx, at.y + dy, { steps: 4 });
	await page.mouse.up();
}

/**
 * Lets a browser's context draw nothing in 3D, though all is as if it did: for what is no matter of pictures. The processor would draw, and slowly. So each
 * canvas has a WebGL that takes all calls and does nothing.
 */
export const drawNothing = (context) => context.addInitScript(() => {
	const { prototype } = WebGL2RenderingContext;
	const names = Object.getOwnPropertyNames(prototype).filter((name) => name !== 'constructor');
	const valueOf = (name) => Object.getOwnPropertyDescriptor(prototype, name).value;
	const parameters = { [prototype.VERSION]: 'WebGL 2.0', [prototype.RENDERER]: 'software', [prototype.SCISSOR_BOX]: [0, 0, 1, 1], [prototype.VIEWPORT]: [0, 0, 1, 1] };
	const answers = {
		getParameter: (name) => parameters[name] ?? 16,
		getExtension: () => ({ loseContext() {} }),
		getShaderPrecisionFormat: () => ({ precision: 23, rangeMin: 127, rangeMax: 127 }),
		getProgramParameter: (_, name) => (name === prototype.LINK_STATUS ? true : 0),
		getShaderParameter: () => true,
		checkFramebufferStatus: () => prototype.FRAMEBUFFER_COMPLETE,
		isContextLost: () => false,
	};
	const make = (canvas, attributes) => {
		const gl = { canvas, drawingBufferWidth: canvas.width, drawingBufferHeight: canvas.height };
		for (const name of names) {
			const value = valueOf(name);
			if (typeof value === 'number') gl[name] = value;
			else if (typeof value === 'function') gl[name] = answers[name] ?? (name.startsWith('create') ? () => ({}) : name.endsWith('InfoLog') ? () => '' : () => null);
		}
		return Object.assign(gl, { getContextAttributes: () => attributes });
	};
	const made = new WeakMap();
	const { getContext } = HTMLCanvasElement.prototype;
	HTMLCanvasElement.prototype.getContext = function get(kind, attributes = {}) {
		if (kind !== 'webgl2') return getContext.call(this, kind, attributes);
		if (!made.has(this)) made.set(this, make(this, attributes));
		return made.get(this);
	};
});

/** Has a page's clock go on by a second at each look, so that Inspect takes each time as seldom as it may. For what is no matter of times. */
export const hurry = (page) => page.evaluate(() => {
	let now = performance.now();
	performance.now = () => (now += 1000);
});

/** The site that the test files of this process share, and how many of them use it. */
let [site, users] = [null, 0];

/** Begins: a server below a path of its own, and a browser. All test files of a process have the same ones, and use the same pages one after the other. */
export function begin() {
	users++;
	site ??= start();
	return site;
}

async function start() {
	if (!existsSync(path.join(folder, 'index.html'))) {
		throw new Error(`${folder} is not built: ./antw test builds it`);
	}
	const server = await serve(null, { '/any/where': folder }, { isKept: true });
	const browser = await launch();
	return {
		browser,
		url: `${server.url}any/where/`,
		async close() {
			if (--users > 0) return;
			site = null;
			await browser.close();
			server.close();
		},
	};
}

/** A page in a browser that remembers nothing; said is what came on the console, and from elsewhere. */
export async function newPage({ browser, url }, { isDrawn, ...options }) {
	const context = await browser.newContext({ reducedMotion: 'reduce', ...options });
	if (!isDrawn) await drawNothing(context);
	const page = await context.newPage();
	const said = [];
	page.on('console', (message) => saysItWaits(message.text()) || said.push(`${message.type()}: ${message.text()}`));
	page.on('pageerror', (error) => said.push(String(error)));
	page.on('request', (request) => {
		if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(url)) {
			said.push(`loaded ${request.url()}`);
		}
	});
	return { page, said };
}

/**
 * Leaves a page for an empty one of its site. about:blank would not do: Chromium may ask for the icon of the page that is left as late as there,
 * and says that about:blank must not load it.
 */
export async function goNowhere(page) {
	const empty = new URL('empty', page.url()).href;
	await page.route(empty, (route) => route.fulfill({ contentType: 'text/html', body: '<link rel="icon" href="data:,">' }));
	await page.goto(empty);
	await page.unroute(empty); // a page with routes keeps no files
}

/** Makes a page as good as new. A new one takes twice as long as one that is used again. */
async function forget({ page, said }) {
	for (const other of page.context().pages()) if (other !== page) await other.close();
	await page.unrouteAll();
	await page.evaluate(async () => {
		localStorage.clear();
		for (const { name } of await indexedDB.databases()) indexedDB.deleteDatabase(name);
	});
	await page.emulateMedia({ colorScheme: 'light' });
	await goNowhere(page);
	said.length = 0;
}

/** Pages that tests have left: by their browser, and its options. */
const left = new Map();

/**
 * Opens a view in a browser that remembers nothing.
 *
 * @param {object} site what begin gave
 * @param {string} hash the view, with its argument
 * @param {object} options of the browser's context; isDrawn has it draw 3D, which the processor does, and slowly
 * @returns {Promise<{page: object, said: string[], leave: () => Promise<void>}>} said is what came on the console, and from elsewhere; leave gives the page back
 */
export async function open(site, hash, { isDrawn = false, ...options } = SIZES.desktop) {
	if (!left.has(site.browser)) left.set(site.browser, new Map());
	const pages = left.get(site.browser);
	const { viewport, ...others } = options;
	const key = JSON.stringify({ isDrawn, ...others });
	const opened = pages.get(key)?.pop() ?? await newPage(site, { isDrawn, ...options });
	const { page, said } = opened;
	await page.setViewportSize(viewport);
	await page.goto(`${site.url}#${hash}`);
	await ready(page, hash.split('/')[0]);
	return {
		page,
		said,
		async leave() {
			await forget(opened);
			pages.set(key, [...pages.get(key) ?? [], opened]);
		},
	};
}

/** Gives the page that tests of a view share, at the size of a laptop. Views that have no address here have their name. */
export function sharing(addresses = {}) {
	const pages = {};
	return async (view) => {
		if (!pages[view]) {
			pages[view] = await open(await site, addresses[view] ?? view, SIZES.laptop);
			if (view === 'inspect') await hurry(pages[view].page);
		}
		return pages[view];
	};
}

/** Has a page's clipboard refuse all text. */
export const refuseCopies = (page) => page.evaluate(() => {
	navigator.clipboard.writeText = () => Promise.reject(new Error('refused'));
});

/** Has a page's clipboard keep its text in globalThis.copied. */
export const keepCopies = (page) => page.evaluate(() => {
	navigator.clipboard.writeText = (text) => {
		globalThis.copied = text;
		return Promise.resolve();
	};
});

/** Waits until Play's line says what a pattern matches. */
export const told = (page, { source }) => page.waitForFunction((pattern) => new RegExp(pattern).test(document.querySelector('.controls .status').textContent), source);

/** Taps on something; where Playwright knows no fingers, as in Firefox, it is clicked. */
export const tap = (target) => (isChromium ? target.tap() : target.click());

/** The text of the file that a page hands over when something is pressed. Playwright tells of it in Chromium alone: else it is what the page makes of it. */
export async function saved(page, press) {
	if (isChromium) {
		const [download] = await Promise.all([page.waitForEvent('download'), press()]);
		return readFileSync(await download.path(), 'utf8');
	}
	await page.evaluate(() => {
		const make = URL.createObjectURL;
		URL.createObjectURL = (blob) => {
			globalThis.handedOver = blob.text();
			return make.call(URL, blob);
		};
	});
	await press();
	return page.evaluate(() => globalThis.handedOver);
}

/** Keeps a page waiting for the files of an address, until what this gives is called. */
export async function hold(page, address) {
	let release;
	const held = new Promise((resolve) => {
		release = resolve;
	});
	await page.route(address, async (route) => {
		await held;
		await route.continue();
	});
	return release;
}

/** Opens an address in the page that is there. */
export const go = (page, hash) => page.evaluate((to) => {
	location.hash = to;
}, hash);

export const ready = (page, view) => page.waitForSelector(`main[data-ready="${view}"]`);

/** Presses a button, by what is on it. If it is in the menu of Play, the menu is opened first. */
export async function press(page, name) {
	const isInMenu = await page.evaluate((wanted) => [...document.querySelectorAll('.menu:not(:popover-open) button')].some(({ textContent }) => textContent === wanted), name);
	if (isInMenu) await page.locator('.tool-menu').click();
	await page.getByRole('button', { name, exact: true }).click();
}

/**
 * Waits until a page has done what it does within some milliseconds of its own clock: what was due by then, and two pictures. A busy page takes
 * longer.
 */
export const rest = (page, ms = 0) => page.evaluate((time) => new Promise((resolve) => {
	setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve))), time);
}), ms);

/** Has a page remember the tones that it makes from now on, in globalThis.tones: WebAudio's oscillators. */
export const listen = (page) => page.evaluate(() => {
	globalThis.tones = [];
	globalThis.AudioContext = class extends globalThis.AudioContext {
		createOscillator() {
			const made = super.createOscillator();
			globalThis.tones.push(made);
			return made;
		}
	};
});

/** Waits for the title of the program that is open in Play. */
export const titled = (page, title) => page.waitForFunction((wanted) => document.querySelector('.title').value === wanted, title);

/** Opens a program in Play from a file, as the user does. */
export async function openProgram(page, name, program) {
	await page.setInputFiles('.program input[type=file]', { name: `${name}.json`, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(program)) });
	await titled(page, name);
}

/** The user's own programs: their names. */
export const own = (page) => page.evaluate(() => globalThis.playground.programs.shelf.all.map(({ name }) => name));

/** What is called that has the focus. */
export const focused = (page) => page.evaluate(() => {
	const { activeElement: element } = document;
	return element.labels?.[0]?.textContent || element.getAttribute('aria-label') || element.textContent;
});

/** Presses the tab key until something has the focus that is called so, or begins so. */
export async function tabTo(page, name, key = 'Tab') {
	for (let i = 0; i < 70; i++) {
		if ((await focused(page)).startsWith(name)) return;
		await page.keyboard.press(key);
		// Blockly moves the focus on by itself
		await rest(page);
	}
	throw new Error(`the tab key does not come to “${name}”`);
}

/** Drops files on the page together, as the system does: each with its name and content. */
export async function drop(page, ...files) {
	const data = await page.evaluateHandle((all) => {
		const transfer = new DataTransfer();
		for (const [name, bytes] of all) transfer.items.add(new File([Uint8Array.from(bytes)], name));
		return transfer;
	}, files.map(([name, content]) => [name, [...content]]));
	await page.dispatchEvent('.world', 'drop', { dataTransfer: data });
}

/** What sends the touches of a finger to a page, in Chromium: touch('touchMove', { x, y }). */
export async function finger(page) {
	const client = await page.context().newCDPSession(page);
	return (type, ...touchPoints) => client.send('Input.dispatchTouchEvent', { type, touchPoints });
}

/** Drags from one place of the ground to another, with the mouse. */
export async function drag(page, from, to) {
	const [a, b] = await page.evaluate((places) => {
		const { stage } = globalThis.playground;
		const box = stage.canvas.getBoundingClientRect();
		return places.map(([x, y]) => {
			const at = stage.pixelOf(x, y, 0);
			return { x: box.left + at.x, y: box.top + at.y };
		});
	}, [from, to]);
	await page.mouse.move(a.x, a.y);
	await page.mouse.down();
	await page.mouse.move(b.x, b.y, { steps: 24 });
	await page.mouse.up();
	await rest(page, 100);
}
