/** Walks over the ground and agents: how far, how high, whether they come to rest. */
import assert from "node:assert/strict";
import { prismsOf } from "../geometry.mjs";
import { bodiesOf } from "../shapes.mjs";
import { engine, HAIR } from "../tools.mjs";
import { gapToGround, heightsOf, spotOn, standing } from "./ground.mjs";

const { Footing, WalkOptions } = engine;

const OPTIONS = [
	{}, { stepHeight: 0 }, { stepHeight: 0.6, snap: 0.6 }, { slopeDegrees: 20 }, { slopeDegrees: 70 }, { snap: 0 }, { fall: 0 }, { fall: 0.05 }, { fall: 2 }, { fall: 0, snap: 0, stepHeight: 0 }, { fall: Infinity },
];

/** Walks until it has come to rest, at most. */
const LONGEST_REST = 120;

const placeOf = ({ x, y, z }) => [x, y, z];

/** The agents and the ground that touch an agent, by a system that has seen nothing. */
const touchedBy = (game, agent) => {
	const fresh = game.makeSystem();
	return game.others(agent).filter((other) => fresh.areColliding(agent, other));
};

/** How far an agent is from everything, at least. */
function gapOf(game, agent) {
	const away = Math.min(...game.agents.filter((other) => other !== agent).map((other) => game.queries.distance(agent, other)));
	const { terrain } = game.collision;
	const bodies = terrain && bodiesOf(game, agent);
	return Math.min(away, terrain ? bodies ? gapToGround(bodies, prismsOf(terrain, heightsOf(terrain))).least : game.queries.distance(agent, terrain.agent) : Infinity);
}

function walkOnce(game, agent, dx, dy, options, stood) {
	// what is below may have moved since another walk, and would carry it
	const asked = Object.assign(new WalkOptions(), { carried: false }, options);
	const before = placeOf(agent);
	const wasFree = touchedBy(game, agent).length === 0;
	// a longer walk goes in pieces, and may land meanwhile
	const isInAir = stood === false && Math.hypot(dx, dy) <= agent.size && gapOf(game, agent) > 1e-4 * agent.size;
	const footing = game.queries.walk(agent, dx, dy, asked, new Footing());
	const after = placeOf(agent);
	const text = `${agent} walked (${dx}, ${dy}) from ${before} with ${JSON.stringify(options)} in ${JSON.stringify(game.setting)}`;
	assert.ok(after.every(Number.isFinite) && footing.part >= 0 && footing.part <= 1 && footing.stands === (footing.on !== null), `walk: ${text}, part ${footing.part}`);
	assert.ok(Math.abs(Math.hypot(footing.normal.x, footing.normal.y, footing.normal.z) - 1) < HAIR, `walk: normal ${footing.normal}`);
	const whole = Math.hypot(dx, dy);
	const aside = Math.hypot(after[0] - before[0], after[1] - before[1]);
	const sank = before[2] - after[2];
	const small = 1e-7 * Math.max(1, agent.size);
	if (wasFree) {
		// it may fall from where it has gone up, and slides on what is steeper than it can stand on
		const slid = Math.min(asked.fall / 2, agent.size / 2, Math.max(0, sank) / Math.tan(asked.slopeDegrees * Math.PI / 180) + whole);
		game.expect("walk aside", aside <= whole + slid + small, `${text}, ${aside} aside, sank ${sank}`);
		const pieces = Math.min(64, Math.max(1, Math.ceil(whole / agent.size)));
		const climbed = isInAir ? 0 : pieces * asked.stepHeight + whole * Math.tan(asked.slopeDegrees * Math.PI / 180);
		game.expect(isInAir ? "walk in the air" : "walk up", -sank <= climbed + small, `${text}, up ${-sank}`);
		const touched = touchedBy(game, agent);
		if (touched.length > 0) {
			const fresh = game.makeSystem();
			const isFreeAbove = touched.every((other) => standing(agent, [0, 0, 2e-10 * agent.size], () => !fresh.areColliding(agent, other))) && standing(agent, [0, 0, 2e-10 * agent.size], () => touchedBy(game, agent).length === 0);
			game.expect("walk touches", !isFreeAbove, `${text}, and touches ${touched}`);
			const deepest = Math.max(...touched.map((other) => game.depthOf(fresh, agent, other)));
			game.expect("walk deep", deepest <= 5 * HAIR, `${text}, ${deepest} deep`);
		}
	}
	return footing;
}

