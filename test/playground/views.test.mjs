/** Inspect and Compare, and what goes for every view, in the browser. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { isChromium } from '../../build/headless/browsers.mjs';
import { serve } from '../../build/headless/server.mjs';
import { SIZES, begin, dragBall, drop, goNowhere, hold, hurry, open, press, ready, refuseCopies, rest, root, sharing } from './browser.mjs';

const VIEWS = ['play', 'inspect', 'compare', 'measure', 'level', 'teach'];
/** What is looked at of Play: a game, not the first screen. */
const ADDRESSES = { play: 'play/paintball' };
/** What else a view shows, by what is there then. */
const MORE = { play: { '.gallery [data-drawn], .gallery[data-drawn]': 'play/all', '.lesson:visible': 'play/lesson-wing' }, teach: { '[data-drawn]': 'teach/see' } };
/** The colours in which a phone shows a view: every other view is light, the others are dark; with -Dfull each is both. A desktop shows both. */
const schemesOf = (view) => ['light', 'dark'].filter((_, i) => process.env.FULL_TESTS === 'true' || i === VIEWS.indexOf(view) % 2);
const axe = readFileSync(path.join(root, 'js/playground/node_modules/axe-core/axe.min.js'), 'utf8');
const counts = JSON.parse(readFileSync(path.join(root, 'test/fixtures/playground/scattered.json'), 'utf8'));

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

const shared = sharing(ADDRESSES);

/** A page of a view, in which nothing may be said on the console and nothing comes from elsewhere, whatever is tried there. */
for (const view of VIEWS) {
	test(`${view} on a desktop`, async (t) => {
		const { page, said, leave } = await open(site, ADDRESSES[view] ?? view, { ...SIZES.desktop, isDrawn: true });
		await t.test('what is there stays where it is', () => staysInPlace(page));
		await t.test('Blockly comes with Play alone', async () => {
			const files = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname));
			const withBlockly = files.filter((file) => file.endsWith('.js')).map((file) => path.join(root, 'bin/playground', file.replace('/any/where/', '')))
				.filter((file) => readFileSync(file, 'utf8').includes('blocklyMainBackground'));
			assert.equal(withBlockly.length, view === 'play' ? 1 : 0);
			assert.ok(!files.some((file) => file.includes('formats')), 'readers of files come with the first file');
		});
		await t.test('axe-core finds no fault, in light and dark', async () => {
			await faultless(page, 'light');
			await faultless(page, 'dark', true);
		});
		await t.test('every control is reached by the tab key, and shows it', () => reachesAll(page, isChromium));
		if (view === 'inspect') {
			await t.test('so is every control of its questions, which the keyboard opens', async () => {
				await page.getByLabel('Structures', { exact: true }).focus();
				await page.keyboard.press('ArrowRight');
				await page.waitForSelector('.answers:visible');
				await page.waitForFunction(() => /apart/.test(document.querySelector('.answers .meeting dd')?.textContent));
				await reachesAll(page, isChromium);
				await faultless(page, 'light');
			});
		}
		if (view === 'play') {
			await t.test('axe-core finds no fault in the first screen and in a lesson', async () => {
				await page.getByRole('button', { name: 'Lessons and games' }).click();
				await page.waitForSelector('.gallery');
				await faultless(page, 'dark');
				await page.locator('.gallery .open').first().click();
				await page.waitForSelector('.lesson:visible');
				await faultless(page, 'light');
			});
			await t.test('nor in its program as JavaScript', async () => {
				await press(page, 'This program as JavaScript');
				await page.waitForSelector('dialog pre');
				await faultless(page, 'light');
				await page.keyboard.press('Escape');
			});
			await t.test('nor in two systems beside each other, with an agent that is looked at', async () => {
				await page.getByLabel('And beside it').selectOption('exact');
				await page.waitForSelector('.differences');
				await page.getByRole('button', { name: 'Step', exact: true }).click();
				await page.locator('.cast button').first().click();
				await faultless(page, 'light');
			});
		}
		await t.test('it fits narrow and wide windows', async () => {
			for (const width of [360, 700, 1000, 2560]) {
				await page.setViewportSize({ width, height: 500 });
				await rest(page);
				assert.deepEqual(await page.evaluate(overflow), { page: 0, tables: 0 }, `${width} pixels`);
			}
		});
		assert.deepEqual(said, []);
		await leave();
	});

	test(`${view} on a phone, in German`, async () => {
		const { page, said, leave } = await open(site, ADDRESSES[view] ?? view, { ...SIZES.phone, locale: 'de' });
		assert.equal(await page.getAttribute('html', 'lang'), 'de');
		assert.deepEqual(await page.evaluate(overflow), { page: 0, tables: 0 });
		await staysInPlace(page);
		assert.ok(await page.evaluate(() => {
			const { left, right } = document.querySelector('#views [aria-current]').getBoundingClientRect();
			const nav = document.querySelector('#views').getBoundingClientRect();
			return left >= nav.left - 1 && right <= nav.right + 1;
		}), 'the name of the view is in sight');
		if (isChromium) assert.equal(new Set(await page.locator('#views a').evaluateAll((all) => all.map((each) => each.getBoundingClientRect().top))).size, 1, 'the views are in one line');
		for (const [i, scheme] of schemesOf(view).entries()) await faultless(page, scheme, i > 0);
		for (const [name, address] of Object.entries(MORE[view] ?? {})) {
			await page.evaluate((hash) => {
				location.hash = hash;
			}, address);
			await page.waitForSelector(name);
			assert.deepEqual(await page.evaluate(overflow), { page: 0, tables: 0 }, address);
			for (const [i, scheme] of schemesOf(view).entries()) await faultless(page, scheme, i > 0);
		}
		if (view === 'play') {
			await page.getByRole('button', { name: 'Blöcke', exact: true }).click();
			assert.equal(await page.evaluate(() => innerWidth), SIZES.phone.viewport.width, 'beside the blocks the page is no wider');
			await press(page, 'Dieses Programm als JavaScript');
			await page.waitForSelector('dialog pre');
			const { left, right } = await page.evaluate(() => document.querySelector('dialog').getBoundingClientRect());
			assert.ok(left >= 0 && right <= SIZES.phone.viewport.width, `the dialog is from ${left} to ${right}`);
			await faultless(page, 'dark');
			await page.keyboard.press('Escape');
		}
		if (view === 'compare') {
			await page.locator('.modes input').last().check();
			assert.deepEqual(await page.evaluate(overflow), { page: 0, tables: 0 });
			await faultless(page, 'dark');
		}
		await page.setViewportSize(SIZES.laptop.viewport);
		await rest(page);
		assert.deepEqual(await page.evaluate(overflow), { page: 0, tables: 0 }, 'and on a laptop');
		assert.deepEqual(said, []);
		await leave();
	});
}

