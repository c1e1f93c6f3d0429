import { spawn } from 'node:child_process';
import { access, readFile } from 'node:fs/promises';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { mainClass } from './swf.mjs';

/**
 * Runs a SWF in Adobe's own VM: its shell, with the stand-ins for what a player has beyond the VM (js/standins/). The SWF is compiled
 * for that. Takes and calls what play() of player.mjs does; there is nothing to see.
 *
 * @param {object} options
 * @param {string} options.swf the SWF's file
 * @param {string} options.shell the folder of the shell: avmshell
 * @param {string} options.start the compiled js/standins/start.as
 * @param {boolean} options.collects whether garbage is collected
 * @param {Record<string, string>} options.parameters what the SWF finds in loaderInfo.parameters
 * @param {Record<string, string>} options.folders folders that the SWF can load from: path to folder
 * @param {object} on see player.mjs
 */
export async function play(options, on) {
	const swf = path.resolve(options.swf);
	const main = mainClass(await readFile(swf));
	const shell = spawn(path.join(path.resolve(options.shell), 'avmshell'), [
		...(options.collects ? [] : ['-Dnogc']),
		swf, path.resolve(options.start), '--', main,
		...Object.entries(options.parameters).map(([name, value]) => `${name}=${value}`),
		...Object.entries(options.folders).map(([name, folder]) => `${name}=${path.resolve(folder)}`),
	], { stdio: ['ignore', 'pipe', 'pipe'] });
	let hasEnded = false;
	const lines = createInterface({ input: shell.stdout });
	lines.on('line', (line) => {
		const [, word, rest] = /^\x01(\w+) (.*)$/.exec(line) ?? [];
		switch (word) {
			case 'write':
				on.writeFile(...rest.split(' ').map(unescape));
				break;
			case 'uncaught':
				on.error(unescape(rest));
				break;
			case 'exit':
				hasEnded = true;
				on.exit(Number(rest));
				break;
			default:
				on.trace(line);
		}
	});
	createInterface({ input: shell.stderr }).on('line', (line) => on.crash(line));
	shell.on('error', (error) => on.crash(error.message));
	shell.on('close', (status, signal) => hasEnded || on.crash(`the shell ended with ${signal ?? status}`));
	return {
		screenshot: () => Promise.reject(new Error('Adobe\'s shell shows nothing')),
		close: async () => {
			hasEnded = true;
			shell.kill();
		},
	};
}

/**
 * The folder of Adobe's shell.
 *
 * @throws Error if there is none
 */
export async function shellFolder() {
	const folder = process.env.AVMSHELL;
	if (!folder) {
		throw new Error('AVMSHELL names no folder: -Dplayer=avmshell needs Adobe\'s VM, built from the repository adobe/avmplus by its own '
			+ 'instructions. Put avmshell, builtin.abc and shell_toplevel.abc into one folder and name it in AVMSHELL.');
	}
	for (const file of ['avmshell', 'builtin.abc', 'shell_toplevel.abc']) {
		await access(path.join(folder, file)).catch(() => {
			throw new Error(`${folder}, which AVMSHELL names, has no ${file}`);
		});
	}
	return folder;
}
