/** What the release says of itself. */
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = fileURLToPath(new URL('../..', import.meta.url));

export const inRoot = (file) => path.join(ROOT, file);

export const readJson = (file) => JSON.parse(readFileSync(inRoot(file), 'utf8'));

export const { name: NAME, version: VERSION } = readJson('package.json');

/**
 * The time of the release, in seconds of the Unix epoch: SOURCE_DATE_EPOCH, else the commit's. Where there is no repository, the day of the
 * newest version in CHANGELOG.md.
 */
export function releaseTime() {
	const stated = process.env.SOURCE_DATE_EPOCH;
	if (stated !== undefined) {
		if (!/^\d+$/.test(stated)) {
			throw new Error(`SOURCE_DATE_EPOCH must be a number of seconds: ${stated}`);
		}
		return Number(stated);
	}
	if (existsSync(inRoot('.git'))) {
		return Number(execFileSync('git', ['log', '-1', '--format=%ct'], { cwd: ROOT, encoding: 'utf8' }));
	}
	const [, day] = /^## \d\S* - (\d{4}-\d\d-\d\d)$/m.exec(readFileSync(inRoot('CHANGELOG.md'), 'utf8'));
	return Date.parse(`${day}T00:00:00Z`) / 1000;
}
