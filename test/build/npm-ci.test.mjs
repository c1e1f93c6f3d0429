/** Tests of whether the build installs packages anew: by what the lock file says, not by its time. */
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { isInstalled } from '../../build/npm-ci.mjs';

const script = fileURLToPath(new URL('../../build/npm-ci.mjs', import.meta.url));
const LOCK = {
	packages: {
		'': { name: 'game' }, 'node_modules/one': { version: '1.0.0', integrity: 'sha512-1' },
		'node_modules/elsewhere': { version: '1.0.0', integrity: 'sha512-2', optional: true },
	},
};
const THERE = { packages: { 'node_modules/one': { version: '1.0.0', integrity: 'sha512-1' } } };

test('what npm has installed is compared with the lock file, package by package', () => {
	assert.ok(isInstalled(LOCK, THERE));
	assert.ok(!isInstalled(LOCK, { packages: {} }));
	assert.ok(!isInstalled(LOCK, { packages: { 'node_modules/one': { version: '1.0.0', integrity: 'sha512-3' } } }));
	assert.ok(!isInstalled(LOCK, { packages: { ...THERE.packages, 'node_modules/old': { version: '1.0.0' } } }));
	assert.ok(isInstalled(LOCK, { packages: { ...THERE.packages, 'node_modules/elsewhere': { version: '1.0.0', integrity: 'sha512-2', optional: true } } }));
});

const folder = mkdtempSync(path.join(tmpdir(), 'npm-ci-'));
after(() => rmSync(folder, { recursive: true }));

// An npm that installs what THERE says, or says something and fails.
function run(status = 0, said = '') {
	writeFileSync(path.join(folder, 'npm'), `#!/bin/sh\necho "$@" > ran\nprintf '%s' '${said}' >&2\ncp there node_modules/.package-lock.json\nexit ${status}\n`);
	chmodSync(path.join(folder, 'npm'), 0o755);
	rmSync(path.join(folder, 'ran'), { force: true });
	return spawnSync(process.execPath, [script, folder, 'two packages'], { encoding: 'utf8', env: { ...process.env, PATH: `${folder}:${process.env.PATH}` } });
}

test('npm runs when the lock file says something else, and not again', () => {
	mkdirSync(path.join(folder, 'node_modules'));
	writeFileSync(path.join(folder, 'there'), JSON.stringify(THERE));
	writeFileSync(path.join(folder, 'package-lock.json'), JSON.stringify(LOCK));
	assert.equal(run(1).status, 1);
	rmSync(path.join(folder, 'node_modules/.package-lock.json'));
	const first = run();
	assert.equal(first.status, 0);
	assert.equal(first.stdout, 'Fetching two packages\n');
	assert.match(readFileSync(path.join(folder, 'ran'), 'utf8'), /^ci /);
	// a checkout writes the file anew
	writeFileSync(path.join(folder, 'package-lock.json'), JSON.stringify(LOCK));
	assert.equal(run().stdout, '');
});

test('without a network that is what is said, last', () => {
	writeFileSync(path.join(folder, 'package-lock.json'), JSON.stringify({ packages: { ...LOCK.packages, 'node_modules/two': { version: '1.0.0' } } }));
	const offline = run(1, 'npm error code EAI_AGAIN');
	assert.deepEqual([offline.stderr, offline.status], ['npm error code EAI_AGAIN', 1]);
	assert.match(offline.stdout, /\nFAILED npm reaches no registry: the first build needs a network, docs\/building\.md\n$/);
	assert.equal(run(1, 'npm error code EUSAGE').stdout, 'Fetching two packages\n');
});
