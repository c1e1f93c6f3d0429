import { BufferAttribute, Matrix4, Mesh, Vector3 } from "three";
import { ArgumentError, Model, ModelError } from "starlogo-collision";
import { optionsOf, textOf } from "./arguments.js";
import { isYUp } from "./axes.js";

/** For each model: the up axis of its source, whether that is placed, and of which vertices of which meshes it was made. */
const origins = new WeakMap();

/** The up axis of a model's source, or undefined. */
export const upOf = (model) => origins.get(model)?.up;

/** The engine's own: the record of what a model is made of, and the work that makes a model of it. */
const [ModelData, ModelBuilder] = Model.$parts;

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

function modelOf(name, source, { data, parts }, origin, scaling) {
	if (data.vertices.length === 0) throw new ModelError(name, "", `no vertices: ${whatIsMissing(source)}`);
	Object.assign(data, { scaling, isNormalised: scaling === Model.AS_GIVEN });
	const { model } = new ModelBuilder(data);
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
	const surface = new Surface(name, isYUp(up), source?.isObject3D);
	if (source?.isBufferGeometry) surface.addMesh(new Mesh(source), identity);
	else if (source?.isObject3D) {
		updateMatrices(source);
		eachMesh(source, isPlaced ? source.matrix : identity, (mesh, place) => surface.addMesh(mesh, place));
	} else throw new ModelError(name, "", `expected an Object3D or a BufferGeometry, not ${textOf(source)}${source?.scene?.isObject3D ? ". Its scene is an Object3D" : ""}`);
	return surface.weld();
}

/** Reads meshes, as a reader of the engine reads a file. Each position becomes one vertex, z up. */
class Surface {
	/** What the model is made of: the engine's own record. */
	data;
	/** For each mesh or instance, in the order of eachMesh: how many vertices the mesh has, and those that have become the model's next ones. */
	parts = [];
	#isYUp;
	#isLabelled;
	#pieces = [];
	#cornerCount = 0;
	// the number of each mesh, and of each material
	#meshes = new Map();
	#materials = new Map();
	// of the last mesh: instances have the same
	#mesh = null;
	#points;
	#corners;
	#runs;

