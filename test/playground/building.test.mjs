/** A level that is built in the world, by mouse: kept in the program as blocks, and undone like them. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { SIZES, begin, drag, open } from './browser.mjs';
import { parts } from './parts.mjs';

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
	const size = () => page.locator('.screens').boundingBox();
	const before_ = await size();
	assert.equal(await page.locator('.drag-note').isVisible(), false, 'the line about the picture is gone');
	const at = await pixelOf(page, 1);
	await page.mouse.move(at.x, at.y);
	await page.mouse.down();
	await page.mouse.move(at.x + 20, at.y + 12, { steps: 4 });
	await page.mouse.up();
	await changed(([, [, x]]) => x !== -3.5 && x % 0.5 === 0);
	const moved = (await agentsOf(page))[1];
	assert.ok(moved[1] % 0.5 === 0 && moved[2] % 0.5 === 0 && moved[3] === 1, `on whole and half patches: ${moved}`);
	assert.ok(await page.evaluate(() => globalThis.playground.scene.chosen === globalThis.playground.world.agents[1]), 'it is chosen');
	assert.deepEqual(await size(), before_, 'the buttons for it move nothing');
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

test('the ground is raised and lowered, and a maze is built, by mouse: as blocks, and Undo takes each stroke back', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	await page.evaluate(() => globalThis.playground.programs.openNew());
	await page.waitForFunction(() => globalThis.playground.world.agents.length === 1);
	await page.getByText('Build', { exact: true }).click();
	const heights = (...places) => page.evaluate((all) => all.map(([x, y]) => globalThis.playground.world.terrain?.heightAt(x, y) ?? null), places);
	const brush = (name) => page.getByRole('button', { name, exact: true }).click();
	const blocks = (type) => page.evaluate((wanted) => globalThis.playground.editor.workspace.getBlocksByType(wanted).length, type);
	await brush('Raise the ground');
	await drag(page, [-3, -5], [3, -5]);
	assert.deepEqual(await heights([-3, -5], [0, -5], [3, -5], [0, -3]), [1, 1, 1, 0]);
	assert.equal(await blocks('starlogo_raise'), 7);
	const slopes = await page.evaluate(() => {
		const { geometry } = globalThis.playground.stage.land.field;
		const [position, colour] = ['position', 'color'].map((name) => geometry.getAttribute(name));
		const at = (x, y) => Array.from({ length: position.count }, (_, i) => i).find((i) => position.getX(i) === x && position.getY(i) === y);
		return [[0, -6], [0, 3]].map(([x, y]) => colour.getZ(at(x, y)) / colour.getX(at(x, y)));
	});
	assert.ok(slopes[0] < 0.8 && slopes[1] === 1, `slopes have the colour of earth: ${slopes}`);
	await drag(page, [0, -5], [1, -5]);
	assert.deepEqual(await heights([0, -5], [1, -5], [2, -5]), [2, 2, 1]);
	await brush('Lower the ground');
	await drag(page, [3, -5], [3, -8]);
	assert.deepEqual(await heights([3, -5], [3, -8]), [0, -1]);
	assert.equal(await blocks('starlogo_raise'), 9, 'what is level again has no block');
	await brush('Walls');
	await drag(page, [-5, 5], [5, 5]);
	await drag(page, [-5, 5], [-5, 1]);
	const walls = (await agentsOf(page)).filter(([breed]) => breed === 'walls');
	assert.deepEqual(walls.map(([, x, y,, heading]) => [x, y, heading]), [[-3.5, 5, 90], [0, 5, 90], [3.5, 5, 90], [-5, 3, 0]]);
	assert.deepEqual([await blocks('starlogo_solid'), await page.evaluate(() => globalThis.playground.world.walking.solidBreeds)], [1, ['walls']], 'nobody goes through them');
	// each stroke is one step
	const states = [4, 3, 0, 0, 0];
	for (let i = 1; i <= 4; i++) {
		await page.locator('.tool-undo').click();
		await page.waitForFunction((count) => globalThis.playground.world.agents.filter(({ breed }) => breed === 'walls').length === count, states[i]);
	}
	await page.waitForFunction(() => globalThis.playground.world.terrain?.heightAt(1, -5) === 1);
	await page.locator('.tool-undo').click();
	await page.waitForFunction(() => globalThis.playground.world.terrain === null);
	assert.equal(await page.locator('.tool-undo').getAttribute('aria-disabled'), 'true');
	// the maze of the game “Key and house” is what these strokes build
	await brush('Walls');
	for (const [from, to] of parts.STROKES) await drag(page, from, to);
	const built = (await agentsOf(page)).filter(([breed]) => breed === 'walls');
	await page.evaluate((game) => globalThis.playground.programs.choose(game), 'drive');
	await page.waitForFunction(() => globalThis.playground.world.agents.some(({ breed }) => breed === 'cars'));
	assert.deepEqual(built, (await agentsOf(page)).filter(([breed]) => breed === 'walls'));
	assert.ok(built.length >= 30, `${built.length} walls`);
	await page.goBack();
	await page.waitForFunction(() => globalThis.playground.world.agents.some(({ breed }) => breed === 'bears'));
	// without the brush the pointer turns the world again
	await brush('Agents');
	const eye = () => page.evaluate(() => globalThis.playground.stage.camera.position.x);
	const before_ = await eye();
	await drag(page, [-3, -5], [3, -5]);
	assert.notEqual(await eye(), before_);
	assert.deepEqual(said, []);
	await leave();
});
