import { Cells } from "./cells.js";

/** The id of the breed that means all breeds. */
const EVERYONE = 1;

/**
 * Counts the agents near one, and finds the nearest. The client's blocks move agents without telling: so a question reads all places once a tick, and after
 * collisions, whose blocks then run, again those of the agents that collided.
 */
export class Neighbours {
	#execution;
	#state;
	#equals;
	#half;
	#records;

	/** Where the agents were last. */
	cells;

	/** The tick in which all places were last read. */
	#tick = NaN;
	/** The pairs that collided last, whose blocks may move them, and the tick in which these run. */
	#pairsWithBlocks = [];
	#blocksRunIn = NaN;

	/**
	 * @param window the client's
	 * @param half half the width of its ground
	 * @param records those of all agents
	 */
	constructor(window, half, records) {
		this.#execution = window.Execution;
		this.#state = window.Common.State;
		this.#equals = window.Helper?.Comparison?.equals ?? Object.is;
		this.#half = half;
		this.#records = records;
		this.cells = new Cells(half);
	}

	/** Counts the agents of a breed within a radius of an agent, optionally only those with a value of a trait. */
	count(agent, breedName, radius, trait, value) {
		const reach = Number(radius);
		const breed = this.#breedOf(breedName);
		if (reach > 2 * Math.SQRT2 * this.#half) return this.#countAll(breed, trait, value);
		this.#refresh();
		return reach >= 0 ? this.cells.count(agent, breed, reach, this.#asks(trait, value)) : 0;
	}

	/** The nearest agent of a breed within a radius, optionally with a value of a trait. If there is none, the agent itself. */
	nearest(agent, breedName, radius, trait, value) {
		const reach = Number(radius);
		const breed = this.#breedOf(breedName);
		this.#refresh();
		return (reach >= 0 ? this.cells.nearest(agent, breed, reach, this.#asks(trait, value)) : null) ?? agent;
	}

	/** Removes all records. */
	clear() {
		this.cells.clear();
		this.#pairsWithBlocks = [];
	}

	/** Makes the next question read all places again. */
	forgetPlaces() {
		this.#tick = NaN;
	}

	/**
	 * Call it with the pairs that were found, before the client runs their blocks. The first question after this, and the first in the next tick, read
	 * all places.
	 */
	blocksRunFor(pairs) {
		this.#pairsWithBlocks = pairs;
		this.#blocksRunIn = this.#state.clock;
		this.forgetPlaces();
	}

	/** Reads the places of all agents that may have moved unannounced: once a tick of all agents, later of those whose blocks run. */
	#refresh() {
		if (this.#state.clock !== this.#tick) {
			this.#tick = this.#state.clock;
			for (const record of this.#records) this.cells.insert(record);
		} else if (this.#blocksRunIn === this.#tick) {
			for (const { a, b } of this.#pairsWithBlocks) {
				this.#reinsert(a);
				this.#reinsert(b);
			}
		}
	}

	/** Reads the place of an agent again, unless it was removed. */
	#reinsert({ jbins: [record] }) {
		if (record) this.cells.insert(record);
	}

	/** The breed with a name; null for all breeds. */
	#breedOf(name) {
		const breed = this.#execution.AgentController.getByName(name);
		if (!breed) throw new RangeError(`there is no breed "${name}"`);
		return breed.id === EVERYONE ? null : breed;
	}

	#asks(trait, value) {
		const equals = this.#equals;
		return trait ? (other) => equals(other.getTrait(trait), value) : null;
	}

	/**
	 * Counts all agents, as the client does for a radius beyond the ground's diagonal. That includes the asker, and the World if all breeds
	 * count.
	 */
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
