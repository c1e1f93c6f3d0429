/** A game is saved by one call, and goes on in another process. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { SavedGame } from "./saved.mjs";

const FRAMES = 25;

test("a game goes on in another process as here, to the last bit, with agents created in another order", () => {
	const folder = mkdtempSync(path.join(tmpdir(), "saved-"));
	try {
		const game = new SavedGame();
		game.begin();
		game.run(25);
		const bytes = game.collision.snapshot(true);
		const file = path.join(folder, "game.json");
		writeFileSync(file, JSON.stringify({ frame: game.frame, bytes: Buffer.from(bytes).toString("base64") }));
		const expected = game.run(FRAMES);
		assert.ok(expected.filter((line) => line.startsWith("hit")).length > 40, expected.length);
		assert.ok(new Set(expected.filter((line) => line.startsWith("walk true")).map((line) => line.split(" ")[2])).size > 1, "they stand on several things");
		const found = execFileSync(process.execPath, [fileURLToPath(new URL("saved.mjs", import.meta.url)), file, String(FRAMES)], { encoding: "utf8" });
		assert.deepEqual(found.trimEnd().split("\n"), expected);

		game.frame = 25;
		game.collision.restore(bytes, game.agents);
		assert.deepEqual(game.run(FRAMES), expected, "and here");
	} finally {
		rmSync(folder, { recursive: true });
	}
});
