/**
 * A few of the walks of meshes.mjs.
 *
 * Checks starlogo.queries, starlogo.solid.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { boxBody, triangleBody, withExtents } from "./geometry.mjs";
import { isFreeWay, levelsIn, levelsOf, plainLevel, walkMeshes } from "./meshes.mjs";

const { MESHES } = process.env;

function expectNothing(levels, walkers, steps) {
	const { ends, through, stuck, afloat, ...counts } = walkMeshes(levels, walkers, 1, steps);
	assert.deepEqual({ through, stuck, afloat }, { through: [], stuck: [], afloat: [] });
	assert.equal(counts.walkers, walkers);
	assert.ok(counts.standing > counts.steps / 10 && counts.standing < counts.steps && counts.blocked > 0, JSON.stringify(counts));
	assert.deepEqual(walkMeshes(levels, walkers, 1, steps).ends, ends, "the same walks again");
	return counts;
}

test("a way is not free if a body on it meets a corner for a moment", () => {
	const level = plainLevel([triangleBody([[0.1, 0.1, -1], [0.1, 0.1, 1], [0.5, -0.3, 0]])]);
	const bodies = [
		boxBody([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0.01, 0.01, 0.01]),
		{ corners: [[0, 0, 0]], radius: 0.014 },
		{ corners: [[0, 0, -0.1], [0, 0, 0.1]], radius: 0.014 },
	].map(withExtents);
	for (const body of bodies) {
		assert.ok(!isFreeWay(level, body, [0.15, 0.15, 0], 1e-9), "over the edge");
		assert.ok(!isFreeWay(level, body, [0.145, 0.155, 0], 1e-9), "past its end");
		assert.ok(isFreeWay(level, body, [0.12, 0.18, 0], 1e-9), "beside it");
	}
});

test("walks in a fortress go through nothing, and are never stuck", () => {
	expectNothing(levelsOf(fileURLToPath(new URL("../../assets/fortress.obj", import.meta.url))), 20, 50);
});

test("walks in levels that others have made go through nothing, and are never stuck", { skip: !MESHES && "MESHES names no folder that has them" }, (t) => {
	const { walkers, steps } = expectNothing(levelsIn(MESHES), 40, 100);
	t.diagnostic(`${walkers} walkers, ${steps} steps`);
});
