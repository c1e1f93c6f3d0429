import { exponent } from './statistics.mjs';
import { percent, quoted, ratio, significant, time } from './format.mjs';

/**
 * The figures of the report: from the entries of a run to rows of cells. A cell is a string; a row's first cell is its
 * name. Both the console and the page show these.
 */

/** The thesis's structures, and all. */
export const THESIS_STRUCTURES = ['naive sphere', 'Ritter sphere', 'axis-aligned box', 'z-aligned box', 'oriented box', 'oriented capsule'];
const STRUCTURES = [...THESIS_STRUCTURES, 'minimal sphere', 'minimal capsule', 'hull'];
export const COLLIDERS = ['BinCollider', 'TightestFitCollider', 'HierarchicalCollider', 'CombinationCollider'];
/** Milliseconds of the thesis's sphere-sphere test, and of a frame at 25 a second. */
export const THESIS_SPHERE_TEST = 0.000319;
export const FRAME_MS = 40;

/** The engine's colliders, and those of the reader's own that were measured. */
export const collidersOf = (entries) => [...COLLIDERS, ...others(entries, COLLIDERS)];

/** Entries by subject, in their order: [subject, {variant: entry}]. */
export function bySubject(entries) {
	return [...new Set(entries.map(({ subject }) => subject))]
		.map((each) => [each, Object.fromEntries(entries.filter(({ subject }) => subject === each).map((entry) => [entry.variant, entry]))]);
}

/** A time with its spread, or why there is none. */
export function measured(entry) {
	return entry ? entry.refused ?? `${marked(entry)} ${entry.samples === 1 ? '(one sample)' : spread(entry.value, entry.low, entry.high)}` : '';
}

// A time, with a mark if its multiple was left out.
const marked = (entry) => time(entry.value) + (entry.multiple === null ? '?' : '');

/** What the mark of a time means. */
export const MARK = 'A time with ? may be wrong: its own multiple is left out, so something else took the processor. Nothing is computed from it.';

/** What times and multiples are. */
export const MEDIANS = 'medians ± half the range of the repetitions, without the fastest and the slowest fifth, after a warm-up; if one end is much farther, − and + both'
	+ ' ends. What has no range beside it is a median alone. A multiple is the median of ratios to the test in the same turns, and so not exactly the ratio of two medians.';

/** Half of a range, as a part of its median; both parts of a range that is much longer on one side. */
function spread(median, low, high) {
	const [less, more] = [median - low, high - median].map((part) => part / median);
	return Math.abs(more - less) < 0.1 ? `±${percent((less + more) / 2)}` : `−${percent(less).replace(' %', '')} +${percent(more)}`;
}

/** Whether a time or a multiple is left out, because its range is too wide, or because it contradicts another. */
export function isLeftOut(entry) {
	return Boolean(entry.refused) || entry.multiple === null;
}

/** Whether a time and its multiple are there, so that something can be computed from the time. */
export const isSure = (entry) => Boolean(entry?.value) && entry.multiple !== null;

/** How many times as long as ours the literal algorithm takes; both must be sure. */
export function faster(ours, literal) {
	return isSure(ours) && isSure(literal) ? literal.value / ours.value : undefined;
}

/** The same with the range that follows from the ranges of both. */
export function fasterWithRange(ours, literal) {
	const value = faster(ours, literal);
	return `${ratio(value)} ${spread(value, literal.low / ours.high, literal.high / ours.low)}`;
}

/** A multiple of the sphere-sphere test with its spread. That of the test itself is 1, and has none. */
function multiple(entry) {
	if (entry?.refused || entry?.multiple === null) {
		return 'noisy';
	}
	if (entry?.multiple === undefined) {
		return '';
	}
	return ratio(entry.multiple) + (entry.multipleLow === entry.multipleHigh ? '' : ` ${spread(entry.multiple, entry.multipleLow, entry.multipleHigh)}`);
}

const thesisTime = (entry) => (entry?.thesis === undefined ? '' : quoted(entry.thesis));
const times = (value) => (value === undefined ? '' : ratio(value));
const beside = (entry) => (entry?.beside === undefined ? '' : entry.beside === null ? 'noisy' : time(entry.beside));
const short = (entry) => (!entry ? '' : entry.refused ? 'noisy' : marked(entry));

