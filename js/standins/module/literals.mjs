/** Members that take a literal in JavaScript: options, filters, and what the platform passes to addEventListener. */
import { $aBoolean, $refuse } from "./checks.mjs";
import { ArgumentError } from "./language.mjs";
import { $stateOf } from "./shown.mjs";
import { $hintOfOptions, $refuseSetting } from "./warnings/spelling.mjs";

/** The names of the options that objects of a class have. */
const $optionNames = /* @__PURE__ */ new WeakMap();

/**
 * Options or a filter that a public method receives as a literal: a copy, whose setters check the values. An undefined value counts as absent, and an
 * inherited one as given.
 *
 * @param given the literal
 * @param defaults an object of the class that has the options; it receives the values
 * @param expected what is required
 */
export function $options(target, name, given, defaults, expected) {
	const where = target === null ? name : `${target}: ${name}`;
	if (!$isObject(given) || Array.isArray(given)) $refuse(null, where, given, expected);
	const names = $optionNamesOf(defaults);
	for (const key of Object.keys(given)) {
		// an object of the same class has fields of its own
		const isInner = /^[_$]/.test(key);
		if (names.includes(key) || isInner && key in defaults) continue;
		if (isInner) $refuse(null, where, given, expected);
		throw new ArgumentError(`${where}.${key} is no option; ${$hintOfOptions(name, given, key, names)}there are ${names.join(", ")}`);
	}
	for (const key of names) {
		const value = given[key];
		if (value === undefined) continue;
		try {
			defaults[key] = value;
		} catch (error) {
			$refuseSetting(where, error);
			throw error;
		}
	}
	return defaults;
}

/** The names of an object's options. Those of a class are found once. */
function $optionNamesOf(defaults) {
	const type = defaults.constructor;
	if (type === Object) return Object.keys(defaults);
	if (!$optionNames.has(type)) $optionNames.set(type, Object.keys($stateOf(defaults)));
	return $optionNames.get(type);
}

/** Whether an argument is an object. In place of a Boolean it has options. */
export function $isObject(value) {
	return typeof value === "object" && value !== null;
}

/** Refuses what is no AbortSignal and not null. */
function $aSignal(name, value) {
	if (value !== null && typeof value.addEventListener !== "function") $refuse(null, name, value, "an AbortSignal");
}

/** `addEventListener(type, listener, { once, capture, signal }, priority)`. Events have no phases, so capture is ignored. */
export function $listen(target, type, listener, given, priority) {
	const { once, signal } = $options(null, "addEventListener: options", given, { once: false, capture: false, signal: null }, "a literal such as { once: true }");
	$aBoolean("addEventListener: options.once", once);
	$aSignal("addEventListener: options.signal", signal);
	if (signal?.aborted) return;
	if (target.$recordOf(type, listener) !== null) return;
	target.addEventListener(type, listener, false, priority);
	const added = target.$recordOf(type, listener);
	added.isOnce = once;
	signal?.addEventListener("abort", () => target.$removeRecord(added), { once: true });
}

/** `loader.loadAsync(name, url, { upAxis, scaling, signal })`. */
export function $loadAsync(loader, name, url, given) {
	return new Promise((resolve, reject) => {
		const defaults = { upAxis: "z", scaling: "footprint", signal: null };
		const { upAxis, scaling, signal } = $options("ModelLoader.loadAsync", "options", given, defaults, "a literal such as { upAxis: \"y\" }");
		$aSignal("ModelLoader.loadAsync: options.signal", signal);
		signal?.throwIfAborted();
		loader.load(name, url, upAxis, scaling);
		const load = loader.$_loads.at(-1);
		const stop = () => loader.drop(load);
		signal?.addEventListener("abort", stop);
		load.whenOver = (model, problem) => {
			signal?.removeEventListener("abort", stop);
			if (model !== null) resolve(model);
			else reject(problem ?? (signal?.aborted ? signal.reason : new DOMException(`the load of ${name} was cancelled`, "AbortError")));
		};
	});
}
