import { COLLIDERS, FRAME_MS, THESIS_SPHERE_TEST, THESIS_STRUCTURES, bySubject, castOf, collidersOf, growth, isSure } from './figures.mjs';

/**
 * What the page draws, by figure: {kind, height, labels or series, unit}. Colours are names that the page's style knows:
 * engine, jit, literal, thesis, minimal, and one for each of the engine's colliders.
 */
export function chartsOf(entries) {
	const charts = Object.entries({
		volumes,
		fits: (own) => compared(own, 'ms'),
		access: (own) => compared(own, 'µs', 1e3),
		tests: multiples,
		hierarchies,
		crowds,
		combination,
		scattered,
	}).map(([id, chart]) => [id, entries.filter(({ figure }) => figure === id), chart]).filter(([, own]) => own.length > 0).map(([id, own, chart]) => [id, chart(own)]);
	return Object.fromEntries(charts.filter(([, { series }]) => series.some((one) => one.color !== 'thesis' && hasNumber(one))));
}

/** Whether a series has a number. */
const hasNumber = ({ values, points = values }) => points.some((point) => point !== null);

function bars(labels, unit, series, options = {}) {
	const shown = series.filter((one) => hasNumber(one) || one.refused?.some(Boolean));
	return { kind: 'bars', unit, labels, series: shown, height: 340, ...options };
}

const scaled = (value, factor = 1) => (value === null || value === undefined ? null : value * factor);

/** The bars of entries, some of which may be missing: their values, and which have none because they, or their multiples, were refused. */
const barsOf = (entries, factor, field = 'value') => {
	const numbers = entries.map((entry) => (field === 'value' && entry && !isSure(entry) ? null : entry?.[field]));
	return { values: numbers.map((number) => scaled(number, factor)), refused: numbers.map((number) => number === null) };
};

function compared(entries, unit, factor = 1) {
	const subjects = bySubject(entries);
	return bars(subjects.map(([name]) => name), unit, [
		{ name: 'this engine', color: 'engine', ...barsOf(subjects.map(([, found]) => found.engine), factor) },
		{ name: 'this engine, JIT', color: 'jit', ...barsOf(subjects.map(([, found]) => found.engine), factor, 'beside') },
		{ name: 'literal algorithm', color: 'literal', ...barsOf(subjects.map(([, found]) => found.literal), factor) },
		{ name: 'thesis, 2015', color: 'thesis', values: subjects.map(([, found]) => scaled(found.engine.thesis, factor)) },
	]);
}

function hierarchies(entries) {
	const subjects = bySubject(entries);
	const values = (variant, field) => barsOf(subjects.map(([, found]) => found[variant]), 1, field);
	return bars(subjects.map(([name]) => name), 'ms', [
		{ name: 'this engine, of triangles', color: 'sphere', ...values('engine') },
		{ name: 'this engine, of vertices', color: 'engine', ...values('engine, vertices') },
		{ name: 'of vertices, JIT', color: 'jit', ...values('engine, vertices', 'beside') },
		{ name: 'literal algorithm', color: 'literal', ...values('literal') },
		{ name: 'thesis, 2015', color: 'thesis', values: subjects.map(([, found]) => scaled(found.engine.thesis)) },
	]);
}

function multiples(entries) {
	const subjects = bySubject(entries);
	return bars(subjects.map(([name]) => name), '× sphere-sphere', [
		{ name: 'this engine', color: 'engine', ...barsOf(subjects.map(([, found]) => found.engine), 1, 'multiple') },
		{ name: 'literal algorithm', color: 'literal', ...barsOf(subjects.map(([, found]) => found.literal), 1, 'multiple') },
		{ name: 'thesis, 2015', color: 'thesis', values: subjects.map(([, found]) => scaled(found.engine.thesis, 1 / THESIS_SPHERE_TEST)) },
	]);
}

