import { inflateSync } from 'node:zlib';

const SYMBOL_CLASS = 76;

/**
 * Takes a SWF apart.
 *
 * @param {Buffer} file the SWF's bytes, compressed or not
 * @returns {{head: Buffer, tags: {code: number, bytes: Buffer, content: Buffer}[]}} what is before the first tag, and the tags:
 *     all their bytes, and those behind their headers
 */
export function readSwf(file) {
	const signature = file.toString('latin1', 0, 3);
	if (!['FWS', 'CWS'].includes(signature)) {
		throw new Error(`this is no SWF that can be read here: it begins with ${signature}`);
	}
	const body = bodyOf(file);
	// a rectangle of four numbers with as many bits as its first five bits say, then the frame rate and the frames
	const start = Math.ceil((5 + 4 * (body[0] >> 3)) / 8) + 4;
	const tags = [];
	for (let at = start; at < body.length;) {
		const word = body.readUInt16LE(at);
		const isLong = (word & 63) === 63;
		const from = at + (isLong ? 6 : 2);
		const end = from + (isLong ? body.readUInt32LE(at + 2) : word & 63);
		tags.push({ code: word >> 6, bytes: body.subarray(at, end), content: body.subarray(from, end) });
		at = end;
	}
	return { head: Buffer.concat([Buffer.from('FWS'), file.subarray(3, 8), body.subarray(0, start)]), tags };
}

/** What is behind the first eight bytes of a SWF, which is not in LZMA. */
function bodyOf(file) {
	const body = file.subarray(8);
	return file.toString('latin1', 0, 3) === 'CWS' ? inflateSync(body) : body;
}

/** Why a file cannot be played, or an empty text: it is no SWF, or its end is missing. The length of a SWF in LZMA is not looked at. */
export function problemOf(file) {
	const signature = file.toString('latin1', 0, 3);
	if (!['FWS', 'CWS', 'ZWS'].includes(signature) || file.length < 8) {
		return 'is no SWF';
	}
	try {
		const length = signature === 'ZWS' ? Infinity : 8 + bodyOf(file).length;
		return length < file.readUInt32LE(4) ? 'is no whole SWF: its end is missing' : '';
	} catch {
		return 'is no whole SWF: its end is missing, or its bytes are damaged';
	}
}

/** Puts one together, uncompressed. */
export function writeSwf({ head, tags }) {
	const file = Buffer.concat([head, ...tags.map(({ bytes }) => bytes)]);
	file.writeUInt32LE(file.length, 4);
	return file;
}

/** The string that is in a buffer from a place on, up to a zero byte. */
export function stringAt(buffer, from) {
	return buffer.toString('utf8', from, buffer.indexOf(0, from));
}

/** The name of the class that a SWF's main timeline is an instance of. */
export function mainClass(file) {
	for (const { code, content } of readSwf(file).tags) {
		let at = 2;
		while (code === SYMBOL_CLASS && at < content.length) {
			const name = stringAt(content, at + 2);
			if (content.readUInt16LE(at) === 0) {
				return name;
			}
			at += 3 + Buffer.byteLength(name);
		}
	}
	throw new Error('the SWF has no main class');
}
