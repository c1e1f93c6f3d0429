/** What screen readers, fingers and keys get, and messages that cover nothing. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { isChromium } from '../../build/headless/browsers.mjs';
import { SIZES, begin, open, rest } from './browser.mjs';

const LOW = { ...SIZES.laptop, viewport: { width: 1366, height: 625 } };
const PHONE = SIZES.phone;
/** A phone that is held across. */
const ACROSS = { ...PHONE, viewport: { width: 844, height: 390 } };

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

const edited = (page) => page.waitForFunction(() => globalThis.playground?.editor);

/** Drops a file of text on the page. */
const dropText = (page, name) => page.evaluate((file) => {
	const transfer = new DataTransfer();
	transfer.items.add(new File(['hello'], file));
	dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true }));
}, name);

/** The items of a tree as the browser gives them to screen readers, each with its level. */
async function treeOf(page, name) {
	const client = await page.context().newCDPSession(page);
	const { nodes } = await client.send('Accessibility.getFullAXTree');
	await client.detach();
	const byId = new Map(nodes.map((node) => [node.nodeId, node]));
	const items = [];
	const walk = (node) => {
		if (node?.role?.value === 'treeitem') items.push(`${node.properties.find((each) => each.name === 'level')?.value.value} ${node.name.value}`);
		for (const id of node?.childIds ?? []) walk(byId.get(id));
	};
	walk(nodes.find((node) => node.role?.value === 'tree' && node.name?.value === name));
	return items;
}

test('the blocks are a tree whose words come in reading order, in the program and in the drawer', { skip: isChromium ? false : 'Chromium alone tells its tree' }, async () => {
	const { page, said, leave } = await open(site, 'play/paintball', LOW);
	await edited(page);
	await rest(page, 200);
	const lines = await treeOf(page, 'The program’s blocks');
	const order = ['1 when key space is pressed, each of bears', '2 space', '2 pressed', '2 bears', '2 throw one of paintballs with shape sphere', '3 paintballs', '3 sphere', '3 set colour of me to a random colour', '4 me', '4 a random colour', '3 set size to 0.4'];
	const first = lines.indexOf(order[0]);
	assert.deepEqual(lines.slice(first, first + order.length), order);
	// a folded script has its whole words
	assert.ok(lines.includes('1 when the game starts'), lines.join('\n'));
	// the tree follows the program
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_hatch')[0].dispose(true));
	await rest(page, 200);
	assert.ok(!(await treeOf(page, 'The program’s blocks')).join().includes('throw one of'));
	await page.locator('.blocklyToolboxCategory').nth(2).click();
	await rest(page, 200);
	assert.ok((await treeOf(page, 'Blocks to take')).includes('1 forward 0.1'));
	assert.deepEqual(said.splice(0), []);
	await leave();
});

test('a block that has the focus says its words', async () => {
	const { page, leave } = await open(site, 'play/paintball', LOW);
	await edited(page);
	await rest(page, 200);
	await page.locator('.blocklyBlockCanvas text', { hasText: 'throw one of' }).first().click();
	const words = await page.evaluate(() => [document.activeElement.getAttribute('role'), document.activeElement.getAttribute('aria-label')]);
	assert.deepEqual(words, ['treeitem', 'throw one of paintballs with shape sphere']);
	await leave();
});

test('a refused file moves nothing, and its note goes by itself', async () => {
	for (const view of ['compare', 'level']) {
		const { page, leave } = await open(site, view, LOW);
		await rest(page, 300);
		const place = () => page.evaluate(() => JSON.stringify([...document.querySelectorAll('.world, .tools, .language')].map((each) => each.getBoundingClientRect())));
		const before = await place();
		await dropText(page, 'my notes about the game.txt');
		assert.match(await page.locator('header .note').textContent(), /my notes about the game/);
		assert.equal(await place(), before, view);
		await page.waitForFunction(() => document.querySelector('header .note').textContent === '');
		await leave();
	}
});

test('a problem covers neither the camera nor other controls, and is read whole', async () => {
	for (const [language, size] of [['en', LOW], ['de', LOW], ['en', ACROSS], ['de', ACROSS]]) {
		const { page, leave } = await open(site, 'play/paintball', size);
		if (language === 'de') {
			await page.goto(`${site.url}?language=de#play/paintball`);
			await page.waitForSelector('main[data-ready="play"]');
		}
		await edited(page);
		const problem = 'The program stopped: the loop “repeat while” never comes to an end. Its condition has to become false. Put blocks that go on for ever into “every frame”, without a loop. '.repeat(2);
		await page.evaluate((text) => globalThis.playground.say(text, true), problem);
		const covered = await page.evaluate(() => [...document.querySelectorAll('.controls button, .show select, .show input')].filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.closest('.tabs')).filter((each) => {
			each.scrollIntoView({ block: 'nearest' });
			const { left, top, width, height } = each.getBoundingClientRect();
			return document.elementFromPoint(left + width / 2, top + height / 2)?.closest('.problem, .whole');
		}).map((each) => each.outerHTML));
		assert.deepEqual(covered, [], `${language}, ${size.viewport.height} pixels`);
		assert.equal(await page.locator('.whole').textContent(), problem);
		assert.ok(await page.locator('.whole').isVisible());
		await page.evaluate(() => globalThis.playground.say('short'));
		assert.ok(!await page.locator('.whole').isVisible());
		await leave();
	}
});

test('Ctrl+A beside a field marks nothing', async () => {
	const { page, leave } = await open(site, 'play/paintball', LOW);
	await edited(page);
	await page.evaluate(() => document.activeElement.blur());
	await page.keyboard.press('Control+a');
	assert.equal(await page.evaluate(() => getSelection().toString()), '');
	const title = page.locator('.title');
	await title.click();
	await page.keyboard.press('Control+a');
	await page.keyboard.type('Mine');
	assert.equal(await title.inputValue(), 'Mine');
	await leave();
});

for (const view of ['play/paintball', 'play/lesson-wing', 'play/all', 'inspect', 'compare', 'measure', 'level', 'teach']) {
	test(`${view}: no words below 12 pixels, and on a phone targets of 44`, { skip: isChromium ? false : 'phones are Chromium\'s' }, async () => {
		for (const size of [PHONE, LOW]) {
			const { page, leave } = await open(site, view, size);
			if (view.startsWith('play')) await edited(page);
			await rest(page, 300);
			const small = await page.evaluate(() => [...document.querySelectorAll('body *')].filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.closest('svg, .visually-hidden') && [...each.childNodes].some(({ nodeType, data }) => nodeType === 3 && data.trim() !== ''))
				.filter((each) => parseFloat(getComputedStyle(each).fontSize) < 12).map((each) => `${each.className} ${each.textContent.slice(0, 30)}`));
			assert.deepEqual(small, []);
			const targets = size !== PHONE ? [] : await page.evaluate(() => [...document.querySelectorAll('button, a, select, summary, input:not([type="file"]), .tick, .verdict, .blocklyToolboxCategory')]
				.filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.matches('.skip, p a, small a') && !(each.matches('input') && each.closest('label')))
				.map((each) => [each.getBoundingClientRect(), each]).filter(([{ width, height }]) => width < 43.5 || height < 43.5).map(([{ width, height }, each]) => `${Math.round(width)} ${Math.round(height)} ${each.tagName} ${each.className} ${each.textContent.slice(0, 20)}`));
			assert.deepEqual(targets, []);
			assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing beside the page');
			await leave();
		}
	});
}
