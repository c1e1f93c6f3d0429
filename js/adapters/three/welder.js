import { Vector3 } from "three";
import { turnToEngine } from "./axes.js";

/** Makes vertices of points. Equal positions become one vertex, because exporters repeat them for normals and textures. */
export class Welder {
	#vertices;
	#slots = new Int32Array(1024).fill(-1); // by hash: a vertex. The next free slot is taken if several have one hash
	#bits = new Float64Array(3);
	#words = new Int32Array(this.#bits.buffer);
	#point = new Vector3();
	#isYUp;
	// of the mesh at hand
	#points;
	#matrix;
	#takenCorners;

	/**
	 * @param {number[]} vertices x, y, z, ...: new positions are appended
	 * @param {boolean} isYUp whether the points have y up
	 */
	constructor(vertices, isYUp) {
		this.#vertices = vertices;
		this.#isYUp = isYUp;
	}

	/** Begins a mesh: its points, its matrix, and the list that gets the corners that become vertices. */
	begin({ points, matrix, vertices }) {
		this.#points = points;
		this.#matrix = matrix;
		this.#takenCorners = vertices;
		// at most half of the slots are taken in the end
		const needed = 2 * ((this.#vertices.length + points.length) / 3);
		if (needed > this.#slots.length) this.#grow(2 ** Math.ceil(Math.log2(2 * needed)));
	}

	/** The vertex at a point, which is new if its position is. -0 becomes 0. */
	vertexAt(corner) {
		const { x, y, z } = turnToEngine(this.#point.fromArray(this.#points, 3 * corner).applyMatrix4(this.#matrix), this.#isYUp);
		return this.#vertexOf(x + 0, y + 0, z + 0, corner);
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
		this.#takenCorners.push(corner);
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
