#!/usr/bin/env node
/**
 * What each collision system makes of the scattered game of the playground's Compare, over many frames: how often it is right, and what a frame
 * takes in Node. Prints the table of docs/choosing.md.
 *
 *   ./antw module && node test/docs/accuracy.mjs
 */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { read, root } from '../structure/sources.mjs';

const AGENTS = 150;
const FRAMES = 400;
const FILES = { bear: 'bear.obj', dragon: 'dragon.dae', fireman: 'fireman.dae', seagull: 'seagull.dae', fortress: 'fortress.obj', person: 'person.dae' };

const { buildSync } = createRequire(path.join(root, 'js/module/package.json'))('esbuild');
const out = path.join(root, 'bin/generated/accuracy.mjs');
buildSync({
	stdin: { contents: 'export * from "./compare/game.js"; export * from "starlogo-collision";', resolveDir: path.join(root, 'js/playground') },
	bundle: true, format: 'esm', outfile: out, logLevel: 'warning',
	alias: { 'starlogo-collision': path.join(root, 'bin/module', JSON.parse(read('bin/module/package.json')).exports['.'].default) },
});
const { BinCollider, ColladaModel, CombinationCollider, GreatLand, HierarchicalCollider, ObjModel, ScatteredGame, TightestFitCollider } = await import(pathToFileURL(out).href);

const greatLand = new GreatLand();
for (const [name, file] of Object.entries(FILES)) {
	const bytes = new Uint8Array(readFileSync(path.join(root, 'assets', file)));
	greatLand.addModel(file.endsWith('.obj') ? ObjModel.fromBytes(name, bytes) : ColladaModel.fromBytes(name, bytes));
}

const atDepth = (maxDepth) => Object.assign(new HierarchicalCollider(greatLand), { maxDepth });
const systems = {
	'BinCollider': new BinCollider(greatLand),
	'TightestFitCollider': new TightestFitCollider(greatLand),
	'CombinationCollider, every other agent hierarchical': new CombinationCollider(greatLand),
	'HierarchicalCollider, depth 1': atDepth(1),
	'HierarchicalCollider, depth 3': atDepth(3),
	'HierarchicalCollider, depth 5': atDepth(5),
	'HierarchicalCollider, depth 10': atDepth(10),
	'HierarchicalCollider, exact': Object.assign(new HierarchicalCollider(greatLand), { exact: true }),
};

/** The pairs that a system finds, as keys. */
function keysOf(found) {
	const keys = new Set();
	for (let i = 0; i < found.length; i += 2) {
		keys.add([found[i].id, found[i + 1].id].sort((a, b) => a - b).join());
	}
	return keys;
}

const sums = Object.fromEntries(Object.keys(systems).map((name) => [name, { found: 0, right: 0, times: [] }]));
const game = new ScatteredGame(AGENTS);
let truths = 0;
for (let frame = 0; frame < FRAMES; frame++) {
	game.step();
	const truth = keysOf(systems['HierarchicalCollider, exact'].findCollisions(game.agents));
	truths += truth.size;
	for (const [name, system] of Object.entries(systems)) {
		// what the one before moved is looked at anew
		game.agents.forEach((agent) => agent.jumpTo(agent.x, agent.y, agent.z));
		const start = performance.now();
		const found = system.findCollisions(game.agents);
		sums[name].times.push(performance.now() - start);
		const keys = keysOf(found);
		sums[name].found += keys.size;
		sums[name].right += [...keys].filter((key) => truth.has(key)).length;
	}
}

console.log(`${AGENTS} agents, ${FRAMES} frames, ${truths} pairs that touch; Node ${process.versions.node}`);
console.log('| system | found | false | missed | precision | recall | ms a frame |');
for (const [name, { found, right, times }] of Object.entries(sums)) {
	const median = times.sort((a, b) => a - b)[FRAMES / 2];
	const percent = (part, whole) => `${Math.round((100 * part) / whole)} %`;
	console.log(`| ${name} | ${found} | ${found - right} | ${truths - right} | ${percent(right, found)} | ${percent(right, truths)} | ${median.toFixed(3)} |`);
}
