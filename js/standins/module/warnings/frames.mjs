/** What a Collision's frames tell: no handler is called, no agent has a breed that is named, or all agents are new. */
import { $refuseNoAgent } from "./arguments.mjs";
import { $isProbablyMisspelt } from "./spelling.mjs";
import { $getOrInsert, $warn } from "./warn.mjs";

/** After so many frames without a call the breeds are looked at. */
const $LONG_SILENCE = 300;

/** So many frames in turn with new agents alone are no accident, nor so many in which others are there, and stay as they are. */
const $MANY_FRAMES = 30;
const $MANY_FRAMES_BESIDE = 300;

/** Handlers for starts and ends: CollisionHandler.START and END. */
const $LASTING = 5;

/** The most breeds of a call that are compared with all others. */
const $MOST_HINTS = 20;

/** The breeds of what is no agent: how code names them, and the Collision's setting that each needs. */
const $WORLD_BREEDS = /* @__PURE__ */ new Map([
	["*terrain", { name: "Collision.TERRAIN", setting: "terrain" }],
	["*edge", { name: "Collision.EDGE", setting: "bounds" }],
]);

/** How code names a breed. */
export function $nameOfBreed(breed) {
	return $WORLD_BREEDS.get(breed)?.name ?? JSON.stringify(breed);
}

/** How many names of breeds there were when a name was last looked for; without end once an agent has had it. */
const $checkedBreeds = /* @__PURE__ */ new Map();

/** How many times Collisions were updated. */
export let $updates = 0;

/** The greatest id of an agent that was in a list: agents with greater ones are new. */
export let $greatestId = -1;

/**
 * Of a Collision that is updated: how many frames it called no handler from the first on, without end once it has called one; the
 * greatest id of the last list; how many lists in turn had new agents alone, or beside others that stay; the sum of the revisions of these.
 */
const $collisions = /* @__PURE__ */ new WeakMap();

function $newCollision() {
	return { silentFrames: 0, greatestId: Infinity, newFrames: 0, revisions: 0 };
}

/** Whether a Collision was ever updated. */
export function $isUpdated(collision) {
	return $collisions.has(collision);
}

/**
 * Warns of a Collision that has called no handler in its first frames, if a breed that is named has no agents. A breed may come late. So
 * a game whose handlers run hears nothing. It counts the updates.
 */
export function $warnOfSilence(collision, agents) {
	$updates++;
	const kept = $getOrInsert($collisions, collision, $newCollision);
	const frames = kept.silentFrames;
	if (frames > $LONG_SILENCE) return;
	kept.silentFrames = collision.statistics.handlerCalls > 0 ? Infinity : frames + 1;
	if (frames === $LONG_SILENCE) $warnOfMissing(frames, collision.breedsWithoutAgents, agents);
}

/** Warns of breeds that handlers name and nobody has. */
function $warnOfMissing(frames, missing, agents) {
	const since = `in ${frames} frames no handler was called, and`;
	for (const [breed, { name, setting }] of $WORLD_BREEDS) {
		if (missing.includes(breed)) $warn(`${since} handlers for ${name} need the Collision's ${setting}, which is null`);
	}
	const missingOfAgents = missing.filter((name) => !$WORLD_BREEDS.has(name)).map((name) => JSON.stringify(name));
	const breeds = [...new Set(agents.map((agent) => agent.breed))].slice(0, 5).map((name) => JSON.stringify(name));
	if (missingOfAgents.length === 0 || breeds.length === 0) return;
	$warn(`${since} no agent is of the breed ${missingOfAgents.join(" or ")}. The agents' breeds are ${breeds.join(", ")}`);
}

/**
 * Warns of breeds that handlers or a filter name, if no agent has the breed, and agents have one that is called nearly the same. Agents
 * of the breed may still come. So nothing is refused, and a breed is looked for again when there are new names.
 *
 * @param interests the breeds that handlers name: those of agents are not meant by another name, but for case or a plural's s. Nothing
 *     for a filter
 */
