/** Ways that are not tested: of agents that sweep, before the first frame that sees them; and of fast agents that do not sweep. */
import { $greatestId } from "./frames.mjs";
import { $hasWarned, $rounded, $warn } from "./warn.mjs";

/** So many agents are looked at in a frame, and so many are followed. */
const $MOST_PLACED = 100;

/** A way of more sizes of the agent than this may lead through a wall. */
const $FAR = 0.5;

/** A class's own fields of these names hide the engine's, which is warned of: the agent is where it was. */
const $FIELDS = ["x", "y", "z", "sweeps", "size"];

/** An agent that was put somewhere and then moves by more of its sizes than these in each of so many frames, always by the same way, is a shot. */
const $FAST = 2;
const $MANY_WAYS = 4;

/** Two agents that are nearer than this part of the sum of their sizes touch, whatever their shapes; those that are farther than this one do not. */
const $MIDDLE = 0.25;
const $BESIDE = 0.6;

/** Where agents have been put first since the last frame. */
const $placed = /* @__PURE__ */ new Map();

/** Of agents that do not sweep and are fast from the beginning on: their middle in the last frame, the way to it, and in how many frames the way was this one. */
const $flights = /* @__PURE__ */ new Map();

/** Keeps where an agent is put, if no way leads there: a new one by moveTo, or any by jumpTo. */
export function $warnOfPlace(agent, x, y, z, isJump) {
	if (!isJump && (agent.id <= $greatestId || $placed.has(agent)) || $placed.size >= $MOST_PLACED) return;
	if (!isInWorld(x, y, z)) return; // the engine refuses it
	$placed.set(agent, { x, y, z });
}

/** Warns of agents of a list that sweep, and have been moved since; and of those that do not sweep, and fly through others. */
export function $warnOfShots(collision, agents) {
	if ($hasWarned("flight")) $flights.clear();
	for (const [agent, flight] of $flights) $followFlight(collision, agents, agent, flight);
	if ($placed.size === 0) return;
	for (const [agent, place] of $placed) {
		if (!agents.includes(agent)) continue;
		if (agent.sweeps) $lookAtFirstWay(agent, place);
		else if ($flights.size < $MOST_PLACED) $flights.set(agent, { place: $middleOf(agent), way: new Vector3D(), alike: 0 });
	}
	$placed.clear();
}

function $lookAtFirstWay(agent, { x, y, z }) {
	const way = Math.hypot(agent.x - x, agent.y - y, agent.z - z);
	if (!(way > $FAR * agent.size) || $FIELDS.some((name) => Object.hasOwn(agent, name))) return;
	$warn(`${agent} sweeps, and was moved by ${$rounded(way)} between its place (${[x, y, z].map($rounded).join(", ")}) and its first frame. `
		+ "This part of its way is not tested: put a shot into the muzzle in one frame, and move it from the next one on", "shot");
}

/** Warns of an agent that has passed through another one in the last of some frames, if handlers would have been called for the two. */
function $followFlight({ _handlers: { interests } }, agents, agent, flight) {
	const before = flight.place;
	const place = $middleOf(agent);
	const way = place.subtract(before);
	const { length } = way;
	if (agent.sweeps || length <= $FAST * agent.size) {
		$flights.delete(agent);
		return;
	}
	const alike = way.subtract(flight.way).length < 0.2 * length ? flight.alike + 1 : 0;
	Object.assign(flight, { place, way, alike });
	if (alike < $MANY_WAYS || !agents.includes(agent)) return;
	// what sweeps meets it, and what flies may fly beside it
	const passed = agents.find((other) => !other.sweeps && !$flights.has(other) && interests.includes(agent.$breedNumber, other.$breedNumber)
		&& $isBetween(before, place, other, agent.size + other.size));
	if (!passed) return;
	$warn(`${agent} does not sweep, and has passed through ${passed}: it moves by ${$rounded(length)} patches in a frame, `
		+ `${$rounded(length / agent.size)} times its size. With agent.sweeps = true it meets all that is on its way`, "flight");
}

/** Whether the middle of a way leads through an agent, and its ends are beside it. `sizes` is the sum of the sizes of the two. */
function $isBetween(from, to, agent, sizes) {
	const center = $middleOf(agent);
	const way = to.subtract(from);
	const part = center.subtract(from).dotProduct(way) / way.lengthSquared;
	if (!(part > 0 && part < 1)) return false;
	way.scaleBy(part);
	const distanceTo = (point) => center.subtract(point).length;
	return distanceTo(from.add(way)) < $MIDDLE * sizes && Math.min(distanceTo(from), distanceTo(to)) > $BESIDE * sizes;
}

/** The middle of an agent whose model is as high as it is wide. */
function $middleOf({ x, y, z, size }) {
	return new Vector3D(x, y, z + size / 2);
}

/** Forgets an agent that a question moves, which tests its way. */
export function $forgetFlight(agent) {
	$flights.delete(agent);
}
