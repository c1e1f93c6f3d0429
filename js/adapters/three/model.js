import { Matrix4, Mesh, Vector3 } from "three";
import { Model, ModelError } from "starlogo-collision";
import { isYUp, textOf } from "./axes.js";

const axes = new WeakMap();

/** The up axis of a model's source, or undefined. */
export const upOf = (model) => axes.get(model);

/**
 * A model of an object and everything below it, or of a geometry. Every mesh counts, visible or not, in its present pose.
 *
 * @param {string} name what agents call the shape
 * @param {object} source an Object3D, whose own transform does not count, or a BufferGeometry
 * @param {{up?: "y" | "z", scaling?: string}} options the up axis of the source, and how the model is scaled (Model's scalings)
 */
export function modelFromObject(name, source, { up = "y", scaling = Model.FOOTPRINT } = {}) {
	return modelOf(name, surfaceOf(name, source, up), up, scaling);
}

/**
 * A model of a level that is drawn in the land: one unit of the land is a patch, and an agent at the origin collides where the level is drawn.
 *
 * @param {string} name what the level's agent calls the shape
 * @param {object} object an Object3D, whose parent is the land, or a BufferGeometry
 * @param {{up?: "y" | "z"}} options the up axis of the land
 */
export function levelFromObject(name, object, { up = "y" } = {}) {
	return modelOf(name, surfaceOf(name, object, up, true), up, Model.AS_GIVEN);
}

function modelOf(name, { vertices, triangles }, up, scaling) {
	const model = new Model(name, vertices, triangles, scaling);
	axes.set(model, up);
	return model;
}

/** The vertices and triangles of an object or a geometry, z up. With `isPlaced` the object's own transform counts. */
export function surfaceOf(name, source, up, isPlaced = false) {
	const surface = new Surface(name, isYUp(up));
	if (source?.isBufferGeometry) surface.addMesh(new Mesh(source), new Matrix4());
	else if (source?.isObject3D) {
		source.updateWorldMatrix(true, false);
		source.updateMatrixWorld();
		surface.addTree(source, isPlaced ? source.matrix : new Matrix4());
	} else throw new ModelError(String(name), "", `expected an Object3D or a BufferGeometry, not ${textOf(source)}`);
	return surface;
}

/** Triangles and their corners, z up. Each position appears once. */
class Surface {
	vertices = [];
	triangles = [];
	#name;
	#isYUp;
	#known = new PointTable(this.vertices);

	constructor(name, isYUp) {
		this.#name = name;
		this.#isYUp = isYUp;
	}

	/** Adds the meshes of a tree. The matrix is the object's place in the source. For the source itself it is the identity. */
	addTree(object, place) {
		if (object.isMesh) this.addMesh(object, place);
		for (const child of object.children) {
			// the first of an object's levels of detail is the finest
			if (object.isLOD && object.levels.findIndex((level) => level.object === child) > 0) continue;
			this.addTree(child, place.clone().multiply(child.matrix));
		}
	}

	addMesh(mesh, place) {
		if (mesh.isBatchedMesh) {
			this.#addBatch(mesh, place);
			return;
		}
		const { geometry } = mesh;
		const position = geometry.getAttribute("position");
		if (!position) return;
		const corners = cornersOf(geometry, mesh.material);
		const { count } = position;
		for (let i = 0; i < corners.length; i++) if (!(corners[i] < count)) throw this.#error(mesh, `a triangle names vertex ${corners[i]}, the last one is ${count - 1}`);
		const points = pointsOf(mesh, position);
		if (!mesh.isInstancedMesh) this.#add(points, corners, place);
		else for (let i = 0; i < mesh.count; i++) {
			const instance = new Matrix4();
			mesh.getMatrixAt(i, instance);
			this.#add(points, corners, instance.premultiply(place));
		}
	}

	/** Adds all instances of a BatchedMesh, visible or not. Each draws a part of the mesh's geometry. */
	#addBatch(mesh, place) {
		const { index, attributes } = mesh.geometry;
		const shapes = new Map();
		const shapeOf = (id) => {
			const { start, count, vertexStart, vertexCount } = mesh.getGeometryRangeAt(id);
			const points = pointsOf(mesh, attributes.position, vertexStart, vertexCount);
			const corners = Array.from({ length: count }, (_, i) => (index ? index.getX(start + i) : start + i) - vertexStart);
			for (const corner of corners) if (!(corner >= 0 && corner < vertexCount)) throw this.#error(mesh, `a triangle of geometry ${id} names vertex ${corner}, the last one is ${vertexCount - 1}`);
			return { points, corners };
		};
		let left = mesh.instanceCount;
		for (let i = 0; left > 0 && i < mesh.maxInstanceCount; i++) {
			const id = geometryOf(mesh, i);
			if (id < 0) continue;
			left--;
			if (!shapes.has(id)) shapes.set(id, shapeOf(id));
			const { points, corners } = shapes.get(id);
			this.#add(points, corners, mesh.getMatrixAt(i, new Matrix4()).premultiply(place));
		}
	}

	#add(points, corners, place) {
		// scaled to 0, as hidden instances often are
		if (place.getMaxScaleOnAxis() === 0) return;
		const [second, third] = place.determinant() < 0 ? [2, 1] : [1, 2];
		const { triangles } = this;
		const known = this.#known;
		const isYUp = this.#isYUp;
		const numbers = new Int32Array(points.length / 3).fill(-1);
		const at = new Vector3();
		const numberOf = (i) => {
			at.set(points[3 * i], points[3 * i + 1], points[3 * i + 2]).applyMatrix4(place);
			return (numbers[i] = isYUp ? known.indexOf(at.x, -at.z, at.y) : known.indexOf(at.x, at.y, at.z));
		};
		for (let i = 0; i < corners.length; i += 3) {
			const [a, b, c] = [corners[i], corners[i + second], corners[i + third]];
			triangles.push(numbers[a] < 0 ? numberOf(a) : numbers[a], numbers[b] < 0 ? numberOf(b) : numbers[b], numbers[c] < 0 ? numberOf(c) : numbers[c]);
		}
	}

	#error(mesh, problem) {
		const title = mesh.name || mesh.geometry.name;
		return new ModelError(String(this.#name), title && `mesh "${title}"`, problem);
	}
}

