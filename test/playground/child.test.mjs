/** Play as a child meets it on a small laptop: room for blocks, blocks that snap, lessons that answer, agents to drag, sounds and times. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { isChromium } from '../../build/headless/browsers.mjs';
import { SIZES, begin, finger, focused, listen, open, openProgram, press, ready, rest, titled } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

const SMALL = { viewport: { width: 1366, height: 625 } };
const LESSONS = ['blocks', 'helmet', 'wing', 'main', 'fast', 'starts', 'room', 'near', 'see', 'hunt', 'jump'];
/** Opens one of the page's or of the user's programs. */
async function choose(page, name) {
	await page.evaluate((wanted) => globalThis.playground.programs.choose(wanted), name);
	await rest(page, 100);
}
const boxOf = (page, selector) => page.evaluate((each) => {
	const { top, left, right, bottom, width, height } = document.querySelector(each).getBoundingClientRect();
	return { top, left, right, bottom, width, height };
}, selector);
const number = (value) => ({ shadow: { type: 'math_number', fields: { NUM: value } } });
const inside = (block) => ({ DO: { block } });
const program = (...scripts) => ({ blocks: { languageVersion: 0, blocks: scripts } });
const create = (breed, shape, inner) => ({ type: 'starlogo_create', fields: { BREED: breed, SHAPE: shape }, inputs: { COUNT: number(1), ...(inner && inside(inner)) } });
const go = (x, y, z) => ({ type: 'starlogo_go', inputs: { X: number(x), Y: number(y), Z: number(z) } });

/** A program that never comes to an end. */
const ENDLESS = program({ type: 'starlogo_start', inputs: inside({ type: 'controls_whileUntil', fields: { MODE: 'WHILE' }, inputs: { BOOL: { block: { type: 'logic_boolean', fields: { BOOL: 'TRUE' } } } } }) });

/** Opens a category of the drawer with the mouse. */
async function openDrawer(page, name) {
	const box = await page.locator('.blocklyToolboxCategory', { hasText: name }).boundingBox();
	await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
	await page.waitForFunction(() => globalThis.playground.editor.workspace.getFlyout().isVisible());
	await rest(page, 100);
}

/** The edges of what is called so in the editor: each script, and the drawer. */
const scripts = (page) => page.evaluate(() => {
	const { workspace } = globalThis.playground.editor;
	const pane = document.querySelector('.blocks').getBoundingClientRect();
	const drawer = workspace.getFlyout().isVisible() ? pane.left + workspace.getToolbox().getWidth() + workspace.getFlyout().getWidth() : 0;
	return { pane: { left: pane.left, right: pane.right }, drawer, tops: workspace.getTopBlocks(true).map((block) => {
		const { left, top, bottom, right } = block.getSvgRoot().getBoundingClientRect();
		const { x, y } = block.getRelativeToSurfaceXY();
		return { type: block.type, left, top, bottom, right, x, y };
	}) };
});

const NARROW = [1024, 700, 500];
for (const [code, hint, sizes] of [['en', 'A hint', [NARROW]], ['de', 'Ein Tipp', [[1366, 625, 480], [1366, 768, 620], NARROW]]]) {
	test(`on a small laptop four fifths of the height are for blocks, and nothing lies over anything else (${code})`, async () => {
		const { page, said, leave } = await open(site, 'play/lesson-blocks', { ...SMALL, locale: code });
		for (const [width, height, least] of sizes) {
			await page.setViewportSize({ width, height });
			for (const name of LESSONS) {
				await choose(page, `lesson-${name}`);
				if (width > NARROW[0]) assert.ok(await page.locator('.title').evaluate((each) => each.scrollWidth <= each.clientWidth), `${name} at ${width} x ${height}: its name is whole`);
				const before = await boxOf(page, '.screens');
				await press(page, hint);
				const [blocks, bin, screen, time, foot] = [await boxOf(page, '.blocks'), await boxOf(page, '.tool-bin'), await boxOf(page, '.screens'), await boxOf(page, '.time'), await boxOf(page, '.foot')];
				const where = `${name} at ${width} x ${height}`;
				const letters = await page.evaluate(() => ['.lesson h2', '.lesson .challenge', '.lesson .hint'].map((each) => Number.parseFloat(getComputedStyle(document.querySelector(each)).fontSize)));
				assert.ok(letters[0] > letters[1] && letters[2] >= 14, `${where}: letters of ${letters} pixels`);
				assert.ok(blocks.height >= least && blocks.bottom <= height, `${where}: ${blocks.height} pixels for blocks`);
				assert.ok(bin.bottom < blocks.bottom && bin.right < blocks.right, `${where}: the trash can is in the window`);
				assert.ok(screen.height > 140 && Math.max(time.bottom, foot.bottom) <= height, `${where}: the world is ${screen.height} high`);
				assert.deepEqual(screen, before, `${where}: the hint moves nothing`);
				const categories = await page.evaluate(() => [...document.querySelectorAll('.blocklyToolboxCategory')].map((each) => each.getBoundingClientRect()).map(({ right, bottom }) => ({ right, bottom })));
				assert.equal(categories.length, 10);
				assert.ok(categories.every(({ right, bottom }) => bottom <= blocks.bottom && right <= bin.left), `${where}: categories in the window, and not below the trash can`);
			}
			assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth && document.documentElement.scrollHeight <= innerHeight), 'nothing to scroll');
			await page.locator('.settings').click();
			assert.ok((await boxOf(page, '.time input')).width > 40, 'Speed is a slider, and not a dot');
			await page.locator('.settings').click();
			// in one row
			const tops = await page.evaluate(() => [...document.querySelectorAll('.naming > :is(button, input), .edit > button')].map((each) => Math.round(each.getBoundingClientRect().top)));
			assert.ok(tops.length >= 5 && Math.max(...tops) - Math.min(...tops) < 3, `${tops}`);
		}
		assert.deepEqual(said, []);
		await leave();
	});
}

