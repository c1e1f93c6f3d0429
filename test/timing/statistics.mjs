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

/**
 * What became faster or slower beyond the noise: the ranges of both runs, as multiples of the sphere-sphere test, are
 * apart, and by more than a twentieth.
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
			&& (after.multipleLow > old.multipleHigh || after.multipleHigh < old.multipleLow))
		.map((pair) => ({ ...pair, change: pair.after.multiple / pair.before.multiple }))
		.filter(({ change }) => Math.abs(Math.log(change)) > Math.log(1.05))
		.sort((a, b) => b.change - a.change);
}