/** The variants that are not the report's own: a researcher's fitters or colliders, in their order. */
function others(entries, known) {
	return [...new Set(entries.map((entry) => entry.variant))].filter((name) => !known.includes(name) && !name.endsWith(', literal'));
}

/** When to take each of the engine's colliders, in short; docs/choosing.md says more. */
const TAKE = {
	BinCollider: 'for many roundish agents',
	TightestFitCollider: 'in most games',
	HierarchicalCollider: 'for few agents of odd shapes',
	CombinationCollider: 'where players look closely',
};

/** A row for each collider: how often it is right, what a frame of a crowd and of a scattered game takes, when to take it. */
function colliderRows(entries) {
	const games = comparedGames(entries);
	const accuracies = Object.fromEntries(bySubject(entries.filter(({ figure }) => figure === 'colliders')));
	const share = (entry) => (entry ? percent(entry.value / 100) : '');
	const names = new Set([...COLLIDERS, ...Object.keys(accuracies), ...games.flatMap(([, found]) => others(Object.values(found), COLLIDERS))]);
	const timeOf = (entry) => (entry?.refused ? 'noisy' : measured(entry));
	return [...names].map((name) => [COLLIDERS.includes(name) ? name.replace('Collider', '') : name, TAKE[name] ?? '(your own)', share(accuracies[name]?.precision),
		share(accuracies[name]?.recall), ...games.flatMap(([, found]) => [timeOf(found[name]), beside(found[name])])])
		.filter((row) => row.slice(2).some(Boolean));
}

/** The crowd and the scattered game in which colliders are compared: those of docs/choosing.md, or others of their casts, or the last that were measured. */
function comparedGames(entries) {
	return [['crowds', '100 bears'], ['scattered', '1000 mix']].flatMap(([figure, usual]) => {
		const games = bySubject(entries.filter((entry) => entry.figure === figure)).reverse();
		const ofCast = games.filter(([subject]) => castOf({ subject }) === castOf({ subject: usual }));
		return [...games.filter(([name]) => name === usual), ...ofCast, ...games].slice(0, 1);
	});
}

/** The least of a model's volumes that the thesis's algorithms give, by number. */
function volumeRows(entries) {
	const own = others(entries, STRUCTURES);
	return bySubject(entries).flatMap(([model, found]) => {
		const all = STRUCTURES.concat(own).map((name) => found[name]);
		const ofThesis = THESIS_STRUCTURES.map((name) => found[name]);
		const least = Math.min(...ofThesis.map((entry) => entry.value));
		return [
			[`${model} (${all[0].vertices})`, ...all.map((entry) => (entry ? significant(entry.value, 3) : '') + (ofThesis.includes(entry) && entry.value === least ? '*' : ''))],
			['  thesis', ...all.map((entry) => entry?.thesis?.toFixed(3) ?? '')],
		];
	});
}

function modelRows(entries, more) {
	return bySubject(entries).flatMap(([model, found]) => [
		[model, ...more(found), measured(found.engine), multiple(found.engine), beside(found.engine),
			short(found.literal), times(faster(found.engine, found.literal)), thesisTime(found.engine)],
		...others(Object.values(found), ['engine', 'literal']).map((name) => [`  ${name}`, ...more(found).map(() => ''), measured(found[name]),
			multiple(found[name]), beside(found[name]), '', '', '']),
	]);
}

function testRows(entries) {
	return bySubject(entries).map(([test, found]) => {
		const { engine, literal } = found;
		return [test, measured(engine), multiple(engine), multiple(found['engine, all hit']), beside(engine), short(literal), multiple(literal),
			times(faster(engine, literal)), thesisTime(engine), engine.thesis ? ratio(engine.thesis / THESIS_SPHERE_TEST) : ''];
	});
}

function gameRows(entries) {
	return bySubject(entries).flatMap(([scene, found]) => Object.keys(found).filter((name) => !name.endsWith(', literal')).map((name, i) => {
		const entry = found[name];
		const literal = found[`${name}, literal`];
		return [i === 0 ? scene : '', name.replace('Collider', ''), measured(entry), multiple(entry), beside(entry), short(literal), times(faster(entry, literal)),
			thesisTime(entry), String(entry.collisions), entry.agrees ? 'same' : 'DIFFER'];
	}));
}

