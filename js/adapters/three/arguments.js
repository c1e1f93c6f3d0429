import { ArgumentError, Model } from "starlogo-collision";

/**
 * The engine's own: the record of what a model is made of, the work that makes a model of it, numbers in a list without gaps, the check of
 * options, the text for a value in an error, and warnings, which the minified module has not.
 */
export const [ModelData, ModelBuilder, vectorOf, checkedOptions, textOf, warnings] = Model.$parts;

/**
 * The options of a call, with the defaults of those that are absent. Refuses options that there are not: a misspelt one would do nothing.
 *
 * @param {string} call the function that has got them
 * @param {object} options what it has got
 * @param {object} defaults all options that there are
 */
export function optionsOf(call, options, defaults) {
	return checkedOptions(null, `${call}: options`, options, defaults, 'a literal such as { up: "y" }');
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
