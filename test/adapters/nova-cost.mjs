#!/usr/bin/env node
/**
 * What collisions cost the StarLogo Nova client, its own beside the engine's: the client's code in Node, where the environment's NOVA names its
 * folder. The fastest tenth, in milliseconds a tick (update of all, which all move, and getCollisions) and microseconds a question.
 *
 *   NOVA=... node test/adapters/nova-cost.mjs [system ...]
 */
import { installInto } from "../../bin/module/nova/index.js";
import { randomNumbers } from "../module/games.mjs";
import { loadEngine, makeAgents } from "./nova-real.mjs";

const systems = process.argv.length > 2 ? process.argv.slice(2) : ["bins"];
// other work on the machine makes times longer, never shorter
const typical = (list) => list.sort((a, b) => a - b)[Math.floor(list.length / 10)];
const random = randomNumbers(7);

function tickCost(window, agents, ticks) {
	const { Collisions } = window.Execution;
	const times = [];
	for (let tick = 0; tick < ticks; tick++) {
		for (const { state } of agents) {
			state.x = Math.min(50.5, Math.max(-50.5, state.x + random() - 0.5));
			state.y = Math.min(50.5, Math.max(-50.5, state.y + random() - 0.5));
		}
		const start = performance.now();
		for (const agent of agents) Collisions.update(agent);
		Collisions.getCollisions();
		times.push(performance.now() - start);
		window.Common.State.clock++;
	}
	return typical(times.slice(ticks >> 1));
}

function askCost(window, agents, question, radius) {
	const { Collisions } = window.Execution;
	const times = [];
	for (let round = 0; round < 60; round++) {
		const start = performance.now();
		for (const agent of agents) Collisions[question](agent, "Fish", radius);
		times.push((performance.now() - start) * 1000 / agents.length);
		window.Common.State.clock++;
	}
	return typical(times.slice(10));
}

const rows = [];
// the first is for the compiler
for (const count of [300, 100, 300, 1000, 3000]) {
	const window = loadEngine();
	const agents = makeAgents(window, count, random);
	const ticks = count > 1000 ? 60 : 200;
	const row = { agents: count, own: tickCost(window, agents, ticks) };
	for (const system of systems) {
		const installation = installInto(window, { system });
		row[system] = tickCost(window, agents, ticks);
		installation.uninstall();
	}
	rows.push(row);
}
const fixed = (row) => Object.fromEntries(Object.entries(row).map(([name, value]) => [name, typeof value === "number" && !Number.isInteger(value) ? Number(value.toFixed(3)) : value]));
console.table(rows.slice(1).map(fixed));

const window = loadEngine();
const agents = makeAgents(window, 1000, random);
const asks = [];
for (const question of ["count", "nearest"]) {
	for (const radius of [5, 20, 50]) {
		const own = askCost(window, agents, question, radius);
		const installation = installInto(window);
		asks.push({ question, radius, own, ours: askCost(window, agents, question, radius) });
		installation.uninstall();
	}
}
console.table(asks.map(fixed));
