#!/usr/bin/env node
/**
 * Makes the moving picture of README.md: a small game, as four collision systems see it in turn.
 *
 *   node js/picture/run.mjs [FILE.webp]      after ./antw module; ./antw picture does both
 *
 * The page scene.js draws each frame in headless Chromium, which also compresses it; webp.mjs puts the frames into one file.
 */
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { launch } from '../../build/headless/browsers.mjs';
import { serve } from '../../build/headless/server.mjs';
import { animationOf } from './webp.mjs';

const MOST_BYTES = 1000000;
const MILLISECONDS = 100;

const at = (folder) => fileURLToPath(new URL(`../../${folder}`, import.meta.url));

const PAGE = `<!doctype html>
<script type="importmap">
{ "imports": {
	"starlogo-collision": "/module/starlogo-collision.min.js",
	"three": "/three/build/three.module.js",
	"three/addons/": "/three/examples/jsm/"
} }
</script>
<script type="module">
import { frames } from "/picture/scene.js";
window.pictures = frames();
</script>`;

const server = await serve(PAGE, {
	'/module': at('bin/module'), '/three': at('js/module/node_modules/three'), '/assets': at('assets'), '/picture': at('js/picture'),
});
const browser = await launch();
try {
	const page = await browser.newPage();
	page.on('pageerror', (error) => console.error(error));
	await page.goto(server.url);
	await page.waitForFunction(() => window.pictures);
	const pictures = [];
	for (let next; (next = await page.evaluate(async () => (await window.pictures.next()).value ?? null)); ) {
		pictures.push(Buffer.from(next.slice(next.indexOf(',') + 1), 'base64'));
	}
	const bytes = animationOf(pictures, MILLISECONDS);
	const file = process.argv[2] ?? at('docs/game.webp');
	writeFileSync(file, bytes);
	console.log(`written: ${file} (${pictures.length} frames, ${Math.round(bytes.length / 1024)} KB)`);
	if (bytes.length > MOST_BYTES) throw new Error(`the picture has ${bytes.length} bytes: more than ${MOST_BYTES}`);
} finally {
	await browser.close();
	server.close();
}
