/** The examples on their pages, in one browser: each runs without errors, shows what it says, and fits on a phone. SWFs run in the embedded player. */
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { folder, groups, isSwf } from '../../build/examples/list.mjs';
import { open, serveExamples } from '../../build/examples/site.mjs';
import { isChromium, launchOwn } from '../../build/headless/browsers.mjs';
import { assertNone, differences } from '../structure/sources.mjs';

const examples = groups().flatMap((group) => group.examples);

/** For each example the frame to look at, and a condition on the numbers in its text then. */
const SHOWN = {
	'first-collision': [60, (touches) => touches > 40],
	'start-and-end': [200, (came, went, there) => came > 10 && went > 5 && came - went === there],
	separate: [120, (touches, deepest) => touches > 100 && deepest > 0 && deepest < 0.3],
	bullet: [150, (hits, misses, hitsWithout, missesWithout) => hits === 25 && misses === 0 && hitsWithout > 3 && missesWithout > 3],
	exact: [225, (spheres, tightest, trees, triangles, frames) => triangles > 10 && triangles < trees && trees < tightest && tightest < frames && spheres > 10],
	models: [120, (turns) => turns > 30],
	'nearest-and-cone': [60, (inFront, near, distance) => inFront > 0 && near > 0 && distance <= 3],
	ray: [120, (seen, all) => seen > 0 && seen < all],
	distance: [60, (distance) => distance > 0.5],
	slide: [300, (collected) => collected > 5],
	walk: [900, (jumps, things) => jumps > 0 && things > 4],
	'one-way': [1200, (landed, dropped) => landed > 3 && dropped > 0],
	camera: [600, (frames, shortened, inWalls) => frames === 600 && shortened > 60 && shortened < 540 && inWalls === 0],
	falling: [200, (landed, falling) => landed > 10 && falling > 0],
	hills: [260, (touching, all, seen) => touching > 3 && touching < all && seen > 0 && seen < all],
	filters: [100, (bounces) => bounces > 50],
	snapshot: [355, (times, same, different) => times === 1 && same === 116 && different === 0],
	'own-system': [100, (touches, across) => touches > 3 && across > 1],
	'ten-thousand': [15, (touches) => touches > 5000],
	'three-instances': [60, (bounces) => bounces > 100],
	FirstCollision: [120, (touches) => touches > 100],
	Contacts: [60, (touches, deepest) => touches > 60 && deepest > 0 && deepest < 0.3],
	Sweeps: [120, (hits, passes, hitsWithout, passesWithout) => hits > 10 && passes === 0 && hitsWithout > 2 && passesWithout > 2],
	Questions: [60, (inFront, near) => inFront > 0 && near > 0],
	OwnModel: [60, (level) => level === 1],
};

let site;
let browser;
let page;
const said = [];

// one page for all: a new one for each takes three times as long
before(async () => {
	site = await serveExamples();
	browser = await launchOwn(['--disable-gpu']);
	page = await browser.newPage({ viewport: { width: 390, height: 844 } });
	page.on('console', (message) => isOfPlayer(message) || /GPU stall/.test(message.text()) || said.push(message.text()));
	page.on('pageerror', (error) => said.push(String(error)));
	// the player's other ways to draw take seconds to begin without a graphics card
	await page.addInitScript(() => { globalThis.RufflePlayer = { config: { preferredRenderer: 'canvas' } }; });
	page.on('request', (request) => request.url().startsWith(new URL('/', site.url)) || /^(data|blob):/.test(request.url()) || said.push(request.url()));
});
after(async () => {
	await browser?.close();
	site.close();
});

/** What the Flash player says of itself, and no error. */
const isOfPlayer = (message) => message.type() !== 'error' && page.url().includes('/flash/');
/** Opens an example as a phone shows it. */
const show = (name, frames) => open(page, site, examples.find((example) => example.name === name), frames);
const numbersOf = (text) => (text.match(/\d+(\.\d+)?/g) ?? []).map(Number);
const output = () => page.textContent('output');

/** How many colours the picture has. */
const colours = () => page.evaluate(() => new Promise((resolve) => {
	requestAnimationFrame(() => {
		const canvas = document.querySelector('canvas');
		const context = new OffscreenCanvas(300, 200).getContext('2d');
		context.drawImage(canvas, 0, 0, 300, 200);
		resolve(new Set(new Uint32Array(context.getImageData(0, 0, 300, 200).data.buffer)).size);
	});
}));

test('SHOWN has each example', () => {
	assertNone(differences('SHOWN', Object.keys(SHOWN), examples.map(({ name }) => name)));
});

