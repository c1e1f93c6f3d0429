/** The user's own models: their colours, and every view that offers them. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { SIZES, begin, drop, open, ready } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

/** A glTF file of a cube in two halves: the left one red, the right one, turned by its node, blue. */
function boxes() {
	const corners = [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].map((z) => [x, y, z])));
	const places = new Float32Array(corners.flat());
	const indices = new Uint16Array([0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3]);
	const data = Buffer.concat([Buffer.from(places.buffer), Buffer.from(indices.buffer)]);
	const primitive = (material) => ({ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material }] });
	return {
		asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ children: [2, 1] }, { mesh: 0 }, { mesh: 1, translation: [1, 0, 0] }],
		meshes: [primitive(0), primitive(1)], materials: [{ pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } }, { pbrMetallicRoughness: { baseColorFactor: [0, 0, 1, 1] } }],
		accessors: [{ bufferView: 0, componentType: 5126, count: 8, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 1] }, { bufferView: 1, componentType: 5123, count: 36, type: 'SCALAR' }],
		bufferViews: [{ buffer: 0, byteLength: 96 }, { buffer: 0, byteOffset: 96, byteLength: 72 }],
		buffers: [{ byteLength: 168, uri: `data:application/octet-stream;base64,${data.toString('base64')}` }],
	};
}

/** The same as a GLB file, in which the numbers come after the JSON. */
function glb() {
	const scene = boxes();
	const data = Buffer.from(scene.buffers[0].uri.split(',')[1], 'base64');
	delete scene.buffers[0].uri;
	const text = Buffer.from(JSON.stringify(scene));
	const json = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
	const head = Buffer.alloc(20);
	head.write('glTF');
	[2, 20 + json.length + 8 + data.length, json.length, 0x4e4f534a].forEach((number, i) => head.writeUInt32LE(number, 4 * (i + 1)));
	const between = Buffer.alloc(8);
	[data.length, 0x004e4942].forEach((number, i) => between.writeUInt32LE(number, 4 * i));
	return Buffer.concat([head, json, between, data]);
}

/** The pixels of a stage that are almost of a colour. */
const pixels = (page) => page.evaluate(() => {
	const { stage } = globalThis.playground;
	stage.draw();
	const copy = new OffscreenCanvas(stage.canvas.width, stage.canvas.height).getContext('2d');
	copy.drawImage(stage.canvas, 0, 0);
	const { data } = copy.getImageData(0, 0, stage.canvas.width, stage.canvas.height);
	const found = { red: 0, blue: 0 };
	for (let i = 0; i < data.length; i += 4) {
		if (data[i] > 60 && data[i + 1] < 20 && data[i + 2] < 20) found.red++;
		if (data[i + 2] > 60 && data[i + 1] < 20 && data[i] < 20) found.blue++;
	}
	return found;
});

const options = (page, name) => page.getByLabel(name, { exact: true }).locator('option').allTextContents();