/** By how many pixels the page is too wide, and tables for their places. */
function overflow() {
	return {
		page: Math.max(0, document.documentElement.scrollWidth - innerWidth),
		tables: Math.max(0, ...[...document.querySelectorAll('.table')].map((table) => table.scrollWidth - table.clientWidth)),
	};
}

async function staysInPlace(page) {
	const jumps = await page.evaluate(() => new Promise((resolve) => {
		new PerformanceObserver((list) => resolve(list.getEntries().reduce((sum, { value }) => sum + value, 0))).observe({ type: 'layout-shift', buffered: true });
		setTimeout(() => resolve(0), 300);
	}));
	// a time, which says nothing on a busy machine, where the first picture may be yet to come
	await page.waitForFunction(() => performance.getEntriesByName('first-contentful-paint').length > 0);
	const paint = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime);
	console.log(`first paint after ${Math.round(paint)} ms`);
	assert.ok(jumps < 0.05, `what was there moved: ${jumps}`);
}

/**
 * Fails for what axe-core has to say, of whatever weight; of Blockly's workspace, which is Blockly's, for what is serious. If all was looked at in the
 * other colours, the colours alone are looked at. As Playwright drives Firefox, the colours do not change: all is looked at once more.
 */
async function faultless(page, colorScheme, isAgain = false) {
	await page.emulateMedia({ colorScheme });
	await rest(page, 300);
	// page.evaluate is not bound by the page's policy
	if (!await page.evaluate(() => 'axe' in globalThis)) {
		await page.evaluate(axe);
	}
	const { violations, passes } = await page.evaluate((options) => globalThis.axe.run(options), isAgain && isChromium ? { runOnly: ['cat.color'] } : {});
	assert.ok(passes.length > (isAgain ? 0 : 15), 'axe-core has looked');
	const faults = violations.flatMap(({ id, impact, nodes }) => nodes.filter(({ target }) => /serious|critical/.test(impact) || !/blockly/i.test(target.join(' ')))
		.map(({ html }) => `${id}: ${html.slice(0, 120)}`));
	assert.deepEqual(faults, [], colorScheme);
}

/** Comes to every control by the tab key. As Playwright drives Firefox, nothing is focus-visible after the key has gone through the window's own controls. */
async function reachesAll(page, showsFocus) {
	const wanted = await page.evaluate(() => {
		const groups = new Set();
		const controls = [...document.querySelectorAll('a[href], button, select, summary, input:not([tabindex="-1"]), .world[tabindex]')]
			// of radio buttons of one name, one is reached, and arrows do the rest; what is folded is not there, and what is disabled is no control yet
			.filter((each) => each.checkVisibility() && !each.disabled && !each.closest('.blocks') && !(each.type === 'radio' && (groups.has(each.name) || !groups.add(each.name))));
		controls.forEach((each, i) => {
			each.dataset.control = each.type === 'radio' ? each.name : i;
		});
		for (const each of document.querySelectorAll('input[type=radio]')) {
			each.dataset.control = each.name;
		}
		return [...new Set(controls.map((each) => each.dataset.control))];
	});
	const missing = new Set(wanted);
	for (let i = 0; i < wanted.length + 60 && missing.size > 0; i++) {
		await page.keyboard.press('Tab');
		const { control, isShown, html } = await page.evaluate(() => {
			const { activeElement: element } = document;
			return { control: element.dataset.control, isShown: getComputedStyle(element).outlineStyle !== 'none', html: element.outerHTML.slice(0, 80) };
		});
		if (missing.delete(control)) {
			assert.ok(isShown || !showsFocus, `it is seen that this has the focus: ${html}`);
		}
	}
	const names = await page.evaluate((all) => all.map((each) => document.querySelector(`[data-control="${each}"]`).outerHTML.slice(0, 80)), [...missing]);
	assert.deepEqual(names, []);
	assert.ok(wanted.length > 8);
}

const status = (page) => page.textContent('.status');

/** Waits until a model is measured, of which the status line says what matches. */
const measured = (page, expected) => page.waitForFunction(([source]) => new RegExp(source).test(document.querySelector('.status').textContent) && !document.querySelector('[aria-busy]'),
	[expected.source]);

