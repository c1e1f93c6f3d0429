/**
 * The floor of the broad phase: agents that are unit spheres over a bounded ground, hand-written for them alone, in flat typed arrays.
 * benchmark.AgentCells, in JavaScript.
 */
export class AgentCells {
	/**
	 * @param halfWidth the ground reaches from -halfWidth to halfWidth in x and y
	 * @param count how many agents there are
	 */
	constructor(halfWidth, count) {
		// a border of empty cells all around spares the inner loop its checks
		this.shift = halfWidth + 1;
		this.columns = Math.trunc(2 * halfWidth + 1) + 2;
		this.starts = new Int32Array(this.columns * this.columns + 2);
		[this.cells, this.order] = Array.from({ length: 2 }, () => new Int32Array(count));
		[this.readX, this.readY, this.readZ, this.x, this.y, this.z] = Array.from({ length: 6 }, () => new Float64Array(count));
	}

	/** Finds the pairs that touch: a0, b0, a1, b1, ... */
	find(agents, out) {
		this.sort(agents);
		const { order, x, y, z, starts, columns } = this;
		const last = columns * (columns - 1) - 2;
		let found = 0;
		let end = 0;
		for (let cell = columns + 1; cell <= last; cell++) {
			let i = end;
			end = starts[cell + 1];
			if (i === end) continue;
			const right = starts[cell + 2];
			const below = starts[cell + columns - 1];
			const belowEnd = starts[cell + columns + 2];
			for (; i < end; i++) {
				const xi = x[i];
				const yi = y[i];
				const zi = z[i];
				const agent = agents[order[i]];
				// the rest of its own cell and the cell to the right
				for (let j = i + 1; j < right; j++) {
					const dx = x[j] - xi;
					if (dx > 1) continue;
					const dy = y[j] - yi;
					const dz = z[j] - zi;
					if (dx * dx + dy * dy + dz * dz <= 1) {
						out[found] = agent;
						out[found + 1] = agents[order[j]];
						found += 2;
					}
				}
				// the three cells below
				for (let j = below; j < belowEnd; j++) {
					const dx = x[j] - xi;
					const dy = y[j] - yi;
					const dz = z[j] - zi;
					if (dx * dx + dy * dy + dz * dz <= 1) {
						out[found] = agent;
						out[found + 1] = agents[order[j]];
						found += 2;
					}
				}
			}
		}
		out.length = found;
	}

	/** Reads the agents, and puts them into the order of their cells. */
	sort(agents) {
		const { readX, readY, readZ, cells, starts, columns, shift, order, x, y, z } = this;
		const count = agents.length;
		starts.fill(0);
		for (let i = 0; i < count; i++) {
			const agent = agents[i];
			const ax = agent.x;
			const ay = agent.y;
			readX[i] = ax;
			readY[i] = ay;
			readZ[i] = agent.z;
			const cell = Math.trunc(ay + shift) * columns + Math.trunc(ax + shift);
			cells[i] = cell;
			starts[cell]++;
		}
		let sum = 0;
		for (let cell = 0; cell < starts.length; cell++) {
			sum += starts[cell];
			starts[cell] = sum;
		}
		// each cell's end becomes its start
		for (let i = 0; i < count; i++) {
			const place = --starts[cells[i]];
			order[place] = i;
			x[place] = readX[i];
			y[place] = readY[i];
			z[place] = readZ[i];
		}
	}
}
