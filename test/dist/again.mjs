/** Builds the release once more, in another folder and under other settings, and compares it with the one in bin: `./antw dist-check`. */
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, utimesSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { strFromU8, unzipSync } from 'fflate';
import { NAME, VERSION, inRoot, releaseTime } from '../../build/dist/project.mjs';

const release = `${NAME}-${VERSION}`;
const copy = inRoot('bin/dist again/elsewhere');
const FETCHED = ['node_modules', 'js/module/node_modules', 'js/playground/node_modules', 'lib/flexunit', 'lib/royale', 'lib/royale-js', 'lib/.resolved'];
const STAMPS = ['node_modules/.package-lock.json', 'js/module/node_modules/.package-lock.json', 'js/playground/node_modules/.package-lock.json', 'lib/.resolved'];
/** A time zone on the other side of the day, and a language whose capital i has a dot. */
const SETTINGS = { TZ: 'Pacific/Kiritimati', LC_ALL: 'tr_TR.UTF-8', JAVA_TOOL_OPTIONS: '-Duser.language=tr -Duser.country=TR -Duser.timezone=Asia/Tokyo' };

test('a second build has the same bytes', { timeout: 30 * 60000 }, () => {
	rmSync(path.dirname(copy), { recursive: true, force: true });
	const files = execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], { cwd: inRoot(''), encoding: 'utf8' });
	for (const file of files.trim().split('\n').reverse().filter((each) => existsSync(inRoot(each)))) {
		cpSync(inRoot(file), path.join(copy, file));
	}
	// fetched once; no file of it is written to
	for (const name of FETCHED.filter((each) => existsSync(inRoot(each)))) {
		mkdirSync(path.dirname(path.join(copy, name)), { recursive: true });
		execFileSync('cp', ['-al', inRoot(name), path.join(copy, name)]);
	}
	for (const stamp of STAMPS) {
		utimesSync(path.join(copy, stamp), Date.now() / 1000, Date.now() / 1000);
	}
	const { status, stdout, stderr } = spawnSync('sh', ['-c', 'umask 077; ./antw dist'], {
		cwd: copy, encoding: 'utf8', maxBuffer: 1e8, env: { ...process.env, ...SETTINGS, SOURCE_DATE_EPOCH: String(releaseTime()) },
	});
	assert.equal(status, 0, `${stdout}${stderr}`);
	const [one, other] = [inRoot('bin'), path.join(copy, 'bin')].map((bin) => readFileSync(path.join(bin, `${release}.zip`)));
	const [sums, otherSums] = [one, other].map((archive) => strFromU8(unzipSync(archive)[`${release}/SHA256SUMS`]).split('\n'));
	assert.deepEqual(otherSums.filter((line) => !sums.includes(line)), [], 'these files differ');
	assert.deepEqual(sums.filter((line) => !otherSums.includes(line)), [], 'these files differ');
	assert.ok(one.equals(other), 'the archives themselves differ');
	rmSync(path.dirname(copy), { recursive: true });
});