test('on a phone every category of blocks is whole, in German too', async () => {
	for (const locale of ['en', 'de']) {
		const { page, said, leave } = await open(site, 'play/hills', { ...SIZES.phone, locale });
		await page.locator('[data-tab="program"]').click();
		const [right, ...ends] = await page.evaluate(() => [...document.querySelectorAll('.blocks, .blocklyToolboxCategoryLabel')].map((each) => each.getBoundingClientRect().right));
		assert.equal(ends.length, 10);
		assert.ok(Math.max(...ends) < right, `${locale}: up to ${Math.max(...ends)} of ${right}`);
		assert.deepEqual(said, []);
		await leave();
	}
});

/** The part of the window below the header that the world takes, as far as it is in sight. */
const shareOfWorld = (page) => page.evaluate(() => {
	const [{ width, top, bottom }, header] = ['.world', 'header'].map((each) => document.querySelector(each).getBoundingClientRect());
	return (width * (Math.min(bottom, innerHeight) - Math.max(top, header.bottom))) / (innerWidth * (innerHeight - header.bottom));
});

for (const [name, size, least] of [['on a small laptop', SMALL, 0.45], ['on a phone', SIZES.phone, 0.45], ['on a phone that is held across', { ...SIZES.phone, viewport: { width: 844, height: 390 } }, 0.6]]) {
	test(`the world has ${100 * least} % of the window below the header at least, ${name}, and its settings are one click away`, { skip: size.hasTouch && !isChromium ? 'phones are Chromium\'s' : false }, async () => {
		const { page, said, leave } = await open(site, 'play/paintball', size);
		const share = await shareOfWorld(page);
		assert.ok(share >= least, `${share}`);
		const settings = page.locator('.settings');
		const isOpen = await settings.getAttribute('aria-expanded') === 'true';
		assert.equal(isOpen, size.viewport.height >= 700);
		if (!isOpen) await settings.click();
		await page.getByLabel('Camera').selectOption('all');
		for (const label of ['Collision system', 'And beside it', 'What the engine sees', 'Speed', 'Rewind']) assert.ok(await page.getByLabel(label, { exact: true }).isVisible(), label);
		await page.reload();
		await ready(page, 'play');
		assert.equal(await settings.getAttribute('aria-expanded'), 'true', 'it is remembered');
		await settings.click();
		for (const label of ['Collision system', 'Speed']) assert.equal(await page.getByLabel(label, { exact: true }).isVisible(), false, label);
		// a lesson may be about them
		await choose(page, 'lesson-helmet');
		assert.ok(await page.getByLabel('Collision system').isVisible());
		assert.deepEqual(said, []);
		await leave();
	});
}

test('in lessons on a small laptop, the world has 45 % of the window below the header, the task is in sight, and an open drawer leaves room for a second script', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-blocks', SMALL);
	for (const name of LESSONS) {
		await choose(page, `lesson-${name}`);
		const share = await shareOfWorld(page);
		assert.ok(share >= 0.45, `${name}: ${share}`);
		assert.equal(await page.getByLabel('Collision system', { exact: true }).isVisible(), ['helmet', 'wing'].includes(name), name);
	}
	await choose(page, 'lesson-room');
	await openDrawer(page, 'Events');
	const { pane, drawer, tops } = await scripts(page);
	assert.ok(pane.right - drawer > 280, `${pane.right - drawer} pixels beside the drawer`);
	assert.ok(tops.every(({ left, right }) => left >= drawer && right <= pane.right), JSON.stringify(tops));
	assert.ok((await boxOf(page, '.lesson h2')).height < 30, 'the name of the lesson is in one line');
	// nothing of the task and of the buttons is covered
	const covered = await page.evaluate(() => [...document.querySelectorAll('.lesson :is(h2, .text, .challenge, button:not(.away)), .controls > button, .corner > *')].filter((each) => {
		const { left, right, top, bottom } = each.getBoundingClientRect();
		return [left + 2, right - 2].some((x) => !each.contains(document.elementFromPoint(x, (top + bottom) / 2)) && !document.elementFromPoint(x, (top + bottom) / 2).contains(each));
	}).map(({ textContent }) => textContent));
	assert.deepEqual(covered, []);
	assert.deepEqual(said, []);
	await leave();
});

