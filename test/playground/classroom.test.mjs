/** Play before a class: from the first screen to lessons that are done, and to a game of one's own that is opened elsewhere. Nothing is drawn in 3D. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PATIENCE, isChromium } from '../../build/headless/browsers.mjs';
import { SIZES, begin, finger, focused, listen, open, own, press, ready, refuseCopies, rest, tabTo, tap, titled, told } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

const Desktop = SIZES.laptop;
const Phone = SIZES.phone;

/** Waits for the lesson of a number. */
const lesson = (page, number) => page.waitForFunction((n) => document.querySelector('.lesson')?.textContent.startsWith(`Lesson ${n} of 11`), number);
const done = (page) => page.waitForFunction(() => /^Done! .{20}/.test(document.querySelector('.why').textContent));
const agents = (page) => page.evaluate(() => globalThis.playground.world.agents.map(({ breed, shape, x, y }) => ({ breed, shape, x, y })));
const types = (page, type) => page.evaluate((wanted) => globalThis.playground.editor.workspace.getBlocksByType(wanted).length, type);

/** The middle of what matches, once it has stopped moving. */
async function middle(page, selector) {
	const { x, y, width, height } = await page.locator(selector).first().boundingBox();
	return { x: x + width / 2, y: y + height / 2 };
}

/** Where a block of the drawer can be held: at its first word. */
const heldAt = async (page, type) => {
	await page.waitForFunction((wanted) => globalThis.playground.editor.workspace.getFlyout().isVisible() && globalThis.playground.editor.workspace.getFlyout().getWorkspace().getBlocksByType(wanted).length > 0, type);
	return page.evaluate((wanted) => {
		const [block] = globalThis.playground.editor.workspace.getFlyout().getWorkspace().getBlocksByType(wanted);
		const { left, top, height } = block.getSvgRoot().querySelector(':scope > .blocklyPath').getBoundingClientRect();
		return { x: left + 12, y: top + Math.min(height / 2, 20) };
	}, type);
};

/** Where something connects behind the first block in a script: below its last block. The mark of where a dragged block would go is none. */
const endOf = (page, type) => page.evaluate((wanted) => {
	let block = globalThis.playground.editor.workspace.getBlocksByType(wanted)[0].getInputTargetBlock('DO');
	while (block.getNextBlock() && !block.getNextBlock().isInsertionMarker()) block = block.getNextBlock();
	const { left, bottom } = block.getSvgRoot().querySelector(':scope > .blocklyPath').getBoundingClientRect();
	return { x: left + 12, y: bottom + 16 };
}, type);

