import assert from 'node:assert/strict';
import { test } from 'node:test';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { addBeside, timesAsFast } from './beside.mjs';
import { chartsOf } from './charts.mjs';
import { comparison, repeats, tables } from './console.mjs';
import { csv } from './csv.mjs';
import { differing, FIGURES, growth, agentsAt25Frames, shownIn } from './figures.mjs';
import { greatestLoad, loadText, versions, wasBusy } from './machine.mjs';
import { percent, quoted, ratio, significant, time } from './format.mjs';
import { olderReport } from './older.mjs';
import { busyText, moduleText, page, runText } from './page.mjs';
import { changes, exponent, merged, withoutContradictions } from './statistics.mjs';

const timed = (figure, subject, variant, value, more = {}) => ({
	figure, subject, variant, value, unit: 'ms', low: value * 0.98, high: value * 1.04, samples: 5,
	multiple: value * 4000, multipleLow: value * 3900, multipleHigh: value * 4100, ...more,
});

const EMPTY = { created: '2026-01-02T03:04:05Z', machine: {}, versions: {}, exponents: [] };

const entries = [
	timed('fits', 'bear', 'engine', 6.8, { thesis: 555, vertices: 547, tightest: 'box' }),
	timed('fits', 'bear', 'literal', 243),
	timed('tests', 'sphereSphere', 'engine', 0.00024, { thesis: 0.000319 }),
	timed('tests', 'sphereSphere', 'engine, all hit', 0.00024),
	timed('tests', 'boxBox', 'engine', 0.0019, { thesis: 0.11717 }),
	timed('tests', 'boxBox', 'engine, all hit', 0.0021),
	timed('tests', 'boxBox', 'literal', 0.065),
	timed('crowds', '100 bears', 'TightestFitCollider', 17.5, { thesis: 1300, agents: 100, collisions: 4950, agrees: true }),
	timed('crowds', '100 bears', 'TightestFitCollider, literal', 432),
	{ figure: 'visits', subject: '100 bears', variant: 'HierarchicalCollider', value: 24750, unit: 'pairs of nodes', agents: 100, tests: 4950 },
	timed('crowds', '100 bears', 'BinCollider', null, { agents: 100, collisions: 4950, agrees: false, refused: '±79 %, noisy' }),
	...[100, 1000, 10000].map((agents) => timed('scattered', `${agents} mix`, 'BinCollider', agents * 0.002, { agents, collisions: 0, agrees: true })),
];

test('numbers read well', () => {
	assert.equal(significant(0.0123456, 3), '0.012');
	assert.equal(significant(123.456, 3), '123');
	assert.equal(significant(0, 3), '0');
	assert.equal(time(0.00024), '240 ns');
	assert.equal(time(0.0019), '1.90 µs');
	assert.equal(time(0.9999), '1.00 ms');
	assert.equal(time(1300), '1300 ms');
	assert.equal(time(12345), '12.3 s');
	assert.equal(ratio(2.345), '2.3×');
	assert.equal(ratio(258096), '258,000×');
	assert.equal(percent(0.042), '4 %');
	assert.equal(quoted(1061), '1061 ms');
	assert.equal(quoted(0.11717), '117.17 µs');
});

test('the chart of volumes has bars of the thesis', () => {
	const structures = ['naive sphere', 'Ritter sphere', 'axis-aligned box', 'z-aligned box', 'oriented box', 'oriented capsule', 'minimal sphere', 'minimal capsule', 'hull'];
	const volumes = structures.map((variant, i) => ({ figure: 'volumes', subject: 'bear', variant, value: 9 - i, thesis: i < 6 ? 10 - i : undefined, vertices: 547 }));
	const series = chartsOf(volumes).volumes.series;
	assert.deepEqual(series.find(({ color }) => color === 'thesis').values, [5]);
	assert.deepEqual(series.find(({ color }) => color === 'engine').values, [4]);
});

test('the chart of hierarchies shows both of the engine\'s', () => {
	const found = [timed('hierarchies', 'bear', 'engine', 42, { thesis: 3.722, vertices: 547 }), timed('hierarchies', 'bear', 'engine, vertices', 15), timed('hierarchies', 'bear', 'literal', 25)];
	assert.deepEqual(chartsOf(found).hierarchies.series.map(({ values }) => values[0]), [42, 15, 25, 3.722]);
});

test('the chart of the combination has literal times beside the engine\'s', () => {
	const found = [0, 10].flatMap((count) => [timed('combination', '100 bears', `${count} hierarchical`, 20 + count), timed('combination', '100 bears', `${count} hierarchical, literal`, 600)]);
	const { labels, series } = chartsOf(found).combination;
	assert.deepEqual(labels, ['0 hierarchical', '10 hierarchical']);
	assert.deepEqual(series.map(({ values }) => values), [[20, 30], [600, 600]]);
});

test('a line with no exponent has a name without one', () => {
	const series = chartsOf([timed('scattered', '100 mix', 'BinCollider', 1, { agents: 100, collisions: 0, agrees: true })]).scattered.series;
	assert.deepEqual(series.map(({ name }) => name), ['Bin']);
});

test('the exponent of a power is found', () => {
	assert.ok(Math.abs(exponent([[1, 3], [10, 3 * 10 ** 1.2], [100, 3 * 100 ** 1.2]]) - 1.2) < 1e-9);
	assert.equal(exponent([[5, 3], [50, 30], [5, 4]]), undefined);
	assert.ok(Math.abs(growth(entries.filter((entry) => entry.figure === 'scattered'))[0].exponents.BinCollider - 1) < 1e-9);
});

