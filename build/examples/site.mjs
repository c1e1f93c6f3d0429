/**
 * The examples on loopback as a release has them: beside the module and the models, with the SWFs that were compiled. What their pages
 * take from a content delivery network, three.js and the Flash player, comes from where npm put it here, so that no page needs more
 * than this machine.
 */
import { existsSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from '../headless/server.mjs';

export const root = fileURLToPath(new URL('../..', import.meta.url));

const NETWORK = /https:\/\/cdn\.jsdelivr\.net\/npm\/((?:@[\w-]+\/)?[\w-]+)@[\d.]+/g;

/** Where SWFs are compiled to: by ./antw examples, and for a release. */
const SWFS = ['bin/examples', 'bin/dist/examples'];

/** Which folder has what is below a path; of several, the first that has the file. */
const FOLDERS = {
	'/examples': ['examples', newest(SWFS)],
	'/module': ['bin/module'],
	'/assets': ['assets'],
	'/docs': ['docs'],
	'/npm/three': ['js/adapters/three/node_modules/three-r187'],
	'/npm/@ruffle-rs/ruffle': ['node_modules/@ruffle-rs/ruffle'],
};

/** The folder whose SWFs were compiled last. */
function newest(folders) {
	const timeOf = (folder) => statSync(path.join(root, folder, 'flash'), { throwIfNoEntry: false })?.mtimeMs ?? 0;
	return folders.reduce((one, other) => (timeOf(other) > timeOf(one) ? other : one));
}

/**
 * Serves them.
 *
 * @param {number} port 0 for any that is free
 * @returns {Promise<{url: string, close: () => void}>} the address of the index
 */
export async function serveExamples(port = 0) {
	if (!existsSync(path.join(root, 'bin/module/package.json'))) throw new Error('the examples need bin/module: run ./antw module first');
	const folders = Object.entries(FOLDERS).map(([at, below]) => [at, below.map((folder) => path.join(root, folder))]);
	const { url, close } = await serve(pageAt, Object.fromEntries(folders), { port });
	return { url: `${url}examples/`, close };
}

/** Opens an example in a browser's page, and waits until so many frames have been. */
export async function open(page, site, { name, address }, frames) {
	await page.goto(`${site.url}${address}${address.includes('?') ? '&' : '?'}frames=${frames}`);
	await page.waitForFunction((wanted) => Number(document.documentElement.dataset.frame) >= wanted, frames);
}

/** A page of the examples, which names this machine in place of the network; null for what is none. */
function pageAt(pathname) {
	const file = path.join(root, pathname.endsWith('/') ? `${pathname}index.html` : pathname);
	if (!pathname.startsWith('/examples/') || !file.endsWith('.html') || !existsSync(file)) return null;
	return readFileSync(file, 'utf8').replaceAll(NETWORK, '/npm/$1');
}
