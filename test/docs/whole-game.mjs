/** For docs/whole-game.md: whether the game has gone as its comments say. */
import assert from 'node:assert/strict';

export function check({ hero, wall, hit, saved, purse, footing, agents }) {
	assert.deepEqual([purse, saved.purse, hero.x.toFixed(2), footing.stands], [2, 2, '6.00', true]);
	assert.deepEqual([hit.agent, hit.distance.toFixed(2)], [wall, '7.75']);
	assert.deepEqual(agents.map(({ breed }) => breed), ['heroes', 'walls', 'coins']);
}
