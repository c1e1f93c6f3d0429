/** A class: pupils hand in their work, the teacher opens it; links and files keep what belongs to a program; addresses that lead nowhere say so. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { isChromium } from '../../build/headless/browsers.mjs';
import { SIZES, begin, go, goNowhere, keepCopies, open, own, press, ready, refuseCopies, root, saved, titled, told } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

const Desktop = SIZES.laptop;
const BEAR = path.join(root, 'assets/bear.obj');
const skip = isChromium ? false : 'downloads are Chromium\'s';
const tickOf = (page, name) => page.evaluate((lesson) => globalThis.playground.programs.progress.isDone(lesson), name);
const lessonShown = (page) => page.evaluate(() => document.querySelector('.lesson h2')?.textContent ?? null);

/** Does the lesson with the helmet, whose task is the choice of a system. */
async function doHelmet(page) {
	await go(page, 'play/lesson-helmet');
	await page.waitForFunction(() => /helmet/.test(document.querySelector('.lesson h2')?.textContent));
	await page.getByLabel('Collision system').selectOption('exact');
	await page.waitForFunction(() => /^Done!/.test(document.querySelector('.why').textContent));
}

/** Gives the first agents of a program another shape, as the menu of shapes does when it opens. */
const shape = (page, name) => page.evaluate((wanted) => {
	const field = globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].getField('SHAPE');
	field.getOptions(false);
	field.setValue(wanted);
}, name);

/** Changes the program that is open, so that it becomes the user's own. */
const change = (page) => page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_start')[0].moveBy(1, 0) ?? globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].setFieldValue('bears', 'BREED'));

