/** The StarLogo Nova client's own projects in Chromium, where the environment's NOVA names its folder. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { begin } from "./nova-page.mjs";
import { NOVA, PROJECTS } from "./nova-real.mjs";

const TICKS = 500;
const SYSTEMS = [
	{ system: "bins" },
	{ system: "tightest" },
	{ system: "combination", breeds: { Fish: { hierarchical: true } } },
	{ system: "hierarchical", depth: 3 },
];
const options = { skip: NOVA ? false : "NOVA does not name the client's folder" };

let site;
before(async () => {
	if (NOVA) site = await begin();
});
after(() => site?.close());

/**
 * In the page: sets the project up and runs it. Each answer is compared with brute force. Of the client's own collisions, those that depart
 * are counted, and with `mends` put right. Gives what was counted, and a line for each tick of where all agents are.
 */
async function drive({ ticks, options, mends = false }) {
	const { AgentController, Collisions, Engine } = Execution;
	const { State } = Common;
	Helper.Utils.randomSeed = 42;
	Execution.Agent.idBase = 1;
	const installation = options ? StarLogoCollision.installInto(window, options) : null;
	const seen = { pairs: 0, again: 0, missed: 0, extra: 0, counts: 0, wrongCounts: 0, nearests: 0, wrongNearests: 0, most: 0, born: 0, dead: 0 };
	const alive = () => AgentController.data.slice(1, AgentController.numAgents).filter((agent) => !agent.isDead);
	const key = ({ a, b }) => `${a.id}-${b.id}`;
	const squared = (a, b) => (a.state.x - b.state.x) ** 2 + (a.state.y - b.state.y) ** 2 + (a.state.z - b.state.z) ** 2;
	const hasBlock = (a, b) => State.collidingBreeds.has(a.breed.id) && State.collidedBreeds.get(a.breed.id).includes(b.breed.id);
	const touch = !installation || options.system === "bins" ? (a, b) => squared(a, b) < (a.state.size + b.state.size) ** 2 / 4 : (a, b) => installation.areColliding(a, b);
	const given = { getCollisions: Collisions.getCollisions, count: Collisions.count, nearest: Collisions.nearest };
	Collisions.getCollisions = () => {
		const pairs = given.getCollisions();
		const found = new Map(pairs.map((pair) => [key(pair), pair]));
		const agents = alive().sort((a, b) => a.id - b.id);
		const expected = new Map();
		for (let i = 0; i < agents.length; i++) {
			for (let j = i + 1; j < agents.length; j++) {
				const [a, b] = [agents[i], agents[j]];
				if ((hasBlock(a, b) || hasBlock(b, a)) && touch(a, b)) expected.set(`${a.id}-${b.id}`, { a, b });
			}
		}
		seen.pairs += expected.size;
		seen.again += pairs.length - found.size;
		for (const [text] of expected) if (!found.has(text)) seen.missed++;
		for (const text of found.keys()) if (!expected.has(text)) seen.extra++;
		return mends ? [...found.values()] : pairs;
	};
	const others = (agent, name, radius, trait, value) => alive()
		.filter((other) => other !== agent && (name === "Everyone" || other.breed.name === name) && (!trait || Helper.Comparison.equals(other.getTrait(trait), value)))
		.map((other) => ({ other, far: squared(agent, other) }))
		.filter(({ far }) => far <= radius * radius)
		.sort((a, b) => a.far - b.far || a.other.id - b.other.id);
	Collisions.count = (agent, name, radius, ...rest) => {
		const got = given.count(agent, name, radius, ...rest);
		if (radius <= 142) {
			seen.counts++;
			const right = others(agent, name, radius, ...rest).length;
			if (got !== right) seen.wrongCounts++;
			if (mends) return right;
		}
		return got;
	};
	Collisions.nearest = (agent, name, radius, ...rest) => {
		const got = given.nearest(agent, name, radius, ...rest);
		const right = others(agent, name, radius, ...rest)[0]?.other ?? agent;
		seen.nearests++;
		if (got !== right) seen.wrongNearests++;
		return mends ? right : got;
	};
	const lines = [];
	let problem = null;
	try {
		const push = WidgetManager.getWidgetsByType(slnova.PushButtonWidget).map((widget) => widget.getName()).find((name) => /setup/i.test(name));
		const toggle = WidgetManager.getWidgetsByType(slnova.ToggleButtonWidget)[0].getName();
		State.pushedButtons.add(push);
		Engine.tick();
		if (installation) {
			// which asks for the models
			given.getCollisions();
			while (installation.pendingCount > 0) await new Promise((resolve) => setTimeout(resolve, 20));
			seen.models = [...new Set(alive().map(({ state }) => state.shape))].filter((shape) => installation.greatLand.hasModel(shape)).length;
		}
		let known = new Set(alive().map((agent) => agent.id));
		for (let tick = 0; tick < ticks; tick++) {
			State.toggledButtons.add(toggle);
			Engine.tick();
			const now = alive();
			const ids = new Set(now.map((agent) => agent.id));
			seen.most = Math.max(seen.most, now.length);
			for (const id of ids) if (!known.has(id)) seen.born++;
			for (const id of known) if (!ids.has(id)) seen.dead++;
			known = ids;
			lines.push(now.map(({ id, state }) => `${id} ${state.x} ${state.y} ${state.z} ${state.size} ${state.color}`).join("\n"));
		}
	} catch (error) {
		problem = String(error.stack);
	}
	for (const [name, method] of Object.entries(given)) Collisions[name] = method;
	installation?.uninstall();
	return { seen, lines, problem, problems: installation?.problems ?? [] };
}

for (const project of NOVA ? PROJECTS : ["FishAlgae"]) {
	test(`${project}: ${TICKS} ticks with each system, each answer that of brute force`, options, async (context) => {
		for (const system of SYSTEMS) {
			const { page, said } = await site.open(project);
			const { seen, problem, problems } = await page.evaluate(drive, { ticks: TICKS, options: system });
			context.diagnostic(`${system.system}: ${JSON.stringify(seen)}`);
			assert.equal(problem, null);
			assert.deepEqual([seen.again, seen.missed, seen.extra, seen.wrongCounts, seen.wrongNearests], [0, 0, 0, 0, 0]);
			assert.deepEqual([said, problems], [[], []]);
			assert.ok(seen.most >= 20);
			// the others have no collision blocks, and ask for nobody
			if (project === "FishAlgae") assert.ok(seen.pairs > 10 && seen.counts > 10000 && seen.born > 50 && seen.dead > 50 && (system.system === "bins" || seen.models > 0));
			await page.close();
		}
	});

	test(`${project}: the game with the client's own collisions, but for what departs, is the one with bins, tick for tick`, options, async (context) => {
		const run = async (settings) => {
			const { page } = await site.open(project);
			const result = await page.evaluate(drive, { ticks: TICKS, ...settings });
			await page.close();
			return result;
		};
		const own = await run({});
		const mended = await run({ mends: true });
		const bins = await run({ options: { system: "bins" } });
		context.diagnostic(`own: ${JSON.stringify(own.seen)}`);
		context.diagnostic(`own, mended: ${JSON.stringify(mended.seen)}`);
		const departs = bins.lines.findIndex((line, tick) => line !== mended.lines[tick]);
		assert.ok(departs === -1 || mended.seen.missed > 0, `it departs at tick ${departs}, and no pair was missed`);
		context.diagnostic(`equal for ${departs === -1 ? bins.lines.length : departs} ticks`);
	});
}
