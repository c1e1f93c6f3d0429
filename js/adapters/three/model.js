import { Matrix4, Mesh, Vector3 } from "three";
import { ArgumentError, Model, ModelError } from "starlogo-collision";
import { optionsOf, textOf } from "./arguments.js";
import { isYUp } from "./axes.js";

/** For each model: the up axis of its source, whether that is placed, and of which vertices of which meshes it was made. */
const origins = new WeakMap();

/** The up axis of a model's source, or undefined. */
export const upOf = (model) => origins.get(model)?.up;

const identity = new Matrix4();
const point = new Vector3();

/**
 * A model of an object and everything below it, or of a geometry. Every mesh counts, visible or not, in its present pose.
 *
 * @param {string} name what agents call the shape
 * @param {object} source an Object3D, whose own transform does not count, or a BufferGeometry
 * @param {{up?: "y" | "z", scaling?: string}} options the up axis of the source, and how the model is scaled (Model's scalings)
 */
export function modelFromObject(name, source, options = {}) {
	const { up, scaling } = optionsOf("modelFromObject", options, { up: "y", scaling: Model.FOOTPRINT });
	return modelOf(name, source, surfaceOf(name, source, up), { up, isPlaced: false }, scaling);
}

/**
 * A model of a level that is drawn in the land: one unit of the land is a patch, and an agent at the origin collides where the level is drawn.
 *
 * @param {string} name what the level's agent calls the shape
 * @param {object} object an Object3D, whose parent is the land, or a BufferGeometry
 * @param {{up?: "y" | "z"}} options the up axis of the land
 */
export function levelFromObject(name, object, options = {}) {
	const { up } = optionsOf("levelFromObject", options, { up: "y" });
	return modelOf(name, object, surfaceOf(name, object, up, true), { up, isPlaced: true }, Model.AS_GIVEN);
}

function modelOf(name, source, { vertices, triangles, parts, meshes, materials }, origin, scaling) {
	if (vertices.length === 0) throw new ModelError(name, "", `no vertices: ${whatIsMissing(source)}`);
	const model = new Model(name, vertices, triangles, scaling);
	if (source.isObject3D) {
		model.setMeshes(meshes.numbers, meshes.names);
		model.setMaterials(materials.numbers, materials.names);
	}
	origins.set(model, { ...origin, parts, isGeometry: !source.isObject3D, posed: null });
	return model;
}

function whatIsMissing(source) {
	const { attributes } = source.geometry ?? source;
	const what = source.isObject3D ? `${textOf(source)} "${source.name}"` : "the geometry";
	if (attributes && !attributes.position) return `${source.isObject3D ? `${what}: its geometry` : what} has no positions`;
	return `${what} has no ${source.isObject3D ? "meshes with triangles yet" : "triangles"}`;
}

/**
 * Gives a model the pose of an object: the vertices that its bones, morph targets and children's transforms give it now.
 *
 * @param {object} model a model of modelFromObject or levelFromObject
 * @param {object} object its source, or a clone of it
 */
export function poseModel(model, object) {
	const origin = origins.get(model);
	if (!origin) throw new ArgumentError(`model "${model.name}" was not made of an object: modelFromObject makes models that objects can pose`);
	const { parts, isGeometry, isPlaced, up } = origin;
	const posed = origin.posed ??= new Float64Array(model.vertices.length);
	let part = 0;
	let at = 0;
	const place = (mesh, matrix) => {
		if (mesh.isBatchedMesh) throw new ArgumentError(`model "${model.name}" was made of a BatchedMesh, which has no pose`);
		const { count, vertices } = parts[part++] ?? refuse();
		if (count !== countOf(mesh)) refuse();
		for (const vertex of vertices) {
			mesh.getVertexPosition(vertex, point).applyMatrix4(matrix);
			posed[at] = point.x;
			posed[at + 1] = up === "y" ? -point.z : point.y;
			posed[at + 2] = up === "y" ? point.y : point.z;
			at += 3;
		}
	};
	const refuse = () => {
		throw new ArgumentError(`model "${model.name}" was made of other meshes than ${textOf(object)} "${object.name}" has`);
	};
	updateMatrices(object);
	if (!isGeometry) eachMesh(object, isPlaced ? object.matrix : identity, place);
	else if (object.isMesh) place(object, identity);
	if (part !== parts.length) refuse();
	model.pose(posed);
}

/** Computes the matrices of an object and of everything below it, and of the bones of its meshes, which may be elsewhere. */
function updateMatrices(object) {
	object.updateWorldMatrix(true, false);
	object.updateMatrixWorld();
	object.traverse(({ isSkinnedMesh, skeleton }) => {
		if (isSkinnedMesh) for (const bone of skeleton.bones) bone.updateWorldMatrix(true, false);
	});
}