test('in lessons on a phone that is held across, 30 % of the window below the header are the world’s', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-blocks', { ...SIZES.phone, viewport: { width: 844, height: 390 } });
	for (const name of LESSONS) {
		await choose(page, `lesson-${name}`);
		const share = await shareOfWorld(page);
		assert.ok(share > 0.3, `${name}: ${share}`);
	}
	assert.deepEqual(said, []);
	await leave();
});

test('on a phone, the menu of a block is gone when the world is shown', async () => {
	const { page, leave } = await open(site, 'play/paintball', SIZES.phone);
	await page.locator('[data-tab="program"]').filter({ hasText: 'Blocks' }).click();
	await page.evaluate(() => {
		const block = globalThis.playground.editor.workspace.getTopBlocks(true)[0];
		block.showContextMenu(new PointerEvent('contextmenu', { clientX: 150, clientY: 400 }));
	});
	const menu = page.locator('.blocklyContextMenu');
	await menu.waitFor();
	await page.locator('button[data-tab="game"]').click();
	await menu.waitFor({ state: 'detached' });
	await leave();
});

test('on a phone, scripts give way to the drawer above them, and come back', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-room', SIZES.phone);
	await page.locator('[data-tab="program"]').click();
	await rest(page, 200);
	const tops = async () => (await scripts(page)).tops.map(({ top }) => Math.round(top));
	const before_ = await tops();
	await openDrawer(page, 'Collisions');
	const end = await page.evaluate(() => document.querySelector('.blocklyToolboxFlyout .blocklyFlyoutBackground').getBoundingClientRect().bottom);
	assert.ok((await tops()).every((top) => top >= end - 1), `the drawer ends at ${end}, scripts begin at ${await tops()}`);
	await page.evaluate(() => globalThis.playground.editor.closeMenus());
	await rest(page, 200);
	assert.deepEqual(await tops(), before_);
	assert.deepEqual(said, []);
	await leave();
});

test('a block from the drawer pushes no script away, and joins one even if it is dropped 12 pixels too high', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-blocks', SMALL);
	let taken = 0;
	// two of each category; with -Dfull more
	const most = process.env.FULL_TESTS === 'true' ? 5 : 2;
	for (const category of ['Movement', 'Looks', 'Collisions']) {
		for (let i = 0; i < most; i++) {
			await page.evaluate(() => globalThis.playground.programs.choose('lesson-blocks', false, true));
			await rest(page, 50);
			const before = await scripts(page);
			await openDrawer(page, category);
			const open_ = await scripts(page);
			assert.ok(open_.tops.every(({ left }) => left >= open_.drawer), `${category}: the drawer ends at ${open_.drawer}, scripts begin at ${open_.tops.map(({ left }) => left)}`);
			assert.ok(open_.pane.right - open_.drawer > 200, `${open_.pane.right - open_.drawer} pixels for scripts`);
			const from = await page.evaluate((wanted) => {
				const blocks = globalThis.playground.editor.workspace.getFlyout().getWorkspace().getTopBlocks(true).filter(({ previousConnection }) => previousConnection);
				const block = blocks[wanted];
				const box = block?.getSvgRoot().querySelector(':scope > .blocklyPath').getBoundingClientRect();
				return box && box.top + 20 < innerHeight - 20 ? { x: box.left, y: box.top, type: block.type } : null;
			}, i);
			if (from === null) continue;
			await page.mouse.move(from.x + 8, from.y + 10);
			await page.mouse.down();
			await page.mouse.move(from.x + 20, from.y + 14, { steps: 4 });
			await rest(page, 300);
			const to = await page.evaluate(() => {
				const { left, bottom } = globalThis.playground.editor.workspace.getBlocksByType('starlogo_each')[0].getInputTargetBlock('DO').getSvgRoot().querySelector(':scope > .blocklyPath').getBoundingClientRect();
				return { x: left, y: bottom - 7 };
			});
			await page.mouse.move(to.x + 8, to.y + 10 - 12, { steps: 6 });
			await page.mouse.up();
			await rest(page, 300);
			const after_ = await scripts(page);
			for (const { type, x, y } of before.tops) {
				const same = after_.tops.find((each) => each.type === type);
				assert.deepEqual([same.x, type === 'starlogo_start' ? y : same.y], [x, y], `${from.type}: ${type} stays`);
			}
			const chain = await page.evaluate(() => {
				const all = [];
				for (let block = globalThis.playground.editor.workspace.getBlocksByType('starlogo_each')[0].getInputTargetBlock('DO'); block; block = block.getNextBlock()) all.push(block.type);
				return all;
			});
			assert.deepEqual(chain, ['starlogo_turn', from.type]);
			// the drawer is closed: the scripts are where they were
			assert.deepEqual(after_.tops[0].left, before.tops[0].left);
			taken++;
		}
	}
	assert.ok(taken >= 2 * most, `${taken} blocks`);
	assert.deepEqual(said, []);
	await leave();
});