test('three pupils hand in on one computer, one after the other; the teacher sees who has solved what, and plays a program at a click', { skip }, async () => {
	const { page, said, leave } = await open(site, 'play/lesson-helmet', Desktop);
	const files = [];
	// one says of himself what none of his programs does
	const forged = { Ben: ['wing'] };
	for (const [i, pupil] of ['Ada', 'Ben', 'Cem'].entries()) {
		if (i % 2 === 0) await doHelmet(page);
		await go(page, 'play/lesson-blocks');
		await page.waitForFunction(() => /turtles move/.test(document.querySelector('.lesson h2')?.textContent));
		await change(page);
		await titled(page, 'Blocks make turtles move (mine)');
		if (pupil === 'Cem') {
			await page.setInputFiles('.naming input[type=file]', BEAR);
			await told(page, /“bear 2”/);
			await shape(page, 'bear 2');
			await page.waitForFunction(() => /bear 2/.test(localStorage.getItem('starlogo-playground.programs')));
		}
		await press(page, 'Hand in…');
		const dialog = page.getByRole('dialog', { name: 'Hand in your work' });
		assert.match(await dialog.textContent(), i % 2 === 0 ? /1 lesson that you have done and 1 program\./ : /0 lessons that you have done and 1 program\./);
		// the name of the one before is forgotten
		assert.equal(await dialog.getByLabel('Name').inputValue(), '');
		await dialog.getByRole('button', { name: 'Save a file' }).click();
		assert.match(await dialog.textContent(), /Write your name first/);
		await dialog.getByLabel('Name').fill(pupil);
		const work = JSON.parse(await saved(page, () => dialog.getByRole('button', { name: 'Save a file' }).click()));
		work.done.push(...forged[pupil] ?? []);
		files.push({ name: `${pupil}.json`, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(work)) });
		assert.match(await dialog.textContent(), new RegExp(`“${pupil} – StarLogo.json” is in your downloads`));
		await page.keyboard.press('Escape');
		await press(page, 'Lessons and games');
		await press(page, 'New pupil…');
		assert.match(await page.getByRole('dialog', { name: 'New pupil…' }).textContent(), /forgets everything.*This cannot be undone/);
		await Promise.all([page.waitForNavigation(), press(page, 'Forget everything')]);
		await ready(page, 'play');
		assert.deepEqual([await own(page), await tickOf(page, 'helmet'), await page.evaluate(() => globalThis.playground.modelShelf.names)], [[], false, []]);
	}
	await go(page, 'teach');
	await page.getByRole('link', { name: 'The work of a class' }).click();
	await page.setInputFiles('input[type=file]', [...files, { name: 'holiday.json', mimeType: 'application/json', buffer: Buffer.from('{"a": 1}') }]);
	await page.waitForFunction(() => document.querySelectorAll('.class tbody tr').length === 3);
	assert.match(await page.textContent('.status'), /3 works are new\. No work of this page: holiday\.json\./);
	// what was done by the choice of a system alone is played again, too
	await page.waitForSelector('[data-checked="class"]');
	assert.deepEqual(await page.locator('.class tbody tr').evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent).join(' ').replaceAll(/ +/g, ' ').trim())),
		['Ada … ✓ 0 1', 'Ben … ✓? 0 1', 'Cem … ✓ 0 1']);
	assert.equal(await page.locator('.class tfoot td').nth(1).textContent(), '2', 'what is only said does not count');
	await page.waitForSelector('[data-drawn="class"]');
	assert.ok((await page.locator('.class img').evaluateAll((all) => all.map(({ naturalWidth }) => naturalWidth))).every((width) => width > 100), 'each program has its picture');
	// the same again is no other
	await page.setInputFiles('input[type=file]', files.slice(0, 2));
	await page.waitForFunction(() => /0 works are new. 2 were here already/.test(document.querySelector('.status').textContent));
	await page.locator('.pupil', { hasText: 'Cem' }).locator('a').click();
	await ready(page, 'play');
	await titled(page, 'Blocks make turtles move (mine) (Cem)');
	assert.equal(await lessonShown(page), 'Blocks make turtles move');
	assert.deepEqual([await page.evaluate(() => globalThis.playground.world.agents[0].shape), await page.evaluate(() => globalThis.playground.modelShelf.names)], ['bear 2', ['bear 2']]);
	assert.deepEqual(await own(page), [], 'it is not among her own');
	await press(page, 'Step');
	await page.reload();
	await ready(page, 'play');
	assert.equal(await page.inputValue('.title'), 'Blocks make turtles move (mine) (Cem)', 'the browser remembers the class');
	// in another tab it is there as well
	const tab = await page.context().newPage();
	await tab.goto(`${site.url}#teach/class`);
	await tab.waitForFunction(() => document.querySelectorAll('.class tbody tr').length === 3);
	await tab.close();
	await page.goBack();
	await page.waitForFunction(() => document.querySelectorAll('.class tbody tr').length === 3);
	await page.locator('.pupil').first().getByRole('button').click();
	await page.waitForFunction(() => document.querySelectorAll('.class tbody tr').length === 2);
	await press(page, 'Remove all…');
	assert.match(await page.textContent('.status'), /^This removes the works of all 2 pupils from this browser/);
	await press(page, 'Forget everything');
	await page.waitForFunction(() => /Nothing is open yet/.test(document.querySelector('.class').textContent));
	await page.reload();
	await ready(page, 'teach');
	assert.match(await page.textContent('.class'), /Nothing is open yet/);
	assert.deepEqual(said, []);
	await leave();
});

