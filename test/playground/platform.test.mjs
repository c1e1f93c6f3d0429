/** A whole platform game, from an empty program: built by mouse and keys alone, played to its end, exported, and the export played in Node and in a page. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { begin, goNowhere, open, press, rest, root, saved, titled } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

/** A part of a block that the mouse holds, from its upper left corner. */
const [HOLD_X, HOLD_Y] = [9, 10];

/** Where something of a block is in the window: "DO" and other inputs, "next", or the middle of a field or a value. */
const placeOf = (page, id, part) => page.evaluate(([block, name]) => {
	const { workspace } = globalThis.playground.editor;
	const found = workspace.getBlockById(block);
	const connection = name === 'next' ? found.nextConnection : found.getInput(name)?.connection;
	if (connection && !connection.targetBlock()?.isShadow()) {
		const { a, d, e, f } = workspace.getCanvas().getScreenCTM();
		return { x: a * connection.x + e, y: d * connection.y + f };
	}
	const element = connection ? connection.targetBlock().getSvgRoot() : found.getField(name).getSvgRoot();
	const { left, top, width, height } = element.getBoundingClientRect();
	return { x: left + width / 2, y: top + height / 2 };
}, [id, part]);

class Builder {
	constructor(page) {
		this.page = page;
	}

	ids(type) {
		return this.page.evaluate((wanted) => globalThis.playground.editor.workspace.getBlocksByType(wanted).map(({ id }) => id), type);
	}

	/** Drags a block from the drawer to a place, and returns its id. */
	async take(category, type, to) {
		const { page } = this;
		const known = await this.ids(type);
		const isOpen = () => page.evaluate((wanted) => {
			const flyout = globalThis.playground.editor.workspace.getFlyout();
			return flyout.isVisible() && flyout.getWorkspace().getTopBlocks(false).some((each) => each.type === wanted);
		}, type);
		for (let i = 0; i < 10 && !(await isOpen()); i++) {
			const box = await page.locator('.blocklyToolboxCategory', { hasText: category }).boundingBox();
			await page.mouse.click(box.x + 30, box.y + box.height / 2);
			await rest(page, 150);
		}
		await rest(page, 100);
		const from = async () => page.evaluate((wanted) => {
			const flyout = globalThis.playground.editor.workspace.getFlyout().getWorkspace();
			const { left, top } = flyout.getTopBlocks(false).find((each) => each.type === wanted).getSvgRoot().querySelector(':scope > .blocklyPath').getBoundingClientRect();
			return { x: left, y: top };
		}, type);
		let at = await from();
		for (let i = 0; at.y > 1000 && i < 20; i++) {
			await page.mouse.move(at.x + 60, 600);
			await page.mouse.wheel(0, 300);
			await rest(page, 50);
			at = await from();
		}
		await page.mouse.move(at.x + HOLD_X, at.y + HOLD_Y);
		await page.mouse.down();
		await page.mouse.move(at.x + HOLD_X + 30, at.y + HOLD_Y + 10, { steps: 3 });
		await rest(page, 100);
		const { x, y } = typeof to === 'function' ? await to() : to;
		await page.mouse.move(x + HOLD_X, y + HOLD_Y, { steps: 6 });
		await page.mouse.up();
		await rest(page, 150);
		const [id, ...more] = (await this.ids(type)).filter((each) => !known.includes(each));
		assert.ok(id && more.length === 0, `${type} is in the program`);
		return id;
	}

	/** Takes a block into an input of another one, or below it. */
	async join(category, type, id, part) {
		const taken = await this.take(category, type, () => placeOf(this.page, id, part));
		assert.equal(await this.page.evaluate((each) => globalThis.playground.editor.workspace.getBlockById(each).getParent()?.id, taken), id, `${type} joins ${part}`);
		return taken;
	}

	/** Types a number into a block. */
	async type(id, inputs) {
		for (const [name, value] of Object.entries(inputs)) {
			const { x, y } = await placeOf(this.page, id, name);
			await this.page.mouse.click(x, y);
			await this.page.locator('.blocklyHtmlInput').waitFor();
			await this.page.keyboard.press('Control+A');
			await this.page.keyboard.type(String(value));
			await this.page.keyboard.press('Enter');
			await this.page.locator('.blocklyHtmlInput').waitFor({ state: 'detached' });
		}
	}

