/** The page as one file: copied alone to a folder of its own, as to a stick, and opened by a double click, without a server. */
import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { isChromium, launch } from '../../build/headless/browsers.mjs';
import { serve } from '../../build/headless/server.mjs';
import { SIZES, newPage as openPage, press, ready, root, saved } from './browser.mjs';
import { parts } from './parts.mjs';

const NAME = 'starlogo-nova.html';
const skip = isChromium ? false : 'one browser is enough';
let browser;
let stick;
before(async () => {
	stick = mkdtempSync(path.join(os.tmpdir(), 'stick-'));
	copyFileSync(path.join(root, 'bin/playground', NAME), path.join(stick, NAME));
	browser = await launch();
});
after(async () => {
	await browser.close();
	rmSync(stick, { recursive: true });
});

/** A page in a browser that remembers nothing; said is what came on the console, and requests for other files. */
const newPage = (options = {}) => openPage({ browser, url: pathToFileURL(path.join(stick, NAME)).href }, { ...SIZES.desktop, locale: 'en-US', ...options });

const at = (hash) => `${pathToFileURL(path.join(stick, NAME)).href}${hash}`;
const done = (page) => page.waitForFunction(() => /^Done! .{20}/.test(document.querySelector('.why').textContent));

test('without a server, all eleven lessons are solved', { skip }, async () => {
	const { page, said } = await newPage();
	await page.goto(at(''));
	await ready(page, 'play');
	assert.equal(await page.locator('.silent').count(), 0, 'what is said where no script arrives is gone');
	await page.locator('.gallery .next').click();
	const names = await page.evaluate(() => globalThis.playground.programs.gallery.groups[0].entries.map(({ id }) => id.replace('lesson-', '')));
	assert.equal(names.length, 11);
	for (const [i, name] of names.entries()) {
		await page.waitForFunction((number) => document.querySelector('.lesson')?.textContent.startsWith(`Lesson ${number} of 11`), i + 1);
		// a file with the solution on the teacher's sheet, in the lesson
		await page.setInputFiles('.naming input[type=file]', { name: `${name}.json`, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify({ lesson: name, ...parts.solved(name) })) });
		await page.waitForFunction((title) => document.querySelector('.title').value === title, name);
		await page.getByLabel('Speed').fill('5');
		await press(page, 'Run');
		await done(page);
		await press(page, 'Stop').catch(() => {});
		if (i < 10) await press(page, 'Next');
	}
	await press(page, 'Lessons and games');
	assert.equal(await page.locator('.gallery .tick').count(), 11);
	// the teacher's page plays all eleven again, from the file that hands them in
	await page.locator('.gallery').getByRole('button', { name: 'Hand in…' }).click();
	await page.getByRole('dialog').getByLabel('Name').fill('Ada');
	const work = await saved(page, () => press(page, 'Save a file'));
	await page.goto(at('#teach/class'));
	await ready(page, 'teach');
	await page.setInputFiles('input[type=file]', { name: 'Ada.json', mimeType: 'application/json', buffer: Buffer.from(work) });
	await page.waitForSelector('[data-checked="class"]');
	assert.equal(await page.locator('.class tbody .done').count(), 11);
	assert.deepEqual(said, []);
	await page.context().close();
});

test('without a server, every view works, programs and models are kept, and nothing is asked for', { skip }, async () => {
	const { page, said } = await newPage();
	await page.goto(at('#inspect'));
	await ready(page, 'inspect');
	await page.waitForFunction(() => /^Bear: \d/.test(document.querySelector('.status').textContent));
	for (const view of ['compare', 'measure']) {
		await page.goto(at(`#${view}`));
		await ready(page, view);
	}
	await page.goto(at('#teach/hunt'));
	await page.waitForSelector('[data-drawn="hunt"]');
	assert.ok(await page.locator('.shown-blocks .blocklyPath').count() > 3);
	assert.equal(await page.locator('.sheet .address').count(), 0, 'a file has no address for others');
	await page.goto(at('#play/maze'));
	await ready(page, 'play');
	await page.setInputFiles('input[type=file]', path.join(root, 'assets/bear.obj'));
	await page.waitForFunction(() => /Agents can have the shape “bear 2”.*keeps it/.test(document.querySelector('.controls .status').textContent));
	await press(page, 'Save a copy');
	await page.reload();
	await ready(page, 'play');
	assert.deepEqual(await page.evaluate(() => [document.querySelector('.title').value, globalThis.playground.modelShelf.names]), ['Maze (mine)', ['bear 2']]);
	assert.deepEqual(said, []);
	await page.context().close();
});

test('the page that is served leads to the file if it is opened by a double click', { skip }, async () => {
	const { page } = await newPage();
	await page.goto(`${pathToFileURL(path.join(root, 'bin/playground/index.html')).href}#play/maze`);
	await page.waitForURL(/starlogo-nova\.html#play\/maze$/);
	await ready(page, 'play');
	assert.equal(await page.inputValue('.title'), 'Maze');
	await page.context().close();
});

test('where the script does not arrive, the page says so', { skip }, async () => {
	const server = await serve(null, { '': path.join(root, 'bin/playground') });
	await Promise.all([[{}, `${server.url}index.html`], [{ javaScriptEnabled: false }, `${server.url}index.html`], [{ javaScriptEnabled: false }, at('')]].map(async ([options, address]) => {
		const { page } = await newPage(options);
		await page.route('**/main.js', (route) => route.abort());
		await page.goto(address);
		// its style makes it visible late
		assert.match(await page.evaluate(() => getComputedStyle(document.querySelector('.silent')).animation), /^appear\b.*\b3s\b|\b3s\b.*\bappear\b/, 'not while it may still come');
		await page.locator('.silent').waitFor({ state: 'visible' });
		assert.match(await page.textContent('.silent'), /has not started[^]*ist nicht gestartet/);
		await page.context().close();
	}));
	server.close();
});

test('the file has its own strict policy, and the licences of what is in it', () => {
	const html = readFileSync(path.join(root, 'bin/playground', NAME), 'utf8');
	const [, policy] = /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(html);
	assert.match(policy, /^default-src 'none'; script-src 'sha256-[^ ]+'; style-src 'sha256-[^ ]+'; img-src data:;/);
	assert.doesNotMatch(policy, /unsafe|https?:|\*|connect/);
	assert.match(html, /blockly 12[^]*Apache-2.0[^]*three 0\.[^]*MIT/);
});
