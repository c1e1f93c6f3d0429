#!/usr/bin/env node
/**
 * What collisions cost the StarLogo Nova client, its own beside the engine's: the client's code in Node, where the environment's NOVA names its
 * folder. Games of the same agents take turns, tick by tick; the fastest tenth, in milliseconds a tick (update of all, which all move, and
 * getCollisions) and microseconds a question, and how much of the client's own that is.
 *
 *   NOVA=... node test/adapters/nova-cost.mjs [system ...]
 */
import { installInto } from "../../bin/module/nova/index.js";
import { randomNumbers } from "../benchmark/games.mjs";
import { loadEngine, makeAgents } from "./nova-real.mjs";

const systems = process.argv.length > 2 ? process.argv.slice(2) : ["bins"];
// other work on the machine makes times longer, never shorter
const typical = (list) => list.sort((a, b) => a - b)[Math.floor(list.length / 10)];
const random = randomNumbers(7);

/** Games of as many agents in the same places: the client's own, and one for each system. */
function makeGames(count, systems) {
	const [own, ...others] = [null, ...systems].map((system) => {
		const window = loadEngine();
		const agents = makeAgents(window, count, random);
		if (system !== null) installInto(window, { system });
		return { name: system ?? "own", window, agents, times: [] };
	});
	const move = (far) => own.agents.forEach(({ state }, i) => {
		for (const axis of ["x", "y"]) state[axis] = Math.min(50.5, Math.max(-50.5, state[axis] + far * (random() - 0.5)));
		for (const { agents } of others) Object.assign(agents[i].state, { x: state.x, y: state.y });
	});
	return { games: [own, ...others], move };
}

/** Has each game do something in turn, and gives the times of each, per tick or question. */
function timesOf({ games, move }, rounds, act, scale) {
	for (let round = 0; round < rounds; round++) {
		move(1);
		for (const { window, agents, times } of games) {
			const start = performance.now();
			act(window.Execution.Collisions, agents);
			times.push((performance.now() - start) * scale);
			window.Common.State.clock++;
		}
	}
	const [own, ...others] = games.map(({ name, times }) => [name, typical(times.slice(times.length >> 2))]);
	return Object.fromEntries([own, ...others.flatMap(([name, time]) => [[name, time], [`${name} / own`, time / own[1]]])]
		.map(([name, value]) => [name, Number(value.toFixed(3))]));
}

const tick = (Collisions, agents) => {
	for (const agent of agents) Collisions.update(agent);
	Collisions.getCollisions();
};
// the first is for the compiler
const rows = [300, 100, 300, 1000, 3000].map((count) => ({ agents: count, ...timesOf(makeGames(count, systems), Math.min(1000, 200000 / count), tick, 1) }));
console.table(rows.slice(1));

console.table(["count", "nearest"].flatMap((question) => [5, 20, 50].map((radius) => {
	const ask = (Collisions, agents) => {
		for (const agent of agents) Collisions[question](agent, "Fish", radius);
	};
	const games = makeGames(1000, ["bins"]);
	for (const { window, agents } of games.games) for (const agent of agents) window.Execution.Collisions.update(agent);
	return { question, radius, ...timesOf({ ...games, move() {} }, 80, ask, 1) };
})));
