/** Questions whose update is forgotten, or whose Collision's is, and that have not seen the ground. */
import { $isUpdated, $updates } from "./frames.mjs";
import { $breedsWithHandlers } from "./handlers.mjs";
import { $forgetShot } from "./shots.mjs";
import { $restoredLists, $restores } from "./snapshots.mjs";
import { $lastWalk } from "./walks.mjs";
import { $distance, $getOrInsert, $hasWarned, $placeOf, $warn } from "./warn.mjs";

/** After so many frames without an update, or walks of one agent, the agents' places are compared. */
const $LONG_WITHOUT_UPDATE = 300;

/** After so many walks what carries the walker is looked at. */
const $MANY_WALKS = 30;

/** So many agents are compared. */
const $MOST_PLACES = 100;

/** So many updates of questions pass before the Collision's own is missed, or so many of these after which they have moved an agent, if it has got somewhere. */
const $LONG_WITHOUT_FRAMES = 3000;
const $LONG_PLAY_WITHOUT_FRAMES = 300;

/**
 * Of questions: how many restores there were before their last update; how many updates they had before their Collision's first, after how many of
 * these they moved an agent, the first such agent, and where it was; the list of their last update, and when it was; the first agent that they have
 * moved since, and how often; where the list's first agents are once that is long ago; by rider, in how many frames in turn its platform moved late; the agents
 * that the questions move themselves.
 */
const $questions = /* @__PURE__ */ new WeakMap();

function $newQuestions() {
	return {
		restores: 0, updatesBefore: 0, playedBefore: 0, player: null, start: null, agents: null, updated: 0, walker: null, walks: 0, lates: new WeakMap(), places: null, movers: new WeakSet(),
	};
}

/** The questions that were asked last, and when. */
let $lastAsked = null;
let $askedUpdate = 0;
let $askedRestore = 0;

/**
 * Warns of questions whose update() is forgotten: if they are asked for hundreds of frames without it, and an agent has moved meanwhile. An
 * agent that a question moves or refreshes is seen where it is. If no Collision counts the frames, the walks of one agent do.
 *
 * @param agents the list, if this is the update
 * @param mover the agent that the question moves or refreshes, or null
 */
export function $warnOfStale(queries, agents, mover) {
	if (agents === null && queries.terrain !== null) $warnOfLateGround(queries);
	if (mover !== null) $forgetShot(mover);
	// most questions follow others of the same frame
	if (queries === $lastAsked && $updates === $askedUpdate && $restores === $askedRestore && agents === null && mover === null) return;
	$lastAsked = queries;
	$askedUpdate = $updates;
	$askedRestore = $restores;
	if ($hasWarned("stale")) return;
	const kept = $getOrInsert($questions, queries, $newQuestions);
	if (agents !== null) kept.restores = $restores;
	else if (mover === null && kept.restores !== $restores) $lookAtRestored(kept, queries);
	if (agents !== null) Object.assign(kept, { agents, updated: $updates, walker: null, walks: 0, places: null });
	if (kept.agents === null) return;
	if (mover !== null) {
		kept.movers.add(mover);
		kept.walker ??= mover;
		if (mover === kept.walker) kept.walks++;
		if (mover === $lastWalk?.agent) $countLate(kept, queries, mover); // a walk, not another motion
	}
	const frames = $updates - kept.updated;
	const below = kept.walks >= $MANY_WALKS && kept.walker === $lastWalk?.agent ? $lastWalk.footing.on : null;
	const platform = $ifMoved(queries, below);
	if (platform) $reportStale(platform, `${kept.walks} motions of ${kept.walker}, which stands on it,`);
	if (Math.max(frames, kept.walks) < $LONG_WITHOUT_UPDATE) return;
	kept.places ??= kept.agents.slice(0, $MOST_PLACES).filter((agent) => agent).map((agent) => ({ agent, x: agent.x, y: agent.y, z: agent.z }));
	const moved = kept.places.find(({ agent, x, y, z }) => !kept.movers.has(agent) && (agent.x !== x || agent.y !== y || agent.z !== z));
	if (!moved) return;
	const since = frames < $LONG_WITHOUT_UPDATE ? `${kept.walks} motions of ${kept.walker}` : `${frames} frames`;
	$reportStale(moved.agent, since);
}

