/** Members that take a literal in JavaScript: options, filters, and what the platform passes to addEventListener. */
import { $refuse } from "./checks.mjs";
import { ArgumentError } from "./language.mjs";
import { $stateOf } from "./shown.mjs";
import { $warnOfSetting } from "./warnings/arguments.mjs";
import { $hintOfOption, $hintOfOptions } from "./warnings/spelling.mjs";

/**
 * Options or a filter that a public method receives as a literal: a copy, whose setters check the values. An undefined value counts as absent.
 *
 * @param options an object of the class that has the options
 * @param kind the required kind
 */
export function $options(target, name, value, options, kind) {
	if (typeof value !== "object" || Array.isArray(value)) $refuse(target, name, value, kind);
	for (const key of Object.keys(value)) {
		if (!(key in options)) {
			if (/^[_$]/.test(key)) $refuse(target, name, value, kind);
			const names = Object.keys($stateOf(options));
			throw new ArgumentError(`${target === null ? "" : `${target}: `}${name}.${key} is no option; ${$hintOfOptions(name, value, key, names) || $hintOfOption(key, names)}there are ${names.join(", ")}`);
		}
		$warnOfSetting(target, name, key, value, options);
		if (value[key] !== undefined) options[key] = value[key];
	}
	return options;
}

/** Whether an object was passed instead of a Boolean: the options of the platform's own addEventListener. */
export function $areOptions(value) {
	return typeof value === "object" && value !== null;
}

/** `addEventListener(type, listener, { once, capture, signal })`. */
export function $listen(target, type, listener, { once = false, capture = false, signal = null }) {
	if (signal?.aborted) return;
	const isOwn = (each) => each.call === listener && each.isCapturing === capture;
	const isKnown = target.$listenersTo(type).some(isOwn);
	target.addEventListener(type, listener, capture);
	if (isKnown) return;
	target.$listenersTo(type).find(isOwn).isOnce = once;
	signal?.addEventListener("abort", () => target.removeEventListener(type, listener, capture), { once: true });
}

/** `loader.loadAsync(name, url, { upAxis, scaling, signal })`. */
export function $loadAsync(loader, name, url, given) {
	return new Promise((resolve, reject) => {
		const kind = "a literal such as { upAxis: \"y\" }";
		if (given === null) $refuse("ModelLoader.loadAsync", "options", given, kind);
		const { upAxis, scaling, signal } = $options("ModelLoader.loadAsync", "options", given, { upAxis: "z", scaling: "footprint", signal: null }, kind);
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
