/** For docs/terrain.md: whether its samples have done what the page says. The bear is in a hill, and the ball comes down on it. */
import assert from 'node:assert/strict';

export function check({ agents: [bear, ball], terrain, hit, free, height, others, triangles, lines }) {
	assert.ok(Math.abs(bear.z - terrain.heightAt(bear.x, bear.y)) < 0.1, 'the bear has come out');
	assert.ok(triangles > 2 * 100 * 100 && lines.length > 0 && lines.length % 6 === 0);
	assert.deepEqual([hit.agent, hit.distance, others.length], [terrain.agent, 6, 0]);
	assert.ok(free > 0.4 && free < 0.6 && ball.x > -1 && height < 0.6);
}
