/** For docs/snapshots.md: whether its samples have done what the page says. */
import assert from 'node:assert/strict';

export function check({ agents, list, text, speed }) {
	assert.ok(list.length === 2 && list.every((agent, i) => agent !== agents[i] && agent.breed === agents[i].breed), 'others of the same kind');
	assert.deepEqual([list[1].x, speed], [0, 0]);
	assert.ok(list[0].prey === list[1] && list[1].prey === undefined, 'who is named is one of the list');
	assert.ok(text.length > 300 && text.length < 600, `${text.length}`);
}
