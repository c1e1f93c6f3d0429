/** Puts still WebP pictures together as one that moves, by the container's specification (RFC 9649). */

const ANIMATED = 0x02;
/** A frame takes the place of the one before it: nothing is blended. */
const NO_BLENDING = 0x02;

/** A chunk: its name, its length and its bytes, at an even length. */
function chunk(name, ...parts) {
	const content = Buffer.concat(parts);
	const head = Buffer.alloc(8);
	head.write(name, 'latin1');
	head.writeUInt32LE(content.length, 4);
	return Buffer.concat([head, content, Buffer.alloc(content.length % 2)]);
}

function numbers(...pairs) {
	return Buffer.concat(pairs.map(([value, bytes]) => {
		const buffer = Buffer.alloc(bytes);
		buffer.writeUIntLE(value, 0, bytes);
		return buffer;
	}));
}

/** The chunks of a picture: [name, bytes], in their order. */
export function chunksOf(picture) {
	const chunks = [];
	for (let at = 12; at < picture.length; ) {
		const length = picture.readUInt32LE(at + 4);
		chunks.push([picture.toString('latin1', at, at + 4), picture.subarray(at + 8, at + 8 + length)]);
		at += 8 + length + length % 2;
	}
	return chunks;
}

/** The chunk of a still that has its pixels, compressed with loss and without transparency, and its size. */
function frameOf(still) {
	const chunks = new Map(chunksOf(still));
	const pixels = chunks.get('VP8 ');
	if (!pixels || chunks.has('ALPH')) throw new Error(`expected a WebP picture with a chunk "VP8 " and no transparency, not ${[...chunks.keys()]}`);
	return { pixels, width: pixels.readUInt16LE(6) & 0x3fff, height: pixels.readUInt16LE(8) & 0x3fff };
}

/**
 * One picture of several, that begins again at its end.
 *
 * @param {Buffer[]} stills WebP pictures of one size, compressed with loss
 * @param {number} milliseconds how long each is shown
 * @returns {Buffer}
 */
export function animationOf(stills, milliseconds) {
	const frames = stills.map(frameOf);
	const [{ width, height }] = frames;
	if (frames.some((frame) => frame.width !== width || frame.height !== height)) throw new Error('the frames are not of one size');
	const size = [[width - 1, 3], [height - 1, 3]];
	const forever = 0;
	const content = Buffer.concat([
		Buffer.from('WEBP'),
		chunk('VP8X', numbers([ANIMATED, 4], ...size)),
		chunk('ANIM', numbers([0xffffffff, 4], [forever, 2])),
		...frames.map(({ pixels }) => chunk('ANMF', numbers([0, 3], [0, 3], ...size, [milliseconds, 3], [NO_BLENDING, 1]), chunk('VP8 ', pixels))),
	]);
	return chunk('RIFF', content);
}
