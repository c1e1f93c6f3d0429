/** Inspect and Compare, and what goes for every view, in the browser. */
import assert from 'node:assert/strict';
import { existsSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { SIZES, begin, open, root } from './browser.mjs';

const VIEWS = ['play', 'inspect', 'compare'];
const axe = readFileSync(path.join(root, 'playground/node_modules/axe-core/axe.min.js'), 'utf8');
const counts = JSON.parse(readFileSync(path.join(root, 'test/fixtures/playground/scattered.json'), 'utf8'));

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

/** What has to hold in every view, at every size. */
async function looksWell(page, view, { isMobile }) {
	const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
	assert.ok(wide <= 0, `the page is ${wide} pixels too wide`);
	const cut = await page.evaluate(() => Math.max(0, ...[...document.querySelectorAll('.table')].map((table) => table.scrollWidth - table.clientWidth)));
	assert.equal(cut, 0, 'pixels that a table is wider than its place');
	const jumps = await page.evaluate(() => new Promise((resolve) => {
		new PerformanceObserver((list) => resolve(list.getEntries().reduce((sum, { value }) => sum + value, 0))).observe({ type: 'layout-shift', buffered: true });
		setTimeout(() => resolve(0), 300);
	}));
	assert.ok(jumps < 0.05, `what was there moved: ${jumps}`);
	// page.evaluate is not bound by the page's policy
	await page.evaluate(axe);
	// what is wrong with colours is so at every size
	for (const colorScheme of isMobile ? ['light'] : ['light', 'dark']) {
		await page.emulateMedia({ colorScheme });
		await page.waitForTimeout(300);
		assert.deepEqual(await seriousFaults(page), [], colorScheme);
	}
}

async function seriousFaults(page) {
	const { violations, passes } = await page.evaluate(() => globalThis.axe.run());
	assert.ok(passes.length > 15, 'axe-core has looked');
	return violations.filter(({ impact }) => impact === 'serious' || impact === 'critical')
		.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join('; ')}`);
}

/** And on a desktop. */
const EVERY_VIEW = {
	'Play alone loads Blockly': async (page, view) => {
		const files = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname));
		const withBlockly = files.filter((file) => file.endsWith('.js')).map((file) => path.join(root, 'bin/playground', file.replace('/any/where/', '')))
			.filter((file) => readFileSync(file, 'utf8').includes('blocklyMainBackground'));
		assert.equal(withBlockly.length, view === 'play' ? 1 : 0);
	},

	'it fits windows that are 360 and 2560 pixels wide': async (page) => {
		for (const width of [360, 2560]) {
			await page.setViewportSize({ width, height: 800 });
			await page.waitForFunction((wanted) => innerWidth === wanted && document.documentElement.scrollWidth <= wanted, width);
		}
		await page.setViewportSize(SIZES.desktop.viewport);
	},

	'every control is reached by the tab key': async (page) => {
		const wanted = await page.evaluate(() => {
			const groups = new Set();
			const controls = [...document.querySelectorAll('a[href], button, select, summary, input:not([tabindex="-1"]), .world[tabindex]')]
				// of radio buttons of one name, one is reached, and arrows do the rest; what is folded is not there
				.filter((each) => each.checkVisibility() && !each.closest('.blocks') && !(each.type === 'radio' && (groups.has(each.name) || !groups.add(each.name))));
			controls.forEach((each, i) => {
				each.dataset.control = each.type === 'radio' ? each.name : i;
			});
			for (const each of document.querySelectorAll('input[type=radio]')) {
				each.dataset.control = each.name;
			}
			return [...new Set(controls.map((each) => each.dataset.control))];
		});
		const reached = new Set();
		for (let i = 0; i < wanted.length + 60 && reached.size < wanted.length; i++) {
			await page.keyboard.press('Tab');
			const control = await page.evaluate(() => document.activeElement.dataset.control);
			if (control !== undefined) {
				reached.add(control);
			}
		}
		const missing = wanted.filter((each) => !reached.has(each));
		const names = await page.evaluate((all) => all.map((each) => document.querySelector(`[data-control="${each}"]`).outerHTML.slice(0, 80)), missing);
		assert.deepEqual(names, []);
		assert.ok(wanted.length > 8);
	},
};

/** Drops a file on the page, as the system does. */
async function drop(page, name, content) {
	const data = await page.evaluateHandle(([file, bytes]) => {
		const transfer = new DataTransfer();
		transfer.items.add(new File([Uint8Array.from(bytes)], file));
		return transfer;
	}, [name, [...content]]);
	await page.dispatchEvent('.world', 'drop', { dataTransfer: data });
}

const status = (page) => page.textContent('.status');

/** And in one view, on a page that what goes before has left as it was. */
const IN_VIEW = {
	play: {},
	inspect: {
		'something is to be seen within a second': async (page) => {
			const paint = await page.evaluate(() => performance.getEntriesByType('paint').find(({ name }) => name === 'first-contentful-paint').startTime);
			console.log(`first paint after ${Math.round(paint)} ms`);
			assert.ok(paint < 1000, `${paint} ms`);
		},

		'models by their names and by dropped files, with their volumes': async (page) => {
			await page.getByLabel('Model', { exact: true }).selectOption('cube');
			await page.waitForFunction(() => document.querySelector('.status').textContent.startsWith('24 vertices'));
			const rows = await page.locator('tbody tr').allTextContents();
			assert.equal(rows.length, 11);
			assert.match(rows.find((row) => row.startsWith('Oriented box')), /^Oriented box(tightest)?1\.001\.00/);
			assert.match(rows.find((row) => row.startsWith('Naive sphere')), /^Naive sphere2\.722\.72/);
			await drop(page, 'bear.obj', readFileSync(path.join(root, 'assets/bear.obj')));
			await page.waitForFunction(() => document.querySelector('.status').textContent.startsWith('547 vertices'));
			await drop(page, 'broken.obj', Buffer.from('v 1 2 x\n'));
			await page.waitForSelector('.status.problem');
			assert.match(await status(page), /^This file cannot be shown\. model "broken\.obj", line 1/);
			await drop(page, 'broken.dae', Buffer.from('<COLLADA><'));
			await page.waitForFunction(() => /broken\.dae/.test(document.querySelector('.status').textContent));
			assert.match(await status(page), /not well-formed XML/);
			await drop(page, 'picture.png', Buffer.from('x'));
			await page.waitForFunction(() => /picture\.png/.test(document.querySelector('.status').textContent));
			assert.equal(await status(page), 'picture.png is no .obj, .dae, .zae, .glb, .gltf or .stl file.');
			assert.equal(await page.locator('tbody tr').count(), 11, 'what was there is there');
		},

		'settings change what is found': async (page) => {
			const nodes = () => page.textContent('.results .card:last-child .note');
			const before = await nodes();
			await page.getByLabel('Fewest vertices to split').fill('200');
			await page.getByLabel('Tolerance for cheaper tests').fill('10');
			await page.getByRole('button', { name: 'Measure again' }).click();
			await page.waitForFunction((old) => document.querySelector('.results .card:last-child .note').textContent !== old, before);
			assert.match(await page.textContent('.results .card .note'), /takes the naive sphere/);
			await page.getByLabel('Fewest vertices to split').fill('0');
			await page.evaluate(() => document.querySelector('form').noValidate = true);
			await page.getByRole('button', { name: 'Measure again' }).click();
			await page.waitForSelector('.status.problem');
			assert.match(await status(page), /^That number is not possible: /);
		},
	},
	compare: {
		'the counts are those of the engine\'s own test': async (page) => {
			const table = async () => Object.fromEntries(await page.locator('tr[data-system]').evaluateAll((rows) => rows.map((row) => [
				row.dataset.system, [...row.querySelectorAll('td')].slice(0, 3).map((cell) => Number(cell.textContent)),
			])));
			for (const frame of counts.frames) {
				const { touching, ...systems } = frame;
				assert.match(await page.textContent('.scattered .note'), new RegExp(`; ${touching} pairs`));
				assert.deepEqual(await table(), systems);
				await page.getByRole('button', { name: 'A frame on' }).click();
			}
		},

		'two agents are moved by sliders and by dragging': async (page) => {
			const verdicts = () => page.locator('.verdict strong').allTextContents();
			assert.deepEqual(await verdicts(), ['false collision', 'false collision', 'do not', 'do not', 'do not']);
			const z = page.locator('details[open] .slider', { hasText: /^z/ }).locator('input');
			await z.fill('3');
			assert.deepEqual(await verdicts(), ['do not', 'do not', 'do not', 'do not', 'do not']);
			await z.fill('0.1');
			const x = page.locator('details[open] .slider', { hasText: /^x/ }).locator('input');
			const before = await x.inputValue();
			const at = await page.evaluate(() => {
				const { agents: [, ball], stage: { camera, canvas } } = globalThis.playground;
				const point = camera.position.clone().set(ball.x, ball.y, ball.z + ball.size / 2).project(camera);
				const box = canvas.getBoundingClientRect();
				return { x: box.left + ((point.x + 1) / 2) * box.width, y: box.top + ((1 - point.y) / 2) * box.height };
			});
			await page.mouse.move(at.x, at.y);
			await page.mouse.down();
			await page.mouse.move(at.x + 120, at.y + 10, { steps: 4 });
			await page.mouse.up();
			assert.notEqual(await x.inputValue(), before);
		},
	},
};

// a page is opened once: that is what takes the time
for (const [name, size] of Object.entries(SIZES)) {
	for (const view of VIEWS) {
		test(`${view}, ${name}`, async (t) => {
			const { page, context, said } = await open(site, view, size);
			const more = name === 'desktop' ? { ...EVERY_VIEW, ...IN_VIEW[view] } : {};
			for (const [title, check] of Object.entries({ 'nothing on the console, nothing from elsewhere, nothing that axe-core calls serious': looksWell, ...more })) {
				await t.test(title, async () => {
					await check(page, view, size);
					assert.deepEqual(said, []);
				});
			}
			await context.close();
		});
	}
}

test('without WebGL the page says so, and the rest works', async () => {
	const { page, context } = await open({ ...site, browser: {
		newContext: async (options) => {
			const made = await site.browser.newContext(options);
			await made.addInitScript(() => {
				HTMLCanvasElement.prototype.getContext = () => null;
			});
			return made;
		},
	} }, 'inspect');
	assert.match(await page.textContent('.world'), /^This browser draws no 3D here/);
	assert.equal(await page.locator('tbody tr').count(), 11);
	await context.close();
});

test('the page is under a strict policy, and has the licences of what it brings', () => {
	const html = readFileSync(path.join(root, 'bin/playground/index.html'), 'utf8');
	const policy = /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(html)[1];
	assert.match(policy, /^default-src 'none'; script-src 'self'; style-src 'self';/);
	assert.doesNotMatch(policy, /unsafe|https?:|\*/);
	assert.ok(existsSync(path.join(root, 'bin/playground/LICENSES.txt')));
	assert.ok(statSync(path.join(root, 'bin/playground/main.js')).size < 20000, 'the first script is small');
});