test('a glTF file and a GLB file are drawn in their base colours; Compare and Measure offer them', async () => {
	const { page, said, leave } = await open(site, 'inspect', { ...SIZES.laptop, isDrawn: true });
	for (const [name, content] of [['boxes.gltf', Buffer.from(JSON.stringify(boxes()))], ['boxes.glb', glb()]]) {
		await drop(page, [name, content]);
		await page.waitForFunction((file) => document.querySelector('.status').textContent.startsWith(`${file}: 16 vertices, 24 triangles`), name);
		assert.deepEqual(await page.evaluate(() => globalThis.playground.model.colours), [[12, '#0000ff'], [12, '#ff0000']]);
		const { red, blue } = await pixels(page);
		assert.ok(red > 100 && blue > 100, `${red} red, ${blue} blue`);
	}
	await page.getByRole('link', { name: 'Compare' }).click();
	await ready(page, 'compare');
	const shape = page.locator('.side select').first();
	await page.locator('summary', { hasText: 'Agent A' }).click();
	await shape.selectOption('boxes.glb');
	assert.equal(await page.evaluate(() => globalThis.playground.agents[0].shape), 'boxes.glb');
	await page.waitForFunction(() => location.hash.includes('boxes.glb'));
	assert.match(await page.textContent('.code code'), /new Model\("boxes\.glb", vertices, triangles\)/);
	// a scene with it is opened again
	await page.evaluate(() => {
		const link = location.hash.split('/')[1];
		globalThis.playground.agents[0].shape = 'cube';
		globalThis.playground.open(link);
	});
	assert.equal(await shape.inputValue(), 'boxes.glb');
	// a file can be opened here, too
	await drop(page, ['other_~1.glb', glb()]);
	await page.waitForFunction(() => globalThis.playground.agents[0].shape === 'other_~1.glb');
	await page.waitForFunction(() => location.hash.includes('other'));
	await page.evaluate(() => globalThis.playground.open(location.hash.split('/')[1]));
	assert.equal(await shape.inputValue(), 'other_~1.glb');
	await drop(page, ['broken.obj', Buffer.from('hello')]);
	await page.waitForFunction(() => /^broken\.obj cannot be shown\. No vertices, so this is no OBJ text: expected/.test(document.querySelector('.tools [role=status]').textContent));
	await page.getByRole('link', { name: 'Measure' }).click();
	await ready(page, 'measure');
	assert.deepEqual(await options(page, 'Models'), ['all six', 'boxes.gltf', 'boxes.glb', 'other_~1.glb']);
	await page.getByLabel('Models', { exact: true }).selectOption('boxes.glb');
	assert.deepEqual(await page.evaluate(() => [...new Set(globalThis.playground.live.game.agents.map((agent) => agent.shape))]), ['boxes.glb']);
	await page.getByLabel('Rapier beside it').check();
	await page.waitForFunction(() => globalThis.playground.live.rapier);
	await page.getByRole('button', { name: 'Run', exact: true }).click();
	await page.waitForFunction(() => globalThis.playground.live.parts.count >= 24);
	await page.getByRole('button', { name: 'Stop', exact: true }).click();
	const [engine, rapier] = await page.evaluate(() => ['pairs', 'inRapier'].map((name) => Number(document.querySelector(`.live .part-${name} dd`).textContent.replaceAll(',', ''))));
	// Rapier computes in single precision, so a pair that only just touches may be missing there, or be one too many
	assert.ok(engine > 100 && Math.abs(engine - rapier) <= 1, `${engine} and ${rapier} pairs`);
	assert.deepEqual(said.splice(0), []);
	await leave();
});

test('what Play keeps is offered in Inspect, Compare and Measure, after a reload too', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.laptop);
	await page.waitForFunction(() => globalThis.playground?.editor);
	await drop(page, ['crate.glb', glb()]);
	await page.waitForFunction(() => /crate/.test(document.querySelector('.controls .status').textContent));
	assert.deepEqual(await page.evaluate(() => globalThis.playground.models.get('crate').colours), [[12, '#0000ff'], [12, '#ff0000']]);
	for (const view of ['inspect', 'compare', 'measure']) {
		await page.goto(`${site.url}#${view}`);
		await ready(page, view);
		await page.reload();
		await ready(page, view);
		await page.waitForFunction(() => [...document.querySelectorAll('option')].some(({ textContent }) => textContent === 'crate'));
	}
	assert.deepEqual(said.splice(0), []);
	await leave();
});

test('Measure shows the least of many times, and warns where the machine is busy', async () => {
	const { page, leave } = await open(site, 'measure', SIZES.laptop);
	const shown = (times) => page.evaluate((list) => {
		const { live } = globalThis.playground;
		live.parts.clear();
		for (const engine of list) live.parts.add({ move: 1, engine, draw: 1 });
		live.stop();
		return [document.querySelector('.live .part-engine dd').textContent, !document.querySelector('.live .busy').hidden];
	}, times);
	assert.deepEqual(await shown(Array.from({ length: 180 }, (_, i) => (i < 12 ? 2 : 2.2))), ['2.00', false]);
	assert.deepEqual(await shown(Array.from({ length: 180 }, (_, i) => (i < 24 ? 2 : 5))), ['2.00', true]);
	await leave();
});