test('a second script has its own place, wherever it is dropped, and however the first one grows', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-blocks', SMALL);
	const overlaps = async () => {
		const { tops } = await scripts(page);
		return tops.flatMap((a, i) => tops.slice(i + 1).filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom).map((b) => `${a.type} ${b.type}`));
	};
	await openDrawer(page, 'Events');
	const from = await page.evaluate(() => {
		const { left, top } = globalThis.playground.editor.workspace.getFlyout().getWorkspace().getTopBlocks(true)[1].getSvgRoot().getBoundingClientRect();
		return { x: left + 12, y: top + 40 };
	});
	await page.mouse.move(from.x, from.y);
	await page.mouse.down();
	await page.mouse.move(from.x + 20, from.y, { steps: 4 });
	const { tops: [{ left, top }] } = await scripts(page);
	await page.mouse.move(left + 60, top + 60, { steps: 6 });
	await page.mouse.up();
	await page.waitForFunction(() => globalThis.playground.editor.workspace.getTopBlocks().length === 3);
	await rest(page, 300);
	assert.deepEqual(await overlaps(), []);
	// the first one becomes longer
	await page.evaluate(() => {
		const { workspace } = globalThis.playground.editor;
		const turn = workspace.getBlocksByType('starlogo_turn')[0];
		for (let i = 0; i < 5; i++) {
			const block = workspace.newBlock('starlogo_scatter');
			block.initSvg();
			block.render();
			turn.nextConnection.connect(block.previousConnection);
		}
	});
	await rest(page, 400);
	assert.deepEqual(await overlaps(), []);
	assert.deepEqual(said, []);
	await leave();
});

test('a script that is dropped on a long column stays in sight, near the place where it was dropped', async () => {
	const { page, said, leave } = await open(site, 'play/jump', SMALL);
	for (const [dx, dy] of [[40, 60], [200, 60], [40, 250]]) {
		await page.evaluate(() => globalThis.playground.programs.choose('jump', false, true));
		await rest(page, 100);
		const before = await page.evaluate(() => globalThis.playground.editor.workspace.scrollY);
		await openDrawer(page, 'Events');
		const from = await page.evaluate(() => {
			const { left, top } = globalThis.playground.editor.workspace.getFlyout().getWorkspace().getTopBlocks(true)[1].getSvgRoot().getBoundingClientRect();
			return { x: left + 12, y: top + 40 };
		});
		const { tops: [{ left, top }] } = await scripts(page);
		await page.mouse.move(from.x, from.y);
		await page.mouse.down();
		await page.mouse.move(from.x + 20, from.y, { steps: 4 });
		await page.mouse.move(left + dx, top + dy, { steps: 6 });
		await page.mouse.up();
		await rest(page, 500);
		const after_ = await page.evaluate(() => {
			const { workspace } = globalThis.playground.editor;
			const pane = document.querySelector('.blocks').getBoundingClientRect();
			const all = workspace.getTopBlocks(false).map((block) => [block, block.getBoundingRectangle()]);
			const box = workspace.getTopBlocks(false).at(-1).getSvgRoot().getBoundingClientRect();
			return {
				scrollY: workspace.scrollY, isSeen: box.top >= pane.top && box.top < pane.bottom - 40 && box.left < pane.right - 60,
				overlaps: all.flatMap(([a, one], i) => all.slice(i + 1).filter(([, other]) => one.intersects(other)).map(([b]) => `${a.type} ${b.type}`)),
			};
		});
		assert.ok(Math.abs(after_.scrollY - before) < 450, `dropped at ${dx}, ${dy}: scrolled by ${after_.scrollY - before}`);
		assert.ok(after_.isSeen, `dropped at ${dx}, ${dy}: it is in sight`);
		assert.deepEqual(after_.overlaps, []);
	}
	assert.deepEqual(said, []);
	await leave();
});

/** Takes a block out of an open drawer, to a place: with one fast step at the end. */
async function takeFast(page, type, to, last) {
	const from = await page.evaluate((wanted) => {
		const block = globalThis.playground.editor.workspace.getFlyout().getWorkspace().getTopBlocks(true).find((each) => each.type === wanted);
		const { left, top, height } = block.getSvgRoot().querySelector(':scope > .blocklyPath').getBoundingClientRect();
		return { x: left, y: top, middle: top + height / 2 };
	}, type);
	const dy = to.isValue ? from.middle - from.y : 10;
	await page.mouse.move(from.x + 9, from.y + dy);
	await page.mouse.down();
	await page.mouse.move(from.x + 120, from.y + 60);
	await page.mouse.move(to.x + 9 + last, to.y + dy + last, { steps: 2 });
	await page.mouse.move(to.x + 9, to.y + dy);
	await page.mouse.up();
	await rest(page, 400);
}

