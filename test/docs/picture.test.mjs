/** The moving picture of README.md, and what puts its frames together. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { animationOf, chunksOf } from '../../js/picture/webp.mjs';
import { root } from '../structure/sources.mjs';

const picture = readFileSync(path.join(root, 'docs/game.webp'));
const FRAME_HEAD = 16;
const frames = chunksOf(picture).filter(([name]) => name === 'ANMF').map(([, content]) => content);

/** A still that has the pixels of a frame. */
function still(frame) {
	const pixels = frame.subarray(FRAME_HEAD);
	const head = Buffer.from('RIFF....WEBP');
	head.writeUInt32LE(4 + pixels.length, 4);
	return Buffer.concat([head, pixels]);
}

test('the picture moves, begins again and has less than 1 MB', () => {
	assert.ok(picture.length < 1e6);
	assert.equal(picture.readUInt32LE(4), picture.length - 8);
	assert.deepEqual(chunksOf(picture).slice(0, 2).map(([name]) => name), ['VP8X', 'ANIM']);
	assert.equal(chunksOf(picture)[1][1].readUInt16LE(4), 0);
	assert.ok(frames.length >= 40);
	assert.ok(new Set(frames.map((frame) => frame.toString('base64'))).size > 30, 'the frames differ');
});

test('stills put together are the picture again', () => {
	assert.ok(animationOf(frames.map(still), frames[0].readUIntLE(12, 3)).equals(picture));
});

test('what is no picture with loss, or of another size, is refused', () => {
	const other = still(frames[0]);
	assert.throws(() => animationOf([Buffer.from('RIFF....WEBPVP8L\x04\0\0\0abcd', 'latin1')], 100), /expected a WebP picture/);
	other.writeUInt16LE(100, 20 + 6);
	assert.throws(() => animationOf([still(frames[0]), other], 100), /not of one size/);
});
