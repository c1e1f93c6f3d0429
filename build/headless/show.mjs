#!/usr/bin/env node
/**
 * Serves a page with a SWF in Ruffle on loopback, for a browser on this machine, until it is interrupted.
 *
 *   node build/headless/show.mjs file.swf [options]
 *
 *   --param name=value      a value in loaderInfo.parameters (may be repeated)
 *   --mount /path=folder    a folder that the SWF can load from (may be repeated)
 */
import { createRequire } from 'node:module';
import path from 'node:path';
import { refuse } from '../refuse.mjs';
import { parsed, requireSwf } from './arguments.mjs';
import { serve } from './server.mjs';

async function given() {
	const all = parsed();
	await requireSwf(all.swf);
	return all;
}

const { swf, parameters, folders } = await given().catch(({ message }) => refuse(`show: ${message}`));
const ruffle = path.dirname(createRequire(import.meta.url).resolve('@ruffle-rs/ruffle'));
const movie = { url: `/swf/${path.basename(swf)}`, parameters, autoplay: 'on', unmuteOverlay: 'hidden', splashScreen: false };

const page = `<!doctype html>
<html lang="en">
<head><meta charset="utf-8"><title>${path.basename(swf, '.swf')}</title><link rel="icon" href="data:,">
<style>html, body { margin: 0; height: 100%; overflow: hidden; background: #16301c; } ruffle-player { display: block; width: 100vw; height: 100vh; }</style>
</head>
<body><script src="/ruffle/ruffle.js"></script>
<script>
addEventListener('load', () => {
	const player = window.RufflePlayer.newest().createPlayer();
	document.body.append(player);
	(player.ruffle ? player.ruffle() : player).load(${JSON.stringify(movie).replaceAll('<', '\\u003c')});
});
</script></body>
</html>`;

const server = await serve(page, { '/ruffle': ruffle, '/swf': path.dirname(path.resolve(swf)), ...folders });
console.log(`open ${server.url} in a browser; Ctrl-C ends it`);
