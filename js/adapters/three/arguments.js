import { ArgumentError, Model } from "starlogo-collision";

/**
 * The engine's own: the record of what a model is made of, the work that makes a model of it, numbers in a list without gaps, the text for a
 * value in an error, and warnings, which the minified module has not.
 */
export const { ModelData, ModelBuilder, vectorOf, textOf, warnings } = Model.$internals;

/**
 * The options of a call, with the defaults of those that are absent, and whether y is up. Refuses options that there are not: a misspelt one
 * would do nothing.
 *
 * @param {string} call the function that has got them
 * @param {object} given what it has got
 * @param {object} others all options that there are beside `up`, with their defaults
 */
export function optionsOf(call, given, others = {}) {
	const options = Model.$internals.checkedOptions(null, `${call}: options`, given, { up: "y", ...others }, 'a literal such as { up: "y" }');
	return { ...options, isYUp: isYUp(options.up, `${call}: options.up`) };
}

/**
 * Whether y is up. The only other axis is z.
 *
 * @param up the axis
 * @param name the option that has it, with its call
 */
export function isYUp(up, name) {
	if (up !== "y" && up !== "z") throw new ArgumentError(`${name} must be "y" or "z", not ${textOf(up)}`);
	return up === "y";
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