/** Whether some colliders have the collisions of a test of all pairs, or which differ. */
function agreement(games) {
	const wrong = games.filter(({ agrees }) => !agrees).map(({ variant }) => shortName(variant));
	return wrong.length === 0 ? 'same' : `DIFFER: ${wrong.join(', ')}`;
}

/** The games of a run whose collisions are not those of a test of all pairs, by their colliders, in a line; or an empty text. */
export function differing(entries) {
	const wrong = entries.filter(({ agrees }) => agrees === false);
	return [...new Set(wrong.map(({ variant }) => variant))]
		.map((name) => `${name}, in ${wrong.filter(({ variant }) => variant === name).map(({ subject }) => subject).join(' and ')}`).join('; ');
}

function scatteredRows(entries) {
	return growth(entries).flatMap(({ cast, exponents, exponentsByWork }) => {
		const names = collidersOf(entries);
		const games = bySubject(entries.filter((entry) => castOf(entry) === cast)).flatMap(([scene, found]) => {
			const jit = names.map((name) => beside(found[name]));
			const game = [scene, ...names.map((name) => measured(found[name])), range(Object.values(found).map((entry) => entry.collisions)),
				agreement(Object.values(found))];
			return jit.some(Boolean) ? [game, ['  JIT', ...jit, '', '']] : [game];
		});
		const row = (name, values) => [name, ...names.map((collider) => values[collider]?.toFixed(2) ?? ''), '', ''];
		return Object.keys(exponents).length === 0 ? games : [...games, row('exponent', exponents), row('  with collisions', exponentsByWork)];
	});
}

function range(counts) {
	const [least, most] = [Math.min(...counts), Math.max(...counts)];
	return least === most ? String(least) : `${least}–${most}`;
}

/**
 * The fitted exponents of the scattered games' times, of the number of agents and of that of agents and collisions:
 * [{cast, exponents: {collider: exponent}, exponentsByWork: {collider: exponent}}].
 */
export function growth(entries) {
	const casts = [...new Set(entries.map((entry) => castOf(entry)))];
	return casts.map((cast) => {
		const fitted = (size) => Object.fromEntries(collidersOf(entries)
			.map((name) => [name, entries.filter((entry) => entry.variant === name && castOf(entry) === cast && isSure(entry))])
			.map(([name, games]) => [name, exponent(games.map((entry) => [size(entry), entry.value]))])
			.filter(([, value]) => value !== undefined));
		return {
			cast,
			exponents: fitted((entry) => entry.agents),
			exponentsByWork: fitted((entry) => entry.agents + entry.collisions),
		};
	});
}

/**
 * Up to how many agents each collider has frames of at most 40 ms, 25 a second, in the games that were measured: a row for each cast. A game
 * whose range includes 40 ms does not count. A collider whose collisions differ from those of all pairs has no number.
 */
export function agentsAt25Frames(entries) {
	return [...new Set(entries.map((entry) => castOf(entry)))].map((cast) => [cast, ...collidersOf(entries)
		.map((name) => mostAgents(entries.filter((entry) => entry.variant === name && castOf(entry) === cast)))]);
}

function mostAgents(games) {
	if (games.some(({ agrees }) => agrees === false)) {
		return 'DIFFER';
	}
	const agents = (condition) => games.filter(condition).map((entry) => entry.agents);
	const holds = Math.max(...agents((entry) => isSure(entry) && entry.high <= FRAME_MS));
	const fails = Math.min(...agents((entry) => isSure(entry) && entry.low > FRAME_MS));
	if (holds === -Infinity) {
		return fails === Infinity ? (games.length > 0 ? 'noisy' : '') : `fewer than ${fails}`;
	}
	return fails === Infinity ? `at least ${holds}` : `${holds}, not ${fails}`;
}

/** A second table of games: how many agents each collider can have. */
const AT_25_FRAMES = {
	title: '25 frames a second: the most agents whose frames take at most 40 ms',
	head: (entries) => [['game', ...colliderNames(entries)]],
	rows: agentsAt25Frames,
};

/** Who plays in a game: the subject without its number. */
export function castOf(entry) {
	return entry.subject.slice(entry.subject.indexOf(' ') + 1);
}

const VOLUMES = {
	head: (entries) => [['model (vertices)', 'naive', 'Ritter', 'aligned', 'z-box', 'box', 'capsule', 'min.', 'min.', 'hull', ...others(entries, STRUCTURES).map(shortName)],
		['', 'sphere', 'sphere', 'box', '1°', '10°', '', 'sphere', 'capsule', '16', ...others(entries, STRUCTURES).map(() => 'own')]],
	rows: volumeRows,
};

