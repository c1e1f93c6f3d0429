/** Measure's game: its figures can be compared, and it fills the page. In the browser. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { SIZES, begin, open, press } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

test('the engine and Rapier tell of the same frame, so they have the same pairs; without the world the figures have all of the page', async () => {
	const { page, said, leave } = await open(site, 'measure', SIZES.laptop);
	await page.getByRole('slider', { name: 'Agents' }).fill('0');
	// both in one look, because the next frame changes both
	const figures = (...names) => page.evaluate((wanted) => wanted.map((name) => [...document.querySelectorAll('.live .figures div')].find((each) => each.className.endsWith(`part-${name}`)).querySelector('dd').textContent), names);
	await page.getByLabel('Rapier beside it').check();
	const found = [];
	await press(page, 'Run');
	for (let i = 0; i < 5; i++) {
		await page.waitForFunction((before) => Number([...document.querySelectorAll('.live .part-inRapier dd')][0].textContent) > 0 && document.querySelector('.live .figures').textContent !== before, await page.textContent('.live .figures'));
		found.push(await figures('pairs', 'inRapier'));
	}
	await press(page, 'Stop');
	assert.ok(found.every(([engine, rapier]) => Math.abs(engine - rapier) <= 1 && engine > 0), JSON.stringify(found));
	assert.ok(new Set(found.map(String)).size > 1, 'the frames are not all alike');
	const width = () => page.evaluate(() => document.querySelector('.live .times').getBoundingClientRect().width / document.querySelector('.live').getBoundingClientRect().width);
	assert.ok(await width() < 0.6);
	await page.getByLabel('Draw the world').uncheck();
	assert.ok(await width() > 0.95);
	assert.deepEqual(said, []);
	await leave();
});

test('with both others beside it the figures are in two rows, and the graph has every dot of a library that takes long', async () => {
	const { page, said, leave } = await open(site, 'measure', SIZES.laptop);
	for (const name of ['kdbush beside it', 'Rapier beside it']) await page.getByLabel(name).check();
	await page.waitForFunction(() => globalThis.playground.live.rapier);
	const rows = await page.locator('.live .figures > div:visible').evaluateAll((all) => all.map((each) => each.getBoundingClientRect().top));
	assert.deepEqual(rows, [...Array(4).fill(rows[0]), ...Array(4).fill(rows[4])]);
	assert.ok(rows[4] > rows[0]);
	const dots = await page.evaluate(() => {
		const { parts } = globalThis.playground.live;
		parts.clear();
		// of every sixth frame; one of them is a hundred times as long as the others
		for (let i = 0; i < 180; i++) parts.add({ move: 1, engine: 2, draw: 1, ...i % 6 === 0 && { rapier: i === 60 ? 5000 : 50 + (i % 7) } });
		parts.draw();
		const { canvas } = parts;
		const hex = getComputedStyle(canvas).getPropertyValue('--part-rapier');
		const colour = [1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16)).join();
		const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
		const columns = Array.from({ length: canvas.width }, () => false);
		for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255 && data.subarray(i, i + 3).join() === colour) columns[(i / 4) % canvas.width] = true;
		return columns.filter((has, i) => has && !columns[i - 1]).length;
	});
	assert.equal(dots, 30);
	assert.deepEqual(said, []);
	await leave();
});
