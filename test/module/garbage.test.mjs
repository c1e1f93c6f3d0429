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

// How boxes overlap is found with Numbers that are passed from function to function.
const MORE = {
	bins: { moveUntilTouch: 6e5, slide: 6e5 },
	"tightest fit": { moveUntilTouch: 12e6, slide: 12e6 },
};

for (const [system, more] of Object.entries(MORE)) {
	const { bytes, answers } = measure("questions.mjs", system);
	for (const [name, left] of Object.entries(bytes)) {
		test(`${name} makes no garbage: ${system}`, () => {
			assert.ok(answers[name] > 50, `${answers[name]} answers: something is found`);
			assert.ok(left < (more[name] ?? MOST_OF_QUESTIONS), `${left} bytes in 10,000 questions`);
		});
	}
}