test('Inspect: models by their names and by dropped files, with their volumes', async () => {
	const { page, said } = await shared('inspect');
	await page.getByLabel('Model', { exact: true }).selectOption('cube');
	await page.waitForFunction(() => document.querySelector('.status').textContent.startsWith('Cube: 24 vertices'));
	const rows = await page.locator('tbody tr').allTextContents();
	assert.equal(rows.length, 11);
	assert.match(rows.find((row) => row.startsWith('Oriented box')), /^Oriented box( smallest)?1\.001\.00/);
	assert.match(rows.find((row) => row.startsWith('Naive sphere')), /^Naive sphere2\.722\.72/);
	await drop(page, ['bear.obj', readFileSync(path.join(root, 'assets/bear.obj'))]);
	await measured(page, /^bear\.obj: 547 vertices/);
	const place = () => page.locator('.inspect .screen').boundingBox();
	const before = await place();
	await drop(page, ['broken.obj', Buffer.from('v 1 2 x\n')]);
	await page.waitForSelector('.status.problem');
	assert.match(await status(page), /^broken\.obj cannot be shown\. Line 1: expected/);
	assert.deepEqual(await place(), before, 'an error moves nothing');
	await drop(page, ['broken.dae', Buffer.from('<COLLADA><')]);
	await page.waitForFunction(() => /broken\.dae/.test(document.querySelector('.status.problem')?.textContent));
	assert.match(await status(page), /not well-formed XML/);
	await drop(page, ['picture.png', Buffer.from('x')]);
	await page.waitForFunction(() => /picture\.png/.test(document.querySelector('.status.problem')?.textContent));
	assert.match(await status(page), /^picture\.png cannot be shown\. .*OBJ, DAE, GLB, glTF and STL files can be/);
	assert.equal(await page.locator('tbody tr').count(), 11, 'what was there is there');
	assert.deepEqual(said.splice(0), []);
});

test('Inspect: settings change what is found', async () => {
	const { page, said } = await shared('inspect');
	const nodes = () => page.textContent('.results .card:last-child .note');
	const before = await nodes();
	await page.getByLabel('Fewest vertices to split').fill('200');
	await page.getByRole('button', { name: 'Measure again' }).click();
	await page.waitForFunction((old) => document.querySelector('.results .card:last-child .note').textContent !== old, before);
	await page.getByLabel('Fewest vertices to split').fill('0');
	await page.evaluate(() => document.querySelector('form').noValidate = true);
	await page.getByRole('button', { name: 'Measure again' }).click();
	await page.waitForSelector('.status.problem');
	assert.match(await status(page), /^That number is not possible: /);
	await page.getByLabel('Fewest vertices to split').fill('5');
	await page.getByRole('button', { name: 'Measure again' }).click();
	await measured(page, /vertices/);
	assert.deepEqual(said.splice(0), []);
});

test('Inspect: rays, nearest agents, distances and contacts by the pointer', async () => {
	const { page, said } = await shared('inspect');
	await page.getByLabel('Model', { exact: true }).selectOption('cube');
	await measured(page, /^Cube: /);
	await page.getByLabel('Questions', { exact: true }).check();
	const answer = (name) => page.textContent(`.answers .${name} dd`);
	const numbers = async (name) => (await answer(name)).match(/-?\d+\.\d+/g).map(Number);
	const near = (found, expected, room) => expected.forEach((each, i) => assert.ok(Math.abs(found[i] - each) <= room, `${found} for ${expected}`));
	await page.waitForFunction(() => /apart/.test(document.querySelector('.answers .meeting dd')?.textContent));
	await page.getByLabel('Seen by').selectOption('tightest fits');
	// a ball of radius 0.3 beside an edge of the cube
	const angle = (7 * Math.PI) / 6;
	near(await numbers('meeting'), [Math.hypot(1.2 * Math.cos(angle) + 0.5, 1.2 * Math.sin(angle) + 0.5) - 0.3], 0.0006);
	const pixel = (x, y, z) => page.evaluate((at) => {
		const { camera, canvas } = globalThis.playground.stage;
		const point = camera.position.clone().set(...at).project(camera);
		const box = canvas.getBoundingClientRect();
		return [box.left + ((point.x + 1) / 2) * box.width, box.top + ((1 - point.y) / 2) * box.height];
	}, [x, y, z]);
	await page.mouse.move(...await pixel(0.1, 0.2, 1));
	assert.match(await answer('ray'), /^meets Cube after/);
	const [, ...place] = await numbers('ray');
	near(place, [0.1, 0.2, 1, 0, 0, 1], 0.02);
	const eye = await page.evaluate(() => globalThis.playground.stage.camera.position.toArray());
	near(await numbers('ray'), [Math.hypot(eye[0] - 0.1, eye[1] - 0.2, eye[2] - 1)], 0.02);
	const [x, y] = [1.2 * Math.cos(angle), 1.2 * Math.sin(angle)];
	await page.mouse.move(...await pixel(x, y - 0.7, 0));
	assert.match(await answer('ray'), /^meets nothing$/);
	assert.match(await answer('nearest'), /^Sphere 1: /);
	near(await numbers('nearest'), [0.7, x, y - 0.7, 0], 0.02);
	await page.mouse.move(...await pixel(x, y, 0.3));
	assert.match(await answer('ray'), /^meets Sphere 1/);
	await page.mouse.click(...await pixel(x, y, 0.3));
	await page.mouse.move(...await pixel(x, y - 0.7, 0));
	assert.match(await answer('ray'), /^meets Sphere 1.*\(kept\)$/, 'a click keeps it');
	await page.mouse.click(...await pixel(x, y - 0.7, 0));
	await page.mouse.move(...await pixel(x, y, 0));
	await page.mouse.down();
	await page.mouse.move(...await pixel(0.45, 0.1, 0), { steps: 3 });
	await page.mouse.up();
	assert.match(await answer('meeting'), /^Sphere 1, Cube: They touch at/);
	const { agents: [, ball], drawn } = await page.evaluate(() => {
		const { stage, questions: { sight: { agents } } } = globalThis.playground;
		return { agents: agents.map((agent) => ({ x: agent.x, y: agent.y })), drawn: stage.scene.children.filter(({ isLineSegments, geometry }) => isLineSegments && geometry.drawRange.count === 8).length };
	});
	near([ball.x, ball.y], [0.45, 0.1], 0.03);
	assert.equal(drawn, 1, 'the contact: a cross and its normal');
	// the box's face that is nearest is that of x = 0.5
	near((await numbers('meeting')).slice(3), [0.5 - ball.x + 0.3, 1, 0, 0], 0.02);
	await page.locator('.world').focus();
	await page.keyboard.press('Enter');
	assert.match(await answer('ray'), /\(kept\)$/, 'the keyboard asks');
	await page.getByLabel('Structures', { exact: true }).check();
	assert.deepEqual(await page.evaluate(() => globalThis.playground.stage.actors.children.filter(({ visible }) => visible).map(({ count }) => count)), [1, 1], 'the cube and its outline');
	const eyeNow = () => page.evaluate(() => globalThis.playground.stage.camera.position.toArray());
	const before = await eyeNow();
	const [across, up] = await pixel(0, 0, 0.5);
	await page.mouse.move(across, up);
	await page.mouse.down();
	await page.mouse.move(across + 80, up, { steps: 4 });
	await page.mouse.up();
	assert.notDeepEqual(await eyeNow(), before, 'with no question open, the pointer turns the picture and moves no model');
	assert.deepEqual(said.splice(0), []);
});

