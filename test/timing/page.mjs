import { readFile } from 'node:fs/promises';
import { chartsOf } from './charts.mjs';
import { countLeftOut, repeats } from './console.mjs';
import { FIGURES, MARK, MEDIANS, bySubject, castOf, faster, fasterWithRange, isSure, measured, noteOf, tablesOf } from './figures.mjs';
import { percent, ratio } from './format.mjs';
import { loadText, wasDisturbed } from './machine.mjs';
import { TOLERANCE } from './statistics.mjs';

const library = new URL('../../node_modules/chart.js/dist/chart.umd.min.js', import.meta.url);
const own = (name) => readFile(new URL(name, import.meta.url), 'utf8');

/**
 * The report as one self-contained page of HTML.
 *
 * @param {object} report what report.json has
 * @param {string} clone the way from the page's folder to the project's, for links to its docs
 */
export async function page(report, clone = '../..') {
	const [style, draw, chart] = await Promise.all([own('page.css'), own('page-charts.js'), readFile(library, 'utf8')]);
	const charts = chartsOf(report.entries);
	const date = report.created.slice(0, 16).replace('T', ' ');
	return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Collision engine: timing report</title>
<style>${style}</style>
</head>
<body>
<header>
<h1>Collision engine: timing report</h1>
<p>The evaluation of “Improved Collision Detection in StarLogo Nova” (section 6), run on <span class="whole">${date}</span> UTC.</p>
<ul class="colors">
<li><span style="background: var(--engine)"></span><b>this engine</b>, in this run</li>
<li><span style="background: var(--literal)"></span><b>literal</b>: the thesis's algorithms as it describes them, in this run and the same player</li>
<li><span style="background: var(--thesis)"></span><b>thesis, 2015</b>: its own numbers, from another machine and player</li>
</ul>
<p>${takenIn(report.versions)}${report.module ? ` ${escape(moduleText(report.module))}` : ''}</p>
${wasDisturbed(report) ? `<p class="warning">${escape(loadText(report.load, report.machine.cores) + busyText(report))}</p>` : ''}
${report.isComplete === false ? '<p class="warning">The run ended early. The report has what was measured before.</p>' : ''}
${leftOut(report.entries)}
<dl class="tiles">${tiles(report).map(([value, label]) => `<div><dt>${label}</dt><dd>${mark(value)}</dd></div>`).join('')}</dl>
</header>
<main>
${FIGURES.map((figure) => section(figure, report, charts, clone)).join('\n')}
</main>
<footer>
<p>Times are ${MEDIANS} “×” is a multiple of the sphere-sphere test, measured in turns
with it: only these can be compared across machines, and only if both were free.</p>
<p id="left-out">Noisy: half of the range of the time, or of the multiple, is more than 30 % of its median, so it is left out. Contradictory: a time and its multiple, or the engine's and the literal one's,
differ by more than ${percent(TOLERANCE)} from what the others say, because another program took the processor in a part of the run or in one of the runs. Both happen less on a machine that does nothing else.
${MARK}</p>
${again(report)}
${(report.runs ?? []).map((run) => `<p>${escape(runText(run))}</p>`).join('\n')}
<p>The thesis: ${THESIS} To cite this report: ${escape(citation(report))}</p>
<p>${report.load ? escape(loadText(report.load, report.machine.cores)) : ''}${report.earlierEntries ? ` ${earlierText(report)}` : ''}</p>
<p>${Object.entries({ ...report.machine, ...report.versions }).map(([name, value]) => `<span>${words(name)}: ${escape(value)}</span>`).join(' · ')}</p>
</footer>
<script>${chart.replaceAll('</script', '<\\/script')}</script>
<script>const charts = ${JSON.stringify(charts).replaceAll('<', '\\u003c')};
${draw}</script>
</body>
</html>
`;
}

const THESIS = 'Divya Bajekal, “Improved Collision Detection in StarLogo Nova”, thesis, Massachusetts Institute of Technology, Cambridge (Massachusetts), 2015.';

/** How a report is cited. */
export function citation(report) {
	const { created, machine, versions } = report;
	const others = wasDisturbed(report) ? ', while other programs ran' : '';
	return `“Collision engine: timing report”, starlogo-collision ${versions.engine} (commit ${versions.commit}), ${created.slice(0, 10)}, in ${versions.player} on ${machine.processor}${others}.`;
}

/** What a run measured, and how often, in words. */
export function runText({ created, settings, load }) {
	const what = settings.refused ? 'what the report had left out, again' : `a ${settings.full ? 'full' : 'quick'} run`;
	const has = (figure) => (settings.options.figures ?? figure).split(',').includes(figure);
	const games = [['crowds', settings.crowds], ['scattered games', settings.games]].filter(([name, counts]) => has(name.split(' ')[0]) && counts.length > 0)
		.map(([name, counts]) => `${name} of ${counts.join(', ')} agents`);
	const options = Object.entries(settings.options).sort().map(([name, value]) => `-D${name}=${value}`).join(' ');
	const often = `${settings.repetitions} repetitions${settings.longRepetitions === settings.repetitions ? '' : `, ${settings.longRepetitions} of what takes long`}`;
	return `Run of ${created.slice(0, 16).replace('T', ' ')} UTC: ${[what, often, ...games, options ? `options ${options}` : 'without options'].join('; ')}. Load ${
		load?.start ?? '?'} to ${load?.end ?? '?'}.`;
}

/** How many of a report's entries are not of its last run, in words. */
export function earlierText({ earlierEntries, entries }) {
	return `${earlierEntries} of the ${entries.length} entries are of earlier runs of the same commit on this machine; the load is the greatest of all runs.`;
}

/** How many entries were measured while the machine was busy, in words; an empty text if none or all were. */
export function busyText({ entries }) {
	const count = entries.filter(({ busy }) => busy).length;
	return count === 0 || count === entries.length ? '' : ` This is so of ${count} of the ${entries.length} entries.`;
}

/** How fast the ES module was, in words. */
export function moduleText({ player, count, low, median, high }) {
	const times = (ratio) => (ratio < 9.95 ? ratio.toFixed(1) : String(Math.round(ratio)));
	return `In ${player} the engine was ${times(median)} times as fast: the median of ${count} times, which range from ${times(low)} to ${times(high)}.`;
}

/** How many of the times are left out, if any is. */
function leftOut(entries) {
	const count = countLeftOut(entries);
	return count === '' ? '' : `<p><a href="#left-out">Left out</a>, as too noisy or contradictory: ${count}.</p>`;
}

/** What is left out, and the commands that measure it again. */
function again({ entries, versions, sources }) {
	const text = repeats(entries, versions.commit, sources);
	return text === '' ? '' : `<div class="scroll"><pre>${escape(text)}</pre></div>`;
}

/** Which numbers were taken in which player. */
function takenIn({ player, beside }) {
	const green = beside ? ` Green, and named JIT: this engine in ${escape(beside)}, the Flash client's virtual machine, in a second run on the same computer.` : '';
	const slow = player?.startsWith('Ruffle') ? ' Ruffle interprets. Flash Player, in which the thesis measured, compiles: compare blue with amber, not with grey.' : '';
	return `All times but the thesis's were taken in ${escape(player ?? 'an unknown player')}${beside ? ', but for one colour.' : '.'}${slow}${green}`;
}

