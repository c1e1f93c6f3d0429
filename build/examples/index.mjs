#!/usr/bin/env node
/**
 * Takes a picture of each example as its page shows it, and writes the index: examples/pictures, and the cards in examples/index.html and
 * examples/README.md, in the order of EXAMPLES in examples/shared/page.js.
 *
 *   node build/examples/index.mjs            all pictures
 *   node build/examples/index.mjs ray exact  the pictures of some, and the cards
 *   node build/examples/index.mjs --cards    the cards alone
 */
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch } from '../../test/headless/browsers.mjs';
import { root, serveExamples } from './site.mjs';

/** The frame of which a picture is taken: when there is something to see. */
const FRAMES = 260;
const FRAMES_OF = { 'first-collision': 200, bullet: 197, distance: 60, exact: 247, falling: 900, filters: 400, snapshot: 262, OwnModel: 400, Sweeps: 130 };
const WIDTH = 480;
const CARDS = /(<!-- cards: .*-->\n)[^]*(<!-- end of cards -->)/;

export const folder = path.join(root, 'examples');
export const isSwf = (name) => /^[A-Z]/.test(name);

/** All examples by groups: the name of each with its title and its sentence, which its own file has. */
export function groups() {
	const [, list] = /const EXAMPLES = (\{[^]*?\n\});/.exec(readFileSync(path.join(folder, 'shared/page.js'), 'utf8'));
	const all = JSON.parse(list.replaceAll(/,(\s*[\]}])/g, '$1'));
	return Object.entries(all).map(([group, names]) => ({ group, examples: names.map((name) => ({ name, ...saidOf(name) })) }));
}

function saidOf(name) {
	if (isSwf(name)) {
		const [, title, sentence] = /\/\*\*\s*(.*?): ([^]*?)\s*\*\//.exec(readFileSync(path.join(folder, `flash/${name}.as`), 'utf8'));
		return { title, sentence: sentence.replaceAll(/\s*\n\s*\* ?/g, ' '), address: `flash/index.html?${name}`, file: `flash/${name}.as` };
	}
	const text = readFileSync(path.join(folder, `${name}.html`), 'utf8');
	return { title: /<title>(.*)<\/title>/.exec(text)[1], sentence: /<p>([^]*?)<\/p>/.exec(text)[1].replaceAll('\n', ' '), address: `${name}.html`, file: `${name}.html` };
}

/** The index's two pages as they should be. */
export function pages() {
	const all = groups();
	const html = all.map(({ group, examples }) => `<h2>${group}</h2>\n<ul class="cards">\n${examples.map(({ name, title, sentence, address }) =>
		`<li><a href="${address}"><img src="pictures/${name}.webp" alt="" width="${WIDTH}" height="${(WIDTH * 2) / 3}" loading="lazy"><strong>${title}</strong><span>${sentence}</span></a></li>\n`).join('')}</ul>\n`);
	const markdown = all.map(({ group, examples }) => `## ${group}\n\n| | |\n|---|---|\n${examples.map(({ name, title, sentence, file }) =>
		`| [<img src="pictures/${name}.webp" alt="${title}" width="240">](${file}) | [${title}](${file})<br>${sentence.replaceAll('. ', '.<br>')} |\n`).join('')}`);
	const filled = (file, cards) => readFileSync(path.join(folder, file), 'utf8').replace(CARDS, (_, begin, end) => `${begin}${cards}${end}`);
	return new Map([['index.html', filled('index.html', html.join(''))], ['README.md', filled('README.md', `\n${markdown.join('\n')}\n`)]]);
}

/** Opens an example, of which so many frames have been. */
export async function open(page, site, { name, address }, frames) {
	await page.goto(`${site.url}${address}${address.includes('?') ? '&' : '?'}frames=${frames}`);
	await page.waitForFunction((wanted) => Number(document.documentElement.dataset.frame) >= wanted, frames);
	return name;
}

async function takePictures(examples) {
	const site = await serveExamples();
	const browser = await launch(['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage']);
	try {
		for (const example of examples) {
			const page = await browser.newPage({ viewport: { width: WIDTH + 34, height: 700 }, colorScheme: 'light' });
			await open(page, site, example, FRAMES_OF[example.name] ?? FRAMES);
			const png = await page.locator('.picture > :first-child').screenshot();
			const webp = await page.evaluate(async ([data, width]) => {
				const bitmap = await createImageBitmap(await (await fetch(data)).blob());
				const canvas = Object.assign(document.createElement('canvas'), { width, height: (width * 2) / 3 });
				canvas.getContext('2d').drawImage(bitmap, 0, 0, canvas.width, canvas.height);
				return canvas.toDataURL('image/webp', 0.8);
			}, [`data:image/png;base64,${png.toString('base64')}`, WIDTH]);
			writeFileSync(path.join(folder, `pictures/${example.name}.webp`), Buffer.from(webp.split(',')[1], 'base64'));
			await page.close();
		}
	} finally {
		await browser.close();
		site.close();
	}
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
	const chosen = process.argv.slice(2);
	await takePictures(groups().flatMap(({ examples }) => examples).filter(({ name }) => chosen.length === 0 || chosen.includes(name)));
	for (const [name, text] of pages()) writeFileSync(path.join(folder, name), text);
}