for (const { name, title, file } of examples) {
	test(`${name} shows what it says`, async () => {
		const [frames, isShown] = SHOWN[name];
		await show(name, frames);
		const text = await output();
		assert.ok(isShown(...numbersOf(text)), text);
		const listing = await page.textContent('pre');
		assert.ok(listing.length > 500 && readFileSync(path.join(folder, file), 'utf8').includes(listing), 'the code that is shown is that of the file');
		assert.equal(await page.title(), title);
		assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'it is no wider than a phone');
		assert.equal(await page.evaluate(() => { const { scrollWidth, clientWidth } = document.querySelector('pre'); return scrollWidth - clientWidth; }), 0, 'no code is cut off');
		if (!isSwf(name) && name !== 'three-instances') assert.ok(await colours() > 20);
		assert.deepEqual(said.splice(0), []);
	});
}

test('the pointer leads what is yours, Play goes on, and dark is dark', async () => {
	await page.emulateMedia({ colorScheme: 'dark' });
	await show('first-collision', 5);
	const before = numbersOf(await output())[0];
	const box = await page.locator('canvas').boundingBox();
	await page.mouse.move(box.x + 30, box.y + 30);
	await page.getByRole('button', { name: 'Play' }).click();
	await page.waitForFunction((touches) => Number.parseInt(document.querySelector('output').textContent) > touches + 5, before);
	assert.equal(await page.getByRole('button', { name: 'Pause' }).count(), 1);
	if (isChromium) { // Playwright asks no other browser here for dark pages
		const shade = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
		assert.ok(Math.max(...shade) < 60, `${shade}`);
	}
	assert.deepEqual(said.splice(0), []);
	await page.emulateMedia({ colorScheme: null });
});

test('keys move the player that slides, and no wall lets it through', async () => {
	await show('slide', 1);
	await page.keyboard.down('ArrowRight');
	await page.getByRole('button', { name: 'Play' }).click();
	await page.waitForFunction(() => document.querySelector('output').textContent.startsWith('2 '));
	await page.waitForFunction((frame) => Number(document.documentElement.dataset.frame) > frame + 40, Number(await page.evaluate(() => document.documentElement.dataset.frame)));
	assert.match(await output(), /^2 collected, in a wall: no$/);
	await page.keyboard.up('ArrowRight');
	assert.deepEqual(said.splice(0), []);
});

test('a colour that is ticked again is filtered no more', async () => {
	await show('filters', 5);
	assert.match(await output(), /left out: green$/);
	await page.getByLabel('green').check();
	await page.getByRole('button', { name: 'Play' }).click();
	await page.waitForFunction(() => document.querySelector('output').textContent.endsWith('left out: none'));
	assert.deepEqual(said.splice(0), []);
});

test('in the level and with three.js, nothing is wider than a phone, and buttons lead the player', async () => {
	const phone = await browser.newPage({ viewport: { width: 390, height: 844 }, ...(isChromium && { hasTouch: true, isMobile: true }) });
	phone.on('pageerror', (error) => said.push(String(error)));
	for (const [folderOf, done] of [['three', /^A (bear|seagull) turns/], ['level', /^[\d.]+ ms a frame.* 0 bullets.*; 0 shots, 0 hits$/]]) {
		await phone.goto(`${site.url}${folderOf}/index.html`);
		await phone.waitForFunction(([source]) => new RegExp(source).test(document.querySelector('output').textContent), [done.source]);
		assert.ok(await phone.evaluate(() => [...document.querySelectorAll('output, p, button')].every((each) => each.getBoundingClientRect().right <= innerWidth)), folderOf);
	}
	if (isChromium) { // no other browser pretends to be a phone
		const shoot = phone.getByRole('button', { name: 'shoot' });
		assert.ok(await phone.locator('p').isHidden() && await shoot.isVisible());
		await shoot.tap();
		await phone.waitForFunction(() => / 1 bullet .*; 1 shot, /.test(document.querySelector('output').textContent));
	}
	await phone.close();
	assert.deepEqual(said.splice(0), []);
});

test('the level and the three.js page say so if one of their files does not come', async () => {
	const other = await browser.newPage();
	for (const file of ['**/*.glb', '**/three.module.js']) {
		await other.route(file, (route) => route.abort());
		for (const name of ['level', 'three']) {
			await other.goto(`${site.url}${name}/index.html`);
			await other.waitForFunction(() => /did not load/.test(document.querySelector('output').textContent));
		}
		await other.unroute(file);
	}
	await other.close();
});

test('opened as a file, a page says what it needs', async () => {
	await page.goto(`file://${path.join(folder, 'first-collision.html')}`);
	assert.match(await page.textContent('.notice'), /antw examples/);
	assert.match(await page.textContent('pre'), /onCollision/);
	said.length = 0; // the browser says that it refuses the module
});

test('links of the index lead somewhere', async () => {
	const html = readFileSync(path.join(folder, 'index.html'), 'utf8');
	const targets = [...html.matchAll(/(?:href|src)="(?!\w+:)([^"#?]+)[^"]*"/g)].map(([, target]) => target);
	assert.ok(targets.length > 2 * examples.length);
	for (const target of targets) assert.ok(existsSync(path.join(folder, target)), target);
});