function section(figure, report, charts, clone) {
	const [own, more] = tablesOf(figure, report.entries, { wasDisturbed: wasDisturbed(report), isComplete: report.isComplete });
	if (!own) return '';
	const chart = charts[figure.id];
	const picture = chart ? `<div class="scroll"><div class="chart" style="height:${chart.height}px;min-width:${44 * (chart.labels?.length ?? 13)}px">
<canvas id="${figure.id}" role="img" aria-label="${escape(figure.title)}"></canvas></div></div>` : '';
	const isMarked = chart?.series.some(({ refused }) => refused?.some(Boolean));
	return `<section>
<h2>${escape(figure.title)}</h2>
${chart ? `<p class="lead">${escape(figure.lead)} The scale is logarithmic.</p>` : ''}
${picture}
${isMarked ? '<p class="note crosses">× stands for a number that was left out.</p>' : ''}
<div class="scroll">${table(own)}</div>
${more ? `<h3>${escape(more.title)}</h3>\n<div class="scroll">${table(more)}</div>` : ''}
<p class="note">${escape(noteOf(figure, own).replace(/^\* /, 'Bold: '))}${figure.see ? ` More: <a href="${escape(`${clone}/${figure.see[0]}`)}">${escape(figure.see[1])}</a>.` : ''}</p>
</section>`;
}