test('Compare: two agents are moved by sliders and by dragging', async () => {
	const { page, said } = await shared('compare');
	const verdicts = () => page.locator('.verdict strong').allTextContents();
	assert.deepEqual(await verdicts(), ['false collision', 'false collision', ...Array(4).fill('no collision')]);
	const z = page.locator('details[open] .slider', { hasText: /^z/ }).locator('input');
	await z.fill('3');
	assert.deepEqual(await verdicts(), [...Array(6).fill('no collision')]);
	await z.fill('0.1');
	const x = page.locator('details[open] .slider', { hasText: /^x/ }).locator('input');
	const before = await x.inputValue();
	await dragBall(page, 120, 10);
	assert.notEqual(await x.inputValue(), before);
	assert.deepEqual(said.splice(0), []);
});

test('Compare: the program that it shows runs, and gives the same verdict', async () => {
	const { page, said } = await shared('compare');
	const assets = await serve(null, { '/assets': path.join(root, 'assets') });
	const folder = path.join(root, 'bin/generated/compare-code');
	mkdirSync(folder, { recursive: true });
	try {
		for (const [system, shape] of [['Tightest fits', 'bear'], ['Convex hulls', 'fireman'], ['Unit spheres', 'cube'], ['Exact', 'sphere']]) {
			await page.locator('.verdict', { hasText: system }).click();
			await page.locator('details[open] select').selectOption(shape);
			const text = await page.textContent('.code code');
			const verdict = await page.locator('.verdict', { hasText: system }).locator('strong').textContent();
			const file = path.join(folder, `${shape}.mjs`);
			writeFileSync(file, text.replace('"starlogo-collision"', JSON.stringify(pathToFileURL(path.join(root, 'bin/module/starlogo-collision.js')).href)).replaceAll('"assets/', `"${assets.url}assets/`));
			const { stdout } = await promisify(execFile)(process.execPath, [file]);
			assert.equal(stdout.trim(), text.split('// ').at(-1), text);
			assert.equal(stdout.trim(), String(verdict !== 'no collision' && verdict !== 'missed'), verdict);
		}
	} finally {
		assets.close();
	}
	assert.deepEqual(said.splice(0), []);
});

test('Compare: the counts are those of the engine\'s own test', async () => {
	const { page, said } = await shared('compare');
	const table = async () => Object.fromEntries(await page.locator('tr[data-system]').evaluateAll((rows) => rows.map((row) => [
		row.dataset.system, [...row.querySelectorAll('td')].slice(0, 3).map((cell) => Number(cell.textContent)),
	])));
	await page.getByRole('radio', { name: 'A scattered game' }).check();
	await page.getByLabel('Beside').selectOption('exact');
	await page.getByRole('button', { name: 'From the start' }).click();
	for (const frame of counts.frames) {
		const { touching, ...systems } = frame;
		assert.match(await page.textContent('.scattered .note'), new RegExp(`; ${touching} pairs`));
		assert.deepEqual(await table(), systems);
		await page.getByRole('button', { name: 'A frame on' }).click();
	}
	assert.deepEqual(said.splice(0), []);
});

test('Compare: each pair of systems, with a line for each pair of agents', async () => {
	const { page, said } = await shared('compare');
	const { systems, only } = await page.evaluate(() => {
		// all at once, so that nothing is drawn meanwhile
		const [list] = document.querySelectorAll('.scattered select');
		const [names, differences] = [[...list.options].map(({ value }) => value), {}];
		for (const reference of names) {
			list.value = reference;
			list.dispatchEvent(new Event('change'));
			for (const row of document.querySelectorAll('tr[data-system]')) {
				row.querySelector('input').click();
				const [found, wrong, missed] = [...row.querySelectorAll('td')].map(({ textContent }) => Number.parseFloat(textContent));
				const lines = globalThis.playground.gameSection.stage.scene.children.filter(({ isLineSegments, renderOrder }) => isLineSegments && renderOrder === 1);
				differences[`${row.dataset.system} ${reference}`] = { said: [found - wrong, wrong, missed], drawn: lines.map(({ geometry }) => geometry.drawRange.count / 2) };
			}
		}
		return { systems: names, only: differences };
	});
	assert.equal(Object.keys(only).length, 6 * 5);
	for (const [pair, { said: numbers, drawn }] of Object.entries(only)) {
		assert.deepEqual(drawn, numbers, pair);
		only[pair] = numbers.slice(1);
	}
	for (const [pair, [wrong, missed]] of Object.entries(only)) {
		const [a, b] = systems.filter((name) => pair.startsWith(name)).concat(systems.filter((name) => pair.endsWith(` ${name}`)));
		assert.deepEqual(only[`${b} ${a}`], [missed, wrong], pair);
	}
	assert.ok(Object.values(only).filter(([wrong, missed]) => wrong + missed > 0).length > 12, 'they are not alike');
	assert.deepEqual(said.splice(0), []);
});