test('the first three lessons are done with the mouse, from the first screen on', async () => {
	const { page, said, leave } = await open(site, 'play', Desktop);
	assert.equal(await page.locator('.gallery ol').first().locator('li').count(), 11);
	assert.deepEqual(await page.locator('.gallery ol').first().locator('.number').allTextContents(), Array.from({ length: 11 }, (_, i) => String(i + 1)));
	await page.locator('.gallery .next').click();
	await lesson(page, 1);
	// the script that the lesson is about is in sight
	const script = await page.evaluate(() => {
		const { top, bottom } = globalThis.playground.editor.workspace.getBlocksByType('starlogo_each')[0].getSvgRoot().getBoundingClientRect();
		const host = document.querySelector('.blocks').getBoundingClientRect();
		return top >= host.top && bottom <= host.bottom;
	});
	assert.ok(script);
	await page.locator('.blocklyToolboxCategory', { hasText: 'Movement' }).click();
	const from = await heldAt(page, 'starlogo_forward');
	const to = await endOf(page, 'starlogo_each');
	await page.mouse.move(from.x, from.y);
	await page.mouse.down();
	// straight down first, out of the block
	for (let i = 1; i <= 6; i++) await page.mouse.move(from.x, from.y + 15 * i);
	assert.equal(await types(page, 'starlogo_forward'), 1, 'a block that is pulled straight down comes out of the drawer');
	await page.mouse.move(to.x, to.y, { steps: 5 });
	await page.mouse.up();
	await titled(page, 'Blocks make turtles move (mine)');
	assert.ok(await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_forward')[0].getRootBlock().type === 'starlogo_each'));
	await press(page, 'Run');
	await done(page);
	assert.equal(await page.locator('.confetti').count(), 1);
	await press(page, 'Stop');
	await press(page, 'Next');
	await lesson(page, 2);
	// to choose is all that is asked for
	await page.getByLabel('Collision system', { exact: true }).selectOption('exact');
	await done(page);
	await press(page, 'Next');
	await lesson(page, 3);
	await page.getByLabel('Collision system', { exact: true }).selectOption('exact');
	await done(page);
	// three ticks, and the fourth is the next one
	await press(page, 'Lessons and games');
	await page.waitForSelector('.gallery .next');
	assert.equal(await page.locator('.gallery .tick').count(), 3);
	assert.match(await page.locator('.gallery .next').textContent(), /Precise where it matters/);
	assert.deepEqual(said, []);
	await leave();
});

test('the first three lessons are done with the keyboard, from the first screen on; no category is skipped', async () => {
	const { page, said, leave } = await open(site, 'play', Desktop);
	assert.equal(await focused(page), 'Lessons and games');
	await tabTo(page, '1Blocks');
	await page.keyboard.press('Enter');
	await lesson(page, 1);
	await page.waitForFunction(() => document.activeElement.textContent === 'Blocks make turtles move', null);
	// the drawer: each category, in order
	for (let i = 0; i < 30 && !(await page.evaluate(() => document.activeElement.closest('.blocklyToolbox'))); i++) {
		await page.keyboard.press('Tab');
		await rest(page);
	}
	const category = () => page.evaluate(() => globalThis.playground.editor.workspace.getToolbox().getSelectedItem()?.getName());
	const seen = [await category()];
	for (let i = 0; i < 3; i++) {
		await page.keyboard.press('ArrowDown');
		seen.push(await category());
	}
	assert.deepEqual(seen, ['Events', 'Collisions', 'Movement', 'Senses']);
	await page.keyboard.press('ArrowUp');
	assert.equal(await category(), 'Movement');
	// its first block, put where the script ends
	await page.keyboard.press('ArrowRight');
	await page.keyboard.press('Enter');
	await page.waitForFunction(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_forward').length === 1);
	const isInside = () => page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_forward')[0].getRootBlock().type === 'starlogo_each');
	for (let i = 0; i < 12 && !(await isInside()); i++) {
		await page.keyboard.press('ArrowDown');
		await page.keyboard.press('Enter');
		await rest(page);
		if (!(await isInside())) await page.keyboard.press('m');
	}
	assert.ok(await isInside());
	await tabTo(page, 'Run');
	await page.keyboard.press('Enter');
	await done(page);
	await tabTo(page, 'Next', 'Shift+Tab');
	await page.keyboard.press('Enter');
	for (const number of [2, 3]) {
		await lesson(page, number);
		await tabTo(page, 'Collision system');
		await page.keyboard.press('End');
		await done(page);
		if (number === 2) {
			await tabTo(page, 'Next', 'Shift+Tab');
			await page.keyboard.press('Enter');
		}
	}
	assert.deepEqual(said, []);
	await leave();
});

const fingers = isChromium ? false : 'fingers that move are Chromium\'s';

/** Has a page tell where its buttons and the picture are: now, and every different answer in the frames in which a game runs, until its lesson is done. */
const watchPlaces = (page) => page.evaluate(() => {
	globalThis.places = () => [...document.querySelectorAll('.controls button, .screen')].map((each) => each.getBoundingClientRect()).map(({ x, y, width }) => [x, y, width].map(Math.round).join()).join(' ');
	globalThis.placesWhileItRuns = () => new Promise((resolve) => {
		const all = new Set();
		const look = () => {
			// it shows why, and makes room for that
			if (/^Done!/.test(document.querySelector('.why').textContent)) return resolve([...all]);
			if (document.querySelector('.run.running')) all.add(globalThis.places());
			return requestAnimationFrame(look);
		};
		look();
	});
});

/** What a function tells of a page, once it has told the same twice: by then nothing moves any more. */
async function atRest(page, tell) {
	for (let before = null; ;) {
		const now = await tell();
		if (JSON.stringify(now) === before) return now;
		before = JSON.stringify(now);
		await rest(page, 100);
	}
}

/**
 * Drags a block from the drawer to the end of a script with a finger. A busy page sees moves late: the finger stays until the block is out of the
 * drawer, then until its place in the script is shown.
 */
async function dragWithFinger(page, type, script) {
	const touch = await finger(page);
	const from = await atRest(page, () => heldAt(page, type));
	const end = Date.now() + PATIENCE;
	await touch('touchStart', from);
	for (let i = 1; (await types(page, type)) === 0; i++) {
		assert.ok(Date.now() < end, 'the block does not come out of the drawer');
		await touch('touchMove', { x: from.x, y: from.y + Math.min(90, 15 * i) + (i % 2) });
	}
	for (let i = 0; (await page.locator('.blocklyInsertionMarker').count()) === 0; i++) {
		assert.ok(Date.now() < end, 'no place is shown at the end of the script');
		const { x, y } = await endOf(page, script);
		await touch('touchMove', { x: x + (i % 2), y });
	}
	await touch('touchEnd');
	await page.waitForFunction((wanted) => globalThis.playground.editor.workspace.getBlocksByType(wanted[0])[0].getRootBlock().type === wanted[1], [type, script]);
}

test('the first three lessons are done with fingers, from the first screen on; nothing jumps when the game runs', { skip: fingers }, async () => {
	const { page, said, leave } = await open(site, 'play', Phone);
	await tap(page.locator('.gallery .next'));
	await lesson(page, 1);
	await tap(page.getByRole('button', { name: 'Blocks', exact: true }));
	const begin = await page.evaluate(() => {
		const { top } = globalThis.playground.editor.workspace.getBlocksByType('starlogo_each')[0].getSvgRoot().getBoundingClientRect();
		return top / innerHeight;
	});
	assert.ok(begin < 0.57, `blocks begin at ${begin} of the height`);
	await tap(page.locator('.blocklyToolboxCategory', { hasText: 'Movement' }));
	await dragWithFinger(page, 'starlogo_forward', 'starlogo_each');
	await titled(page, 'Blocks make turtles move (mine)');
	await tap(page.getByRole('button', { name: 'World', exact: true }));
	await watchPlaces(page);
	const before = await atRest(page, () => page.evaluate(() => globalThis.places()));
	const running = page.evaluate(() => globalThis.placesWhileItRuns());
	await tap(page.getByRole('button', { name: 'Run', exact: true }));
	assert.deepEqual(await running, [before], 'nothing jumps');
	await done(page);
	for (const number of [2, 3]) {
		await tap(page.getByRole('button', { name: 'Next', exact: true }));
		await lesson(page, number);
		await page.getByLabel('Collision system', { exact: true }).selectOption('exact');
		await done(page);
	}
	assert.deepEqual(said, []);
	await leave();
});

test('a game of one\'s own is made, named, kept, shared and opened elsewhere, with its collision system', async () => {
	const { page, said, leave } = await open(site, 'play', Desktop);
	await page.locator('.gallery').locator('.new').click();
	await titled(page, 'My program');
	assert.equal(await page.textContent('.keeping'), '✓ saved');
	assert.deepEqual((await agents(page)).map(({ breed }) => breed), ['bears']);
	await page.locator('.title').fill('Bears: “one”');
	await page.keyboard.press('Enter');
	assert.deepEqual(await own(page), ['Bears: “one”']);
	// what stands still shows what is changed
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].getInputTargetBlock('COUNT').setFieldValue(3, 'NUM'));
	await page.waitForFunction(() => globalThis.playground.world.agents.length === 3);
	await page.getByLabel('Collision system', { exact: true }).selectOption('exact');
	const [file] = isChromium ? await Promise.all([page.waitForEvent('download'), press(page, 'Download')]) : [null];
	if (file) assert.equal(file.suggestedFilename(), 'Bears “one”.json');
	await page.reload();
	await ready(page, 'play');
	await titled(page, 'Bears: “one”');
	assert.equal(await page.getByLabel('Collision system', { exact: true }).inputValue(), 'exact');
	// where the clipboard takes nothing, the link is shown
	await refuseCopies(page);
	await press(page, 'Copy a link');
	const link = await page.locator('.address').inputValue();
	// the system goes with its program, and not with the next one
	await page.evaluate(() => {
		location.hash = 'play/paintball';
	});
	await titled(page, 'Paintball');
	assert.equal(await page.getByLabel('Collision system', { exact: true }).inputValue(), 'tightest fits');
	await press(page, 'Back to “Bears: “one””');
	assert.equal(await page.getByLabel('Collision system', { exact: true }).inputValue(), 'exact');
	assert.deepEqual(said, []);
	await leave();
	const other = await open(site, link.split('#')[1], Desktop);
	assert.equal(await other.page.locator('.title').inputValue(), 'Bears: “one”');
	assert.equal(await other.page.getByLabel('Collision system', { exact: true }).inputValue(), 'exact');
	assert.equal((await agents(other.page)).length, 3);
	assert.deepEqual(await own(other.page), []);
	await press(other.page, 'Save a copy');
	await other.page.reload();
	await ready(other.page, 'play');
	assert.equal(await other.page.locator('.title').inputValue(), 'Bears: “one”');
	assert.deepEqual(await own(other.page), ['Bears: “one”']);
	assert.deepEqual(other.said, []);
	await other.leave();
});

