/** What a frame leaves behind for the garbage collector in Node: nothing to speak of, once it is warm. What a question leaves: little. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { measure } from "./bytes.mjs";

// Bytes a frame: less than one an agent. A Number an agent would make 160,000.
const MOST = 8 * 1024;

const measured = measure("garbage.mjs");

test("the measure sees an object an agent", () => {
	assert.ok(measured.objects > 100000, `${measured.objects} bytes`);
});

test("moving agents makes no garbage", () => {
	assert.ok(Math.abs(measured.moving) < MOST, `${measured.moving} bytes a frame`);
});

test("turning agents makes no garbage", () => {
	assert.ok(Math.abs(measured.turning) < MOST, `${measured.turning} bytes a frame`);
});

for (const [name, bytes] of Object.entries(measured.frames)) {
	test(`a frame of ${name} makes no garbage`, () => {
		assert.ok(measured.pairs[name] > 10000, `${measured.pairs[name]} pairs: something happens`);
		assert.ok(bytes < MOST, `${bytes} bytes a frame`);
	});
}

// A Number for one agent in five.
const MOST_OF_A_SWEEP = 32 * 1024;

for (const [name, bytes] of Object.entries(measured.sweeps)) {
	test(`agents that sweep over the ground make no garbage: ${name}`, () => {
		assert.ok(measured.touches[name] > 1000 && measured.touches[name] < 9000, `${measured.touches[name]} touches: some agents touch the ground`);
		assert.ok(bytes < MOST_OF_A_SWEEP, `${bytes} bytes a frame`);
	});
}

// Bytes a question: V8 makes objects of some Numbers.
const MOST_OF_A_QUESTION = 1024;
const MOST_AMONG_PARTS = 4 * 1024;
// several motions, among the triangles of the ground; and a question with many answers
const MOST_OF = { walk: 4 * MOST_OF_A_QUESTION, castAgentAll: 2 * MOST_OF_A_QUESTION };

const systems = { bins: MOST_OF_A_QUESTION, "tightest fit": MOST_OF_A_QUESTION };
if (process.env.FULL_TESTS === "true") Object.assign(systems, { hierarchical: MOST_AMONG_PARTS, combination: MOST_AMONG_PARTS, triangles: MOST_AMONG_PARTS });

for (const [system, others] of Object.entries(systems)) {
	const mostOf = { ...MOST_OF, others };
	const { bytes, answers } = measure("questions.mjs", system, JSON.stringify(mostOf));
	for (const [name, left] of Object.entries(bytes)) {
		test(`${name} leaves little garbage: ${system}`, () => {
			assert.ok(answers[name] > 50, `${answers[name]} answers: something is found`);
			assert.ok(left / 10000 < (mostOf[name] ?? others), `${left / 10000} bytes a question`);
		});
	}
}
