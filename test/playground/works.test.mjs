/** The works of a class, without a page. */
import assert from 'node:assert/strict';
import { webcrypto } from 'node:crypto';
import { test } from 'node:test';
import { handed } from '../../js/playground/shared/files/submissions.js';

globalThis.crypto ??= webcrypto;

test('who opens the class twice at once loses nothing that comes meanwhile', async () => {
	const requests = [];
	let isAtOnce = false;
	// a browser that keeps nothing, and says so late
	globalThis.indexedDB = { open() {
		const request = { refuse: () => request.onerror() };
		if (isAtOnce) queueMicrotask(request.refuse);
		else requests.push(request);
		return request;
	} };
	const opened = [handed.open(), handed.open()];
	requests.shift().refuse();
	await opened[0];
	isAtOnce = true;
	assert.ok(await handed.take(JSON.stringify({ kind: 'starlogo-nova-work', pupil: 'Ada', programs: [] }), 'Ada.json'));
	for (const { refuse } of requests) refuse();
	await opened[1];
	await handed.open();
	assert.deepEqual(handed.all.map(({ pupil }) => pupil), ['Ada']);
	assert.equal(handed.isKept, false);
	assert.equal(await handed.take(JSON.stringify({ kind: 'starlogo-nova-work', pupil: 'Ada', programs: [] }), 'Ada.json'), false, 'it is there already');
});
