/** The package and the playground's views in Debian's WebKit, with -Dfull, where it is installed. */
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import net from 'node:net';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { serve } from '../../build/headless/server.mjs';
import { missing, openWebKit } from '../../build/headless/webkit.mjs';
import { root } from './browser.mjs';

const skip = process.env.FULL_TESTS === 'true' ? missing : 'only with -Dfull';
const SPACE = ' ';
const pictures = path.join(root, 'bin/webkit');

let site;
let page;
before(async () => {
	if (skip) return;
	mkdirSync(pictures, { recursive: true });
	site = await serve('<!doctype html><title>Empty</title>', { '/playground': path.join(root, 'bin/playground'), '/module': path.join(root, 'bin/module') });
	page = await openWebKit(await freePort());
	console.log(`WebKit ${page.version}`);
});
after(async () => {
	await page?.close();
	site?.close();
});

async function freePort() {
	const server = net.createServer();
	await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
	const { port } = server.address();
	await new Promise((resolve) => server.close(resolve));
	return port;
}

/** Opens a view, with what its address names, from then on with a list of what goes wrong in the page. */
async function open(view, argument = '') {
	await page.goto(site.url);
	await page.goto(`${site.url}playground/#${view}${argument}`);
	await page.until((name) => document.querySelector(`main[data-ready="${name}"]`) !== null, view);
	await page.evaluate(() => {
		globalThis.wrong = [];
		addEventListener('error', ({ message }) => wrong.push(message));
		addEventListener('unhandledrejection', ({ reason }) => wrong.push(String(reason)));
	});
}

async function end(view) {
	writeFileSync(path.join(pictures, `${view}.png`), await page.picture());
	assert.deepEqual(await page.evaluate(() => globalThis.wrong), []);
}

test('the package decides in WebKit what it decides in Node', { skip }, async () => {
	const game = async (url) => {
		const { Agent, BuiltInModel, Collision, GreatLand, HierarchicalCollider, TightestFitCollider } = await import(url);
		const land = new GreatLand();
		for (const model of [BuiltInModel.cube(), BuiltInModel.sphere(), BuiltInModel.cylinder()]) land.addModel(model);
		return [new TightestFitCollider(land), new HierarchicalCollider(land)].map((system) => {
			const agents = Array.from({ length: 300 }, (_, i) => new Agent(['cube', 'sphere', 'cylinder'][i % 3]));
			agents.forEach((agent, i) => Object.assign(agent, { heading: 37 * i, roll: 11 * i, size: 0.5 + i % 7 / 3 }));
			const collision = new Collision(system);
			const told = [];
			collision.onCollision('turtles', 'turtles', (a, b, contact) => told.push(a.id - agents[0].id, b.id - agents[0].id, contact.depth, contact.point.x));
			for (let frame = 0; frame < 20; frame++) {
				agents.forEach((agent, i) => agent.moveTo(i * 7 % 20 + frame / 9, i * 13 % 17 - frame / 7, i % 5 / 2));
				collision.update(agents);
			}
			return told;
		});
	};
	await page.goto(site.url);
	const inWebKit = await page.evaluate(game, `${site.url}module/starlogo-collision.js`);
	assert.ok(inWebKit.every((told) => told.length > 4000), inWebKit.map((told) => told.length).join());
	assert.deepEqual(inWebKit, await game(path.join(root, 'bin/module/starlogo-collision.js')));
});

test('Play: a game runs, is steered by keys, and counts', { skip }, async () => {
	await open('play', '/paintball');
	await page.click('button.primary');
	await page.evaluate(() => document.querySelector('.world').focus());
	const balls = () => /paintballs \d/.test(document.querySelector('main').innerText);
	assert.equal(await page.evaluate(balls), false);
	await page.press(SPACE, 600);
	await page.until(balls);
	await end('play');
});

test('Inspect: a model, its structures and their volumes', { skip }, async () => {
	await open('inspect');
	assert.match(await page.evaluate(() => document.querySelector('main').innerText), /\d\.\d{3}/);
	await end('inspect');
});

test('Compare: each system says what it sees, and all of a game', { skip }, async () => {
	await open('compare');
	const verdicts = await page.evaluate(() => document.querySelector('.verdicts').innerText);
	assert.match(verdicts, /\bcollision/i);
	assert.match(verdicts, /no collision/i);
	await end('compare');
});
