import { key } from './statistics.mjs';

/**
 * Entries with what another player took for the same beside: in the field `beside`, null where it is not reported.
 *
 * @param {object[]} entries of a run
 * @param {object[]} others of a run in another player
 * @returns {object[]} copies of the entries; only times of the engine have something beside
 */
export function addBeside(entries, others) {
	const values = new Map(others.map((entry) => [key(entry), entry.value]));
	return entries.map((entry) => (entry.unit === 'ms' && values.has(key(entry)) ? { ...entry, beside: values.get(key(entry)) } : entry));
}

/**
 * How many times as fast the engine is in another run, over all of its times that both report.
 *
 * @param {object[]} entries of a run
 * @param {object[]} others of the other
 * @returns {{count: number, low: number, median: number, high: number} | undefined} undefined if they have none in common
 */
export function timesAsFast(entries, others) {
	const values = new Map(others.map((entry) => [key(entry), entry.value]));
	const ratios = entries
		.filter((entry) => entry.unit === 'ms' && !entry.variant.includes('literal') && entry.value > 0 && values.get(key(entry)) > 0)
		.map((entry) => entry.value / values.get(key(entry)))
		.sort((a, b) => a - b);
	return ratios.length === 0 ? undefined : { count: ratios.length, low: ratios[0], median: ratios[ratios.length >> 1], high: ratios.at(-1) };
}
