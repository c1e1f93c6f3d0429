#!/usr/bin/env node
/**
 * Writes test/fixtures/convex: pairs of convex bodies of all kinds and families, with their exact signed distance and the time of their first touch.
 *
 *   node test/oracle/convex/vectors.mjs [PAIRS]
 *
 * PAIRS of each family and each pair of kinds. It takes some minutes.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { KINDS, LAYOUT, sizeOf } from "./bodies.mjs";
import { FAMILIES, KIND_PAIRS, drawMotion, drawPair } from "./families.mjs";
import { Pair, placeAt, touchTimes } from "./truth.mjs";

const SEED = 20261125;

/** Of the sizes: how near to touching neither a way comes, nor its start, unless it goes as deep. */
const BAND = 1e-9;

/** Of the sizes: how far apart shapes are at the earliest time, and how deep they are in each other at the latest. */
const NEAR = 1e-12;
const DEEP = 1e-13;

const isClear = (distance, size) => Math.abs(distance) > BAND * size;

/** The motion of a pair, in single precision, and its times. */
function motionOf(drawn) {
	const { a, b } = drawn;
	const size = sizeOf(a) + sizeOf(b);
	if (size === 0) return { start: [0, 0, 0], way: [0, 0, 0], earliest: 0, latest: 0 };
	for (;;) {
		const motion = drawMotion(drawn);
		const start = motion.start.map(Math.fround);
		const way = motion.way.map(Math.fround);
		const before = new Pair(a, b, start).signedDistance;
		if (!isClear(before, size) || !isClear(new Pair(a, b, start, way).signedDistance, size) || !isClear(new Pair(a, b, placeAt(start, way, 1)).signedDistance, size)) continue;
		return { start, way, ...(before < 0 ? { earliest: 0, latest: 0 } : touchTimes(a, b, start, way, NEAR * size, DEEP * size)) };
	}
}

const doubles = (numbers) => Buffer.from(new Float64Array(numbers).buffer);
const floats = (numbers) => Buffer.from(new Float32Array(numbers).buffer);

function recordOf(drawn) {
	const { family, a, b } = drawn;
	const { start, way, earliest, latest } = motionOf(drawn);
	const head = [FAMILIES.indexOf(family), ...[a, b].flatMap((each) => [KINDS.indexOf(each.kind), each.numbers.length])];
	const distance = new Pair(a, b).signedDistance;
	return { bytes: Buffer.concat([Buffer.from(head), doubles([...a.numbers, ...b.numbers, distance]), floats([...start, ...way]), doubles([earliest, latest])]), distance, earliest };
}

const each = Number(process.argv[2] ?? 20);
const records = [];
const families = [];
for (const family of FAMILIES) {
	const first = records.length;
	for (const [i, kinds] of KIND_PAIRS.entries()) {
		for (let k = 0; k < each; k++) records.push(recordOf(drawPair(family, ...(k % 2 === 0 ? kinds : kinds.toReversed()), SEED + 100003 * families.length + 1009 * i + k)));
	}
	const all = records.slice(first);
	families.push({ name: family, pairs: all.length, touching: all.filter(({ distance }) => distance <= 0).length, motionsThatTouch: all.filter(({ earliest }) => earliest <= 1).length });
	console.log(JSON.stringify(families.at(-1)));
}
const folder = new URL("../../fixtures/convex/", import.meta.url);
mkdirSync(folder, { recursive: true });
writeFileSync(new URL("pairs.bin", folder), Buffer.concat(records.map(({ bytes }) => bytes)));
writeFileSync(new URL("manifest.json", folder), `${JSON.stringify({
	version: 1,
	byteOrder: "little-endian, no header, no padding",
	record: "family, kind of A, count of A's numbers, kind of B, count of B's numbers, each a byte; A's numbers, B's numbers, signed distance, each a float64; start x y z, way x y z, each a float32; earliest time, latest time, each a float64",
	kinds: KINDS,
	numbers: LAYOUT,
	signedDistance: "above 0: the gap; below 0: the depth, the shortest translation that separates the two",
	motion: "A is at its place plus the start at time 0, and moves along the way until time 1",
	times: `a first touch is right from the earliest time, at which they are ${NEAR} of the sizes apart, to the latest, at which A would be ${DEEP} of them deep in B; 2 if there is none`,
	band: `no way comes nearer to grazing than ${BAND} of the sizes, and neither start nor end is as near to a touch`,
	size: "half the diagonal of the axis-aligned box around a body",
	seed: SEED,
	families,
}, null, 1)}\n`);
