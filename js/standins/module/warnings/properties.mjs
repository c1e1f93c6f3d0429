/** Properties that a game sets and the engine does not read, and traits that a collision system does not look at. */
import { $inheritedBy } from "../shown.mjs";
import { $levels } from "./drawn.mjs";
import { $lookAtPoses } from "./poses.mjs";
import { $changesBetween } from "./spelling.mjs";
import { $getOrInsert, $isPowerOfTwo, $rounded, $warn } from "./warn.mjs";

/** So many objects are looked at. */
const $MOST_OBJECTS = 1000;

/** So many agents of a list are looked at again. */
const $MOST_AGENTS_AGAIN = 100;

/** Traits are compared with a collision system that stays for more frames than these. */
const $FRAMES_OF_A_SYSTEM = 30;

/** What other libraries call traits of an agent, and the engine's names for them. */
const $OTHER_WORDS = /* @__PURE__ */ new Map([
	["isSweeping", "sweeps"],
	["collidesAs", "collideAs"],
	["rotation", "heading, pitch and roll in degrees, or setQuaternion()"],
	["quaternion", "setQuaternion()"],
	["scale", "size"],
	["position", "moveTo(x, y, z)"],
	["radius", "size"],
	["colour", "color"],
	["yaw", "heading in degrees"],
	["layer", "breed"],
]);

/** Names that a game's own class of agents may have for something else. */
const $OWN_WORDS = /^(?:position|rotation|quaternion|scale|radius|yaw|layer)$/;

/** Which traits of an agent have no effect in a collision system. */
const $IDLE_TRAITS = {
	BinCollider: ["hierarchical", "collideAs", "traversalDepth"],
	TightestFitCollider: ["hierarchical", "traversalDepth"],
	HierarchicalCollider: ["collideAs"],
};

/** The values of these traits that a new agent has, and the systems where others have an effect. */
const $TRAITS = {
	hierarchical: { first: false, systems: "a CombinationCollider" },
	collideAs: { first: "tightest", systems: "a TightestFitCollider or a CombinationCollider" },
	traversalDepth: { first: 0, systems: "a HierarchicalCollider or a CombinationCollider" },
};

/** The settings of trees, which other collision systems do not have. */
const $TREE_SETTINGS = ["exact", "maxDepth"];

/** A model that was wider than this in its source may be a level. */
const $LARGE = 8;

const $checkedObjects = /* @__PURE__ */ new WeakSet();

/** For the place of an agent, which is an object of the engine: the first agent that had it. */
const $owners = /* @__PURE__ */ new WeakMap();
let $objectsLookedAt = 0;

/** Of a Collision or questions: the updates, and the collision system of the first one, or null once it has been exchanged. */
const $lookedAgain = /* @__PURE__ */ new WeakMap();

function $newLooks(updated) {
	return { updates: 0, collisionSystem: $systemOf(updated) };
}

/**
 * Warns of properties that do nothing of an agent, a collision system, a filter, options or a GreatLand: `agent.sweep = true` sets a
 * property of the game's own, because the engine's is called `sweeps`. Only the first thousand objects are looked at, once each, or
 * whenever they are changing.
 */
export function $warnOfUnknownProperties(object, isChanging) {
	if ($objectsLookedAt >= $MOST_OBJECTS) return;
	if (!isChanging && $checkedObjects.has(object)) return;
	$checkedObjects.add(object);
	$objectsLookedAt++;
	$lookAtProperties(object);
	if (object instanceof Agent) $lookAtOwner(object);
}

/** Warns of two agents with one place. */
function $lookAtOwner(agent) {
	const owner = $getOrInsert($owners, agent.$placement, () => agent);
	if (owner === agent) return;
	$warn(`${agent} is at the place of another agent, always: whoever moves one moves both, because Object.assign has copied the engine's fields. `
		+ "See docs/questions.md in the package, \"How is an agent copied?\"", "owner");
}

/**
 * Warns of a property that a game sets of a Footing, and whose name is near one of the engine's. A Footing has fields in place of setters, and what walks
 * write into it is read.
 */
