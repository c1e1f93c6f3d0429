import { $changesBetween } from '../js/standins/module/warnings/spelling.mjs';

/** What a message says after a name that there is not: `; there is --stall`, or nothing if no name is near. */
export function thereIs(name, names, before = '') {
	const [[nearest, far]] = names.map((each) => [each, $changesBetween(name, each)]).sort((a, b) => a[1] - b[1]);
	return far <= Math.max(1, name.length / 3) ? `; there is ${before}${nearest}` : '';
}
