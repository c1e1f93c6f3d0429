/** Cells per side: ten on the ground, and one on either side for places beyond it. */
const SIDE = 12;
const LAST = SIDE - 1;

/** For each column or row, all of them, the nearest first. */
const OUTWARD = Array.from({ length: SIDE }, (_, from) => Array.from({ length: SIDE }, (_, to) => to).sort((a, b) => Math.abs(a - from) - Math.abs(b - from)));

/**
 * Finds near agents of the client. It keeps each agent in a square cell of the ground, by its last known place. A question reads the
 * present places of its candidates. So it can miss only an agent that has moved to another cell and was not inserted again. Height, breed and traits
 * are always the present ones.
 */
export class Cells {
	#half;
	#width;
	#cells = Array.from({ length: SIDE * SIDE }, () => []);

	// the squares of the distances to a row
	#rowDistances = new Float64Array(SIDE);

	/** Creates cells for a ground from -half to half. */
	constructor(half) {
		this.#half = half;
		this.#width = 2 * half / (SIDE - 2);
	}

	/** Removes all records. */
	clear() {
		for (const cell of this.#cells) cell.length = 0;
	}

	/** Inserts a record, { clientAgent, cell, slot }, into the cell of its agent. The cell of a new record is -1. */
	insert(record) {
		const { x, y } = record.clientAgent.state;
		const cell = this.#index(x) * SIDE + this.#index(y);
		if (cell === record.cell) return;
		this.remove(record);
		record.cell = cell;
		record.slot = this.#cells[cell].push(record) - 1;
	}

	/** Removes a record, if it is present. */
	remove(record) {
		if (record.cell < 0) return;
		const list = this.#cells[record.cell];
		const last = list.pop();
		if (last !== record) {
			list[record.slot] = last;
			last.slot = record.slot;
		}
		record.cell = -1;
	}

	/**
	 * Counts other agents within a radius, including its border. `breed` null counts all breeds. `accepts` may be null; otherwise it must
	 * return true.
	 */
	count(asker, breed, radius, accepts) {
		const { x, y, z } = asker.state;
		const reach = radius * radius;
		const lowX = this.#index(x - radius);
		const highX = this.#index(x + radius);
		const lowY = this.#index(y - radius);
		const highY = this.#index(y + radius);
		const rowDistances = this.#rowDistances;
		for (let row = lowY; row <= highY; row++) rowDistances[row] = this.#leastDistance(y, row) ** 2;
		let found = 0;
		for (let column = lowX; column <= highX; column++) {
			const near = reach - this.#leastDistance(x, column) ** 2;
			for (let row = lowY; row <= highY; row++) {
				if (rowDistances[row] > near) continue;
				const list = this.#cells[column * SIDE + row];
				for (let i = 0; i < list.length; i++) {
					const other = list[i].clientAgent;
					if ((breed !== null && other.breed !== breed) || other.isDead) continue;
					const state = other.state;
					const dx = x - state.x;
					const dy = y - state.y;
					const dz = z - state.z;
					if (!(dx * dx + dy * dy + dz * dz <= reach)) continue;
					if (other !== asker && (accepts === null || accepts(other))) found++;
				}
			}
		}
		return found;
	}

	/**
	 * The nearest other agent within a radius; null if there is none. Of equally near agents, the one with the smallest id. The parameters are
	 * those of count.
	 */
	nearest(asker, breed, radius, accepts) {
		const { x, y, z } = asker.state;
		const rows = OUTWARD[this.#index(y)];
		let best = null;
		let least = radius * radius;
		for (const column of OUTWARD[this.#index(x)]) {
			const columnDistance = this.#leastDistance(x, column) ** 2;
			if (columnDistance > least) continue;
			for (const row of rows) {
				if (columnDistance + this.#leastDistance(y, row) ** 2 > least) continue;
				const list = this.#cells[column * SIDE + row];
				for (let i = 0; i < list.length; i++) {
					const other = list[i].clientAgent;
					if ((breed !== null && other.breed !== breed) || other.isDead || other === asker) continue;
					const state = other.state;
					const dx = x - state.x;
					const dy = y - state.y;
					const dz = z - state.z;
					const squared = dx * dx + dy * dy + dz * dz;
					if (squared < least || (squared === least && (best === null || other.id < best.id))) {
						if (accepts !== null && !accepts(other)) continue;
						best = other;
						least = squared;
					}
				}
			}
		}
		return best;
	}

	/** The column or row of a coordinate; 0 for NaN. */
	#index(coordinate) {
		const index = Math.floor((coordinate + this.#half) / this.#width) + 1;
		return index >= LAST ? LAST : index > 0 ? index : 0;
	}

	/** The distance to a column or row, a little smaller because of rounding. */
	#leastDistance(coordinate, index) {
		const low = index === 0 ? -Infinity : (index - 1) * this.#width - this.#half;
		const high = index === LAST ? Infinity : index * this.#width - this.#half;
		return Math.max(low - coordinate, coordinate - high, 1e-9) - 1e-9;
	}
}
