import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { unzipSync } from 'fflate';
import { inRoot } from '../../build/dist/project.mjs';
import { zip } from '../../build/dist/zip.mjs';

const TIME = Date.UTC(2026, 10, 20, 13, 14, 16) / 1000;
const files = new Map([['b/two.txt', Buffer.from('two '.repeat(100))], ['a.txt', Buffer.from('one')]]);

test('an archive does not depend on the order in which files come, nor on where it is made', () => {
	const here = zip(files, TIME);
	assert.deepEqual(zip(new Map([...files].reverse()), TIME), here);
	for (const TZ of ['Pacific/Kiritimati', 'America/St_Johns']) {
		const text = `import { zip } from ${JSON.stringify(inRoot('build/dist/zip.mjs'))};
			new Date().getHours();
			process.stdout.write(zip(new Map([["b/two.txt", Buffer.from("two ".repeat(100))], ["a.txt", Buffer.from("one")]]), ${TIME}));`;
		assert.deepEqual(execFileSync(process.execPath, ['--input-type=module', '-e', text], { env: { ...process.env, TZ } }), here, TZ);
	}
	assert.notDeepEqual(zip(files, TIME + 2), here);
});

test('what is in it comes out, with its time and for all to read', () => {
	const archive = zip(files, TIME);
	assert.deepEqual(Object.keys(unzipSync(archive)), ['a.txt', 'b/two.txt']);
	const central = archive.indexOf(Buffer.from([0x50, 0x4b, 1, 2]));
	assert.equal(archive.readUInt32LE(central + 38) >>> 16, 0o100644);
	assert.equal(archive.readUInt16LE(central + 12), (13 << 11) | (14 << 5) | (16 >> 1));
	assert.equal(archive.readUInt16LE(central + 14), ((2026 - 1980) << 9) | (11 << 5) | 20);
	assert.equal(archive.readUInt16LE(central + 30), 0, 'no further fields');
});
