/** Snapshots: back to a frame, and the same again; on to another Collision, and the same there. */
import assert from "node:assert/strict";
import { engine } from "../tools.mjs";

const { Agent, ByteArray, Collision, Terrain } = engine;

/** A snapshot goes into the ground that it is of: as many heights, as far apart. */
function checkOtherGround(game, bytes, listed) {
	const { terrain } = game.collision;
	if (!terrain) return;
	const { columns, rows, cellWidth, x, y } = terrain;
	for (const other of [null, new Terrain(columns + 1, rows, cellWidth, x, y), new Terrain(columns, rows, 2 * cellWidth, x, y)]) {
		game.collision.terrain = other;
		let problem = null;
		try {
			game.collision.restore(bytes, listed);
		} catch (error) {
			problem = error;
		}
		game.expect("snapshot of other ground", problem?.name === "ArgumentError", `${problem}`);
	}
	game.collision.terrain = terrain;
}

export const snapshots = {
	/** The frame goes on in another Collision, whose agents and ground are new: they write the same bytes. */
	elsewhere: {
		random: () => [],
		play(game) {
			if (!game.known()) return;
			game.frame();
			if (!game.known()) return;
			const { terrain, bounds, lastAgents } = game.collision;
			const bytes = game.collision.snapshot(true);
			const other = new Collision(game.makeSystem());
			other.terrain = terrain && new Terrain(terrain.columns, terrain.rows, terrain.cellWidth, terrain.x, terrain.y);
			other.bounds = bounds;
			other.restore(bytes, lastAgents.map(() => new Agent("sphere")));
			assert.deepEqual(other.snapshot(true), bytes, "another Collision writes other bytes");
		},
	},
	/** A snapshot, some frames of motion, back, and the same again. */
	rewind: {
		random: ({ integer, between }) => [1 + integer(5), between(0, 0.3)],
		play(game, frames, step) {
			const listed = [...game.agents];
			game.frame();
			// after a reset there is no frame to go back to
			if (game.isReset || !listed.every(({ shape }) => game.land.hasModel(shape))) return;
			const staying = [...game.agents];
			const before = game.traits(listed);
			const setting = { ...game.setting };
			const bytes = game.collision.snapshot();
			const models = game.modelChanges;
			const grounds = game.groundChanges;
			const runOn = () => {
				const all = [];
				for (let i = 0; i < frames; i++) {
					game.agents.forEach((agent, k) => agent.moveTo(agent.x + step * ((k + i) % 3 - 1), agent.y + step * ((k * 7 + i) % 5 - 2), agent.z));
					all.push(JSON.stringify(game.frame()));
				}
				return all.join("\n");
			};
			const first = runOn();
			// what has changed the models or the system can't be taken back
			if (JSON.stringify(setting) !== JSON.stringify(game.setting) || models !== game.modelChanges || grounds !== game.groundChanges) return;
			game.agents = staying;
			game.putBack(listed, before);
			const bad = new ByteArray(bytes);
			bad.length = Math.max(0, bad.length - 1 - frames);
			assert.throws(() => game.collision.restore(bad, listed), /no snapshot/);
			checkOtherGround(game, bytes, listed);
			game.collision.restore(bytes, listed);
			assert.equal(runOn(), first, "after a restore it is not the same");
		},
	},
};
