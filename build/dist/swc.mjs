import { createHash } from 'node:crypto';
import { strFromU8, strToU8, unzipSync, zlibSync } from 'fflate';
import { readSwf, writeSwf } from '../headless/swf.mjs';
import { zip } from './zip.mjs';

const PRODUCT_INFO = 41;
const PRODUCT_INFO_TIME = 18;
const SCRIPT = /<script name="[^]*?<\/script>/g;

/**
 * The same SWC with the time of the release in place of when it was compiled, and of when its sources were written; packed as everywhere.
 *
 * @param {Uint8Array} file the SWC
 * @param {number} seconds the time of the release, of the Unix epoch
 * @param {Record<string, Uint8Array>} notices files for people, which compilers pass over
 * @returns {Buffer}
 */
export function normaliseSwc(file, seconds, notices = {}) {
	const entries = new Map(Object.entries({ ...unzipSync(file), ...notices }).filter(([name]) => !name.endsWith('/')));
	const library = normaliseSwf(Buffer.from(entries.get('library.swf')), seconds);
	const catalog = normaliseCatalog(strFromU8(entries.get('catalog.xml')), library, seconds);
	entries.set('library.swf', library);
	entries.set('catalog.xml', strToU8(catalog));
	return zip(entries, seconds);
}

/** A catalogue's scripts, and what each depends on, come in the order of Java's hash tables. */
function normaliseCatalog(text, library, seconds) {
	const digest = createHash('sha256').update(library).digest('hex');
	const timed = text.replaceAll(/ mod="\d+"/g, ` mod="${seconds * 1000}"`)
		.replace(/(<digest type="SHA-256" signed="false" value=")\w+"/, `$1${digest}"`);
	return sortMatches(timed, SCRIPT).replaceAll(SCRIPT, (script) => sortMatches(script, /<dep [^>]*>/g));
}

/** A text whose parts of one kind are in order, each where one of them was. */
function sortMatches(text, pattern) {
	const sorted = text.match(pattern)?.sort();
	return text.replaceAll(pattern, () => sorted.shift());
}

/**
 * The same SWF with the time of the release in place of when it was compiled.
 *
 * @param {Buffer} file the SWF
 * @param {number} seconds the time of the release, of the Unix epoch
 */
export function normaliseSwf(file, seconds) {
	const swf = readSwf(file);
	const { content } = swf.tags.find(({ code }) => code === PRODUCT_INFO);
	content.writeBigUInt64LE(BigInt(seconds) * 1000n, PRODUCT_INFO_TIME);
	return compressed(writeSwf(swf));
}

/** zlib's own bytes are not the same on all processors. */
function compressed(swf) {
	const head = Buffer.from(swf.subarray(0, 8));
	head.write('CWS', 'latin1');
	return Buffer.concat([head, zlibSync(swf.subarray(8), { level: 9 })]);
}
