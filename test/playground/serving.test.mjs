/** The command that serves the page to a class. Tests listen on loopback alone. */
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createRequire } from 'node:module';
import path from 'node:path';
import { test } from 'node:test';
import { addressesOf, qrOf } from '../../js/playground/announce.mjs';
import { root } from './browser.mjs';

const jsQR = createRequire(path.join(root, 'js/playground/package.json'))('jsqr');

const CARDS = {
	lo: [{ address: '127.0.0.1', family: 'IPv4', internal: true }],
	wlan: [{ address: 'fe80::1', family: 'IPv6', internal: false }, { address: '192.168.178.23', family: 'IPv4', internal: false }],
	cable: [{ address: '10.0.0.7', family: 'IPv4', internal: false }],
};

test('a class is told the addresses in its network', () => {
	assert.deepEqual(addressesOf('127.0.0.1', 8080, CARDS), ['http://127.0.0.1:8080/']);
	assert.deepEqual(addressesOf('0.0.0.0', 8080, CARDS), ['http://192.168.178.23:8080/', 'http://10.0.0.7:8080/']);
	assert.deepEqual(addressesOf('0.0.0.0', 8080, { lo: CARDS.lo }), ['http://127.0.0.1:8080/']);
	assert.deepEqual(addressesOf('10.0.0.7', 80, CARDS), ['http://10.0.0.7:80/']);
});

/** The grey pixels of lines from a terminal, four by four for each module. */
function photographed(lines, hasBlocks) {
	const rows = lines.flatMap((line) => {
		if (!hasBlocks) return [[...line.matchAll(/\x1b\[(40|107)m {2}/g)].map(([, colour]) => colour === '40')];
		const text = line.replaceAll(/\x1b\[[\d;]*m/g, '');
		return [[...text].map((each) => '▀█'.includes(each)), [...text].map((each) => '▄█'.includes(each))];
	});
	const scale = 4;
	const [width, height] = [rows[0].length * scale, rows.length * scale];
	const pixels = new Uint8ClampedArray(width * height * 4).fill(255);
	rows.forEach((row, y) => row.forEach((isDark, x) => {
		if (isDark) for (let i = 0; i < scale; i++) for (let j = 0; j < scale; j++) pixels.fill(0, 4 * ((y * scale + i) * width + x * scale + j), 4 * ((y * scale + i) * width + x * scale + j) + 3);
	}));
	return [pixels, width, height];
}

for (const [hasBlocks, most] of [[true, 40], [false, 80]]) {
	test(`the QR code in the terminal leads to the address (${hasBlocks ? 'blocks' : 'ASCII'})`, () => {
		const address = 'http://192.168.178.23:8080/';
		const lines = qrOf(address, hasBlocks);
		assert.equal(jsQR(...photographed(lines, hasBlocks)).data, address);
		assert.ok(lines.every((line) => line.replaceAll(/\x1b\[[\d;]*m/g, '').length <= most), 'it fits into a terminal');
		assert.equal(hasBlocks || lines.every((line) => /^[\x00-\x7f]*$/.test(line)), true);
	});
}

/** What the command prints until it waits, and what it serves. */
async function served(...args) {
	const child = spawn(process.execPath, [path.join(root, 'js/playground/serve.mjs'), path.join(root, 'bin/playground'), '0', ...args], { env: { ...process.env, LC_ALL: 'C.UTF-8' } });
	let said = '';
	try {
		for await (const part of child.stdout) {
			said += part;
			if (/stop with[^]*\n/.test(said) && (args.length === 0 || /firewall/.test(said))) break;
		}
		const [url] = /http:\S+/.exec(said);
		return { said, url, page: await (await fetch(url)).text() };
	} finally {
		child.kill();
	}
}

test('the command serves on loopback; for another address of this machine it prints the QR code, too', async () => {
	const alone = await served();
	assert.match(alone.url, /^http:\/\/127\.0\.0\.1:\d+\/$/);
	assert.match(alone.page, /StarLogo Nova/);
	assert.doesNotMatch(alone.said, /█/);
	const shared = await served('localhost');
	assert.match(shared.url, /^http:\/\/localhost:\d+\/$/);
	assert.match(shared.page, /StarLogo Nova/);
	const code = shared.said.split('\n').filter((line) => /^\x1b\[30;107m/.test(line));
	assert.equal(jsQR(...photographed(code, true)).data, shared.url);
});
