/** Snapshots that have less than is probably meant: of no agents, or without the traits that a game does not put back itself. */
import { $isUpdated } from "./frames.mjs";
import { $getOrInsert, $rounded, $warn } from "./warn.mjs";

/** The byte of a snapshot that says what is in it, and the bit for traits: see Snapshots.as. */
const $CONTENTS = 4;
const $HAS_TRAITS = 1;

/** If a Collision takes more snapshots without traits than these, it is not known which of them it goes back to. */
const $MOST_SNAPSHOTS = 10;

/** Of a Collision: for each snapshot without traits the agents' ids and places. */
const $withoutTraits = /* @__PURE__ */ new WeakMap();

/** Warns of a snapshot with traits before the first update, which has the traits of nobody; and keeps the places for one without. */
export function $warnOfSnapshot(collision, withTraits) {
	const agents = [...collision.lastAgents];
	if (withTraits) {
		if (agents.length > 0 || $isUpdated(collision)) return;
		$warn("a snapshot before the first update has no agents, so restore() puts nobody back: "
			+ "it is of the list of the last collision.update(agents)");
		return;
	}
	const taken = $getOrInsert($withoutTraits, collision, () => []);
	if (taken.length <= $MOST_SNAPSHOTS) taken.push(agents.map(({ id, x, y, z }) => ({ id, x, y, z })));
}

/** Agents with traits of a snapshot that no binding has looked at since. */
export const $restored = /* @__PURE__ */ new WeakSet();

/** How often Collisions have gone back, and with which list each did last. */
export let $restores = 0;
export const $restoredLists = /* @__PURE__ */ new WeakMap();

/** Warns of going back by a snapshot without traits if an agent is elsewhere than at any such snapshot: the game has not put it back. */
export function $warnOfRestore(collision, bytes, agents) {
	$restores++;
	$restoredLists.set(collision, agents);
	if (bytes?.byteAt($CONTENTS) & $HAS_TRAITS) {
		for (const agent of agents) $restored.add(agent);
		return;
	}
	const taken = $withoutTraits.get(collision);
	if (!taken || taken.length > $MOST_SNAPSHOTS) return;
	const ofThese = taken.filter((places) => places.length === agents.length && places.every(({ id }, i) => id === agents[i]?.id));
	const movedSince = ofThese.map((places) => places.findIndex(({ x, y, z }, i) => agents[i].x !== x || agents[i].y !== y || agents[i].z !== z));
	if (movedSince.length === 0 || movedSince.includes(-1)) return;
	const agent = agents[movedSince.at(-1)];
	const { x, y, z } = ofThese.at(-1)[movedSince.at(-1)];
	const [now, before] = [[agent.x, agent.y, agent.z], [x, y, z]].map((place) => place.map($rounded).join(", "));
	$warn(`restore() leaves ${agent} at (${now}), and it was at (${before}) when the snapshot was taken, which has no traits. `
		+ "Take snapshot({ withTraits: true }), or put the traits back before restore()", "restore");
}
