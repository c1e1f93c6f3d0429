import { Agent, BinCollider, Collision, CombinationCollider, GreatLand, HierarchicalCollider, Model, TightestFitCollider } from "starlogo-collision";
import { Blocks } from "./blocks.js";
import { Entry, firstSharedBin } from "./entry.js";
import { Neighbours } from "./neighbours.js";
import { SPHERE, Shapes } from "./shapes.js";
import { Traits, checkTraits } from "./traits.js";

/** The engine's own: the check of options. */
const [, , , checkedOptions] = Model.$parts;

const SYSTEMS = { bins: BinCollider, tightest: TightestFitCollider, hierarchical: HierarchicalCollider, combination: CombinationCollider };

/**
 * Larger than the rounding of places and sizes. So the engine finds all pairs that may touch by the client's rule, and the rule is then
 * tested.
 */
const MARGIN = 1e-9;

/** Agents beyond this coordinate take no part. Half a size farther away, an Agent can still exist. */
const FARTHEST = Agent.LARGEST_COORDINATE - Agent.LARGEST_SIZE;

/** The lower part of a key is the turn. No game has so many updates. */
const TURNS = 2 ** 36;

/** A key has room for this many breeds of a block. No game has so many. */
const RANKS = 1024;

/** Finds the collisions of a client in a window, with the engine. It replaces the client's Collisions. */
export class NovaCollisions {
	#execution;
	#half;
	#options;
	#entries = new Set();
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
	#traits = new Traits();

	/** Counts the agents near one, and finds the nearest. */
	neighbours;

