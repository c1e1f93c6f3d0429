/**
 * Walks and other motions that go wrong: too far in a frame, down without end, stopped by what should be walked through, begun inside of
 * a level.
 */
import { $nameOfBreed } from "./frames.mjs";
import { $lookAtFooting } from "./properties.mjs";
import { $getOrInsert, $isPowerOfTwo, $isSameStep, $rounded, $warn } from "./warn.mjs";

/** So many walks in turn that go down steeply are a fall. */
const $LONG_FALL = 200;

/** A walk of more sizes of the agent than these is long for one frame. */
const $LONG_STRIDE = 2;

/** So many long walks in turn are no accident. */
const $MANY_STRIDES = 30;

/** So many walks that one breed stops are no accident. */
const $MANY_STOPS = 10;

/**
 * Of an agent that walks: how often it has walked; how many long strides it has taken in turn; in how many walks in turn it fell, from which height, and its
 * height now.
 */
const $walkers = /* @__PURE__ */ new WeakMap();

function $newWalker({ z }) {
	return { walks: 0, strides: 0, falls: 0, top: z, z };
}

/** The last walk. It is looked at when the next one begins, because its Footing is written then. */
export let $lastWalk = null;

/** So many jumps of a platform below a walker, each no longer than this, are no accident. */
const $MANY_JUMPS = 10;
const $SHORT_JUMP = 1;

/** Of a platform that has jumped below a walker: by which step, below whom and where that one was, and how often in turn. */
const $jumps = /* @__PURE__ */ new WeakMap();

/** What has changed more often than this is no level, but a door or an enemy. */
const $MANY_CHANGES = 20;
const $REMEDY_FOR_MOVING = "That one moves: the two were in one another before the motion. Where a walk ends, no binding or jump may undo it";

/** What a walk does with another agent that it does not touch: the words of the warning. */
const $STOPS_BEFORE = { does: "stops before", go: "go through", ask: "bump into them, ask what has stopped it: the Footing's against" };
const $ENDS_ON = { does: "ends on", go: "fall through", ask: "stand on them, ask what it stands on: the Footing's on" };

/** How many walks of one breed another has stopped, by the text of both. */
const $stops = /* @__PURE__ */ new Map();

/**
 * Warns of an agent that falls without end: in each of many walks it has come down by more than it went sideways. Steeper than that is no
 * ground that it walks on. And of many walks in turn that are each as long as a second's, probably.
 */
export function $warnOfFall(agent, dx, dy) {
	const walker = $getOrInsert($walkers, agent, $newWalker);
	const length = Math.hypot(dx, dy);
	$countStride(walker, agent, length);
	$countFall(walker, agent, length);
}

function $countStride(walker, agent, length) {
	walker.strides = length > $LONG_STRIDE * agent.size ? walker.strides + 1 : 0;
	if (walker.strides !== $MANY_STRIDES) return;
	$warn(`${agent} walks ${$rounded(length)} patches in each frame. The engine knows no time: if this is its speed, in patches a second, `
		+ "multiply it by the time since the last frame", "stride");
}

function $countFall(walker, agent, length) {
	// who stands on a platform that sinks goes down with it
	const isFalling = walker.z - agent.z > length && !agent.$platformLink?.platform;
	walker.falls = isFalling ? walker.falls + 1 : 0;
	if (walker.falls === 0) walker.top = agent.z;
	walker.z = agent.z;
	if (walker.falls !== $LONG_FALL) return;
	$warn(`${agent} has fallen in ${$LONG_FALL} walks, from z = ${$rounded(walker.top)} to ${$rounded(agent.z)}: nothing stops it. `
		+ "If it should stand, its ground has to be in the list of queries.update(), which is called once a frame; among the breeds of the "
		+ "walk's filter, if that has any; as large as it should be "
		+ "(a model is one unit wide, unless it is Model.AS_GIVEN or of levelFromObject); and upright (a file's up axis may be \"y\"); "
		+ "a level that is one model has to be hierarchical", "fall");
}

/**
 * Warns of agents that many walks have stopped before or ended on, if the questions' Collision has handlers for the breeds of the two, and
 * these have never met: who walks should go through coins, because it touches nothing that stops it.
 */
export function $warnOfWalk(seen, walker, footing) {
	const { handlers, agent, footing: end } = $lastWalk ?? {};
	$lastWalk = { handlers: seen.$_source.$_handlers, agent: walker, footing };
	if ($isPowerOfTwo(++$getOrInsert($walkers, walker, $newWalker).walks)) $lookAtFooting(footing);
	if (!handlers) return;
	if (end.part < 0.5) $countStop(handlers, $STOPS_BEFORE, agent, end.against);
	$countStop(handlers, $ENDS_ON, agent, end.on);
}

