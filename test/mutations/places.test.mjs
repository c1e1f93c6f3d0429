/** Tests of what the mutations change. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { placesIn } from "./places.mjs";

const LINES = `class Other {
	isLess(a, b) {
		return a < b;
	}
}

class Part {
	constructor() {
		this.count = 3;
		this.time = Motion$NEVER;
	}
	isLess(a, b) {
		return a < b;
	}
	static get isMore() {
		return Part$isMore;
	}
}

function Part$isMore(a, b) {
	return a > b;
}

function Partial$isEqual(a, b) {
	return a == b;
}

function alone(a, b) {
	return a + b;
}`.split("\n");

const changesOf = (name) => placesIn(LINES, name).map(({ line, changed }) => `${LINES[line].trim()} ${changed.trim()}`);

test("a class's methods are changed, and the functions behind it, which are its static methods", () => {
	assert.deepEqual(changesOf("Part"), ["return a < b; return a <= b;", "return a > b; return a >= b;"]);
	assert.deepEqual(changesOf("alone"), ["return a + b; return a - b;", "return a + b; return a;"]);
	assert.deepEqual(changesOf("None"), []);
});
