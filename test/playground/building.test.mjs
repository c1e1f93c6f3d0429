/** A level that is built in the world, by mouse: kept in the program as blocks, and undone like them. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { SIZES, begin, open } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

/** Where an agent's middle is on the screen. */
const pixelOf = (page, i) => page.evaluate((at) => {
	const { world: { agents: { [at]: agent } }, stage: { camera, canvas } } = globalThis.playground;
	const point = camera.position.clone().set(agent.x, agent.y, agent.z + agent.size / 8).project(camera);
	const box = canvas.getBoundingClientRect();
	return { x: box.left + ((point.x + 1) / 2) * box.width, y: box.top + ((1 - point.y) / 2) * box.height };
}, i);

const agentsOf = (page) => page.evaluate(() => globalThis.playground.world.agents.map(({ breed, x, y, z, heading }) => [breed, x, y, z, heading]));

test('agents are moved, copied, turned, raised and deleted in the world, and Undo takes it back', async () => {
	const { page, said, leave } = await open(site, 'play/jump', SIZES.laptop);
	await page.getByText('Build', { exact: true }).click();
	const first = await agentsOf(page);
	const bar = page.locator('.build-bar');
	assert.equal(await bar.isVisible(), false, 'nobody is chosen');
	const changed = async (is) => {
		for (let i = 0; i < 100; i++) {
			if (is(await agentsOf(page))) return;
			await page.waitForTimeout(30);
		}
		assert.fail(`${is}: ${JSON.stringify(await agentsOf(page))}`);
	};
	const at = await pixelOf(page, 1);
	await page.mouse.move(at.x, at.y);
	await page.mouse.down();
	await page.mouse.move(at.x + 20, at.y + 12, { steps: 4 });
	await page.mouse.up();
	await changed(([, [, x]]) => x !== -3.5 && x % 0.5 === 0);
	const moved = (await agentsOf(page))[1];
	assert.ok(moved[1] % 0.5 === 0 && moved[2] % 0.5 === 0 && moved[3] === 1, `on whole and half patches: ${moved}`);
	assert.ok(await page.evaluate(() => globalThis.playground.scene.chosen === globalThis.playground.world.agents[1]), 'it is chosen');
	for (const [name, what] of [['Turn', ([, [,,,, heading]]) => heading === 45], ['Higher', ([, [,,, z]]) => z === 1.5], ['Lower', ([, [,,, z]]) => z === 1]]) {
		await bar.getByRole('button', { name, exact: true }).click();
		await changed(what);
	}
	await bar.getByRole('button', { name: 'Copy', exact: true }).click();
	await changed(({ length }) => length === first.length + 1);
	assert.deepEqual((await agentsOf(page))[2].slice(0, 1), ['platforms'], 'the copy is the next one');
	assert.ok(await page.evaluate(() => globalThis.playground.scene.chosen === globalThis.playground.world.agents[2]), 'the copy is chosen');
	await bar.getByRole('button', { name: 'Delete', exact: true }).click();
	await changed(({ length }) => length === first.length);
	for (let i = 0; i < 6; i++) await page.locator('.tool-undo').click();
	await changed((agents) => JSON.stringify(agents) === JSON.stringify(first));
	assert.equal(await page.locator('.tool-undo').getAttribute('aria-disabled'), 'true', 'each was one step');
	assert.deepEqual(said, []);
	await leave();
});
