/** What a child meets who runs games again and again: random numbers, the camera, lessons that start by themselves, words. In the browser. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { SIZES, begin, open, openProgram, press, ready, rest, titled, told } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

const places = (page) => page.evaluate(() => globalThis.playground.world.agents.map(({ x, y, heading }) => [x, y, heading].join(' ')).join());
const frame = (page) => page.evaluate(() => globalThis.playground.world.frame);

test('each run has other random numbers; a lesson has the same, and so has a game that is rewound or changed', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	const first = await places(page);
	await press(page, 'Reset');
	const second = await places(page);
	assert.notEqual(second, first);
	await press(page, 'Reset');
	assert.ok(![first, second].includes(await places(page)));
	// whoever changes a block sees the same game
	const third = await places(page);
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_hatch')[0].setFieldValue('cube', 'SHAPE'));
	await titled(page, 'Paintball (mine)');
	assert.equal(await places(page), third);
	await page.evaluate(() => {
		delete document.querySelector('main').dataset.ready;
		location.hash = 'play/lesson-hunt';
	});
	await ready(page, 'play');
	await titled(page, 'The hunt');
	const lesson = await places(page);
	await press(page, 'Reset');
	assert.equal(await places(page), lesson);
	assert.deepEqual(said, []);
	await leave();
});

test('a lesson that starts at the choice of a system is not stopped by a click on Run, and says no more what was wrong before', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-wing', SIZES.laptop);
	await press(page, 'Run');
	await page.waitForFunction(() => /^Not yet: .*not exact enough/.test(document.querySelector('.why').textContent));
	await page.getByLabel('Collision system').selectOption('exact');
	assert.equal(await page.textContent('.why'), '');
	await page.waitForFunction(() => globalThis.playground.world.frame > 3);
	await page.locator('.run').click();
	await page.waitForFunction(() => globalThis.playground.isRunning && globalThis.playground.world.frame > 3);
	assert.equal(await page.locator('.run').textContent(), 'Stop');
	await page.locator('.run').click();
	assert.ok(!(await page.evaluate(() => globalThis.playground.isRunning)));
	const stopped = await frame(page);
	await rest(page, 100);
	assert.equal(await frame(page), stopped);
	assert.deepEqual(said, []);
	await leave();
});

test('a key of the program starts its game, as in Level, and other keys do not', async () => {
	const { page, said, leave } = await open(site, 'play/jump', SIZES.laptop);
	await page.locator('.world').first().focus();
	await page.keyboard.press('ArrowDown');
	assert.ok(!(await page.evaluate(() => globalThis.playground.isRunning)), 'there is no script for it');
	const x = () => page.evaluate(() => globalThis.playground.world.agents.find(({ breed }) => breed === 'people').x);
	const before = await x();
	await page.keyboard.down('ArrowRight');
	await page.waitForFunction((from) => globalThis.playground.isRunning && globalThis.playground.world.agents.find(({ breed }) => breed === 'people').x > from + 0.3, before);
	await page.keyboard.up('ArrowRight');
	assert.deepEqual(said, []);
	await leave();
});

test('“All of it” frames what is added, and a reload keeps the camera that was chosen', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	await press(page, 'New');
	await titled(page, 'My program');
	// a platform game has its breeds in the menus of an empty program
	const breeds = await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].getField('BREED').getOptions(false).map(([, value]) => value));
	for (const breed of ['platforms', 'coins', 'houses']) assert.ok(breeds.includes(breed), `${breeds}`);
	const isSeen = () => page.evaluate(() => globalThis.playground.world.agents.map(({ x, y, z }) => {
		const { x: across, y: up, z: deep } = globalThis.playground.stage.camera.position.clone().set(x, y, z).project(globalThis.playground.stage.camera);
		return Math.abs(across) < 1 && Math.abs(up) < 1 && deep < 1;
	}));
	await page.evaluate(() => {
		const { workspace } = globalThis.playground.editor;
		const number = (value) => ({ shadow: { type: 'math_number', fields: { NUM: value } } });
		const go = { type: 'starlogo_go', inputs: { X: number(7), Y: number(6), Z: number(0) } };
		const create = (breed, shape, inner) => ({ type: 'starlogo_create', fields: { BREED: breed, SHAPE: shape }, inputs: { COUNT: number(1), ...(inner && { DO: { block: inner } }) } });
		globalThis.playground.programs.openFile(new File([JSON.stringify({ blocks: { languageVersion: 0, blocks: [{ type: 'starlogo_start', inputs: { DO: { block: { ...create('bears', 'bear'), next: { block: create('turtles', 'turtle', go) } } } } }] } })], 'far.json'));
	});
	await titled(page, 'far');
	assert.deepEqual(await isSeen(), [true, true]);
	// further away, by a change in the program
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_go')[0].getInputTargetBlock('X').setFieldValue(-11, 'NUM'));
	await page.waitForFunction(() => globalThis.playground.world.agents[1].x === -11);
	assert.deepEqual(await isSeen(), [true, true]);
	await page.getByLabel('Camera').selectOption('eyes');
	await page.reload();
	await ready(page, 'play');
	await titled(page, 'far');
	assert.equal(await page.getByLabel('Camera').inputValue(), 'eyes');
	assert.deepEqual(said, []);
	await leave();
});

test('“All of it” follows the only agent that moves when it walks out of the picture, unless the user has turned the picture', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	const blocks = [{ type: 'starlogo_start', inputs: { DO: { block: { type: 'starlogo_create', fields: { BREED: 'bears', SHAPE: 'bear' }, inputs: { COUNT: { shadow: { type: 'math_number', fields: { NUM: 1 } } } } } } } },
		{ type: 'starlogo_each', fields: { BREED: 'bears' }, inputs: { DO: { block: { type: 'starlogo_forward', inputs: { STEPS: { shadow: { type: 'math_number', fields: { NUM: 0.05 } } } } } } } }];
	await openProgram(page, 'away', { blocks: { languageVersion: 0, blocks } });
	const unseen = (frames) => page.evaluate((count) => {
		const { world, stage, draw } = globalThis.playground;
		let most = 0;
		for (let i = 0, lost = 0; i < count; i++) {
			world.step();
			draw.call(globalThis.playground);
			const [{ x, y, z }] = world.agents;
			lost = stage.pixelOf(x, y, z).isSeen ? 0 : lost + 1;
			most = Math.max(most, lost);
		}
		return most;
	}, frames);
	assert.ok(await unseen(900) <= 21, 'it is out of sight for a third of a second at most');
	await press(page, 'Reset');
	await page.locator('.world').focus();
	const { x, y, width, height } = await page.locator('.world canvas').first().boundingBox();
	await page.mouse.move(x + 0.1 * width, y + 0.6 * height);
	await page.mouse.down();
	await page.mouse.move(x + 0.1 * width + 20, y + 0.6 * height, { steps: 4 });
	await page.mouse.up();
	assert.ok(await unseen(900) > 100, 'the picture stays where the user has turned it');
	assert.deepEqual(said, []);
	await leave();
});

test('at the first visit no button leads back to a game that nobody opened; drawers have no empty holes in “set”, “=” and “and”', async () => {
	const { page, said, leave } = await open(site, 'play', SIZES.laptop);
	await page.locator('.gallery .open', { hasText: 'Chase' }).click();
	await titled(page, 'Chase');
	assert.equal(await page.getByRole('button', { name: 'Back to “Paintball”' }).count(), 0);
	await page.evaluate(() => {
		location.hash = 'play/maze';
	});
	await titled(page, 'Maze');
	await told(page, /^“Maze” is open/);
	assert.equal(await page.getByRole('button', { name: 'Back to “Chase”' }).count(), 1);
	const empty = (category, types) => page.evaluate(([name, wanted]) => {
		const { workspace } = globalThis.playground.editor;
		workspace.getVariableMap().createVariable('item');
		const toolbox = workspace.getToolbox();
		toolbox.setSelectedItem(toolbox.getToolboxItems().find((item) => item.getName() === name));
		return workspace.getFlyout().getWorkspace().getTopBlocks().filter(({ type }) => wanted.includes(type)).map(({ type, inputList }) => [type, inputList.filter(({ connection }) => connection && !connection.targetConnection).length]);
	}, [category, types]);
	assert.deepEqual(await empty('Control', ['logic_compare', 'logic_operation', 'logic_negate']), [['logic_compare', 0], ['logic_operation', 0], ['logic_negate', 0]]);
	assert.deepEqual(await empty('Variables', ['variables_set']), [['variables_set', 0]]);
	// the drawer is open for the new variable
	await page.locator('.blocklyFlyoutButton').first().click();
	await page.locator('.ask input').fill('lives');
	await page.keyboard.press('Enter');
	await page.locator('.ask').waitFor({ state: 'detached' });
	await rest(page, 100);
	const drawer = () => page.evaluate(() => {
		const flyout = globalThis.playground.editor.workspace.getFlyout();
		return flyout.isVisible() && flyout.getWorkspace().getTopBlocks().filter(({ type }) => type === 'variables_get').map((block) => block.getField('VAR').getText());
	});
	assert.deepEqual(await drawer(), ['item', 'lives', 'place']);
	assert.deepEqual(said, []);
	await leave();
});

test('one key leads past the views into the open one', async () => {
	const { page, said, leave } = await open(site, 'measure', SIZES.laptop);
	await page.keyboard.press('Tab');
	await page.locator('.skip:focus').waitFor();
	assert.ok(await page.locator('.skip').evaluate((each) => each.getBoundingClientRect().width > 50));
	await page.keyboard.press('Enter');
	await page.keyboard.press('Tab');
	assert.ok(await page.evaluate(() => document.activeElement !== document.body && document.querySelector('main').contains(document.activeElement)));
	assert.equal(await page.evaluate(() => location.hash), '#measure');
	assert.deepEqual(said, []);
	await leave();
});
