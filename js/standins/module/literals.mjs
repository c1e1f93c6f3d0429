/** Members that take a literal in JavaScript: options, filters, and what the platform passes to addEventListener. */
import { $refuse } from "./checks.mjs";
import { ArgumentError } from "./language.mjs";
import { $stateOf } from "./shown.mjs";
import { $hintOfOption, $hintOfOptions, $hintOfSetting } from "./warnings/spelling.mjs";

/**
 * Options or a filter that a public method receives as a literal: a copy, whose setters check the values. An undefined value counts as absent.
 *
 * @param given the literal
 * @param defaults an object of the class that has the options; it receives the values
 * @param kind the required kind
 */
export function $options(target, name, given, defaults, kind) {
	const where = target === null ? name : `${target}: ${name}`;
	if (typeof given !== "object" || given === null || Array.isArray(given)) $refuse(null, where, given, kind);
	for (const key of Object.keys(given)) {
		if (!(key in defaults)) {
			if (/^[_$]/.test(key)) $refuse(null, where, given, kind);
			const names = Object.keys($stateOf(defaults));
			throw new ArgumentError(`${where}.${key} is no option; ${$hintOfOptions(name, given, key, names) || $hintOfOption(key, names)}there are ${names.join(", ")}`);
		}
		if (given[key] === undefined) continue;
		try {
			defaults[key] = given[key];
		} catch (error) {
			throw $hintOfSetting(where, error) || error;
		}
	}
	return defaults;
}

/** Whether an object was passed instead of a Boolean: the options of the platform's own addEventListener. */
export function $areOptions(value) {
	return typeof value === "object" && value !== null;
}

/** `addEventListener(type, listener, { once, capture, signal }, priority)`. Events have no phases, so capture is ignored. */
export function $listen(target, type, listener, given, priority) {
	const { once, signal } = $options(null, "addEventListener: options", given, { once: false, capture: false, signal: null }, "a literal such as { once: true }");
	if (signal?.aborted) return;
	const isOwn = (each) => each.call === listener && !each.isCapturing;
	const isKnown = target.$listenersTo(type).some(isOwn);
	target.addEventListener(type, listener, false, priority);
	if (isKnown) return;
	target.$listenersTo(type).find(isOwn).isOnce = once;
	signal?.addEventListener("abort", () => target.removeEventListener(type, listener), { once: true });
}

/** `loader.loadAsync(name, url, { upAxis, scaling, signal })`. */
export function $loadAsync(loader, name, url, given) {
	return new Promise((resolve, reject) => {
		const defaults = { upAxis: "z", scaling: "footprint", signal: null };
		const { upAxis, scaling, signal } = $options("ModelLoader.loadAsync", "options", given, defaults, "a literal such as { upAxis: \"y\" }");
		signal?.throwIfAborted();
		loader.load(name, url, upAxis, scaling);
		const load = loader._loads.at(-1);
		const stop = () => loader.drop(load);
		signal?.addEventListener("abort", stop);
		load.whenOver = (model, problem) => {
			signal?.removeEventListener("abort", stop);
			if (model !== null) resolve(model);
			else reject(problem ?? (signal?.aborted ? signal.reason : new DOMException(`the load of ${name} was cancelled`, "AbortError")));
		};
	});
}