/** The places of a mesh's vertices in its own space, x, y, z, ..., in its present pose: of all, or of some from a first one on. */
function pointsOf(mesh, position, first = 0, count = position.count) {
	const points = new Float64Array(3 * count);
	const isPosed = mesh.isSkinnedMesh || mesh.geometry.morphAttributes.position !== undefined;
	if (mesh.isSkinnedMesh) for (const bone of mesh.skeleton.bones) bone.updateWorldMatrix(true, false);
	const at = new Vector3();
	for (let i = 0; i < count; i++) {
		if (isPosed) mesh.getVertexPosition(first + i, at);
		else at.fromBufferAttribute(position, first + i);
		points[3 * i] = at.x;
		points[3 * i + 1] = at.y;
		points[3 * i + 2] = at.z;
	}
	return points;
}

/** The number of the geometry of an instance of a BatchedMesh; -1 if the instance was deleted. */
function geometryOf(mesh, instance) {
	try {
		return mesh.getGeometryIdAt(instance);
	} catch {
		return -1;
	}
}

/**
 * The vertices of the triangles that are drawn, three each: those in the draw range and, with several materials, in the groups that have
 * one.
 */
function cornersOf({ index, attributes, drawRange, groups }, material) {
	const total = index ? index.count : attributes.position.count;
	const drawn = Array.isArray(material) ? groups.filter(({ materialIndex }) => material[materialIndex]) : [{ start: 0, count: total }];
	const taken = new Uint8Array(total);
	const corners = new Float64Array(3 * total);
	let length = 0;
	for (const { start, count } of drawn) {
		const end = Math.min(total, start + count, drawRange.start + drawRange.count);
		for (let i = Math.max(start, drawRange.start); i + 2 < end; i += 3) {
			if (taken[i]++) continue;
			for (let k = i; k < i + 3; k++) corners[length++] = index ? index.getX(k) : k;
		}
	}
	return corners.subarray(0, length);
}

/** Gives positions indices. Equal positions get one index, because exporters repeat them for normals and textures. */
class PointTable {
	#points;
	#count = 0;
	#slots = new Int32Array(1024).fill(-1); // by hash: the index of a point. The next free slot is taken if several have one hash
	#hashes = [];
	#bits = new Float64Array(3);
	#words = new Uint32Array(this.#bits.buffer);

	/** @param {number[]} points x, y, z, ...: new positions are appended */
	constructor(points) {
		this.#points = points;
	}

	indexOf(x, y, z) {
		const points = this.#points;
		const slots = this.#slots;
		const last = slots.length - 1;
		const hash = this.#hash(x, y, z);
		let slot = hash & last;
		for (let i = slots[slot]; i >= 0; i = slots[slot]) {
			if (points[3 * i] === x && points[3 * i + 1] === y && points[3 * i + 2] === z) return i;
			slot = (slot + 1) & last;
		}
		const added = this.#count++;
		slots[slot] = added;
		this.#hashes.push(hash);
		points.push(x, y, z);
		if (2 * this.#count > last) this.#grow();
		return added;
	}

	#grow() {
		const slots = new Int32Array(4 * this.#slots.length).fill(-1);
		for (let i = 0; i < this.#count; i++) {
			let slot = this.#hashes[i] & (slots.length - 1);
			while (slots[slot] >= 0) slot = (slot + 1) & (slots.length - 1);
			slots[slot] = i;
		}
		this.#slots = slots;
	}

	#hash(x, y, z) {
		const words = this.#words;
		// turns -0 into 0
		this.#bits[0] = x + 0;
		this.#bits[1] = y + 0;
		this.#bits[2] = z + 0;
		let hash = 0;
		for (let i = 0; i < 6; i++) {
			hash = Math.imul(hash ^ words[i], 0x9e3779b1);
			hash ^= hash >>> 15;
		}
		return hash;
	}
}
