/** The examples' pages, in one browser: each runs without errors, shows what it says, and fits on a phone. */
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { folder, groups, pages } from '../../build/examples/list.mjs';
import { open, root, serveExamples } from '../../build/examples/site.mjs';
import { launch } from '../headless/browsers.mjs';

const examples = groups().flatMap((group) => group.examples);
const LONGEST = 60;
const ARGUMENTS = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-accelerated-2d-canvas', '--disable-dev-shm-usage'];

/** What each page shows after so many frames: the numbers that it says, and what has to hold of them. */
const SHOWN = {
	'first-collision': [60, (touches) => touches > 40],
	'start-and-end': [200, (came, went, there) => came > 10 && went > 5 && came - went === there],
	separate: [120, (touches, deepest) => touches > 100 && deepest > 0 && deepest < 0.3],
	bullet: [150, (hits, misses, hitsWithout, missesWithout) => hits > 40 && misses === 0 && hitsWithout > 5 && missesWithout > 5],
	exact: [225, (spheres, tightest, trees, triangles, frames) => triangles > 10 && triangles < trees && trees < tightest && tightest < frames && spheres > 10],
	models: [120, (turns) => turns > 30],
	'nearest-and-cone': [60, (inFront, near, distance) => inFront > 0 && near > 0 && distance <= 3],
	ray: [120, (seen, all) => seen > 0 && seen < all],
	distance: [60, (distance) => distance > 0.5],
	slide: [300, (collected) => collected > 5],
	falling: [200, (landed, falling) => landed > 10 && falling > 0],
	filters: [100, (bounces) => bounces > 50],
	snapshot: [355, (times, same, different) => times === 1 && same === 116 && different === 0],
	'own-system': [100, (touches, across) => touches > 3 && across > 1],
	'ten-thousand': [15, (touches) => touches > 5000],
	'three-instances': [60, (bounces) => bounces > 100],
};

let site;
let browser;
before(async () => {
	site = await serveExamples();
	browser = await launch(ARGUMENTS);
});
after(async () => {
	await browser.close();
	site.close();
});

/** Opens an example as a phone shows it, and gives its page and all that was said on the console or was loaded from elsewhere. */
async function show(example, frames, options = {}) {
	const page = await browser.newPage({ viewport: { width: 390, height: 844 }, ...options });
	const said = [];
	page.on('console', (message) => /GPU stall/.test(message.text()) || said.push(message.text()));
	page.on('pageerror', (error) => said.push(String(error)));
	page.on('request', (request) => request.url().startsWith(new URL('/', site.url)) || /^(data|blob):/.test(request.url()) || said.push(request.url()));
	await open(page, site, example, frames);
	return { page, said };
}

const numbersOf = (text) => (text.match(/\d+(\.\d+)?/g) ?? []).map(Number);
const output = (page) => page.textContent('output');
const find = (name) => examples.find((example) => example.name === name);

/** How many colours the picture has. */
const coloursOf = (page) => page.evaluate(() => new Promise((resolve) => {
	requestAnimationFrame(() => {
		const canvas = document.querySelector('canvas');
		const context = new OffscreenCanvas(300, 200).getContext('2d');
		context.drawImage(canvas, 0, 0, 300, 200);
		resolve(new Set(new Uint32Array(context.getImageData(0, 0, 300, 200).data.buffer)).size);
	});
}));

test('every page has an entry in the index, and the index is as its script writes it', () => {
	const files = readdirSync(folder).filter((file) => file.endsWith('.html') && file !== 'index.html').map((file) => file.replace('.html', ''));
	assert.deepEqual(files.sort(), Object.keys(SHOWN).sort());
	assert.deepEqual(examples.map(({ name }) => name).filter((name) => !/^[A-Z]/.test(name)).sort(), files);
	for (const [file, text] of pages()) {
		assert.ok(readFileSync(path.join(folder, file), 'utf8') === text, `${file} is not what "node build/examples/index.mjs --cards" writes`);
	}
});

