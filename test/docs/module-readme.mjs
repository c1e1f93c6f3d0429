/** For js/module/README.md: what it names and does not show. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { serve } from '../../build/headless/server.mjs';

const assets = new URL('../../assets/', import.meta.url);
const read = (name) => readFileSync(new URL(name, assets));

const THREE = createRequire(new URL('../../js/module/package.json', import.meta.url))('three');
export const mesh = new THREE.Mesh(new THREE.BoxGeometry(2, 4, 2));
mesh.position.set(1, 2, 3);
const floor = new THREE.BoxGeometry(40, 1, 40).translate(0, -0.5, 0);
// thinner than a shot flies in a frame
const wall = new THREE.BoxGeometry(0.05, 5, 40).translate(15, 2.5, 0);
export const levelScene = new THREE.Group().add(...[floor, wall].map((geometry) => new THREE.Mesh(geometry)));
export const bearText = read('bear.obj').toString();
export const signal = new AbortController().signal;
export const file = new Blob([read('dragon.dae')]);

let finish;
const isComplete = new Promise((resolve) => {
	finish = resolve;
});
export const startGame = () => finish();

/** Its addresses are relative, as in a page; in Node a server of the assets makes them absolute. */
const server = await serve(null, { '/assets': assets.pathname });
const { fetch } = globalThis;
globalThis.fetch = (address, ...rest) => fetch(new URL(address, server.url), ...rest);

/** Whether the samples have done what the page says. */
export async function check({ bear, ball, collision, greatLand, teapot, nextFrame, actors, hero, footing, save, goBackTo, nextStep, runner, runners }) {
	const keys = { right: 1, forward: 0, isJumping: false };
	for (let i = 0; i < 20; i++) nextFrame(keys);
	assert.ok(footing.stands && Math.abs(hero.x - 1.6) < 1e-9 && Math.abs(hero.z) < 1e-6, `${hero.x}, ${hero.z}`);
	assert.equal(actors.length, 3);
	const saved = save();
	nextFrame({ ...keys, isJumping: true });
	for (let i = 0; i < 19; i++) nextFrame(keys);
	const after = [hero.x, hero.z, actors.length];
	assert.ok(hero.z > 1 && !footing.stands);
	goBackTo(saved);
	assert.ok(hero.x < 1.7 && hero.z < 1e-6);
	nextFrame({ ...keys, isJumping: true });
	for (let i = 0; i < 19; i++) nextFrame(keys);
	assert.deepEqual([hero.x, hero.z, actors.length], after);
	for (let i = 0; i < 60; i++) nextFrame(keys);
	assert.ok(footing.stands);
	nextFrame({ ...keys, isShooting: true });
	const shot = actors.at(-1);
	assert.deepEqual([shot.breed, shot.x], ['shots', hero.x]);
	for (let i = 0; i < 5; i++) nextFrame(keys);
	assert.ok(actors.includes(shot) && Math.abs(shot.x - hero.x) > 3);
	for (let i = 0; i < 12; i++) nextFrame(keys);
	assert.ok(!actors.includes(shot) && shot.x < 16, `${shot.x}`);
	assert.equal(runners.length, 3);
	for (let i = 0; i < 20; i++) nextStep(keys);
	assert.ok(footing.stands && Math.abs(runner.x - 1.6) < 1e-9 && Math.abs(runner.z) < 1e-6, `${runner.x}, ${runner.z}`);
	assert.equal(runners.length, 2);
	assert.deepEqual([teapot.x, teapot.y, teapot.z, teapot.size], [1, -3, 0, 2]);
	assert.equal(collision.statistics.handlerCalls, 1);
	assert.equal(bear.color, ball.color);
	await isComplete;
	globalThis.fetch = fetch;
	server.close();
	assert.ok(['bear', 'dragon', 'tree'].every((name) => greatLand.hasModel(name)));
	// the system that takes the bins' place knows the shapes of the agents that are there
	collision.update([bear, ball]);
}