const crowdHead = (variants) => [['crowd', variants, 'engine', '× sphere', 'JIT', 'literal', '× engine', 'thesis', 'pairs', 'a test of'],
	['', '', '', '', '', '', '', '', '', 'all pairs']];

/** A class's name without its package. */
const shortName = (name) => name.slice(name.lastIndexOf('.') + 1);
// one that is called as the engine's keeps its package
const colliderNames = (entries) => collidersOf(entries).map((name) => (COLLIDERS.includes(shortName(name)) ? name : shortName(name)).replace(/Collider$/, ''));

/** The entries that a figure shows. */
export const shownIn = ({ id, of = [id] }, entries) => entries.filter(({ figure }) => of.includes(figure));

/**
 * The tables of a figure, without columns that are empty everywhere: [{title, head, rows, textColumns}]. If something else was running, what
 * was too slow may not be; a run that ended early does not say how many agents are too many.
 */
export function tablesOf(figure, entries, { wasDisturbed, isComplete = true }) {
	const own = shownIn(figure, entries);
	const more = figure.more && isComplete ? [{ ...figure.more, title: figure.more.title + (wasDisturbed ? ' (something else was running: it may be more)' : '') }] : [];
	return own.length === 0 ? [] : [figure, ...more].map(({ title, head, rows, textColumns = 1 }) => {
		const [heads, cells] = [head(own), rows(own)];
		const isShown = (_, column) => column === 0 || cells.some((row) => row[column]);
		const shown = (rows) => rows.map((row) => row.filter(isShown));
		return { title, head: shown(heads), rows: shown(cells), textColumns: heads[0].slice(0, textColumns).filter(isShown).length };
	});
}

/** What a figure's note says of its table: the texts of the columns and the rows that are there. */
export function noteOf({ note }, { head, rows }) {
	const names = [...head.flat(), ...rows.map(([name]) => name)];
	return Object.entries(note).filter(([name]) => names.includes(name)).map(([, text]) => text).join(' ');
}

