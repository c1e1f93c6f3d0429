/** The breeds that have collision blocks, from the client's State, and the handlers of a Collision for them. */
export class Blocks {
	#state;
	#collision;
	#handler;
	#present = "";
	#ranks = new Map();
	#pairs = [];

	/** Ids of the breeds that appear in any block. */
	breedsWithBlocks = new Set();

	/** Reads the client's State. The Collision calls the handler with each pair of Agents that has a block. */
	constructor(state, collision, handler) {
		this.#state = state;
		this.#collision = collision;
		this.#handler = handler;
	}

	/** Gives the Collision the handlers of the blocks that there are now. */
	followState() {
		const { collidingBreeds, collidedBreeds } = this.#state;
		const blocks = Array.from(collidingBreeds, (id) => [id, collidedBreeds.get(id) ?? []]);
		const present = JSON.stringify(blocks);
		if (present === this.#present) return;
		for (const [id, other] of this.#pairs) this.#collision.removeHandler(id, other, this.#handler);
		this.#present = present;
		this.#pairs = [];
		this.#ranks = new Map(blocks.map(([id]) => [id, new Map()]));
		this.breedsWithBlocks = new Set();
		for (const [id, others] of blocks) others.forEach((other, rank) => this.#add(id, other, rank));
		for (const [id, other] of this.#pairs) this.#collision.onCollision(id, other, this.#handler);
	}

	/** The place of one breed in another breed's list of breeds to look for; -1 if it is not there. */
	rank(breed, other) {
		return this.#ranks.get(breed)?.get(other) ?? -1;
	}

	#add(id, other, rank) {
		const ranks = this.#ranks.get(id);
		// a breed may appear twice: in its own block and in a block for everyone
		if (ranks.has(other)) return;
		ranks.set(other, rank);
		this.breedsWithBlocks.add(id).add(other);
		// handlers on both sides would call twice; a breed's handler for itself is one
		if (id === other || this.rank(other, id) < 0) this.#pairs.push([String(id), String(other)]);
	}
}