/** Warns of questions that have not seen where restore() has put the agents. */
function $lookAtRestored(kept, queries) {
	kept.restores = $restores;
	const agents = $restoredLists.get(queries.$_source);
	const agent = kept.agents && agents?.find((each) => $hasMovedSince(queries, each));
	if (agent) $warn(`questions do not see ${agent} where restore() has put it: call queries.update(agents) after restore(), before you ask`, "restored");
}

/** Warns of a platform that has moved since the update of its frame when its rider is moved, in many frames in turn. */
function $countLate(kept, queries, rider) {
	const platform = $ifMoved(queries, rider.$platformLink?.platform);
	const lates = platform ? (kept.lates.get(rider) ?? 0) + 1 : 0;
	kept.lates.set(rider, lates);
	if (lates !== $MANY_WALKS || kept.walks >= $MANY_WALKS) return;
	$warn(`${platform} moves after queries.update(agents), in ${lates} frames in turn, and then ${rider} moves, which stands on it: `
		+ "move it before the update. See docs/queries.md in the package, \"The order of a frame\"", "late platform");
}

function $reportStale(agent, since) {
	$warn(`questions see ${agent} where it was at the last queries.update(agents), ${since} ago: `
		+ "call it once a frame, or refresh(agent)", "stale");
}

/** What a walker stands on, if it has moved since questions have seen it; else null. */
function $ifMoved(queries, platform) {
	const isListed = platform && queries.$table.listed.rowOf(platform) >= 0;
	return isListed && $hasMovedSince(queries, platform) ? platform : null;
}

/** Whether an agent is elsewhere than questions have seen it, or they have not seen it. */
function $hasMovedSince({ $table: { listed, $places } }, agent) {
	const row = listed.rowOf(agent);
	return row < 0 || agent.x !== $places.x[row] || agent.y !== $places.y[row] || agent.z !== $places.z[row];
}

/** Warns of a ground that has come since the last update of questions, if they have seen none: rays and walks go through it. */
function $warnOfLateGround(queries) {
	if (!queries.$_isUpdated || queries.$table.listed.agentsByRow[0] !== null) return; // ListedAgents.GROUND_ROW
	$warn("the ground was set after the last queries.update(agents), so questions do not see it: "
		+ "set it before, or update them again", "ground");
}

/**
 * Warns of a forgotten collision.update(): questions about a Collision with handlers are updated many times, and the Collision never is. It
 * waits long if who is moved stays where it is, because a game may show its title before its first frame.
 */
export function $warnOfNoFrames(queries) {
	const collision = queries.$_source;
	if (!(collision.$_handlers?._lists.length > 0) || $isUpdated(collision)) return;
	const kept = $getOrInsert($questions, queries, $newQuestions);
	kept.updatesBefore++;
	if (kept.walker !== null) {
		kept.playedBefore++;
		kept.player ??= kept.walker;
		kept.start ??= $placeOf(kept.player);
	}
	const isPlayed = kept.playedBefore >= $LONG_PLAY_WITHOUT_FRAMES && $distance(kept.player, kept.start) > kept.player.size;
	if (!isPlayed && kept.updatesBefore < $LONG_WITHOUT_FRAMES) return;
	const breeds = $breedsWithHandlers(collision);
	$warn(`questions were updated ${kept.updatesBefore} times, and their Collision with handlers${breeds ? ` for ${breeds}` : ""} never, `
		+ "so no handler runs: call collision.update(agents) once a frame, too", `no frames ${breeds}`);
}