test('tables are at most 112 columns wide and say what is not reported', () => {
	const text = tables(entries);
	for (const line of text.split('\n')) {
		assert.ok(line.length <= 112, line);
	}
	assert.match(text, /bear +547 +box +6\.80 ms ±3 % +27,200× ±3 % +243 ms +36× +555 ms/);
	assert.match(text, /±79 %, noisy/);
	assert.match(text, /^25 frames a second: .*\n\ngame .*\n─+\nbears +DIFFER +/m);
	assert.match(text, /DIFFER$/m);
});

test('a collider whose collisions are not those of all pairs is named', () => {
	const game = (subject, variant, agrees) => timed('scattered', subject, variant, 1, { agents: 100, collisions: 5, agrees });
	const games = ['100 mix', '100 mix, as dense'].flatMap((subject) => [game(subject, 'BinCollider', true), game(subject, 'game.WrongCollider', false)]);
	const text = tables(games);
	assert.match(text, /^100 mix, as dense .* 5 +DIFFER: WrongCollider$/m);
	assert.match(text, /^mix +at least 100 +DIFFER$/m);
	assert.equal(differing(games), 'game.WrongCollider, in 100 mix and 100 mix, as dense');
	assert.equal(differing(games.filter(({ agrees }) => agrees)), '');
});

test('collisions that are wrong in any player fail the report, which names the player', (t) => {
	const folder = mkdtempSync(path.join(tmpdir(), 'report-test-'));
	t.after(() => rmSync(folder, { recursive: true }));
	const reported = (wrong) => {
		for (const [player, where] of [['Ruffle', '.'], ['a shell', 'beside'], ['Node', 'module']]) {
			const found = [timed('crowds', '100 bears', 'BinCollider', 1, { agents: 100, collisions: 5, agrees: player !== wrong })];
			mkdirSync(path.join(folder, where), { recursive: true });
			writeFileSync(path.join(folder, where, 'results.json'), JSON.stringify({ player, isComplete: true, entries: found }));
		}
		return spawnSync(process.execPath, [fileURLToPath(new URL('report.mjs', import.meta.url)), folder, `--beside=${folder}/beside`, `--module=${folder}/module`],
			{ encoding: 'utf8' });
	};
	assert.equal(reported('none').status, 0);
	for (const player of ['Ruffle', 'a shell', 'Node']) {
		const { status, stdout } = reported(player);
		assert.equal(status, 1);
		assert.match(stdout, new RegExp(`^FAILED timing: in ${player} collisions were not those of all pairs: BinCollider, in 100 bears$`, 'm'));
	}
});

test('a range that is much longer on one side has both ends', () => {
	const text = tables([timed('tests', 'boxBox', 'engine', 0.00473, { low: 0.00453, high: 0.00723 }), timed('tests', 'boxBox', 'engine, all hit', null, { multiple: null, refused: 'noisy' })]);
	assert.match(text, /^boxBox +4\.73 µs −4 \+53 % .* noisy$/m);
});

test('a multiple is refused by its own range, and that of the base is 1', () => {
	const found = [
		timed('tests', 'sphereSphere', 'engine', 0.00024, { multiple: 1, multipleLow: 1, multipleHigh: 1 }),
		timed('tests', 'boxBox', 'engine', 0.0019, { multiple: 8, multipleLow: 7, multipleHigh: 9 }),
		timed('tests', 'hullHull', 'engine', 0.005, { multiple: null, multipleLow: 10, multipleHigh: 30 }),
	];
	const text = tables(found);
	assert.match(text, /^sphereSphere +240 ns ±3 % +1\.0×$/m);
	assert.match(text, /^boxBox +1\.90 µs ±3 % +8\.0× ±13 %$/m);
	assert.match(text, /^hullHull +5\.00 µs\? ±3 % +noisy$/m);
	assert.match(repeats(found), /tests \/ hullHull \/ engine \(its multiple alone\)\nTo/);
});

test('the games that keep 25 frames a second are named by their colliders', async () => {
	const game = (agents, variant, value) => timed('scattered', `${agents} mix`, variant, value, { agents, collisions: 0, agrees: true });
	const games = [game(100, 'BinCollider', 1), game(1000, 'BinCollider', 9), game(100, 'TightestFitCollider', 4), game(1000, 'TightestFitCollider', 41),
		game(100, 'HierarchicalCollider', 50), game(1000, 'HierarchicalCollider', null)];
	assert.deepEqual(agentsAt25Frames(games), [['mix', 'at least 1000', '100, not 1000', 'fewer than 100', '']]);
	const uncertain = { ...game(300, 'TightestFitCollider', 41), low: 39 };
	assert.deepEqual(agentsAt25Frames([...games, uncertain]), agentsAt25Frames(games));
	assert.deepEqual(agentsAt25Frames([{ ...game(10, 'BinCollider', 39), high: 41 }]), [['mix', 'noisy', '', '', '']]);
	const text = tables(games);
	assert.match(text, /^25 frames a second: .*40 ms\n\ngame +Bin +TightestFit +Hierarchical\n─+\nmix +at least 1000 +100, not 1000 +fewer than 100\n/m);
	assert.match(tables(games, { wasDisturbed: true }), /40 ms \(something else was running: it may be more\)\n/);
	assert.match(await page({ ...EMPTY, machine: { cores: 2 }, load: { start: 2, end: 2 }, entries: games }), /<h3>25 .*40 ms \(something else was running: it may be more\)<\/h3>/);
	assert.match(await page({ ...EMPTY, entries: games }), /<h3>25 frames a second: .*40 ms<\/h3>\n.*<table>.*>game<.*>Bin</);
});