	/** @param {boolean} isLabelled whether hits tell the mesh and the material of a triangle */
	constructor(name, isYUp, isLabelled) {
		this.data = new ModelData(name);
		this.#isYUp = isYUp;
		this.#isLabelled = isLabelled;
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
		if (place.getMaxScaleOnAxis() === 0 || corners.length === 0) return;
		if (this.#isLabelled) this.#label(mesh, runs);
		this.#pieces.push({ mesh, points, corners, place, part });
		this.#cornerCount += corners.length;
	}

	/** Labels the triangles that come next. */
	#label(mesh, runs) {
		const { meshes, materials } = this.data;
		let first = this.#cornerCount / 3;
		meshes.beginRun(labelOf(mesh, titleOf(mesh), this.#meshes, meshes), first);
		for (const { material, count } of runs) {
			if (count === 0) continue;
			materials.beginRun(labelOf(material, material?.name, this.#materials, materials), first);
			first += count;
		}
	}

	/** Makes vertices and triangles of all that was added. A list that has its length at once is made in a quarter of the time of one that grows. */
	weld() {
		const triangles = (this.data.triangles = zeros(this.#cornerCount));
		const welder = new Welder(this.data.vertices);
		let first = 0;
		for (const { mesh, points, corners, place, part } of this.#pieces) {
			welder.begin(points, place, this.#isYUp, part);
			this.#addTriangles(mesh, points, corners, welder, triangles, first);
			first += corners.length;
			if (place.determinant() < 0) turnOver(triangles, first - corners.length, first);
		}
		return this;
	}

	/** Writes triangles from a first place on. */
	#addTriangles(mesh, points, corners, welder, triangles, first) {
		// the model's vertex at each point, -1 before it is known
		const numbers = new Int32Array(points.length / 3).fill(-1);
		for (let i = 0; i < corners.length; i++) {
			const corner = corners[i];
			let number = numbers[corner];
			if (number === undefined) throw this.#error(mesh, `a triangle names vertex ${corner}, the last one is ${numbers.length - 1}`);
			if (number < 0) number = numbers[corner] = welder.vertexAt(corner);
			triangles[first + i] = number;
		}
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
		return new ModelError(this.data.name, title && `mesh "${title}"`, problem);
	}
}

/** The label of a mesh or a material. A new one gets the next. */
function labelOf(thing, name, known, labels) {
	if (!known.has(thing)) known.set(thing, labels.addLabel(String(name ?? "")));
	return known.get(thing);
}

/** How many vertices a mesh has. */
const countOf = (mesh) => mesh.geometry.getAttribute("position")?.count ?? 0;

/** A mesh's name, or its geometry's if it has none. */
const titleOf = (mesh) => mesh.name || mesh.geometry.name;

/** The places of a mesh's vertices in its own space, x, y, z, ..., in its present pose: of all, or of some from a first one on. */
function pointsOf(mesh, position, first = 0, count = position.count) {
	const isPosed = mesh.isSkinnedMesh || mesh.geometry.morphAttributes.position !== undefined;
	// others decode what they have: halves of floats, fractions, numbers among others
	const isPlain = position.getX === BufferAttribute.prototype.getX && position.itemSize === 3 && !position.normalized;
	if (isPlain && !isPosed) return position.array.subarray(3 * first, 3 * (first + count));
	const points = new Float64Array(3 * count);
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

/** Turns triangles over, from an index of their list to another. */
function turnOver(triangles, first, end) {
	for (let i = first; i < end; i += 3) [triangles[i + 1], triangles[i + 2]] = [triangles[i + 2], triangles[i + 1]];
}

/** A list of zeros without gaps. V8 takes for granted that `new Array(count)` has some, and looks for them at each reading. */
function zeros(count) {
	const some = [];
	while (some.length < 1024) some.push(0);
	return [].concat(...new Array(count >> 10).fill(some), some.slice(0, count & 1023));
}

/** Makes vertices of points. Equal positions become one vertex, because exporters repeat them for normals and textures. */
class Welder {
	#vertices;
	#slots = new Int32Array(1024).fill(-1); // by hash: a vertex. The next free slot is taken if several have one hash
	#bits = new Float64Array(3);
	#words = new Int32Array(this.#bits.buffer);
	// of the mesh at hand
	#points;
	#elements;
	#isYUp;
	#part;

	/** @param {number[]} vertices x, y, z, ...: new positions are appended */
	constructor(vertices) {
		this.#vertices = vertices;
	}

	/** Begins a mesh: its points, its place, and where the points are listed that become vertices. */
	begin(points, place, isYUp, part) {
		this.#points = points;
		this.#elements = place.elements;
		this.#isYUp = isYUp;
		this.#part = part;
		// at most half of the slots are taken in the end
		const needed = 2 * ((this.#vertices.length + points.length) / 3);
		if (needed > this.#slots.length) this.#grow(2 ** Math.ceil(Math.log2(2 * needed)));
	}

	/** The vertex at a point, which is new if its position is. This is Vector3.applyMatrix4, and -0 becomes 0. */
	vertexAt(corner) {
		const points = this.#points;
		const e = this.#elements;
		const px = points[3 * corner];
		const py = points[3 * corner + 1];
		const pz = points[3 * corner + 2];
		const w = 1 / (e[3] * px + e[7] * py + e[11] * pz + e[15]);
		const x = (e[0] * px + e[4] * py + e[8] * pz + e[12]) * w + 0;
		const second = (e[1] * px + e[5] * py + e[9] * pz + e[13]) * w + 0;
		const third = (e[2] * px + e[6] * py + e[10] * pz + e[14]) * w + 0;
		return this.#isYUp ? this.#vertexOf(x, 0 - third, second, corner) : this.#vertexOf(x, second, third, corner);
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
		this.#part.push(corner);
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