/** Every figure: its name, what it shows, how the lines of its head and its rows come from the entries, and what its note says of a column or row. */
export const FIGURES = [
	{
		id: 'colliders', of: ['colliders', 'crowds', 'scattered'], title: 'Which collider to take',
		head: (entries) => [['collider', 'take it', 'precision', 'recall', ...comparedGames(entries).flatMap(([name]) => [name, 'JIT'])],
			['', '', '', '', ...comparedGames(entries).flatMap(([, found]) => [Object.values(found)[0].figure === 'crowds' ? 'together' : 'scattered', ''])]],
		textColumns: 2,
		rows: colliderRows,
		see: ['docs/choosing.md', 'Choosing a collider'],
		note: { precision: 'Precision: the share of the pairs it reports that touch. Recall: the share of the touching pairs that it reports. Exact mode says which'
			+ ' touch, in the game of "Precision of shapes"; every other agent is hierarchical there.',
		together: 'Together: a frame of the crowd below, with one hierarchical agent in the CombinationCollider\'s.',
		scattered: 'Scattered: a frame of the game below.' },
	},
	{
		id: 'volumes', title: 'Figure 6-1: volumes of bounding structures, in cubic patches', ...VOLUMES,
		lead: 'Each group of bars is a model. A lower bar is a tighter structure. Of the sphere, the cube and the cylinder blue should reach as low as grey; the other models are not the thesis\'s.',
		note: { 'model (vertices)': '* the tightest of the thesis\'s six. The smallest known sphere and capsule, and a hull of at most 16 corners, are on the right. The sphere of the'
			+ ' BinCollider has 0.524. The models are the project\'s own, of the same kinds and vertex counts as the thesis\'s.'
			+ ' Ritter\'s sphere of a cube has one of thirty volumes from 2.72 to 6.81, by the vertices on which it starts and by their'
			+ ' order; the thesis\'s 5.216 is one of them. The built-in sphere has its vertices in other places than the thesis\'s,'
			+ ' and so another box and capsule.' },
	},
	{
		id: 'nova', title: 'Figure 6-1 on the thesis\'s own models, as the StarLogo Nova client ships and turns them', ...VOLUMES,
		note: { 'model (vertices)': 'Of spheres and boxes 42 of 45 are the thesis\'s to 0.003. Ritter\'s spheres of the seagull and the fortress depend on the order of the'
			+ ' vertices; the dragon\'s z-aligned box is smaller at 1 degree. Capsules: the thesis\'s are found for some models alone.' },
	},
	{
		id: 'fits', title: 'Figure 6-2: time to find the tightest fit',
		lead: 'Each group of bars is a model. A lower bar is faster.',
		head: () => [['model', 'vertices', 'tightest', 'engine', '× sphere test', 'JIT', 'literal', '× engine', 'thesis']],
		rows: (entries) => modelRows(entries, (found) => [String(found.engine.vertices), found.engine.tightest]),
		note: { literal: 'Literal: the thesis\'s search for the oriented box alone, every vertex in each of 729 rotations (a ninth is timed).'
			+ ' × engine, here and below: how many times as long as the engine the thesis\'s algorithm takes in the same run.' },
	},
	{
		id: 'access', title: 'Figure 6-3: time to access and transform a tightest fit',
		lead: 'Each group of bars is a model. A lower bar is faster.',
		head: () => [['model', 'engine', '× sphere test', 'JIT', 'literal', '× engine', 'thesis']],
		rows: (entries) => modelRows(entries, () => []),
		note: { model: 'For an agent that has moved and turned. The engine does this once for each agent that has moved.',
		literal: 'The literal collider does it for both agents of each pair.' },
	},
	{
		id: 'tests', title: 'Figure 6-4: time of an intersection test',
		lead: 'Each group of bars is a kind of pair. A lower bar is faster. The sphere-sphere test of the same machine is 1, so grey can be compared here.',
		head: () => [['test', 'engine', '× sphere', 'all hit', 'JIT', 'literal', '× sphere', '× engine', 'thesis', '× sphere']],
		rows: testRows,
		note: { test: 'On random pairs of which 40 % intersect, and on pairs that all do; each as a multiple of the sphere-sphere test of the'
			+ ' same run, the thesis\'s figures as a multiple of its own. Literal tests that are the same as the engine\'s are not repeated.'
			+ ' Hulls have 8 to 16 corners. The thesis has none.' },
	},
	{
		id: 'precision', title: 'Precision of shapes: how many of the pairs that they report touch',
		head: () => [['shape', 'pairs', 'precision', 'recall']],
		rows: (entries) => bySubject(entries).map(([shape, { found, precision, recall }]) => [shape, String(found.value), percent(precision.value / 100),
			percent(recall.value / 100)]),
		note: { shape: 'A game of 150 agents, fifty frames: bears, dragons, firemen, seagulls, fortresses and persons, scattered over the ground and five patches'
			+ ' large. Exact mode says which touch. Precision: the share of the reported pairs that touch. Recall: the share of those that touch which'
			+ ' are reported. Tightest: the smallest of sphere, box and capsule. Hulls have at most 16 corners.'
			+ ' The sphere here encloses the model. That of the BinCollider is as wide as the agent\'s size, so a fortress\'s corners stand out of it.' },
	},
	{
		id: 'hierarchies', title: 'Figure 6-5: time to build a hierarchy',
		lead: 'Each group of bars is a model. A lower bar is faster. Compare dark blue with amber: both build from vertices.',
		head: () => [['model', 'vertices', 'of triangles', 'of vertices', '× sphere test', 'JIT', 'literal', '× engine', 'thesis']],
		rows: (entries) => bySubject(entries).map(([model, found]) => [model, String(found.engine.vertices), measured(found.engine),
			measured(found['engine, vertices']), multiple(found['engine, vertices']),
			beside(found['engine, vertices']), short(found.literal),
			times(faster(found['engine, vertices'], found.literal)), thesisTime(found.engine)]),
		note: { model: 'Ten levels; nodes of five vertices or fewer are not split. The engine builds from triangles, and here also from vertices'
			+ ' alone, as the thesis does. From triangles it takes longer than the thesis: a model has about twice as many triangles as vertices, and each node\'s'
			+ ' box encloses whole triangles. So no level of the hierarchy misses the surface.' },
	},
	{
		id: 'crowds', title: 'Sections 6.1 to 6.4: a frame of a crowd, all in one bin and all colliding',
		lead: 'Each group of bars is a crowd with a collider; those of one crowd stand together. A lower bar is faster. Bars below the red line leave room for 25 frames a second.',
		head: () => crowdHead('collider'),
		textColumns: 2,
		rows: gameRows,
		more: AT_25_FRAMES,
		note: { crowd: 'The engine\'s frames include bins, breeds and handlers. -Dmodels chooses no crowds.',
		literal: 'The literal colliders are timed on 300 of the pairs and multiplied, each pair once'
			+ ' (the thesis counts it twice), without these: so the literal BinCollider, a sphere test for each pair and no more, may take less.',
		collider: 'One agent of the CombinationCollider\'s crowds is hierarchical. Pairs: those that collide. A test of all pairs: whether it finds the same.' },
	},
	{
		id: 'visits', title: 'Section 6.3.3: nodes visited in a frame of these crowds',
		head: () => [['crowd', 'collider', 'pairs of nodes', 'pairs of agents', 'nodes for each', 'thesis']],
		textColumns: 2,
		rows: (entries) => bySubject(entries).flatMap(([crowd, found]) => Object.entries(found).map(([collider, { value, tests }], i) => [i === 0 ? crowd : '',
			collider.replace('Collider', ''), String(value), String(tests), (value / tests).toFixed(1), '5'])),
		note: { crowd: 'A visit compares two nodes of two hierarchies, or a node and the other agent\'s structure. The thesis expects one for each level: five'
			+ ' at its depth of five, for agents that all collide.' },
	},
	{
		id: 'combination', title: 'Section 6.4: CombinationCollider, by how many agents are hierarchical',
		lead: 'Each group of bars has so many hierarchical agents. A lower bar is faster.',
		head: () => crowdHead('of them'),
		textColumns: 2,
		rows: gameRows,
		note: { crowd: 'The thesis gives no number here; it says that it lies between those of the other two colliders.' },
	},
	{
		id: 'experiments', title: 'What the thesis proposes or asks: §3.6.4, §7.4, §7.5, §7.7',
		head: () => [['proposal', 'without', 'with', 'gains', 'more hits']],
		rows: (entries) => bySubject(entries).map(([question, found]) => [question, measured(found.without), measured(found.with),
			times(faster(found.with, found.without)), `${found.more.value.toFixed(1)} %`]),
		note: { proposal: 'Faces alone: the literal test without its nine axes of edges. Factor: the structure with the cheapest tests of up to so many times'
			+ ' the least volume, of six models. First: a test of spheres or capsules around two structures comes before theirs, which are the'
			+ ' engine\'s. Trees: literal ones of five levels, beside boxes. Gains: how many times as long a test takes without the proposal.'
			+ ' The engine has none of them. Faces alone, factors and other trees report agents that do not touch. Tests that come first'
			+ ' gain on these pairs, but not in a frame, whose search has already compared the extents.' },
	},
	{
		id: 'scattered', title: 'Scattered games: a frame, by the number of agents',
		lead: 'Each line is a collider. A lower line is faster, and a flatter one grows less with the number of agents.',
		head: (entries) => [['game', ...colliderNames(entries), 'pairs', 'a test of all pairs']],
		rows: scatteredRows,
		more: AT_25_FRAMES,
		note: { game: 'Agents all over SpaceLand\'s 100 by 100 patches, all moving: of size 1, and of sizes with which any number of them covers as'
			+ ' much of the ground ("as dense"). Pairs: those that collide, by collider. A test of all pairs: whether it finds the same.',
		exponent: 'Exponent e: for n times as many agents a frame takes n to the power of e times as long, fitted to all games of the list.'
			+ ' With 1, twice the agents take twice the time; with 2, four times. The next row counts agents and collisions together,'
			+ ' because the collisions of agents of size 1 grow with the square of the number of agents.' },
	},
	{
		id: 'monitor', title: 'The monitor in a running game',
		head: () => [['game', 'what', '', 'JIT']],
		textColumns: 2,
		rows: (entries) => entries.map((entry) => [entry.subject, entry.variant,
			entry.unit === 'ms' ? measured(entry) : `${significant(entry.value, 2)} ${entry.unit}`, beside(entry)]),
		note: { game: 'A frame at 25 a second has 40 ms. The time that the player takes to draw the monitor is not included. The cost of the'
			+ ' CollisionRecorder is that of recording the collisions.' },
	},
];
