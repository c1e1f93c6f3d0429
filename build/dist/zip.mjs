import { zipSync } from 'fflate';

const REGULAR_FILE = 0o100644;
const UNIX = 3;

/**
 * A zip archive that is the same on every machine: entries in the order of their names, all of one time, readable by all. It is deflated by
 * fflate, which is JavaScript: the zlib inside of Node writes other bytes on other processors.
 *
 * @param {Map<string, Uint8Array>} files what is in it, by name
 * @param {number} seconds the time of all entries, of the Unix epoch
 * @returns {Buffer}
 */
export function zip(files, seconds) {
	process.env.TZ = 'UTC'; // an archive's times are local ones
	const options = { mtime: seconds * 1000, os: UNIX, attrs: (REGULAR_FILE << 16) >>> 0, level: 9 };
	const names = [...files.keys()].sort();
	return Buffer.from(zipSync(Object.fromEntries(names.map((name) => [name, [files.get(name), options]]))));
}