function table({ head, rows, textColumns }) {
	const heads = head[0].map((_, column) => head.map((line) => line[column]).filter(Boolean).map(escape).join(' '));
	const type = (column) => (column < textColumns ? ' class="text"' : '');
	const cell = (text, column) => (column === 0 ? `<th scope="row">${escape(text.trim())}</th>` : `<td${type(column)}>${mark(text)}</td>`);
	return `<table><thead><tr>${heads.map((text, column) => `<th scope="col"${type(column)}>${text}</th>`).join('')}</tr></thead>
<tbody>${rows.map((row) => `<tr${rowClass(row)}>${row.map(cell).join('')}</tr>`).join('\n')}</tbody></table>`;
}

const rowClass = (row) => (['  thesis', '  JIT'].includes(row[0]) ? ' class="thesis"' : /^exponent|^  with/.test(row[0]) ? ' class="sum"' : '');

/** A cell's text: what is tightest stands out, a spread stands back. */
function mark(text) {
	return escape(text).replace(/^(.*)\*$/, '<strong>$1</strong>').replace(/ ([±−].*|\(one sample\))$/, ' <small>$1</small>');
}

/** What to know at a glance. */
function tiles({ entries, exponents }) {
	const of = (figure) => entries.filter((entry) => entry.figure === figure);
	const found = [];
	const tests = Object.fromEntries(bySubject(of('tests')));
	if (isSure(tests.sphereSphere?.engine)) {
		found.push([measured(tests.sphereSphere.engine), 'a sphere-sphere test']);
	}
	if (faster(tests.boxBox?.engine, tests.boxBox?.literal)) {
		found.push(compared(tests.boxBox, 'the thesis\'s box-box test in the same run'));
	}
	const models = bySubject(of('fits')).map(([, fit]) => fit);
	const fits = models.filter((fit) => faster(fit.engine, fit.literal)).sort((a, b) => faster(a.engine, a.literal) - faster(b.engine, b.literal));
	if (fits.length > 0) {
		const [least, most] = [fits[0], fits.at(-1)].map((fit) => ratio(faster(fit.engine, fit.literal)));
		const which = fits.length > 1 ? `median of ${fits.length} of ${models.length} models, from ${least} to ${most}` : 'of one model';
		found.push(compared(fits[fits.length >> 1], `the thesis's search for the tightest fit (${which})`));
	}
	const bears = Object.fromEntries(bySubject(of('crowds')))['100 bears'];
	if (isSure(bears?.TightestFitCollider)) {
		found.push([measured(bears.TightestFitCollider), 'a frame of 100 colliding bears, TightestFitCollider (thesis: 1300 ms)']);
	}
	const { cast, exponents: { TightestFitCollider: exponent } } = exponents.find((each) => each.cast.endsWith('as dense')) ?? { exponents: {} };
	if (exponent !== undefined) {
		const games = of('scattered').filter((entry) => entry.variant === 'TightestFitCollider' && castOf(entry) === cast && isSure(entry)).map(({ agents }) => agents);
		found.push([ratio(2 ** exponent), `as long for twice as many agents, scattered at the same density (fitted to ${games.length} games of ${
			Math.min(...games)} to ${Math.max(...games)} agents, TightestFitCollider)`]);
	}
	return found;
}

/** A tile for how many times as long as the engine the literal algorithm takes. */
function compared({ engine, literal }, other) {
	return faster(engine, literal) >= 1 ? [fasterWithRange(engine, literal), `as fast as ${other}`] : [fasterWithRange(literal, engine), `as long as ${other}`];
}

const words = (name) => name.replace(/GB$/, ' in GB');

function escape(text) {
	return String(text).replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
}