test('a dialog closes when another view opens', async () => {
	const { page, said, leave } = await open(site, 'play/maze', SIZES.laptop);
	await press(page, 'This program as JavaScript');
	await page.getByRole('dialog').waitFor();
	await page.evaluate(() => {
		location.hash = 'compare';
	});
	await ready(page, 'compare');
	assert.equal(await page.locator('dialog').count(), 0);
	assert.deepEqual(said, []);
	await leave();
});

test('a view that comes late is not written over the one chosen since', async () => {
	const { page, said, leave } = await open(site, 'inspect');
	const release = await hold(page, '**/models/*.json');
	const asked = page.waitForRequest('**/models/person.json');
	await page.getByRole('link', { name: 'Compare' }).click();
	await asked;
	await page.getByRole('link', { name: 'Inspect' }).click();
	await ready(page, 'inspect');
	const came = page.waitForResponse('**/models/person.json');
	release();
	await came;
	await rest(page, 1500);
	assert.equal(await page.locator('.facts').count(), 1, 'Inspect is there');
	assert.equal(await page.locator('.pair').count(), 0, 'and Compare is not');
	assert.equal(await page.evaluate(() => 'found' in globalThis.playground), true, 'the console has the view that is shown');
	assert.deepEqual(said, []);
	await leave();
});

test('Inspect: a model that is missing is said to be, and works when it is there again', async () => {
	const { page, said } = await shared('inspect');
	await page.getByLabel('Model', { exact: true }).selectOption('bear');
	await measured(page, /^Bear: /);
	await page.route('**/models/dragon.json', (route) => route.fulfill({ status: 404, body: 'no' }));
	await page.getByLabel('Model', { exact: true }).selectOption('dragon');
	await page.waitForSelector('.status.problem');
	assert.match(await status(page), /^Dragon cannot be shown\. .*dragon\.json.*404/);
	assert.equal(await page.getByLabel('Model', { exact: true }).inputValue(), 'bear', 'what is shown is chosen');
	assert.equal(await page.locator('[aria-busy]').count(), 0);
	await page.unroute('**/models/dragon.json');
	await page.getByLabel('Model', { exact: true }).selectOption('dragon');
	await measured(page, /^Dragon: /);
	assert.equal(await page.locator('tbody tr').count(), 11);
	assert.equal(said.splice(0).length, isChromium ? 1 : 0, 'Chromium says on the console that it was missing');
});