export function $lookAtFooting(footing) {
	const names = Object.keys(new Footing());
	for (const name of Object.keys(footing).filter((each) => !names.includes(each))) {
		const meant = names.find((each) => each.length > 3 && ($isSimilar(name, each) || $withoutIs(name).startsWith(each.replace(/s$/, ""))));
		if (meant) $warn(`${name} is no property of a Footing that the engine reads; is ${meant} meant?`);
	}
}

/**
 * Looks at a Collision or at questions, at the collision system, and at agents again, because a game may set a property later than the
 * first frame: at the first hundred of a list, in the second, fourth, eighth frame and so on.
 */
export function $warnOfLaterProperties(updated, agents) {
	const collisionSystem = $systemOf(updated);
	const looks = $getOrInsert($lookedAgain, updated, $newLooks);
	looks.updates++;
	if (!$isPowerOfTwo(looks.updates)) return;
	for (const each of [updated, collisionSystem, $greatLandOf(collisionSystem), updated.terrain]) if (each) $lookAtProperties(each);
	const few = agents.slice(0, $MOST_AGENTS_AGAIN);
	for (const agent of few) if ($checkedObjects.has(agent)) $lookAtProperties(agent);
	$lookForTriangles(collisionSystem, few);
	// a game that exchanges its system may have set the traits for another one
	if (looks.collisionSystem !== collisionSystem) looks.collisionSystem = null;
	else if (looks.updates > $FRAMES_OF_A_SYSTEM) {
		$lookAtTraits(collisionSystem, few);
		$lookAtLevels(collisionSystem, few);
		$lookAtScaledLevels(collisionSystem, few);
	}
	$lookAtPoses(collisionSystem, few);
}

/** Warns of an agent whose triangles decide, and whose model has none: rays and motions pass between its vertices. */
function $lookForTriangles(collisionSystem, agents) {
	if (!collisionSystem.exact) return;
	const isOfTrees = $typeOf(collisionSystem) === "HierarchicalCollider";
	const greatLand = $greatLandOf(collisionSystem);
	const hasNone = ({ shape }) => greatLand?.hasModel(shape) && !(greatLand.modelOf(shape).triangles?.length > 0);
	const agent = agents.find((each) => (isOfTrees || each.hierarchical) && hasNone(each));
	if (!agent) return;
	$warn(`${agent} has gaps: with exact triangles decide, and its model has only vertices. If each three of these are a triangle, `
		+ "say so: new Model(name, vertices, vertices.map((_, i) => i).slice(0, vertices.length / 3)). Of an object of three.js levelFromObject "
		+ "and modelFromObject make models with triangles", "no triangles");
}

/** Warns of a level that is one patch wide: it stays where a new agent is, and its model was much larger before it was normalised. */
function $lookAtLevels(collisionSystem, agents) {
	const greatLand = $greatLandOf(collisionSystem);
	const level = agents.find((agent) => agent.hierarchical && agent.size === 1 && agent.x === 0 && agent.y === 0 && agent.z === 0
		&& $unitsOf(greatLand?.modelOf(agent.shape)) > $LARGE);
	if (!level) return;
	$warn(`${level} is one patch wide, and its model was ${$rounded($unitsOf(greatLand.modelOf(level.shape)))} units wide before it was normalised. If it is a `
		+ "level, keep its size: a model with Model.AS_GIVEN, and of a three.js scene levelFromObject in place of modelFromObject", "level");
}

/** Warns of a level that is scaled: its model has the units that it is drawn in. */
function $lookAtScaledLevels(collisionSystem, agents) {
	const choice = collisionSystem.$search?.narrowPhase.shapeChoice;
	const level = agents.find(({ shape, size }) => size !== 1 && $levels.has(choice?.$modelOf(shape)));
	if (!level) return;
	$warn(`${level} has the size ${$rounded(level.size)}, and its model is of levelFromObject, which keeps the units that the level is drawn in: `
		+ "its agent stays at the origin, with size 1", "scaled level");
}

/** The collision system of a Collision or of questions, which may be about a Collision. */
function $systemOf(updated) {
	const source = updated.$_seen?.$_source ?? updated;
	return source.collisionSystem ?? source;
}

/** The name of a collision system's class. */
export function $typeOf(collisionSystem) {
	return Object.getPrototypeOf(collisionSystem).constructor?.name;
}

