/** Warnings while a game is developed: about what is allowed, and probably a mistake. The minified module has none of them. */
import { $isForUsers, distanceOf } from "./language.mjs";

const $MOST_LOOKED_AT = 1000;
const $warned = /* @__PURE__ */ new Set();
const $checkedBreeds = /* @__PURE__ */ new Map();
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
		const meant = names.find((each) => each === name) ?? names.find((each) => each.toLowerCase() === name.toLowerCase() || $changesBetween(name, each) <= 1);
		if (meant === name) $warn(`${name} is a field of ${type} that hides the engine's: set it in the constructor`);
		else if (meant !== undefined) $warn(`${name} is no property of ${type} that the engine reads; is ${meant} meant?`);
	}
}

/**
 * Warns of breeds that handlers or a filter name, if no agent has the breed, and agents have one that is called nearly the same. Agents
 * of the breed may still come. So nothing is refused, and a breed is looked for again when there are new names.
 */
export function $warnOfBreeds(names, agents) {
	if ($isForUsers) return;
	for (const name of names) {
		if ($checkedBreeds.get(name) >= Breeds.count) continue;
		const breeds = [...new Set(agents.map((agent) => agent?.breed))].filter((breed) => typeof breed === "string" && !/^\*/.test(breed));
		if (breeds.length === 0) continue;
		$checkedBreeds.set(name, breeds.includes(name) ? Infinity : Breeds.count);
		const meant = breeds.find((breed) => $areSimilar(name, breed));
		if (meant !== undefined && !breeds.includes(name)) $warn(`no agent is of the breed ${JSON.stringify(name)}; is ${JSON.stringify(meant)} meant?`);
	}
}

/** Whether a breed's name may be another one, misspelled. Names that differ in numbers alone are of different breeds. */
function $areSimilar(name, breed) {
	if (name.length < 4 || name.replace(/\d+/g, "") === breed.replace(/\d+/g, "")) return false;
	return name.toLowerCase() === breed.toLowerCase() || $changesBetween(name, breed) <= (Math.max(name.length, breed.length) < 6 ? 1 : 2);
}

/** The names of an object's setters. */
function $settableNames(object) {
	const names = [];
	for (let type = Object.getPrototypeOf(object); type && type !== Object.prototype; type = Object.getPrototypeOf(type)) {
		for (const [name, { set }] of Object.entries(Object.getOwnPropertyDescriptors(type))) if (set && !/^[_$]/.test(name) && name.length > 3) names.push(name);
	}
	return names;
}

/** How many letters are too many, too few or others (Levenshtein, 1966). */
function $changesBetween(name, other) {
	let same = 0;
	while (same < name.length && name[same] === other[same]) same++;
	return distanceOf(name, other) + 2 * same;
}
