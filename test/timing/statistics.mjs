/**
 * The exponent of y = c x^e, by least squares of the logarithms.
 *
 * @param {[number, number][]} points
 * @returns {number | undefined} undefined for fewer than two different x
 */
export function exponent(points) {
	const logs = points.map(([x, y]) => [Math.log(x), Math.log(y)]);
	const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
	const [meanX, meanY] = [mean(logs.map(([x]) => x)), mean(logs.map(([, y]) => y))];
	const squares = logs.reduce((sum, [x]) => sum + (x - meanX) ** 2, 0);
	return squares > 0 ? logs.reduce((sum, [x, y]) => sum + (x - meanX) * (y - meanY), 0) / squares : undefined;
}

/** What identifies an entry from run to run. */
export function key(entry) {
	return `${entry.figure} / ${entry.subject} / ${entry.variant}`;
}

// Runs drift apart by more than the repetitions within one of them do: by so much of a number, either way.
const DRIFT = 0.1;

/**
 * What became faster or slower beyond the noise: the ranges of both runs, as multiples of the sphere-sphere test and each
 * wider by the drift between runs, are apart.
 *
 * @param {object[]} older entries of a report
 * @param {object[]} newer entries of another
 * @returns {{key: string, before: object, after: object, change: number}[]} change: newer over older, slowest first
 */
export function changes(older, newer) {
	const before = new Map(older.map((entry) => [key(entry), entry]));
	return newer
		.map((after) => ({ key: key(after), before: before.get(key(after)), after }))
		.filter(({ before: old, after }) => old?.multiple && after.multiple
			&& areApart(old, after))
		.map((pair) => ({ ...pair, change: pair.after.multiple / pair.before.multiple }))
		.sort((a, b) => b.change - a.change);
}

function areApart(a, b) {
	const [less, more] = a.multiple < b.multiple ? [a, b] : [b, a];
	return less.multipleHigh * (1 + DRIFT) < more.multipleLow * (1 - DRIFT);
}

/**
 * A report's entries with those of a later run in their places.
 *
 * @param {object[]} older entries of the report
 * @param {object[]} newer entries of the run
 */
export function merged(older, newer) {
	const later = new Map(newer.map((entry) => [key(entry), entry]));
	const kept = new Set(older.map(key));
	return [...older.map((entry) => later.get(key(entry)) ?? entry), ...newer.filter((entry) => !kept.has(key(entry)))];
}
