/**
 * Some of the games of kept.mjs; that command plays more.
 *
 * Checks starlogo.broadphase, starlogo.search, starlogo.handlers, starlogo.collision.
 */
import assert from "node:assert/strict";
import test from "node:test";
import { play } from "./kept.mjs";

test("a frame in which few agents have changed makes the calls of a frame that tests all agents, in their order", () => {
	let calls = 0, partial = 0;
	// in 64 the ground rises under agents that stand
	for (const seed of [...Array.from({ length: 25 }, (_, i) => i + 1), 64]) {
		const game = play(seed);
		calls += game.calls;
		partial += game.partial;
	}
	assert.ok(calls > 100000 && partial > 300, `${calls} calls, and ${partial} frames with fewer candidates`);
});
