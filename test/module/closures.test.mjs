/** What the functions of objects' methods keep in memory. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { $bound } from "../../js/standins/module/language.mjs";

setFlagsFromString("--expose-gc");
const collect = runInNewContext("gc");

class Work {
	numbers = new Array(10_000).fill(0.5);

	step() {
		return this;
	}
}

test("a method is the same function each time, of a frozen object too", () => {
	const [work, other] = [new Work(), Object.freeze(new Work())];
	assert.equal($bound(work, "step"), $bound(work, "step"));
	assert.equal($bound(other, "step")(), other);
	assert.equal($bound(other, "step"), $bound(other, "step"));
	assert.notEqual($bound(work, "step"), $bound(other, "step"));
	assert.deepEqual(Reflect.ownKeys(work), ["numbers"]);
});

test("an object whose method was taken goes with the next collection of young objects", () => {
	// so nothing of the first calls is young any more
	$bound(new Work(), "step");
	collect();
	collect();
	const before = process.memoryUsage().heapUsed;
	for (let i = 0; i < 50; i++) {
		$bound(new Work(), "step");
		collect({ type: "minor" });
	}
	const kept = process.memoryUsage().heapUsed - before;
	assert.ok(kept < 1e6, `${kept} bytes`);
});
