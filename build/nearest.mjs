import { $nearestOption } from '../js/standins/module/warnings/spelling.mjs';

/** What a message says after a name that there is not: `; there is --stall`, or nothing if no name is near. */
export function thereIs(name, names, before = '') {
	const nearest = $nearestOption(name, names);
	return nearest === undefined ? '' : `; there is ${before}${nearest}`;
}
