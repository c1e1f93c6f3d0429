/** Tests of the release, unpacked: bin/starlogo-collision-VERSION.zip and nothing else. */
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { strFromU8, unzipSync } from 'fflate';
import { NAME, ROOT, VERSION, inRoot } from '../../build/dist/project.mjs';
import { PATIENCE, launch } from '../../build/headless/browsers.mjs';
import { readSwf } from '../../build/headless/swf.mjs';
import { play } from '../../build/headless/player.mjs';
import { serve } from '../../build/headless/server.mjs';
import { mxmlc } from './flex.mjs';

const release = `${NAME}-${VERSION}`;
const archive = readFileSync(inRoot(`bin/${release}.zip`));
const folder = inRoot(`bin/dist-test/${release}`);
const pictures = inRoot('bin/dist-test');
const chrome = process.env.CHROME || '/usr/bin/chromium';
const files = new Map(Object.entries(unzipSync(archive)).map(([name, content]) => [name.slice(release.length + 1), Buffer.from(content)]));
const text = (name) => strFromU8(files.get(name));
const sha256 = (content) => createHash('sha256').update(content).digest('hex');

before(() => {
	rmSync(pictures, { recursive: true, force: true });
	for (const [name, content] of files) {
		mkdirSync(path.dirname(path.join(folder, name)), { recursive: true });
		writeFileSync(path.join(folder, name), content);
	}
});

test('its checksums are right, and there is one of every file', () => {
	assert.equal(readFileSync(inRoot(`bin/${release}.zip.sha256`), 'utf8'), `${sha256(archive)}  ${release}.zip\n`);
	const sums = new Map(text('SHA256SUMS').trim().split('\n').map((line) => line.split('  ').reverse()));
	assert.deepEqual([...sums.keys()].sort(), [...files.keys()].filter((name) => name !== 'SHA256SUMS').sort());
	for (const [name, sum] of sums) {
		assert.equal(sha256(files.get(name)), sum, name);
	}
});

test('everything is in it', () => {
	for (const name of ['swc/starlogo-collision.swc', 'swc/starlogo-collision-away3d.swc', 'module/package.json', 'module/index.d.ts', 'playground/index.html',
		'docs/asdoc/index.html', 'docs/typedoc/index.html', 'docs/typedoc/classes/index.Agent.html', 'docs/release.md', 'assets/bear.obj', 'assets/bear.obj.cooked', 'assets/manifest.json', 'assets/LICENSE', 'examples/client/Client.as', 'examples/index.html', 'examples/ray.html', 'examples/pictures/ray.webp', 'examples/flash/Sweeps.swf', 'examples/page/index.html', 'examples/three/index.html', 'examples/three/bear.glb', 'module/three/index.d.ts',
		'README.md', 'CHANGELOG.md', 'LICENSE', 'licences/README.md', 'sbom.cdx.json']) {
		assert.ok(files.get(name)?.length > 300, name);
	}
});

test('what its pages link to is in it', () => {
	let links = 0;
	for (const name of [...files.keys()].filter((each) => each.endsWith('.md'))) {
		for (const [, target] of text(name).matchAll(/(?:\]\(|^<tr><td><a href=")(?!\w+:|#)([^)#"]+)/gm)) {
			links++;
			const linked = path.posix.join(path.posix.dirname(name), target).replace(/\/$/, '');
			assert.ok([...files.keys()].some((each) => each === linked || each.startsWith(`${linked}/`)), `${name} links to ${target}`);
		}
	}
	assert.ok(links > 4);
});

test('it says nowhere where it was built', () => {
	const here = ROOT.slice(0, -1);
	for (const [name, content] of files) {
		assert.ok(!content.includes(here), name);
	}
	for (const name of [...files.keys()].filter((each) => each.endsWith('.swc'))) {
		const library = readSwf(Buffer.from(unzipSync(files.get(name))['library.swf']));
		assert.ok(library.tags.every(({ content }) => !content.includes(here)), name);
		assert.ok(library.tags.some(({ content }) => content.includes('/src;starlogo')), `${name} has the names of its sources for debuggers`);
	}
});

test('SWCs say which version they are, and under which licence', () => {
	for (const name of [...files.keys()].filter((each) => each.endsWith('.swc'))) {
		const entries = unzipSync(files.get(name));
		assert.equal(strFromU8(entries.VERSION), `${NAME} ${VERSION}\n`);
		assert.equal(strFromU8(entries.LICENSE), text('LICENSE'));
	}
});

test('nothing of others is in the SWCs', () => {
	for (const name of [...files.keys()].filter((each) => each.endsWith('.swc'))) {
		const catalog = strFromU8(unzipSync(files.get(name))['catalog.xml']);
		const defined = [...catalog.matchAll(/<def id="([^"]+)"/g)].map((match) => match[1]);
		assert.deepEqual(defined.filter((id) => !/^starlogo[.:]/.test(id) && !/^_[0-9a-f]{64}_flash_display_Sprite$/.test(id)), [], name);
		assert.ok(defined.length > 2);
	}
});

let browser;
before(async () => {
	browser = await launch();
});
after(() => browser.close());

