/** The most frames that are kept, and the most agents in all of them together. */
const MOST_FRAMES = 900;
const MOST_AGENTS = 150000;

const TRAITS = ["shape", "breed", "x", "y", "z", "heading", "pitch", "roll", "size", "color", "hierarchical", "traversalDepth", "collideAs", "sweeps", "born", "said", "rise", "touched", "hit", "isAlive", "own"];

/** Keeps the last frames of a game, so that it can go back. */
export class History {
	/** The index of the frame that is shown; undefined while the game goes on. */
	shown = undefined;
	#frames = [];
	#agentCount = 0;

	/** @param {import("./world.js").World} world */
	constructor(world) {
		this.world = world;
	}

	clear() {
		this.#frames.length = this.#agentCount = 0;
		this.shown = undefined;
	}

	/** Keeps the last frame anew, because the user has moved an agent in it. */
	amend(searched) {
		this.goOn();
		if (this.#frames.length === 0) return;
		this.#agentCount -= this.#frames.pop().all.length;
		this.add(searched);
	}

	/** The number of frames that one can go back. */
	get length() {
		return Math.max(0, this.#frames.length - 1);
	}

	/**
	 * Keeps the last frame.
	 *
	 * @param {object[]} searched the agents that the engine was given in it
	 */
	add(searched) {
		const { agents: living, state, collisions } = this.world;
		const all = [...new Set([...searched, ...living])];
		this.#frames.push({
			searched, living: [...living], all, traits: all.map((agent) => Object.fromEntries(TRAITS.map((name) => [name, agent[name]]))), bytes: collisions.collision.snapshot(), system: collisions.systemName, state: copyOf(state),
		});
		this.#agentCount += all.length;
		while (this.#frames.length > MOST_FRAMES || (this.#agentCount > MOST_AGENTS && this.#frames.length > 2)) this.#agentCount -= this.#frames.shift().all.length;
	}

	/** The number of frames that the world has gone back. */
	get back() {
		return this.shown === undefined ? 0 : this.#frames.length - 1 - this.shown;
	}

	/** Takes the world back to an earlier frame. When the game goes on, the frames after it are removed. */
	show(back) {
		const { world } = this;
		const at = Math.max(0, this.#frames.length - 1 - back);
		const { searched, living, all, traits, bytes, system, state } = this.#frames[at];
		world.agents.splice(0, Infinity, ...living);
		Object.assign(world.state, copyOf(state));
		world.useSystem(system);
		world.restoreBlocks();
		all.forEach((agent, i) => restore(agent, traits[i]));
		world.collisions.collision.restore(bytes, searched);
		this.shown = at;
	}

	/** Removes the frames after the one that is shown, because the game goes on from there. */
	goOn() {
		if (this.shown === undefined) return;
		for (const { all } of this.#frames.splice(this.shown + 1)) this.#agentCount -= all.length;
		this.shown = undefined;
	}
}

/** A copy of a world's state, for a frame. Of what is not copied here, each change makes another object. */
const copyOf = (state) => ({
	...state, variables: { ...state.variables }, totals: new Map(state.totals), events: [...state.events], threads: state.threads.map((thread) => thread.copy()),
});

function restore(agent, { x, y, z, ...others }) {
	Object.assign(agent, others);
	agent.moveTo(x, y, z);
}
