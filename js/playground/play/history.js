/** The frames that a game has been through, to go back to: agents' traits, what scripts know, and the engine's own snapshot. */

/** How many frames are kept at most, and how many agents in all of them. */
const MOST_FRAMES = 900;
const MOST_AGENTS = 150000;

const TRAITS = ["shape", "breed", "x", "y", "z", "heading", "pitch", "roll", "size", "color", "hierarchical", "traversalDepth", "collideAs", "sweeps", "born", "said", "touched", "hit", "isAlive"];
const PLACED = new Set(["x", "y", "z"]);

export class History {
	#frames = [];
	#agents = 0;

	/** @param {import("./world.js").World} world */
	constructor(world) {
		this.world = world;
	}

	clear() {
		this.#frames.length = this.#agents = 0;
		this.shown = undefined;
	}

	/** How many frames one can go back. */
	get length() {
		return Math.max(0, this.#frames.length - 1);
	}

	/**
	 * Keeps the frame that has just been.
	 *
	 * @param {object[]} listed the agents that the engine was given in it
	 */
	add(listed) {
		const { agents, state, collisions } = this.world;
		const all = [...new Set([...listed, ...agents])];
		this.#frames.push({
			listed, agents: [...agents], all, traits: all.map((agent) => TRAITS.map((name) => agent[name])), bytes: collisions.collision.snapshot(), system: collisions.systemName,
			state: { ...state, variables: { ...state.variables }, totals: new Map(state.totals), events: [...state.events], threads: state.threads.map((thread) => thread.copy()) },
		});
		this.#agents += all.length;
		while (this.#frames.length > MOST_FRAMES || (this.#agents > MOST_AGENTS && this.#frames.length > 2)) this.#agents -= this.#frames.shift().all.length;
	}

	/** How many frames back the world is. */
	get back() {
		return this.shown === undefined ? 0 : this.#frames.length - 1 - this.shown;
	}

	/** Makes an earlier frame the world's again; those after it are forgotten once the game goes on. */
	show(back) {
		const { world } = this;
		const at = Math.max(0, this.#frames.length - 1 - back);
		const { listed, agents, all, traits, bytes, system, state } = this.#frames[at];
		all.forEach((agent, i) => restore(agent, traits[i]));
		world.agents.splice(0, Infinity, ...agents);
		Object.assign(world.state, state, { variables: { ...state.variables }, totals: new Map(state.totals), events: [...state.events], threads: state.threads.map((thread) => thread.copy()) });
		world.useSystem(system);
		world.collisions.collision.restore(bytes, listed);
		this.shown = at;
	}

	/** Forgets the frames after the one that is shown: the game goes on from there. */
	goOn() {
		if (this.shown === undefined) return;
		for (const { all } of this.#frames.splice(this.shown + 1)) this.#agents -= all.length;
		this.shown = undefined;
	}
}

function restore(agent, traits) {
	TRAITS.forEach((name, i) => {
		if (!PLACED.has(name)) agent[name] = traits[i];
	});
	const [x, y, z] = [...PLACED].map((name) => traits[TRAITS.indexOf(name)]);
	agent.moveTo(x, y, z);
}
