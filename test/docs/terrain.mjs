/** For docs/terrain.md: a bear in a hill, and a ball that comes down on it. */
import assert from 'node:assert/strict';
import * as game from './game.mjs';

export const collision = game.collision;
export const bear = game.bear;
export const ball = game.ball;
export const agents = game.agents;
ball.moveTo(-2, 1, 8);

/** Whether the samples have done what the page says. */
export function check({ terrain, hit, free, height, others, triangles, lines }) {
	assert.ok(Math.abs(bear.z - terrain.heightAt(bear.x, bear.y)) < 0.1, 'the bear has come out');
	assert.ok(triangles > 2 * 100 * 100 && lines.length > 0 && lines.length % 6 === 0);
	assert.deepEqual([hit.agent, hit.distance, others.length], [terrain.agent, 6, 0]);
	assert.ok(free > 0.4 && free < 0.6 && ball.x > -1 && height < 0.6);
}
