#!/usr/bin/env node
/**
 * Makes pictures of every view, to look at: in five sizes, light and dark, English and German.
 *
 *   node test/playground/pictures.mjs OUT [PATTERN]     PATTERN: of their names, as "play-lesson" or "390x844-dark-de"
 */
import { mkdirSync } from 'node:fs';
import path from 'node:path';
import { begin, ready, rest } from './browser.mjs';

const SIZES = [[1366, 625], [1366, 768], [390, 844], [844, 390], [1920, 1080]];
const script = (type, DO) => ({ blocks: { blocks: [{ type, inputs: { DO: { block: DO } } }] } });
const ENDLESS = script('starlogo_start', { type: 'controls_whileUntil', fields: { MODE: 'WHILE' }, inputs: { BOOL: { block: { type: 'logic_boolean', fields: { BOOL: 'TRUE' } } } } });
const BEARS = script('starlogo_start', { type: 'starlogo_create', fields: { BREED: 'bears', SHAPE: 'bear' }, inputs: { COUNT: { shadow: { type: 'math_number', fields: { NUM: 3 } } } } });
const WORKS = ['Ada', 'Ben', 'Cem', 'Dora', 'Efe'].map((pupil, i) => ({ name: `${pupil}.json`, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify({
	kind: 'starlogo-nova-work', pupil, done: ['helmet', 'wing', 'fast'].slice(0, i), won: i > 2 ? ['maze'] : [], programs: [{ name: 'Blocks make turtles move (mine)', lesson: 'blocks', program: BEARS }, { name: 'Mine', program: BEARS }].slice(0, i),
})) }));

const frames = (page, count) => page.evaluate((wanted) => {
	const view = globalThis.playground;
	for (let i = 0; i < wanted; i++) view.world.step();
	view.draw();
}, count);
const openMenu = async (page, at) => {
	const blocks = page.locator('[data-tab="program"]');
	if (await blocks.isVisible()) await blocks.click();
	await page.locator('.tool-menu').click();
	await page.locator('.menu button').nth(at).click();
};

/** Each view: its address, and what is done there before its picture is made. */
const VIEWS = {
	'play-home': ['play/all', (page) => page.waitForSelector('.gallery[data-drawn], .gallery [data-drawn]')],
	'play-lesson': ['play/lesson-wing', async (page) => {
		await page.locator('.run').click();
		await page.waitForFunction(() => document.querySelector('.why').textContent !== '');
		await page.locator('.run').click();
	}],
	'play-lesson-long': ['play/lesson-see', (page) => page.locator('.hint-button').click()],
	'play-game': ['play/paintball', (page) => frames(page, 30)],
	'play-sees': ['play/chase', async (page) => {
		await page.locator('.game .tick input').first().check();
		await frames(page, 60);
		await page.locator('summary').first().click();
	}],
	'play-beside': ['play/helmet', async (page) => {
		await page.locator('.game select').nth(1).selectOption('exact');
		await page.waitForSelector('.differences');
		for (let i = 0; i < 5; i++) await page.locator('.controls button').nth(1).click();
	}],
	'play-blocks': ['play/hills', async (page) => {
		const blocks = page.locator('[data-tab="program"]');
		if (await blocks.isVisible()) await blocks.click();
		await page.locator('.blocklyToolboxCategory').nth(2).click();
	}],
	'play-error': ['play/maze', async (page) => {
		await page.setInputFiles('.program input[type=file]', { name: 'endless.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(ENDLESS)) });
		await page.waitForSelector('.status.problem');
	}],
	'play-javascript': ['play/maze', (page) => openMenu(page, 5)],
	'play-handin': ['play/maze', (page) => openMenu(page, 7)],
	inspect: ['inspect', (page) => page.waitForFunction(() => /\d/.test(document.querySelector('.status').textContent) && !document.querySelector('[aria-busy]'))],
	'inspect-questions': ['inspect', async (page) => {
		await page.locator('input[value=questions]').check();
		await page.waitForFunction(() => /\d/.test(document.querySelector('.answers .meeting dd').textContent));
	}],
	compare: ['compare', () => {}],
	'compare-game': ['compare/game~tightest-fits~exact~3', (page) => page.waitForFunction(() => [...document.querySelectorAll('.scattered tr:is([data-system], [data-reference])')].every(({ lastChild }) => /^\d/.test(lastChild.textContent)))],
	measure: ['measure', async (page) => {
		await page.locator('.live .tools button').click();
		await page.waitForFunction(() => globalThis.playground.live.parts.count >= 13);
		await page.locator('.live .tools button').click();
	}],
	'measure-series': ['measure', async (page) => {
		await page.locator('input[value=series]').check();
		await page.locator('.measuring select').first().selectOption('100');
		await page.locator('.measuring button').first().click();
		await page.waitForFunction(() => document.querySelectorAll('.chart path').length > 15 && !globalThis.playground.keepers[0].disabled);
	}],
	level: ['level', (page) => page.evaluate(() => {
		for (let i = 0; i < 200; i++) globalThis.playground.step();
		globalThis.playground.draw();
	})],
	'level-source': ['level', (page) => page.evaluate(() => {
		document.querySelector('.code').open = true;
	})],
	teach: ['teach', () => {}],
	'teach-lesson': ['teach/room', (page) => page.waitForSelector('[data-drawn="room"]')],
	'teach-class': ['teach/class', async (page) => {
		await page.setInputFiles('input[type=file]', WORKS);
		await page.waitForSelector('[data-drawn="class"]');
	}],
	'teach-program': ['teach/maze', (page) => page.waitForSelector('[data-drawn="maze"]')],
};

const [out, pattern = ''] = process.argv.slice(2);
mkdirSync(out, { recursive: true });
const site = await begin();
const all = Object.keys(VIEWS).flatMap((view) => SIZES.flatMap(([width, height]) => ['light', 'dark'].flatMap((scheme) => ['en', 'de'].map((code) => ({ view, width, height, scheme, code, name: `${view}-${width}x${height}-${scheme}-${code}` })))))
	.filter(({ name }) => new RegExp(pattern).test(name));
for (const { view, width, height, scheme, code, name } of all) {
	const context = await site.browser.newContext({ viewport: { width, height }, colorScheme: scheme, locale: code, reducedMotion: 'reduce', ...(Math.min(width, height) < 500 && { hasTouch: true, isMobile: true }) });
	const page = await context.newPage();
	const [address, prepare] = VIEWS[view];
	await page.goto(`${site.url}#${address}`);
	await ready(page, address.split('/')[0]);
	await prepare(page);
	await rest(page, 200);
	await page.screenshot({ path: path.join(out, `${name}.png`), fullPage: Math.min(width, height) < 500 });
	console.log(name);
	await context.close();
}
await site.close();