test('a block that is dropped fast is not loose, one that is replaced lies beside its script, and keys leave no script aside', async () => {
	const { page, said, leave } = await open(site, 'play/jump', SMALL);
	for (const last of [15, 40]) {
		for (const at of [0, 2]) {
			await page.evaluate(() => globalThis.playground.programs.choose('jump', false, true));
			await rest(page, 50);
			await openDrawer(page, 'Control');
			const to = await page.evaluate((wanted) => {
				const { workspace } = globalThis.playground.editor;
				const chain = (block) => (block ? [block, ...chain(block.getNextBlock())] : []);
				const all = workspace.getTopBlocks(true).slice(0, 2).flatMap((top) => chain(top.getInputTargetBlock('DO')));
				const { left, bottom } = all[wanted].getSvgRoot().querySelector(':scope > .blocklyPath').getBoundingClientRect();
				return { x: left, y: bottom - 7 };
			}, at);
			const count = () => page.evaluate(() => globalThis.playground.editor.workspace.getTopBlocks(false).length);
			const before_ = await count();
			await takeFast(page, 'controls_if', to, last);
			assert.equal(await count(), before_, `${last} pixels, block ${at}`);
		}
	}
	await page.evaluate(() => globalThis.playground.programs.choose('jump', false, true));
	await rest(page, 50);
	await openDrawer(page, 'Senses');
	const to = await page.evaluate(() => {
		const { left, top } = globalThis.playground.editor.workspace.getBlocksByType('starlogo_standing')[0].getSvgRoot().querySelector(':scope > .blocklyPath').getBoundingClientRect();
		return { x: left, y: top, isValue: true };
	});
	await takeFast(page, 'starlogo_touching', to, 15);
	await rest(page, 500);
	const overlaps = await page.evaluate(() => {
		const { workspace } = globalThis.playground.editor;
		const [old] = workspace.getBlocksByType('starlogo_standing');
		const place = old.getBoundingRectangle();
		return old.getParent() ? ['it is not replaced'] : workspace.getTopBlocks(false).filter((each) => each !== old && each.getBoundingRectangle().intersects(place)).map(({ type }) => type);
	});
	assert.deepEqual(overlaps, []);
	await page.locator('.tool-undo').click();
	await page.waitForFunction(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_standing')[0].getParent()?.type === 'controls_if');
	// by keys
	await choose(page, 'lesson-blocks');
	const scrolled = () => page.evaluate(() => Math.round(globalThis.playground.editor.workspace.scrollX));
	const first = await scrolled();
	await page.locator('.title').focus();
	for (let i = 0; i < 20 && !(await page.evaluate(() => globalThis.playground.editor.workspace.getFlyout().isVisible())); i++) {
		await page.keyboard.press('Tab');
		await rest(page, 30);
	}
	await page.keyboard.press('ArrowDown');
	await page.keyboard.press('ArrowRight');
	// scripts give way to the drawer
	await page.waitForFunction((least) => globalThis.playground.editor.workspace.scrollX > least, first + 200);
	await page.keyboard.press('Escape');
	await page.waitForFunction((wanted) => Math.round(globalThis.playground.editor.workspace.scrollX) === wanted, first);
	assert.deepEqual(said, []);
	await leave();
});

test('a program that is changed while it runs has a button that says so', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-blocks', SMALL);
	const look = () => page.evaluate(() => {
		const button = document.querySelector('.run');
		return [button.textContent, getComputedStyle(button).backgroundColor, Math.round(button.getBoundingClientRect().width)];
	});
	await press(page, 'Run');
	const before = await look();
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].getInputTargetBlock('COUNT').setFieldValue(7, 'NUM'));
	await page.waitForFunction(() => document.querySelector('.run').textContent === 'Start anew');
	assert.match(await page.textContent('.controls .status'), /^You have changed the program/);
	const changed = await look();
	assert.notEqual(changed[1], before[1], 'in another colour');
	assert.equal(changed[2], before[2], 'of the same width');
	assert.notEqual(await page.evaluate(() => globalThis.playground.world.agents.length), 7, 'it counts when the game begins anew');
	await press(page, 'Start anew');
	await page.waitForFunction(() => globalThis.playground.world.agents.length === 7);
	// some browsers fade from colour to colour
	await page.waitForFunction(([text, colour]) => {
		const run = document.querySelector('.run');
		return run.textContent === text && getComputedStyle(run).backgroundColor === colour;
	}, before);
	assert.deepEqual(await look(), before);
	// while it stands still a change counts at once
	await press(page, 'Stop');
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].getInputTargetBlock('COUNT').setFieldValue(3, 'NUM'));
	await page.waitForFunction(() => globalThis.playground.world.agents.length === 3);
	assert.equal((await look())[0], 'Run');
	assert.deepEqual(said, []);
	await leave();
});