test('the pages of both APIs open as files without script errors', async () => {
	const page = await browser.newPage();
	const errors = [];
	page.on('pageerror', (error) => errors.push(String(error)));
	const open = (name) => page.goto(pathToFileURL(path.join(folder, 'docs', name)).href, { waitUntil: 'load' });
	await open('asdoc/index.html');
	await open('typedoc/index.html');
	await open('typedoc/classes/index.Agent.html');
	assert.equal(await page.textContent('h1'), 'Class Agent');
	await open('asdoc/starlogo/bounding/Sphere.html');
	const rows = () => page.evaluate(() => [...document.querySelectorAll('#summaryTableProperty tr')].filter((row) => row.offsetHeight > 0).length);
	const own = await rows();
	await page.click('text=Show Inherited Public Properties');
	assert.ok(await rows() > own, 'inherited ones are shown');
	await page.click('text=Hide Inherited Public Properties');
	assert.equal(await rows(), own);
	assert.deepEqual(errors, []);
});

test('the example client compiles against the SWC alone, and runs', async () => {
	const client = path.join(folder, 'examples/client');
	const [, command] = /^ {4}mxmlc (.*)$/m.exec(text('examples/client/README.md').replaceAll(/\\\n */g, ''));
	mxmlc(command.split(' '), { cwd: client });
	const frames = await playUntil(path.join(client, 'client.swf'), 'frame 120:', path.join(pictures, 'client.png'));
	assert.equal(frames.filter((line) => line.startsWith('error')).length, 0, frames.join('\n'));
	const [, bumps, hits] = /(\d+) bumps, (\d+) hits/.exec(frames.at(-1)).map(Number);
	assert.ok(bumps > 10 && hits > 1, frames.at(-1));
	await assertIsDrawn(path.join(pictures, 'client.png'), ['223,232,207', '185,167,140']);
});

test('the example page runs on the module alone', async () => {
	const server = await serve(null, { '': folder });
	try {
		const page = await browser.newPage({ viewport: { width: 600, height: 480 } });
		const said = [];
		page.on('console', (message) => said.push(message.text()));
		page.on('pageerror', (error) => said.push(String(error)));
		page.on('request', (request) => request.url().startsWith(server.url) || request.url().startsWith('data:') || said.push(request.url()));
		await page.goto(`${server.url}examples/page/`);
		await page.waitForFunction(() => Number(/frame (\d+)/.exec(document.querySelector('output').textContent)?.[1]) >= 150);
		const [, turns, hits] = /(\d+) turns, (\d+) hits/.exec(await page.textContent('output')).map(Number);
		await page.screenshot({ path: path.join(pictures, 'page.png') });
		assert.deepEqual(said, []);
		assert.ok(turns > 20 && hits > 1, `${turns} turns, ${hits} hits`);
		await assertIsDrawn(path.join(pictures, 'page.png'), ['188,216,224', '185,167,140']);
	} finally {
		server.close();
	}
});

/** Plays a SWF until a line of what it traces begins with a text, and takes a picture then; gives all lines up to it. */
async function playUntil(swf, beginning, picture) {
	assert.ok(existsSync(swf));
	const lines = [];
	let player;
	let timer;
	try {
		await new Promise((resolve, reject) => {
			timer = setTimeout(() => reject(new Error(`no line begins with "${beginning}":\n${lines.join('\n')}`)), PATIENCE);
			const trace = (line) => lines.push(line) && line.startsWith(beginning) && resolve();
			play({ swf, chrome, parameters: { assets: '/assets' }, folders: { '/assets': path.join(folder, 'assets') }, width: 480, height: 360 },
				{ trace, error: reject, crash: reject, writeFile() {}, exit() {} }).then((started) => {
				player = started;
			}, reject);
		});
		await player.screenshot(picture);
	} finally {
		clearTimeout(timer);
		await player?.close();
	}
	return lines;
}

/** That a picture has many colours, and some that there must be in many places. */
async function assertIsDrawn(file, expected) {
	const page = await browser.newPage();
	const counts = await page.evaluate(async (data) => {
		const bitmap = await createImageBitmap(await (await fetch(data)).blob());
		const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
		context.drawImage(bitmap, 0, 0);
		const { data: pixels } = context.getImageData(0, 0, bitmap.width, bitmap.height);
		const colours = {};
		for (let i = 0; i < pixels.length; i += 4) {
			const colour = `${pixels[i]},${pixels[i + 1]},${pixels[i + 2]}`;
			colours[colour] = (colours[colour] ?? 0) + 1;
		}
		return colours;
	}, `data:image/png;base64,${readFileSync(file).toString('base64')}`);
	await page.close();
	assert.ok(Object.keys(counts).length > 500, `${Object.keys(counts).length} colours`);
	const isNear = (one, other) => one.split(',').every((value, i) => Math.abs(value - other.split(',')[i]) <= 3);
	for (const colour of expected) {
		const pixels = Object.keys(counts).filter((each) => isNear(each, colour)).reduce((sum, each) => sum + counts[each], 0);
		assert.ok(pixels > 1000, `${colour}: ${pixels} pixels`);
	}
}
