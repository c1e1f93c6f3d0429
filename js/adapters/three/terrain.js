import { BufferAttribute, BufferGeometry } from "three";
import { ArgumentError, Terrain } from "starlogo-collision";
import { isYUp, textOf } from "./axes.js";
import { surfaceOf } from "./model.js";

/** How far outside of a triangle a place may be and still count, as a part of the triangle: so rounding leaves no gap between two. */
const ROUNDING = 1e-9;

/** The surface of a terrain, as a geometry in the axes of the land. */
export class TerrainGeometry extends BufferGeometry {
	#terrain;
	#isYUp;
	#isBlocky;
	#revision = -1;
	#next = 0;

	/**
	 * @param {object} terrain the ground
	 * @param {{up?: "y" | "z"}} options the up axis of the land
	 */
	constructor(terrain, { up = "y" } = {}) {
		super();
		if (!(terrain instanceof Terrain)) throw new ArgumentError(`a Terrain is needed, not ${textOf(terrain)}`);
		this.#terrain = terrain;
		this.#isYUp = isYUp(up);
		this.update();
	}

	get terrain() { return this.#terrain; }

	/** Takes over the heights. Returns whether the ground has changed. */
	update() {
		const { revision, isBlocky } = this.#terrain.$grid;
		if (revision === this.#revision && isBlocky === this.#isBlocky) return false;
		if (isBlocky !== this.#isBlocky) this.#makeRoom(isBlocky);
		this.#revision = revision;
		this.#isBlocky = isBlocky;
		this.#next = 0;
		if (isBlocky) this.#writeBlocks();
		else this.#writeSlopes();
		this.getAttribute("position").needsUpdate = true;
		// flat for blocks, because they share no vertices
		this.computeVertexNormals();
		this.computeBoundingBox();
		this.computeBoundingSphere();
		return true;
	}

	#makeRoom(isBlocky) {
		const { columns, rows } = this.#terrain;
		// each block has a top, and a wall between it and each neighbour
		const squares = isBlocky ? 3 * columns * rows - columns - rows : (columns - 1) * (rows - 1);
		const index = new Uint32Array(6 * squares);
		for (let i = 0; i < squares; i++) {
			const first = isBlocky ? 4 * i : i + Math.floor(i / (columns - 1));
			const up = isBlocky ? 3 : columns;
			const across = isBlocky ? 2 : columns + 1;
			index.set([first, first + 1, first + across, first, first + across, first + up], 6 * i);
		}
		this.dispose();
		this.setIndex(new BufferAttribute(index, 1));
		this.setAttribute("position", new BufferAttribute(new Float32Array(3 * (isBlocky ? 4 * squares : columns * rows)), 3));
		this.deleteAttribute("normal");
	}

	#writeSlopes() {
		const { columns, rows, cellWidth, x, y } = this.#terrain;
		for (let row = 0; row < rows; row++) for (let column = 0; column < columns; column++) {
			this.#add(x + column * cellWidth, y + row * cellWidth, this.#terrain.getHeight(column, row));
		}
	}

	#writeBlocks() {
		const terrain = this.#terrain;
		const { columns, rows, cellWidth } = terrain;
		for (let row = 0; row < rows; row++) for (let column = 0; column < columns; column++) {
			const height = terrain.getHeight(column, row);
			const [left, front] = [terrain.x + (column - 0.5) * cellWidth, terrain.y + (row - 0.5) * cellWidth];
			const [right, back] = [left + cellWidth, front + cellWidth];
			this.#add(left, front, height);
			this.#add(right, front, height);
			this.#add(right, back, height);
			this.#add(left, back, height);
			// a wall faces the lower block, because the sign of the heights' difference turns its corners round
			if (column + 1 < columns) this.#addWall(right, front, right, back, terrain.getHeight(column + 1, row), height);
			if (row + 1 < rows) this.#addWall(right, back, left, back, terrain.getHeight(column, row + 1), height);
		}
	}

	#addWall(x, y, toX, toY, from, to) {
		this.#add(x, y, from);
		this.#add(toX, toY, from);
		this.#add(toX, toY, to);
		this.#add(x, y, to);
	}

	/** Adds a vertex; z is up. */
	#add(x, y, z) {
		if (this.#isYUp) this.getAttribute("position").setXYZ(this.#next++, x, z, -y);
		else this.getAttribute("position").setXYZ(this.#next++, x, y, z);
	}
}

/**
 * A terrain with the heights of an object: at each place that of its highest triangle. Where there is no triangle, the height is the least
 * of the others, or 0.
 *
 * @param {object} source an Object3D, whose parent is the land, or a BufferGeometry
 * @param {number} columns how many heights there are along x
 * @param {number} rows how many there are along y
 * @param {number} cellWidth how far neighbours are apart
 * @param {number} x where the first height is, in the engine's axes
 * @param {number} y where the first height is
 * @param {{up?: "y" | "z"}} options the up axis of the land
 */
export function terrainFromMesh(source, columns, rows, cellWidth = 1, x = 0, y = 0, { up = "y" } = {}) {
	const terrain = new Terrain(columns, rows, cellWidth, x, y);
	const { vertices, triangles } = surfaceOf("terrain", source, up, true);
	const heights = new Array(columns * rows).fill(-Infinity);
	// the corners, counted in cells from the first height
	const cornerOf = (i) => ({ x: (vertices[3 * i] - x) / cellWidth, y: (vertices[3 * i + 1] - y) / cellWidth, z: vertices[3 * i + 2] });
	for (let i = 0; i < triangles.length; i += 3) {
		raise(heights, columns, rows, cornerOf(triangles[i]), cornerOf(triangles[i + 1]), cornerOf(triangles[i + 2]));
	}
	const least = heights.reduce((most, height) => (height > -Infinity ? Math.min(most, height) : most), Infinity);
	const missing = least < Infinity ? least : 0;
	terrain.setHeights(0, 0, columns, rows, heights.map((height) => (height > -Infinity ? height : missing)));
	return terrain;
}

/** Raises the heights that are below a triangle to it. */
function raise(heights, columns, rows, a, b, c) {
	const area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
	const [lowest, highest] = [Math.min(a.z, b.z, c.z), Math.max(a.z, b.z, c.z)];
	// an upright triangle has edges that belong to others, too
	if (!(Math.abs(area) > 0 && Number.isFinite(lowest) && Number.isFinite(highest))) return;
	const lastColumn = Math.min(columns - 1, Math.floor(Math.max(a.x, b.x, c.x) + ROUNDING));
	const lastRow = Math.min(rows - 1, Math.floor(Math.max(a.y, b.y, c.y) + ROUNDING));
	for (let row = Math.max(0, Math.ceil(Math.min(a.y, b.y, c.y) - ROUNDING)); row <= lastRow; row++) {
		for (let column = Math.max(0, Math.ceil(Math.min(a.x, b.x, c.x) - ROUNDING)); column <= lastColumn; column++) {
			const ofB = ((column - a.x) * (c.y - a.y) - (c.x - a.x) * (row - a.y)) / area;
			const ofC = ((b.x - a.x) * (row - a.y) - (column - a.x) * (b.y - a.y)) / area;
			if (!(ofB >= -ROUNDING && ofC >= -ROUNDING && ofB + ofC <= 1 + ROUNDING)) continue;
			const height = Math.max(lowest, Math.min(highest, a.z + ofB * (b.z - a.z) + ofC * (c.z - a.z)));
			const at = row * columns + column;
			heights[at] = Math.max(heights[at], height);
		}
	}
}