test('lessons: to choose the system is enough, a wrong one is told why, and one\'s own version comes back', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-wing', SMALL);
	const shown = () => page.evaluate(() => {
		const { shows } = document.querySelector('.lesson').dataset;
		return document.querySelector(`.lesson .${shows}`).textContent;
	});
	const places = () => page.evaluate(() => [...document.querySelectorAll('.controls button, .screens, .lesson .challenge, .lesson .steps')].map((each) => each.getBoundingClientRect()).map(({ x, y, width, height }) => [x, y, width, height].map(Math.round).join()).join(' '));
	await press(page, 'Run');
	const first = await places();
	await page.waitForFunction(() => /^Not yet:/.test(document.querySelector('.why').textContent));
	assert.match(await shown(), /^Not yet: The dragon turns red/);
	assert.equal(await places(), first, 'what is said moves nothing');
	await press(page, 'Reset');
	assert.match(await shown(), /^The ball rolls under the wing/);
	await page.getByLabel('Collision system').selectOption('hierarchies');
	await page.waitForFunction(() => /^Done!/.test(document.querySelector('.why').textContent));
	const settled = (await places()).split(' ').slice(0, 3).join(' ');
	assert.equal(settled, first.split(' ').slice(0, 3).join(' '), 'nor does success');
	await press(page, 'Stop');
	// one's own version: by the card, and by Back; and beside it the lesson's
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_forward')[0].getInputTargetBlock('STEPS').setFieldValue(0.09, 'NUM'));
	await titled(page, 'A wing is not a box (mine)');
	assert.equal((await places()).split(' ').slice(0, 3).join(' '), settled, 'nor does the first change');
	const speed = () => page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_forward')[0].getInputTargetBlock('STEPS').getFieldValue('NUM'));
	assert.ok(await page.getByRole('button', { name: 'Begin again', exact: true }).isVisible());
	await press(page, 'Next');
	await page.waitForFunction(() => /^Lesson 4/.test(document.querySelector('.lesson').textContent));
	assert.ok(!(await page.getByRole('button', { name: 'Begin again', exact: true }).isVisible()));
	await press(page, 'Back');
	await titled(page, 'A wing is not a box (mine)');
	assert.equal(await speed(), 0.09);
	await press(page, 'Lessons and games');
	await page.locator('.gallery .open').nth(2).click();
	await page.waitForSelector('.gallery', { state: 'detached' });
	await titled(page, 'A wing is not a box (mine)');
	await press(page, 'Begin again');
	await titled(page, 'A wing is not a box');
	assert.equal(await speed(), 0.06);
	// the program is named once on the first screen
	await press(page, 'Lessons and games');
	await page.waitForSelector('.gallery .own input');
	const names = await page.evaluate(() => {
		const card = [...document.querySelectorAll('.gallery li')].find((each) => each.querySelector('.own input'));
		return [card.innerText.trim(), card.querySelector('input').value, card.querySelector('.open').getAttribute('aria-label')];
	});
	assert.deepEqual(names, ['✕', 'A wing is not a box (mine)', 'A wing is not a box (mine)']);
	assert.deepEqual(said, []);
	await leave();
});

test('the line about dragging is gone after five seconds, and for good after the first drag', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-wing', SMALL);
	const note = page.locator('.drag-note');
	assert.ok(await note.isVisible());
	await rest(page, 5200);
	assert.equal(await note.isVisible(), false, 'after five seconds');
	await choose(page, 'lesson-helmet');
	assert.ok(await note.isVisible(), 'in the next lesson it is there again');
	const { left, top, width } = await boxOf(page, '.world');
	await page.mouse.move(left + width / 2, top + 20);
	await page.mouse.down();
	await page.mouse.move(left + width / 2 + 60, top + 20, { steps: 3 });
	await page.mouse.up();
	await choose(page, 'lesson-wing');
	assert.equal(await note.isVisible(), false, 'after the first drag');
	assert.deepEqual(said, []);
	await leave();
});

test('agents are dragged in the world, and who touches whom is shown at once; elsewhere the picture turns', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-blocks', SMALL);
	await openProgram(page, 'two', program(
		{ type: 'starlogo_start', inputs: inside({ ...create('bears', 'bear', go(-3, 0, 0)), next: { block: create('balls', 'sphere', go(3, 0, 0)) } }) },
		{ type: 'starlogo_touch_start', fields: { BREED: 'balls', OTHER: 'bears' }, inputs: inside({ type: 'starlogo_score_change', inputs: { SCORE: number(1) } }) },
	));
	assert.ok(await page.getByText('Drag the picture to look around').isVisible());
	await press(page, 'Step');
	const at = (breed) => page.evaluate((wanted) => {
		const { world, stage } = globalThis.playground;
		const { x, y, z, size } = world.agents.find(({ breed: each }) => each === wanted);
		const pixel = stage.pixelOf(x, y, z + 0.4 * size);
		const box = stage.canvas.getBoundingClientRect();
		return { x: box.left + pixel.x, y: box.top + pixel.y, place: [x, y, z] };
	}, breed);
	const camera = () => page.evaluate(() => globalThis.playground.stage.camera.position.toArray());
	const eye = await camera();
	const [ball, bear] = [await at('balls'), await at('bears')];
	await page.mouse.move(ball.x, ball.y);
	await page.waitForFunction(() => document.querySelector('.world canvas').classList.contains('grab'));
	await page.mouse.down();
	await page.mouse.move(bear.x, bear.y, { steps: 8 });
	await page.waitForFunction(() => globalThis.playground.world.score === 1);
	await page.mouse.up();
	const moved = await at('balls');
	assert.ok(Math.abs(moved.place[0] + 3) < 0.8 && moved.place[2] === 0, `${moved.place}`);
	assert.deepEqual(await camera(), eye, 'the picture does not turn');
	assert.ok(!(await page.getByText('Drag the picture to look around').isVisible()), 'said until it is known');
	// the frame is kept as it is now
	await press(page, 'Step');
	await page.locator('.settings').click();
	await page.getByLabel('Rewind').fill('-1');
	await page.locator('.settings').click();
	assert.deepEqual((await at('balls')).place, moved.place);
	// beside the agents the picture turns
	const canvas = await boxOf(page, '.world canvas');
	await page.mouse.move(canvas.left + 30, canvas.bottom - 60);
	await page.mouse.down();
	await page.mouse.move(canvas.left + 130, canvas.bottom - 60, { steps: 4 });
	await page.mouse.up();
	assert.notDeepEqual(await camera(), eye);
	assert.deepEqual((await at('balls')).place, moved.place);
	assert.deepEqual(said, []);
	await leave();
});

