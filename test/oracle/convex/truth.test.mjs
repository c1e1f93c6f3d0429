/** The exact arithmetic against its own proofs, and against the signed distances and times that geometry.py and motion.py found in 60 digits. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { body, sizeOf } from "./bodies.mjs";
import { FAMILIES, KIND_PAIRS, Random, drawMotion, drawPair } from "./families.mjs";
import { Pair, gapOf, isProved, scaled, touchTimes } from "./truth.mjs";

const isFull = process.env.FULL_TESTS === "true";
const FIXTURES = new URL("../../fixtures/", import.meta.url);

/** Of the sizes: the rounding of a quaternion's axes. */
const ROUNDING = 4e-15;

/** How near the times of test/fixtures/motion are. */
const TIME = 1.1e-9;

function* drawnPairs(count) {
	for (const family of FAMILIES) {
		for (const [i, kinds] of KIND_PAIRS.entries()) for (let k = 0; k < count; k++) yield drawPair(family, ...kinds, 7000 * i + k);
	}
}

const integers = (kind, ...numbers) => body(kind, numbers);

test("distances and depths of bodies at integers are known", () => {
	const cube = integers("box", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 2, 2);
	const distances = [
		[integers("sphere", 5, 6, 0, 1), 4],
		[integers("sphere", 5, 6, 0, 5), 0],
		[integers("sphere", 5, 6, 0, 6), -1],
		[integers("sphere", 1, 0, 0, 1), -2],
		[integers("capsule", 4, 5, 14, 4, 5, 8, 1), 6],
		[integers("box", 3, 3, 3, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 1), 0],
		[integers("box", 3, 2, 1, 0, 1, 0, 0, 0, 1, 1, 0, 0, 2, 2, 2), -1],
		[integers("triangle", 0, 0, 3, 9, 0, 3, 0, 9, 3), 1],
		[integers("triangle", -9, 0, 1, 9, 9, 1, 9, -9, 1), -1],
		[integers("hull", 0, 0, 5, 0, 0, -1, 1, 0, 0, 0, 1, 0, -1, -1, 0), 2],
		[integers("hull", 0, 0, 2, 0, 0, -1, 9, 0, 9, 0, 9, 9, -9, -9, 9), -1],
	];
	for (const [other, distance] of distances) {
		const found = new Pair(other, cube).signedDistance;
		assert.ok(Math.abs(found - distance) <= 1e-15, `${other.kind} ${other.numbers}: ${found}, not ${distance}`);
		assert.equal(new Pair(cube, other).signedDistance, found);
	}
});

test("every gap has a proof, and nothing else has one", () => {
	let overlapping = 0;
	let count = 0;
	for (const each of drawnPairs(isFull ? 40 : 3)) {
		const { start, way } = drawMotion(each);
		for (const pair of [new Pair(each.a, each.b), new Pair(each.a, each.b, start, way)]) {
			const gap = pair.findGap();
			assert.ok(isProved(pair.first, pair.second, gap), `${each.family}, seed ${each.seed}`);
			if (gap.square > 0n) assert.ok(!isProved(pair.first, pair.second, { ...gap, square: gap.square + 1n }));
			assert.ok(!isProved(pair.first, pair.second, { ...gap, weights: gap.weights.map((weight, i) => (i === 0 ? weight + 1n : weight)) }));
			const other = gapOf(pair.first, pair.second, [[pair.first.length - 1, pair.second.length - 1]]);
			assert.equal(other.square * gap.sum ** 2n, gap.square * other.sum ** 2n, "from another corner");
			overlapping += gap.square === 0n ? 1 : 0;
			count++;
		}
	}
	assert.ok(overlapping > count / 5 && overlapping < count / 2, `${overlapping} overlap of ${count}`);
});

test("cores come apart after the depth along its direction, and after no shorter way", () => {
	const random = new Random(5);
	let deep = 0;
	for (const each of drawnPairs(isFull ? 20 : 2)) {
		const pair = new Pair(each.a, each.b);
		if (pair.findGap().square > 0n || !(pair.coreDepth > 0)) continue;
		deep++;
		const text = `${each.family}, seed ${each.seed}`;
		const [a, b] = [each.a, each.b].map((whole) => ({ ...whole, radius: 0 }));
		const along = (direction, way) => new Pair(a, b, scaled(direction, way)).areTouching();
		assert.ok(!along(pair.direction, pair.coreDepth * (1 + 1e-12) + 1e-15 * sizeOf(each.a)), text);
		for (let i = 0; i < 8; i++) assert.ok(along(random.direction(), pair.coreDepth * (1 - 1e-9)), text);
	}
	assert.ok(deep > 40, `${deep} deep`);
});

/** The structures of a file of test/fixtures/pairs from one record on, as bodies. */
function readerOf(bytes, { recordBytes, numbers, shapes }) {
	const width = numbers === "float64" ? 8 : 4;
	return (index) => {
		let at = index * recordBytes;
		const list = (count) => Array.from({ length: count }, () => {
			at += width;
			return width === 8 ? bytes.readDoubleLE(at - 8) : bytes.readFloatLE(at - 4);
		});
		const [a, b] = shapes.map((kind) => {
			if (kind !== "box") return body(kind, list(kind === "sphere" ? 4 : 7));
			const center = list(3);
			const quaternion = list(4);
			const length = Math.hypot(...quaternion);
			const [w, x, y, z] = quaternion.map((each) => each / length);
			const axes = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
			return body(kind, [...center, ...axes, ...list(3)]);
		});
		return { a, b, distance: bytes.readDoubleLE(at) };
	};
}

const manifest = JSON.parse(readFileSync(new URL("pairs/manifest.json", FIXTURES), "utf8"));
for (const file of manifest.files) {
	test(`the distances and times of ${file.name} are those of the other oracle`, () => {
		const read = readerOf(readFileSync(new URL(`pairs/${file.file}`, FIXTURES)), file);
		const motions = readFileSync(new URL(`motion/${file.file}`, FIXTURES));
		const every = isFull ? 1 : 50;
		let touches = 0;
		for (let i = 0; i < file.count; i += every) {
			const { a, b, distance } = read(i);
			const size = sizeOf(a) + sizeOf(b);
			const found = new Pair(a, b).signedDistance;
			assert.ok(Math.abs(found - distance) <= ROUNDING * Math.max(size, Math.abs(distance)), `record ${i}: ${found}, not ${distance}`);
			if (i % (10 * every) !== 0) continue;
			const numbers = Array.from({ length: 6 }, (_, k) => motions.readFloatLE(52 * i + 4 * k));
			const time = motions.readDoubleLE(52 * i + 24);
			if (time === 0) continue;
			touches += time <= 1 ? 1 : 0;
			const { earliest, latest } = touchTimes(a, b, numbers.slice(0, 3), numbers.slice(3), 0, 0);
			assert.ok(earliest <= time + TIME && latest >= time - TIME && (time === 2) === (earliest === 2), `motion ${i}: ${earliest} to ${latest}, not ${time}`);
		}
		assert.ok(touches > 0);
	});
}
