/** What users do out of the usual order: while something loads, after a game has stopped, after another tab has changed something. In the browser. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { isChromium } from '../../build/headless/browsers.mjs';
import { change, collision, create, each, go as place, heading, move, program, start } from '../../js/playground/play/builtin/notation.js';
import { packed } from '../../js/playground/shared/files/packing.js';
import { SIZES, begin, drop, go, hold, listen, open, openProgram, own, press, ready, rest, saved, titled } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

/** A bear and a wall in one place, whose collision raises the score. */
const COUNTING = program(start(create(1, 'bears', 'bear'), create(1, 'walls', 'wall')), collision('bears', 'walls', change(1)));

const score = (page) => page.evaluate(() => globalThis.playground.world.score);

test('before the blocks are there, no control of Play does anything, and no key starts the game', async () => {
	const { page, said, leave } = await open(site, 'play/jump', SIZES.laptop);
	const release = await hold(page, '**/parts/editor-*.js');
	await page.reload();
	await page.waitForFunction(() => document.querySelector('.status')?.textContent === 'Loading…');
	assert.ok(await page.getByLabel('Collision system').evaluate((each) => each.closest('[inert]') !== null));
	assert.ok(await page.getByLabel('Camera').evaluate((each) => each.closest('[inert]') !== null));
	// whatever has the focus
	await page.evaluate(() => document.querySelector('.world').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true })));
	release();
	await ready(page, 'play');
	assert.ok(await page.getByLabel('Camera').evaluate((each) => each.closest('[inert]') === null));
	assert.deepEqual(said, []);
	await leave();
});

test('who chooses a program while a link is read gets the chosen one', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	await page.evaluate(() => {
		const { arrayBuffer } = Blob.prototype;
		const held = new Promise((resolve) => {
			globalThis.goOn = resolve;
		});
		Blob.prototype.arrayBuffer = async function late() {
			await held;
			return arrayBuffer.call(this);
		};
	});
	await go(page, `play/${await packed({ name: 'Linked', ...COUNTING })}`);
	await rest(page);
	await page.evaluate(() => globalThis.playground.programs.choose('maze'));
	await titled(page, 'Maze');
	await page.evaluate(() => globalThis.goOn());
	await rest(page, 200);
	assert.deepEqual(await page.evaluate(() => [document.querySelector('.title').value, location.hash]), ['Maze', '#play/maze']);
	assert.deepEqual(said, []);
	await leave();
});

test('an address with the name of something that every object has leads nowhere, and says so', async () => {
	const { page, said, leave } = await open(site, 'play/constructor', SIZES.laptop);
	await page.waitForSelector('.gallery [role=alert]');
	assert.equal(await page.inputValue('.title'), 'Paintball');
	await go(page, 'teach/constructor');
	await page.waitForSelector('main[data-ready=teach] [role=alert]');
	assert.deepEqual(said, []);
	await leave();
});

test('a stopped game shows what another system finds, and what a dragged agent touches, without running collision scripts', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	await openProgram(page, 'counting', COUNTING);
	await press(page, 'Step');
	const before = await score(page);
	assert.ok(before > 0);
	for (const system of ['exact', 'hierarchies', 'unit spheres']) await page.getByLabel('Collision system').selectOption(system);
	assert.equal(await score(page), before);
	assert.ok(await page.evaluate(() => globalThis.playground.world.collisions.collision.statistics.collisions > 0));
	await press(page, 'Step');
	assert.equal(await score(page), before + 1, 'the next frame runs them');
	assert.deepEqual(said, []);
	await leave();
});

test('who clicks an agent while the game runs still reads the frames of a second', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	await press(page, 'Run');
	await page.waitForFunction(() => [...document.querySelectorAll('.figures div')].find((each) => /frames/.test(each.textContent)).querySelector('dd').textContent !== '–');
	const shown = await page.evaluate(() => {
		globalThis.playground.draw();
		return [...document.querySelectorAll('.figures div')].find((each) => /frames/.test(each.textContent)).querySelector('dd').textContent;
	});
	assert.match(shown, /^[1-9]\d*$/);
	await press(page, 'Stop');
	assert.deepEqual(said, []);
	await leave();
});

test('after something else was moved no “Undo” is offered for deleted blocks, because it would undo the move', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	const count = () => page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_hatch').length);
	const before = await count();
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_hatch')[0].checkAndDelete());
	await page.getByRole('button', { name: 'Undo', exact: true }).last().waitFor();
	await page.evaluate(() => globalThis.playground.editor.workspace.getTopBlocks()[0].moveBy(0, 40));
	await rest(page, 100);
	assert.equal(await page.locator('.controls .status button').count(), 0, 'the button would undo the move');
	await page.locator('.tool-undo').click();
	await page.locator('.tool-undo').click();
	await page.waitForFunction((all) => globalThis.playground.editor.workspace.getBlocksByType('starlogo_hatch').length === all, before);
	assert.deepEqual(said, []);
	await leave();
});

