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
