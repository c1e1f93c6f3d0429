import { Vector3 } from "three";
import { ArgumentError, Model, ModelError } from "starlogo-collision";
import { optionsOf, textOf } from "./arguments.js";
import { countOf, eachMesh, identity, surfaceOf, updateMatrices } from "./surface.js";

/** For each model: the up axis of its source, whether that is placed, and of which vertices and faces of which meshes it was made. */
const origins = new WeakMap();

/** The up axis of a model's source, or undefined. */
export const upOf = (model) => origins.get(model)?.up;

/** Whether a model has its object's place in it, which is not the origin. */
export const isPlaced = (model) => origins.get(model)?.isPlaced === true;

/** The engine's own: the work that makes a model of the record that a Surface fills, and warnings, which the minified module has not. */
const [, ModelBuilder, warnings] = Model.$parts;

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
	requireName("modelFromObject", name);
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
	requireName("levelFromObject", name);
	const surface = surfaceOf(name, object, up, true);
	warnings?.ofParent(name, object);
	return modelOf(name, object, surface, { up, isPlaced: object.isObject3D && !object.matrix.equals(identity) }, Model.AS_GIVEN);
}

function requireName(call, name) {
	if (typeof name !== "string") throw new ArgumentError(`${call}: the model's name comes first and is a string, not ${textOf(name)}`);
}

function modelOf(name, source, { data, parts, drawn }, origin, scaling) {
	if (data.vertices.length === 0) throw new ModelError(name, "", `no vertices: ${whatIsMissing(source)}`);
	Object.assign(data, { scaling, isNormalised: scaling === Model.AS_GIVEN });
	const model = new Model(name, null, null, null, new ModelBuilder(data).build());
	origins.set(model, { ...origin, parts, drawn, isGeometry: !source.isObject3D, posed: null });
	warnings?.keepSource(source, model);
	return model;
}

function whatIsMissing(source) {
	const { attributes } = source.geometry ?? source;
	const what = source.isObject3D ? `${textOf(source)} "${source.name}"` : "the geometry";
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
	const { drawn, isGeometry } = origins.get(model) ?? {};
	if (!drawn || isGeometry) throw new ArgumentError(`faceOf: model must be one that modelFromObject or levelFromObject has made of an Object3D, not ${textOf(model)}`);
	const last = model.triangles.length / 3 - 1;
	if (!(Number.isInteger(triangle) && triangle >= -1 && triangle <= last)) throw new RangeError(`faceOf: triangle must be a whole number from -1 to ${last}, not ${textOf(triangle)}`);
	if (triangle === -1) return null;
	const { object, instanceId, first, faceAt } = drawn.findLast((each) => each.first <= triangle);
	return { object, faceIndex: faceAt(triangle - first), instanceId };
}

/**
 * Gives a model the pose of an object: the vertices that its bones, morph targets and children's transforms give it now.
 *
 * @param {object} model a model that can be bound
 * @param {object} object its source, or a clone of it
 */
export function poseModel(model, object) {
	const origin = origins.get(model);
	if (!origin) throw new ArgumentError(`model "${model.name}" was not made of an object: modelFromObject makes models that objects can pose`);
	const { parts, isGeometry, up } = origin;
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
	if (!isGeometry) eachMesh(object, identity, place);
	else if (object.isMesh) place(object, identity);
	if (part !== parts.length) refuse();
	model.pose(posed);
}