export function $warnOfMissingBreeds(names, agents, interests) {
	const unchecked = (names ?? []).filter((name) => !/^\*/.test(name) && !($checkedBreeds.get(name) >= Breeds$NAMES.count));
	if (unchecked.length === 0) return;
	const breeds = new Set(agents.map((agent) => agent?.breed).filter((breed) => typeof breed === "string" && !/^\*/.test(breed)));
	if (breeds.size === 0) return;
	// what a handler names is no filter's mistake
	for (const name of unchecked) $checkedBreeds.set(name, interests || breeds.has(name) ? Infinity : Breeds$NAMES.count);
	// a few: each is compared with all breeds and agents
	const missing = new Set(unchecked.filter((name) => !breeds.has(name)));
	const isFree = (breed) => !interests?.$isNamed(Breeds$NAMES.knownNumberOf(breed));
	const stemOf = (name) => name.toLowerCase().replace(/s$/, "");
	for (const name of [...missing].slice(0, $MOST_HINTS)) {
		const likely = [...breeds].filter((breed) => isFree(breed) || stemOf(breed) === stemOf(name)).concat(...$WORLD_BREEDS.keys());
		$warnOfBreed(name, likely, agents);
	}
}

/** Warns of breeds that a filter names, as $warnOfMissingBreeds() does, and of "*", which only handlers take. */
export function $warnOfBreeds(names, agents) {
	if (names?.includes("*")) $warn('a filter names the breed "*", which no agent has; without breeds it takes agents of any breed');
	$warnOfMissingBreeds(names, agents);
}

/** Warns of a breed that no agent has: a similar one may be meant, or it is a shape. */
function $warnOfBreed(breed, likely, agents) {
	const quoted = JSON.stringify(breed);
	const meant = likely.find((each) => $isProbablyMisspelt(breed, each));
	if (meant !== undefined) {
		$warn(`no agent is of the breed ${quoted}; is ${$nameOfBreed(meant)} meant?`);
		return;
	}
	const shaped = agents.find((agent) => agent?.shape === breed);
	if (shaped) $warn(`no agent is of the breed ${quoted}, which is the shape of ${shaped}: new Agent(${quoted}, "BREED") gives it a breed`);
}

/**
 * Warns of lists whose agents are all made anew in each frame: starts and ends of touches, sweeps and walks are about the same agents. A level and others that stay
 * as they are may be among them; then agents of two breeds are new, and something lasts: handlers of starts or ends, or sweeps. Ids grow, so
 * a new agent has a greater one than all of the list before. It comes first, and refuses what is no agent.
 */
export function $warnOfNewAgents(collision, agents) {
	const kept = $getOrInsert($collisions, collision, $newCollision);
	const newBreeds = new Set();
	let lasts = (collision.$_handlers.phases & $LASTING) !== 0;
	let greatest = -Infinity;
	let others = 0;
	let revisions = 0;
	for (let i = 0; i < agents.length; i++) {
		if (!(agents[i] instanceof Agent)) $refuseNoAgent("Collision.update", agents);
		const { id } = agents[i];
		if (id > greatest) greatest = id;
		if (id > kept.greatestId) {
			newBreeds.add(agents[i].breed);
			lasts ||= agents[i].sweeps;
		} else {
			others++;
			revisions += agents[i].$revision;
		}
	}
	const isAnew = others === 0 ? newBreeds.size > 0 : newBreeds.size > 1 && lasts && revisions === kept.revisions;
	kept.newFrames = isAnew ? kept.newFrames + 1 : 0;
	kept.revisions = revisions;
	kept.greatestId = agents.length > 0 ? greatest : Infinity;
	if (greatest > $greatestId) $greatestId = greatest;
	if (kept.newFrames !== (others === 0 ? $MANY_FRAMES : $MANY_FRAMES_BESIDE)) return;
	const whose = others === 0 ? "all agents" : `all agents of ${[...newBreeds].map((breed) => JSON.stringify(breed)).join(", ")}`;
	$warn(`${whose} are new in ${kept.newFrames} frames in turn, so no touch lasts, and nothing sweeps: make each agent once, and move it`, "new agents");
}
