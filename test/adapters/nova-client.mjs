/** A small client with the interface of StarLogo Nova's that its collisions have, and random games in it. */
import { randomNumbers } from "../benchmark/games.mjs";

const HALF = 50.5;
const EVERYONE = { id: 1, name: "Everyone" };

/** A window with a client in it; its own collisions know all agents that were added, and look at each pair. */
export function makeWindow() {
	const breeds = new Map([["The World", { id: 0, name: "The World" }], ["Everyone", EVERYONE]]);
	const State = { clock: 0, collidingBreeds: new Set(), collidedBreeds: new Map() };
	const AgentController = {
		data: [], numAgents: 0, EVERYONE,
		getByName: (name) => breeds.get(name),
		scatterAllAgents() {},
	};
	const window = { Common: { State }, Helper: { Constants: { MAPSIZE: HALF }, Comparison: { equals: (a, b) => a === b } }, Execution: { AgentController } };
	const added = new Set();
	const Collisions = class {
		static bins = new Map();
		static calls = 0;
		static add(agent) {
			added.add(agent);
			agent.jbins = [[0, 0]];
		}
		static remove(agent) {
			added.delete(agent);
			agent.jbins = [];
		}
		static update(agent) {
			Collisions.remove(agent);
			Collisions.add(agent);
		}
		static getCollisions() {
			Collisions.calls++;
			return bruteCollisions(window);
		}
		static count(agent, name, radius, trait, value) {
			return within(window, agent, name, radius, trait, value).length;
		}
		static nearest(agent, name, radius, trait, value) {
			return within(window, agent, name, radius, trait, value)[0]?.agent ?? agent;
		}
		static empty(id) {
			return [...added].every((agent) => agent.breed.id !== id);
		}
		static reset() {
			added.clear();
		}
	};
	window.Execution.Collisions = Collisions;
	window.added = added;
	AgentController.scatterAllAgents = () => {
		for (const agent of alive(window)) Object.assign(agent.state, { x: (agent.id * 37) % 101 - HALF, y: (agent.id * 61) % 101 - HALF });
	};
	AgentController.addBreed = (name, id) => {
		breeds.set(name, { id, name });
		Collisions.bins.set(id, [[[]]]);
	};
	reset(window);
	return window;
}

/** Forgets all agents but the World, as the client does when a project is set up anew. */
export function reset({ Execution: { AgentController, Collisions } }) {
	Collisions.reset();
	AgentController.data = [{ id: 0, breed: { id: 0, name: "The World" }, state: { x: 0, y: 0, z: 0, size: 1, heading: 0 }, isDead: false, jbins: [], getTrait: () => undefined }];
	AgentController.numAgents = 1;
}

let lastId = 0;

/** A new agent, which nobody has been told of. */
export function hatch({ Execution: { AgentController } }, breedName, state) {
	const agent = {
		id: ++lastId,
		breed: AgentController.getByName(breedName),
		state: { x: 0, y: 0, z: 0, heading: 0, size: 1, color: 0, shape: "Sphere", ...state },
		isDead: false,
		jbins: [],
		getTrait(trait) {
			return this.state[trait];
		},
	};
	agent.prevState = { ...agent.state };
	AgentController.data[AgentController.numAgents++] = agent;
	return agent;
}

/** Takes the dead out of the list, the last into each's place. */
export function clearDead({ Execution: { AgentController } }) {
	const { data } = AgentController;
	for (let i = AgentController.numAgents - 1; i > 0; i--) {
		if (!data[i].isDead) continue;
		data[i] = data[--AgentController.numAgents];
		data[AgentController.numAgents] = undefined;
	}
}

/** The agents that live. */
export function alive({ Execution: { AgentController } }) {
	return AgentController.data.slice(1, AgentController.numAgents).filter((agent) => !agent.isDead);
}

/** All pairs that touch by the client's rule and have a block, each once. */
export function bruteCollisions(window) {
	const { collidingBreeds, collidedBreeds } = window.Common.State;
	const hasBlock = (a, b) => collidingBreeds.has(a.breed.id) && collidedBreeds.get(a.breed.id).includes(b.breed.id);
	const agents = alive(window).sort((a, b) => a.id - b.id);
	const pairs = [];
	for (let i = 0; i < agents.length; i++) {
		for (let j = i + 1; j < agents.length; j++) {
			const [a, b] = [agents[i], agents[j]];
			if (squaredDistance(a, b) < (a.state.size + b.state.size) ** 2 / 4 && (hasBlock(a, b) || hasBlock(b, a))) pairs.push({ a, b });
		}
	}
	return pairs;
}

/** The others of a breed within a radius, the nearest first, of equally near ones the smaller id. */
export function within(window, agent, name, radius, trait, value) {
	return alive(window)
		.filter((other) => other !== agent && (name === "Everyone" || other.breed.name === name) && (!trait || other.getTrait(trait) === value))
		.map((other) => ({ agent: other, squared: squaredDistance(agent, other) }))
		.filter(({ squared }) => squared <= Number(radius) ** 2)
		.sort((a, b) => a.squared - b.squared || a.agent.id - b.agent.id);
}

