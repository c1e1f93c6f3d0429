/** Some of the games of ./antw fuzz, the same ones every time. No time that a game takes is judged here. */
import assert from "node:assert/strict";
import test from "node:test";
import { problemOf } from "./game.mjs";
import { OPEN } from "./open.mjs";
import { gameOf } from "./random.mjs";

const KINDS = {
	"all kinds of calls": { games: 15, kinds: null },
	"places on the ground and at the edges": { games: 60, kinds: ["add", "model", "parts", "trait", "trait", "system", "ground", "edges", "stand", "stand", "stand", "beside"] },
	"insides of models with several parts": { games: 3, kinds: ["inside"] },
};

OPEN.add("points cost");
for (const [name, { games, kinds }] of Object.entries(KINDS)) {
	test(`random games have the answers of loops, of plain geometry and of systems that have seen nothing: ${name}`, () => {
		for (let seed = 1; seed <= games; seed++) assert.equal(problemOf(gameOf(seed, kinds)), null, `seed ${seed}`);
	});
}
