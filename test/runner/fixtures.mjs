/** What stands in for the player's server where the tests' code runs in Node. */
import { readFileSync } from "node:fs";
import path from "node:path";

/**
 * Lets the module of tests read files of folders.
 *
 * @param tests the module
 * @param {string[]} mounts each /url=folder
 */
export function mount(tests, mounts) {
	const folders = mounts.map((each) => each.split("="));
	const read = (url) => {
		const [address] = url.split("?");
		const [prefix, folder] = folders.find(([start]) => address.startsWith(`${start}/`)) ?? [];
		return folder === undefined ? null : readFileSync(path.join(folder, address.slice(prefix.length)));
	};
	// a file is read at once, and given later
	tests.setFetch((url, onProgress, onDone, onError) => {
		let bytes = null;
		let isStopped = false;
		try {
			bytes = read(url);
		} catch {
			// as if it were not mounted
		}
		setTimeout(() => {
			if (isStopped) return;
			if (bytes === null) return onError("404");
			onProgress(bytes.length, bytes.length);
			// the progress may be a reason to stop
			if (!isStopped) onDone(bytes);
		});
		return () => { isStopped = true; };
	});
}