export function squaredDistance(a, b) {
	const dx = a.state.x - b.state.x;
	const dy = a.state.y - b.state.y;
	const dz = a.state.z - b.state.z;
	return dx * dx + dy * dy + dz * dz;
}

/** Pairs as text, in an order of their own. */
export function pairKeys(pairs) {
	return pairs.map(({ a, b }) => `${a.id}-${b.id}`).sort();
}

const NAMES = ["Fish", "Algae", "Shark"];

/**
 * A random game: in each tick agents move, grow, change their breed, are born and die one after the other, and ask in between; then collisions
 * are asked for, whose blocks move agents without a word, kill and ask. `check` is called with each answer: (what, got, expected).
 */
export function playGame(window, seed, ticks, check, { population = 60, spread = HALF } = {}) {
	const { Common: { State }, Execution: { AgentController, Collisions } } = window;
	const random = randomNumbers(seed);
	const between = (low, high) => low + (high - low) * random();
	const pick = (list) => list[Math.floor(random() * list.length)];
	const coordinate = () => (random() < 0.1 ? pick([-HALF, HALF, 0, 49.6, -40.5]) : random() < 0.1 ? Math.round(between(-5, 5)) : between(-spread, spread));
	const height = () => (random() < 0.3 ? between(-3, 3) : 0);
	const size = () => pick([0, 0, 1, 1, 1, 2, between(0, 6)]);
	NAMES.forEach((name, i) => AgentController.getByName(name) ?? AgentController.addBreed(name, i + 2));
	const chooseBlocks = () => {
		State.collidingBreeds = new Set();
		State.collidedBreeds = new Map();
		for (const id of [2, 3, 4]) {
			if (random() < 0.4) continue;
			State.collidingBreeds.add(id);
			State.collidedBreeds.set(id, random() < 0.2 ? [0, 1, 2, 3, 4] : [pick([2, 3, 4]), pick([2, 3, 4])]);
		}
	};
	const populate = () => {
		for (let i = 0; i < population; i++) Collisions.add(hatch(window, pick(NAMES), { x: coordinate(), y: coordinate(), z: height(), size: size() }));
	};
	const ask = (agent) => {
		const name = pick([...NAMES, "Everyone"]);
		const radius = pick([0, 1, 5, 20, 50, 142, between(0, 30), "12.5"]);
		const [trait, value] = random() < 0.3 ? ["size", 1] : [];
		const expected = within(window, agent, name, radius, trait, value);
		check("count", Collisions.count(agent, name, radius, trait, value), expected.length);
		check("nearest", Collisions.nearest(agent, name, radius, trait, value).id, (expected[0]?.agent ?? agent).id);
	};
	const step = (agent) => {
		const before = { ...agent.state };
		if (random() < 0.6) Object.assign(agent.state, random() < 0.1 ? { x: coordinate(), y: coordinate() } : { x: agent.state.x + between(-1, 1), y: agent.state.y + between(-1, 1) });
		if (random() < 0.1) agent.state.z = height();
		if (random() < 0.1) agent.state.size = size();
		if (random() < 0.3) ask(agent);
		if (random() < 0.02) Collisions.update(hatch(window, agent.breed.name, agent.state));
		if (random() < 0.03) agent.breed = AgentController.getByName(pick(NAMES));
		if (random() < 0.02) die(agent);
		if (!agent.isDead && ["x", "y", "size"].some((trait) => agent.state[trait] !== before[trait])) Collisions.update(agent);
	};
	const die = (agent) => {
		agent.isDead = true;
		Collisions.remove(agent);
	};
	populate();
	for (let tick = 0; tick < ticks; tick++) {
		if (tick % 10 === 0) chooseBlocks();
		if (random() < 0.02) {
			reset(window);
			populate();
		}
		const count = AgentController.numAgents;
		for (let i = 1; i < count; i++) if (!AgentController.data[i].isDead) step(AgentController.data[i]);
		if (random() < 0.05) {
			AgentController.scatterAllAgents();
			alive(window).slice(0, 5).forEach(ask);
		}
		const pairs = Collisions.getCollisions();
		check("pairs", pairKeys(pairs).join(" "), pairKeys(bruteCollisions(window)).join(" "));
		check("order in a pair", pairs.every(({ a, b }) => a.id < b.id), true);
		for (const { a, b } of pairs) {
			if (a.isDead || b.isDead) continue;
			if (random() < 0.3) Object.assign(a.state, { x: coordinate(), y: coordinate() });
			if (random() < 0.05) die(b);
			if (random() < 0.2) ask(b.isDead ? a : b);
		}
		for (const id of [2, 3, 4]) check("empty", Collisions.empty(id), alive(window).every((agent) => agent.breed.id !== id));
		clearDead(window);
		State.clock++;
	}
}
