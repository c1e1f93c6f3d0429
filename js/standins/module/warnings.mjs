/** Warnings while a game is developed: about what is allowed, and probably a mistake. The minified module has none of them. */
import { parametersOf } from "./contacts.mjs";

const $MOST_LOOKED_AT = 1000;
const $MOST_LOOKED_AT_AGAIN = 100;
const $LONG_SILENCE = 300;
const $LONG_WAIT = 3000;
const $LONG_FALL = 200;
const $LONG_STRIDE = 2;
const $MANY_STOPS = 10;
const $MANY_FRAMES = 30;
const $MOST_COLLISIONS = 8;
const $MANY_ANGLES = 30;
const $END = 4; // CollisionHandler.END
const $WORLD_BREEDS = ["*terrain", "*edge"]; // Collision.TERRAIN and EDGE
const $WORLD_NAMES = { "*terrain": "Collision.TERRAIN", "*edge": "Collision.EDGE" };
const $STRUCTURE = "structure"; // what a cast structure is called: see Body.readStructure
const $warned = /* @__PURE__ */ new Set();
const $checkedBreeds = /* @__PURE__ */ new Map();
const $checkedObjects = /* @__PURE__ */ new WeakSet();
const $looksAt = /* @__PURE__ */ new WeakMap();
const $silentFrames = /* @__PURE__ */ new WeakMap();
const $updates = /* @__PURE__ */ new WeakMap();
const $updatesBefore = /* @__PURE__ */ new WeakMap();
const $falls = /* @__PURE__ */ new WeakMap();
const $walks = /* @__PURE__ */ new Map();
const $stops = /* @__PURE__ */ new Map();
const $breedsOf = /* @__PURE__ */ new WeakMap();
const $additions = /* @__PURE__ */ new WeakMap();
const $lists = /* @__PURE__ */ new WeakMap();
const $angles = { count: 0, least: 0, most: 0 };
let $anglesToSee = 20000;
let $frames = 0;
let $sender = { agent: null, dx: 0, dy: 0, dz: 0, x: 0, y: 0, rays: 0 };
let $asked = null;
let $askedFrame = 0;
let $lookedAt = 0;

/** What other libraries call traits of an agent, and the engine's names for them. */
const $OTHER_WORDS = {
	isHierarchical: "hierarchical", isSweeping: "sweeps", oneWay: "isOneWay", collidesAs: "collideAs", rotation: "heading, pitch and roll in degrees, or setQuaternion()", quaternion: "setQuaternion()",
	scale: "size", position: "moveTo(x, y, z)", radius: "size", colour: "color", yaw: "heading in degrees", layer: "breed",
};

/** Names that a game's own class of agents may have for something else. */
const $OWN_WORDS = /^(?:position|rotation|quaternion|scale|radius|yaw|layer)$/;

/** Which traits of an agent have no effect in a collision system, and where they have one. */
const $IDLE_TRAITS = { BinCollider: ["hierarchical", "collideAs", "traversalDepth"], TightestFitCollider: ["hierarchical", "traversalDepth"], HierarchicalCollider: ["collideAs"] };
const $FIRST_TRAITS = { hierarchical: false, collideAs: "tightest", traversalDepth: 0 };
const $SYSTEMS_OF_TRAITS = { hierarchical: "a CombinationCollider", collideAs: "a TightestFitCollider or a CombinationCollider", traversalDepth: "a HierarchicalCollider or a CombinationCollider" };

/** Writes a warning to the console, once: a warning with numbers that change has a key that does not. */
export function $warn(message, key) {
	if ($warned.has(key ?? message)) return;
	$warned.add(key ?? message);
	globalThis.console?.warn?.(`starlogo-collision: ${message}`);
}

/**
 * Warns of properties that do nothing of an agent, a collision system, a filter, options or a GreatLand: `agent.sweep = true` sets a property of
 * the game's own, because the engine's is called `sweeps`. Only the first thousand objects are looked at, once each, or whenever they are changing.
 */
export function $warnOfUnknownProperties(object, isChanging) {
	if ($lookedAt >= $MOST_LOOKED_AT) return;
	if (!isChanging && $checkedObjects.has(object)) return;
	$checkedObjects.add(object);
	$lookedAt++;
	$warnOfNames(object);
}

/**
 * Looks at a Collision or at questions, at the collision system, and at agents again, because a game may set a property later than the first
 * frame: at the first hundred of a list, in the second, fourth, eighth frame and so on.
 */
