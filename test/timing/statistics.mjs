/**
 * The exponent of y = c x^e, by least squares of the logarithms.
 *
 * @param {[number, number][]} points
 * @returns {number | undefined} undefined for fewer than three different x: a line through two says nothing of how well it fits
 */
export function exponent(points) {
	if (new Set(points.map(([x]) => x)).size < 3) return undefined;
	const logs = points.map(([x, y]) => [Math.log(x), Math.log(y)]);
	const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
	const [meanX, meanY] = [mean(logs.map(([x]) => x)), mean(logs.map(([, y]) => y))];
	const squares = logs.reduce((sum, [x]) => sum + (x - meanX) ** 2, 0);
	return logs.reduce((sum, [x, y]) => sum + (x - meanX) * (y - meanY), 0) / squares;
}

/** What identifies an entry from run to run. */
export function key(entry) {
	return `${entry.figure} / ${entry.subject} / ${entry.variant}`;
}

// Runs drift apart by more than the repetitions within one of them do: by so much of a number, either way.
const DRIFT = 0.1;

/**
 * What became faster or slower beyond the noise: the ranges of both runs, as multiples of the sphere-sphere test and each
 * wider by the drift between runs, are apart, and the time did not go the other way. One sample has no range, so it is not compared.
 *
 * @param {object[]} older entries of a report
 * @param {object[]} newer entries of another
 * @returns {{key: string, before: object, after: object, change: number}[]} change: newer over older, slowest first
 */
export function changes(older, newer) {
	const before = new Map(older.map((entry) => [key(entry), entry]));
	return newer
		.map((after) => ({ key: key(after), before: before.get(key(after)), after }))
		.filter(({ before: old, after }) => old?.multiple && after.multiple && old.samples > 1 && after.samples > 1
			&& areApart(rangeOf(old), rangeOf(after)) && (after.multiple - old.multiple) * (after.value - old.value) >= 0)
		.map((pair) => ({ ...pair, change: pair.after.multiple / pair.before.multiple }))
		.sort((a, b) => b.change - a.change);
}

const rangeOf = (entry) => [entry.multipleLow, entry.multipleHigh];

/** Whether two ranges have nothing in common, also if each is wider by the drift. */
function areApart(one, other) {
	const [less, more] = one[0] < other[0] ? [one, other] : [other, one];
	return less[1] * (1 + DRIFT) < more[0] * (1 - DRIFT);
}

const CONTRADICTORY = 'contradictory';
/** By so much of it two numbers that should be the same may differ: runs and turns drift. */
export const TOLERANCE = 0.15;

/**
 * The entries without the numbers that contradict others: something else took the processor in a part of the run, or in one of the runs of
 * a report. A time and its multiple tell how long the sphere-sphere test took beside it. If that is not the usual time, the entry has no
 * number. If the times of an engine and its literal algorithm still have another ratio than their multiples, neither has. The BinCollider
 * does the same in all crowds of as many agents, so of these those have no number that took longer than the fastest.
 *
 * @param {object[]} entries of a run or of a report
 */
export function withoutContradictions(entries) {
	const bad = contradictory(entries);
	return entries.map((entry) => (bad.has(entry) ? { ...entry, value: null, multiple: null, refused: CONTRADICTORY } : entry));
}

function contradictory(entries) {
	const timed = entries.filter((entry) => entry.value && entry.multiple);
	const sphereTest = (entry) => entry.value / entry.multiple;
	const spheres = timed.map(sphereTest).sort((a, b) => a - b);
	const usual = spheres[spheres.length >> 1];
	const bad = new Set(timed.filter((entry) => differ(sphereTest(entry), usual)));
	const usualOnes = timed.filter((entry) => !bad.has(entry));
	const byKey = new Map(usualOnes.map((entry) => [key(entry), entry]));
	for (const literal of usualOnes) {
		const ours = literal.variant.includes('literal') ? byKey.get(key({ ...literal, variant: engineOf(literal) })) : undefined;
		if (ours && differ(sphereTest(literal), sphereTest(ours))) {
			bad.add(literal).add(ours);
		}
	}
	const bins = timed.filter(({ figure, variant }) => figure === 'crowds' && variant === 'BinCollider');
	for (const crowd of bins) {
		if (bins.some((other) => other.agents === crowd.agents && other.high < crowd.low && areApart([other.low, other.high], [crowd.low, crowd.high]))) {
			bad.add(crowd);
		}
	}
	return bad;
}

const differ = (one, other) => Math.max(one, other) > Math.min(one, other) * (1 + TOLERANCE);

/** The variant beside which a literal one stands. */
function engineOf({ figure, variant }) {
	return figure === 'hierarchies' ? 'engine, vertices' : variant.endsWith(', literal') ? variant.slice(0, -', literal'.length) : variant.replace('literal', 'engine');
}

// A number that is left out is worth less than a time whose multiple is, and this less than a time with a multiple.
const worth = (entry) => (entry.refused ? 0 : entry.multiple === null ? 1 : 2);

/**
 * A report's entries with those of a later run in their places. A worse number does not take the place of a better one, nor one with which
 * the report would contradict itself, unless a test of all pairs says otherwise of its collisions than before. Numbers that still
 * contradict one another are left out.
 *
 * @param {object[]} older entries of the report
 * @param {object[]} newer entries of the run
 */
export function merged(older, newer) {
	const before = new Map(older.map((entry) => [key(entry), entry]));
	const isNeeded = (entry) => !before.has(key(entry)) || before.get(key(entry)).agrees !== entry.agrees;
	const better = newer.filter((entry) => isNeeded(entry) || !isWorse(entry, before.get(key(entry))));
	const bad = contradictory(replaced(older, better));
	return withoutContradictions(replaced(older, better.filter((entry) => isNeeded(entry) || before.get(key(entry)).refused || !bad.has(entry))));
}

function replaced(older, newer) {
	const later = new Map(newer.map((entry) => [key(entry), entry]));
	const kept = new Set(older.map(key));
	return [...older.map((entry) => later.get(key(entry)) ?? entry), ...newer.filter((entry) => !kept.has(key(entry)))];
}

/** Whether a number is worth less than an earlier one of the same: left out, of one sample, of a busy machine, or much noisier. */
function isWorse(entry, earlier) {
	if (worth(entry) !== worth(earlier)) return worth(entry) < worth(earlier);
	if ((entry.samples === 1) !== (earlier.samples === 1)) return entry.samples === 1;
	if (Boolean(entry.busy) !== Boolean(earlier.busy)) return Boolean(entry.busy);
	return noise(entry) > 2 * noise(earlier);
}

/** The wider of the ranges of a time and of its multiple, as a part of it. */
function noise({ value, low, high, multiple, multipleLow, multipleHigh }) {
	return Math.max(value ? (high - low) / value : 0, multiple ? (multipleHigh - multipleLow) / multiple : 0);
}
