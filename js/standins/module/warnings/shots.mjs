/** Shots that pass through others untested: that sweep, but move before their first frame; and that do not sweep, and tunnel. */
import { $greatestId } from "./frames.mjs";
import { $greatLandOf } from "./properties.mjs";
import { $distance, $getOrInsert, $hasWarned, $isSameStep, $placeOf, $rounded, $warn } from "./warn.mjs";

/** So many agents are looked at in a frame, and so many are followed. */
const $MOST_PLACED = 100;

/** A path of more sizes of the agent than this may lead through a wall. */
const $FAR = 0.5;

/** A class's own fields of these names hide the engine's, which is warned of: the agent is where it was. */
const $FIELDS = ["x", "y", "z", "sweeps", "size"];

/** An agent that was put somewhere is a shot if it moves by more than this many of its sizes in each of so many frames, by the same step. */
const $FAST = 2;
const $MANY_STEPS = 4;

/** A step is tested at places that are one size of the shot apart, at this many at most. */
const $MOST_SAMPLES = 32;

/** So many tests are made in one frame, and so many in all: a game with many shots shall not become slow. */
const $MOST_TESTS_IN_FRAME = 200;
let $testsLeft = 20000;

/** Where agents have been put since the last frame, and not moved to. */
const $placed = /* @__PURE__ */ new Map();

/**
 * Shots that do not sweep: their place in the last frame, the step to it, in how many frames in turn the step was this one, and what they have passed
 * through in these.
 */
const $shots = /* @__PURE__ */ new Map();

/** Of an agent that sweeps: where its last jump ended, by which step, and how many jumps in turn were by this one. */
const $jumpsOf = /* @__PURE__ */ new WeakMap();

function $newShot(place, step) {
	return { place, step, repeats: 0, passed: null };
}

/** Agents that were put at the world's origin, where a new one is anyway. */
export const $putAtOrigin = /* @__PURE__ */ new WeakSet();

/** How far the farthest vertex of a model is from its origin. */
const $reaches = /* @__PURE__ */ new WeakMap();

/** Keeps where an agent is put, if no path leads there: a new one by moveTo, or any by jumpTo. */
export function $warnOfPlace(agent, x, y, z, isJump) {
	if (x === 0 && y === 0 && z === 0) $putAtOrigin.add(agent);
	if (!isJump && (agent.id <= $greatestId || $placed.has(agent)) || $placed.size >= $MOST_PLACED) return;
	if (!isInWorld(x, y, z)) return; // the engine refuses it
	$placed.set(agent, { x, y, z });
}

/**
 * Warns of an agent that sweeps, and is moved by jumps: each begins where the last one ended, and is by the same step. Nothing is tested on
 * the way of a jump.
 */
export function $warnOfJumps(agent, x, y, z) {
	if (!agent.sweeps || !isInWorld(x, y, z)) return;
	const before = $jumpsOf.get(agent);
	const step = new Vector3D(x - agent.x, y - agent.y, z - agent.z);
	const isNext = before && $distance(agent, before.place) === 0 && step.length > $FAR * agent.size && $isSameStep(step, before.step);
	const repeats = isNext ? before.repeats + 1 : 0;
	$jumpsOf.set(agent, { place: new Vector3D(x, y, z), step, repeats });
	if (repeats !== $MANY_STEPS) return;
	$warn(`${agent} sweeps, and is moved by jumpTo(): a jump goes through everything. It meets what is on its way if it has moveTo()`, "jumps of a shot");
}

/** Warns of agents of a list that sweep, and have been moved since; and of shots that do not sweep, and tunnel. */
export function $warnOfShots(collision, agents) {
	const leastLeft = $testsLeft - $MOST_TESTS_IN_FRAME;
	for (const [agent, shot] of $shots) $followShot(collision, agents, agent, shot, leastLeft);
	if ($placed.size === 0) return;
	for (const [agent, place] of $placed) {
		if (!agents.includes(agent)) continue;
		if (agent.sweeps) $lookAtFirstPath(agent, place);
		else if ($shots.size < $MOST_PLACED && !$hasWarned("tunneling")) $shots.set(agent, $newShot($placeOf(agent), new Vector3D()));
	}
	$placed.clear();
}

function $lookAtFirstPath(agent, place) {
	const length = $distance(agent, place);
	if (!(length > $FAR * agent.size) || $FIELDS.some((name) => Object.hasOwn(agent, name))) return;
	$warn(`${agent} sweeps, and was moved by ${$rounded(length)} between its place (${[place.x, place.y, place.z].map($rounded).join(", ")}) and its first frame. `
		+ "This part of its path is not tested: put a shot into the muzzle in one frame, and move it from the next one on", "first path");
}

