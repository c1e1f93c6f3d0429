import { ArgumentError } from "starlogo-collision";

/**
 * The options of a call, with the defaults of those that are absent. Refuses options that there are not: a misspelt one would do nothing.
 *
 * @param {string} call the function that has got them
 * @param {object} options what it has got
 * @param {object} defaults all options that there are
 */
export function optionsOf(call, options, defaults) {
	if (typeof options !== "object" || options === null || Array.isArray(options)) throw new ArgumentError(`${call}: options must be a literal such as { up: "y" }, not ${textOf(options)}`);
	const result = { ...defaults };
	for (const [name, value] of Object.entries(options)) {
		if (!(name in defaults)) refuse(call, name, Object.keys(defaults));
		if (value !== undefined) result[name] = value;
	}
	return result;
}

/** Refuses an option that there is not. Names those that there are. */
function refuse(call, wrong, names) {
	const inCommon = names.map((name) => [...name].findIndex((letter, i) => letter.toLowerCase() !== wrong[i]?.toLowerCase())).map((length, i) => (length < 0 ? names[i].length : length));
	const most = Math.max(...inCommon);
	const nearest = most > 1 && names.length > 1 ? `the nearest is ${names[inCommon.indexOf(most)]}; ` : "";
	throw new ArgumentError(`${call}: options.${wrong} is no option; ${nearest}there ${names.length > 1 ? "are" : "is"} ${names.join(", ")}`);
}

/**
 * Refuses what is no point, and returns what is one.
 *
 * @param {string} call the function that has got it
 * @param {object} point what it has got
 */
export function requirePoint(call, point) {
	if (typeof point?.x !== "number" || typeof point.y !== "number" || typeof point.z !== "number") {
		throw new ArgumentError(`${call}: x, y and z must be numbers, as a Vector3 has them, not ${textOf(point)}`);
	}
	return point;
}

/** The text for a value in an error. */
export function textOf(value) {
	return typeof value === "string" ? `"${value}"` : typeof value === "object" && value !== null ? `${value.constructor?.name ?? "object"}` : String(value);
}