export function $warnOfLaterProperties(system, agents) {
	const looks = $looksAt.get(system) ?? { frames: 0, collider: system.collisionSystem };
	looks.frames++;
	$looksAt.set(system, looks);
	if ((looks.frames & (looks.frames - 1)) !== 0 || !Array.isArray(agents)) return;
	$warnOfNames(system);
	if (system.collisionSystem) $warnOfNames(system.collisionSystem);
	const few = agents.slice(0, $MOST_LOOKED_AT_AGAIN);
	for (const agent of few) if ($checkedObjects.has(agent)) $warnOfNames(agent);
	// a game that exchanges its system may have set them for another one
	if (looks.collider !== system.collisionSystem) looks.collider = null;
	else if (looks.frames > $MANY_FRAMES) $warnOfTraits(looks.collider, few);
}

/** Warns of traits that agents have and their collision system does not look at. */
function $warnOfTraits(collider, agents) {
	const type = Object.getPrototypeOf(collider ?? {}).constructor?.name;
	for (const trait of $IDLE_TRAITS[type] ?? []) {
		const agent = agents.find((each) => each?.[trait] !== undefined && each[trait] !== $FIRST_TRAITS[trait]);
		if (agent) $warn(`${trait} of ${agent} does nothing in a ${type}: it is for ${$SYSTEMS_OF_TRAITS[trait]}`, type + trait);
	}
}

/** Warns of the names of an object's own properties that do nothing. */
function $warnOfNames(object) {
	for (const name of Object.keys(object)) {
		if (/^[_$]/.test(name)) continue;
		const type = object.constructor.name;
		if (name === "exact" || name === "maxDepth") $warn(`${name} does nothing on a ${type}: it is for a HierarchicalCollider or a CombinationCollider`);
		const names = $settableNames(object).filter((each) => each === name || Math.min(each.length, name.length) > 3 && each !== name.replace(/\d+$/, ""));
		const other = "sweeps" in object && (type === "Agent" || !$OWN_WORDS.test(name)) ? $OTHER_WORDS[name] : undefined;
		const meant = names.find((each) => each === name) ?? names.find((each) => each.toLowerCase() === name.toLowerCase() || $changesBetween(name, each) <= 1) ?? other;
		if (meant === name) $warn(`${name} is a field of ${type} that hides the engine's: set it in the constructor`);
		else if (meant !== undefined) $warn(`${name} is no property of ${type} that the engine reads; is ${meant} meant?`);
	}
}

/**
 * Warns of breeds that handlers or a filter name, if no agent has the breed, and agents have one that is called nearly the same. Agents
 * of the breed may still come. So nothing is refused, and a breed is looked for again when there are new names.
 */
export function $warnOfBreeds(names, agents) {
	const unchecked = names.filter((name) => !($checkedBreeds.get(name) >= Breeds$NAMES.count));
	if (unchecked.length === 0) return;
	const breeds = new Set(agents.map((agent) => agent?.breed).filter((breed) => typeof breed === "string" && !/^\*/.test(breed)));
	if (breeds.size === 0) return;
	const called = [...breeds, ...$WORLD_BREEDS];
	for (const name of new Set(unchecked)) {
		$checkedBreeds.set(name, breeds.has(name) ? Infinity : Breeds$NAMES.count);
		if (breeds.has(name)) continue;
		const meant = called.find((breed) => $areSimilar(name, breed));
		const shaped = agents.find((agent) => agent?.shape === name);
		if (meant === undefined && shaped) $warn(`no agent is of the breed ${JSON.stringify(name)}, which is the shape of ${shaped}: new Agent(${JSON.stringify(name)}, "BREED") gives it a breed`);
		if (meant !== undefined) $warn(`no agent is of the breed ${JSON.stringify(name)}; is ${$WORLD_NAMES[meant] ?? JSON.stringify(meant)} meant?`);
	}
}

/**
 * Warns of a listener for events that an object never sends: `loader.addEventListener("load", ...)`. Only of the engine's own classes, because a
 * game's may send other events.
 */
export function $warnOfEvent(object, type) {
	const types = { ModelLoader: ["modelLoaded", "error", "progress", "complete", "cancel"] }[Object.getPrototypeOf(object)?.constructor.name];
	if (types && !types.includes(type)) $warn(`a ModelLoader sends no event ${JSON.stringify(type)}; it sends ${types.join(", ")}`);
}

