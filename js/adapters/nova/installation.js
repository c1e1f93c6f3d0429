import { Agent, BinCollider, Collision, CombinationCollider, GreatLand, HierarchicalCollider, Model, TightestFitCollider } from "starlogo-collision";
import { Blocks } from "./blocks.js";
import { Neighbours } from "./neighbours.js";
import { Overlay, viewClassOf } from "./overlay.js";
import { Overrides } from "./overrides.js";
import { AgentRecord, FoundPair } from "./record.js";
import { SPHERE, Shapes } from "./shapes.js";
import { Traits, checkedBreeds, checkedTraits } from "./traits.js";

/** The engine's own check of options. */
const { checkedOptions } = Model.$internals;

/** The name of the symbol under which a client keeps its installation. Other copies of this script find it there too. */
export const INSTALLATION_KEY = "starlogo-collision.nova";
const INSTALLED = Symbol.for(INSTALLATION_KEY);

const SYSTEMS = { bins: BinCollider, tightest: TightestFitCollider, hierarchical: HierarchicalCollider, combination: CombinationCollider };

const DEFAULTS = {
	system: "bins", exact: false, depth: undefined, sweeps: undefined, breeds: {}, shapes: null, overlay: false, manifest: null,
};

/**
 * Larger than the rounding of places and sizes. So the engine finds all pairs that may touch by the client's rule, and the rule is then
 * tested.
 */
const MARGIN = 1e-9;

/** Agents beyond this coordinate take no part. Half a size farther away, an Agent can still exist. */
const FARTHEST = Agent.LARGEST_COORDINATE - Agent.LARGEST_SIZE;

/** The installation in the client of a window, or null. */
export function installedIn(window) {
	return window.Execution?.Collisions?.[INSTALLED] ?? null;
}

/** Replaces the collisions of the StarLogo Nova client in a window with the engine's. An earlier installation is uninstalled first. */
export function installInto(window, options = {}) {
	if (!window?.Execution?.Collisions || !window.Common?.State || !window.Execution.AgentController) {
		throw new TypeError("the window has no StarLogo Nova client: Execution.Collisions is not there");
	}
	return new Installation(window, options);
}

/** An installation of the engine in a client: it finds the collisions of the client's agents in place of the client's Collisions. */
class Installation {
	#window;
	#client;
	#overrides = new Overrides();
	#overlay;
	#half;
	#options;
	#records = new Set();
	#sequence = 0;
	#greatLand = new GreatLand();
	#shapes;
	#collision = new Collision(new BinCollider());
	#neighbours;
	#blocks;
	#engineAgents = [];
	#drawAgent = new Agent(SPHERE);
	#found = [];
	#traits = new Traits();

	/** If an option is refused, nothing has changed. */
	constructor(window, options) {
		this.#window = window;
		this.#client = window.Execution.Collisions;
		this.#half = window.Helper?.Constants?.MAPSIZE ?? 50.5;
		this.#applyOptions(options, DEFAULTS);
		const { shapes, manifest } = this.#options;
		this.#shapes = new Shapes(this.#greatLand, window, { own: shapes, manifest });
		this.#neighbours = new Neighbours(window, this.#half, this.#records);
		this.#blocks = new Blocks(window.Common.State, this.#collision, (a, b) => this.#onPair(a.record, b.record));
		this.#overlay = new Overlay(window, this.#greatLand, (fraction, call) => this.#forEachShown(fraction, call));
		installedIn(window)?.uninstall();
		this.#client.reset();
		this.#override();
		this.#addAll();
		this.#overlay.show(Boolean(this.#options.overlay));
	}

	/** Whether it is still installed. */
	get isInstalled() {
		return this.#overrides.any;
	}

	/** The options in use. */
	get options() {
		return this.#options;
	}

	/** The GreatLand with the models. */
	get greatLand() {
		return this.#greatLand;
	}

	/** The number of models that are still loading. */
	get pendingCount() {
		return this.#shapes.pendingCount;
	}

