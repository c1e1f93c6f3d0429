import { FIGURES, isLeftOut, noteOf, tablesOf } from './figures.mjs';
import { ratio, time } from './format.mjs';
import { key } from './statistics.mjs';

const WIDTH = 112;

/** All figures as text, in lines of at most 112 characters; for the state of the run see tablesOf(). */
export function tables(entries, state = {}) {
	return FIGURES.map((figure) => [figure, tablesOf(figure, entries, state)]).filter(([, found]) => found.length > 0)
		.map(([figure, found]) => [...found.flatMap((each) => [each.title, '', table(each), '']), wrap(noteOf(figure, found[0]))].join('\n')).join('\n\n\n');
}

/** Rows of cells in columns, the first of them flush left and the others flush right. */
function table({ head, rows, textColumns = 1 }) {
	const widths = head[0].map((_, column) => Math.max(...[...head, ...rows].map((row) => row[column].length)));
	const line = (row) => row.map((cell, column) => (column < textColumns ? cell.padEnd(widths[column]) : cell.padStart(widths[column]))).join('  ').trimEnd();
	const rule = '─'.repeat(widths.reduce((sum, width) => sum + width + 2, -2));
	return [...head.map(line), rule, ...rows.map(line)].join('\n');
}

function wrap(text) {
	const lines = [''];
	for (const word of text.split(' ')) {
		if (lines.at(-1).length + word.length + 1 > WIDTH) {
			lines.push('');
		}
		lines[lines.length - 1] += (lines.at(-1) ? ' ' : '') + word;
	}
	return lines.join('\n');
}

/** What changed since another report. */
export function comparison(changed, olderDate) {
	if (changed.length === 0) {
		return `Since ${olderDate}: nothing is faster or slower beyond the noise.`;
	}
	const rows = changed.map(({ key, before, after, change }) => [key, ratio(before.multiple), ratio(after.multiple),
		`${time(before.value)} to ${time(after.value)}`, change > 1 ? `${ratio(change)} as long` : `${ratio(1 / change)} as fast`]);
	return `Since ${olderDate}, beyond the noise, as multiples of the sphere-sphere test:\n\n`
		+ table({ head: [['what', 'before', 'now', 'time', '']], rows });
}

const GAMES = ['crowds', 'scattered'];
const MODELS = ['fits', 'access', 'hierarchies'];

/** How many times are left out, and of how many others the multiple; an empty text if none is. */
export function countLeftOut(entries) {
	const timed = entries.filter(({ unit }) => unit === 'ms');
	const left = timed.filter(isLeftOut);
	const times = left.filter(({ refused }) => refused).length;
	const multiples = left.length - times;
	return left.length === 0 ? '' : `${times} of ${timed.length} times${multiples > 0 ? `; of ${multiples} more the multiple alone` : ''}`;
}

/**
 * Names the entries that are left out, with the command that measures them alone again; or an empty text.
 *
 * @param {object[]} entries of a run
 * @param {string} commit what was measured; with changes that are not committed its runs share no report
 * @param {string} sources the folder of a researcher's own classes
 */
export function repeats(entries, commit = '', sources = 'FOLDER') {
	const left = entries.filter(isLeftOut);
	if (left.length === 0) {
		return '';
	}
	const own = (isOf) => [...new Set(left.filter(isOf).map(({ variant }) => variant.replace(/, literal$/, '')).filter((name) => name.includes('.')))].join(',');
	const [colliders, fitters] = [own(({ figure }) => GAMES.includes(figure)), own(({ figure }) => MODELS.includes(figure))];
	const command = `    ./antw timing -Drefused${colliders && ` -Dcolliders=${colliders}`}${fitters && ` -Dfitters=${fitters}`}`
		+ `${colliders || fitters ? ` -Dsources=${sources}` : ''} -Drepetitions=11`;
	const where = commit.endsWith('-dirty') ? 'in a report of their own, as the clone has changes that are not committed. They replace the report that is there' : 'for the same report';
	return [`Left out, as too noisy or contradictory: ${countLeftOut(entries)}`, ...left.map((entry) => `    ${key(entry)}${entry.refused ? '' : ' (its multiple alone)'}`), `To measure them alone again, ${where}:`, command].join('\n');
}
