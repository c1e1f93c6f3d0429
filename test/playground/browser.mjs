/** The playground in a headless browser with software GL, as a desktop's and a phone's browser show it. */
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { isChromium, launch } from '../headless/browsers.mjs';
import { serve } from '../headless/server.mjs';

export const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = path.join(root, 'bin/playground');

const ARGUMENTS = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage',
	'--disable-background-networking', '--no-first-run'];

/** The sizes that everything is tried at. The processor draws: of each two by two pixels one is enough. */
export const SIZES = {
	desktop: { viewport: { width: 1366, height: 820 }, deviceScaleFactor: 0.5 },
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

/** How long anything may take, in milliseconds. */
export const PATIENCE = 120000;

/** Lets a browser's context draw nothing in 3D, though all is as if it did: for what is no matter of pictures. The processor draws, and slowly. */
export const drawNothing = (context) => context.addInitScript(() => {
	for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) WebGL2RenderingContext.prototype[name] = () => {};
});

/** Begins: a server below a path of its own, and a browser. */
export async function begin() {
	if (!existsSync(path.join(folder, 'index.html'))) {
		throw new Error(`${folder} is not built: ./antw test builds it`);
	}
	const server = await serve(null, { '/any/where': folder });
	const browser = await launch(ARGUMENTS);
	return {
		browser,
		url: `${server.url}any/where/`,
		async close() {
			await browser.close();
			server.close();
		},
	};
}

/**
 * Opens a view in a browser of its own, which remembers nothing.
 *
 * @param {object} site what begin gave
 * @param {string} hash the view, with its argument
 * @param {object} options of the browser's context; isDrawn says whether it draws 3D
 * @returns {Promise<{page: object, context: object, said: string[]}>} said is what came on the console, and from elsewhere
 */
export async function open(site, hash, { isDrawn = true, ...options } = SIZES.desktop) {
	const context = await site.browser.newContext({ reducedMotion: 'reduce', ...options });
	// a machine that has other things to do is slow, and not broken
	context.setDefaultTimeout(PATIENCE);
	if (!isDrawn) await drawNothing(context);
	const page = await context.newPage();
	const said = [];
	page.on('console', (message) => said.push(`${message.type()}: ${message.text()}`));
	page.on('pageerror', (error) => said.push(String(error)));
	page.on('request', (request) => {
		if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(site.url)) {
			said.push(`loaded ${request.url()}`);
		}
	});
	await page.goto(`${site.url}#${hash}`);
	await ready(page, hash.split('/')[0]);
	return { page, context, said };
}

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

export const ready = (page, view) => page.waitForSelector(`main[data-ready="${view}"]`, { timeout: PATIENCE });
