/** What takes the place of the client's Collisions. */
import { Agent, BinCollider, Collision, CombinationCollider, GreatLand, HierarchicalCollider, TightestFitCollider } from "starlogo-collision";
import { Blocks } from "./blocks.js";
import { Cells } from "./cells.js";
import { Entry, firstSharedBin } from "./entry.js";
import { SPHERE, Shapes } from "./shapes.js";

const SYSTEMS = { bins: BinCollider, tightest: TightestFitCollider, hierarchical: HierarchicalCollider, combination: CombinationCollider };

/** More than the rounding of places and sizes: pairs that may touch by the client's rule are all found, and then tested by it. */
const MARGIN = 1e-9;

/** Beyond this coordinate agents take no part: half of a size away an Agent can still be. */
const FARTHEST = Agent.LARGEST_COORDINATE - Agent.LARGEST_SIZE;

/** A key has the turn in its lower part; no game is updated so often. */
const TURNS = 2 ** 36;

/** The id of the breed that stands for all. */
const EVERYONE = 1;

/** How many breeds a key has room for. */
const RANKS = 128;

/** Traits that no block of the client sets. */
const NO_TRAITS = Object.freeze({});

/** The names of the traits that an option may have. */
const TRAITS = ["hierarchical", "depth", "sweeps", "structure"];

/** Collisions of a client that runs in a window, by the engine. */
export class NovaCollisions {
	#execution;
	#state;
	#equals;
	#half;
	#options;
	#entries = new Set();
	#cells;
	#turn = 0;
	#greatLand = new GreatLand();
	#shapes;
	#isBins;
	#collider;
	#collision;
	#blocks;
	#bodies = [];
	#ghost = new Agent(SPHERE);
	#found = [];
	#isSwept = false;
	// the tick in which all places were read last, and the one whose collisions were found last, by pairs of which agents may move
	#tick = NaN;
	#collidedIn = NaN;
	#suspects = [];
	#breedTraits = new Map();
	#agentTraits = new WeakMap();

	/** Of a window's client, whose agents are added later; for the options see installInto. */
	constructor(window, options) {
		this.#execution = window.Execution;
		this.#state = window.Common.State;
		this.#equals = window.Helper?.Comparison?.equals ?? Object.is;
		this.#half = window.Helper?.Constants?.MAPSIZE ?? 50.5;
		this.#cells = new Cells(this.#half);
		this.#blocks = new Blocks(this.#state, (a, b) => this.#onPair(a.entry, b.entry));
		this.#use(options);
		this.#shapes = new Shapes(this.#greatLand, window, { own: options.shapes, manifest: options.manifest });
	}

	/** The options that count. */
	get options() {
		return this.#options;
	}

	/** What decides, one of the engine's colliders. */
	get collider() {
		return this.#collider;
	}

	/** The models. */
	get greatLand() {
		return this.#greatLand;
	}

	/** The shapes of the client. */
	get shapes() {
		return this.#shapes;
	}

	/** All places are read again before the next question. */
	forgetPlaces() {
		this.#tick = NaN;
	}

