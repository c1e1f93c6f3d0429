/** Warnings while a game is developed: about what is allowed, and probably a mistake. The minified module has none of them. */
import { $isForUsers } from "./language.mjs";

const $MOST_LOOKED_AT = 1000;
const $warned = /* @__PURE__ */ new Set();
const $checkedBreeds = /* @__PURE__ */ new Map();
const $checkedObjects = /* @__PURE__ */ new WeakSet();
let $lookedAt = 0;

/** What other libraries call traits of an agent, and the engine's names for them. */
const $OTHER_WORDS = {
	isHierarchical: "hierarchical", isSweeping: "sweeps", oneWay: "isOneWay", collidesAs: "collideAs", rotation: "heading, pitch and roll in degrees, or setQuaternion()", quaternion: "setQuaternion()",
	scale: "size", position: "moveTo(x, y, z)", radius: "size", colour: "color",
};

/** Writes a warning to the console, once. */
export function $warn(message) {
	if ($isForUsers || $warned.has(message)) return;
	$warned.add(message);
	globalThis.console?.warn?.(`starlogo-collision: ${message}`);
}

/**
 * Warns of properties that do nothing of an agent, a collision system, a filter, options or a GreatLand: `agent.sweep = true` sets a property of
 * the game's own, because the engine's is called `sweeps`. Only the first thousand objects are looked at, once each, or whenever they are changing.
 */
export function $warnOfNames(object, isChanging) {
	if ($isForUsers || $lookedAt >= $MOST_LOOKED_AT) return;
	if (!isChanging && $checkedObjects.has(object)) return;
	$checkedObjects.add(object);
	$lookedAt++;
	for (const name of Object.keys(object)) {
		if (/^[_$]/.test(name) || name.length < 4) continue;
		const type = object.constructor.name;
		if (name === "exact" || name === "maxDepth") $warn(`${name} does nothing on a ${type}: it is for a HierarchicalCollider or a CombinationCollider`);
		const names = $settableNames(object);
		const other = "sweeps" in object && (type === "Agent" || !/^(?:position|rotation|quaternion|scale|radius)$/.test(name)) ? $OTHER_WORDS[name] : undefined;
		const meant = names.find((each) => each === name) ?? names.find((each) => each.toLowerCase() === name.toLowerCase() || $changesBetween(name, each) <= 1) ?? other;
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

/**
 * Warns of a listener for events that an object never sends: `loader.addEventListener("load", ...)`. Only of the engine's own classes, because a
 * game's may send other events.
 */
export function $warnOfEvent(object, type) {
	if ($isForUsers) return;
	const types = { ModelLoader: ["modelLoaded", "error", "progress", "complete", "cancel"] }[Object.getPrototypeOf(object)?.constructor.name];
	if (types && !types.includes(type)) $warn(`a ModelLoader sends no event ${JSON.stringify(type)}; it sends ${types.join(", ")}`);
}

/** Warns of an agent that does not stop a motion, because the motion begins deep inside of its tree or its triangles. */
export function $warnOfInside(agent) {
	$warn(`the shape ${JSON.stringify(agent.shape)} does not stop this motion, because the motion begins deep inside of it. What is inside of a closed model collides; without exact, what is inside of a box of its tree. A room needs exact, and an opening or thick walls: see docs/questions.md`);
}

/** What an error says about a name that is not known: the name that is probably meant. Of hints the minified module has nothing. */
export function $hintOfName(name, names) {
	const meant = names.find((each) => $areSimilar(name, each));
	return meant === undefined ? "" : `; is ${JSON.stringify(meant)} meant?`;
}

/** What an error says about an option that is not among the names of all: the nearest one. */
export function $hintOfOption(key, names) {
	const word = key.toLowerCase();
	// each letter in common counts against two changes, because abbreviations are common
	const farAway = names.map((each) => $changesBetween(word, each.toLowerCase()) - 2 * $commonLetters(word, each.toLowerCase()));
	const least = Math.min(...farAway);
	return least < 1 ? `the nearest is ${names[farAway.indexOf(least)]}; ` : "";
}

/** Whether a breed's or a model's name may be another one, misspelled. Names that differ in numbers alone are of different breeds. */
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

/** How many letters have to be inserted, removed or replaced (Levenshtein, 1966). */
function $changesBetween(name, other) {
	let counts = [...other, ""].map((_, i) => i);
	[...name].forEach((letter, i) => {
		const before = counts;
		counts = [i + 1];
		for (let j = 0; j < other.length; j++) counts.push(Math.min(before[j + 1] + 1, counts[j] + 1, before[j] + (letter === other[j] ? 0 : 1)));
	});
	return counts[other.length];
}

/** How many letters two words have in common from the beginning on. */
function $commonLetters(name, other) {
	let same = 0;
	while (same < name.length && name[same] === other[same]) same++;
	return same;
}