test('a collider of which no game has a time holds nobody knows how many', () => {
	const game = (agents, variant, value) => timed('crowds', `${agents} mix`, variant, value, { agents });
	const games = [game(100, 'BinCollider', 1), game(1000, 'BinCollider', null), game(100, 'TightestFitCollider', null), game(1000, 'TightestFitCollider', 41),
		game(100, 'game.Discs', null)];
	assert.deepEqual(agentsAt25Frames(games), [['mix', 'at least 100', 'fewer than 1000', '', '', 'noisy']]);
});

test('a number that was refused has a mark in its chart', async () => {
	const { crowds } = chartsOf([...entries, timed('crowds', '100 bears', 'CombinationCollider', 20, { agents: 100 })]);
	assert.deepEqual(crowds.series.map(({ name, values, refused }) => [name, values, refused]), [
		['this engine', [null, 17.5, 20], [true, false, false]],
		['literal algorithm', [null, 432, null], [false, false, false]],
		['thesis, 2015', [null, 1300, null], undefined],
	]);
	const lines = chartsOf([...entries, { ...timed('scattered', '300 mix', 'BinCollider', 1, { agents: 300 }), value: null }]).scattered;
	assert.deepEqual(lines.series[0].refused, [300]);
	const html = await page({ ...EMPTY, entries });
	assert.equal(html.split('× stands for a number that was left out').length, 2);
});

test('times and multiples that contradict others are refused', () => {
	const row = (value, multiple, variant, subject = 'capsuleCapsule', figure = 'tests') => timed(figure, subject, variant, value,
		{ multiple, multipleLow: multiple * 0.95, multipleHigh: multiple * 1.05 });
	const others = ['a', 'b', 'c', 'd', 'e'].map((name, i) => row(0.00055 * (i + 1), i + 1, 'engine', name));
	const refused = (...found) => withoutContradictions([...others, ...found]).filter((entry) => entry.refused).map(({ subject, variant, value, multiple }) => {
		assert.deepEqual([value, multiple], [null, null]);
		return `${subject} ${variant}`;
	});
	assert.deepEqual(refused(row(0.0121, 22, 'engine'), row(0.0239, 43, 'literal')), []);
	// the literal algorithm's turn was in a busy moment, so its sphere-sphere test took three times as long as usual
	assert.deepEqual(refused(row(0.0121, 22, 'engine'), row(0.0239, 13, 'literal')), ['capsuleCapsule literal']);
	// 393 ns and 1.36 µs are 3.5 times as long, and not 2.8
	assert.deepEqual(refused(row(0.00136, 0.00136 / 0.00055 / 1.14, 'engine', 'sphereBox')), []);
	assert.deepEqual(refused(row(0.00136, 0.00136 / 0.00055 / 1.24, 'engine', 'sphereBox')), ['sphereBox engine']);
	// each is not unusual, but 2.6 times as long by the times and 2.1 times by the multiples
	assert.deepEqual(refused(row(0.0108, 22, 'engine, all hit'), row(0.0276, 46, 'literal, all hit')), ['capsuleCapsule engine, all hit', 'capsuleCapsule literal, all hit']);
	assert.deepEqual(refused(row(0.0108, 22, 'BinCollider', '10 mix', 'crowds'), row(0.0276, 46, 'BinCollider, literal', '10 mix', 'crowds')),
		['10 mix BinCollider', '10 mix BinCollider, literal']);
	assert.deepEqual(refused(row(0.0108, 22, 'engine, vertices', 'bear', 'hierarchies'), row(0.0276, 46, 'literal', 'bear', 'hierarchies')),
		['bear engine, vertices', 'bear literal']);
});

test('a busy run is compared with none, and says so under its title', async () => {
	const report = (start, end) => ({ load: { start, end }, machine: { cores: 2 } });
	assert.deepEqual([wasBusy(report(0.3, 1.4)), wasBusy(report(2.4, 1)), wasBusy(report(1, 9)), wasBusy({ machine: { cores: 2 } })], [false, true, true, false]);
	const at = (load) => page({ created: '2026-01-02T03:04:05Z', machine: { cores: 2 }, load, versions: {}, exponents: [], entries });
	assert.match(await at({ start: 0.2, end: 12 }), /<p class="warning">Load of the machine: 0\.2 before the run, 12 after it/);
	assert.doesNotMatch(await at({ start: 0.2, end: 1.1 }), /class="warning"/);
	assert.match(await at({ start: 0.2, end: 12 }), /To cite this report: [^<]*, while other programs ran\./);
	const busy = entries.map((entry, i) => (i < 3 ? { ...entry, busy: true } : entry));
	assert.equal(busyText({ entries: busy }), ` This is so of 3 of the ${entries.length} entries.`);
	assert.equal(busyText({ entries }), '');
});