test('Inspect: files by their content, with their names, standing up, points as points, times of warm runs', async () => {
	const { page, said } = await shared('inspect');
	const model = page.getByLabel('Model', { exact: true });
	const height = () => page.evaluate(() => Math.max(...globalThis.playground.model.vertices.filter((_, i) => i % 3 === 2)));
	// a post of 1 by 4 by 1, y up
	const post = [...Array(8).keys()].map((i) => `v ${i & 1} ${i & 2 ? 4 : 0} ${i & 4 ? 1 : 0}`).join('\n');
	const faces = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map((each) => `f ${each}`).join('\n');
	await drop(page, ['post.txt', Buffer.from(`${post}\n${faces}\n`)]);
	await measured(page, /^post\.txt: 8 vertices, 12 triangles/);
	assert.equal(await model.evaluate((list) => list.selectedOptions[0].textContent), 'post.txt');
	assert.equal(await height(), 0.25, 'it lies');
	await page.getByLabel('Up', { exact: true }).selectOption('y');
	await page.waitForFunction(() => Math.max(...globalThis.playground.model.vertices.filter((_, i) => i % 3 === 2)) === 4);
	await measured(page, /^post\.txt: 8/);
	assert.ok(await page.evaluate(() => globalThis.playground.found.rows.every(({ runs }) => runs >= 2)), 'times of several runs');
	await drop(page, ['cloud.obj', Buffer.from(`${post}\n`)]);
	await measured(page, /^cloud\.obj: 8 vertices, 0 triangles/);
	assert.equal(await page.getByLabel('Up', { exact: true }).inputValue(), 'z', 'the next one stands as it is');
	const drawn = await page.evaluate(() => {
		const { scene, actors } = globalThis.playground.stage;
		return [scene.children.filter(({ isPoints }) => isPoints).length, actors.children.filter(({ visible }) => visible).length];
	});
	assert.deepEqual(drawn, [1, 0], 'points, and no mesh');
	// measured again, of the same model
	await page.reload();
	await ready(page, 'inspect');
	await measured(page, /^Bear/);
	await page.getByRole('button', { name: 'Measure again' }).click();
	await page.waitForSelector('.results[aria-busy]');
	await measured(page, /^Bear/);
	const [, hull] = /convex hull first, in about (\d+\.\d+) ms/.exec(await page.textContent('.results .card .note'));
	const fits = await page.locator('.results tbody td:last-child').allTextContents();
	assert.ok(fits.every((ms) => Number(ms) >= Number(hull)), `no fit is shorter than the hull that it computes: ${fits}, ${hull}`);
	await hurry(page);
	await drop(page, ['post.txt', Buffer.from(`${post}\n${faces}\n`)]);
	await measured(page, /^post\.txt: 8/);
	await model.selectOption({ label: 'post.txt' });
	await measured(page, /^post\.txt: 8 vertices, 12/);
	// two files of other kinds, under names that say nothing
	const stl = Buffer.alloc(84 + 50);
	stl.writeUInt32LE(1, 80);
	[0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((value, i) => stl.writeFloatLE(value, 84 + 4 * i));
	await drop(page, ['part', stl]);
	await measured(page, /^part: 3 vertices, 1 triangle(?!s)/);
	const corners = Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 3, 0]).buffer).toString('base64');
	await drop(page, ['scene', Buffer.from(JSON.stringify({
		asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
		accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 3, 0] }],
		bufferViews: [{ buffer: 0, byteLength: 36 }], buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${corners}` }],
	}))]);
	await measured(page, /^scene: 3 vertices, 1 triangle(?!s)/);
	assert.equal(await height(), 3, 'glTF is y up');
	assert.deepEqual(said.splice(0), []);
});

test('Inspect: no column of its table is cut off', async () => {
	const { page } = await shared('inspect');
	for (const [name, text] of [['cube', 'Cube'], ['sphere', 'Sphere'], ['tree', 'Tree']]) {
		await page.getByLabel('Model', { exact: true }).selectOption(name);
		await measured(page, new RegExp(`^${text}: `));
		for (const width of [390, 961, 1366]) {
			await page.setViewportSize({ width, height: 768 });
			assert.equal((await page.evaluate(overflow)).tables, 0, `${name}, ${width}`);
		}
	}
	await page.setViewportSize(SIZES.laptop.viewport);
});

test('Compare: the verdicts are in sight while every slider moves', async () => {
	const { page, said } = await shared('compare');
	await page.getByRole('radio', { name: 'Two agents' }).check();
	let moved = 0;
	for (const agent of ['Agent A', 'Agent B']) {
		await page.getByText(agent).click();
		for (const slider of await page.locator('.pair input[type=range]:visible').all()) {
			await slider.focus();
			await page.keyboard.press('ArrowRight');
			moved++;
			const hidden = await page.evaluate(() => [...document.querySelectorAll('.verdict strong')].filter((each) => {
				const box = each.getBoundingClientRect();
				const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
				return !each.closest('.verdict').contains(at);
			}).length);
			assert.equal(hidden, 0, `${agent}, slider ${moved}`);
		}
	}
	assert.ok(moved >= 14, `${moved} sliders`);
	assert.deepEqual(said.splice(0), []);
});

test('Compare: of the exact system the triangles are drawn', async () => {
	const { page } = await shared('compare');
	await page.getByRole('radio', { name: 'Two agents' }).check();
	await page.locator('.verdict', { hasText: 'Exact' }).click();
	const { drawn, edges } = await page.evaluate(() => {
		const { agents, models, stage } = globalThis.playground;
		const lines = stage.scene.children.find(({ isLineSegments, geometry }) => isLineSegments && geometry.drawRange.count < Infinity);
		const all = agents.map(({ shape }) => {
			const { triangles } = models.get(shape);
			const found = new Set();
			for (let i = 0; i < triangles.length; i++) {
				const [a, b] = [triangles[i], triangles[i % 3 === 2 ? i - 2 : i + 1]];
				found.add(a < b ? `${a} ${b}` : `${b} ${a}`);
			}
			return found.size;
		});
		return { drawn: lines.geometry.drawRange.count / 2, edges: all[0] + all[1] };
	});
	assert.equal(drawn, edges);
});

test('a near miss that stands still is coloured as the chosen system sees it, and tests are counted', async () => {
	const { page, said, leave } = await open(site, 'play/wing');
	await page.getByRole('button', { name: 'Step', exact: true }).click();
	const seen = () => page.evaluate(() => {
		const { world, panel: { figures } } = globalThis.playground;
		return { isRed: world.agents.find(({ breed }) => breed === 'dragons').color === 0xe5484d, tests: Number(figures.cells.tests.textContent) };
	});
	for (const [system, isRed] of [['hierarchies', false], ['tightest fits', true], ['exact', false], ['unit spheres', true]]) {
		await page.getByLabel('Collision system').selectOption(system);
		assert.deepEqual(await seen(), { isRed, tests: 1 }, system);
	}
	assert.deepEqual(said, []);
	await leave();
});

test('a file that is dropped elsewhere, and a graphics card that goes away, are said in words', async () => {
	const { page, leave } = await open(site, 'level', { ...SIZES.desktop, isDrawn: true });
	await drop(page, ['bear.obj', Buffer.from('v 1 2 3')]);
	assert.match(await page.textContent('header [role=status]'), /^bear\.obj was not opened\. Open models in the view “Inspect”/);
	await drop(page, ['mine.json', Buffer.from('{}')]);
	assert.match(await page.textContent('header [role=status]'), /^mine\.json was not opened\. Open programs in the view “Play”/);
	await page.getByRole('link', { name: 'Inspect' }).click();
	await ready(page, 'inspect');
	assert.equal(await page.textContent('header [role=status]'), '');
	await page.evaluate(() => {
		globalThis.loss = globalThis.playground.stage.renderer.getContext().getExtension('WEBGL_lose_context');
		globalThis.loss.loseContext();
	});
	await page.waitForSelector('.world .lost[role=alert]');
	assert.match(await page.textContent('.lost'), /has stopped drawing 3D/);
	assert.equal(await page.locator('tbody tr').count(), 11);
	await page.evaluate(() => globalThis.loss.restoreContext());
	await page.waitForSelector('.lost', { state: 'detached' });
	const colours = await page.evaluate(() => {
		const { stage } = globalThis.playground;
		stage.draw();
		const gl = stage.renderer.getContext();
		const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
		gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
		return new Set(new Uint32Array(pixels.buffer)).size;
	});
	assert.ok(colours > 20, `${colours} colours are drawn again`);
	await leave();
});

test('forced colours leave what is chosen, wrong and meant to be seen', { skip: isChromium ? false : 'Playwright forces colours in Chromium alone' }, async () => {
	const { page, leave } = await open(site, 'compare', { ...SIZES.desktop, forcedColors: 'active' });
	const style = (selector, pseudo) => page.evaluate(([which, part]) => {
		const { outlineStyle, borderStyle, backgroundColor, borderTopColor } = getComputedStyle(document.querySelector(which), part);
		return { outlineStyle, borderStyle, backgroundColor, borderTopColor };
	}, [selector, pseudo]);
	assert.notEqual((await style('.bar a[aria-current]')).outlineStyle, 'none', 'the view that is shown');
	assert.equal((await style('.bar a:not([aria-current])')).outlineStyle, 'none');
	assert.notEqual((await style('.verdict.differs')).borderStyle, (await style('.verdict:not(.differs)')).borderStyle, 'a verdict that is wrong');
	await page.getByRole('radio', { name: 'A scattered game' }).check();
	const dots = await Promise.all(['hit', 'wrong', 'missed', 'none'].map(async (name) => (await style(`.legend .${name}`, '::before')).backgroundColor));
	assert.equal(new Set(dots).size, 4, 'the legend has the colours of the picture');
	await leave();
});

test('without WebGL the page says so, and the rest works', async () => {
	const { page, leave } = await open({ ...site, browser: {
		newContext: async (options) => {
			const made = await site.browser.newContext(options);
			await made.addInitScript(() => {
				HTMLCanvasElement.prototype.getContext = () => null;
			});
			return made;
		},
	} }, 'inspect', { ...SIZES.desktop, isDrawn: true });
	assert.match(await page.textContent('.world'), /^This browser draws no 3D here/);
	assert.equal(await page.locator('tbody tr').count(), 11);
	await leave();
});

test('the page is under a strict policy, and has the licences of what it brings', () => {
	const html = readFileSync(path.join(root, 'bin/playground/index.html'), 'utf8');
	const policy = /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(html)[1];
	assert.match(policy, /^default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self';/);
	// Rapier is WebAssembly; nothing else is made of text
	assert.doesNotMatch(policy.replace('\'wasm-unsafe-eval\'', ''), /unsafe|https?:|\*/);
	assert.ok(existsSync(path.join(root, 'bin/playground/LICENSES.txt')));
	assert.ok(statSync(path.join(root, 'bin/playground/main.js')).size < 20000, 'the first script is small');
});

test('Level: the game in the level of examples/level runs, is steered, saved and rewound, with its source beside it', async () => {
	const { page, said } = await shared('level');
	const state = () => page.evaluate(() => {
		const { game: { player: { x, y, z, heading }, level, shots, enemies }, isLed, past } = globalThis.playground;
		return { x, y, z, heading, shots, enemies: enemies.length, isLed, level: level.shape, past: past.length };
	});
	const until = (what, told) => page.waitForFunction(what, told);
	const hold = async (key, ...what) => {
		await page.keyboard.down(key);
		await until(...what);
		await page.keyboard.up(key);
	};
	const away = ({ x, y }) => Math.hypot(globalThis.playground.game.player.x - x, globalThis.playground.game.player.y - y) > 0.5;
	assert.match(await page.textContent('.side .note'), /^The level is one mesh of 83,060 triangles/);
	assert.ok(await page.getByRole('button', { name: 'Load' }).isDisabled(), 'nothing is saved yet');
	// it goes by itself, and shoots
	await press(page, 'Run');
	assert.equal(await page.locator('.drag-note').textContent(), 'The player walks by itself. Press a key to lead it.');
	await until(() => globalThis.playground.game.shots > 0 && Number.parseFloat(document.querySelector('.figures dd').textContent) > 0);
	assert.equal((await state()).isLed, false);
	// until a key is pressed
	await hold('ArrowLeft', () => globalThis.playground.isLed);
	const before = await state();
	await hold('ArrowUp', away, before);
	await page.keyboard.press('f');
	await until((shots) => globalThis.playground.game.shots > shots, before.shots);
	await hold('Space', () => globalThis.playground.game.player.speed > 0);
	// W, A, S and D are arrow keys, too
	const there = await state();
	await hold('KeyS', away, there);
	await hold('KeyD', (heading) => globalThis.playground.game.player.heading !== heading, there.heading);
	await press(page, 'Stop');
	await press(page, 'Save');
	assert.equal(await page.locator('.drag-note').textContent(), 'Saved. Load leads back here.');
	const { x, y } = await state();
	await press(page, 'Run');
	await hold('ArrowUp', away, { x, y });
	await press(page, 'Stop');
	await press(page, 'Load');
	const loaded = await state();
	assert.deepEqual([loaded.x, loaded.y], [x, y]);
	// the pad has the keys: a finger goes back in time
	const kept = loaded.past;
	const back = await page.locator('.pad .back').boundingBox();
	await page.mouse.move(back.x + back.width / 2, back.y + back.height / 2);
	await page.mouse.down();
	await until((most) => globalThis.playground.past.length < most, kept);
	await page.mouse.up();
	await press(page, 'Stop');
	// the source is the example's, and leads to all of it
	assert.ok(await page.locator('.code pre').isVisible());
	assert.equal(await page.textContent('.code pre'), readFileSync(path.join(root, 'examples/level/game.js'), 'utf8'));
	const link = await page.request.get(await page.locator('.code a').evaluate(({ href }) => href));
	assert.match(await link.text(), /id="a-game-in-a-level"[^]*GLTFLoader/);
	assert.deepEqual(said.splice(0), []);
});

test('Compare: the scene is in the address: it survives a reload, and a link brings it', async () => {
	const { page, said, leave } = await open(site, 'compare');
	await page.getByLabel('Size').last().fill('0.5');
	await page.locator('input[name=shown][value=exact]').check();
	await page.waitForURL(/#compare\/dragon_0_0_0_0_0_0_2~sphere_0\.2_0\.6_0\.1_0_0_0_0\.5~exact$/);
	await page.reload();
	await ready(page, 'compare');
	const scene = () => page.evaluate(() => {
		const { agents, sight, gameSection: { system: gameSystem, reference, isShown } } = globalThis.playground;
		return { shapes: agents.map(({ shape }) => shape), size: agents[1].size, system: sight.system, gameSystem, reference, isGame: isShown };
	});
	assert.deepEqual(await scene(), { shapes: ['dragon', 'sphere'], size: 0.5, system: 'exact', gameSystem: 'unit spheres', reference: 'exact', isGame: false });
	assert.ok(await page.locator('input[name=shown][value=exact]').isChecked());
	assert.equal(await page.getByLabel('Size').last().inputValue(), '0.5');
	await page.getByRole('radio', { name: 'A scattered game' }).check();
	await page.getByLabel('Beside').selectOption('hierarchies');
	await page.getByRole('button', { name: 'A frame on' }).click();
	await page.getByRole('button', { name: 'A frame on' }).click();
	await page.waitForURL(/#compare\/game~unit-spheres~hierarchies~2$/);
	const places = () => page.evaluate(() => globalThis.playground.gameSection.game.agents.map(({ x, y }) => [x, y]));
	const before = await places();
	await refuseCopies(page);
	await page.getByRole('button', { name: 'Copy a link' }).click();
	const link = await page.locator('.address').inputValue();
	await goNowhere(page);
	await page.goto(link);
	await ready(page, 'compare');
	assert.deepEqual(await places(), before);
	assert.ok(await page.getByRole('radio', { name: 'A scattered game' }).isChecked());
	assert.equal(await page.getByLabel('Beside').inputValue(), 'hierarchies');
	// nonsense shows the beginning
	await goNowhere(page);
	await page.goto(`${site.url}#compare/dragon_0~sphere_a_b_c_d_e_f_0~exact`);
	await ready(page, 'compare');
	assert.deepEqual((await scene()).shapes, ['dragon', 'sphere']);
	assert.deepEqual(said, []);
	await leave();
});