test('a code hands in, too; a file that is dropped on the wrong page is named for what it is', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-helmet', Desktop);
	await doHelmet(page);
	await refuseCopies(page);
	await press(page, 'Save a copy');
	await press(page, 'Hand in…');
	await page.getByRole('dialog').getByLabel('Name').fill('Ada');
	await press(page, 'Copy a code');
	await page.waitForFunction(() => document.querySelector('dialog textarea').value.length > 20);
	const code = await page.inputValue('dialog textarea');
	assert.match(code, /^SL1\.[\w-]+$/);
	assert.ok(code.length < 1500, `${code.length} letters`);
	await page.keyboard.press('Escape');
	const file = JSON.stringify({ kind: 'starlogo-nova-work', pupil: 'Ben', done: ['wing'], won: [], programs: [], models: {} });
	await page.setInputFiles('.naming input[type=file]', { name: 'Ben.json', mimeType: 'application/json', buffer: Buffer.from(file) });
	await told(page, /Ben\.json is the work that somebody has handed in/);
	await go(page, 'teach/class');
	await page.waitForSelector('.class');
	// as a letter brings it: with words around it, and broken into lines
	await page.getByLabel('The code').fill('Hello!');
	await press(page, 'Take the codes');
	await page.waitForFunction(() => /No whole code/.test(document.querySelector('.status').textContent));
	for (const text of [`My code:\n${code}\nRegards`, code.replaceAll(/.{70}/g, '$&\n')]) {
		await page.getByLabel('The code').fill(text);
		await press(page, 'Take the codes');
		await page.waitForFunction(() => document.querySelector('.status').textContent.includes('work') && document.querySelector('textarea').value === '');
	}
	assert.match(await page.textContent('.status'), /0 works are new. 1 was here already/);
	assert.deepEqual(await page.locator('.class tbody th').allTextContents(), ['Ada']);
	// files are dropped anywhere among the pages for teachers
	await go(page, 'teach');
	await page.waitForSelector('a[href="#teach/class"]');
	const data = await page.evaluateHandle((text) => {
		const transfer = new DataTransfer();
		transfer.items.add(new File([text], 'Ben.json'));
		return transfer;
	}, file);
	// a browser that refuses to keep says so
	await page.evaluate(() => {
		IDBFactory.prototype.open = () => {
			throw new Error('refused');
		};
	});
	await page.dispatchEvent('.sheet', 'drop', { dataTransfer: data });
	await page.waitForFunction(() => [...document.querySelectorAll('.class tbody th')].map(({ textContent }) => textContent).join() === 'Ada,Ben');
	assert.match(await page.textContent('.status'), /^1 work is new\.\s+This browser does not keep them/);
	assert.deepEqual(said, []);
	await leave();
});

test('a model that cannot be read hinders nobody else, and what was played once is not played again', async () => {
	const { page, said, leave } = await open(site, 'teach/class', Desktop);
	const work = (pupil, more) => ({ name: `${pupil}.json`, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify({ kind: 'starlogo-nova-work', pupil, done: ['helmet'], won: [], programs: [], ...more })) });
	const solutions = { helmet: { system: 'exact' } };
	await page.setInputFiles('input[type=file]', [work('Ada', { solutions, models: { broken: Buffer.from('v 1 2 x').toString('base64') } }), work('Ben', { solutions })]);
	await page.waitForSelector('[data-checked="class"]');
	const signs = () => [...document.querySelectorAll('.class tbody tr')].map((row) => row.textContent.replaceAll(/[^✓?]/g, '')).join();
	assert.equal(await page.evaluate(signs), '?,✓', 'what could not be played is not said to have been');
	await go(page, 'teach');
	await page.waitForSelector('a[href="#teach/class"]');
	await page.evaluate(() => {
		// as the page of the class appears, before it plays anything
		globalThis.appeared = new Promise((resolve) => {
			new MutationObserver(() => document.querySelector('.class tbody tr') && resolve([...document.querySelectorAll('.class tbody .done')].length)).observe(document.querySelector('main'), { childList: true, subtree: true });
		});
		location.hash = 'teach/class';
	});
	assert.equal(await page.evaluate(() => globalThis.appeared), 1, 'what Ben has solved is known');
	assert.deepEqual(said, []);
	await leave();
});

