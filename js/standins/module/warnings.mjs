/** Warnings while a game is developed: about what is allowed, and probably a mistake. The minified module has none of them. */
import { $isForUsers, distanceOf } from "./language.mjs";

const $MOST_LOOKED_AT = 1000;
const $warned = /* @__PURE__ */ new Set();
let $lookedAt = 0;

/** Writes a warning to the console, once. */
export function $warn(message) {
	if ($isForUsers || $warned.has(message)) return;
	$warned.add(message);
	globalThis.console?.warn?.(`starlogo-collision: ${message}`);
}

/**
 * Warns of properties of an agent or a collision system that do nothing: `agent.sweep = true` sets a property of the game's own, because
 * the engine's is called `sweeps`. Only the first thousand objects are looked at.
 */
export function $warnOfNames(object) {
	if ($isForUsers || $lookedAt >= $MOST_LOOKED_AT) return;
	$lookedAt++;
	for (const name of Object.keys(object)) {
		if (/^[_$]/.test(name) || name.length < 4) continue;
		const type = object.constructor.name;
		if (name === "exact" || name === "maxDepth") $warn(`${name} does nothing on a ${type}: it is for a HierarchicalCollider or a CombinationCollider`);
		const names = $settableNames(object);
		const meant = names.find((each) => each === name) ?? names.find((each) => each.toLowerCase() === name.toLowerCase() || $areClose(name, each));
		if (meant === name) $warn(`${name} is a field of ${type} that hides the engine's: set it in the constructor`);
		else if (meant !== undefined) $warn(`${name} is no property of ${type} that the engine reads; is ${meant} meant?`);
	}
}

/** The names of an object's setters. */
function $settableNames(object) {
	const names = [];
	for (let type = Object.getPrototypeOf(object); type && type !== Object.prototype; type = Object.getPrototypeOf(type)) {
		for (const [name, { set }] of Object.entries(Object.getOwnPropertyDescriptors(type))) if (set && !/^[_$]/.test(name) && name.length > 3) names.push(name);
	}
	return names;
}

/** Whether one letter too many, too few or another makes one name of the other. */
function $areClose(name, other) {
	let same = 0;
	while (same < name.length && name[same] === other[same]) same++;
	return distanceOf(name, other) + 2 * same <= 1;
}