	/** Chooses in a block's menus. A breed that is not there yet is made. */
	async choose(id, fields) {
		for (const [name, text] of Object.entries(fields)) {
			const { x, y } = await placeOf(this.page, id, name);
			await this.page.mouse.click(x, y);
			const items = this.page.locator('.blocklyDropDownDiv .blocklyMenuItem');
			await items.first().waitFor();
			const item = items.filter({ hasText: new RegExp(`^${text}$`) });
			if (await item.count() > 0) await item.click();
			else if (!/^(BREED|OTHER)$/.test(name)) assert.fail(`${name}: ${await items.allTextContents()}`);
			else {
				await items.filter({ hasText: /^new breed…$/ }).click();
				await this.page.locator('.ask input').fill(text);
				await this.page.keyboard.press('Enter');
				await this.page.locator('.ask').waitFor({ state: 'detached' });
			}
			await rest(this.page, 100);
		}
	}

	/** Puts “create” below a block, with a size and a place in it. */
	async create(id, part, breed, shape, size, x, y, z) {
		const made = await this.join('Agents', 'starlogo_create', id, part);
		await this.choose(made, { BREED: breed, SHAPE: shape });
		const sized = await this.join('Looks', 'starlogo_size', made, 'DO');
		await this.type(sized, { SIZE: size });
		const placed = await this.join('Movement', 'starlogo_go', sized, 'next');
		await this.type(placed, { X: x, Y: y, Z: z });
		return made;
	}
}

const bearAt = (page) => page.evaluate(() => globalThis.playground.world.agents.find(({ breed }) => breed === 'bears').x);