test('what -Dcompare names must be a report, and the run does not begin without', (t) => {
	const folder = mkdtempSync(path.join(tmpdir(), 'report-test-'));
	t.after(() => rmSync(folder, { recursive: true }));
	const text = path.join(folder, 'text.json');
	writeFileSync(text, '{"entries": []');
	assert.throws(() => olderReport(text), /^Error: -Dcompare: .*text\.json is no report\.json of \.\/antw timing$/);
	const begin = (...more) => spawnSync(process.execPath, [fileURLToPath(new URL('load.mjs', import.meta.url)), folder, ...more], { encoding: 'utf8' });
	assert.deepEqual([begin('nothing.json').status, begin('nothing.json').stderr], [64, '-Dcompare: there is no file nothing.json\n']);
	assert.equal(begin('').status, 0);
	writeFileSync(text, JSON.stringify({ ...EMPTY, entries, machine: { cores: 2 }, load: { start: 1, end: 9 } }));
	assert.match(begin(text).stdout, /\nNothing will be compared with .*text\.json: in its run more programs ran than the machine has cores\.\n$/);
});

test('a busy machine is told', () => {
	assert.match(loadText({ start: 0.2, end: 9 }, 2), /Something else was running/);
	assert.equal(loadText({ start: 0.2, end: 1.1 }, 2), 'Load of the machine: 0.2 before the run, 1.1 after it, on 2 cores.');
	assert.match(loadText({ start: 9.7, end: 11 }, 2), /on 2 cores\. Something else was running/);
});

test('what another player took stands beside, and nowhere else', async () => {
	const others = [timed('fits', 'bear', 'engine', 0.31), timed('tests', 'boxBox', 'engine', null), timed('scattered', '1000 mix', 'BinCollider', 0.25),
		timed('crowds', '100 bears', 'TightestFitCollider', 0.15), timed('fits', 'sphere', 'engine', 1)];
	const both = addBeside(entries, others);
	assert.equal(both.length, entries.length);
	assert.equal(both.find((entry) => entry.subject === 'boxBox' && entry.variant === 'engine').beside, null);
	const text = tables(both);
	for (const line of text.split('\n')) {
		assert.ok(line.length <= 112, line);
	}
	assert.match(text, /bear +547 +box +6\.80 ms ±3 % +27,200× ±3 % +310 µs +243 ms/);
	assert.match(text, /boxBox .* noisy /);
	assert.match(text, /^1000 mix .*\n  JIT +250 µs$/m);
	assert.doesNotMatch(tables(entries), /JIT/);
	assert.match(csv(both), /,0\.31,/);
	const html = await page({ created: '2026-01-02T03:04:05Z', machine: {}, versions: { player: 'one', beside: 'an<other' }, exponents: [], entries: both });
	assert.match(html, /taken in one, but.*an&lt;other/);
	assert.match(html, /this engine, JIT/);
});

test('the report says how many times as fast the ES module is', async () => {
	const others = [timed('fits', 'bear', 'engine', 0.68), timed('fits', 'bear', 'literal', 1), timed('tests', 'boxBox', 'engine', null),
		timed('crowds', '100 bears', 'TightestFitCollider', 0.5), timed('crowds', '100 bears', 'TightestFitCollider, literal', 1)];
	const faster = timesAsFast(entries, others);
	assert.deepEqual({ ...faster, low: faster.low.toFixed(3) }, { count: 2, low: '10.000', median: 35, high: 35 });
	assert.match(moduleText({ player: 'Node', count: 3, low: 0.96, median: 4, high: 123 }), / 4\.0 times .* from 1\.0 to 123\./);
	assert.equal(timesAsFast(entries, []), undefined);
	assert.match(moduleText({ player: 'Node 20', ...faster }), /^In Node 20 the engine was 35 times as fast: .* 2 times, .* from 10 to 35\.$/);
	const html = await page({ created: '2026-01-02T03:04:05Z', machine: {}, versions: { player: 'one' }, module: { player: 'No<de', ...faster }, exponents: [], entries });
	assert.match(html, /In No&lt;de the engine was 35 times/);
});

test('a comparison names what changed beyond the noise, and nothing else', () => {
	const slower = entries.map((entry) => (entry.subject === 'bear' && entry.variant === 'engine'
		? timed('fits', 'bear', 'engine', entry.value * 1.5) : entry));
	assert.deepEqual(changes(entries, entries), []);
	const changed = changes(entries, slower);
	assert.equal(changed.length, 1);
	assert.equal(changed[0].key, 'fits / bear / engine');
	assert.ok(Math.abs(changed[0].change - 1.5) < 1e-9);
	assert.match(comparison(changed, 'yesterday'), /fits \/ bear \/ engine .* 1\.5× as long/);
	assert.match(comparison(changes(slower, entries), 'yesterday'), /1\.5× as fast/);
	assert.match(comparison([], 'yesterday'), /nothing is faster or slower/);
});

test('a change within the drift between runs, or within the ranges, is noise', () => {
	const scaled = (factor, width) => entries.map((entry) => ({ ...entry, multiple: entry.multiple * factor,
		multipleLow: entry.multiple * factor * (1 - width), multipleHigh: entry.multiple * factor * (1 + width) }));
	assert.deepEqual(changes(scaled(1, 0.001), scaled(1.15, 0.001)), []);
	assert.deepEqual(changes(scaled(1, 0.2), scaled(1.5, 0.2)), []);
	assert.notDeepEqual(changes(scaled(1, 0.05), scaled(1.5, 0.05)), []);
});

