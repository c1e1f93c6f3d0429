/** Handlers that are probably not what is meant: their parameters, and how they are added and removed. */
import { parametersOf } from "../contacts.mjs";
import { $updates } from "./frames.mjs";
import { $breedsText, $functionKind, $getOrInsert, $warn } from "./warn.mjs";

const $END = 4; // CollisionHandler.END

/** Handlers that are added in so many frames in turn are probably added in all. */
const $MANY_ADDITIONS = 30;

/** A game may have so many Collisions, whose updates count one by one: one frame is no more updates than these. */
export const $MOST_COLLISIONS = 8;

/** The breeds that a handler was added for, as texts. */
const $breedsOf = /* @__PURE__ */ new WeakMap();

/** Of a Collision, by the text of two breeds: the update before their handlers were added, and in how many frames in turn they were. */
const $additions = /* @__PURE__ */ new WeakMap();

/**
 * Warns of a handler with more parameters than it gets arguments, with the contact before the agents, of one that uses the contact
 * at the end of a touch, where it is null, and of one that is async or a generator. Handlers with fewer parameters are as common as methods without any.
 */
export function $warnOfHandler(breed, otherBreed, handler, phase) {
	const breeds = $breedsText(breed, otherBreed);
	const name = `the handler ${handler.name || "without a name"} for ${breeds}`;
	$getOrInsert($breedsOf, handler, () => new Set()).add(breeds);
	if (handler.length > 3) $warn(`${name} has ${handler.length} parameters, and gets three arguments: the two agents and the contact`);
	const kind = $functionKind(handler);
	if (kind.endsWith("GeneratorFunction")) $warn(`${name} is a generator, so a call runs nothing of it: it has to be a function without *`);
	if (kind === "AsyncFunction") {
		$warn(`${name} is async: after an await its contact is another pair's, and its errors are not in handlerErrors. `
			+ "Copy what you need of the contact first, and catch errors in the handler");
	}
	const text = Function.prototype.toString.call(handler);
	const [first, second, third] = parametersOf(text).split(",").map((each) => each.trim());
	if (first === "contact" || second === "contact") {
		$warn(`${name} has its contact too early: it gets the two agents first, (a, b, contact)`);
	}
	if (phase === $END && third && $readsBlindly(text, third)) {
		$warn(`${name} is for the end of a touch, where its third argument is null: there it is without contact. `
			+ "Copy what you need of the contact in onCollisionStart");
	}
}

/** Whether a function reads properties of a parameter, and asks nowhere whether there is an object. */
function $readsBlindly(text, name) {
	if (!/^\w+$/.test(name)) return /^[{[]/.test(name);
	const reads = new RegExp(`\\b${name}\\s*[.[]`);
	const asks = new RegExp(`\\b${name}\\s*(?:\\?|&&|\\|\\||[!=]=)|!\\s*${name}\\b|\\(\\s*${name}\\s*\\)`);
	return reads.test(text) && !asks.test(text);
}

/** Warns of handlers of two breeds that are added in each frame, at the last of many in turn. */
export function $warnOfAddition(collision, breed, otherBreed) {
	const breeds = $breedsText(breed, otherBreed);
	const additions = $getOrInsert($additions, collision, () => new Map());
	const before = additions.get(breeds);
	if (before?.update === $updates) return;
	const frames = $updates - before?.update <= $MOST_COLLISIONS ? before.frames + 1 : 1;
	additions.set(breeds, { update: $updates, frames });
	if (frames !== $MANY_ADDITIONS) return;
	$warn(`handlers for ${breeds} were added in ${$MANY_ADDITIONS} frames in turn, and all of them run: `
		+ "add a handler once, before the first frame");
}

/** Warns of a handler that removeHandler cannot find: it was added for other breeds, or is another function with the same text. */
export function $warnOfRemoval(collision, breed, otherBreed, handler) {
	const breeds = $breedsText(breed, otherBreed);
	const added = $breedsOf.get(handler);
	$additions.get(collision)?.delete(breeds);
	if (added?.has(breeds)) return;
	const why = added ? `is one for ${[...added].join(", ")}`
		: "was never added: a function that => or bind() makes anew is another one. Keep the one that was added";
	$warn(`removeHandler removes nothing for ${breeds}: the function ${handler.name || "without a name"} ${why}`);
}

/** The text of two breeds that a Collision has handlers for; undefined if none were added. */
export function $breedsWithHandlers(collision) {
	return $additions.get(collision)?.keys().next().value;
}
