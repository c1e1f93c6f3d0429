/** For docs/motion.md: what it names and does not show. */
import assert from 'node:assert/strict';
import * as game from './game.mjs';
import { engine } from './engine.mjs';

export const collision = game.collision;
export const ball = game.ball;
export const agents = game.agents;
const calls = [];
export const splash = (point) => calls.push(point.z > 0 ? 'splash' : point);
export const bump = (bear, wall) => calls.push(`bump ${wall.breed}`);
export const walkOn = (...all) => calls.push(`walkOn ${all[2]}`);

/** Whether the samples have done what the page says. */
export function check() {
	const { bear } = game;
	const wall = new engine.Agent('sphere', 'walls');
	agents.push(wall);
	ball.moveTo(-3, 0, 0.4);
	collision.update(agents);
	ball.moveTo(3, 0, 0.4);
	wall.moveTo(5, 0, 0);
	collision.update(agents);
	assert.deepEqual(calls, ['bump walls', 'walkOn null', 'splash']);
	assert.deepEqual(agents, [bear, wall]);
	agents.push(ball);
	ball.jumpTo(49, 20, 0);
	ball.heading = 30;
	collision.update(agents);
	ball.moveTo(51, 20, 0);
	collision.update(agents);
	assert.ok(Math.abs((ball.heading + 720) % 360 - 150) < 1e-9, `${ball.heading}`);
}
