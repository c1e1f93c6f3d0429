/** The breeds that have collision blocks, from the client's State, and the handlers of a Collision for them. */
export class Blocks {
	#state;
	#handler;
	#present = [];
	#next = [];
	#lists = new Map();
	#pairs = [];
	#collision = null;

	/** Ids of the breeds that appear in any block. */
	breedsWithBlocks = new Set();

	/** Reads the client's State. The handler is called with each pair of Agents that has a block. */
	constructor(state, handler) {
		this.#state = state;
		this.#handler = handler;
	}

	/** Gives a Collision the handlers of the blocks that there are now. */
	followState(collision) {
		const { collidingBreeds, collidedBreeds } = this.#state;
		const next = this.#next;
		let count = 0;
		for (const id of collidingBreeds) {
			const others = collidedBreeds.get(id);
			if (!others) continue;
			next[count++] = id;
			next[count++] = others.length;
			for (let i = 0; i < others.length; i++) next[count++] = others[i];
		}
		next.length = count;
		if (collision === this.#collision && count === this.#present.length && next.every((id, i) => id === this.#present[i])) return;
		this.#next = this.#present;
		this.#present = next;
		if (this.#collision) for (const [id, other] of this.#pairs) this.#collision.removeHandler(id, other, this.#handler);
		this.#collision = collision;
		this.#change();
	}

	/** The place of one breed in another breed's list of breeds to look for; -1 if it is not there. */
	rank(breed, other) {
		return this.#lists.get(breed)?.get(other) ?? -1;
	}

	#change() {
		this.#lists = new Map();
		this.#pairs = [];
		this.breedsWithBlocks = new Set();
		for (let i = 0; i < this.#present.length; i += 2 + this.#present[i + 1]) {
			const id = this.#present[i];
			const ranks = new Map();
			for (let k = 0; k < this.#present[i + 1]; k++) {
				const other = this.#present[i + 2 + k];
				// a breed may appear twice: in its own block and in a block for everyone
				if (ranks.has(other)) continue;
				ranks.set(other, k);
				this.breedsWithBlocks.add(id).add(other);
				// handlers on both sides would call twice
				if (!this.#lists.get(other)?.has(id)) this.#pairs.push([String(id), String(other)]);
			}
			this.#lists.set(id, ranks);
		}
		for (const [id, other] of this.#pairs) this.#collision.onCollision(id, other, this.#handler);
	}
}
