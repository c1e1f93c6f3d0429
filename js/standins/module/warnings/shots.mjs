/** Agents that sweep and are moved before the first frame that sees them. That part of their way is not tested. */
import { $greatestId } from "./frames.mjs";
import { $rounded, $warn } from "./warn.mjs";

/** So many agents are looked at in a frame. */
const $MOST_PLACED = 100;

/** A way of more sizes of the agent than this may lead through a wall. */
const $FAR = 0.5;

/** A class's own fields of these names hide the engine's, which is warned of: the agent is where it was. */
const $FIELDS = ["x", "y", "z", "sweeps", "size"];

/** Where agents have been put first since the last frame. */
const $placed = /* @__PURE__ */ new Map();

/** Keeps where an agent is put, if no way leads there: a new one by moveTo, or any by jumpTo. */
export function $warnOfPlace(agent, x, y, z, isJump) {
	if (!isJump && (agent.id <= $greatestId || $placed.has(agent)) || $placed.size >= $MOST_PLACED) return;
	if (!isInWorld(x, y, z)) return; // the engine refuses it
	$placed.set(agent, { x, y, z });
}

/** Warns of agents of a list that sweep, and have been moved since. */
export function $warnOfShots(agents) {
	if ($placed.size === 0) return;
	for (const [agent, { x, y, z }] of $placed) {
		const way = Math.hypot(agent.x - x, agent.y - y, agent.z - z);
		if (!agent.sweeps || !(way > $FAR * agent.size) || !agents.includes(agent)) continue;
		if ($FIELDS.some((name) => Object.hasOwn(agent, name))) continue;
		$warn(`${agent} sweeps, and was moved by ${$rounded(way)} between its place (${[x, y, z].map($rounded).join(", ")}) and its first frame. `
			+ "This part of its way is not tested: put a shot into the muzzle in one frame, and move it from the next one on", "shot");
	}
	$placed.clear();
}
