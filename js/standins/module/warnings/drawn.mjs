/** What the adapter to three.js draws elsewhere than it collides, or cannot read. The adapter calls these functions itself. */
import { $keepPose } from "./poses.mjs";
import { $putAtOrigin } from "./shots.mjs";
import { $restored, $restores } from "./snapshots.mjs";
import { $distance, $placeOf, $rounded, $warn } from "./warn.mjs";

/** So many updates in turn that put an agent back to its object are no accident. */
const $MANY_UNDONE = 10;

/**
 * Of an agent: where it was after the last update of its binding, the longest step from one update to the next, and how many updates in turn have put it
 * back to its object.
 */
const $lastPlaces = /* @__PURE__ */ new WeakMap();

/** Of an object: where the last update has put it, and how many in turn have put it back there. */
const $undoneMoves = /* @__PURE__ */ new WeakMap();

/** For each source of a model: the name of the last one, and its place in the source. */
const $sources = /* @__PURE__ */ new WeakMap();

/** Of an InstancedMesh that is bound as a whole: to which agent last, and how often Collisions had gone back then. */
const $boundMeshes = /* @__PURE__ */ new WeakMap();

/** The models of levelFromObject. */
export const $levels = /* @__PURE__ */ new WeakSet();

/** The adapter's warnings: see Model.$internals. */
export function $warningsForAdapters() {
	return {
		keepSource: $keepSource, keepLevel: $keepLevel, keepPose: $keepPose, ofNoModel: $warnOfNoModel, ofScale: $warnOfScale, ofParent: $warnOfParent, ofInstances: $warnOfInstances,
		placeIfFirst: $placeIfFirst, ofFirstUpdate: $warnOfFirstUpdate, ofUpdateObject: $warnOfUpdateObject, placeIfMoved: $placeIfMoved, ofUpdateAgent: $warnOfUpdateAgent, errorOfVertex: $errorOfVertex,
		requireSkeletons: $requireSkeletons,
	};
}

/** Keeps of which source a model was made. */
function $keepSource(source, model) {
	$sources.set(source, { name: model.name, matrix: model.source.matrix.rawData });
}

/** Keeps that a model is of levelFromObject. */
function $keepLevel(model) {
	$levels.add(model);
}

/**
 * The error for a vertex that is no place, with its mesh's own number: the engine knows the model's vertices alone. Null if there is none, or if it is of
 * a BatchedMesh, whose vertices are numbered in parts.
 */
function $errorOfVertex(name, vertices, meshes) {
	const vertex = Math.floor(vertices.findIndex((value) => value - value !== 0) / 3);
	const mesh = meshes.findLast(({ firstVertex, meshVertices: own }) => own.length > 0 && firstVertex <= vertex);
	if (vertex < 0 || mesh.object.isBatchedMesh) return null;
	const meshName = mesh.object.name || mesh.object.geometry.name;
	const place = vertices.slice(3 * vertex, 3 * vertex + 3).join(", ");
	return new ModelError(name, meshName && `mesh "${meshName}"`, `vertex ${mesh.meshVertices[vertex - mesh.firstVertex]} of its geometry must be at finite numbers, not at (${place})`);
}

/** Refuses an object with a SkinnedMesh whose skeleton is not there: three.js would stop at it. */
function $requireSkeletons(name, object) {
	object.traverse((mesh) => {
		if (!mesh.isSkinnedMesh || mesh.skeleton) return;
		throw new ModelError(name, "", `the SkinnedMesh ${JSON.stringify(mesh.name)} has no skeleton: call mesh.bind(skeleton) first`);
	});
}

/** Warns of a binding without the model that was made of the object, whose place and size in it are needed. */
function $warnOfNoModel(agent, object) {
	const { name, matrix } = $sources.get(object) ?? $sources.get(object.geometry) ?? {};
	if (name === undefined || name !== agent.shape || $isIdentity(matrix)) return;
	$warn(`new ThreeAgentBinding(agent, object) draws ${agent} elsewhere, or of another size, than it collides: the model ${JSON.stringify(name)} `
		+ "was made of the object. Pass it as the third argument", `source of ${name}`);
}

/** Warns of an object with a non-uniform scale of its own, which no model has: updateObject() would set it to the agent's size. */
function $warnOfScale(agent, object) {
	const sizes = object.scale.toArray();
	if (!object.matrixAutoUpdate || Math.max(...sizes.map(Math.abs)) <= (1 + 1e-6) * Math.min(...sizes.map(Math.abs))) return;
	$warn(`the object of ${agent} has a scale of its own, (${sizes.map($rounded).join(", ")}), which is not in its model and which updateObject() overwrites. `
		+ "Put the mesh into a Group, make the model of the group, and bind the group", `scale of ${agent.shape}`);
}

/**
 * Warns of an InstancedMesh that is bound as a whole to an agent with the model of one of its instances, or to a second agent without a model. After
 * restore() a game may bind it anew.
 */
function $warnOfInstances(agent, mesh, model) {
	const { isInstancedMesh, count, geometry } = mesh;
	if (!isInstancedMesh || count < 2) return;
	const before = $boundMeshes.get(mesh);
	$boundMeshes.set(mesh, { agent, restores: $restores });
	const isShared = model === null && before && before.agent !== agent && before.restores === $restores;
	if (!isShared && $sources.get(geometry)?.name !== agent.shape) return;
	$warn(`new ThreeAgentBinding(agent, mesh) moves all ${count} instances of the mesh of ${agent}. To move one of them, take `
		+ "bindInstance(agent, mesh, index, model)", `instances of ${agent.shape}`);
}