/** An agent of the game, put above the ground if there is one. */
function begin(game, place, u, v, height) {
	if (game.agents.length < 2 || !game.known()) return null;
	const agent = game.at(place);
	const { terrain } = game.collision;
	if (terrain) {
		const [x, y, z] = spotOn(terrain, u, v);
		agent.jumpTo(x, y, z + height);
	}
	game.queries.update(game.agents);
	return agent;
}

export const walks = {
	stroll: {
		random: ({ integer, between, pick }) => [integer(99), between(-0.05, 1.05), between(-0.05, 1.05), pick([0, 0.001, 0.5, 2]), pick([0.01, 0.1, 0.3, 2]), between(0, 360), 1 + integer(12), integer(OPTIONS.length)],
		play(game, place, u, v, height, step, degrees, count, which) {
			const agent = begin(game, place, u, v, height);
			let stood;
			for (let i = 0; agent && i < count; i++) stood = walkOnce(game, agent, step * Math.cos(degrees * Math.PI / 180), step * Math.sin(degrees * Math.PI / 180), OPTIONS[which], stood).stands;
		},
	},
	rest: {
		random: ({ integer, between, pick }) => [integer(99), between(0, 1), between(0, 1), pick([0, 0.001, 0.2]), integer(OPTIONS.length)],
		play(game, place, u, v, height, which) {
			const agent = begin(game, place, u, v, height);
			if (!agent || !game.collision.terrain) return;
			let moved = Infinity;
			let sank = 0;
			let pushed = 0;
			for (let i = 0; i < LONGEST_REST && moved > 1e-7 * agent.size; i++) {
				const before = placeOf(agent);
				({ pushed } = walkOnce(game, agent, 0, 0, OPTIONS[which]));
				moved = Math.hypot(agent.x - before[0], agent.y - before[1], agent.z - before[2]);
				sank = before[2] - agent.z;
				// beside the ground, or over a pit, it falls and falls
				if (sank > 0.01 || agent.z < -3) i--;
				if (agent.z < -9) return;
			}
			// what is squeezed is pushed less and less, but again and again
			game.expect("walk rests", moved <= 1e-7 * agent.size || pushed > 0, `${agent} goes ${moved} at each walk(0, 0), sinks ${sank}, with ${JSON.stringify(OPTIONS[which])} in ${JSON.stringify(game.setting)}`);
		},
	},
	refused: {
		random: ({ integer, pick }) => [integer(99), pick([NaN, Infinity, 1e308, -1e200]), integer(4)],
		play(game, place, value, which) {
			if (game.agents.length === 0 || !game.known()) return;
			const agent = game.at(place);
			game.queries.update(game.agents);
			const before = placeOf(agent);
			const shape = agent.shape;
			const { land } = game;
			const tries = [
				() => game.queries.walk(agent, value, 0), () => game.queries.walk(agent, 0, value), () => game.queries.walk(agent, 0.5, 0, Object.assign(new WalkOptions(), { stepHeight: -value })),
				() => { agent.shape = "no such model"; game.queries.walk(agent, 0.5, 0); },
			];
			let problem = null;
			try {
				tries[which]();
			} catch (error) {
				problem = error;
			}
			agent.shape = shape;
			assert.ok(land.hasModel(shape));
			game.expect("walk refused", problem !== null && ["RangeError", "ArgumentError"].includes(problem.name), `${which}, ${value}: ${problem}`);
			assert.deepEqual(placeOf(agent), before, "a walk that was refused has moved");
		},
	},
};