test('a change whose time and multiple went opposite ways is noise', () => {
	const [bear] = entries;
	const changed = (value, factor) => changes([bear], [{ ...bear, value, multiple: bear.multiple * factor, multipleLow: bear.multipleLow * factor, multipleHigh: bear.multipleHigh * factor }]);
	assert.equal(changed(bear.value * 0.7, 0.5).length, 1);
	assert.deepEqual(changed(bear.value * 1.3, 0.5), []);
});

test('CSV has a line for each entry and quotes what has commas', () => {
	const lines = csv(entries).split('\r\n');
	assert.equal(lines.length, entries.length + 2);
	assert.match(lines[0], /^figure,subject,variant,value,unit,/);
	assert.ok(lines.some((line) => line.includes('"TightestFitCollider, literal"')));
});

test('the page is self-contained and has every figure there are entries of', async () => {
	const html = await page({ created: '2026-01-02T03:04:05Z', machine: { processor: '<fast>' }, versions: {}, exponents: [], entries });
	assert.doesNotMatch(html, /<(link|img|iframe)\b|<script[^>]+src=|@import/);
	for (const figure of FIGURES) {
		assert.equal(html.includes(figure.title), shownIn(figure, entries).length > 0, figure.id);
	}
	assert.match(html, /&lt;fast&gt;/);
	assert.match(html, /<dt>as fast as the thesis's box-box test in the same run<\/dt><dd>34× <small>±6 %<\/small><\/dd>/);
	assert.match(html, /<dt>a frame of 100 colliding bears,[^<]*<\/dt><dd>17\.5 ms <small>±3 %<\/small><\/dd>/);
});

const STRUCTURES = ['naive sphere', 'Ritter sphere', 'axis-aligned box', 'z-aligned box', 'oriented box', 'oriented capsule', 'minimal sphere', 'minimal capsule', 'hull'];

test('the precision of a shape is in percent', () => {
	const entry = (variant, value) => ({ figure: 'precision', subject: 'hull', variant, value, unit: variant === 'found' ? 'pairs' : '%' });
	const row = tables([entry('found', 27628), entry('precision', 73.46), entry('recall', 100)]).split('\n').find((line) => line.startsWith('hull'));
	assert.match(row, /^hull +27628 +73 % +100 %$/);
});

test('one table has a row for each collider: how often it is right, how long a frame takes, and when to take it', async () => {
	const shares = [['BinCollider', 55, 96], ['TightestFitCollider', 53, 100], ['game.Discs', 40, 90]].flatMap(([subject, precision, recall]) =>
		[['precision', precision], ['recall', recall]].map(([variant, value]) => ({ figure: 'colliders', subject, variant, value, unit: '%' })));
	const text = tables([...entries, ...shares]);
	assert.match(text, /^collider +take it +precision +recall +100 bears +1000 mix\n +together +scattered$/m);
	assert.match(text, /^Bin +for many roundish agents +55 % +96 % +noisy +2\.00 ms ±3 %$/m);
	assert.match(text, /^TightestFit +in most games +53 % +100 % +17\.5 ms ±3 %$/m);
	const jit = [...entries, ...shares].map((entry) => (['crowds', 'scattered'].includes(entry.figure) ? { ...entry, beside: 0.123 } : entry));
	assert.ok(tables(jit).split('\n').every((line) => line.length <= 112));
	assert.match(text, /^game\.Discs +\(your own\) +40 % +90 %$/m);
	assert.doesNotMatch(text, /^Hierarchical/m);
	assert.match(await page({ ...EMPTY, entries: shares }, '..'), /Which collider to take[^]*<a href="\.\.\/docs\/choosing\.md">/);
	assert.match(tables(entries), /^collider +take it +100 bears +1000 mix$/m);
	// another number of the same agents comes before other agents, and a game that was not measured is not spoken of
	const crowds = tables(['10 bears', '20 bears', '20 dragons'].map((subject) => timed('crowds', subject, 'BinCollider', 1, { agents: 20, collisions: 5, agrees: true })));
	assert.match(crowds, /^Which collider to take\n\ncollider +take it +20 bears\n/);
	assert.match(crowds, /^Together: a frame of the crowd below/m);
	assert.doesNotMatch(crowds, /scattered|how often/i);
	// a note says nothing of columns and rows that are not there
	assert.match(text, /^Precision: the share/m);
	assert.doesNotMatch(tables(entries), /Precision: the share/);
	assert.match(text, /Exponent e:/);
	assert.doesNotMatch(tables(entries.filter(({ agents }) => agents !== 10000)), /Exponent e:/);
});

test('a run that was cut does not say how many agents are too many', async () => {
	assert.match(tables(entries), /25 frames a second/);
	assert.doesNotMatch(tables(entries, { isComplete: false }), /25 frames a second/);
	assert.doesNotMatch(await page({ ...EMPTY, entries, isComplete: false }), /25 frames a second: the most/);
});

test('the chart of a crowd has its colliders side by side', () => {
	const crowds = ['BinCollider', 'TightestFitCollider'].flatMap((name) => ['bears', 'mix'].map((cast) => timed('crowds', `100 ${cast}`, name, 1, { agents: 100 })));
	assert.deepEqual(chartsOf(crowds).crowds.labels, [['Bin', 'bears'], ['Tightest', 'bears'], ['Bin', 'mix'], ['Tightest', 'mix']]);
});

test('the volumes stand under the heads of their structures', () => {
	const volumes = STRUCTURES.map((variant, i) => ({ figure: 'volumes', subject: 'bear', variant, value: 10 + i, vertices: 547 }));
	const [, , first, second, , row] = tables(volumes).split('\n');
	assert.deepEqual([first.trim().split(/ {2,}/).at(-1), second.trim().split(/ {2,}/).at(-1)], ['hull', '16']);
	assert.match(row, / 18\.0$/);
});

test("a researcher's own fitters and colliders stand beside the engine's", async () => {
	const own = [...entries,
		...STRUCTURES.map((variant, i) => ({ figure: 'volumes', subject: 'bear', variant, value: 10 + i, vertices: 547, ...(i < 6 && { thesis: 2 }) })),
		{ figure: 'volumes', subject: 'bear', variant: 'game.UprightFitter', value: 9.5, vertices: 547 },
		timed('fits', 'bear', 'game.UprightFitter', 0.3),
		timed('crowds', '100 bears', 'game.Discs', 3.25, { agents: 100, collisions: 4950, agrees: true }),
		...[100, 1000, 10000].map((agents) => timed('scattered', `${agents} mix`, 'game.Discs', agents * 0.01, { agents, collisions: 0, agrees: true }))];
	const text = tables(own);
	assert.match(text, /^model .* UprightFitter$/m);
	assert.match(text, /^bear \(547\) .* 9\.50$/m);
	assert.match(text, /^ {2}game\.UprightFitter +300 µs/m);
	assert.match(text, /^ +game\.Discs +3\.25 ms/m);
	assert.match(text, /^exponent +1\.00 +1\.00$/m);
	const html = await page({ created: '2026-01-02T03:04:05Z', machine: {}, versions: {}, exponents: [], entries: own });
	assert.match(html, /<th scope="col">UprightFitter own<\/th>/);
	assert.match(html, /"Discs: n\^1\.00"|game\.Discs: n\^1\.00/);
});

test('a collider of the reader\'s own that is called as one of the engine\'s has its package in the heads', () => {
	const found = ['BinCollider', 'game.BinCollider', 'game.DiscCollider'].map((name) => timed('scattered', '100 mix', name, 1, { agents: 100, collisions: 0, agrees: true }));
	assert.match(tables(found), /^game +Bin +.*game\.Bin +Disc /m);
});

test('a later run takes the places of its entries alone', () => {
	const later = [timed('fits', 'bear', 'engine', 5), timed('fits', 'cube', 'engine', 1)];
	const both = merged(entries, later);
	assert.equal(both.length, entries.length + 1);
	assert.equal(both[0].value, 5);
	assert.equal(both[1], entries[1]);
	assert.equal(both.at(-1).subject, 'cube');
});

test('a number that is left out does not take the place of one that is not', () => {
	const [accepted] = entries;
	const refused = { ...accepted, value: null, multiple: null, refused: '±79 %, noisy' };
	const half = { ...accepted, multiple: null };
	assert.deepEqual(merged([accepted], [refused]), [accepted]);
	assert.deepEqual(merged([accepted], [half]), [accepted]);
	assert.deepEqual(merged([half], [refused]), [half]);
	assert.deepEqual(merged([refused], [half]), [half]);
	assert.deepEqual(merged([refused], [accepted]), [accepted]);
	// collisions that are wrong now are told, whatever the time
	const wrong = { ...refused, agrees: false };
	assert.deepEqual(merged([{ ...accepted, agrees: true }], [wrong]), [wrong]);
});

test('a worse number does not take the place of a better one', () => {
	const [accepted] = entries;
	const wide = { ...accepted, low: accepted.value * 0.9, samples: 11 };
	const narrow = { ...accepted, low: accepted.value * 0.97, value: accepted.value * 1.01 };
	assert.deepEqual(merged([accepted], [wide]), [accepted]);
	assert.deepEqual(merged([wide], [accepted]), [accepted]);
	assert.deepEqual(merged([accepted], [narrow]), [narrow]);
	const busy = { ...narrow, busy: true };
	assert.deepEqual(merged([accepted], [busy]), [accepted]);
	assert.deepEqual(merged([busy], [wide]), [wide]);
	const once = { ...narrow, samples: 1 };
	assert.deepEqual(merged([{ ...busy, samples: 5 }], [once]), [{ ...busy, samples: 5 }]);
});

test('a report of several runs does not contradict itself', () => {
	const row = (subject, variant, value, multiple) => timed('tests', subject, variant, value, { multiple, multipleLow: multiple * 0.98, multipleHigh: multiple * 1.02 });
	const others = ['a', 'b', 'c', 'd', 'e'].map((name, i) => row(name, 'engine', 0.0004 * (i + 1), i + 1));
	const engine = row('capsuleCapsule', 'engine', 0.00268, 7.16);
	const literal = row('capsuleCapsule', 'literal', 0.0048, 12);
	const later = row('capsuleCapsule', 'literal', 0.0056, 6.22);
	// the later number has as narrow a range, and was taken while the machine was slower
	assert.deepEqual(merged([...others, engine, literal], [later]), [...others, engine, literal]);
	const refusedBefore = { ...literal, value: null, multiple: null, refused: 'noisy' };
	const found = merged([...others, engine, refusedBefore], [later]).filter(({ refused }) => refused);
	assert.deepEqual(found.map(({ variant, refused }) => [variant, refused]), [['literal', 'contradictory']]);
	const wrong = { ...later, agrees: false };
	assert.equal(merged([...others, engine, literal], [wrong]).at(-1).agrees, false);
});

test('of the BinCollider\'s crowds of one size those that took longer than the fastest are left out', () => {
	const crowd = (subject, agents, value, variant = 'BinCollider') => timed('crowds', subject, variant, value, { agents });
	const found = withoutContradictions([crowd('100 spheres', 100, 214), crowd('100 bears', 100, 93), crowd('100 mix', 100, 99), crowd('10 bears', 10, 1.07),
		crowd('100 spheres', 100, 214, 'TightestFitCollider'), crowd('100 bears', 100, 93, 'TightestFitCollider')]);
	assert.deepEqual(found.filter(({ refused }) => refused).map(({ subject, variant }) => `${subject} ${variant}`), ['100 spheres BinCollider']);
});

test('a time whose multiple is left out is marked, and nothing is computed from it', async () => {
	const pair = [timed('tests', 'boxBox', 'engine', 0.0019, { multiple: null }), timed('tests', 'boxBox', 'literal', 0.065)];
	assert.match(tables(pair), /^boxBox +1\.90 µs\? ±3 % +noisy +65\.0 µs +260× ±3 %$/m);
	assert.doesNotMatch(await page({ ...EMPTY, entries: pair }), /box-box test in the same run/);
	assert.deepEqual(chartsOf([timed('fits', 'bear', 'engine', 6, { multiple: null }), timed('fits', 'bear', 'literal', 240)]).fits.series.map(({ values, refused }) => [values, refused]),
		[[[null], [true]], [[240], [false]]]);
	const game = timed('scattered', '100 mix', 'BinCollider', 1, { agents: 100, multiple: null });
	assert.deepEqual(agentsAt25Frames([game]), [['mix', 'noisy', '', '', '']]);
});

test('the report has the settings of its runs, and says how it and the thesis are cited', async () => {
	const run = (more) => ({ created: '2026-01-02T03:04:05Z', load: { start: 0.2, end: 1 },
		settings: { full: false, repetitions: 5, longRepetitions: 3, crowds: [10, 100], games: [], refused: false, options: {}, ...more } });
	assert.equal(runText(run()), 'Run of 2026-01-02 03:04 UTC: a quick run; 5 repetitions, 3 of what takes long; crowds of 10, 100 agents; without options. Load 0.2 to 1.');
	assert.match(runText(run({ refused: true, longRepetitions: 5, options: { repetitions: '5', figures: 'tests' } })),
		/: what the report had left out, again; 5 repetitions; options -Dfigures=tests -Drepetitions=5\./);
	const html = await page({ ...EMPTY, runs: [run(), run({ full: true })], versions: { engine: '9.8.7', commit: 'abc', player: 'Ruffle' }, machine: { processor: 'a <fast>' }, entries });
	assert.match(html, /<p>Run of [^<]*: a quick run[^]*<p>Run of [^<]*: a full run/);
	assert.match(html, /Divya Bajekal, “Improved[^<]*Massachusetts Institute of Technology[^<]*2015\. To cite this report: [^<]* 9\.8\.7 \(commit abc\), 2026-01-02, in Ruffle on a &lt;fast&gt;\./);
});

test('-Drefused measures what a report of the same commit has left out', (t) => {
	const folder = mkdtempSync(path.join(tmpdir(), 'report-test-'));
	t.after(() => rmSync(folder, { recursive: true }));
	const asked = (...figures) => spawnSync(process.execPath, [fileURLToPath(new URL('refused.mjs', import.meta.url)), folder, ...figures], { encoding: 'utf8' });
	assert.match(asked().stderr, /^-Drefused: there is no report .*report\.json yet/);
	const write = (commit, found) => writeFileSync(path.join(folder, 'report.json'), JSON.stringify({ ...EMPTY, versions: { commit }, entries: found }));
	write('another', entries);
	assert.match(asked().stderr, /^-Drefused: the report .* is of commit another, and this clone is at /);
	const { commit } = versions('');
	const question = timed('experiments', '§7.4 factor 3', 'with', 1, { multiple: null });
	write(commit, [...entries, question]);
	assert.deepEqual(asked().stdout.trim().split(';').map(decodeURIComponent), ['crowds / 100 bears / BinCollider', 'experiments / §7.4 factor 3 / with']);
	assert.deepEqual(asked('fits,crowds').stdout.trim().split(';').map(decodeURIComponent), ['crowds / 100 bears / BinCollider']);
	assert.deepEqual([asked('tests').status, asked('tests').stdout], [64, '']);
});

test('one sample has no range, is not compared, and does not take the place of more', () => {
	const once = timed('tests', 'boxBox', 'engine', 0.0019, { low: 0.0019, high: 0.0019, multiple: 8, multipleLow: 8, multipleHigh: 8, samples: 1 });
	assert.match(tables([once]), /^boxBox +1\.90 µs \(one sample\) +8\.0×$/m);
	const often = timed('tests', 'boxBox', 'engine', 0.01, { multiple: 40 });
	assert.deepEqual(merged([often], [once]), [often]);
	assert.deepEqual(merged([once], [often]), [often]);
	const later = { ...once, value: 0.002 };
	assert.deepEqual(merged([once], [later]), [later]);
	assert.deepEqual(changes([often], [once]), []);
});

test('a report that several runs have made says so, with the greatest load', async () => {
	assert.deepEqual(greatestLoad({ start: 0.2, end: 3 }, { start: 1, end: 2 }), { start: 1, end: 3 });
	assert.deepEqual(greatestLoad({ end: 1 }, { start: 0.5, end: 2 }), { start: 0.5, end: 2 });
	assert.deepEqual(greatestLoad(undefined, { start: 0.5, end: 2 }), { start: 0.5, end: 2 });
	const at = (earlierEntries) => page({ ...EMPTY, machine: { cores: 2 }, load: { start: 0, end: 1 }, entries, earlierEntries });
	assert.match(await at(4), new RegExp(`4 of the ${entries.length} entries are of earlier runs of the same commit on this machine; the load is the greatest of all runs\\.`));
	assert.doesNotMatch(await at(undefined), /earlier runs/);
});

test('what is noisy is named, with a command that repeats it', () => {
	assert.match(repeats(entries), /crowds \/ 100 bears \/ BinCollider\n.*\n {4}\.\/antw timing -Drefused -Drepetitions=11$/);
	assert.match(repeats([timed('fits', 'cube', 'game.UprightFitter', null, { refused: 'noisy' })]), /-Drefused -Dfitters=game\.UprightFitter -Dsources=FOLDER -Drep/);
	assert.match(repeats([timed('crowds', '10 bears', 'game.Discs', null, { refused: 'noisy' })]), /-Drefused -Dcolliders=game\.Discs -Dsources=FOLDER -Drep/);
	assert.match(repeats([timed('fits', 'cube', 'game.UprightFitter', null, { refused: 'noisy' })], '', '../my/src'), / -Dsources=\.\.\/my\/src /);
	assert.match(repeats([timed('fits', 'bear', 'literal', null, { refused: 'contradictory' })]), /^Left out, as too noisy or contradictory: 1 of 1 times\n/);
	const ofMultiple = repeats([timed('fits', 'bear', 'literal', null, { refused: 'noisy' }), timed('fits', 'bear', 'engine', 1, { multiple: null })]);
	assert.match(ofMultiple, /: 1 of 2 times; of 1 more the multiple alone\n.* literal\n.* engine \(its multiple alone\)\n/);
	assert.equal(repeats(entries.filter((entry) => !entry.refused)), '');
});

test('what is noisy can join a report only if the commit says what was measured', () => {
	assert.match(repeats(entries, 'abc'), /^To measure them alone again, for the same report:$/m);
	assert.match(repeats(entries, 'abc-dirty'), /^To measure them alone again, .* changes that are not committed.*report/m);
});

test('the page says at its top what is missing', async () => {
	assert.match(await page({ ...EMPTY, entries }), /<p id="left-out">Noisy: half of the range /);
	assert.match(await page({ ...EMPTY, entries }), /<a href="#left-out">Left out<\/a>, as too noisy or contradictory: 1 of 13 times\.[^]*<p id="left-out">[^]*<pre>Left out, [^]*\n {4}\.\/antw timing -Drefused /);
	assert.doesNotMatch(await page({ ...EMPTY, entries: entries.filter(({ refused }) => !refused) }), /href="#left-out"/);
	assert.match(await page({ ...EMPTY, isComplete: false, entries }), /class="warning">The run ended early/);
	assert.doesNotMatch(await page({ ...EMPTY, entries }), /ended early/);
	assert.match(await page({ ...EMPTY, versions: { player: 'Ruffle 1' }, entries }), /Ruffle interprets/);
});

test('without a number there is no chart, and no exponent', () => {
	const found = ['BinCollider', 'TightestFitCollider'].flatMap((name) => [100, 1000].map((agents) => timed('scattered', `${agents} mix`, name, null, { agents, collisions: 0, refused: 'noisy' })));
	assert.deepEqual(chartsOf([...found, timed('fits', 'bear', 'engine', null, { refused: 'noisy' })]), {});
	assert.doesNotMatch(tables(found), /^exponent|with collisions/m);
	// the thesis's number alone is none of the run
	assert.deepEqual(chartsOf([timed('fits', 'bear', 'engine', null, { refused: 'noisy', thesis: 555 })]), {});
});

test('an interrupted run says how far it was, if it had measured anything', (t) => {
	const folder = mkdtempSync(path.join(tmpdir(), 'report-test-'));
	t.after(() => rmSync(folder, { recursive: true }));
	const cut = () => spawnSync(process.execPath, [fileURLToPath(new URL('cut.mjs', import.meta.url)), folder], { encoding: 'utf8' }).stdout;
	assert.equal(cut(), '');
	writeFileSync(path.join(folder, 'results.json'), JSON.stringify({ entries }));
	writeFileSync(path.join(folder, 'load.txt'), '0.1');
	utimesSync(path.join(folder, 'load.txt'), 1, 1);
	assert.equal(cut(), `The timing run was interrupted after ${entries.length} entries, the last of them of scattered, 10000 mix.\n\`node test/timing/report.mjs ${folder}\` makes a report of them.\n`);
	utimesSync(path.join(folder, 'results.json'), 0, 0);
	assert.equal(cut(), '');
	writeFileSync(path.join(folder, 'results.json'), '{"entries": []}');
	assert.equal(cut(), 'The timing run was interrupted before its first entry.\n');
});
