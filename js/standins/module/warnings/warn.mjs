/**
 * Warnings while a game is developed: about what is allowed, and probably a mistake. Each file of this folder has those of one subject;
 * this one has what they share. Only the functions `$warn...`, `$refuse...` and `$hint...` are called from outside. The minified module has them
 * without what they do, and nothing else of this folder.
 */

const $warned = /* @__PURE__ */ new Set();

/** Writes a warning to the console, once: a warning with numbers that change has a key that does not. Returns whether it is written now. */
export function $warn(message, key = message) {
	if ($warned.has(key)) return false;
	$warned.add(key);
	globalThis.console?.warn?.(`starlogo-collision: ${message}`);
	return true;
}

/** Whether the warning with a key has been written. */
export function $hasWarned(key) {
	return $warned.has(key);
}

/** The value of a WeakMap for an object. If there is none, `make` makes it. */
export function $getOrInsert(map, object, make) {
	let value = map.get(object);
	if (value === undefined) map.set(object, value = make(object));
	return value;
}

/** Whether a count is 1, 2, 4, 8 and so on: what may change at any time is looked at then. */
export function $isPowerOfTwo(count) {
	return (count & (count - 1)) === 0;
}

/** Where an agent is. */
export function $placeOf({ x, y, z }) {
	return new Vector3D(x, y, z);
}

/** How far apart two are that have x, y and z. */
export function $distance({ x, y, z }, other) {
	return Math.hypot(other.x - x, other.y - y, other.z - z);
}

/** Whether another step is nearly this one: frames do not last equally long. */
export function $isSameStep(step, other) {
	return $distance(step, other) <= 0.2 * Math.hypot(step.x, step.y, step.z);
}

/** What a function is, as the language says it: "Function", "AsyncFunction", "GeneratorFunction" or "AsyncGeneratorFunction". */
export function $functionKind(call) {
	return Object.prototype.toString.call(call).slice(8, -1);
}

/** The text of a number, with three digits. */
export function $rounded(number) {
	return String(Number(number.toPrecision(3)));
}

/** The text of two breeds. */
export function $breedsText(breed, otherBreed) {
	return `${JSON.stringify(breed)} and ${JSON.stringify(otherBreed)}`;
}