function $countStop({ interests, _lists, _indices }, { does, go, ask }, agent, other) {
	if (!agent || !other) return; // the walk was refused, or went on
	const [breed, otherBreed] = [agent.$breedNumber, other.$breedNumber];
	const haveMet = (first, second) => _lists[_indices.find(first, second)]?.pairHandlers;
	if (!interests.$hasPair(breed, otherBreed) || haveMet(breed, otherBreed) || haveMet(otherBreed, breed)) return;
	const [name, otherName] = [agent.breed, other.breed].map($nameOfBreed);
	const stops = ($stops.get(name + otherName) ?? 0) + 1;
	$stops.set(name + otherName, stops);
	if (stops !== $MANY_STOPS) return;
	// who leaves out the ground falls through it
	const through = other.$isEnvironment ? "" : ` If it should ${go} them, leave them out: walk(agent, dx, dy, { filter: { exceptBreeds: [${otherName}] } }).`;
	$warn(`a walk of ${name} ${does} ${otherName} and does not touch them, so the handlers of the two do not run while it only stands there.${through} `
		+ `If it should ${ask}`);
}

/**
 * Warns of a platform that moves sideways by jumps, always by the same step, while a walker stands on it and does not move with it. A walk
 * itself follows one that jumps up or down.
 */
export function $warnOfJump(platform, x, y) {
	if ($lastWalk?.footing.on !== platform) return;
	const { agent } = $lastWalk;
	const step = { x: x - platform.x, y: y - platform.y, z: 0 };
	const length = Math.hypot(step.x, step.y);
	const before = $jumps.get(platform);
	const isLeft = before?.agent === agent && length > 0 && length < $SHORT_JUMP && $isSameStep(step, before.step)
		&& !$isSameStep(step, { x: agent.x - before.x, y: agent.y - before.y, z: 0 });
	const jumps = isLeft ? before.jumps + 1 : 0;
	$jumps.set(platform, { step, agent, x: agent.x, y: agent.y, jumps });
	if (jumps !== $MANY_JUMPS) return;
	$warn(`${platform} is moved by jumpTo() while ${agent} stands on it. A jump carries nobody: a platform that moves has moveTo()`, "jump");
}

/** A body that is this many times half of its extent inside of a structure is inside with room to spare. Two equal ones in one place are not. */
const $WITH_ROOM = 2.1;

/**
 * Warns of an agent that does not stop a motion, because the motion begins deep inside of its tree or its triangles, or whose
 * structure has all that moves inside. See warnOfInside.as.
 */
export function $warnOfInside(body, row, contact) {
	const agents = body._seen.$table.listed.agentsByRow;
	const level = agents[row];
	const isTree = body.bodyOf(row).shape.$tree !== null;
	const { agent, fullBody } = body; // agent is null if a structure is cast
	const { placement: place } = fullBody;
	const { depth } = contact;
	const allowed = (isTree ? 1 : $WITH_ROOM) * fullBody.halfAlong(contact);
	if (level.$isEnvironment || depth <= allowed || body.isShallow(row, contact)) return;
	// how far its lowest point is below its place, if it does not lean
	const below = place.r22 === 1 ? fullBody.halfZ - fullBody.offsetZ : 0;
	const name = agent ?? "a structure that is cast";
	const key = `inside ${level.shape} ${agent?.shape}`;
	const rider = agent && agents.find((each) => each?.$platformLink?.platform === agent);
	const remedy = rider ? $remedyForRider(rider) : level.$revision > $MANY_CHANGES ? $REMEDY_FOR_MOVING : $remedyForPlace(place, agent ? below : 0);
	if (isTree) $warn($textOfTree(name, place, depth, level, remedy), key);
	else $warn($textOfStructure(name, depth, level, agent === null), key);
}

/** What is said of a motion that begins inside of a tree. */
function $textOfTree(name, place, depth, level, remedy) {
	const at = [place.x, place.y, place.z].map($rounded).join(", ");
	return `${name} begins a motion at (${at}), ${$rounded(depth)} deep inside of ${level}, which does not stop it. ${remedy}`;
}

/** What to do if a walker stands on what moves, so that a platform that rises could not lift it. */
function $remedyForRider(rider) {
	return `Its way up is blocked by ${rider}, which stands on it: leave that one out of the filter of its walk. `
		+ "See docs/queries.md in the package, \"Moving platforms\"";
}

/** What to do about a place that is wrong, or a model that is. `below` is how far the lowest point of what moves is below its place. */
function $remedyForPlace(place, below) {
	const up = $rounded(below);
	const remedy = below > 0.01 * place.size
		? `Its lowest point is ${up} below its place: a model that is AS_GIVEN keeps its origin. `
			+ `If its place is on the ground, move it up by ${up}, or give it a model whose origin is its lowest point.`
		: "What is inside of a closed model collides; without exact, what is inside of a box of its tree. "
			+ "A room needs exact, and an opening or thick walls. A level that lies on its side needs another up axis.";
	return `${remedy} See docs/questions.md in the package, "floats in a room"`;
}

/** What is said of a motion that begins inside of the structure around a level. */
function $textOfStructure(name, depth, level, isCast) {
	const end = isCast ? "which it meets at once or not at all" : "and a walk pushes it out";
	const { breed } = level;
	return `${name} begins a motion ${$rounded(depth)} deep inside of the structure around ${level}, ${end}. `
		+ `If it should go through ${JSON.stringify(breed)}, leave them out by a filter: { exceptBreeds: [${JSON.stringify(breed)}] }. `
		+ "If this is a level, whose triangles should count, set hierarchical of it, and take a CombinationCollider with exact. "
		+ "See docs/questions.md in the package, \"thrown out of the level\"";
}