test('a platform game is built from nothing by mouse and keys, won, exported, and its export is won in Node and runs in a page', { timeout: 240000 }, async () => {
	const { page, said, leave } = await open(site, 'play/paintball', { viewport: { width: 1800, height: 1150 }, deviceScaleFactor: 0.5 });
	page.setDefaultTimeout(10000);
	await press(page, 'New');
	await page.waitForFunction(() => globalThis.playground.world.agents.length === 1 && document.activeElement === document.querySelector('.title'));
	await page.keyboard.type('My platforms');
	await page.keyboard.press('Enter');
	await titled(page, 'My platforms');
	await rest(page, 300);
	const build = new Builder(page);
	// nothing is left
	const [given] = await build.ids('starlogo_start');
	const corner = await page.evaluate((id) => {
		const { left, top } = globalThis.playground.editor.workspace.getBlockById(id).getSvgRoot().getBoundingClientRect();
		return { x: left + 12, y: top + 34 };
	}, given);
	await page.mouse.click(corner.x, corner.y);
	await page.keyboard.press('Delete');
	await page.waitForFunction(() => globalThis.playground.editor.workspace.getAllBlocks(false).length === 0);

	const right = (y) => page.evaluate((at) => {
		const pane = document.querySelector('.blocks').getBoundingClientRect();
		return { x: pane.right - 330, y: pane.top + at };
	}, y);
	const start = await build.take('Events', 'starlogo_start', () => page.evaluate(() => {
		const { left, top } = document.querySelector('.blocks').getBoundingClientRect();
		return { x: left + 170, y: top + 20 };
	}));
	let last = await build.create(start, 'DO', 'platforms', 'platform', 4, -5, 0, 1);
	last = await build.create(last, 'next', 'platforms', 'platform', 4, 0.6, 0, 1);
	last = await build.create(last, 'next', 'coins', 'coin', 1, 1.5, 0, 2.1);
	last = await build.create(last, 'next', 'bears', 'bear', 1.2, -6, 0, 3);
	const solid = await build.join('Collisions', 'starlogo_solid', last, 'next');
	await build.choose(solid, { BREED: 'platforms', ON: 'on' });

	const each = await build.take('Events', 'starlogo_each', () => right(20));
	await build.choose(each, { BREED: 'bears' });
	await build.join('Movement', 'starlogo_fall', each, 'DO');
	const walk = await build.take('Events', 'starlogo_key', () => right(200));
	await build.choose(walk, { KEY: 'right arrow', BREED: 'bears' });
	await build.type(await build.join('Movement', 'starlogo_walk', walk, 'DO'), { STEPS: 0.05 });
	const jump = await build.take('Events', 'starlogo_key', () => right(380));
	await build.choose(jump, { KEY: 'space', MODE: 'pressed', BREED: 'bears' });
	await build.type(await build.join('Movement', 'starlogo_jump', jump, 'DO'), { HEIGHT: 2 });
	const touch = await build.take('Collisions', 'starlogo_touch_start', () => right(560));
	await build.choose(touch, { BREED: 'bears', OTHER: 'coins' });
	await build.choose(await build.join('Game', 'starlogo_end', touch, 'DO'), { HOW: 'won' });

	assert.deepEqual((await page.evaluate(() => globalThis.playground.world.agents.map(({ breed, x, z }) => [breed, x, z]))), [['platforms', -5, 1], ['platforms', 0.6, 1], ['coins', 1.5, 2.1], ['bears', -6, 3]]);
	assert.equal(await page.evaluate(() => globalThis.playground.editor.workspace.getTopBlocks(false).length), 5, 'no block is loose');

	// a quarter as fast: this computer may be busy
	await page.getByLabel('Speed').focus();
	for (let i = 0; i < 2; i++) await page.keyboard.press('ArrowLeft');
	await press(page, 'Run');
	await page.waitForFunction(() => globalThis.playground.world.agents.find(({ breed }) => breed === 'bears').z < 2.01);
	await page.keyboard.down('ArrowRight');
	for (let i = 0; i < 600 && await bearAt(page) < -3.7; i++) await page.waitForTimeout(20);
	await page.keyboard.press('Space');
	await page.waitForFunction(() => globalThis.playground.world.ended !== null);
	await page.keyboard.up('ArrowRight');
	assert.equal(await page.evaluate(() => globalThis.playground.world.ended.how), 'won');
	await page.locator('.end', { hasText: 'You have won!' }).waitFor();

	await press(page, 'This program as JavaScript');
	const text = await saved(page, () => page.locator('.ask.javascript').getByRole('button', { name: 'Download', exact: true }).click());
	const folder = mkdtempSync(path.join(tmpdir(), 'platforms-'));
	mkdirSync(path.join(folder, 'node_modules'));
	symlinkSync(path.join(root, 'bin/module'), path.join(folder, 'node_modules/starlogo-collision'));
	const file = path.join(folder, 'game.mjs');
	writeFileSync(file, text);
	const { stdout } = await promisify(execFile)(process.execPath, [file]);
	assert.match(stdout, /^4 agents after 600 frames/);
	const { agents, game, press: push, step } = await import(pathToFileURL(file).href);
	push('right');
	for (let i = 0; i < 400 && !game.ended; i++) {
		if (agents[3].x > -3.7 && agents[3].x < -3.6) push('space');
		step();
	}
	assert.equal(game.ended?.how, 'won');

	await page.keyboard.press('Escape');
	await goNowhere(page);
	const script = (body) => (route) => route.fulfill({ contentType: 'text/javascript', body });
	await page.route('**/game.mjs', script(text));
	await page.route('**/engine.js', script(readFileSync(path.join(root, 'bin/module/starlogo-collision.js'), 'utf8')));
	await page.route('**/game.html', (route) => route.fulfill({ contentType: 'text/html', body: '<link rel="icon" href="data:,"><script type="importmap">{ "imports": { "starlogo-collision": "./engine.js" } }</script><script type="module" src="game.mjs"></script>' }));
	assert.deepEqual(said, []);
	const [message] = await Promise.all([page.waitForEvent('console', (each) => /agents after/.test(each.text())), page.goto(`${site.url}game.html`)]);
	assert.match(message.text(), /^4 agents after 600 frames/);
	rmSync(folder, { recursive: true, force: true });
	said.length = 0;
	await leave();
});
