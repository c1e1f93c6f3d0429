/** Tests of the bytes that the npm package gives: the platform's own, which can be copied and sent. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { MessageChannel, receiveMessageOnPort } from "node:worker_threads";

const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = path.join(root, "bin/module");
const manifest = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
const { Agent, BinCollider, BuiltInModel, ByteArray, Collision, CookedModel, FitStore, GltfAnimations, GltfModel, GreatLand, ModelError } =
	await import(pathToFileURL(path.join(folder, manifest.exports["."].default)));

const posted = (value) => {
	const { port1, port2 } = new MessageChannel();
	port1.postMessage(value);
	const { message } = receiveMessageOnPort(port2);
	port1.close();
	return message;
};

test("a snapshot is a Uint8Array, and so are its copies, from which the game goes back", () => {
	const agents = [new Agent("sphere", "balls"), new Agent("sphere", "walls")];
	agents[0].sweeps = true;
	agents[1].moveTo(5, 0, 0);
	const collision = new Collision(new BinCollider());
	let hits = 0;
	collision.onCollision("balls", "walls", () => hits++);
	collision.onCollisionEnd("balls", "walls", () => {});
	collision.update(agents);
	const bytes = collision.snapshot();
	assert.equal(Object.prototype.toString.call(bytes), "[object Uint8Array]");
	const shared = new SharedArrayBuffer(bytes.length);
	new Uint8Array(shared).set(bytes);
	const nodes = [bytes, structuredClone(bytes), posted(bytes), bytes.buffer.slice(0), Buffer.from(bytes), new ByteArray(bytes), shared];
	nodes.forEach((copy, i) => {
		agents[0].jumpTo(0, 0, 0);
		collision.restore(copy, agents);
		agents[0].moveTo(20, 0, 0);
		collision.update(agents);
		assert.equal(hits, i + 1);
	});
	assert.equal(structuredClone(bytes).length, bytes.length);
	assert.throws(() => collision.restore(structuredClone(bytes).subarray(1), agents), /no snapshot/);
	assert.throws(() => collision.restore(structuredClone(bytes), [...agents].reverse()), /of the 2 that/);
});

test("a cooked model is a Uint8Array, and so are its copies", () => {
	const bytes = new GreatLand().cook(BuiltInModel.cube());
	assert.ok(bytes instanceof Uint8Array);
	for (const copy of [bytes, structuredClone(bytes), posted(bytes)]) assert.equal(CookedModel.fromBytes("cube", copy).vertices.length, BuiltInModel.cube().vertices.length);
});

test("a ByteArray may begin with another one's bytes, which are copied", () => {
	const first = new ByteArray(new Uint8Array([1, 2, 3]));
	const second = new ByteArray(first);
	first.length = 0;
	assert.deepEqual([...second.toUint8Array()], [1, 2, 3]);
});

test("a storage of fits that gives anything but a ByteArray has none", () => {
	for (const read of [() => new Uint8Array(5), async () => null, () => undefined, () => "bytes"]) {
		const land = new GreatLand();
		land.fitStore = new FitStore(1e6, { read, write: () => true, remove() {} });
		land.addModel(BuiltInModel.cube());
		assert.equal(land.boundingStructures.tightestFit("cube").volume > 0, true);
	}
});

test("a buffer beside a glTF file may have any name", () => {
	const data = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 1]);
	for (const uri of ["hasOwnProperty", "toString", "constructor", "__proto__", "_x", " _x"]) {
		const document = {
			asset: { version: "2.0" }, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
			accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3" }], bufferViews: [{ buffer: 0, byteLength: 36 }], buffers: [{ uri, byteLength: 36 }],
		};
		const file = new TextEncoder().encode(JSON.stringify(document));
		for (const bytes of [data, data.buffer, new ByteArray(data)]) {
			const buffers = Object.fromEntries([[uri, bytes]]);
			assert.equal(GltfModel.fromBytes("g", file, null, "footprint", buffers).vertices.length, 9, uri);
			assert.equal(new GltfAnimations("g", file, null, buffers).count, 0, uri);
		}
		assert.throws(() => GltfModel.fromBytes("g", file, null, "footprint", { [uri]: "AAAA" }), /buffers\["/, uri);
		assert.throws(() => GltfModel.fromBytes("g", file, null, "footprint", {}), ModelError, uri);
		assert.throws(() => GltfModel.fromBytes("g", file, null, "footprint", Object.create(null)), ModelError, uri);
	}
});