/**
 * Warns of an agent that does not stop a motion, because the motion begins deep inside of its tree or its triangles, or whose
 * structure has all that moves inside. See warnOfInside.as. What moves is an agent if one of the shape is at the place.
 */
export function $warnOfInside(agents, index, shape, place, below, depth, isTree) {
	const level = agents[index];
	const mover = agents.find((each) => each?.shape === shape && each.x === place.x && each.y === place.y && each.z === place.z);
	const isCast = !mover && shape === $STRUCTURE;
	const name = mover ?? (isCast ? "a structure that is cast" : `the shape ${JSON.stringify(shape)}`);
	if (!isTree) {
		const end = isCast ? "which it meets at once or not at all" : "and a walk pushes it out";
		$warn(`${name} begins a motion ${$rounded(depth)} deep inside of the structure around ${level}, ${end}. If this is a level, whose triangles should count, set hierarchical of it, and take a CombinationCollider with exact. See docs/questions.md in the package, "thrown out of the level"`, `inside ${level.shape} ${shape}`);
		return;
	}
	const remedy = below > 0.01 * place.size && !isCast
		? `Its lowest point is ${$rounded(below)} below its place: a model that is AS_GIVEN keeps its origin. If its place is on the ground, move it up by ${$rounded(below)}, or give it a model whose origin is its lowest point.`
		: "What is inside of a closed model collides; without exact, what is inside of a box of its tree. A room needs exact, and an opening or thick walls. A level that lies on its side needs another up axis.";
	$warn(`${name} begins a motion at (${[place.x, place.y, place.z].map($rounded).join(", ")}), ${$rounded(depth)} deep inside of ${level}, which does not stop it. ${remedy} See docs/questions.md in the package, "floats in a room"`, `inside ${level.shape} ${shape}`);
}

/**
 * Warns of a handler with more parameters than it gets arguments, with the contact before the agents, or of one that uses the contact
 * at the end of a touch, where it is null. Handlers with fewer parameters are as common as methods without any.
 */
export function $warnOfHandler(breed, otherBreed, handler, kind) {
	const breeds = `${JSON.stringify(breed)} and ${JSON.stringify(otherBreed)}`;
	const name = `the handler ${handler.name || "without a name"} for ${breeds}`;
	$breedsOf.set(handler, ($breedsOf.get(handler) ?? new Set()).add(breeds));
	if (handler.length > 3) $warn(`${name} has ${handler.length} parameters, and gets three arguments: the two agents and the contact`);
	const text = Function.prototype.toString.call(handler);
	const [first, second, third] = parametersOf(text).split(",").map((each) => each.trim());
	if (first === "contact" || second === "contact") $warn(`${name} has its contact too early: it gets the two agents first, (a, b, contact)`);
	if (kind === $END && third && $readsBlindly(text, third)) $warn(`${name} is for the end of a touch, where its third argument is null: there it is without contact. Copy what you need of the contact in onCollisionStart`);
}

/** Warns of a handler that removeHandler cannot find, because it was added for other breeds, or is another function with the same text. */
export function $warnOfRemoval(collision, breed, otherBreed, handler) {
	if (typeof handler !== "function") return;
	const [breeds, added] = [`${JSON.stringify(breed)} and ${JSON.stringify(otherBreed)}`, $breedsOf.get(handler)];
	$additions.get(collision)?.delete(breeds);
	if (added?.has(breeds)) return;
	const why = added ? `is one for ${[...added].join(", ")}` : "was never added: a function that => or bind() makes anew is another one. Keep the one that was added";
	$warn(`removeHandler removes nothing for ${breeds}: the function ${handler.name || "without a name"} ${why}`);
}

