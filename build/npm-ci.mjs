#!/usr/bin/env node
/**
 * Installs the packages of a package-lock.json with npm, unless they are there.
 *
 *   node build/npm-ci.mjs FOLDER WHAT
 *
 * They are there if node_modules/.package-lock.json, which npm writes last, says of each package what package-lock.json says. The times of
 * the files do not count: a checkout of another branch and back installs nothing. While npm works, it says every ten seconds how far it is.
 */
import { spawn } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { refuse } from './refuse.mjs';

const SIGN_OF_LIFE_MS = 10000;

const versionOf = (entry) => entry?.integrity ?? entry?.version;

/**
 * Whether what npm has installed is what a lock file says.
 *
 * @param {object} lock package-lock.json
 * @param {object} installed node_modules/.package-lock.json. Optional packages for other machines are not in it
 */
export function isInstalled(lock, installed) {
	const { '': root, ...wanted } = lock.packages;
	const there = installed.packages ?? {};
	return Object.entries(wanted).every(([name, entry]) => name in there ? versionOf(there[name]) === versionOf(entry) : entry.optional)
		&& Object.keys(there).every((name) => name in wanted);
}

/** Whether what npm said of its failure is that it reached no server. */
function saysItIsOffline(said) {
	return /\b(?:EAI_AGAIN|ENOTFOUND|ECONNREFUSED|ECONNRESET|ENETUNREACH|EHOSTUNREACH|ETIMEDOUT|ERR_SOCKET_TIMEOUT)\b/.test(said);
}

function install(folder, what) {
	const read = (file) => JSON.parse(readFileSync(path.join(folder, file), 'utf8'));
	const lock = read('package-lock.json');
	if (existsSync(path.join(folder, 'node_modules/.package-lock.json')) && isInstalled(lock, read('node_modules/.package-lock.json'))) return;
	console.log(`Fetching ${what}`);
	const names = Object.keys(lock.packages).filter(Boolean);
	const start = Date.now();
	const signs = setInterval(() => {
		const count = names.filter((name) => existsSync(path.join(folder, name, 'package.json'))).length;
		console.log(`${Math.round((Date.now() - start) / 1000)} s: ${count} of ${names.length} packages`);
	}, SIGN_OF_LIFE_MS);
	// by itself it asks a server that it does not reach for more than a minute
	const npm = spawn('npm', ['ci', '--no-progress', '--loglevel=error', '--fetch-retry-mintimeout=2000', '--fetch-retry-maxtimeout=10000'], { cwd: folder, stdio: ['inherit', 'inherit', 'pipe'] });
	let said = '';
	npm.stderr.on('data', (data) => {
		said += data;
		process.stderr.write(data);
	});
	npm.on('error', (error) => console.error(`npm does not start: ${error.message}`));
	npm.on('close', (status) => {
		clearInterval(signs);
		// antw says such a line last, and not the status of this program
		if (status !== 0 && saysItIsOffline(said)) console.log('FAILED npm reaches no registry: the first build needs a network, docs/building.md');
		process.exitCode = status ?? 1;
	});
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	if (process.argv.length < 4) refuse('npm-ci: FOLDER and WHAT must be given');
	install(process.argv[2], process.argv[3]);
}
