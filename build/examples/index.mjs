#!/usr/bin/env node
/**
 * Takes a picture of each example as its page shows it, and writes the index: examples/pictures, and the cards in examples/index.html and
 * examples/README.md, in the order of EXAMPLES in examples/shared/page.js.
 *
 *   node build/examples/index.mjs            all pictures
 *   node build/examples/index.mjs ray exact  the pictures of some, and the cards
 *   node build/examples/index.mjs --cards    the cards alone
 */
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { launch } from '../headless/browsers.mjs';
import { thereIs } from '../nearest.mjs';
import { refuse } from '../refuse.mjs';
import { folder, groups, pages, WIDTH } from './list.mjs';
import { open, serveExamples } from './site.mjs';

/** The frame of which a picture is taken: when there is something to see. */
const FRAMES = 260;
const FRAMES_OF = {
	'first-collision': 200,
	bullet: 197,
	camera: 520,
	distance: 60,
	exact: 247,
	falling: 900,
	filters: 400,
	snapshot: 262,
	walk: 95,
	OwnModel: 400,
	Sweeps: 130,
};

async function takePictures(examples) {
	const site = await serveExamples();
	const browser = await launch();
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

const chosen = process.argv.slice(2).filter((each) => each !== '--cards');
const examples = groups().flatMap((group) => group.examples);
const names = examples.map(({ name }) => name);
const unknown = chosen.find((each) => !names.includes(each));
if (unknown) refuse(`there is no example ${unknown}${thereIs(unknown, [...names, '--cards'])}`);
const wanted = process.argv.length > 2 ? examples.filter(({ name }) => chosen.includes(name)) : examples;
if (wanted.length > 0) await takePictures(wanted);
for (const [name, text] of pages()) writeFileSync(path.join(folder, name), text);
