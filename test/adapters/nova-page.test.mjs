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
	{ system: "hierarchical", exact: true },
];
const options = { skip: NOVA ? false : "NOVA does not name the client's folder" };

let site;
const opened = new Map();
before(async () => {
	if (NOVA) site = await begin();
});
after(() => site?.close());

/**
 * In the page: sets the project up and runs it. Each answer is compared with brute force. Of the client's own collisions, those that depart
 * are counted, and with `mends` put right. A project may be `mixed`: everyone has a block for everyone, agents are born and die, and are asked who is
 * near. Gives what was counted, and a line for each tick of where all agents are.
 */
async function drive({ ticks, options, mends = false, mixed = false }) {
	const { AgentController, Collisions, Engine } = Execution;
	const { State } = Common;
	const installation = options ? StarLogoCollision.installInto(window, options) : null;
	const seen = { pairs: 0, again: 0, missed: 0, firstMissed: null, missedWithin: 0, extra: 0, counts: 0, wrongCounts: 0, nearests: 0, wrongNearests: 0, most: 0, born: 0, dead: 0 };
	const key = ({ a, b }) => `${a.id}-${b.id}`;
	const squared = (a, b) => (a.state.x - b.state.x) ** 2 + (a.state.y - b.state.y) ** 2 + (a.state.z - b.state.z) ** 2;
	const hasBlock = (a, b) => State.collidingBreeds.has(a.breed.id) && State.collidedBreeds.get(a.breed.id).includes(b.breed.id);
	// how far a model reaches from its place; the sphere, until it is loaded, not farther than 1
	let reach = 1;
	const isNear = (a, b) => squared(a, b) <= (reach * (a.state.size + b.state.size)) ** 2;
	const touch = !installation || options.system === "bins" ? (a, b) => squared(a, b) < (a.state.size + b.state.size) ** 2 / 4
		: (a, b) => isNear(a, b) && installation.areColliding(a, b);
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
		for (const [text, { a, b }] of expected) {
			if (found.has(text)) continue;
			seen.missed++;
			seen.firstMissed ??= State.clock;
			// the client bins nobody whose lower side is beyond its last bin
			if (![a, b].some(({ state: { x, y, size } }) => Math.max(x, y) - size / 2 >= 49.5)) seen.missedWithin++;
		}
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
		await setUp(() => {
			if (!mixed) return;
			const node = { yields: false };
			const ids = AgentController.getBreedIDs();
			State.collisionsOn = State.binningOn = true;
			State.collidingBreeds = new Set(ids);
			State.collidedBreeds = new Map(ids.map((id) => [id, ids]));
			State.collisionDict.get(AgentController.EVERYONE.id).set(AgentController.EVERYONE.id, node);
			State.jsFunctions.set(node, (agent) => {
				const chance = Helper.Utils.random();
				if (chance < 0.02 && alive().length > 15) agent.die();
				else if (chance < 0.04 && alive().length < 800) AgentController.spawn(agent, 1, agent.breed.name);
			});
		});
		if (mixed && alive().length < 100) {
			for (const agent of alive()) {
				agent.state.size *= 6;
				Collisions.update(agent);
			}
		}
		if (installation) {
			const { greatLand } = installation;
			const models = [...new Set(alive().map(({ state }) => state.shape))].filter((shape) => greatLand.hasModel(shape));
			seen.models = models.length;
			for (const structure of models.flatMap((name) => [greatLand.boundingStructures.tightestFit(name), greatLand.hierarchies.root(name).bounds])) {
				const extents = [0, 0, 0, 0, 0, 0];
				structure.extentsInto(extents);
				reach = Math.max(reach, Math.hypot(...[0, 2, 4].map((i) => Math.max(-extents[i], extents[i + 1]))));
			}
		}
		let known = new Set(alive().map((agent) => agent.id));
		for (let tick = 0; tick < ticks; tick++) {
			if (mixed && tick % 3 === 0) {
				const parent = alive()[tick % 7];
				AgentController.spawn(parent, 1, parent.breed.name);
				if (alive().length > 15) alive()[tick % 11].die();
			}
			globalThis.tick();
			const now = alive();
			for (let i = 0; mixed && i < 6; i++) {
				const agent = now[(tick * 31 + i * 17) % now.length];
				// of everyone the client's own may not end
				const name = installation && i % 2 ? "Everyone" : agent.breed.name;
				Collisions.count(agent, name, [5, 20, 50][i % 3]);
				Collisions.nearest(agent, name, [5, 20, 50][i % 3]);
			}
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

// the other two have no collision blocks and ask for nobody, so that they are driven with blocks for all as well
const GAMES = (NOVA ? PROJECTS : ["FishAlgae"]).flatMap((project) => (project === "FishAlgae" ? [{ project }] : [{ project }, { project, mixed: true }]));

for (const { project, mixed = false } of GAMES) {
	const name = mixed ? `${project}, all with blocks for all` : project;
	const run = async (context, settings) => {
		// some pages take a minute to open
		const { page, said } = opened.get(project) ?? await site.open(project);
		opened.set(project, { page, said });
		const result = await page.evaluate(drive, { ticks: TICKS, mixed, ...settings });
		assert.equal(result.problem, null);
		assert.deepEqual(said, []);
		context.diagnostic(`${JSON.stringify(settings)}: ${JSON.stringify(result.seen)}`);
		return result;
	};

	test(`${name}: ${TICKS} ticks with each system, each answer that of brute force`, options, async (context) => {
		for (const system of mixed || project === "FishAlgae" ? SYSTEMS : SYSTEMS.slice(0, 1)) {
			const { seen, problems } = await run(context, { options: system });
			assert.deepEqual([seen.again, seen.missed, seen.extra, seen.wrongCounts, seen.wrongNearests], [0, 0, 0, 0, 0]);
			assert.deepEqual(problems, []);
			assert.ok(seen.most >= 20);
			if (mixed) assert.ok(seen.pairs > 500 && seen.counts === 6 * TICKS && seen.nearests === 6 * TICKS && seen.born > 50 && seen.dead > 50);
			else if (project === "FishAlgae") assert.ok(seen.pairs > 5 && seen.counts > 10000 && seen.born > 50 && seen.dead > 50);
			if ((mixed || project === "FishAlgae") && system.system !== "bins") assert.ok(seen.models > 0);
		}
	});

	test(`${name}: the game with the client's own collisions, but for what departs, is the one with bins, tick for tick`, options, async (context) => {
		await run(context, {});
		const mended = await run(context, { mends: true });
		const bins = await run(context, { options: { system: "bins" } });
		const departs = bins.lines.findIndex((line, tick) => line !== mended.lines[tick]);
		// the clock is 1 in the first tick, or 2 where agents are there only then
		assert.ok(departs === -1 || (mended.seen.missed > 0 && departs + 2 >= mended.seen.firstMissed), `it departs at tick ${departs}, and the first pair is missed at ${mended.seen.firstMissed}`);
		context.diagnostic(`equal for ${departs === -1 ? bins.lines.length : departs} ticks`);
	});
}