/**
 * Calls a function for each mesh of an object, and for each instance of its InstancedMeshes, always in the same order.
 *
 * @param {object} object the object
 * @param {object} place its matrix; the identity for the source itself
 * @param {function} visit takes a mesh with positions, and its matrix
 */
function eachMesh(object, place, visit) {
	if (object.isInstancedMesh) {
		for (let i = 0; i < object.count; i++) {
			const instance = new Matrix4();
			object.getMatrixAt(i, instance);
			visit(object, instance.premultiply(place));
		}
	} else if (object.isMesh) visit(object, place);
	for (const child of object.children) {
		// the first of an object's levels of detail is the finest
		if (object.isLOD && object.levels.findIndex((level) => level.object === child) > 0) continue;
		eachMesh(child, place.clone().multiply(child.matrix), visit);
	}
}

/** The vertices and triangles of an object or a geometry, z up. With `isPlaced` the object's own transform counts. */
export function surfaceOf(name, source, up, isPlaced = false) {
	if (typeof name !== "string") throw new ArgumentError(`a model's name must be a string, not ${textOf(name)}`);
	const surface = new Surface(name, isYUp(up));
	if (source?.isBufferGeometry) surface.addMesh(new Mesh(source), identity);
	else if (source?.isObject3D) {
		updateMatrices(source);
		eachMesh(source, isPlaced ? source.matrix : identity, (mesh, place) => surface.addMesh(mesh, place));
	} else throw new ModelError(name, "", `expected an Object3D or a BufferGeometry, not ${textOf(source)}${source?.scene?.isObject3D ? ". Its scene is an Object3D" : ""}`);
	return surface;
}

/** Which mesh, or which material, each triangle belongs to: a number for each triangle, and a name for each number. */
class Labels {
	numbers = [];
	names = [];
	#known = new Map();

	/** Labels the next triangles. */
	add(thing, name, count) {
		if (count === 0) return;
		if (!this.#known.has(thing)) {
			this.#known.set(thing, this.names.length);
			this.names.push(String(name ?? ""));
		}
		const number = this.#known.get(thing);
		const before = this.numbers.length;
		this.numbers.length += count;
		this.numbers.fill(number, before);
	}
}

/** Triangles and their corners, z up. Each position appears once. */
class Surface {
	vertices = [];
	triangles = [];
	/** For each mesh or instance, in the order of eachMesh: how many vertices the mesh has, and those that have become the surface's next ones. */
	parts = [];
	/** The mesh and the material of each triangle. */
	meshes = new Labels();
	materials = new Labels();
	#name;
	#isYUp;
	#known = new PointTable(this.vertices);
	// of the last mesh: instances have the same
	#mesh = null;
	#points;
	#corners;
	#runs;

	constructor(name, isYUp) {
		this.#name = name;
		this.#isYUp = isYUp;
	}

	/** Adds a mesh, or an instance of it. The matrix is its place in the source. */
	addMesh(mesh, place) {
		if (mesh.isBatchedMesh) {
			this.#addBatch(mesh, place);
			return;
		}
		if (mesh !== this.#mesh) this.#read(mesh);
		this.#add(mesh, this.#points, this.#corners, this.#runs, place);
	}

	/** Adds all instances of a BatchedMesh, visible or not. Each draws a part of the mesh's geometry. */
	#addBatch(mesh, place) {
		const { index, attributes } = mesh.geometry;
		const shapes = new Map();
		const shapeOf = (id) => {
			const { start, count, vertexStart, vertexCount } = mesh.getGeometryRangeAt(id);
			const points = pointsOf(mesh, attributes.position, vertexStart, vertexCount);
			// a triangle that is cut off is not drawn
			const corners = Array.from({ length: count - (count % 3) }, (_, i) => (index ? index.getX(start + i) : start + i) - vertexStart);
			return { points, corners, runs: [{ material: mesh.material, count: corners.length / 3 }] };
		};
		let left = mesh.instanceCount;
		for (let i = 0; left > 0 && i < mesh.maxInstanceCount; i++) {
			const id = geometryOf(mesh, i);
			if (id < 0) continue;
			left--;
			if (!shapes.has(id)) shapes.set(id, shapeOf(id));
			const { points, corners, runs } = shapes.get(id);
			this.#add(mesh, points, corners, runs, mesh.getMatrixAt(i, new Matrix4()).premultiply(place));
		}
	}