test('on a phone a finger on an agent moves it, and does not scroll the page; neither a hint, nor success, nor an error moves anything', { skip: isChromium ? false : 'fingers that move are Chromium\'s' }, async () => {
	const { page, said, leave } = await open(site, 'play/lesson-wing', SIZES.phone);
	const ball = () => page.evaluate(() => {
		const { world, stage } = globalThis.playground;
		const { x, y, z, size } = world.agents.find(({ breed }) => breed === 'paintballs');
		const pixel = stage.pixelOf(x, y, z + size / 2);
		const box = stage.canvas.getBoundingClientRect();
		return { x: box.left + pixel.x, y: box.top + pixel.y, place: [x, y] };
	});
	const from = await ball();
	const scrolled = await page.evaluate(() => scrollY);
	const touch = await finger(page);
	await touch('touchStart', { x: from.x, y: from.y });
	for (let i = 1; i <= 6; i++) await touch('touchMove', { x: from.x + 6 * i, y: from.y - 10 * i });
	await touch('touchEnd');
	await page.waitForFunction((before) => globalThis.playground.world.agents.find(({ breed }) => breed === 'paintballs').y > before + 0.5, from.place[1]);
	assert.equal(await page.evaluate(() => scrollY), scrolled);
	assert.ok((await ball()).place[0] > from.place[0]);
	const places = () => page.evaluate(() => [...document.querySelectorAll('.controls > button, .tabs button, .screens, .lesson .challenge, .lesson .steps')].map((each) => each.getBoundingClientRect())
		.map(({ x, y, width, height }) => [x, y + scrollY, width, height].map(Math.round).join()).join(' '));
	await choose(page, 'lesson-jump');
	const first = await places();
	await press(page, 'A hint');
	assert.equal(await places(), first, 'nor the hint');
	await page.evaluate(() => globalThis.playground.programs.lessonCard.look({ agents: [], frame: 1, totals: new Map() }));
	await page.waitForFunction(() => /^Not yet:/.test(document.querySelector('.why').textContent));
	assert.equal(await places(), first, 'nor what is wrong');
	await page.evaluate(() => {
		const { lessonCard: lessons } = globalThis.playground.programs;
		lessons.begin();
		const platforms = [{ breed: 'platforms' }, { breed: 'platforms' }];
		const game = (below, ...coins) => ({ agents: [{ breed: 'bears', z: 2, rise: 0.1 }, ...platforms, ...coins], frame: 1, walking: { standsOn: () => platforms[below] }, totals: new Map([['bears\ncoins', 1]]) });
		lessons.look(game(0, { breed: 'coins', x: 1.5, z: 3.2 }));
		lessons.look(game(1));
	});
	await page.waitForFunction(() => /^Done!.*Make your own/.test(document.querySelector('.why').textContent));
	assert.equal(await places(), first, 'nor success');
	await choose(page, 'chase');
	const second = await places();
	await openProgram(page, 'endless', ENDLESS);
	await page.waitForSelector('.status.problem');
	assert.ok((await boxOf(page, '.status.problem')).height > 60, 'all of it is read');
	assert.equal(await places(), second, 'nor an error');
	assert.deepEqual(said, []);
	await leave();
});

