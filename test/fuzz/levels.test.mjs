/**
 * A few of the walks of levels.mjs.
 *
 * Checks starlogo.queries, starlogo.ground.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { walkLevels } from "./levels.mjs";

test("walks in a ground, in a mesh and over cubes are alike, go through nothing and are never stuck", () => {
	const { walks, ...wrong } = walkLevels(150, 1);
	assert.ok(walks >= 150);
	assert.deepEqual(wrong, { through: [], stuck: [], unlike: [] });
});