	/** The models that could not be loaded, and why. */
	get problems() {
		return this.#shapes.problems;
	}

	/** Changes options. Options that are not named stay. */
	exchange(options) {
		this.#applyOptions(options, this.#options);
		if (this.isInstalled) this.#overlay.show(Boolean(this.#options.overlay));
	}

	/** Shows or hides the colliding shapes in the client's view. */
	showOverlay(isOn = true) {
		this.exchange({ overlay: isOn });
	}

	/** Sets the traits of a breed, by its name, or of an agent. They replace all traits set before; null removes them. */
	setTraits(whose, traits) {
		const checked = checkedTraits(traits);
		if (typeof whose === "string") this.exchange({ breeds: { ...this.#options.breeds, [whose]: checked } });
		else this.#traits.ofAgents.set(whose, checked);
	}

	/** Sets some of an agent's traits, as its blocks do. The others stay. */
	changeTraits(agent, traits) {
		const { ofAgents } = this.#traits;
		ofAgents.set(agent, { ...ofAgents.get(agent), ...checkedTraits(traits) });
	}

	/** Whether two agents touch now. */
	areColliding(a, b) {
		const [first, second] = [this.#currentRecordOf(a), this.#currentRecordOf(b)];
		if (first === null || second === null || first === second) return false;
		if (!this.#copyStateIfInWorld(first.engineAgent, a.state) || !this.#copyStateIfInWorld(second.engineAgent, b.state)) return false;
		return this.#collider.areColliding(first.engineAgent, second.engineAgent) && (!this.#isBins || doSpheresMeet(a.state, b.state));
	}

	/** Gives the client its own collisions back, with all agents in its bins. */
	uninstall() {
		if (!this.isInstalled) return;
		this.#overlay.show(false);
		this.#overrides.restore();
		this.#shapes.stop();
		this.#reset();
		this.#client.reset();
		this.#addAll();
	}

	get #collider() {
		return this.#collision.collisionSystem;
	}

	get #isBins() {
		return this.#options.system === "bins";
	}

	/** Puts methods in the place of the client's own. */
	#override() {
		const neighbours = this.#neighbours;
		const methods = {
			add: (agent) => this.#add(agent),
			remove: (agent) => this.#remove(agent),
			update: (agent) => this.#add(agent),
			getCollisions: () => this.#getCollisions(),
			empty: (breedId) => this.#isEmpty(breedId),
			reset: () => this.#reset(),
			count: (...question) => neighbours.count(...question),
			nearest: (...question) => neighbours.nearest(...question),
		};
		for (const [name, method] of Object.entries(methods)) this.#overrides.apply(this.#client, name, () => method);
		this.#overrides.apply(this.#client, INSTALLED, () => this);
		// it moves all agents without an update
		const { AgentController } = this.#window.Execution;
		if (typeof AgentController.scatterAllAgents === "function") {
			this.#overrides.apply(AgentController, "scatterAllAgents", (scatter) => function (...args) {
				neighbours.forgetPlaces();
				return scatter.apply(this, args);
			});
		}
	}