test('a view and a class whose models do not come say so in the page\'s language, and the class is played when they come', async () => {
	const { page, said, leave } = await open(site, 'teach', SIZES.laptop);
	await page.evaluate(() => localStorage.setItem('starlogo-playground.language', 'de'));
	await page.reload();
	await ready(page, 'teach');
	await page.route('**/models/*.json', (route) => route.abort());
	await go(page, 'inspect');
	await page.waitForFunction(() => /kann nicht gezeigt werden\. Das konnte nicht geladen werden: \w+\.json\. *$/.test(document.querySelector('main .status')?.textContent));
	await go(page, 'compare');
	assert.match(await page.textContent('main [role=alert] p'), /^Das konnte nicht geladen werden: \w+\.json\.$/);
	await go(page, 'teach/class');
	await page.waitForSelector('.class');
	const work = { kind: 'starlogo-nova-work', pupil: 'Ben', done: ['helmet'], won: [], programs: [{ name: 'Mine', lesson: 'helmet', program: { blocks: { blocks: [] } } }], solutions: { helmet: { system: 'exact' } } };
	await page.setInputFiles('input[type=file]', { name: 'Ben.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(work)) });
	await page.waitForSelector('.class .problem');
	assert.match(await page.textContent('.class .problem'), /^Das konnte nicht geladen werden: \w+\.json\. Noch einmal versuchen$/);
	assert.equal(await page.locator('[data-checked="class"]').count(), 0);
	assert.deepEqual(await page.locator('.class tbody [role=img]').evaluateAll((signs) => signs.map(({ textContent, title }) => [textContent, title])), [['?', 'gelöst, sagt die Datei; nicht gespielt']]);
	await page.unrouteAll();
	await press(page, 'Noch einmal versuchen');
	await page.waitForSelector('[data-checked="class"][data-drawn="class"]');
	assert.deepEqual([await page.locator('.class tbody .done').count(), await page.locator('.class .problem').count()], [1, 0]);
	assert.deepEqual(said.filter((each) => !/ERR_FAILED/.test(each)), []);
	await leave();
});

test('in the table of a class names and signs lead to what was handed in, lessons to their pages, and the table can be taken along', async () => {
	const { page, said, leave } = await open(site, 'teach/class', Desktop);
	const blocks = { languageVersion: 0, blocks: [{ type: 'starlogo_start', inputs: {} }] };
	const work = (pupil, programs) => ({ name: `${pupil}.json`, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify({ kind: 'starlogo-nova-work', pupil, done: ['helmet'], won: [], programs })) });
	await page.setInputFiles('input[type=file]', [work('Ada', [{ name: 'One', program: { blocks } }, { name: 'Two', lesson: 'wing', program: { blocks } }]), work('=1+1 "x"', [])]);
	await page.waitForSelector('[data-checked="class"]');
	const links = await page.locator('.class tbody a').evaluateAll((all) => all.map(({ textContent, hash }) => [textContent, hash]));
	const [at] = links.filter(([text]) => text === 'Ada').map(([, hash]) => /^#play\/handed-([\d-]+)-0$/.exec(hash)[1]);
	assert.deepEqual(links, [['Ada', `#play/handed-${at}-0`], ['…', `#play/handed-${at}-1`]]);
	assert.equal(await page.locator('.class thead a').nth(2).evaluate(({ hash }) => hash), '#teach/wing');
	const rows = (await saved(page, () => press(page, 'Download the table'))).split('\r\n');
	assert.match(rows[0], /^\uFEFF?"Pupil","Handed in","Blocks make turtles move",.*"Programs"$/);
	assert.ok(rows.some((row) => /^"Ada","[^"]+20\d\d[^"]+","","✓\?","…","","","","","","","","","0","2"$/.test(row)), rows.join('\n'));
	assert.ok(rows.some((row) => row.startsWith('"\'=1+1 ""x""",')), 'a name is no formula');
	await page.getByRole('link', { name: 'Ada', exact: true }).click();
	await page.waitForSelector('.title');
	await titled(page, 'One (Ada)');
	assert.deepEqual(said, []);
	await leave();
});

test('if a pupil hands in twice, the newest work counts, and the earlier one is folded below it', async () => {
	const { page, said, leave } = await open(site, 'teach/class', Desktop);
	const blocks = { languageVersion: 0, blocks: [{ type: 'starlogo_start', inputs: {} }] };
	const work = (pupil, when, name) => ({ name: `${name}.json`, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify({ kind: 'starlogo-nova-work', when, pupil, done: [], won: [], programs: [{ name, program: { blocks } }] })) });
	await page.setInputFiles('input[type=file]', [work('Ada', Date.UTC(2026, 8, 2, 10), 'Second'), work('Ada', Date.UTC(2026, 8, 1, 10), 'First'), work('Ben', Date.UTC(2026, 8, 1, 10), 'Only')]);
	await page.waitForFunction(() => document.querySelectorAll('.class tbody tr').length === 2);
	assert.match(await page.textContent('.class tfoot'), /All 2/);
	const ada = page.getByRole('region', { name: 'Ada' });
	assert.match(await ada.locator('.head small').textContent(), /^Sep 2, 2026/);
	assert.deepEqual(await ada.locator('.cards .name').allTextContents(), ['Second']);
	assert.ok(!await ada.getByRole('link', { name: 'First' }).isVisible());
	await ada.getByText('Handed in before: 1 work').click();
	await ada.getByRole('link', { name: 'First' }).click();
	await page.waitForSelector('.title');
	await titled(page, 'First (Ada)');
	await page.goBack();
	// the same content is known, whenever it was handed in
	await page.setInputFiles('input[type=file]', [work('Ada', Date.UTC(2026, 8, 3, 10), 'Second')]);
	await page.waitForFunction(() => /0 works are new. 1 was here already/.test(document.querySelector('.status').textContent));
	// what is removed is all of it
	await page.getByRole('button', { name: 'Remove the work of Ada' }).click();
	await page.waitForFunction(() => document.querySelectorAll('.class tbody tr').length === 1);
	assert.equal(await page.getByRole('region', { name: 'Ada' }).count(), 0);
	assert.deepEqual(said, []);
	await leave();
});

test('who has no work is told so and cannot hand it in; who has handed in closes the dialog, and cancels nothing', { skip }, async () => {
	const { page, said, leave } = await open(site, 'play/maze', Desktop);
	await press(page, 'Hand in…');
	assert.match(await page.locator('.handing').textContent(), /You have nothing to hand in yet/);
	assert.deepEqual(await page.locator('.handing button').allTextContents(), ['Close']);
	await page.keyboard.press('Escape');
	await page.locator('.handing').waitFor({ state: 'detached' });
	await press(page, 'Save a copy');
	await press(page, 'Hand in…');
	await page.locator('.handing').getByRole('button', { name: 'Cancel' }).waitFor();
	await page.locator('.handing').getByLabel('Name').fill('Ada');
	await saved(page, () => press(page, 'Save a file'));
	await page.locator('.handing').getByRole('button', { name: 'Close' }).click();
	await page.locator('.handing').waitFor({ state: 'detached' });
	assert.deepEqual(said, []);
	await leave();
});

test('links and files keep the lesson; own models go along in files, and a link says that they do not', { skip }, async () => {
	const { page, said, leave } = await open(site, 'play/lesson-blocks', Desktop);
	await page.setInputFiles('.naming input[type=file]', BEAR);
	await told(page, /“bear 2”/);
	await keepCopies(page);
	await press(page, 'Copy a link');
	await told(page, /^The link is on the clipboard\.$/);
	await shape(page, 'bear 2');
	await titled(page, 'Blocks make turtles move (mine)');
	await press(page, 'Copy a link');
	await told(page, /clipboard\. Your own models are not in a link \(bear 2\)\. Download/);
	const link = await page.evaluate(() => globalThis.copied);
	const file = await saved(page, () => press(page, 'Download'));
	assert.deepEqual(said, []);
	await leave();

	const other = await open(site, link.split('#')[1], Desktop);
	assert.equal(await lessonShown(other.page), 'Blocks make turtles move', 'the card and its task are there');
	await other.leave();
	const third = await open(site, 'play/maze', Desktop);
	// another model of the name is there already
	await third.page.setInputFiles('.naming input[type=file]', { name: 'bear 2.obj', mimeType: 'text/plain', buffer: Buffer.from('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n') });
	await told(third.page, /“bear 2”/);
	await third.page.setInputFiles('.naming input[type=file]', { name: 'mine.json', mimeType: 'application/json', buffer: Buffer.from(file) });
	await titled(third.page, 'Blocks make turtles move (mine)');
	// the program of a file is kept under an address of its own
	await third.page.reload();
	await ready(third.page, 'play');
	assert.equal(await lessonShown(third.page), 'Blocks make turtles move');
	assert.deepEqual(await third.page.evaluate(() => [globalThis.playground.modelShelf.names, globalThis.playground.world.agents[0].shape]), [['bear 2', 'bear 2 2'], 'bear 2 2']);
	assert.equal(JSON.parse(file).models['bear 2'], readFileSync(BEAR).toString('base64'));
	assert.deepEqual(third.said, []);
	await third.leave();
});

test('an address of another browser, a mistyped one and a broken link say so, and show the lessons', async () => {
	const { page, said, leave } = await open(site, 'inspect', Desktop);
	for (const [address, text] of [
		['play/own-mws4clyd-9t9n', /^This address is for a program that another browser keeps/], ['play/lesson-helmt', /^Nothing is at the address “lesson-helmt”/], ['plai/maze', /^Nothing is at the address “plai\/maze”/],
		['play/handed-0-3', /^This address is for a program of a class/], [`play/${'hZHNasMwEIRfxejQk0nT0F58C4FCoaXQlF'.repeat(9)}`, /^The program in this link could not be read/],
	]) {
		await goNowhere(page);
		await page.goto(`${site.url}#${address}`);
		await page.waitForSelector('.gallery .problem');
		assert.match(await page.textContent('.gallery .problem'), text);
		assert.equal(await page.locator('.gallery ol').first().locator('li').count(), 11);
	}
	assert.deepEqual(said, []);
	await leave();
});

test('a program is printed on a page of its own: with its name, its picture and its blocks', async () => {
	const { page, said, leave } = await open(site, 'play/maze', Desktop);
	await press(page, 'Print');
	await page.waitForSelector('[data-drawn="maze"]');
	assert.equal(await page.textContent('.sheet h2'), 'Maze');
	assert.ok(await page.locator('.shown-blocks .blocklyPath').count() > 20);
	assert.equal(await page.evaluate(() => document.querySelector('.shown').naturalWidth), 800);
	await page.evaluate(() => {
		globalThis.print = () => {
			globalThis.printed = true;
		};
	});
	await page.locator('.sheet').getByRole('button', { name: 'Print' }).click();
	assert.ok(await page.evaluate(() => globalThis.printed));
	// a long program takes more than one sheet, so that it can be read; a short one takes one
	const highest = () => page.evaluate(() => Math.max(...[...document.querySelectorAll('.shown-blocks .blocklyText')].map((each) => each.getBoundingClientRect().height)));
	assert.ok(await highest() > 7, `letters of ${await highest()} pixels`);
	await go(page, 'teach/helmet');
	await page.waitForSelector('[data-drawn="helmet"]');
	await go(page, 'teach/wing');
	await page.waitForSelector('[data-drawn="wing"]');
	await go(page, 'teach/maze');
	await page.waitForSelector('[data-drawn="maze"]');
	await page.getByRole('link', { name: 'Back to the program' }).click();
	await ready(page, 'play');
	await titled(page, 'Maze');
	// one from a link, and a name that is none
	await go(page, 'teach/no-such-page');
	await page.waitForSelector('.sheet .problem');
	assert.equal(await page.locator('.sheet tbody tr').count(), 11);
	assert.deepEqual(said, []);
	await leave();
});

test('the last lesson leads on: to the games, to one to change, to one of one\'s own', async () => {
	const { page, said, leave } = await open(site, 'play/lesson-jump', Desktop);
	await page.evaluate(() => globalThis.playground.programs.progress.tickGame('x') ?? localStorage.setItem('starlogo-playground.lessons', '["jump"]'));
	await page.reload();
	await ready(page, 'play');
	await page.waitForFunction(() => /^Done!/.test(document.querySelector('.why').textContent));
	await press(page, 'To the games');
	await page.waitForSelector('.gallery h3');
	await press(page, 'Close');
	await press(page, 'Change a game');
	await titled(page, 'Paintball');
	await page.goBack();
	await titled(page, 'A floor, a jump, a coin');
	await press(page, 'Make your own');
	await titled(page, 'My program');
	assert.deepEqual(said, []);
	await leave();
});