	/**
	 * Calls a function for each agent that takes part: with an agent of the engine that is where it would be compared, so far on its way from
	 * its place in the last tick, and whether the last getCollisions found it in a pair.
	 */
	forEachBody(part, call) {
		const { data, numAgents } = this.#execution.AgentController;
		const hit = new Set(this.#found.flatMap(({ a, b }) => [a, b]));
		const ghost = this.#ghost;
		this.#blocks.read(this.#collision);
		for (let i = 1; i < numAgents; i++) {
			const entry = this.#participant(data[i]);
			if (entry === null) continue;
			const { agent, body } = entry;
			const state = part < 1 && agent.prevState ? between(agent.prevState, agent.state, part) : agent.state;
			if (!this.#pose(ghost, state)) continue;
			ghost.hierarchical = body.hierarchical;
			ghost.traversalDepth = body.traversalDepth;
			ghost.collideAs = body.collideAs;
			ghost.moveTo(state.x, state.y, this.#isBins ? state.z - ghost.size / 2 : state.z);
			call(ghost, hit.has(agent));
		}
	}

	/** Takes other options from now on; those that are not named stay. */
	exchange(options) {
		this.#use({ ...this.#options, ...options });
	}

	/** Sets the traits of a breed, by its name, or of an agent, in place of those it had; null for none. */
	setTraits(whose, traits) {
		const checked = traits === null ? NO_TRAITS : checkTraits(traits);
		if (typeof whose === "string") this.exchange({ breeds: { ...this.#options.breeds, [whose]: checked } });
		else this.#giveTraits(whose, checked);
	}

	/** Sets some of an agent's traits; the others that it has of its own stay. */
	changeTraits(agent, traits) {
		const own = this.#agentTraits.get(agent);
		const checked = checkTraits(traits);
		if (!own || Object.keys(checked).some((name) => own[name] !== checked[name])) this.#giveTraits(agent, { ...own, ...checked });
	}

	/** Takes an agent in. */
	add(agent) {
		let entry = this.#entryOf(agent);
		if (entry === null) {
			entry = new Entry(agent, SPHERE);
			this.#entries.add(entry);
			entry.owner = this;
			agent.jbins = [entry];
			// who is made by one of its breed has its traits, as it has those that the client knows
			const inherited = agent.parent?.breed === agent.breed && this.#agentTraits.get(agent.parent);
			if (inherited && !this.#agentTraits.has(agent)) this.#agentTraits.set(agent, inherited);
		}
		this.#place(entry);
	}

	/** Leaves an agent out. */
	remove(agent) {
		const entry = this.#entryOf(agent);
		if (entry !== null) {
			this.#entries.delete(entry);
			entry.owner = null;
			this.#cells.take(entry);
		}
		agent.jbins = [];
	}

	/** An agent has moved, or is of another size. */
	update(agent) {
		const entry = this.#entryOf(agent);
		if (entry === null) this.add(agent);
		else this.#place(entry);
	}

	/** Leaves all out. */
	reset() {
		for (const entry of this.#entries) entry.owner = null;
		this.#entries.clear();
		this.#cells.clear();
		this.#suspects.length = 0;
		this.#bodies.length = 0;
		this.#found = [];
	}

	/** Whether there is no agent of a breed. */
	empty(breedId) {
		for (const { agent } of this.#entries) if (agent.breed.id === breedId) return false;
		return true;
	}

	/** All pairs that collide and have a block, each once, in the order in which the client finds them; with sweeps, in that of time. */
	getCollisions() {
		this.#blocks.read(this.#collision);
		this.#gather();
		this.#found = [];
		this.#suspects.length = 0;
		this.#collision.update(this.#bodies);
		if (!this.#isSwept) this.#collect();
		// the first question after it reads all places, and so does the first in the next tick
		this.#collidedIn = this.#state.clock;
		this.#tick = NaN;
		return this.#found;
	}

	/** Whether two agents touch, as the last getCollisions saw them. */
	areColliding(a, b) {
		const first = this.#entryOf(a);
		const second = this.#entryOf(b);
		if (first === null || second === null || first === second) return false;
		return this.#collider.areColliding(first.body, second.body) && (!this.#isBins || doSpheresMeet(a.state, b.state));
	}

	/** How many of a breed are within a radius of an agent, which has some trait. */
	count(agent, breedName, radius, trait, value) {
		const reach = Number(radius);
		const breed = this.#breedOf(breedName);
		if (reach > 2 * Math.SQRT2 * this.#half) return this.#countAll(breed, trait, value);
		this.#refresh();
		return reach >= 0 ? this.#cells.count(agent, breed, reach, this.#asks(trait, value)) : 0;
	}

	/** The nearest of a breed within a radius, which has some trait; the agent itself if there is none. */
	nearest(agent, breedName, radius, trait, value) {
		const reach = Number(radius);
		const breed = this.#breedOf(breedName);
		this.#refresh();
		return (reach >= 0 ? this.#cells.nearest(agent, breed, reach, this.#asks(trait, value)) : null) ?? agent;
	}

	#use(options) {
		const { system = "bins", exact = false, depth, breeds = {} } = options;
		if (!Object.hasOwn(SYSTEMS, system)) throw new RangeError(`the system must be one of ${Object.keys(SYSTEMS).join(", ")}, not ${system}`);
		if (exact && (system === "bins" || system === "tightest")) throw new RangeError(`exact is for hierarchical and combination, not for ${system}`);
		const traits = Object.entries(breeds).map(([name, given]) => [name, checkTraits(given)]);
		const collider = new SYSTEMS[system](this.#greatLand);
		if (exact) collider.exact = true;
		if (depth !== undefined) collider.maxDepth = depth;
		this.#collider = collider;
		this.#collision = new Collision(collider);
		this.#isBins = system === "bins";
		this.#options = { ...options, system, exact };
		this.#breedTraits = new Map(traits);
		for (const entry of this.#entries) entry.traitsOf = null;
	}

	#giveTraits(agent, traits) {
		this.#agentTraits.set(agent, traits);
		const entry = this.#entryOf(agent);
		if (entry !== null) entry.traitsOf = null;
	}

	#entryOf(agent) {
		const entry = agent.jbins?.[0];
		return entry instanceof Entry && entry.agent === agent && entry.owner === this ? entry : null;
	}

	#place(entry) {
		entry.bin(this.#half, ++this.#turn);
		this.#cells.put(entry);
	}

	/** Brings the bodies of all that take part to where their agents are. */
	#gather() {
		const { data, numAgents } = this.#execution.AgentController;
		const bodies = this.#bodies;
		let count = 0;
		let isSwept = false;
		for (let i = 1; i < numAgents; i++) {
			const entry = this.#participant(data[i]);
			if (entry === null || !this.#follow(entry)) continue;
			entry.index = i;
			// to set a length costs
			if (entry.keys.length > 0) entry.keys.length = entry.others.length = 0;
			if (entry.body.sweeps) isSwept = true;
			bodies[count++] = entry.body;
		}
		bodies.length = count;
		this.#isSwept = isSwept;
	}

	/** Lists what was found as the client would have come upon it: by its list of agents, bins, breeds of blocks, and turns in a bin. */
	#collect() {
		for (const { entry } of this.#bodies) {
			const others = entry.others;
			if (others.length > 0) this.#suspects.push(entry);
			for (let i = 0; i < others.length; i++) {
				this.#found.push(pairOf(entry.agent, others[i].agent));
				this.#suspects.push(others[i]);
			}
		}
	}

	/** What is kept of an agent that a block is for, its traits up to date; otherwise null. */
	#participant(agent) {
		if (!agent || agent.isDead || !this.#blocks.concerned.has(agent.breed.id)) return null;
		const entry = this.#entryOf(agent);
		if (entry !== null && entry.traitsOf !== agent.breed) this.#setTraits(entry);
		return entry;
	}

	/** Whether an agent can take part; its body is then where it is. */
	#follow({ agent, body }) {
		const { state } = agent;
		if (!this.#pose(body, state)) return false;
		moveBody(body, agent, state.x, state.y, this.#isBins ? state.z - body.size / 2 : state.z);
		return true;
	}

	/** Whether one of a state can take part; all of a body but its place is then as in the state. */
	#pose(body, { x, y, z, size, heading, shape }) {
		if (!(Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) <= FARTHEST && size >= 0 && size < Agent.LARGEST_SIZE)) return false;
		if (this.#isBins) {
			body.shape = SPHERE;
			body.size = Math.min(Math.max(size + size * MARGIN + MARGIN, Agent.SMALLEST_SIZE), Agent.LARGEST_SIZE);
			return true;
		}
		if (!(size > Agent.SMALLEST_SIZE)) return false;
		body.shape = this.#shapes.modelOf(shape);
		body.size = size;
		body.heading = Number.isFinite(heading) ? heading : 0;
		return true;
	}

	#setTraits(entry) {
		const { agent, body } = entry;
		const { hierarchical = false, depth = 0, sweeps = this.#options.sweeps ?? false, structure = Agent.TIGHTEST } = {
			...this.#breedTraits.get(agent.breed.name),
			...this.#agentTraits.get(agent),
		};
		body.hierarchical = hierarchical;
		body.traversalDepth = depth;
		body.sweeps = sweeps;
		body.collideAs = structure;
		body.breed = String(agent.breed.id);
		entry.traitsOf = agent.breed;
	}

	#onPair(a, b) {
		const first = a.agent;
		const second = b.agent;
		const isSameBreed = first.breed.id === second.breed.id;
		// the handler of a breed for itself is called from either side
		if (isSameBreed && a.index > b.index) return;
		if (this.#isBins && !a.body.sweeps && !b.body.sweeps && !doSpheresMeet(first.state, second.state)) return;
		if (this.#isSwept) {
			this.#found.push(pairOf(first, second));
			this.#suspects.push(a, b);
			return;
		}
		const rank = isSameBreed && first.id > second.id ? -1 : this.#blocks.rank(first.breed.id, second.breed.id);
		const otherRank = isSameBreed && second.id > first.id ? -1 : this.#blocks.rank(second.breed.id, first.breed.id);
		const shared = firstSharedBin(a, b) * RANKS;
		if (rank >= 0 && (otherRank < 0 || a.index < b.index)) a.keep(b, (shared + rank) * TURNS + b.turn);
		else b.keep(a, (shared + otherRank) * TURNS + a.turn);
	}

	/** Reads the places of all that may have moved without a word: of everybody once a tick, and then of those whose blocks run. */
	#refresh() {
		if (this.#state.clock !== this.#tick) {
			this.#tick = this.#state.clock;
			for (const entry of this.#entries) this.#cells.put(entry);
			return;
		}
		if (this.#collidedIn === this.#tick) for (const entry of this.#suspects) this.#cells.put(entry);
	}

	/** A breed; null for everyone. */
	#breedOf(name) {
		const breed = this.#execution.AgentController.getByName(name);
		if (!breed) throw new RangeError(`there is no breed "${name}"`);
		return breed.id === EVERYONE ? null : breed;
	}

	#asks(trait, value) {
		const equals = this.#equals;
		return trait ? (other) => equals(other.getTrait(trait), value) : null;
	}

	/** Beyond the diagonal of the ground the client counts all, the asker too; for everyone the World as well. */
	#countAll(breed, trait, value) {
		const { data, numAgents } = this.#execution.AgentController;
		const accepts = this.#asks(trait, value);
		let found = 0;
		for (let i = breed === null ? 0 : 1; i < numAgents; i++) {
			const agent = data[i];
			if (agent && !agent.isDead && (breed === null || agent.breed === breed) && (accepts === null || accepts(agent))) found++;
		}
		return found;
	}
}

/** A state on the way between two, as the client draws it. */
function between(before, now, part) {
	const turn = ((now.heading - before.heading) % 360 + 540) % 360 - 180;
	return {
		...now,
		x: before.x + part * (now.x - before.x),
		y: before.y + part * (now.y - before.y),
		z: before.z + part * (now.z - before.z),
		size: before.size + part * (now.size - before.size),
		heading: before.heading + part * turn,
	};
}

/** By the client's rule: nearer than half the sum of the sizes. */
function doSpheresMeet(a, b) {
	const dx = a.x - b.x;
	const dy = a.y - b.y;
	const dz = a.z - b.z;
	const reach = a.size + b.size;
	return dx * dx + dy * dy + dz * dz < reach * reach / 4;
}

/** An agent that was set elsewhere, not moved, has its new place for the last one too. */
function moveBody(body, agent, x, y, z) {
	const before = agent.prevState;
	if (body.sweeps && before && before.x === x && before.y === y && before.z === agent.state.z) body.jumpTo(x, y, z);
	else body.moveTo(x, y, z);
}

function pairOf(a, b) {
	return a.id < b.id ? { a, b } : { a: b, b: a };
}

function checkTraits(traits) {
	for (const name of Object.keys(traits)) if (!TRAITS.includes(name)) throw new RangeError(`the traits are ${TRAITS.join(", ")}, not ${name}`);
	const { depth = 0, structure = Agent.TIGHTEST } = traits;
	if (!(Number.isInteger(depth) && depth >= 0)) throw new RangeError(`depth must be a whole number, 0 or more, not ${depth}`);
	if (![Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE].includes(structure)) throw new RangeError(`structure must be tightest, sphere, box or capsule, not ${structure}`);
	return { ...traits };
}