/** Warns of a shot that has passed through an agent in one of its last steps, if handlers would have been called for the two. */
function $followShot(collision, agents, agent, shot, leastLeft) {
	const before = shot.place;
	const place = $placeOf(agent);
	const step = place.subtract(before);
	const { length } = step;
	if (agent.sweeps || length <= $FAST * agent.size) {
		$shots.delete(agent);
		return;
	}
	if (!$isSameStep(step, shot.step)) {
		$shots.set(agent, $newShot(place, step));
		return;
	}
	Object.assign(shot, { place, step, repeats: shot.repeats + 1 });
	if (!agents.includes(agent)) return;
	shot.passed ??= $passedBy(collision, agents, agent, before, step, leastLeft);
	if (!shot.passed || shot.repeats < $MANY_STEPS) return;
	$warn(`${agent} does not sweep, and has passed through ${shot.passed}: it moves by ${$rounded(length)} patches in a frame, `
		+ `${$rounded(length / agent.size)} times its size. With agent.sweeps = true it meets all that is on its way`, "tunneling");
	$shots.clear();
}

/**
 * The agent that a shot has passed through in a step from a place; undefined if there is none, or if too many were tested. A filter may leave out what
 * shots go through, so with one nothing is said.
 */
function $passedBy({ collisionSystem, filter, $_handlers: { interests } }, agents, agent, from, step, leastLeft) {
	const { table } = collisionSystem.$search ?? {};
	if (!table || filter) return undefined;
	const greatLand = $greatLandOf(collisionSystem);
	const reach = $reachOf(greatLand, agent);
	// an agent that sweeps meets the shot, and another shot may fly beside it
	return agents.find((other) => $testsLeft > leastLeft && $isNear(from, step, other, reach + $reachOf(greatLand, other) + step.length) && !other.sweeps
		&& !$shots.has(other) && interests.includes(agent.$breedNumber, other.$breedNumber) && $isBetween(collisionSystem, table, agent, from, step, other));
}

/** Whether a step from a place leads to less than a distance from another agent's place. */
function $isNear(from, step, { x, y, z }, distance) {
	x -= from.x;
	y -= from.y;
	z -= from.z;
	const part = Math.min(1, Math.max(0, (x * step.x + y * step.y + z * step.z) / step.lengthSquared));
	return Math.hypot(x - part * step.x, y - part * step.y, z - part * step.z) < distance;
}

/** How far an agent's surface may be from its place: without a model it is a sphere that stands there. */
function $reachOf(greatLand, { shape, size }) {
	const model = greatLand?.modelOf(shape);
	return size * (model ? $getOrInsert($reaches, model, $reachOfModel) : 1);
}

function $reachOfModel({ vertices }) {
	let reach = 1;
	for (let i = 0; i < vertices.length; i += 3) reach = Math.max(reach, Math.hypot(vertices[i], vertices[i + 1], vertices[i + 2]));
	return reach;
}

/** Whether a shot touches another agent at a place of its step from a place, and at neither end. The step is relative to the other, which may fly along. */
function $isBetween(collisionSystem, table, agent, from, step, other) {
	const row = table.listed.rowOf(other);
	if (!table.isSeen(row)) return false;
	const { x: xs, y: ys, z: zs } = table.$places;
	const otherStep = $placeOf(other).subtract(new Vector3D(xs[row], ys[row], zs[row]));
	from = from.add(otherStep);
	const { x, y, z, length } = step.subtract(otherStep);
	const places = Math.min($MOST_SAMPLES, Math.ceil(length / agent.size));
	const touchesAt = (place) => {
		$testsLeft--;
		// The agent is put there for this test alone. Its revision stays, so nothing that was computed for it is computed again.
		Object.assign(agent.$placement, { x: from.x + place / places * x, y: from.y + place / places * y, z: from.z + place / places * z });
		return collisionSystem.areColliding(agent, other);
	};
	const { x: endX, y: endY, z: endZ } = agent.$placement;
	try {
		if (touchesAt(places) || touchesAt(0)) return false;
		for (let i = 1; i < places; i++) if (touchesAt(i)) return true;
		return false;
	} catch {
		return false; // the frame says it
	} finally {
		Object.assign(agent.$placement, { x: endX, y: endY, z: endZ });
	}
}

/** Forgets an agent that a question moves, because this tests its path. */
export function $forgetShot(agent) {
	$shots.delete(agent);
}
