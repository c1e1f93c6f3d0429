/** The examples in ActionScript: each SWF, which the build compiled against the SWC alone, in the embedded player on its page. */
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { folder, groups, isSwf } from '../../build/examples/list.mjs';
import { open, root, serveExamples } from '../../build/examples/site.mjs';
import { launch } from '../headless/browsers.mjs';

const examples = groups().flatMap((group) => group.examples).filter(({ name }) => isSwf(name));

/** What each says after so many frames: its numbers, and what has to hold of them. */
const SHOWN = {
	FirstCollision: [120, (touches) => touches > 100],
	Contacts: [60, (touches, deepest) => touches > 60 && deepest > 0 && deepest < 0.3],
	Sweeps: [120, (hits, passes, hitsWithout, passesWithout) => hits > 10 && passes === 0 && hitsWithout > 2 && passesWithout > 2],
	Questions: [60, (inFront, near) => inFront > 0 && near > 0],
	OwnModel: [60, (level) => level === 1],
};

let site;
let browser;
before(async () => {
	site = await serveExamples();
	browser = await launch(['--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage']);
});
after(async () => {
	await browser.close();
	site.close();
});

test('every example in ActionScript has an entry in the index and a SWF, and its page names the player that the project has', () => {
	const files = readdirSync(path.join(folder, 'flash')).filter((file) => file.endsWith('.as') && file !== 'Land.as').map((file) => file.replace('.as', ''));
	assert.deepEqual(files.sort(), Object.keys(SHOWN).sort());
	assert.deepEqual(examples.map(({ name }) => name).sort(), files);
	const [, version] = /ruffle@([\d.]+)/.exec(readFileSync(path.join(folder, 'flash/index.html'), 'utf8'));
	assert.equal(version, JSON.parse(readFileSync(path.join(root, 'package.json'))).devDependencies['@ruffle-rs/ruffle']);
});

for (const example of examples) {
	test(`${example.name} shows what it says`, { timeout: 120000 }, async () => {
		const [frames, isShown] = SHOWN[example.name];
		const page = await browser.newPage({ viewport: { width: 390, height: 700 } });
		const said = [];
		page.on('console', (message) => message.type() === 'error' && said.push(message.text()));
		page.on('pageerror', (error) => said.push(String(error)));
		page.on('request', (request) => request.url().startsWith(new URL('/', site.url)) || /^(data|blob):/.test(request.url()) || said.push(request.url()));
		page.setDefaultTimeout(100000);
		// its other ways to draw take seconds to begin without a graphics card
		await page.addInitScript(() => { globalThis.RufflePlayer = { config: { preferredRenderer: 'canvas' } }; });
		await open(page, site, example, frames);
		const text = await page.textContent('output');
		assert.ok(isShown(...(text.match(/\d+(\.\d+)?/g) ?? []).map(Number)), text);
		assert.equal(await page.title(), example.title);
		assert.ok(readFileSync(path.join(folder, example.file), 'utf8').includes(await page.textContent('pre')));
		assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'it is no wider than a phone');
		assert.deepEqual(said, []);
		await page.close();
	});
}