function volumes(entries) {
	const subjects = bySubject(entries);
	return bars(subjects.map(([name]) => name), 'cubic patches', [
		{ name: 'smallest sphere known', color: 'sphere', values: subjects.map(([, found]) => found['minimal sphere'].value) },
		{ name: 'tightest of the thesis\'s algorithms', color: 'engine', values: subjects.map(([, found]) => Math.min(...THESIS_STRUCTURES.map((name) => found[name].value))) },
		{ name: 'tightest of the thesis, 2015', color: 'thesis', values: subjects.map(([, found]) => Math.min(...THESIS_STRUCTURES.map((name) => found[name].thesis))) },
		{ name: 'hull', color: 'minimal', values: subjects.map(([, found]) => scaled(found.hull?.value)) },
	]);
}

// so short that the labels of 16 bars lie flat
const SHORT = { BinCollider: 'Bin', TightestFitCollider: 'Tightest', HierarchicalCollider: 'Hierarch.', CombinationCollider: 'Combin.' };

function crowds(entries) {
	const most = Math.max(...entries.map((entry) => entry.agents ?? 0));
	const count = entries.some((entry) => entry.agents === 100) ? 100 : most;
	const subjects = bySubject(entries).filter(([name]) => name.startsWith(`${count} `));
	const rows = subjects.flatMap(([name, found]) => collidersOf(entries).filter((collider) => found[collider])
		.map((collider) => ({ name: [SHORT[collider] ?? collider.split('.').pop(), castOf({ subject: name })], entry: found[collider], literal: found[`${collider}, literal`] })));
	return bars(rows.map(({ name }) => name), `ms a frame of ${count} agents`, [
		{ name: 'this engine', color: 'engine', ...barsOf(rows.map(({ entry }) => entry)) },
		{ name: 'this engine, JIT', color: 'jit', ...barsOf(rows.map(({ entry }) => entry), 1, 'beside') },
		{ name: 'literal algorithm', color: 'literal', ...barsOf(rows.map(({ literal }) => literal)) },
		{ name: 'thesis, 2015', color: 'thesis', values: rows.map(({ entry }) => scaled(entry.thesis)) },
	], { line: [FRAME_MS, 'a frame at 25 a second'] });
}

function combination(entries) {
	const subjects = bySubject(entries);
	const labels = Object.keys(subjects[0][1]).filter((name) => !name.endsWith(', literal'));
	const colors = ['engine', 'TightestFitCollider', 'sphere'];
	const series = subjects.map(([name, found], i) => ({ name: `${name}, this engine`, color: colors[i % 3], ...barsOf(labels.map((label) => found[label])) }));
	const [[, first]] = subjects;
	const literal = { name: 'literal algorithm', color: 'literal', ...barsOf(labels.map((label) => first[`${label}, literal`])) };
	return bars(labels, 'ms a frame', subjects.length === 1 ? [...series, literal] : series, { height: 260 });
}

function scattered(entries) {
	const all = growth(entries);
	const first = all.find(({ cast }) => cast === 'mix') ?? all[0];
	const casts = [first, ...all.filter(({ cast }) => cast === `${first.cast}, as dense`)];
	const series = casts.flatMap(({ cast, exponents }, i) => collidersOf(entries).map((collider) => ({
		name: collider.replace('Collider', '') + (i === 0 ? '' : ', as dense') + (exponents[collider] === undefined ? '' : `: n^${exponents[collider].toFixed(2)}`),
		color: COLLIDERS.includes(collider) ? collider : 'minimal',
		isDashed: i > 0,
		points: entries.filter((entry) => entry.variant === collider && castOf(entry) === cast && isSure(entry))
			.map((entry) => ({ x: entry.agents, y: entry.value })),
		refused: entries.filter((entry) => entry.variant === collider && castOf(entry) === cast && !isSure(entry)).map((entry) => entry.agents),
	}))).filter(({ points, refused }) => points.length + refused.length > 0);
	return { kind: 'lines', height: 420, unit: 'ms a frame', xUnit: `agents (${first.cast})`, series, line: [FRAME_MS, 'a frame at 25 a second'] };
}
