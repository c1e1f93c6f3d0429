/** Makes vertices of points. Equal positions become one vertex, because exporters repeat them for normals and textures. */
export class Welder {
	#vertices;
	#slots = new Int32Array(1024).fill(-1); // by hash: a vertex. The next free slot is taken if several have one hash
	#bits = new Float64Array(3);
	#words = new Int32Array(this.#bits.buffer);
	#isYUp;
	// of the mesh at hand
	#points;
	#elements;
	#meshVertices;

	/**
	 * @param {number[]} vertices x, y, z, ...: new positions are appended
	 * @param {boolean} isYUp whether the points have y up
	 */
	constructor(vertices, isYUp) {
		this.#vertices = vertices;
		this.#isYUp = isYUp;
	}

	/** Begins a mesh: its points, its matrix, and the list that gets the corners that become vertices. */
	begin(points, matrix, meshVertices) {
		this.#points = points;
		this.#elements = matrix.elements;
		this.#meshVertices = meshVertices;
		// at most half of the slots are taken in the end
		const needed = 2 * ((this.#vertices.length + points.length) / 3);
		if (needed > this.#slots.length) this.#grow(2 ** Math.ceil(Math.log2(2 * needed)));
	}

	/** The vertex at a point, which is new if its position is. This is Vector3.applyMatrix4 and toEngineAxes, in half of the time; -0 becomes 0. */
	vertexAt(corner) {
		const points = this.#points;
		const e = this.#elements;
		const px = points[3 * corner];
		const py = points[3 * corner + 1];
		const pz = points[3 * corner + 2];
		const w = 1 / (e[3] * px + e[7] * py + e[11] * pz + e[15]);
		const x = (e[0] * px + e[4] * py + e[8] * pz + e[12]) * w + 0;
		const sceneY = (e[1] * px + e[5] * py + e[9] * pz + e[13]) * w + 0;
		const sceneZ = (e[2] * px + e[6] * py + e[10] * pz + e[14]) * w + 0;
		return this.#isYUp ? this.#vertexOf(x, 0 - sceneZ, sceneY, corner) : this.#vertexOf(x, sceneY, sceneZ, corner);
	}

	#vertexOf(x, y, z, corner) {
		const vertices = this.#vertices;
		const slots = this.#slots;
		let slot = this.#slotOf(x, y, z);
		for (let i = slots[slot]; i >= 0; i = slots[slot]) {
			const at = 3 * i;
			// in one expression: V8 compiles again what it has not met before, such as a second comparison
			if (Math.abs(vertices[at] - x) + Math.abs(vertices[at + 1] - y) + Math.abs(vertices[at + 2] - z) === 0) return i;
			slot = (slot + 1) & (slots.length - 1);
		}
		const { length } = vertices;
		vertices.push(x, y, z);
		this.#meshVertices.push(corner);
		return (slots[slot] = length / 3);
	}

	#grow(length) {
		const vertices = this.#vertices;
		const slots = (this.#slots = new Int32Array(length).fill(-1));
		for (let i = 0; 3 * i < vertices.length; i++) {
			let slot = this.#slotOf(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
			while (slots[slot] >= 0) slot = (slot + 1) & (length - 1);
			slots[slot] = i;
		}
	}

	/** The first slot in which a position may be. */
	#slotOf(x, y, z) {
		const words = this.#words;
		this.#bits[0] = x;
		this.#bits[1] = y;
		this.#bits[2] = z;
		let hash = Math.imul(words[0] ^ words[1], 0x9e3779b1);
		hash = Math.imul(hash ^ (hash >>> 15) ^ words[2] ^ words[3], 0x9e3779b1);
		hash = Math.imul(hash ^ (hash >>> 15) ^ words[4] ^ words[5], 0x9e3779b1);
		return (hash ^ (hash >>> 15)) & (this.#slots.length - 1);
	}
}
