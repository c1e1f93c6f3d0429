import { BufferAttribute, BufferGeometry, Vector3 } from "three";
import { ArgumentError, Terrain, TerrainSurface } from "starlogo-collision";
import { optionsOf, textOf } from "./arguments.js";
import { toSceneAxes } from "./axes.js";
import { surfaceOf } from "./surface.js";

/** How far outside of a triangle a place may be and still count, as a part of the triangle: so rounding leaves no gap between two. */
const ROUNDING = 1e-9;

const point = new Vector3();

/** The surface of a terrain, as a geometry in the axes of the land. */
export class TerrainGeometry extends BufferGeometry {
	#terrain;
	#surface;
	#isYUp;

	/**
	 * @param {object} terrain the ground
	 * @param {{up?: "y" | "z"}} options the up axis of the land
	 */
	constructor(terrain, options = {}) {
		const { isYUp } = optionsOf("TerrainGeometry", options);
		super();
		if (!(terrain instanceof Terrain)) throw new ArgumentError(`a Terrain is needed, not ${textOf(terrain)}`);
		this.#follow(terrain, isYUp);
	}

	#follow(terrain, isYUp) {
		this.#terrain = terrain;
		this.#surface = new TerrainSurface(terrain);
		this.#isYUp = isYUp;
		this.update();
	}

	get terrain() { return this.#terrain; }

	/** A geometry of the same ground. */
	clone() {
		return new this.constructor(this.#terrain).copy(this);
	}

	/** Becomes a geometry of another one's ground. */
	copy(source) {
		super.copy(source);
		this.#follow(source.#terrain, source.#isYUp);
		return this;
	}

	/** Takes over the heights. Returns whether the ground has changed. */
	update() {
		if (!this.#surface.update()) return false;
		const { vertices, normals, triangles } = this.#surface;
		// the number of walls may be another
		this.dispose();
		this.setAttribute("position", this.#attributeOf(vertices));
		this.setAttribute("normal", this.#attributeOf(normals));
		this.setIndex(new BufferAttribute(Uint32Array.from(triangles), 1));
		this.computeBoundingBox();
		this.computeBoundingSphere();
		return true;
	}

	#attributeOf(numbers) {
		const array = new Float32Array(numbers.length);
		for (let i = 0; i < array.length; i += 3) toSceneAxes(point.fromArray(numbers, i), this.#isYUp).toArray(array, i);
		return new BufferAttribute(array, 3);
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
export function terrainFromMesh(source, columns, rows, cellWidth = 1, x = 0, y = 0, options = {}) {
	const { isYUp } = optionsOf("terrainFromMesh", options);
	const terrain = new Terrain(columns, rows, cellWidth, x, y);
	const { vertices, triangles } = surfaceOf("terrain", source, isYUp, true).data;
	const heights = new Array(columns * rows).fill(-Infinity);
	// the corners, counted in cells from the first height
	const cornerOf = (i) => ({ x: (vertices[3 * i] - x) / cellWidth, y: (vertices[3 * i + 1] - y) / cellWidth, z: vertices[3 * i + 2] });
	for (let i = 0; i < triangles.length; i += 3) {
		raise(heights, columns, rows, cornerOf(triangles[i]), cornerOf(triangles[i + 1]), cornerOf(triangles[i + 2]));
	}
	const least = heights.reduce((lowest, height) => (height > -Infinity ? Math.min(lowest, height) : lowest), Infinity);
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