/**
 * Where an object is before updateObject() takes it to its agent; null unless it is drawn, this is the first update, and nobody has put the agent anywhere.
 * Keeps the agent's place, which the update does not change.
 */
function $placeIfFirst(agent, { isInstancedMesh, position, matrixAutoUpdate, visible }) {
	const isFirst = !$lastPlaces.has(agent) && !$restored.has(agent);
	$keepPlace(agent, 0);
	const isMade = agent.x === 0 && agent.y === 0 && agent.z === 0 && agent.size === 1 && !$putAtOrigin.has(agent);
	return isFirst && isMade && !isInstancedMesh && matrixAutoUpdate && visible ? position.clone() : null;
}

/** Warns of a first update that has taken an object away from its place, to where its agent was made. */
function $warnOfFirstUpdate(agent, { position }, placeBefore) {
	if (!$isElsewhere(position, placeBefore)) return;
	$warn(`updateObject() takes the object of ${agent} from (${placeBefore.toArray().map($rounded).join(", ")}) to the origin, where the agent is. If the object `
		+ "stands where it should, call updateAgent() once before", `first update of ${agent.shape}`);
}

/**
 * Warns of an object that is moved before each of many updates, which undo it. It was drawn where the last update put it: what is moved to be
 * drawn elsewhere is drawn there.
 *
 * @param placeBefore where the object was before the update, if it had moved since the last one; else null
 */
function $warnOfUpdateObject(agent, object, placeBefore) {
	const last = $undoneMoves.get(object);
	const isUndone = last && placeBefore && object.matrixAutoUpdate && $isElsewhere(placeBefore, last.place) && $isElsewhere(object.position, placeBefore)
		&& !$isElsewhere(last.place, $drawnPlaceOf(object));
	const undone = isUndone ? last.undone + 1 : 0;
	$undoneMoves.set(object, { place: object.position.clone(), undone });
	if (undone !== $MANY_UNDONE) return;
	$warn(`the object of ${agent} was moved before each of ${undone} updateObject() in turn, which undo it, because the agent leads: move the agent, or call `
		+ "updateAgent() if the object leads", "undone object");
}

/** Where an agent is, if it has moved since the last update of its binding. */
function $placeIfMoved(agent) {
	const last = $lastPlaces.get(agent);
	return last && $isElsewhere(agent, last) ? $placeOf(agent) : null;
}

/**
 * Warns of an agent that has moved, and is put back to its object: by each of many updates in turn, while the object stays; or after a snapshot has moved
 * it. An object that goes back, too, and then on by a step, is near where the snapshot has put the agent.
 *
 * @param placeBefore where the agent was before the update, if it had moved since the last one; else null
 * @param isLed whether the object has moved since the last update
 */
function $warnOfUpdateAgent(agent, object, placeBefore, isLed) {
	const isUndone = placeBefore !== null && $isElsewhere(agent, placeBefore);
	const last = $lastPlaces.get(agent);
	if (isUndone && $restored.has(agent) && $distance(agent, placeBefore) > Math.max($distance(agent, last), 1.5 * last.longestStep)) {
		$warn(`restore() has put ${agent} back, and updateAgent() undoes it, because its object is not back: call binding.updateObject() after restore(), `
			+ "for all bindings. See docs/snapshots.md in the package", "restored object");
	}
	const undone = isUndone && !isLed && !$isDrawnElsewhere(object) ? last.undone + 1 : 0;
	$keepPlace(agent, undone);
	if (undone !== $MANY_UNDONE) return;
	$warn(`${agent} was moved before each of ${undone} updateAgent() in turn, which undo it, because they take its object's place. If the agent leads, `
		+ "call updateObject() instead", "undone");
}

/** Whether an object was drawn elsewhere since the last update: it was moved with its agent, and then back. */
function $isDrawnElsewhere(object) {
	return object.matrixAutoUpdate && $isElsewhere(object.position, $drawnPlaceOf(object));
}

/** Where an object was drawn last. */
function $drawnPlaceOf({ matrix }) {
	return new Vector3D(...matrix.elements.slice(12, 15));
}

function $keepPlace(agent, undone) {
	$restored.delete(agent);
	const last = $lastPlaces.get(agent);
	$lastPlaces.set(agent, { x: agent.x, y: agent.y, z: agent.z, longestStep: last ? Math.max($distance(agent, last), last.longestStep) : 0, undone });
}

/** Whether what has a place is elsewhere, by more than rounding. */
function $isElsewhere(placed, place) {
	return $distance(placed, place) > 1e-6 * (1 + Math.hypot(place.x, place.y, place.z));
}

/** Warns of a level below a parent that is moved, turned or scaled in the scene. It may be the land, so it is no error. A land with z up is turned. */
function $warnOfParent(name, object, isYUp) {
	if (!object.parent || !isYUp) return;
	const { elements } = object.parent.matrixWorld;
	if ($isIdentity(elements)) return;
	const place = elements.slice(12, 15).map($rounded).join(", ");
	const scale = $rounded(object.parent.matrixWorld.getMaxScaleOnAxis());
	$warn(`levelFromObject(${JSON.stringify(name)}): the object's parent is moved, turned or scaled in the scene, to (${place}) and ${scale} times its size, `
		+ "and the model does not have that: one unit of the parent is a patch. If one unit of the scene should be, put the object into the scene itself, "
		+ "or pass an object that stands in it");
}

/** Whether the 16 numbers of a matrix move, turn and scale nothing, up to rounding. */
function $isIdentity(elements) {
	return elements.every((element, i) => Math.abs(element - (i % 5 === 0 ? 1 : 0)) < 1e-6);
}
