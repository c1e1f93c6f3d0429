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
