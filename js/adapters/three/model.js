import { Vector3 } from "three";
import { ArgumentError, Model, ModelError } from "starlogo-collision";
import { ModelBuilder, optionsOf, textOf, warnings } from "./arguments.js";
import { toEngineAxes } from "./axes.js";
import { countOf, eachMesh, identity, surfaceOf, updateMatrices } from "./surface.js";

/**
 * How each model was converted from three.js: whether y is up there, whether the object's own transform counts, from which vertices and faces of which
 * meshes, and by mesh the index of the first of these.
 */
const conversions = new WeakMap();

/** How a model was converted; undefined if it was not made of an object or a geometry. */
export const conversionOf = (model) => conversions.get(model);

const point = new Vector3();

/**
 * A model of an object and everything below it, or of a geometry. Every mesh counts, visible or not, in its present pose.
 *
 * @param {string} name what agents call the shape
 * @param {object} source an Object3D, whose own transform does not count, or a BufferGeometry
 * @param {{up?: "y" | "z", scaling?: string}} options the up axis of the source, and how the model is scaled (Model's scalings)
 */
export function modelFromObject(name, source, options = {}) {
	const { isYUp, scaling } = optionsOf("modelFromObject", options, { scaling: Model.FOOTPRINT });
	requireName("modelFromObject", name);
	return modelOf(name, source, surfaceOf(name, source, isYUp), { isYUp, isPlaced: false }, scaling);
}

/**
 * A model of a level that is drawn in the land: one unit of the land is a patch, and an agent at the origin collides where the level is drawn.
 *
 * @param {string} name what the level's agent calls the shape
 * @param {object} object an Object3D, whose parent is the land, or a BufferGeometry
 * @param {{up?: "y" | "z"}} options the up axis of the land
 */
export function levelFromObject(name, object, options = {}) {
	const { isYUp } = optionsOf("levelFromObject", options);
	requireName("levelFromObject", name);
	const surface = surfaceOf(name, object, isYUp, true);
	warnings?.ofParent(name, object, isYUp);
	const model = modelOf(name, object, surface, { isYUp, isPlaced: object.isObject3D && !object.matrix.equals(identity) }, Model.AS_GIVEN);
	warnings?.keepLevel(model);
	return model;
}

function requireName(call, name) {
	if (typeof name !== "string") throw new ArgumentError(`${call}: the model's name comes first and is a string, not ${textOf(name)}`);
}

function modelOf(name, source, { data, meshes }, made, scaling) {
	if (data.vertices.length === 0) throw new ModelError(name, "", `no vertices: ${whatIsMissing(source)}`);
	Object.assign(data, { scaling, isInModelSpace: scaling === Model.AS_GIVEN });
	const model = new Model(name, null, null, Model.AS_GIVEN, build(name, data, meshes));
	const indices = new Map(meshes.map(({ object }, i) => [object, i]).reverse());
	conversions.set(model, { ...made, meshes, indices, isGeometry: !source.isObject3D, posed: null });
	warnings?.keepSource(source, model);
	return model;
}

/** What a Model takes. Only an error is worth a search for the vertex: the engine names the model's, and the warnings that of its mesh. */
function build(name, data, meshes) {
	try {
		return new ModelBuilder(data).build();
	} catch (error) {
		throw warnings?.errorOfVertex(name, data.vertices, meshes) ?? error;
	}
}

function whatIsMissing(source) {
	const { attributes } = source.geometry ?? source;
	const what = source.isObject3D ? `${source.constructor.name} "${source.name}"` : "the geometry";
	if (attributes && !attributes.position) return `${source.isObject3D ? `${what}: its geometry` : what} has no positions`;
	return `${what} has no ${source.isObject3D ? "meshes with triangles yet" : "triangles"}`;
}

/**
 * What three.js draws at a triangle of a model, as a Raycaster says it: the mesh, the index of the face, and that of the instance. Null for the
 * triangle -1 of a hit without one.
 *
 * @param {object} model a model that was made of an Object3D
 * @param {number} triangle the number of the triangle, as a hit has it
 */
export function faceOf(model, triangle) {
	const { meshes, isGeometry } = conversionOf(model) ?? {};
	if (!meshes || isGeometry) {
		throw new ArgumentError(`faceOf: model must be one that modelFromObject or levelFromObject has made of an Object3D, not ${textOf(model)}`);
	}
	const last = model.triangles.length / 3 - 1;
	if (!(Number.isInteger(triangle) && triangle >= -1 && triangle <= last)) {
		throw new RangeError(`faceOf: triangle must be a whole number from -1 to ${last}, not ${textOf(triangle)}`);
	}
	if (triangle === -1) return null;
	const { object, instanceId, firstTriangle, faceAt } = meshes.findLast((each) => each.firstTriangle <= triangle);
	return { object, faceIndex: faceAt(triangle - firstTriangle), instanceId };
}

/**
 * Gives a model the pose of an object: the vertices that its bones, morph targets and children's transforms give it now.
 *
 * @param {object} model a model that can be bound
 * @param {object} object its source, or a clone of it
 */
export function poseModel(model, object) {
	const conversion = conversionOf(model);
	if (!conversion) throw new ArgumentError(`model "${model.name}" was not made of an object: modelFromObject makes models that objects can pose`);
	const { meshes, indices, isGeometry, isYUp } = conversion;
	const posed = conversion.posed ??= new Float64Array(model.vertices.length);
	let number = 0;
	let areOwn = null;
	const poseMesh = (mesh, matrix, instanceId = null) => {
		if (mesh.isBatchedMesh) throw new ArgumentError(`model "${model.name}" was made of a BatchedMesh, which has no pose`);
		// the source's own meshes may have another order by now; those of a clone have the same
		const isOwn = indices.has(mesh);
		areOwn ??= isOwn;
		const made = meshes[isOwn ? indices.get(mesh) + instanceId : number];
		if (isOwn !== areOwn || made?.instanceId !== instanceId || made.count !== countOf(mesh)) refuse();
		const { meshVertices, firstVertex } = made;
		meshVertices.forEach((vertex, i) => {
			toEngineAxes(mesh.getVertexPosition(vertex, point).applyMatrix4(matrix), isYUp).toArray(posed, 3 * (firstVertex + i));
		});
		number++;
	};
	const refuse = () => {
		throw new ArgumentError(`model "${model.name}" was made of other meshes than ${object.constructor.name} "${object.name}" has`);
	};
	updateMatrices(model.name, object);
	if (!isGeometry) eachMesh(object, identity, poseMesh);
	else if (object.isMesh) poseMesh(object, identity);
	if (number !== meshes.length) refuse();
	model.pose(posed);
}
