/** The most frames that are kept, and the most agents in all of them together. */
const MOST_FRAMES = 900;
const MOST_AGENTS = 150000;

/** The ground of games that do not choose one. */
const MEADOW = "meadow";

/** The state of a world, beside its agents, at the beginning of a game. A frame that is kept has it. */
export const beginning = (seed) => ({
	frame: 0, seed, made: 0,
	score: null, goal: null, limit: null, ground: MEADOW, ended: null,
	sweeping: {}, breedTraits: new Map(), shownStructures: new Map(), solid: [],
	messages: [], shownVariables: [], variables: {}, threads: [],
	totals: new Map(), meetings: [], meetingCount: 0, pairs: new Map(), touching: 0,
});

const WORLD_FIELDS = Object.keys(beginning(0));
const AGENT_FIELDS = ["shape", "breed", "x", "y", "z", "heading", "pitch", "roll", "size", "color", "hierarchical", "traversalDepth", "collideAs", "sweeps", "born", "said", "rise", "touched", "hit", "isAlive", "own"];

/** Keeps the last frames of a game, so that it can go back. */
export class History {
	/** The number of frames that the world has gone back. */
	back = 0;
	#frames = [];
	#agentCount = 0;

	/** @param {import("./world.js").World} world */
	constructor(world) {
		this.world = world;
	}

	clear() {
		this.#frames.length = this.#agentCount = this.back = 0;
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
		const { agents: living, collisions } = this.world;
		const all = [...new Set([...searched, ...living])];
		this.#frames.push({
			searched, living: [...living], all, states: all.map((agent) => fieldsOf(agent, AGENT_FIELDS)), bytes: collisions.collision.snapshot(), system: collisions.systemName, ofWorld: copyOf(fieldsOf(this.world, WORLD_FIELDS)),
		});
		this.#agentCount += all.length;
		while (this.#frames.length > MOST_FRAMES || (this.#agentCount > MOST_AGENTS && this.#frames.length > 2)) this.#agentCount -= this.#frames.shift().all.length;
	}

	/** Takes the world back to an earlier frame. When the game goes on, the frames after it are removed. */
	show(back) {
		const { world } = this;
		this.back = Math.min(back, this.length);
		const { searched, living, all, states, bytes, system, ofWorld } = this.#frames.at(-1 - this.back);
		world.agents.splice(0, Infinity, ...living);
		Object.assign(world, copyOf(ofWorld));
		world.useSystem(system);
		world.restoreBlocks();
		all.forEach((agent, i) => restore(agent, states[i]));
		world.collisions.collision.restore(bytes, searched);
	}

	/** Removes the frames after the one that is shown, because the game goes on from there. */
	goOn() {
		for (const { all } of this.#frames.splice(this.#frames.length - this.back)) this.#agentCount -= all.length;
		this.back = 0;
	}
}

const fieldsOf = (object, names) => Object.fromEntries(names.map((name) => [name, object[name]]));

/** A copy of a world's state. Of what is not copied here, each change makes another object. */
const copyOf = (state) => ({
	...state, variables: { ...state.variables }, totals: new Map(state.totals), meetings: [...state.meetings], threads: state.threads.map((thread) => thread.copy()),
});

function restore(agent, { x, y, z, ...others }) {
	Object.assign(agent, others);
	agent.moveTo(x, y, z);
}
