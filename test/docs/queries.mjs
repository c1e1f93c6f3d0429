/** For docs/queries.md: whether its samples have done what the page says, and whether a lift carries a player in a walk as the page shows it. */
import assert from 'node:assert/strict';
import { engine } from './engine.mjs';

const { Agent, AgentQueries, BuiltInModel, GreatLand, TightestFitCollider } = engine;

export function check({ agents, prey, crowd, seen, pack, below, weaker, hit, hits, isInSight, camera, eye, free, bump, bumps, speed, footing, stride }) {
	const [wolf, friend, lamb] = agents;
	assert.deepEqual([prey, weaker, hit.agent, bump.agent], [lamb, lamb, lamb, friend]);
	assert.deepEqual([crowd, seen.length, pack.length, hits.length, bumps.length, isInSight], [6, 3, 3, 4, 2, false]);
	assert.equal(below.agent.shape, 'hero');
	assert.ok(free < 1 && wolf.y > 0 && camera.x < eye.x);
	assert.equal(speed, -43 / 60);
	checkLift(footing, stride);
}

/** The lift carries the player, upwards, downwards and turning, unless it is told not to. */
function checkLift(footing, stride) {
	const land = new GreatLand();
	for (const model of [BuiltInModel.box(2, 2, 1, 'lift'), BuiltInModel.capsule(0.3, 1.8, 'player')]) land.addModel(model);
	const queries = new AgentQueries(new TightestFitCollider(land));
	const [lift, player] = ['lift', 'player'].map((shape) => new Agent(shape));
	player.moveTo(-0.5, 0, 1.1);
	queries.update([lift, player]);
	queries.walk(player, 0, 0, { fall: Infinity }, footing);
	assert.ok(footing.on === lift && Math.abs(player.z - 1) < 1e-6, `${player.z}`);
	for (const [x, z, heading] of [[0, 2, 0], [1, 0.5, 0], [1, 0.5, 90]]) {
		lift.moveTo(x, 0, z);
		lift.heading = heading;
		queries.update([lift, player]);
		queries.walk(player, 0, 0, stride, footing);
		assert.ok(footing.on === lift && Math.abs(player.z - z - 1) < 1e-6, `${player.z} above ${z}`);
	}
	assert.ok(player.heading === 90 && player.y < -0.4, `${player}`);
	const before = player.x;
	for (const options of [{ ...stride, carried: false }, { ...stride, filter: { except: [lift] } }]) {
		lift.moveTo(lift.x + 0.1, 0, 0.5);
		queries.update([lift, player]);
		queries.walk(player, 0, 0, options, footing);
		assert.equal(player.x, before);
	}
}
