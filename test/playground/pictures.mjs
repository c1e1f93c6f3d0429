#!/usr/bin/env node
/**
 * Makes pictures of every view, to look at: in five sizes, light and dark, English and German.
 *
 *   node test/playground/pictures.mjs OUT [PATTERN]     PATTERN: of their names, as "play-lesson" or "390x844-dark-de"
 */
import { mkdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { begin, drag, ready, rest, root } from './browser.mjs';

const SIZES = [[1366, 625], [1366, 768], [390, 844], [844, 390], [1920, 1080]];
/** A model of the user's own. */
const OWN = { name: 'my-fortress.obj', mimeType: 'model/obj', buffer: readFileSync(path.join(root, 'assets/fortress.obj')) };
/** A phone shows so much of a page, in several pictures. */
const PAGES = 3;
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
/** Opens the blocks, where a small window shows one of the two parts. */
const openBlocks = async (page) => {
	const blocks = page.locator('[data-tab="program"]');
	if (await blocks.isVisible()) await blocks.click();
};
const openSettings = async (page) => {
	const settings = page.locator('.settings');
	if (await settings.getAttribute('aria-expanded') === 'false') await settings.click();
};
/** Turns “Build” on, and takes one of its brushes. */
const build = async (page, brush) => {
	await page.locator('.corner .tick input').check();
	await page.locator(`[data-brush="${brush}"]`).click();
};
/** The game of an empty program of the user's own. */
const openNew = async (page) => {
	await page.evaluate(() => globalThis.playground.programs.openNew());
	await page.waitForFunction(() => globalThis.playground.world.agents.length === 1);
};
const openMenu = async (page, at) => {
	await openBlocks(page);
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
		await openSettings(page);
		await page.locator('.game .tools .tick input').first().check();
		await frames(page, 60);
		await page.locator('summary').first().click();
	}],
	'play-beside': ['play/helmet', async (page) => {
		await openSettings(page);
		await page.locator('.game select').nth(1).selectOption('exact');
		await page.waitForSelector('.differences');
		for (let i = 0; i < 5; i++) await page.locator('.controls button').nth(1).click();
	}],
	'play-blocks': ['play/hills', async (page) => {
		await openBlocks(page);
		await page.locator('.blocklyToolboxCategory').nth(2).click();
	}],
	'play-lesson-blocks': ['play/lesson-room', async (page) => {
		await openBlocks(page);
		await page.locator('.blocklyToolboxCategory').nth(1).click();
	}],
	'play-lesson-first': ['play/lesson-blocks', () => {}],
	'play-lesson-last': ['play/lesson-jump', (page) => frames(page, 5)],
	'play-new': ['play/paintball', openNew],
	'play-settings': ['play/jump', async (page) => {
		await openSettings(page);
		await frames(page, 30);
	}],
	'play-build': ['play/jump', async (page) => {
		await build(page, 'agents');
		await page.locator('.cast button').nth(1).evaluate((each) => each.click());
	}],
	'play-ground': ['play/paintball', async (page) => {
		await openNew(page);
		await build(page, 'raise');
		await drag(page, [-3, -5], [3, -5]);
	}],
	'play-walls': ['play/paintball', async (page) => {
		await openNew(page);
		await build(page, 'wall');
		await drag(page, [-5, 5], [5, 5]);
		await drag(page, [-5, 5], [-5, 1]);
	}],
	'play-model': ['play/paintball', async (page) => {
		await page.setInputFiles('.program input[type=file]', OWN);
		await rest(page, 1000);
	}],
	'play-error': ['play/maze', async (page) => {
		await page.setInputFiles('.program input[type=file]', { name: 'endless.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(ENDLESS)) });
		await page.waitForSelector('.status.problem');
	}],
	'play-javascript': ['play/maze', (page) => openMenu(page, 5)],
	'play-menu': ['play/maze', async (page) => {
		await openBlocks(page);
		await page.locator('.tool-menu').click();
	}],
	'play-handin': ['play/maze', async (page) => {
		await openMenu(page, 1);
		await openMenu(page, 7);
	}],
	inspect: ['inspect', (page) => page.waitForFunction(() => /\d/.test(document.querySelector('.status').textContent) && !document.querySelector('[aria-busy]'))],
	'inspect-questions': ['inspect', async (page) => {
		await page.locator('input[value=questions]').check();
		await page.waitForFunction(() => /\d/.test(document.querySelector('.answers .meeting dd')?.textContent));
	}],
	'inspect-own': ['inspect', async (page) => {
		await page.setInputFiles('input[type=file]', OWN);
		await page.waitForFunction(() => /my-fortress/.test(document.querySelector('.status').textContent) && !document.querySelector('[aria-busy]'));
	}],
	compare: ['compare', () => {}],
	'compare-own': ['compare', async (page) => {
		await page.setInputFiles('input[type=file]', OWN);
		await rest(page, 1000);
	}],
	'compare-game': ['compare/game~tightest-fits~exact~3', (page) => page.waitForFunction(() => [...document.querySelectorAll('.scattered tr:is([data-system], [data-reference])')].every(({ lastChild }) => /^\d/.test(lastChild.textContent)))],
	measure: ['measure', async (page) => {
		await page.locator('.live .tools button').click();
		await page.waitForFunction(() => globalThis.playground.live.parts.count >= 13);
		await page.locator('.live .tools button').click();
	}],
	'measure-beside': ['measure', async (page) => {
		for (const box of await page.locator('.live .tools .tick input').all()) await box.check();
		await page.locator('.live .tools button').click();
		await page.waitForFunction(() => globalThis.playground.live.parts.count >= 100, null, { timeout: 120_000 });
		await page.locator('.live .tools button').click();
	}],
	'measure-own': ['measure', async (page) => {
		await page.locator('.live').dispatchEvent('drop', { dataTransfer: await page.evaluateHandle((bytes) => {
			const transfer = new DataTransfer();
			transfer.items.add(new File([Uint8Array.from(bytes)], 'my-fortress.obj'));
			return transfer;
		}, [...OWN.buffer]) });
		await page.waitForFunction(() => [...document.querySelectorAll('.live select option')].some(({ value, selected }) => value === 'my-fortress.obj' && selected));
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
	'teach-in-class': ['teach/in-class', async (page) => {
		await page.waitForSelector('[data-drawn="in-class"]');
		await page.locator('input[type=url]').fill('http://192.168.1.20:8080/');
	}],
};

const [out, pattern = ''] = process.argv.slice(2);
mkdirSync(out, { recursive: true });
const site = await begin();
const isWanted = (name) => new RegExp(pattern).test(name);
/** Makes the pictures of a view that are wanted, of one size and language: light and dark are the same page, which changes its colours. */
async function picture(view, [width, height], code) {
	const pictures = ['light', 'dark'].map((scheme) => [scheme, `${view}-${width}x${height}-${scheme}-${code}`]).filter(([, name]) => isWanted(name));
	if (pictures.length === 0) return;
	const isPhone = Math.min(width, height) < 500;
	const context = await site.browser.newContext({ viewport: { width, height }, colorScheme: pictures[0][0], locale: code, reducedMotion: 'reduce', ...(isPhone && { hasTouch: true, isMobile: true }) });
	context.setDefaultTimeout(30000);
	const page = await context.newPage();
	const [address, prepare] = VIEWS[view];
	try {
		await page.goto(`${site.url}#${address}`);
		await ready(page, address.split('/')[0]);
		await prepare(page);
	} catch (error) {
		// its picture shows where it stands
		console.log(`${view}-${width}x${height}-${code}: ${error.message}`);
		process.exitCode = 1;
	}
	for (const [scheme, name] of pictures) {
		await page.emulateMedia({ colorScheme: scheme });
		await rest(page, 200);
		// not as one picture of the whole page, for which the window would change
		const count = isPhone ? Math.min(PAGES, await page.evaluate(() => Math.ceil((document.documentElement.scrollHeight - 40) / innerHeight))) : 1;
		for (let i = 0; i < count; i++) {
			await page.evaluate((at) => scrollTo(0, at * (innerHeight - 60)), i);
			await rest(page, i > 0 ? 100 : 0);
			await page.screenshot({ path: path.join(out, `${name}${i > 0 ? `-${i + 1}` : ''}.png`) });
		}
		console.log(name);
	}
	await context.close();
}
for (const view of Object.keys(VIEWS)) for (const size of SIZES) for (const code of ['en', 'de']) await picture(view, size, code);
await site.close();
