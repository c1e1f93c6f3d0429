/** Shots that pass through others untested: that sweep, but move before their first frame; and that do not sweep, and tunnel. */
import { $greatestId } from "./frames.mjs";
import { $hasWarned, $isSameStep, $rounded, $warn } from "./warn.mjs";

/** So many agents are looked at in a frame, and so many are followed. */
const $MOST_PLACED = 100;

/** A path of more sizes of the agent than this may lead through a wall. */
const $FAR = 0.5;

/** A class's own fields of these names hide the engine's, which is warned of: the agent is where it was. */
const $FIELDS = ["x", "y", "z", "sweeps", "size"];

/** An agent that was put somewhere is a shot if it moves by more than this many of its sizes in each of so many frames, by the same step. */
const $FAST = 2;
const $MANY_STEPS = 4;

/** Two agents that are nearer than this part of the sum of their sizes touch, whatever their shapes; those that are farther than this one do not. */
const $MIDDLE = 0.25;
const $BESIDE = 0.6;

/** Where agents have been put since the last frame, and not moved to. */
const $placed = /* @__PURE__ */ new Map();

/** Shots that do not sweep: their middle in the last frame, the step to it, and in how many frames in turn the step was this one. */
const $shots = /* @__PURE__ */ new Map();

/** Keeps where an agent is put, if no path leads there: a new one by moveTo, or any by jumpTo. */
export function $warnOfPlace(agent, x, y, z, isJump) {
	if (!isJump && (agent.id <= $greatestId || $placed.has(agent)) || $placed.size >= $MOST_PLACED) return;
	if (!isInWorld(x, y, z)) return; // the engine refuses it
	$placed.set(agent, { x, y, z });
}

/** Warns of agents of a list that sweep, and have been moved since; and of shots that do not sweep, and tunnel. */
export function $warnOfShots(collision, agents) {
	for (const [agent, shot] of $shots) $followShot(collision, agents, agent, shot);
	if ($placed.size === 0) return;
	for (const [agent, place] of $placed) {
		if (!agents.includes(agent)) continue;
		if (agent.sweeps) $lookAtFirstPath(agent, place);
		else if ($shots.size < $MOST_PLACED && !$hasWarned("tunneling")) $shots.set(agent, { place: $middleOf(agent), step: new Vector3D(), repeats: 0 });
	}
	$placed.clear();
}

function $lookAtFirstPath(agent, { x, y, z }) {
	const length = Math.hypot(agent.x - x, agent.y - y, agent.z - z);
	if (!(length > $FAR * agent.size) || $FIELDS.some((name) => Object.hasOwn(agent, name))) return;
	$warn(`${agent} sweeps, and was moved by ${$rounded(length)} between its place (${[x, y, z].map($rounded).join(", ")}) and its first frame. `
		+ "This part of its path is not tested: put a shot into the muzzle in one frame, and move it from the next one on", "first path");
}

/** Warns of a shot that has passed through an agent since the last frame, if handlers would have been called for the two. */
function $followShot({ _handlers: { interests } }, agents, agent, shot) {
	const before = shot.place;
	const place = $middleOf(agent);
	const step = place.subtract(before);
	const { length } = step;
	if (agent.sweeps || length <= $FAST * agent.size) {
		$shots.delete(agent);
		return;
	}
	const repeats = $isSameStep(step, shot.step) ? shot.repeats + 1 : 0;
	Object.assign(shot, { place, step, repeats });
	if (repeats < $MANY_STEPS || !agents.includes(agent)) return;
	// hardly any is between, so this comes first; an agent that sweeps meets the shot, and another shot may fly beside it
	const passed = agents.find((other) => $isBetween(before, step, other, agent.size + other.size) && !other.sweeps && !$shots.has(other)
		&& interests.includes(agent.$breedNumber, other.$breedNumber));
	if (!passed) return;
	$warn(`${agent} does not sweep, and has passed through ${passed}: it moves by ${$rounded(length)} patches in a frame, `
		+ `${$rounded(length / agent.size)} times its size. With agent.sweeps = true it meets all that is on its way`, "tunneling");
	$shots.clear();
}

/** Whether the middle of a step from a place leads through an agent, and its ends are beside it. `sizes` is the sum of the sizes of the two. */
function $isBetween(from, step, agent, sizes) {
	const x = agent.x - from.x;
	const y = agent.y - from.y;
	const z = agent.z + agent.size / 2 - from.z;
	const part = (x * step.x + y * step.y + z * step.z) / step.lengthSquared;
	if (!(part > 0 && part < 1)) return false;
	const distanceAt = (share) => Math.hypot(x - share * step.x, y - share * step.y, z - share * step.z);
	return distanceAt(part) < $MIDDLE * sizes && Math.min(distanceAt(0), distanceAt(1)) > $BESIDE * sizes;
}

/** The middle of an agent whose model is as high as it is wide. */
function $middleOf({ x, y, z, size }) {
	return new Vector3D(x, y, z + size / 2);
}

/** Forgets an agent that a question moves, because this tests its path. */
export function $forgetShot(agent) {
	$shots.delete(agent);
}
