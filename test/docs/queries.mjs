/** For docs/queries.md: a wolf, its friend and some sheep, and a player on a lift. */
import assert from 'node:assert/strict';
import { engine } from './engine.mjs';

const { Agent, BuiltInModel, Collision, GreatLand, TightestFitCollider } = engine;
const greatLand = new GreatLand();
for (const model of [BuiltInModel.sphere(), BuiltInModel.box(2, 2, 1, 'lift'), BuiltInModel.capsule(0.3, 1.8, 'player')]) greatLand.addModel(model);
export const collision = new Collision(new TightestFitCollider(greatLand));
export const wolf = new Agent('sphere', 'wolves');
export const friend = new Agent('sphere', 'wolves');
export const agents = [wolf, friend];
for (let i = 1; i <= 9; i++) {
	const sheep = new Agent('sphere', i % 3 === 0 ? 'lambs' : 'sheep');
	sheep.moveTo(0.3 * i, 0, 0);
	sheep.size = i < 5 ? 1 : 0.5;
	agents.push(sheep);
}
export const lift = new Agent('lift', 'lifts');
export const player = new Agent('player', 'players');
lift.moveTo(0, 0, 0);
player.moveTo(-0.5, 0, 2.1);
export const actors = [lift, player];
export const seconds = 0;
export const delta = 0.02;
export const bindings = [{ updateObject: () => drawn.push(player.z) }];

const drawn = [];
let howls = 0;
let splashes = 0;
export const howl = () => howls++;
export const splash = () => splashes++;

/** Whether the samples have done what the page says. */
export async function check({ queries, prey, crowd, seen, pack, below, weaker, hit, hits, isInSight, camera, eye, bump, bumps, footing, stride, speed }) {
	assert.equal(howls, 1);
	assert.equal(prey, agents[2]);
	assert.deepEqual([crowd, seen.length, pack.length, hits.length, isInSight], [10, 9, 3, 9, false]);
	assert.equal(below.agent.shape, 'hero');
	assert.equal(weaker, agents[6]);
	assert.deepEqual([hit.distance, hit.agent], [0, agents[2]]);
	assert.ok(wolf.y > 0 && splashes === 1);
	assert.ok(camera.x <= eye.x && bump !== null && bumps.length > 0);
	assert.equal(speed, -43 * delta);
	// the lift carries the player, upwards, downwards and turning
	assert.equal(drawn.length, 1);
	queries.walk(player, 0, 0, { fall: Infinity }, footing);
	assert.ok(footing.on === lift && Math.abs(player.z - 2) < 1e-6, `${player.z}`);
	for (const [x, z, heading] of [[0, 2, 0], [1, 0.5, 0], [1, 0.5, 90]]) {
		lift.moveTo(x, 0, z);
		lift.heading = heading;
		queries.update(actors);
		queries.walk(player, 0, 0, stride, footing);
		assert.ok(footing.on === lift && Math.abs(player.z - z - 1) < 1e-6, `${player.z} above ${z}`);
	}
	assert.ok(player.heading === 90 && player.y < -0.4, `${player}`);
	// a filter, and carried
	const before = player.x;
	for (const options of [{ ...stride, carried: false }, { ...stride, filter: { except: [lift] } }]) {
		lift.moveTo(lift.x + 0.1, 0, 0.5);
		queries.update(actors);
		queries.walk(player, 0, 0, options, footing);
		assert.equal(player.x, before);
	}
}