	#addAll() {
		const { data, numAgents } = this.#window.Execution.AgentController;
		for (let i = 1; i < numAgents; i++) {
			const agent = data[i];
			if (!agent) continue;
			agent.jbins = [];
			if (!agent.isDead) this.#client.add(agent);
		}
	}

	/**
	 * Calls a function for each agent that takes part:
	 * with an Agent of the engine, the collider, and whether the last getCollisions found it in a pair.
	 * `fraction` says where on its way it is: 0 at its place in the last tick, 1 at its present place.
	 */
	#forEachShown(fraction, call) {
		const { data, numAgents } = this.#window.Execution.AgentController;
		const hit = new Set(this.#found.flatMap(({ finder, other }) => [finder, other]));
		const drawAgent = this.#drawAgent;
		this.#blocks.followState();
		for (let i = 1; i < numAgents; i++) {
			const record = this.#participant(data[i]);
			if (record === null) continue;
			const { clientAgent, engineAgent } = record;
			const state = fraction < 1 && clientAgent.prevState ? between(clientAgent.prevState, clientAgent.state, fraction) : clientAgent.state;
			if (!this.#copyStateIfInWorld(drawAgent, state)) continue;
			drawAgent.hierarchical = engineAgent.hierarchical;
			drawAgent.traversalDepth = engineAgent.traversalDepth;
			drawAgent.collideAs = engineAgent.collideAs;
			call(drawAgent, this.#collider, hit.has(record));
		}
	}

	/** Adds an agent, or reads the place and size of one that was added. */
	#add(agent) {
		let record = this.#recordOf(agent);
		if (record === null) {
			record = new AgentRecord(agent, SPHERE);
			this.#records.add(record);
			agent.jbins = [record];
			this.#traits.inherit(agent);
		}
		record.setBin(this.#half, ++this.#sequence);
		this.#neighbours.cells.insert(record);
	}

	/** Removes an agent. */
	#remove(agent) {
		const record = this.#recordOf(agent);
		if (record !== null) {
			this.#records.delete(record);
			this.#neighbours.cells.remove(record);
		}
		agent.jbins = [];
	}

	/** Removes all agents. */
	#reset() {
		this.#records.clear();
		this.#neighbours.clear();
		this.#engineAgents.length = 0;
		this.#found = [];
	}

	/** Whether a breed has no agents. */
	#isEmpty(breedId) {
		for (const { clientAgent } of this.#records) if (clientAgent.breed.id === breedId) return false;
		return true;
	}

	/** All colliding pairs that have a block, each once. They come in the client's order; with sweeps, in the order of time. */
	#getCollisions() {
		this.#blocks.followState();
		this.#listParticipants();
		this.#found = [];
		this.#collision.update(this.#engineAgents);
		if (!this.#engineAgents.some(({ sweeps }) => sweeps)) this.#found.sort(FoundPair.compare);
		const pairs = this.#found.map(({ pair }) => pair);
		this.#neighbours.blocksRunFor(pairs);
		return pairs;
	}

	/** Changes options. Those that are not named, or undefined, are as before. */
	#applyOptions(given, before) {
		const options = checkedOptions(null, "options", given, { ...before }, 'a literal such as { system: "tightest" }');
		const { system, exact, depth, overlay } = options;
		for (const name of ["shapes", "manifest"]) {
			if (before !== DEFAULTS && options[name] !== before[name]) throw new RangeError(`${name} is read once, at installation`);
		}
		if (!Object.hasOwn(SYSTEMS, system)) throw new RangeError(`the system must be one of ${Object.keys(SYSTEMS).join(", ")}, not ${system}`);
		if (exact && (system === "bins" || system === "tightest")) throw new RangeError(`exact is for hierarchical and combination, not for ${system}`);
		checkedTraits({ sweeps: options.sweeps });
		options.breeds = checkedBreeds(options.breeds);
		// checked all the same for bins and tightest fits, which have no trees: a later system may use the depth
		const withTrees = new HierarchicalCollider(this.#greatLand);
		withTrees.exact = exact;
		if (depth !== undefined) withTrees.maxDepth = depth;
		if (overlay) viewClassOf(this.#window); // throws if there is none
		// with another system, motions begin anew
		if (system !== this.#options?.system) this.#collision.collisionSystem = new SYSTEMS[system](this.#greatLand);
		if ("maxDepth" in this.#collider) Object.assign(this.#collider, { exact, maxDepth: withTrees.maxDepth });
		this.#options = Object.freeze(options);
		this.#traits.ofBreeds = options.breeds;
	}

	#recordOf(agent) {
		const record = agent.jbins?.[0];
		return this.#records.has(record) && record.clientAgent === agent ? record : null;
	}

	/** Lists the engine's Agents for all agents that take part, and moves them there. */
	#listParticipants() {
		const { data, numAgents } = this.#window.Execution.AgentController;
		const engineAgents = this.#engineAgents;
		let count = 0;
		for (let i = 1; i < numAgents; i++) {
			const record = this.#participant(data[i]);
			if (record === null || !this.#copyStateIfInWorld(record.engineAgent, data[i].state)) continue;
			const { engineAgent } = record;
			if (engineAgent.sweeps && !hasMoved(data[i])) engineAgent.jumpTo(engineAgent.x, engineAgent.y, engineAgent.z);
			record.index = i;
			engineAgents[count++] = engineAgent;
		}
		engineAgents.length = count;
	}

	/** The record of an agent that has a block; otherwise null. */
	#participant(agent) {
		return agent && !agent.isDead && this.#blocks.breedsWithBlocks.has(agent.breed.id) ? this.#currentRecordOf(agent) : null;
	}

	/** The record of an agent, with its traits up to date; null if it has none. */
	#currentRecordOf(agent) {
		const record = this.#recordOf(agent);
		if (record !== null) this.#setTraits(record);
		return record;
	}

	/** Gives an Agent the place, size and shape of a state, if an agent with this state can take part. Returns whether it can. */
	#copyStateIfInWorld(engineAgent, { x, y, z, size, heading, shape }) {
		if (!(Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) <= FARTHEST && size >= 0 && size < Agent.LARGEST_SIZE)) return false;
		if (this.#isBins) {
			engineAgent.shape = SPHERE;
			engineAgent.size = Math.min(Math.max(size + size * MARGIN + MARGIN, Agent.SMALLEST_SIZE), Agent.LARGEST_SIZE);
			engineAgent.moveTo(x, y, z - engineAgent.size / 2);
			return true;
		}
		if (!(size > Agent.SMALLEST_SIZE)) return false;
		engineAgent.shape = this.#shapes.modelOf(shape);
		engineAgent.size = size;
		engineAgent.heading = Number.isFinite(heading) ? heading : 0;
		engineAgent.moveTo(x, y, z);
		return true;
	}

	#setTraits({ clientAgent, engineAgent }) {
		const { hierarchical = false, depth = 0, sweeps = this.#options.sweeps ?? false, structure = Agent.TIGHTEST } = this.#traits.of(clientAgent);
		engineAgent.hierarchical = hierarchical;
		engineAgent.traversalDepth = depth;
		engineAgent.sweeps = sweeps;
		engineAgent.collideAs = structure;
		engineAgent.breed = String(clientAgent.breed.id);
	}

	#onPair(a, b) {
		const first = a.clientAgent;
		const second = b.clientAgent;
		const isSameBreed = first.breed.id === second.breed.id;
		// a breed's handler for the breed itself is called from both sides
		if (isSameBreed && a.index > b.index) return;
		if (this.#isBins && !isSwept(a) && !isSwept(b) && !doSpheresMeet(first.state, second.state)) return;
		const rank = isSameBreed && first.id > second.id ? -1 : this.#blocks.rank(first.breed.id, second.breed.id);
		const otherRank = isSameBreed && second.id > first.id ? -1 : this.#blocks.rank(second.breed.id, first.breed.id);
		this.#found.push(rank >= 0 && (otherRank < 0 || a.index < b.index) ? new FoundPair(a, b, rank) : new FoundPair(b, a, otherRank));
	}
}

/** The state on the way between two states, as the client draws it. */
function between(before, now, fraction) {
	const turn = ((now.heading - before.heading) % 360 + 540) % 360 - 180;
	return {
		...now,
		x: before.x + fraction * (now.x - before.x),
		y: before.y + fraction * (now.y - before.y),
		z: before.z + fraction * (now.z - before.z),
		size: before.size + fraction * (now.size - before.size),
		heading: before.heading + fraction * turn,
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

/** Whether an agent collides along a way in this tick. */
function isSwept({ engineAgent, clientAgent }) {
	return engineAgent.sweeps && hasMoved(clientAgent);
}

/** Whether an agent has moved to its place. If it was set there, its last place is the same. */
function hasMoved({ state, prevState: before }) {
	return !before || before.x !== state.x || before.y !== state.y || before.z !== state.z;
}
