/** The floor of the broad phase: unit spheres in flat typed arrays, hand-written for them alone. benchmark.FlatCells, in JavaScript. */
export class FlatCells {
	/** How many numbers <code>pairs</code> holds: two a pair. */
	length = 0;

	/**
	 * @param halfWidth of the ground
	 * @param diameter of the largest sphere
	 * @param count how many spheres there are
	 */
	constructor(halfWidth, diameter, count) {
		// a border of empty cells all around spares the inner loop its checks
		this.origin = -halfWidth - diameter;
		this.perWidth = 1 / diameter;
		this.columns = Math.trunc(2 * halfWidth / diameter) + 4;
		this.heads = new Int32Array(this.columns * this.columns);
		this.offsets = Int32Array.of(1, this.columns - 1, this.columns, this.columns + 1);
		this.cells = new Int32Array(count);
		this.next = new Int32Array(count + 1);
		this.pairs = new Int32Array(64 * count);
		[this.x, this.y, this.z, this.radius] = Array.from({ length: 4 }, () => new Float64Array(count));
	}

	/** Takes the places of agents over. */
	take(agents) {
		agents.forEach((agent, i) => {
			this.x[i] = agent.x;
			this.y[i] = agent.y;
			this.z[i] = agent.z + 0.5 * agent.size;
			this.radius[i] = 0.5 * agent.size;
		});
	}

	/** Finds the pairs that touch. */
	find() {
		const { x, y, z, radius, heads, cells, next, offsets, pairs, columns, origin, perWidth } = this;
		const count = x.length;
		let found = 0;
		heads.fill(0);
		for (let i = 0; i < count; i++) {
			const cell = Math.trunc((y[i] - origin) * perWidth) * columns + Math.trunc((x[i] - origin) * perWidth);
			cells[i] = cell;
			next[i + 1] = heads[cell];
			heads[cell] = i + 1;
		}
		for (let i = 0; i < count; i++) {
			const xi = x[i];
			const yi = y[i];
			const zi = z[i];
			const ri = radius[i];
			const cell = cells[i];
			// the rest of its own cell, then four of the eight around it
			let link = next[i + 1];
			for (let neighbour = 0; neighbour < 5; neighbour++) {
				while (link !== 0) {
					const j = link - 1;
					link = next[link];
					const dx = x[j] - xi;
					if (dx > 1 || dx < -1) continue;
					const dy = y[j] - yi;
					if (dy > 1 || dy < -1) continue;
					const dz = z[j] - zi;
					const reach = ri + radius[j];
					if (dx * dx + dy * dy + dz * dz <= reach * reach) {
						pairs[found] = i;
						pairs[found + 1] = j;
						found += 2;
					}
				}
				if (neighbour < 4) link = heads[cell + offsets[neighbour]];
			}
		}
		this.length = found;
	}
}