test('blocks: what is deleted is counted, what a menu offers has pictures, breeds bring their shapes and are named on the page', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	const all = await page.evaluate(() => globalThis.playground.editor.workspace.getAllBlocks().filter((block) => !block.isShadow()).length);
	assert.ok(all > 50);
	await page.evaluate(() => {
		const { workspace } = globalThis.playground.editor;
		const [block] = workspace.getTopBlocks(true);
		globalThis.count = block.getDescendants().length;
		block.checkAndDelete();
	});
	await told(page, /^\d+ blocks are deleted\./);
	assert.equal(Number.parseInt(await page.textContent('.controls .status'), 10), await page.evaluate(() => globalThis.count));
	for (const [place, name] of [['.status', 'Undo'], ['.edit', 'Redo'], ['.edit', 'Undo']]) {
		await page.locator(place).getByRole('button', { name }).click();
		await page.waitForFunction(([count, isBack]) => (globalThis.playground.editor.workspace.getAllBlocks().filter((block) => !block.isShadow()).length === count) === isBack, [all, name === 'Undo']);
	}
	assert.equal(await page.locator('.title').inputValue(), 'Paintball (mine)', 'no program comes or goes by Undo');
	// a new block says what it makes
	await page.locator('.blocklyToolboxCategory', { hasText: 'Agents' }).click();
	await heldAt(page, 'starlogo_create');
	const fields = await page.evaluate(() => {
		const [block] = globalThis.playground.editor.workspace.getFlyout().getWorkspace().getBlocksByType('starlogo_create');
		return ['BREED', 'SHAPE'].map((name) => block.getFieldValue(name));
	});
	assert.deepEqual(fields, ['bears', 'bear']);
	await page.keyboard.press('Escape');
	// a key that comes late would close the menu too
	await page.waitForFunction(() => !globalThis.playground.editor.workspace.getFlyout().isVisible());
	await rest(page, 100);
	// another breed brings its shape; a shape that was chosen stays
	const chosen = await page.evaluate(() => {
		const block = globalThis.playground.editor.workspace.getBlocksByType('starlogo_create').find((each) => each.getFieldValue('BREED') === 'bears');
		globalThis.made = block;
		block.setFieldValue('turtles', 'BREED');
		const first = block.getFieldValue('SHAPE');
		block.setFieldValue('cube', 'SHAPE');
		block.setFieldValue('seagulls', 'BREED');
		return [first, block.getFieldValue('SHAPE')];
	});
	assert.deepEqual(chosen, ['turtle', 'cube']);
	// all shapes are in sight, each with a picture
	await page.evaluate(() => globalThis.made.getField('SHAPE').showEditor());
	await page.waitForSelector('.blocklyMenuItem .shape img[src]');
	const { items, pictures, isCut } = await page.evaluate(() => {
		const content = document.querySelector('.blocklyDropDownContent');
		return { items: content.querySelectorAll('.blocklyMenuItem').length, pictures: content.querySelectorAll('.shape img[src]').length, isCut: content.scrollHeight > content.clientHeight + 1 };
	});
	assert.deepEqual({ items, pictures, isCut }, { items: 20, pictures: 20, isCut: false });
	await page.keyboard.press('Escape');
	// a breed's name, by a dialog of the page's own that says how long it may be
	await page.evaluate(() => globalThis.made.setFieldValue('new breed', 'BREED'));
	await page.locator('.ask input').fill('x'.repeat(40));
	assert.equal(await page.textContent('.ask small'), '30 of 30 letters');
	await page.locator('.ask input').fill('wolves');
	await press(page, 'OK');
	await page.waitForFunction(() => globalThis.made.getFieldValue('BREED') === 'wolves');
	assert.deepEqual(said, []);
	await leave();
});

