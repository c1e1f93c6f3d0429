/**
 * A few of the walks of meshes.mjs.
 *
 * Checks starlogo.queries, starlogo.solid.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { levelsIn, levelsOf, walkMeshes } from "./meshes.mjs";

const { MESHES } = process.env;

function expectNothing(levels, walkers, steps) {
	const { ends, through, stuck, afloat, ...counts } = walkMeshes(levels, walkers, 1, steps);
	assert.deepEqual({ through, stuck, afloat }, { through: [], stuck: [], afloat: [] });
	assert.equal(counts.walkers, walkers);
	assert.ok(counts.standing > counts.steps / 10 && counts.standing < counts.steps && counts.blocked > 0, JSON.stringify(counts));
	assert.deepEqual(walkMeshes(levels, walkers, 1, steps).ends, ends, "the same walks again");
	return counts;
}

test("walks in a fortress go through nothing, and are never stuck", () => {
	expectNothing(levelsOf(fileURLToPath(new URL("../../assets/fortress.obj", import.meta.url))), 20, 50);
});

test("walks in levels that others have made go through nothing, and are never stuck", { skip: !MESHES && "MESHES names no folder that has them" }, (t) => {
	const { walkers, steps } = expectNothing(levelsIn(MESHES), 40, 100);
	t.diagnostic(`${walkers} walkers, ${steps} steps`);
});
