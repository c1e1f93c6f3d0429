/** The page that the playground writes of a program, drawn with three.js; and the page that says how a class gets the playground. */
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { after, before, test } from 'node:test';
import { createRequire } from 'node:module';
import { serve } from '../../build/headless/server.mjs';
import { SIZES, begin, open, press, root, saved } from './browser.mjs';

const jsQR = createRequire(path.join(root, 'js/playground/package.json'))('jsqr');

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

test('a program is downloaded as a page that three.js draws, and plays it by keys; opened without what it needs, it says so', async () => {
	const folder = mkdtempSync(path.join(os.tmpdir(), 'page-'));
	const npm = path.join(root, 'js/playground/node_modules');
	const server = await serve(null, { '/node_modules/starlogo-collision': path.join(root, 'bin/module'), '/node_modules/three': path.join(npm, 'three'), '': folder });
	try {
		for (const [game, key] of [['paintball', 'ArrowUp'], ['jump', 'ArrowRight'], ['hills', 'ArrowUp'], ['drive', 'ArrowUp']]) {
			const { page, leave } = await open(site, `play/${game}`, SIZES.laptop);
			await page.waitForFunction(() => globalThis.playground?.editor);
			await press(page, 'This program as JavaScript');
			const html = await saved(page, () => page.getByRole('button', { name: 'Download a page' }).click());
			assert.match(html, /npm install three@0\.180\.0 /);
			const [, hero] = /const HERO = "(\w+)"/.exec(html);
			writeFileSync(path.join(folder, `${game}.html`), html);
			await leave();
			// by a double click it says what it needs
			const clicked = await site.browser.newPage();
			await clicked.goto(pathToFileURL(path.join(folder, `${game}.html`)).href);
			await clicked.locator('.needs').waitFor();
			assert.match(await clicked.locator('.needs').innerText(), new RegExp(`^This page needs [^]*npm install three@[^]*npx http-server[^]*http://localhost:8080/\\S+\\.html$`));
			await clicked.close();
			const context = await site.browser.newContext({ viewport: { width: 480, height: 320 }, deviceScaleFactor: 1 });
			const drawn = await context.newPage();
			const said = [];
			drawn.on('pageerror', (error) => said.push(String(error)));
			drawn.on('console', (message) => message.type() === 'error' && said.push(message.text()));
			await drawn.route('**/favicon.ico', (route) => route.fulfill({ body: '' }));
			await drawn.goto(`${server.url}${game}.html`);
			await drawn.waitForFunction(() => globalThis.game?.frame > 5, null, { timeout: 20000 }).catch(() => {});
			assert.deepEqual(said, [], game);
			const placeOf = () => drawn.evaluate((breed) => {
				const agent = globalThis.agents.find((each) => each.breed === breed);
				return [agent.x, agent.y];
			}, hero);
			const from = await placeOf();
			await drawn.keyboard.down(key);
			await drawn.waitForFunction(([breed, [x, y]]) => {
				const agent = globalThis.agents.find((each) => each.breed === breed);
				return Math.hypot(agent.x - x, agent.y - y) > 0.3;
			}, [hero, from]);
			await drawn.keyboard.up(key);
			const colours = await drawn.evaluate(() => new Promise((resolve) => {
				requestAnimationFrame(() => {
					const canvas = document.querySelector('canvas');
					const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
					copy.drawImage(canvas, 0, 0);
					resolve(new Set(new Uint32Array(copy.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size);
				});
			}));
			assert.ok(colours > 8, `${game}: ${colours} colours are drawn`);
			if (process.env.PICTURES) await drawn.screenshot({ path: path.join(process.env.PICTURES, `export-${game}.png`) });
			assert.match(await drawn.textContent('p'), /\S/);
			assert.deepEqual(said, [], game);
			await context.close();
		}
	} finally {
		server.close();
		rmSync(folder, { recursive: true });
	}
});

test('the page “In class” says how to serve, and its QR code leads to what is chosen', async () => {
	const { page, said, leave } = await open(site, 'teach', SIZES.laptop);
	await page.getByRole('link', { name: 'In class', exact: true }).click();
	await page.waitForSelector('[data-drawn="in-class"]');
	for (const words of ['python3 -m http.server', 'npx http-server', './antw playground -Dhost=0.0.0.0', 'starlogo-nova.html']) assert.ok((await page.textContent('.sheet')).includes(words), words);
	// loopback is only this computer
	assert.ok(await page.locator('.busy').isVisible());
	assert.equal(await page.locator('.sheet .address').getAttribute('href'), `${site.url}#play/all`);
	await page.getByLabel('Address of the page').fill('http://192.168.0.10:8080/');
	assert.ok(await page.locator('.busy').isHidden());
	await page.getByLabel('What opens').selectOption('lesson-wing');
	const link = 'http://192.168.0.10:8080/#play/lesson-wing';
	assert.equal(await page.locator('.sheet .address').getAttribute('href'), link);
	const read = await page.evaluate(async () => {
		const svg = document.querySelector('.qr').cloneNode(true);
		for (const [name, value] of Object.entries({ xmlns: 'http://www.w3.org/2000/svg', width: 300, height: 300 })) svg.setAttribute(name, value);
		const image = new Image();
		image.src = `data:image/svg+xml,${encodeURIComponent(svg.outerHTML)}`;
		await image.decode();
		const context = new OffscreenCanvas(300, 300).getContext('2d');
		context.drawImage(image, 0, 0);
		return [...context.getImageData(0, 0, 300, 300).data];
	});
	assert.equal(jsQR(Uint8ClampedArray.from(read), 300, 300).data, link);
	await page.getByLabel('Address of the page').fill('nonsense');
	assert.ok(await page.locator('.busy').isVisible());
	assert.equal(await page.locator('.qr').count(), 0);
	assert.deepEqual(said.splice(0), []);
	await leave();
});