/** The GreatLand with the models of a collision system of the engine's own. */
export function $greatLandOf(collisionSystem) {
	return collisionSystem.$search?.narrowPhase.shapeChoice.greatLand;
}

/** How many units of its source a model's patch is long. */
function $unitsOf(model) {
	const [x, y, z] = model?.source.matrix.rawData ?? [1, 0, 0];
	return 1 / Math.hypot(x, y, z);
}

/** Warns of traits that agents have and their collision system does not look at. */
function $lookAtTraits(collisionSystem, agents) {
	const type = $typeOf(collisionSystem);
	for (const trait of $IDLE_TRAITS[type] ?? []) {
		const { first, systems } = $TRAITS[trait];
		const agent = agents.find((each) => each[trait] !== undefined && each[trait] !== first);
		if (agent) $warn(`${trait} of ${agent} does nothing in a ${type}: it is for ${systems}`, type + trait);
	}
}

/** Warns of an object's own properties that do nothing. */
function $lookAtProperties(object) {
	const type = object.constructor.name;
	if (object instanceof Agent && Object.isFrozen(object)) $warn(`${object} is frozen, so it can't move: keep agents out of a store that freezes its state`, "frozen");
	for (const name of Object.keys(object).filter((each) => !/^[_$]/.test(each))) {
		if ($TREE_SETTINGS.includes(name)) $warn(`${name} does nothing on a ${type}: ${$remedyForSetting(type, name)}`);
		const meant = $meantBy(object, name);
		if (meant === name) $warn(`${name} is a field of ${type} that hides the engine's: set it in the constructor`);
		else if (meant !== undefined) $warn(`${name} is no property of ${type} that the engine reads; is ${meant} meant?`);
	}
}

/** What to do about a setting of trees that a collision system does not have. */
function $remedyForSetting(type, name) {
	return type === "LevelCollider" ? `set ${name} of its LevelShapes` : "it is for a HierarchicalCollider or a CombinationCollider";
}

/**
 * Which property of the engine is meant by the name of an object's own property: the same name, a similar one, or another library's word
 * for it.
 */
function $meantBy(object, name) {
	const setters = $namesOfSetters(object);
	if (setters.includes(name)) return name;
	const isLong = (setter) => Math.min(setter.length, name.length) > 3;
	const isNumbered = (setter) => setter === name.replace(/\d+$/, "");
	const near = setters.find((setter) => isLong(setter) && !isNumbered(setter) && $isSimilar(name, setter));
	const other = object.constructor.name === "Collision" && name === "collider" ? "collisionSystem" : undefined;
	const meant = near ?? ("sweeps" in object ? $OTHER_WORDS.get(name) : other);
	return $isOfOwnClass(object, name, meant) ? undefined : meant;
}

/** Whether a name may be another one, misspelt. */
function $isSimilar(name, other) {
	return $withoutIs(other) === $withoutIs(name) || $changesBetween(name, other) <= 1;
}

/** A name in small letters, without the verb of a yes or no: "exact" for isExact. */
function $withoutIs(name) {
	return name.replace(/^is(?=[A-Z])/, "").toLowerCase();
}

/**
 * Whether a property belongs to a game's own class of agents, which declares it, though its name is near a trait's: other libraries have
 * such a word, or it is a plural, or its value is of another kind than the trait's, as a list.
 */
function $isOfOwnClass(object, name, trait) {
	if (!("sweeps" in object)) return false;
	const isOther = $OWN_WORDS.test(name) || name === `${trait}s` || typeof object[name] !== typeof object[trait];
	return isOther && $isInClass(object, name);
}

/** Whether a game's own class of an agent, or one that it extends, has a name in its text: it declares the property, or sets it. */
function $isInClass(object, name) {
	const type = Object.getPrototypeOf(object);
	if (type.constructor.name === "Agent") return false;
	return String(type.constructor).match(/[\w$]+/g).includes(name) || $isInClass(type, name);
}

/** The names of an object's setters. */
function $namesOfSetters(object) {
	return $inheritedBy(object).filter(([name, { set }]) => set && !/^[_$]/.test(name)).map(([name]) => name);
}