test('an example is one file of at most 60 lines, with a picture', () => {
	for (const { name, file } of examples) {
		const lines = readFileSync(path.join(folder, file), 'utf8').trimEnd().split('\n');
		assert.ok(lines.length <= LONGEST, `${file} has ${lines.length} lines`);
		const size = statSync(path.join(folder, `pictures/${name}.webp`)).size;
		assert.ok(size > 1000 && size < 100000, `${name}.webp has ${size} bytes`);
	}
});

test('the documentation has a link to each example', () => {
	const text = readdirSync(path.join(root, 'docs')).filter((file) => file.endsWith('.md')).map((file) => readFileSync(path.join(root, 'docs', file), 'utf8')).join('');
	for (const { name, file } of examples) assert.ok(text.includes(`](../examples/${file})`), `no page of docs/ has a link to ${name}`);
});

for (const [name, [frames, isShown]] of Object.entries(SHOWN)) {
	test(`${name} shows what it says`, { timeout: 60000 }, async () => {
		const { page, said } = await show(find(name), frames);
		const text = await output(page);
		assert.ok(isShown(...numbersOf(text)), text);
		const listing = await page.textContent('pre');
		assert.ok(readFileSync(path.join(folder, `${name}.html`), 'utf8').includes(listing), 'the code that is shown is that of the file');
		assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'it is no wider than a phone');
		if (name !== 'three-instances') assert.ok(await coloursOf(page) > 20);
		assert.deepEqual(said, []);
		await page.close();
	});
}

test('the pointer leads what is yours, Play goes on, and dark is dark', { timeout: 60000 }, async () => {
	const { page, said } = await show(find('first-collision'), 5, { colorScheme: 'dark' });
	const before = numbersOf(await output(page))[0];
	const box = await page.locator('canvas').boundingBox();
	await page.mouse.move(box.x + 30, box.y + 30);
	await page.getByRole('button', { name: 'Play' }).click();
	await page.waitForFunction((touches) => Number.parseInt(document.querySelector('output').textContent) > touches + 5, before);
	assert.equal(await page.getByRole('button', { name: 'Pause' }).count(), 1);
	const shade = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
	assert.ok(Math.max(...shade) < 60, `${shade}`);
	assert.deepEqual(said, []);
	await page.close();
});

test('keys move the player that slides, and no wall lets it through', { timeout: 60000 }, async () => {
	const { page } = await show(find('slide'), 1);
	await page.keyboard.down('ArrowRight');
	await page.getByRole('button', { name: 'Play' }).click();
	await page.waitForFunction(() => document.querySelector('output').textContent.startsWith('2 '));
	await page.waitForFunction((frame) => Number(document.documentElement.dataset.frame) > frame + 40, Number(await page.evaluate(() => document.documentElement.dataset.frame)));
	assert.match(await output(page), /^2 collected, in a wall: no$/);
	await page.close();
});

test('a colour that is ticked again is filtered no more', { timeout: 60000 }, async () => {
	const { page } = await show(find('filters'), 5);
	assert.match(await output(page), /left out: green$/);
	await page.getByLabel('green').check();
	await page.getByRole('button', { name: 'Play' }).click();
	await page.waitForFunction(() => document.querySelector('output').textContent.endsWith('left out: none'));
	await page.close();
});

test('opened as a file, a page says what it needs', { timeout: 60000 }, async () => {
	const page = await browser.newPage();
	await page.goto(`file://${path.join(folder, 'first-collision.html')}`);
	assert.match(await page.textContent('.notice'), /antw examples/);
	assert.match(await page.textContent('pre'), /onCollision/);
	await page.close();
});

test('links of the index lead somewhere', async () => {
	const html = readFileSync(path.join(folder, 'index.html'), 'utf8');
	const targets = [...html.matchAll(/(?:href|src)="(?!\w+:)([^"#?]+)[^"]*"/g)].map(([, target]) => target);
	assert.ok(targets.length > 2 * examples.length);
	for (const target of targets) assert.ok(existsSync(path.join(folder, target)), target);
});
