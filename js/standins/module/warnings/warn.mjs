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

/** What a WeakMap keeps of an object. `first` makes it for a new one. */
export function $keptOf(map, object, first) {
	let kept = map.get(object);
	if (kept === undefined) map.set(object, kept = first(object));
	return kept;
}

/** The text of a number, with three digits. */
export function $rounded(number) {
	return String(Number(number.toPrecision(3)));
}

/** The text of two breeds. */
export function $breedsText(breed, otherBreed) {
	return `${JSON.stringify(breed)} and ${JSON.stringify(otherBreed)}`;
}