test('Compare: milliseconds stand beside precision, for the other system too', async () => {
	const { page, said, leave } = await open(site, 'compare/game~tightest-fits~exact~3', { ...SIZES.desktop, locale: 'de-DE' });
	await page.waitForFunction(() => [...document.querySelectorAll('.scattered tr:is([data-system], [data-reference])')].every(({ lastChild }) => /^\d/.test(lastChild.textContent)));
	const rows = await page.locator('.scattered tr:is([data-system], [data-reference])').evaluateAll((all) => all.map((row) => [row.dataset.system ?? row.dataset.reference, Number(row.lastChild.textContent.replace(',', '.'))]));
	assert.deepEqual(rows.map(([name]) => name), ['unit spheres', 'tightest fits', 'hulls', 'hierarchies', 'combination', 'exact']);
	assert.ok(rows.every(([, ms]) => ms > 0), JSON.stringify(rows));
	for (const width of [1366, 1920]) {
		await page.setViewportSize({ width, height: 768 });
		assert.equal(await page.evaluate(() => document.querySelector('.scattered .table').scrollWidth - document.querySelector('.scattered .table').clientWidth), 0, `no figure is cut off at ${width}`);
	}
	assert.deepEqual(said, []);
	await leave();
});

test('Inspect takes a program for what it is, and leads to Play', async () => {
	const { page, said, leave } = await open(site, 'inspect');
	const program = { name: 'Mine', lesson: 'room', blocks: { blocks: [{ type: 'starlogo_start', inputs: { DO: { block: { type: 'starlogo_create', fields: { BREED: 'walls', SHAPE: 'wall' }, inputs: { COUNT: { shadow: { type: 'math_number', fields: { NUM: 3 } } } } } } } }] } };
	await drop(page, ['mine.json', Buffer.from(JSON.stringify(program))]);
	await page.waitForSelector('.status a');
	assert.match(await status(page), /^mine\.json is a program of blocks, not a model\. Open it in Play$/);
	await page.locator('.status a').click();
	await ready(page, 'play');
	await page.waitForFunction(() => document.querySelector('.title').value === 'Mine');
	assert.equal(await page.evaluate(() => globalThis.playground.world.agents.length), 3);
	assert.match(await page.textContent('.lesson'), /A room/);
	assert.deepEqual(said, []);
	await leave();
});

test('the head of the page links the guide and the API, and stays in one line in windows of 1024 pixels', async () => {
	for (const locale of ['en-US', 'de-DE']) {
		const { page, said, leave } = await open(site, 'measure', { ...SIZES.desktop, viewport: { width: 1024, height: 768 }, locale });
		const links = await page.locator('.helps a').evaluateAll((all) => all.map((each) => each.href));
		assert.equal(links.length, 2);
		for (const link of links) {
			const response = await page.request.get(link);
			assert.ok(response.ok(), link);
			assert.match(await response.text(), /GreatLand|collision/i);
		}
		assert.ok(await page.evaluate(() => document.querySelector('.bar').getBoundingClientRect().height) < 60);
		assert.equal(await page.getByRole('heading', { level: 1 }).textContent(), locale === 'en-US' ? 'Collision playground' : 'Kollisionswerkstatt');
		assert.deepEqual(said, []);
		await leave();
	}
});