test('the menu of systems changes the block that decides', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-main', Desktop);
	assert.equal(await page.getByLabel('Collision system', { exact: true }).inputValue(), 'combination');
	await page.getByLabel('Collision system', { exact: true }).selectOption('exact');
	assert.match(await page.textContent('.controls .status'), /^The block “use collision system” says “exact” now/);
	await press(page, 'Reset');
	assert.equal(await page.getByLabel('Collision system', { exact: true }).inputValue(), 'exact');
	assert.deepEqual(await page.evaluate(() => [globalThis.playground.world.collisions.systemName, globalThis.playground.editor.system]), ['exact', 'exact']);
	assert.deepEqual(said, []);
	await leave();
});

test('the line between blocks and world moves, and stays; the lesson folds; a tone tells of touches and can be muted', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-helmet', Desktop);
	const width = () => page.evaluate(() => Math.round(document.querySelector('.blocks').getBoundingClientRect().width));
	const first = await width();
	const at = await middle(page, '.splitter');
	await page.mouse.move(at.x, at.y);
	await page.mouse.down();
	await page.mouse.move(at.x + 150, at.y, { steps: 3 });
	await page.mouse.up();
	assert.ok(await width() > first + 100);
	await page.locator('.splitter').focus();
	const wide = await width();
	await page.keyboard.press('ArrowLeft');
	assert.ok(await width() < wide);
	const kept = await width();
	const card = () => page.evaluate(() => document.querySelector('.lesson').getBoundingClientRect().height);
	const tall = await card();
	await press(page, 'Fold');
	assert.ok(await card() < tall / 1.5);
	assert.ok(await page.locator('.challenge').isVisible());
	await page.reload();
	await ready(page, 'play');
	assert.equal(await width(), kept);
	// sound
	await listen(page);
	await press(page, 'Turn the sound off');
	await page.getByLabel('Collision system', { exact: true }).selectOption('exact');
	await done(page);
	assert.equal(await page.evaluate(() => globalThis.tones.length), 0);
	await press(page, 'Turn the sound on');
	await press(page, 'Reset');
	await press(page, 'Run');
	await page.waitForFunction(() => globalThis.tones.length >= 5, null);
	// a game that is set back has what it had
	await page.evaluate(() => globalThis.playground.programs.choose('helmet'));
	await titled(page, 'The fireman\'s helmet');
	await page.getByLabel('Collision system', { exact: true }).selectOption('exact');
	await press(page, 'Step');
	await press(page, 'Step');
	await page.getByLabel('Rewind').fill('-1');
	await page.locator('summary', { hasText: 'Numbers' }).click();
	const figure = (name) => page.evaluate((text) => Number([...document.querySelectorAll('.figures div')].find((each) => each.textContent.endsWith(text)).querySelector('dd').textContent), name);
	assert.deepEqual([await figure('touching'), await figure('meetings so far')], [1, 1]);
	assert.ok(await page.evaluate(() => document.querySelector('.time').getBoundingClientRect().height < 60), 'the line of time does not wrap');
	assert.deepEqual(said, []);
	await leave();
});
