#!/usr/bin/env node
/**
 * Makes the report of a timing run: prints its tables, and writes report.json, report.csv and report.html.
 *
 *   node test/timing/report.mjs folder [--compare=older-report.json] [--beside=folder] [--module=folder] [--sources=folder]
 *
 * The folder has the results.json of the run; docs/timing-report.md describes report.json. If the folder has a report of the same commit,
 * player and machine, this run's entries take their places in it. With an older report, what
 * became faster or slower since then is printed. With another folder, that of a run in another player, its times stand beside; with
 * that of a run of the ES module the report says how many times as fast that is. The sources are those of a researcher's own classes.
 */
import { existsSync, statSync } from 'node:fs';
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { refuse } from '../../build/refuse.mjs';
import { addBeside, timesAsFast } from './beside.mjs';
import { comparison, repeats, tables } from './console.mjs';
import { csv } from './csv.mjs';
import { differing, growth, MARK, MEDIANS } from './figures.mjs';
import { greatestLoad, isBusy, load, loadText, machine, versions, wasBusy, wasDisturbed } from './machine.mjs';
import { busyText, earlierText, moduleText, page, runText } from './page.mjs';
import { olderReportOrEnd } from './older.mjs';
import { changes, key, merged, withoutContradictions } from './statistics.mjs';

const { positionals: [folder], values } = parseArgs({
	allowPositionals: true,
	options: { compare: { type: 'string', default: '' }, beside: { type: 'string', default: '' }, module: { type: 'string', default: '' },
		sources: { type: 'string' } },
});
if (!folder) refuse('usage: report.mjs folder [--compare=older-report.json] [--beside=folder] [--module=folder] [--sources=folder]');
const resultsOf = async (run) => JSON.parse(await readFile(path.join(run, 'results.json'), 'utf8'));
const results = await resultsOf(folder);
const beside = values.beside ? await resultsOf(values.beside) : undefined;
const module = values.module ? await resultsOf(values.module) : undefined;
// first: the older report may be the one that is about to be replaced
const older = olderReportOrEnd(values.compare);
const file = (name) => path.join(folder, name);
const began = statSync(file(existsSync(file('load.txt')) ? 'load.txt' : 'results.json')).mtime;
const measured = {
	machine: machine(),
	versions: { ...versions(results.player), ...(beside && { beside: beside.player }) },
};
const own = withoutContradictions(results.entries);
const ownLoad = { start: existsSync(file('load.txt')) ? Number(await readFile(file('load.txt'), 'utf8')) : undefined, end: load() };
const taken = withLoad(beside ? addBeside(own, withoutContradictions(beside.entries)) : own);
const earlier = existsSync(file('report.json')) ? JSON.parse(await readFile(file('report.json'), 'utf8')) : undefined;
const isContinued = earlier !== undefined && areOfOne(earlier, measured);
const entries = isContinued ? merged(earlier.entries, taken) : taken;
const kept = isContinued ? entries.filter((entry) => earlier.entries.includes(entry)) : [];
const better = kept.filter((entry) => !entry.refused && taken.some((own) => key(own) === key(entry))).length;
const run = { created: began.toISOString(), settings: results.settings, load: ownLoad };
const report = {
	schema: 1,
	created: began.toISOString(),
	...measured,
	load: isContinued ? greatestLoad(earlier.load, ownLoad) : ownLoad,
	...(kept.length > 0 && { earlierEntries: kept.length }),
	runs: [...(isContinued ? (earlier.runs ?? []).filter(({ created }) => created !== run.created) : []), ...(run.settings ? [run] : [])],
	...(results.isComplete === false && { isComplete: false }),
	...(values.sources && { sources: values.sources }),
	...(module && { module: { player: module.player, ...timesAsFast(own, module.entries) } }),
	exponents: growth(entries.filter((entry) => entry.figure === 'scattered')),
	entries,
};
await writeFile(file('report.json'), JSON.stringify(report, null, 1) + '\n');
await writeFile(file('report.csv'), csv(report.entries));
await writeFile(file('report.html'), await page(report, path.relative(folder, fileURLToPath(new URL('../..', import.meta.url)))));
const state = { wasDisturbed: wasDisturbed(report), isComplete: report.isComplete };
const told = loadText(report.load, report.machine.cores);
await writeFile(file('timing.txt'), `${told}${busyText(report)}\n\n${tables(report.entries, state)}\n`);
console.log(`\n${tables(taken, state)}\n`);
console.log(`Taken in ${report.versions.player}${beside ? `; the columns and rows named JIT in ${beside.player}` : ''}.`);
if (report.module) console.log(moduleText(report.module));
console.log(`Times and multiples are ${MEDIANS} ${MARK}`);
if (run.settings) console.log(runText(run));
console.log(told + busyText(report));
if (older) {
	const date = older.created.slice(0, 16).replace('T', ' ');
	console.log('\n' + (wasBusy(older) || wasBusy(report) ? `Nothing is compared with the report of ${date}: in ${wasBusy(older) ? 'its' : 'this'} run more programs ran than the machine has cores.`
		: comparison(changes(older.entries, report.entries), date)));
}
if (report.earlierEntries) console.log(`${earlierText(report)} All tables are in ${file('timing.txt')}.`);
if (better > 0) console.log(`Of ${better} entries that were measured again the report keeps the earlier numbers: the new ones are left out, of one sample, of a busy machine, noisier or contradict the report.`);
const again = repeats(entries, report.versions.commit, report.sources);
if (again) console.log('\n' + again);
console.log(`\nThe report: ${file('report.html')}`);
for (const run of [results, beside, module].filter(Boolean)) {
	const wrong = differing(run.entries);
	if (!wrong) continue;
	console.log(`FAILED timing: in ${run.player} collisions were not those of all pairs: ${wrong}`);
	process.exitCode = 1;
}
if (results.isComplete === false) {
	console.error(`The run ended early. The report has the ${taken.length} entries that it had measured.`);
	process.exitCode = 1;
}

/** The entries of this run, marked if the machine was busy. */
function withLoad(found) {
	return isBusy(ownLoad, measured.machine.cores) ? found.map((entry) => ({ ...entry, busy: true })) : found;
}

/** Whether two runs may share a report: what they measured is the same, and the commit says all of it. */
function areOfOne(one, other) {
	return !other.versions.commit.endsWith('-dirty') && JSON.stringify([one.machine, one.versions]) === JSON.stringify([other.machine, other.versions]);
}
