import { ArgumentError } from "starlogo-collision";

/**
 * Refuses options that there are not: a misspelt one would do nothing.
 *
 * @param {string} call the function that has got them
 * @param {object} others what is left of the options without those that there are
 * @param {string[]} names those that there are
 */
export function refuseOthers(call, others, ...names) {
	const [wrong] = Object.keys(others);
	if (wrong === undefined) return;
	if (wrong === "0") throw new ArgumentError(`${call}: options must be a literal such as { up: "y" }, not ${textOf(Object.values(others).join(""))}`);
	const inCommon = names.map((name) => [...name].findIndex((letter, i) => letter.toLowerCase() !== wrong[i]?.toLowerCase())).map((length, i) => (length < 0 ? names[i].length : length));
	const most = Math.max(...inCommon);
	const nearest = most > 1 && names.length > 1 ? `the nearest is ${names[inCommon.indexOf(most)]}; ` : "";
	throw new ArgumentError(`${call}: options.${wrong} is no option; ${nearest}there ${names.length > 1 ? "are" : "is"} ${names.join(", ")}`);
}

/** The text for a value in an error. */
export function textOf(value) {
	return typeof value === "string" ? `"${value}"` : typeof value === "object" && value !== null ? `${value.constructor?.name ?? "object"}` : String(value);
}
