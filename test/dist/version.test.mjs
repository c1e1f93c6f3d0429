/** Tests that package.json alone says which version this is. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { VERSION, inRoot, readJson, releaseTime } from '../../build/dist/project.mjs';

const STATED = new RegExp(`(version|starlogo.{0,40})[^\\w\\n]{1,8}v?${VERSION.replaceAll('.', '\\.')}\\b`, 'i');
const MAY_STATE_IT = ['package.json', 'package-lock.json', 'CHANGELOG.md'];

test('no other file states it', { skip: !existsSync(inRoot('.git')) && 'this is no repository' }, () => {
	const files = execFileSync('git', ['ls-files'], { cwd: inRoot(''), encoding: 'utf8' }).trim().split('\n');
	const stating = files.filter((file) => STATED.test(readFileSync(inRoot(file), 'latin1')));
	assert.deepEqual(stating.filter((file) => !MAY_STATE_IT.includes(file) && !file.endsWith('/package-lock.json')), []);
	assert.ok(stating.includes('package.json'));
});

test('packages that are never published have none', () => {
	for (const folder of ['js/module', 'js/playground']) {
		assert.equal(readJson(`${folder}/package.json`).private, true);
		assert.equal(readJson(`${folder}/package.json`).version, undefined);
	}
});

test('the newest in CHANGELOG.md is it', () => {
	const [, newest] = /^## (\d\S*) - \d{4}-\d\d-\d\d$/m.exec(readFileSync(inRoot('CHANGELOG.md'), 'utf8'));
	assert.equal(newest, VERSION);
});

test('what is built has it', () => {
	for (const file of ['bin/module/package.json', 'bin/dist/asdoc/index.html']) assert.ok(existsSync(inRoot(file)), `${file} is not built: ./antw dist builds it`);
	assert.equal(readJson('bin/module/package.json').version, VERSION);
	assert.match(readFileSync(inRoot('bin/module/starlogo-collision.js'), 'utf8').slice(0, 200), new RegExp(`^/\\*! starlogo-collision ${VERSION},`));
	assert.match(readFileSync(inRoot('bin/dist/asdoc/index.html'), 'utf8').slice(0, 1000), new RegExp(`collision engine ${VERSION}\\b`));
});

test('the release is as old as the commit, or as old as it is told', () => {
	assert.ok(releaseTime() > Date.UTC(2026, 0) / 1000);
	const before = process.env.SOURCE_DATE_EPOCH;
	try {
		process.env.SOURCE_DATE_EPOCH = '1700000000';
		assert.equal(releaseTime(), 1700000000);
		process.env.SOURCE_DATE_EPOCH = 'today';
		assert.throws(releaseTime, /SOURCE_DATE_EPOCH must be a number of seconds: today/);
	} finally {
		delete process.env.SOURCE_DATE_EPOCH;
		Object.assign(process.env, before === undefined ? {} : { SOURCE_DATE_EPOCH: before });
	}
});
