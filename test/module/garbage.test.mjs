/** What a frame leaves behind for the garbage collector in Node: nothing to speak of, once it is warm. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const game = path.join(path.dirname(fileURLToPath(import.meta.url)), "garbage.mjs");

// Bytes a frame: less than one an agent. A Number an agent would make 160,000.
const MOST = 8 * 1024;

/** Measures in a process of its own, whose young generation holds all that the frames make: no collection comes in between. */
const measured = JSON.parse(execFileSync(process.execPath, ["--expose-gc", "--min-semi-space-size=64", "--max-semi-space-size=64", game], { encoding: "utf8" }));

test("the measure sees an object an agent", () => {
	assert.ok(measured.objects > 100000, `${measured.objects} bytes`);
});

test("moving agents makes no garbage", () => {
	assert.ok(Math.abs(measured.moving) < MOST, `${measured.moving} bytes a frame`);
});

for (const [name, bytes] of Object.entries(measured.frames)) {
	test(`a frame of ${name} makes no garbage`, () => {
		assert.ok(measured.pairs[name] > 10000, `${measured.pairs[name]} pairs: something happens`);
		assert.ok(bytes < MOST, `${bytes} bytes a frame`);
	});
}