test('a game with a limit of time shows a clock and the best time, blocks make sounds, and the drawer names who is there', async () => {
	const { page, said, leave } = await open(site, 'play/hills', SMALL);
	await page.locator('.settings').click();
	assert.equal(await page.textContent('.clock'), '40 s left');
	const won = (seconds) => program(
		{ type: 'starlogo_start', inputs: inside({ type: 'starlogo_limit', fields: { TEXT: 'Too late.' }, inputs: { SECONDS: number(5) }, next: { block: create('dragons', 'dragon', { type: 'starlogo_sound', fields: { SOUND: 'ding' } }) } }) },
		{ type: 'starlogo_timer', fields: { BREED: 'dragons' }, inputs: { SECONDS: number(seconds), ...inside({ type: 'starlogo_note', inputs: { NOTE: number(69) }, next: { block: { type: 'starlogo_end', fields: { HOW: 'won', TEXT: 'Yes!' } } } }) } },
	);
	await openProgram(page, 'short', won(0.5));
	await listen(page);
	await press(page, 'Run');
	await page.waitForSelector('.end');
	assert.match(await page.textContent('.end'), /You have won!Yes! It took 0\.5 seconds\.Play again/);
	assert.deepEqual(await page.evaluate(() => globalThis.tones.slice(0, 3).map(({ frequency }) => Math.round(frequency.value))), [1319, 1319, 440]);
	// slower: the best time stays
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_timer')[0].getInputTargetBlock('SECONDS').setFieldValue(1, 'NUM'));
	await page.waitForFunction(() => globalThis.playground.world.frame === 0);
	assert.equal(await page.textContent('.clock'), '5 s left · best 0.5 s');
	await press(page, 'Run');
	await page.waitForFunction(() => /It took 1\.0 seconds\.Your best: 0\.5 seconds\./.test(document.querySelector('.end').textContent));
	// and faster
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_timer')[0].getInputTargetBlock('SECONDS').setFieldValue(0.3, 'NUM'));
	await page.waitForFunction(() => globalThis.playground.world.frame === 0);
	await press(page, 'Run');
	await page.waitForFunction(() => /It took 0\.3 seconds\.Your best so far!/.test(document.querySelector('.end').textContent));
	// nobody wins in time
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_timer')[0].getInputTargetBlock('SECONDS').setFieldValue(60, 'NUM'));
	await page.waitForFunction(() => globalThis.playground.world.frame === 0);
	await page.getByLabel('Speed').fill('5');
	await press(page, 'Run');
	await page.waitForFunction(() => /The game is over\.Too late\. It took 5\.0 seconds/.test(document.querySelector('.end').textContent));
	// the drawer
	const named = (type, field) => page.evaluate(([wanted, name]) => globalThis.playground.editor.workspace.getFlyout().getWorkspace().getBlocksByType(wanted)[0].getFieldValue(name), [type, field]);
	await openDrawer(page, 'Agents');
	assert.deepEqual([await named('starlogo_create', 'BREED'), await named('starlogo_create', 'SHAPE')], ['dragons', 'dragon']);
	await page.evaluate(() => globalThis.playground.programs.choose('lesson-near'));
	await titled(page, 'Who is near?');
	await openDrawer(page, 'Senses');
	assert.equal(await named('starlogo_count', 'BREED'), 'turtles');
	await openDrawer(page, 'Events');
	assert.equal(await named('starlogo_each', 'BREED'), 'bears');
	await page.evaluate(() => globalThis.playground.programs.choose('lesson-see'));
	await titled(page, 'What do I see?');
	await openDrawer(page, 'Senses');
	assert.equal(await named('starlogo_nearest', 'BREED'), 'turtles', 'the wall does nothing');
	await openDrawer(page, 'Movement');
	const steps = await page.evaluate(() => globalThis.playground.editor.workspace.getFlyout().getWorkspace().getBlocksByType('starlogo_forward')[0].getInputTargetBlock('STEPS').getFieldValue('NUM'));
	assert.ok(60 * steps <= 6, `${60 * steps} squares a second`);
	assert.deepEqual(said, []);
	await leave();
});

test('the space bar throws after a tick, Speed keeps the keyboard, and an error moves nothing', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SMALL);
	await page.locator('.settings').click();
	const places = () => page.evaluate(() => [...document.querySelectorAll('.controls button, .screens, .blocks')].map((each) => each.getBoundingClientRect()).map(({ x, y, width, height }) => [x, y, width, height].map(Math.round).join()).join(' '));
	const first = await places();
	await press(page, 'Run');
	await page.getByLabel('What the engine sees').check();
	await page.keyboard.press('Space');
	await page.waitForFunction(() => globalThis.playground.world.agents.some(({ breed }) => breed === 'paintballs') || globalThis.playground.world.made > 22);
	assert.ok(await page.getByLabel('What the engine sees').isChecked());
	await page.getByLabel('What the engine sees').uncheck();
	await page.getByLabel('Speed').focus();
	for (const _ of [1, 2]) {
		await page.keyboard.press('ArrowLeft');
		assert.equal(await focused(page), 'Speed');
	}
	assert.equal(await page.getByLabel('Speed').inputValue(), '1');
	await press(page, 'Stop');
	assert.equal(await places(), first);
	await openProgram(page, 'endless', ENDLESS);
	await page.waitForSelector('.status.problem');
	const buttons = (all) => all.split(' ').slice(0, 3).join(' ');
	assert.equal(buttons(await places()), buttons(first));
	const [problem, blocks] = [await boxOf(page, '.status.problem'), await boxOf(page, '.blocks')];
	assert.ok(problem.height > 30 && problem.left > blocks.right, 'all of it is read, beside the blocks');
	assert.deepEqual(said, []);
	await leave();
});

test('Compare has its panel on the same side for two agents and for a game', async () => {
	const { page, said, leave } = await open(site, 'compare', SMALL);
	const sides = async () => {
		const { side, screen } = await page.evaluate(() => Object.fromEntries(['side', 'screen'].map((name) => [name, [...document.querySelectorAll(`.compare .${name}`)].map((each) => each.getBoundingClientRect()).find(({ width }) => width > 0).left])));
		return side > screen;
	};
	const pair = await sides();
	await page.getByRole('radio', { name: 'A scattered game' }).check();
	await page.waitForFunction(() => [...document.querySelectorAll('.scattered .side')].some((each) => each.getBoundingClientRect().width > 0));
	assert.equal(await sides(), pair);
	await ready(page, 'compare');
	assert.deepEqual(said, []);
	await leave();
});