	/** Adds triangles of a mesh: its points, three corners for each triangle, and runs of triangles with one material. */
	#add(mesh, points, corners, runs, place) {
		const part = [];
		this.parts.push({ count: points.length / 3, vertices: part });
		// scaled to 0, as hidden instances often are
		if (place.getMaxScaleOnAxis() === 0) return;
		this.#addTriangles(mesh, points, corners, place, part);
		this.meshes.add(mesh, titleOf(mesh), corners.length / 3);
		for (const { material, count } of runs) this.materials.add(material, material?.name, count);
	}

	/** Adds triangles by their corners, and the points whose positions are new to `part`. */
	#addTriangles(mesh, points, corners, place, part) {
		const { triangles } = this;
		const before = triangles.length;
		// the surface's vertex at each point, -1 before it is known
		const numbers = new Int32Array(points.length / 3).fill(-1);
		for (let i = 0; i < corners.length; i++) {
			const corner = corners[i];
			let number = numbers[corner];
			if (number === undefined) throw this.#error(mesh, `a triangle names vertex ${corner}, the last one is ${numbers.length - 1}`);
			if (number < 0) number = numbers[corner] = this.#vertexOf(points, corner, place, part);
			triangles.push(number);
		}
		if (place.determinant() < 0) turnOver(triangles, before);
	}

	/** The surface's vertex at a point of a mesh. */
	#vertexOf(points, corner, place, part) {
		const { vertices } = this;
		const { length } = vertices;
		point.set(points[3 * corner], points[3 * corner + 1], points[3 * corner + 2]).applyMatrix4(place);
		const number = this.#isYUp ? this.#known.indexOf(point.x, -point.z, point.y) : this.#known.indexOf(point.x, point.y, point.z);
		if (vertices.length > length) part.push(corner);
		return number;
	}

	#read(mesh) {
		const { geometry } = mesh;
		const position = geometry.getAttribute("position");
		const count = countOf(mesh);
		this.#mesh = mesh;
		({ corners: this.#corners, runs: this.#runs } = count === 0 ? { corners: [], runs: [] } : drawnTriangles(geometry, mesh.material));
		this.#points = count === 0 ? [] : pointsOf(mesh, position);
	}

	#error(mesh, problem) {
		const title = titleOf(mesh);
		return new ModelError(this.#name, title && `mesh "${title}"`, problem);
	}
}

/** How many vertices a mesh has. */
const countOf = (mesh) => mesh.geometry.getAttribute("position")?.count ?? 0;

/** A mesh's name, or its geometry's if it has none. */
const titleOf = (mesh) => mesh.name || mesh.geometry.name;

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
 * The triangles that are drawn, with three corners each, in runs with one material: those in the draw range and, with several materials, in the
 * groups that have one.
 */
function drawnTriangles({ index, attributes, drawRange, groups }, material) {
	const total = index ? index.count : attributes.position.count;
	const hasGroups = Array.isArray(material);
	const drawn = hasGroups ? groups.filter(({ materialIndex }) => material[materialIndex]) : [{ start: 0, count: total, materialIndex: 0 }];
	const all = index ? index.array : new Uint32Array(total).map((_, i) => i);
	const ranges = drawn.map(({ start, count, materialIndex }) => {
		const first = Math.max(start, drawRange.start);
		const length = Math.max(0, Math.min(total, start + count, drawRange.start + drawRange.count) - first);
		return { first, end: first + length - (length % 3), own: hasGroups ? material[materialIndex] : material };
	});
	// one range needs no copy
	if (ranges.length === 1) {
		const [{ first, end, own }] = ranges;
		const corners = rangeOf(all, first, end);
		return { corners, runs: [{ material: own, count: corners.length / 3 }] };
	}
	const corners = [];
	const taken = new Uint8Array(total);
	const runs = ranges.map(({ first, end, own }) => {
		const before = corners.length;
		takeCorners(all, first, end, taken, corners);
		return { material: own, count: (corners.length - before) / 3 };
	});
	return { corners, runs };
}

/** The corners from one index to another. A typed array's share its memory; an index may have a plain array. */
const rangeOf = (corners, first, end) => (corners.subarray ? corners.subarray(first, end) : corners.slice(first, end));

/** Takes the corners of the triangles of a range that are not taken yet. */
function takeCorners(all, first, end, taken, corners) {
	for (let i = first; i < end; i += 3) if (!taken[i]++) corners.push(all[i], all[i + 1], all[i + 2]);
}

/** Turns triangles over, from an index of their list on. */
function turnOver(triangles, first) {
	for (let i = first; i < triangles.length; i += 3) [triangles[i + 1], triangles[i + 2]] = [triangles[i + 2], triangles[i + 1]];
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