/** Whether a function reads properties of a parameter, and asks nowhere whether there is an object. */
function $readsBlindly(text, name) {
	if (!/^\w+$/.test(name)) return /^[{[]/.test(name);
	return new RegExp(`\\b${name}\\s*[.[]`).test(text) && !new RegExp(`\\b${name}\\s*(?:\\?|&&|\\|\\||[!=]=)|!\\s*${name}\\b|\\(\\s*${name}\\s*\\)`).test(text);
}

/**
 * Warns of handlers of two breeds that are added in each frame, at the last of many in turn. A game may have some Collisions, whose frames count one by
 * one.
 */
export function $warnOfAddition(collision, breed, otherBreed) {
	const breeds = `${JSON.stringify(breed)} and ${JSON.stringify(otherBreed)}`;
	let additions = $additions.get(collision);
	if (!additions) $additions.set(collision, additions = new Map());
	const before = additions.get(breeds);
	if (before?.frame === $frames) return;
	const frames = $frames - before?.frame <= $MOST_COLLISIONS ? before.frames + 1 : 1;
	additions.set(breeds, { frame: $frames, frames });
	if (frames === $MANY_FRAMES) $warn(`handlers for ${breeds} were added in ${$MANY_FRAMES} frames in turn, and all of them run: add a handler once, before the first frame`);
}

/**
 * Warns of lists whose agents are all made anew in each frame: starts and ends of touches, sweeps and walks are about the same agents. Ids grow, so
 * it looks at the first of a list and the last of the one before.
 */
export function $warnOfNewAgents(collision, agents) {
	let list = $lists.get(collision);
	if (!list) $lists.set(collision, list = { lastId: Infinity, newFrames: 0 });
	list.newFrames = agents?.[0]?.id > list.lastId ? list.newFrames + 1 : 0;
	list.lastId = agents?.[agents.length - 1]?.id ?? Infinity;
	if (list.newFrames === $MANY_FRAMES) $warn(`all agents are new in ${$MANY_FRAMES} frames in turn, so no touch lasts, and nothing sweeps: make each agent once, and move it`);
}

/** Warns of what is given to an update beside the list, probably the time. */
export function $warnOfTime(name, given) {
	if (given.length > 1) $warn(`${name} takes the list alone: the engine knows no time and moves nothing. Move an agent by its speed, multiplied by the time since the last frame`);
}

/** Warns of a function for `accepts` that says nothing, or later. */
export function $warnOfAccepts(accepts) {
	if (typeof accepts !== "function") return;
	const text = Function.prototype.toString.call(accepts);
	const hasBlock = /^(?:function\b|\w+\s*\(|[^=]*=>\s*\{)/.test(text);
	if (/^async\b/.test(text)) $warn("accepts is an async function, whose promise counts as true for every agent: it has to answer at once");
	else if (hasBlock && !/\breturn\b|\bthrow\b|\[native code\]/.test(text)) $warn("accepts returns nothing, so no agent counts: it returns true for those that do");
}

/**
 * Warns of a Collision that has called no handler in its first frames, if a breed that is named has no agents. A breed may come late. So
 * a game whose handlers run hears nothing.
 */
export function $warnOfSilence(collision, agents) {
	$frames++;
	const frames = $silentFrames.get(collision) ?? 0;
	if (frames > $LONG_SILENCE) return;
	$silentFrames.set(collision, collision.statistics.handlerCalls > 0 ? Infinity : frames + 1);
	if (frames < $LONG_SILENCE || !Array.isArray(agents)) return;
	const breeds = [...new Set(agents.map((agent) => agent?.breed))];
	const missing = collision.breedsWithoutAgents;
	const missingOfAgents = missing.filter((name) => !$WORLD_BREEDS.includes(name));
	for (const [breed, setting] of [["*terrain", "terrain"], ["*edge", "bounds"]]) {
		if (missing.includes(breed)) $warn(`in ${frames} frames no handler was called, and handlers for ${$WORLD_NAMES[breed]} need the Collision's ${setting}, which is null`);
	}
	if (missingOfAgents.length > 0 && breeds.length > 0) $warn(`in ${frames} frames no handler was called, and no agent is of the breed ${missingOfAgents.map((name) => JSON.stringify(name)).join(" or ")}. The agents' breeds are ${breeds.slice(0, 5).map((name) => JSON.stringify(name)).join(", ")}`);
}

/**
 * Warns of questions whose update() is forgotten: if they are asked for hundreds of frames without it, and an agent has moved meanwhile. An
 * agent that a question moves or refreshes is seen where it is.
 *
 * @param agents the list, if this is the update
 * @param mover the agent that the question moves or refreshes, or null
 */
export function $warnOfStale(queries, agents, mover) {
	// most questions follow others of the same frame
	if (queries === $asked && $frames === $askedFrame && agents === null && mover === null) return;
	$asked = queries;
	$askedFrame = $frames;
	if ($warned.has("stale")) return;
	let last = $updates.get(queries);
	if (agents !== null) {
		if (!last) $updates.set(queries, last = { agents: null, frameThen: 0, placesThen: null, movers: new WeakSet() });
		last.agents = agents;
		last.frameThen = $frames;
		last.placesThen = null;
	}
	if (!last || !Array.isArray(last.agents)) return;
	if (typeof mover?.shape === "string") last.movers.add(mover);
	if ($frames - last.frameThen < $LONG_SILENCE) return;
	last.placesThen ??= last.agents.slice(0, 100).filter((agent) => agent).map((agent) => ({ agent, x: agent.x, y: agent.y, z: agent.z }));
	const moved = last.placesThen.find(({ agent, x, y, z }) => !last.movers.has(agent) && (agent.x !== x || agent.y !== y || agent.z !== z));
	if (moved) $warn(`questions see ${moved.agent} where it was at the last queries.update(agents), ${$frames - last.frameThen} frames ago: call it once a frame, or refresh(agent)`, "stale");
}

/**
 * Warns of a forgotten collision.update(): questions about a Collision with handlers are updated thousands of times, and the Collision never is. It
 * waits long, because a game may ask its questions before its first frame.
 */
export function $warnOfNoFrames(queries) {
	const collision = queries._source;
	if (!(collision._handlers?._lists.length > 0) || $silentFrames.has(collision)) return;
	const updates = ($updatesBefore.get(collision) ?? 0) + 1;
	$updatesBefore.set(collision, updates);
	if (updates !== $LONG_WAIT) return;
	const [breeds] = $additions.get(collision)?.keys() ?? [];
	$warn(`questions were updated ${updates} times, and their Collision with handlers${breeds ? ` for ${breeds}` : ""} never, so no handler runs: call collision.update(agents) once a frame, too`);
}

/**
 * Warns of rays that begin inside of the agent that sends them: many begin in an agent that moves, all at the same place beside the agent's own. It
 * compares with the ray before, which began in an agent.
 */
export function $warnOfSender(agent, origin) {
	if ($warned.has("sender")) return;
	const before = $sender;
	const [dx, dy, dz] = [origin.x - agent.x, origin.y - agent.y, origin.z - agent.z];
	const isBeside = agent === before.agent && Math.abs(dx - before.dx) + Math.abs(dy - before.dy) + Math.abs(dz - before.dz) < 1e-9 * agent.size;
	if (isBeside && agent.x === before.x && agent.y === before.y) return;
	$sender = { agent, dx, dy, dz, x: agent.x, y: agent.y, rays: isBeside ? before.rays + 1 : 1 };
	if ($sender.rays === $MANY_FRAMES) $warn(`${$MANY_FRAMES} rays began inside of ${agent}, and met it at distance 0, wherever it was. If it sends them, leave it out: cast(origin, direction, maxDistance, { except: [agent] })`, "sender");
}

/** Warns of a built-in model that takes the place of one of other lengths, because neither has got a name. */
export function $warnOfReplaced(receiver, model) {
	if (!$isBuiltIn(model) || model.name !== "box" && model.name !== "capsule") return;
	const before = receiver.$choice ? receiver.$choice.$modelOf(model.name) : receiver.modelOf(model.name); // a LevelShapes has its models in its choice
	if ($isBuiltIn(before) && before.vertices.join() !== model.vertices.join()) $warn(`a ${model.name} of other lengths takes the place of the first, because both are called "${model.name}": BuiltInModel.${model.name}() takes a name last`);
}

/** Whether an object is a BuiltInModel itself, and none of a game's subclass. */
function $isBuiltIn(model) {
	return Object.getPrototypeOf(model ?? {})?.constructor?.name === "BuiltInModel";
}

/** Warns of arguments that a constructor does not take: `new CombinationCollider(greatLand, { exact: true })`, `new GreatLand({ loadHulls: true })`. */
export function $warnOfMore(name, given, taken) {
	if (given.length <= taken) return;
	const [setting] = given[taken] instanceof Object ? Object.keys(given[taken]) : [];
	const such = setting === undefined ? "" : ` such as ${setting}`;
	const [number, others] = [["no arguments", "those that it got"], ["1 argument", "the others"], ["2 arguments", "the others"]][taken];
	$warn(`new ${name} takes ${number}, and does nothing with ${others}: settings${such} are set after it`);
}

/**
 * Warns of an agent that falls without end: in each of many walks it has come down by more than it went sideways. Steeper than that is no
 * ground that it walks on. And of many walks in turn that are probably each the way of a second.
 */
export function $warnOfFall(agent, dx, dy) {
	if (typeof agent?.z !== "number") return;
	let fall = $falls.get(agent);
	if (!fall) $falls.set(agent, fall = { walks: 0, from: agent.z, last: agent.z, strides: 0 });
	const way = Math.hypot(dx, dy);
	fall.strides = way > $LONG_STRIDE * agent.size ? fall.strides + 1 : 0;
	if (fall.strides === $MANY_FRAMES) $warn(`${agent} walks ${$rounded(way)} patches in each frame. The engine knows no time: if this is the way of a second, multiply it by the time since the last frame`, "stride");
	fall.walks = fall.last - agent.z > way ? fall.walks + 1 : 0;
	if (fall.walks === 0) fall.from = agent.z;
	fall.last = agent.z;
	if (fall.walks !== $LONG_FALL) return;
	$warn(`${agent} has fallen in ${$LONG_FALL} walks, from z = ${$rounded(fall.from)} to ${$rounded(agent.z)}: nothing stops it. If it should stand, its ground has to be in the list of update(), as large as it should be (a model is one unit wide, unless it is Model.AS_GIVEN), and upright (a file's up axis may be "y"); a level that is one model has to be hierarchical`, "fall");
}

/** Keeps a walk until the next frame of a Collision, which looks at what has stopped it. Of many agents only the first are looked at. */
export function $warnOfWalk(queries, agent, dx, dy, options) {
	if (typeof agent?.z !== "number" || $walks.size >= $MOST_LOOKED_AT_AGAIN) return;
	$walks.set(agent, { queries, dx, dy, filter: options?.filter, x: agent.x, y: agent.y });
}

/**
 * Warns of agents that many walks have stopped before or ended on, if handlers are for the breeds of the two, and these have never met: who walks
 * should go through coins, because it touches nothing that stops it.
 */
export function $warnOfStops(collision) {
	const { interests, _pairIndices: met } = collision._handlers;
	for (const [agent, walk] of $walks) {
		for (const [does, other] of [["stops before", $stopOf(agent, walk)], ["ends on", agent.$platformLink?.platform]]) {
			const [breed, otherBreed] = [agent.$breedNumber, other?.$breedNumber];
			if (!other || !interests.$has(breed, otherBreed) || met.find(breed, otherBreed) >= 0 || met.find(otherBreed, breed) >= 0) continue;
			const [name, otherName] = [agent.breed, other.breed].map((each) => JSON.stringify(each));
			const stops = ($stops.get(name + otherName) ?? 0) + 1;
			$stops.set(name + otherName, stops);
			if (stops === $MANY_STOPS) $warn(`a walk of ${name} ${does} ${otherName} and does not touch them, so the handlers of the two never run. If it should go through them, leave them out: walk(agent, dx, dy, { filter: { exceptBreeds: [${otherName}] } })`);
		}
	}
	$walks.clear();
}

/** The agent that a walk has stopped before. */
function $stopOf(agent, { queries, dx, dy, filter, x, y }) {
	if (Math.hypot(agent.x - x, agent.y - y) >= 0.5 * Math.hypot(dx, dy)) return undefined;
	try {
		return queries.castAgent(agent, dx, dy, 0, filter)?.agent;
	} catch {
		return undefined; // a walk that was refused is no concern of the Collision's
	}
}

/** Warns of a slope that is probably in radians. */
export function $warnOfUnits(options) {
	if (!(options?.slopeDegrees > 0 && options.slopeDegrees < 1.6)) return;
	$warn(`slopeDegrees is ${options.slopeDegrees}, so ground that is steeper than this many degrees is a wall. If these are radians, take ${Math.round(options.slopeDegrees * 180 / Math.PI)}`);
}

/** Warns of a cone's angle that is probably in radians. A cone of one degree or two may be meant, so only parts of π count. */
export function $warnOfCone(degrees) {
	if (degrees !== 0 && $isPartOfTurn(degrees)) $warn(`inCone() takes the cone's full angle in degrees. ${$rounded(degrees)} is a part of π: if this is in radians, take degrees = angle * 180 / Math.PI, here ${$rounded(degrees * 180 / Math.PI)}`, "cone");
}

/**
 * Warns of an agent's angle that is probably in radians. It looks at the first angles alone, and no further once one is of more than a turn. It is
 * short, so V8 makes it a part of the setter, which then makes no object of the Number.
 */
export function $warnOfAngle(agent, name, value) {
	if ($anglesToSee > 0) $warnOfRadians(agent, name, value);
}

/**
 * An angle is probably in radians if it is a part of π; or if it begins again at the other end of a turn, and none was farther yet.
 */
function $warnOfRadians(agent, name, value) {
	const before = agent[name];
	if (typeof value !== "number" || value === 0 || before === value) return;
	$angles.count++;
	$angles.least = Math.min($angles.least, value);
	$angles.most = Math.max($angles.most, value);
	const isPart = $isPartOfTurn(value);
	const areOfATurn = $angles.most - $angles.least < 6.2832 && ($angles.most < 3.1416 || $angles.least >= 0);
	$anglesToSee = areOfATurn ? $anglesToSee - 1 : 0;
	const beginsAgain = areOfATurn && $angles.count > $MANY_ANGLES && Math.abs(value - before) > 4.7 && !Number.isInteger(value);
	if (!isPart && !beginsAgain) return;
	$anglesToSee = 0;
	const why = isPart ? "a part of π" : `and was ${$rounded(before)}; all angles were between ${$rounded($angles.least)} and ${$rounded($angles.most)}`;
	$warn(`${name} of ${agent} is ${$rounded(value)}, ${why}. Angles are in degrees: if this is in radians, take ${name} = angle * 180 / Math.PI, here ${$rounded(value * 180 / Math.PI)}`);
}

/** Whether an angle is some twelfths of π, one turn at most, to the last digits: no angle in degrees is. */
function $isPartOfTurn(angle) {
	const twelfths = Math.abs(angle) * 12 / Math.PI;
	return twelfths < 24.5 && Math.abs(twelfths - Math.round(twelfths)) < 1e-12;
}

/** What an error says about a name that is not known: the name that is probably meant. Of hints the minified module has nothing. */
export function $hintOfName(name, names) {
	const meant = names.find((each) => $areSimilar(name, each));
	return meant === undefined ? "" : `; is ${JSON.stringify(meant)} meant?`;
}

/** What an error says about an option that is not among the names of all: the nearest one. */
export function $hintOfOption(key, names) {
	const word = key.toLowerCase();
	// each letter in common counts against two changes, because abbreviations are common
	const farAway = names.map((each) => $changesBetween(word, each.toLowerCase()) - 2 * $commonLetters(word, each.toLowerCase()));
	const least = Math.min(...farAway);
	return least < 1 ? `the nearest is ${names[farAway.indexOf(least)]}; ` : "";
}

/** Whether a breed's or a model's name may be another one, misspelled. Names that differ in numbers alone are of different breeds. */
function $areSimilar(name, breed) {
	if (name.length < 4 || name.replace(/\d+/g, "") === breed.replace(/\d+/g, "")) return false;
	return name.toLowerCase() === breed.toLowerCase() || $changesBetween(name, breed) <= (Math.max(name.length, breed.length) < 6 ? 1 : 2);
}

/** The names of an object's setters. */
function $settableNames(object) {
	const names = [];
	for (let type = Object.getPrototypeOf(object); type && type !== Object.prototype; type = Object.getPrototypeOf(type)) {
		for (const [name, { set }] of Object.entries(Object.getOwnPropertyDescriptors(type))) if (set && !/^[_$]/.test(name)) names.push(name);
	}
	return names;
}

/** How many letters have to be inserted, removed, replaced, or exchanged with the next (Damerau, 1964; Levenshtein, 1966). */
export function $changesBetween(name, other) {
	let earlier = [];
	let counts = [...other, ""].map((_, i) => i);
	[...name].forEach((letter, i) => {
		const before = counts;
		counts = [i + 1];
		for (let j = 0; j < other.length; j++) {
			const isExchanged = i > 0 && j > 0 && letter === other[j - 1] && name[i - 1] === other[j];
			counts.push(Math.min(before[j + 1] + 1, counts[j] + 1, before[j] + (letter === other[j] ? 0 : 1), isExchanged ? earlier[j - 1] + 1 : Infinity));
		}
		earlier = before;
	});
	return counts[other.length];
}

/** A number for a text, with three digits. */
function $rounded(number) {
	return String(Number(number.toPrecision(3)));
}

/** How many letters two words have in common from the beginning on. */
function $commonLetters(name, other) {
	let same = 0;
	while (same < name.length && name[same] === other[same]) same++;
	return same;
}
