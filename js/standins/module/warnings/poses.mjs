/** Poses that agents do not collide as: of a model whose agents are structures, and of one that two bindings pose. */
import { $updates } from "./frames.mjs";
import { $MOST_COLLISIONS } from "./handlers.mjs";
import { $greatLandOf, $typeOf } from "./properties.mjs";
import { $hasWarned, $warn } from "./warn.mjs";

/** A model that was posed so often is animated. */
const $MANY_POSES = 30;

/** If this part of a model's vertices, or more, is outside of the structure around it, the model is drawn elsewhere than it collides. */
const $MUCH = 0.25;

/** The models whose trees some collision system has needed. */
const $trees = /* @__PURE__ */ new WeakSet();

/** The last pose that the binding of an agent gave to a model: in which frame, and a sum that two poses hardly share. */
const $poses = /* @__PURE__ */ new WeakMap();

/** Keeps that an agent's binding has posed a model. */
export function $keepPose(model, agent) {
	const sum = model.vertices.reduce((before, coordinate, i) => before + coordinate * (1 + i % 7), 0);
	$poses.set(agent, { model, sum, frame: $updates });
}

/** Looks at the animated models of agents. A collision system has trees of some, and structures of others. */
export function $lookAtPoses(collisionSystem, agents) {
	const type = $typeOf(collisionSystem);
	const greatLand = $greatLandOf(collisionSystem);
	if (!/^(?:TightestFit|Hierarchical|Combination)Collider$/.test(type) || !greatLand) return;
	const posers = new Map();
	for (const agent of agents) {
		const model = greatLand.hasModel(agent.shape) ? greatLand.modelOf(agent.shape) : null;
		if (!model?.$poseCount) continue;
		const isTree = type === "HierarchicalCollider" || type === "CombinationCollider" && agent.hierarchical;
		if (isTree) $trees.add(model);
		if (model.$poseCount < $MANY_POSES) continue;
		if (isTree) $lookAtPosers(posers, agent, model);
		else if (!$trees.has(model) && agent.collideAs === "tightest") $lookAtStructure(greatLand.boundingStructures, agent, model);
	}
}

/** Warns of a model that another agent's binding has posed in this frame, too, and otherwise. */
function $lookAtPosers(posers, agent, model) {
	const pose = $poses.get(agent);
	if (pose?.model !== model || $updates - pose.frame > $MOST_COLLISIONS) return;
	const other = posers.get(model) ?? pose;
	posers.set(model, pose);
	if (pose.frame !== other.frame || Math.abs(pose.sum - other.sum) <= 1e-6 * (1 + Math.abs(pose.sum))) return;
	$warn(`the model ${JSON.stringify(model.name)} was posed by two bindings between two updates, and has the last pose for both. `
		+ `A figure that moves on its own has a model of its own: modelFromObject(${JSON.stringify(`${model.name}2`)}, object)`, `posers of ${model.name}`);
}

/** Warns of an agent that collides as the structure around a pose that its model has no longer. */
function $lookAtStructure(structures, agent, { name, vertices }) {
	const key = `structure of ${name}`;
	if ($hasWarned(key) || !structures.has(name)) return; // without a structure it is loading
	const structure = structures.tightestFit(name);
	let outside = 0;
	for (let i = 0; i < vertices.length; i += 3) if (!structure.contains(new Vector3D(vertices[i], vertices[i + 1], vertices[i + 2]))) outside += 3;
	if (outside < $MUCH * vertices.length) return;
	$warn(`${agent} collides as the structure around the first pose of its model: a pose moves the tree alone. Set hierarchical, in a CombinationCollider, `
		+ "or fit again: greatLand.boundingStructures.add(model.name, model.vertices)", key);
}