	/** For the client of a window; agents are added later. For the options see installInto. */
	constructor(window, options) {
		this.#execution = window.Execution;
		this.#half = window.Helper?.Constants?.MAPSIZE ?? 50.5;
		this.neighbours = new Neighbours(window, this.#half, this.#entries);
		this.#blocks = new Blocks(window.Common.State, (a, b) => this.#onPair(a.entry, b.entry));
		this.#use(options);
		this.#shapes = new Shapes(this.#greatLand, window, { own: options.shapes, manifest: options.manifest });
	}

	/** The options in use. */
	get options() {
		return this.#options;
	}

	/** The engine's collider in use. */
	get collider() {
		return this.#collider;
	}

	/** The GreatLand with the models. */
	get greatLand() {
		return this.#greatLand;
	}

	/** The client's shapes. */
	get shapes() {
		return this.#shapes;
	}

	/**
	 * Calls a function for each agent that takes part, with an Agent of the engine and whether the last getCollisions found it in a pair.
	 * `part` is the part of the way from the place in the last tick to the present place.
	 */
	forEachBody(part, call) {
		const { data, numAgents } = this.#execution.AgentController;
		const hit = new Set(this.#found.flatMap(({ a, b }) => [a, b]));
		const ghost = this.#ghost;
		this.#blocks.followState(this.#collision);
		for (let i = 1; i < numAgents; i++) {
			const entry = this.#participant(data[i]);
			if (entry === null) continue;
			const { agent, body } = entry;
			const state = part < 1 && agent.prevState ? between(agent.prevState, agent.state, part) : agent.state;
			if (!this.#pose(ghost, state)) continue;
			ghost.hierarchical = body.hierarchical;
			ghost.traversalDepth = body.traversalDepth;
			ghost.collideAs = body.collideAs;
			call(ghost, hit.has(agent));
		}
	}

	/** Changes options. Options that are not named stay. */
	exchange(options) {
		this.#use({ ...this.#options, ...options });
	}

	/** Sets the traits of a breed, by its name, or of an agent. They replace all traits set before; null removes them. */
	setTraits(whose, traits) {
		const checked = checkTraits(traits === null ? {} : traits);
		if (typeof whose === "string") this.exchange({ breeds: { ...this.#options.breeds, [whose]: checked } });
		else this.#giveTraits(whose, checked);
	}

	/** Sets some of an agent's traits. Its other traits stay. */
	changeTraits(agent, traits) {
		const checked = checkTraits(traits);
		if (!this.#traits.hasAll(agent, checked)) this.#giveTraits(agent, { ...this.#traits.ofAgents.get(agent), ...checked });
	}

	/** Adds an agent. */
	add(agent) {
		let entry = this.#entryOf(agent);
		if (entry === null) {
			entry = new Entry(agent, SPHERE);
			this.#entries.add(entry);
			entry.owner = this;
			agent.jbins = [entry];
			this.#traits.inherit(agent);
		}
		this.#place(entry);
	}

	/** Removes an agent. */
	remove(agent) {
		const entry = this.#entryOf(agent);
		if (entry !== null) {
			this.#entries.delete(entry);
			entry.owner = null;
			this.neighbours.cells.take(entry);
		}
		agent.jbins = [];
	}

	/** Call it when an agent has moved or changed its size. */
	update(agent) {
		const entry = this.#entryOf(agent);
		if (entry === null) this.add(agent);
		else this.#place(entry);
	}

	/** Removes all agents. */
	reset() {
		for (const entry of this.#entries) entry.owner = null;
		this.#entries.clear();
		this.neighbours.clear();
		this.#bodies.length = 0;
		this.#found = [];
	}

	/** Whether a breed has no agents. */
	empty(breedId) {
		for (const { agent } of this.#entries) if (agent.breed.id === breedId) return false;
		return true;
	}

	/** All colliding pairs that have a block, each once. They come in the client's order; with sweeps, in the order of time. */
	getCollisions() {
		this.#blocks.followState(this.#collision);
		this.#gather();
		this.#found = [];
		this.neighbours.beginCollisions();
		this.#collision.update(this.#bodies);
		if (!this.#isSwept) this.#collect();
		this.neighbours.endCollisions();
		return this.#found;
	}

	/** Whether two agents touch now. */
	areColliding(a, b) {
		const first = this.#currentEntryOf(a);
		const second = this.#currentEntryOf(b);
		if (first === null || second === null || first === second || !this.#pose(first.body, a.state) || !this.#pose(second.body, b.state)) return false;
		return this.#collider.areColliding(first.body, second.body) && (!this.#isBins || doSpheresMeet(a.state, b.state));
	}

	#use(options) {
		const defaults = { system: "bins", exact: false, depth: undefined, sweeps: undefined, breeds: {}, shapes: null, overlay: false, manifest: null };
		const { system, exact, depth, breeds } = checkedOptions(null, "options", options, defaults, 'a literal such as { system: "tightest" }');
		if (!Object.hasOwn(SYSTEMS, system)) throw new RangeError(`the system must be one of ${Object.keys(SYSTEMS).join(", ")}, not ${system}`);
		if (exact && (system === "bins" || system === "tightest")) throw new RangeError(`exact is for hierarchical and combination, not for ${system}`);
		const traits = new Map(Object.entries(breeds).map(([name, given]) => [name, checkTraits(given)]));
		const collider = new SYSTEMS[system](this.#greatLand);
		if (exact) collider.exact = true;
		if (depth !== undefined) collider.maxDepth = depth;
		this.#collider = collider;
		this.#collision = new Collision(collider);
		this.#isBins = system === "bins";
		this.#options = { ...options, system, exact };
		this.#traits.ofBreeds = traits;
		for (const entry of this.#entries) entry.traitsOf = null;
	}

	#giveTraits(agent, traits) {
		this.#traits.ofAgents.set(agent, traits);
		const entry = this.#entryOf(agent);
		if (entry !== null) entry.traitsOf = null;
	}

	#entryOf(agent) {
		const entry = agent.jbins?.[0];
		return entry instanceof Entry && entry.agent === agent && entry.owner === this ? entry : null;
	}

	#place(entry) {
		entry.bin(this.#half, ++this.#turn);
		this.neighbours.cells.put(entry);
	}

	/** Moves all bodies that take part to their agents. */
	#gather() {
		const { data, numAgents } = this.#execution.AgentController;
		const bodies = this.#bodies;
		let count = 0;
		let isSwept = false;
		for (let i = 1; i < numAgents; i++) {
			const entry = this.#participant(data[i]);
			if (entry === null || !this.#pose(entry.body, data[i].state)) continue;
			if (entry.body.sweeps && wasSet(data[i])) entry.body.jumpTo(entry.body.x, entry.body.y, entry.body.z);
			entry.index = i;
			// setting a length takes time
			if (entry.keys.length > 0) entry.keys.length = entry.others.length = 0;
			if (entry.body.sweeps) isSwept = true;
			bodies[count++] = entry.body;
		}
		bodies.length = count;
		this.#isSwept = isSwept;
	}

	/**
	 * Lists the pairs in the order in which the client would find them: by its list of agents, then by bins, by breeds of blocks, and by turns
	 * in a bin.
	 */
	#collect() {
		for (const { entry } of this.#bodies) {
			const others = entry.others;
			if (others.length > 0) this.neighbours.suspect(entry);
			for (let i = 0; i < others.length; i++) {
				this.#found.push(pairOf(entry.agent, others[i].agent));
				this.neighbours.suspect(others[i]);
			}
		}
	}

	/** The entry of an agent that has a block; otherwise null. */
	#participant(agent) {
		return agent && !agent.isDead && this.#blocks.breedsWithBlocks.has(agent.breed.id) ? this.#currentEntryOf(agent) : null;
	}

	/** The entry of an agent, with its traits up to date; null if it has none. */
	#currentEntryOf(agent) {
		const entry = this.#entryOf(agent);
		if (entry !== null && entry.traitsOf !== agent.breed) this.#setTraits(entry);
		return entry;
	}

	/** Gives a body everything of a state. Returns whether an agent with this state can take part. */
	#pose(body, { x, y, z, size, heading, shape }) {
		if (!(Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) <= FARTHEST && size >= 0 && size < Agent.LARGEST_SIZE)) return false;
		if (this.#isBins) {
			body.shape = SPHERE;
			body.size = Math.min(Math.max(size + size * MARGIN + MARGIN, Agent.SMALLEST_SIZE), Agent.LARGEST_SIZE);
			body.moveTo(x, y, z - body.size / 2);
			return true;
		}
		if (!(size > Agent.SMALLEST_SIZE)) return false;
		body.shape = this.#shapes.modelOf(shape);
		body.size = size;
		body.heading = Number.isFinite(heading) ? heading : 0;
		body.moveTo(x, y, z);
		return true;
	}

	#setTraits(entry) {
		const { agent, body } = entry;
		const { hierarchical = false, depth = 0, sweeps = this.#options.sweeps ?? false, structure = Agent.TIGHTEST } = this.#traits.of(agent);
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
		// a breed's handler for the breed itself is called from both sides
		if (isSameBreed && a.index > b.index) return;
		if (this.#isBins && !a.body.sweeps && !b.body.sweeps && !doSpheresMeet(first.state, second.state)) return;
		if (this.#isSwept) {
			this.#found.push(pairOf(first, second));
			this.neighbours.suspect(a);
			this.neighbours.suspect(b);
			return;
		}
		const rank = isSameBreed && first.id > second.id ? -1 : this.#blocks.rank(first.breed.id, second.breed.id);
		const otherRank = isSameBreed && second.id > first.id ? -1 : this.#blocks.rank(second.breed.id, first.breed.id);
		const shared = firstSharedBin(a, b) * RANKS;
		if (rank >= 0 && (otherRank < 0 || a.index < b.index)) a.keep(b, (shared + rank) * TURNS + b.turn);
		else b.keep(a, (shared + otherRank) * TURNS + a.turn);
	}
}

/** The state on the way between two states, as the client draws it. */
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

/** The client's rule: two agents touch if they are nearer than half the sum of their sizes. */
function doSpheresMeet(a, b) {
	const dx = a.x - b.x;
	const dy = a.y - b.y;
	const dz = a.z - b.z;
	const reach = a.size + b.size;
	return dx * dx + dy * dy + dz * dz < reach * reach / 4;
}

/** Whether an agent was set where it is, instead of moved: its last place is then the new one too. */
function wasSet({ state, prevState: before }) {
	return before && before.x === state.x && before.y === state.y && before.z === state.z;
}

function pairOf(a, b) {
	return a.id < b.id ? { a, b } : { a: b, b: a };
}
