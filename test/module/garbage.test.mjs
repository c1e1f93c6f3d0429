/** What a frame, and questions, leave behind for the garbage collector in Node: nothing to speak of, once it is warm. */
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

for (const [name, bytes] of Object.entries(measured.frames)) {
	test(`a frame of ${name} makes no garbage`, () => {
		assert.ok(measured.pairs[name] > 10000, `${measured.pairs[name]} pairs: something happens`);
		assert.ok(bytes < MOST, `${bytes} bytes a frame`);
	});
}

// Bytes in 10,000 questions, 620 of them the measure's own: an object for each would be 160,000.
const MOST_OF_QUESTIONS = 1024;

// What is asked seldom is compiled late: how hierarchies and triangles part.
const COMPILED_LATE = { moveUntilTouch: 32 * 1024, slide: 32 * 1024 };
const MORE = { hierarchical: COMPILED_LATE, combination: COMPILED_LATE, triangles: COMPILED_LATE };

const systems = ["bins", "tightest fit"];
if (process.env.FULL_TESTS === "true") systems.push("hierarchical", "combination", "triangles");

for (const system of systems) {
	const { bytes, answers } = measure("questions.mjs", system);
	for (const [name, left] of Object.entries(bytes)) {
		test(`${name} makes no garbage: ${system}`, () => {
			assert.ok(answers[name] > 50, `${answers[name]} answers: something is found`);
			assert.ok(left < (MORE[system]?.[name] ?? MOST_OF_QUESTIONS), `${left} bytes in 10,000 questions`);
		});
	}
}