test('after the game has gone back, a tone is played only in a frame in which a touch begins', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	await listen(page);
	await openProgram(page, 'apart', program(start(create(1, 'bears', 'bear', place(-3, 0, 0)), create(1, 'walls', 'wall')), each('bears', heading(0), move(0.5))));
	for (let i = 0; i < 16; i++) await press(page, 'Step');
	const touched = await page.evaluate(() => globalThis.playground.world.meetings.at(-1)?.frame);
	assert.ok(touched > 1 && touched < 14, `they touch in frame ${touched}`);
	const tones = () => page.evaluate(() => globalThis.tones.length);
	const before = await tones();
	assert.ok(before > 0);
	await page.getByLabel('Rewind').fill('-1');
	await press(page, 'Step');
	assert.equal(await tones(), before);
	assert.deepEqual(said, []);
	await leave();
});

test('a program that another tab has removed cannot be removed here any more, and an emptied name is the last one', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	await openProgram(page, 'A', COUNTING);
	await press(page, 'Lessons and games');
	const name = page.locator('.gallery .own input');
	await name.fill('B');
	await name.press('Enter');
	await name.fill('');
	await name.press('Tab');
	assert.equal(await name.inputValue(), 'B');
	assert.deepEqual(await own(page), ['B']);
	await page.evaluate(() => localStorage.setItem('starlogo-playground.programs', '[]'));
	await page.locator('.gallery .own button').click();
	await titled(page, 'Paintball');
	assert.deepEqual(await own(page), []);
	assert.deepEqual(said, []);
	await leave();
});

test('what is handed in has each solution once', { skip: isChromium ? false : 'downloads are Chromium\'s' }, async () => {
	const { page, said, leave } = await open(site, 'play/lesson-blocks', SIZES.laptop);
	await page.evaluate(() => {
		const { workspace } = globalThis.playground.editor;
		const script = workspace.getBlocksByType('starlogo_each')[0];
		const block = workspace.newBlock('starlogo_forward');
		block.initSvg?.();
		block.getInput('STEPS').connection.setShadowState({ type: 'math_number', fields: { NUM: 0.05 } });
		let last = script.getInput('DO').connection.targetBlock();
		while (last.getNextBlock()) last = last.getNextBlock();
		last.nextConnection.connect(block.previousConnection);
	});
	await titled(page, 'Blocks make turtles move (mine)');
	await press(page, 'Run');
	await page.waitForFunction(() => /^Done!/.test(document.querySelector('.why').textContent));
	await press(page, 'Stop');
	await press(page, 'Hand in…');
	const dialog = page.getByRole('dialog');
	await dialog.getByLabel('Name').fill('Ada');
	const work = JSON.parse(await saved(page, () => dialog.getByRole('button', { name: 'Save a file' }).click()));
	assert.deepEqual([work.done, work.programs.map(({ lesson }) => lesson), Object.keys(work.solutions)], [['blocks'], ['blocks'], []]);
	assert.deepEqual(said, []);
	await leave();
});

/** An OBJ file of a box. */
const cube = (width) => Buffer.from(`${[0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].map((z) => `v ${width * x} ${y} ${z}`))).join('\n')}\nf 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n`);

test('a changed file of the same name replaces its model in Compare and in Measure', async () => {
	const { page, said, leave } = await open(site, 'compare', SIZES.laptop);
	const size = () => page.evaluate(() => (globalThis.playground.live ?? globalThis.playground).greatLand.boundingStructures.tightestFit('box.obj').volume);
	for (const view of ['compare', 'measure']) {
		if (view === 'measure') {
			await go(page, view);
			await ready(page, view);
		}
		const sizes = [];
		for (const width of [1, 3]) {
			await drop(page, ['box.obj', cube(width)]);
			// Compare's address follows late
			await rest(page, 600);
			sizes.push(await size());
		}
		assert.ok(sizes[0] > 0 && sizes[1] !== sizes[0], `${view}: ${sizes}`);
	}
	assert.deepEqual(said, []);
	await leave();
});

test('Measure: the chart shows the measurement that the menu names: one of a file, chosen again', async () => {
	const { page, said, leave } = await open(site, 'measure', SIZES.laptop);
	const result = (machine, date) => ({ machine, date, points: { exact: [[50, 1], [100, 2]] } });
	await page.evaluate((kept) => localStorage.setItem('starlogo-playground.measured', JSON.stringify(kept)), [result('Kept', '2020-01-01T00:00:00Z')]);
	await page.reload();
	await ready(page, 'measure');
	await page.getByRole('radio', { name: 'All systems in turn' }).check();
	await page.setInputFiles('.series input[type=file]', { name: 'other.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(result('File', '2021-01-01T00:00:00Z'))) });
	await page.waitForFunction(() => globalThis.playground.other?.machine === 'File');
	const others = page.locator('.series select').last();
	await others.selectOption('0');
	assert.equal(await page.evaluate(() => globalThis.playground.other.machine), 'Kept');
	await others.selectOption({ label: await others.locator('option', { hasText: 'File' }).textContent() });
	assert.equal(await page.evaluate(() => globalThis.playground.other.machine), 'File');
	assert.deepEqual(said, []);
	await leave();
});
