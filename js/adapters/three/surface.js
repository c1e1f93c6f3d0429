/** Reads the meshes of an object or a geometry: their vertices and triangles, z up. */
import { BufferAttribute, Matrix4, Mesh, Vector3 } from "three";
import { ModelError } from "starlogo-collision";
import { ModelData, textOf, vectorOf, warnings } from "./arguments.js";
import { Welder } from "./welder.js";

/** The matrix of a source whose own transform does not count. */
export const identity = new Matrix4();

/** Computes the matrices of a model's object and of everything below it, and of the bones of its meshes, which may be elsewhere. */
export function updateMatrices(name, object) {
	warnings?.requireSkeletons(name, object);
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
 * @param {object} matrix its matrix; the identity for the source itself
 * @param {function} visit takes a mesh with positions, its matrix, and the index of the instance
 */
export function eachMesh(object, matrix, visit) {
	if (object.isInstancedMesh) {
		for (let i = 0; i < object.count; i++) {
			const instance = new Matrix4();
			object.getMatrixAt(i, instance);
			visit(object, instance.premultiply(matrix), i);
		}
	} else if (object.isMesh) visit(object, matrix);
	for (const child of object.children) {
		// the first of an object's levels of detail is the finest
		if (object.isLOD && object.levels.findIndex((level) => level.object === child) > 0) continue;
		eachMesh(child, matrix.clone().multiply(child.matrix), visit);
	}
}

/**
 * What a model of an object or a geometry is made of, z up. With `isPlaced` the object's own transform counts.
 *
 * @returns {{data: object, meshes: object[]}} the engine's own record; and for each mesh or instance, in the order of eachMesh: the mesh, the index of
 * the instance, how many vertices the mesh has, those that have become the model's, the number of the first of these and of its first triangle, and the
 * faces of its triangles
 */
export function surfaceOf(name, source, isYUp, isPlaced = false) {
	const instances = collectInstances(name, source, isPlaced);
	const data = new ModelData(name);
	const drawn = instances.filter(({ corners }) => corners.length > 0);
	weld(data, drawn, isYUp);
	if (source.isObject3D) label(data, drawn);
	return { data, meshes: instances.map(({ mesh }) => mesh) };
}

/**
 * What a source draws: for each mesh or instance its shape as shapeOf has it, its matrix, and the record that surfaceOf returns. A mesh without instances
 * counts as one.
 */
function collectInstances(name, source, isPlaced) {
	const instances = [];
	let firstTriangle = 0;
	const add = (object, instanceId, shape, matrix) => {
		// scaled to 0, as hidden instances often are
		const corners = matrix.getMaxScaleOnAxis() === 0 ? [] : shape.corners;
		const mesh = { object, instanceId, count: shape.points.length / 3, meshVertices: [], firstVertex: 0, firstTriangle, faceAt: shape.faceAt };
		instances.push({ ...shape, corners, matrix, mesh });
		firstTriangle += corners.length / 3;
	};
	// the last object, and what it draws: its instances draw the same
	let last = null;
	let shape;
	const addMesh = (object, matrix, instanceId = null) => {
		if (object.isBatchedMesh) {
			eachInBatch(object, (i, ofInstance) => add(object, i, ofInstance, object.getMatrixAt(i, new Matrix4()).premultiply(matrix)));
			return;
		}
		if (object !== last) shape = shapeOf(object);
		last = object;
		add(object, instanceId, shape, matrix);
	};
	if (source?.isBufferGeometry) {
		addMesh(new Mesh(source), identity);
	} else if (source?.isObject3D) {
		updateMatrices(name, source);
		eachMesh(source, isPlaced ? source.matrix : identity, addMesh);
	} else {
		const hint = source?.scene?.isObject3D ? ". Its scene is an Object3D" : "";
		throw new ModelError(name, "", `expected an Object3D or a BufferGeometry, not ${textOf(source)}${hint}`);
	}
	return instances;
}

/** Calls a function for each instance of a BatchedMesh, visible or not, with its index and its shape: a part of the mesh's geometry. */
function eachInBatch(mesh, visit) {
	const shapes = new Map();
	let left = mesh.instanceCount;
	for (let i = 0; left > 0 && i < mesh.maxInstanceCount; i++) {
		const id = geometryOf(mesh, i);
		if (id < 0) continue;
		left--;
		if (!shapes.has(id)) shapes.set(id, shapeInBatch(mesh, id));
		visit(i, shapes.get(id));
	}
}

/** Makes vertices and triangles of instances. A list that has its length at once is made in a quarter of the time of one that grows. */
function weld(data, instances, isYUp) {
	const triangles = (data.triangles = vectorOf(instances.reduce((count, { corners }) => count + corners.length, 0), 0));
	const welder = new Welder(data.vertices, isYUp);
	for (const { mesh, points, corners, matrix } of instances) {
		mesh.firstVertex = data.vertices.length / 3;
		welder.begin(points, matrix, mesh.meshVertices);
		addTriangles(data.name, mesh, points, corners, welder, triangles);
		if (matrix.determinant() < 0) turnOver(triangles, 3 * mesh.firstTriangle, 3 * mesh.firstTriangle + corners.length);
	}
}

/** Writes the triangles of an instance. */
function addTriangles(name, { object, firstTriangle }, points, corners, welder, triangles) {
	// the model's vertex at each point, -1 before it is known
	const numbers = new Int32Array(points.length / 3).fill(-1);
	for (let i = 0; i < corners.length; i++) {
		const corner = corners[i];
		let number = numbers[corner];
		if (number === undefined) {
			const meshName = nameOf(object);
			throw new ModelError(name, meshName && `mesh "${meshName}"`, `a triangle names vertex ${corner}, the last one is ${numbers.length - 1}`);
		}
		if (number < 0) number = numbers[corner] = welder.vertexAt(corner);
		triangles[3 * firstTriangle + i] = number;
	}
}

/** Labels the triangles of instances by their meshes and materials, which hits tell. */
function label({ meshes, materials }, instances) {
	const meshLabels = new Map();
	const materialLabels = new Map();
	for (const { mesh: { object, firstTriangle }, materialRanges } of instances) {
		meshes.beginRun(labelOf(object, nameOf(object), meshLabels, meshes), firstTriangle);
		let next = firstTriangle;
		for (const { material, count } of materialRanges) {
			if (count === 0) continue;
			materials.beginRun(labelOf(material, material?.name, materialLabels, materials), next);
			next += count;
		}
	}
}

/** The label of a mesh or a material. A new one gets the next. */
function labelOf(thing, name, known, labels) {
	if (!known.has(thing)) known.set(thing, labels.addLabel(String(name ?? "")));
	return known.get(thing);
}

/**
 * What a mesh draws: the places of its vertices, three corners for each triangle, ranges of triangles with one material, and a function for
 * the index of the face that a triangle is.
 */
function shapeOf(mesh) {
	if (countOf(mesh) === 0) return { points: [], corners: [], materialRanges: [], faceAt: null };
	return { points: pointsOf(mesh, mesh.geometry.getAttribute("position")), ...drawnTriangles(mesh.geometry, mesh.material) };
}

/** The same for a geometry of a BatchedMesh, by its number: a part of the mesh's own geometry. */
function shapeInBatch(mesh, id) {
	const { index, attributes } = mesh.geometry;
	const { start, count, vertexStart, vertexCount } = mesh.getGeometryRangeAt(id);
	const points = pointsOf(mesh, attributes.position, vertexStart, vertexCount);
	// a triangle that is cut off is not drawn
	const corners = Array.from({ length: count - (count % 3) }, (_, i) => (index ? index.getX(start + i) : start + i) - vertexStart);
	return { points, corners, materialRanges: [{ material: mesh.material, count: corners.length / 3 }], faceAt: facesFrom(start) };
}

/** The faces of triangles that follow one another from a corner on. */
const facesFrom = (start) => (triangle) => Math.floor(start / 3) + triangle;

/** How many vertices a mesh has. */
export const countOf = (mesh) => mesh.geometry.getAttribute("position")?.count ?? 0;

/** A mesh's name, or its geometry's if it has none. */
const nameOf = (mesh) => mesh.name || mesh.geometry.name;

/** The places of a mesh's vertices in its own space, x, y, z, ..., in its present pose: of all, or of some from a first one on. */
function pointsOf(mesh, position, first = 0, count = position.count) {
	const isPosed = mesh.isSkinnedMesh || mesh.geometry.morphAttributes.position !== undefined;
	// others decode what they have: halves of floats, fractions, numbers among others
	const isPlain = position.getX === BufferAttribute.prototype.getX && position.itemSize === 3 && !position.normalized;
	if (isPlain && !isPosed) return position.array.subarray(3 * first, 3 * (first + count));
	const points = new Float64Array(3 * count);
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
 * The triangles that are drawn, with three corners each, in ranges with one material, and their faces: those in the draw range and, with several
 * materials, in the groups that have one.
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
		return { corners, materialRanges: [{ material: own, count: corners.length / 3 }], faceAt: facesFrom(first) };
	}
	const corners = [];
	const faces = [];
	const taken = new Uint8Array(total);
	const materialRanges = ranges.map(({ first, end, own }) => {
		const before = corners.length;
		takeTriangles(all, first, end, taken, corners, faces);
		return { material: own, count: (corners.length - before) / 3 };
	});
	return { corners, materialRanges, faceAt: (triangle) => faces[triangle] };
}

/** The corners from one index to another. A typed array's share its memory; an index may have a plain array. */
const rangeOf = (corners, first, end) => (corners.subarray ? corners.subarray(first, end) : corners.slice(first, end));

/** Takes the triangles of a range that are not taken yet: their corners and their faces. */
function takeTriangles(all, first, end, taken, corners, faces) {
	for (let i = first; i < end; i += 3) {
		if (taken[i]++) continue;
		corners.push(all[i], all[i + 1], all[i + 2]);
		faces.push(Math.floor(i / 3));
	}
}

/** Turns triangles over, from an index of their list to another. */
function turnOver(triangles, first, end) {
	for (let i = first; i < end; i += 3) [triangles[i + 1], triangles[i + 2]] = [triangles[i + 2], triangles[i + 1]];
}
