/** Draws pairs of bodies, in ten families of difficulty. */
import { readFileSync } from "node:fs";
import { KINDS, body, moved, sizeOf } from "./bodies.mjs";
import { cross, dot } from "./exact.mjs";
import { Pair } from "./truth.mjs";

export const FAMILIES = ["random", "lattice", "flat", "needles", "far", "scales", "face to face", "same place", "models", "near misses"];

/** Random numbers that are the same on every run. */
export class Random {
	/** @param seed an integer; neighbouring seeds give unlike numbers */
	constructor(seed) {
		this.state = Math.imul(seed + 1, 0x9e3779b1) >>> 0;
	}

	// "mulberry32", by Tommy Ettinger, in the public domain
	word() {
		this.state = (this.state + 0x6d2b79f5) >>> 0;
		let t = this.state;
		t = Math.imul(t ^ (t >>> 15), t | 1);
		t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
		return (t ^ (t >>> 14)) >>> 0;
	}

	/** From 0 to 1, with 53 bits. */
	next() {
		return (this.word() * 2097152 + (this.word() >>> 11)) / 9007199254740992;
	}

	between(low, high) {
		return low + (high - low) * this.next();
	}

	/** From 0 to below a number. */
	integer(count) {
		return Math.floor(count * this.next());
	}

	chance(probability) {
		return this.next() < probability;
	}

	pick(from) {
		return from[this.integer(from.length)];
	}

	/** Of all magnitudes between two alike. */
	log(low, high) {
		return Math.exp(this.between(Math.log(low), Math.log(high)));
	}

	sign() {
		return this.chance(0.5) ? 1 : -1;
	}

	direction() {
		for (;;) {
			const vector = [this.between(-1, 1), this.between(-1, 1), this.between(-1, 1)];
			const length = Math.hypot(...vector);
			if (length > 0.1 && length < 1) return vector.map((each) => each / length);
		}
	}

	/** Three perpendicular unit vectors. */
	frame() {
		const x = this.direction();
		for (;;) {
			const y = this.direction();
			const across = cross(x, y);
			const length = Math.hypot(...across);
			if (length < 0.1) continue;
			const z = across.map((each) => each / length);
			return [x, cross(z, x), z];
		}
	}
}

const UPRIGHT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

const along = (at, frame, by) => at.map((each, k) => each + by[0] * frame[0][k] + by[1] * frame[1][k] + by[2] * frame[2][k]);

/** A frame turned by an angle about an axis. */
const turned = (frame, angle, axis) => frame.map((each) => {
	const [sine, part] = [Math.sin(angle), 2 * Math.sin(angle / 2) ** 2];
	const across = cross(axis, each);
	const twice = cross(axis, across);
	return each.map((number, k) => number + sine * across[k] + part * twice[k]);
});

/** A frame with its axes in another order. */
function permuted(frame, random) {
	const turn = random.integer(3);
	const axes = [0, 1, 2].map((i) => frame[(i + turn) % 3]);
	return random.chance(0.5) ? axes : [axes[1], axes[0], axes[2]].map((axis, i) => (i === 2 ? axis : axis.map((each) => -each)));
}

/** Corners of a hull within extents: all of them on an ellipsoid, in a prism, or in a plane. */
function hullCorners(random, extents) {
	const corners = [];
	const count = 4 + random.integer(9);
	if (random.chance(0.3)) {
		for (let i = 0, sides = 3 + random.integer(4); i < sides; i++) {
			const angle = 2 * Math.PI * i / sides;
			for (const end of [-1, 1]) corners.push([Math.cos(angle), Math.sin(angle), end]);
		}
	} else for (let i = 0; i < count; i++) corners.push(random.direction());
	return corners.map((corner) => corner.map((each, k) => each * extents[k]));
}

/** A body of a kind with its middle at a place, between -extents and extents along the axes of a frame. */
function drawn(kind, random, extents, frame, at, corners = null) {
	switch (kind) {
	case "sphere":
		return body(kind, [...at, extents[0]]);
	case "capsule":
		return body(kind, [...along(at, frame, [-extents[0], 0, 0]), ...along(at, frame, [extents[0], 0, 0]), extents[1]]);
	case "box":
		return body(kind, [...at, ...frame.flat(), ...extents]);
	case "triangle": {
		const foot = random.between(-1, 1);
		return body(kind, [[-1, -1, 0], [1, -1, 0], [foot, 1, 0]].flatMap((corner) => along(at, frame, corner.map((each, k) => each * extents[k]))));
	}
	default:
		corners ??= hullCorners(random, extents);
		return withClearCorners(body(kind, [...at, ...corners.flatMap((corner) => along([0, 0, 0], frame, corner))]));
	}
}

/** Of a hull's size: how far a corner is from the hull of the others at least. An engine may leave out what is nearer. */
const CLEAR = 1e-5;

/** A hull without the corners that are not clearly corners. */
function withClearCorners(hull) {
	const [x, y, z, ...corners] = hull.numbers;
	const least = CLEAR * sizeOf(hull);
	let kept = Array.from({ length: corners.length / 3 }, (_, i) => corners.slice(3 * i, 3 * i + 3));
	for (let i = kept.length - 1; i >= 0 && kept.length > 1; i--) {
		const others = kept.filter((_, k) => k !== i);
		if (new Pair(body("sphere", [...kept[i], 0]), body("hull", [0, 0, 0, ...others.flat()])).coreDistance <= least) kept = others;
	}
	return body("hull", [x, y, z, ...kept.flat()]);
}

const three = (each) => [each(), each(), each()];

const lattice = {
	sphere: (random, at, scale) => body("sphere", [...at, scale * (1 + random.integer(3))]),
	capsule: (random, at, scale) => {
		const end = three(() => scale * (random.integer(5) - 2));
		return body("capsule", [...at, ...at.map((each, k) => each + end[k]), scale * random.integer(3)]);
	},
	box: (random, at, scale) => body("box", [...at, ...permuted(UPRIGHT, random).flat(), ...three(() => scale * (1 + random.integer(3)))]),
	triangle: (random, at, scale) => body("triangle", three(() => at.map((each) => each + scale * (random.integer(5) - 2))).flat()),
	hull: (random, at, scale) => withClearCorners(body("hull", [...at, ...Array.from({ length: 4 + random.integer(7) }, () => three(() => scale * (random.integer(5) - 2))).flat()])),
};

const models = [];

/** Points of the project's models, those of each that are farthest along some directions. */
function modelCorners(random) {
	if (models.length === 0) {
		for (const name of ["bear", "fortress", "kelp", "spaceship", "tree"]) {
			const text = readFileSync(new URL(`../../../assets/${name}.obj`, import.meta.url), "utf8");
			models.push([...text.matchAll(/^v +(\S+) +(\S+) +(\S+)/gm)].map((line) => line.slice(1, 4).map(Number)));
		}
	}
	const points = random.pick(models);
	const corners = new Set();
	for (let i = 0, count = 6 + random.integer(18); i < count; i++) {
		const direction = random.direction();
		corners.add(points.reduce((best, point, k) => (dot(direction, point) > dot(direction, points[best]) ? k : best), 0));
	}
	return [...corners].map((i) => points[i]);
}

/** How each family draws the extents, frames and places of both. */
const settings = {
	random: (random) => ({ extent: () => random.between(0.1, 1) }),
	flat: (random) => ({ extent: () => (random.chance(0.5) ? 0 : random.between(0.1, 1)) }),
	needles: (random) => ({ extent: () => (random.chance(0.5) ? random.log(1e-9, 1e-2) : random.between(0.1, 1)) }),
	far: (random) => ({ extent: () => random.between(0.1, 1), origin: random.direction().map((each) => each * random.log(1e3, 1e6)) }),
	scales: (random) => {
		const scales = random.chance(0.5) ? [random.log(1e-6, 1e6), random.log(1e-6, 1e6)] : null;
		return { extent: (which) => (scales === null ? random.log(1e-6, 1e6) : scales[which] * random.between(0.1, 1)) };
	},
	models: (random) => ({ extent: () => random.between(0.1, 1), isModel: true }),
};

function drawLattice(kinds, random) {
	const scale = 2 ** (random.integer(9) - 4);
	const far = random.chance(0.2) ? 1000 : 0;
	const origin = three(() => scale * far * (random.integer(3) - 1));
	let [a, b] = kinds.map((kind, i) => lattice[kind](random, i === 0 ? origin : origin.map((each) => each + scale * (random.integer(9) - 4)), scale));
	if (random.chance(0.5)) {
		// along an axis, from afar, to the first place where they touch
		const axis = random.integer(3);
		const step = [0, 0, 0];
		step[axis] = -scale;
		const aside = b.points[0].map(([integer, exponent], k) => (k === axis ? 12 * scale : scale * (random.integer(3) - 1)) + Number(integer) * 2 ** exponent);
		a = moved(a, aside.map((each, k) => each - a.numbers[k]));
		for (let i = 0; i < 24 && !new Pair(a, b).areTouching(); i++) a = moved(a, step);
	}
	return [a, b];
}

// Two bodies with the same axes, nearly or exactly, beside each other along one of them.
function drawFaces(kinds, random) {
	const frame = random.chance(0.4) ? UPRIGHT : random.frame();
	const other = random.chance(0.5) ? frame : turned(frame, random.log(1e-16, 1e-3), random.direction());
	const [first, second] = kinds.map(() => three(() => random.between(0.1, 1)));
	const axis = random.integer(3);
	const reach = (kind, extents) => (kind === "sphere" ? extents[0] : kind === "capsule" ? (axis === 0 ? extents[0] + extents[1] : extents[1]) : kind === "triangle" && axis === 2 ? 0 : extents[axis]);
	const prism = (extents) => [-1, 1].flatMap((end) => [[-1, -1], [1, -1], [1, 1], [-0.5, 1]].map((corner) => {
		const at = [0, 0, 0];
		at[axis] = end * extents[axis];
		at[(axis + 1) % 3] = corner[0] * extents[(axis + 1) % 3];
		at[(axis + 2) % 3] = corner[1] * extents[(axis + 2) % 3];
		return at;
	}));
	const way = three(() => random.between(-0.5, 0.5));
	way[axis] = reach(kinds[0], first) + reach(kinds[1], second);
	const at = three(() => random.between(-1, 1));
	const make = (kind, extents, axes, place) => drawn(kind, random, extents, axes, place, kind === "hull" ? prism(extents) : null);
	return [make(kinds[0], first, frame, at), make(kinds[1], second, random.chance(0.7) ? other : permuted(other, random), along(at, frame, way))];
}

function drawPlain(kinds, family, random) {
	const { extent, origin = [0, 0, 0], isModel = false } = settings[family](random);
	const place = (kind, which) => {
		const extents = three(() => extent(which));
		const scale = Math.max(...extents);
		const corners = isModel && kind === "hull" ? modelCorners(random).map((corner) => corner.map((each) => each * scale)) : null;
		return drawn(kind, random, extents, random.chance(0.1) ? UPRIGHT : random.frame(), origin, corners);
	};
	const [a, b] = kinds.map(place);
	const way = random.chance(0.15) ? random.between(1, 3) : random.between(0, 1.2);
	const direction = random.direction();
	return [moved(a, direction.map((each) => each * way * (sizeOf(a) + sizeOf(b)))), b];
}

function drawSamePlace(kinds, random) {
	const frame = random.frame();
	const at = random.chance(0.5) ? [0, 0, 0] : three(() => random.between(-10, 10));
	const extents = three(() => random.between(0.1, 1));
	return kinds.map((kind) => drawn(kind, random, random.chance(0.5) ? extents : three(() => random.between(0.1, 1)), random.chance(0.5) ? frame : random.frame(), at));
}

/** Moves the first body so that the signed distance of the two is about as wanted, if it can tell along which way. */
export function approached(a, b, distance) {
	const pair = new Pair(a, b);
	const { direction } = pair;
	if (direction === null) return a;
	const by = distance - pair.signedDistance;
	return moved(a, direction.map((each) => by * each));
}

/** Gaps and depths of all magnitudes that matter to rounding. */
const tinyGap = (random, low, high) => random.sign() * random.log(low, high);

/** A pair of bodies of a family, from one seed: { family, seed, a, b, random }. The random numbers go on. */
export function drawPair(family, kindA, kindB, seed) {
	const random = new Random(seed);
	const kinds = [kindA, kindB];
	let a;
	let b;
	switch (family) {
	case "lattice":
		[a, b] = drawLattice(kinds, random);
		break;
	case "face to face":
		[a, b] = drawFaces(kinds, random);
		break;
	case "same place":
		[a, b] = drawSamePlace(kinds, random);
		break;
	case "near misses": {
		const like = random.pick(["random", "random", "flat", "needles", "far", "face to face", "models"]);
		[a, b] = like === "face to face" ? drawFaces(kinds, random) : drawPlain(kinds, like, random);
		a = approached(a, b, tinyGap(random, 1e-15, 1e-9) * (sizeOf(a) + sizeOf(b)));
		break;
	}
	default:
		[a, b] = drawPlain(kinds, family, random);
		if (random.chance(0.35)) a = approached(a, b, -random.log(1e-12, 1e-2) * (sizeOf(a) + sizeOf(b)));
		else if (random.chance(0.15)) a = approached(a, b, tinyGap(random, 1e-12, 1e-3) * (sizeOf(a) + sizeOf(b)));
	}
	return { family, seed, a, b, random };
}

/** A motion of the first body past or into the second one: { start, way }. Half of them only just touch, or only just do not. */
export function drawMotion({ a, b, random }) {
	const size = sizeOf(a) + sizeOf(b);
	const direction = random.direction();
	const back = random.between(0.2, 3) * size;
	const aside = random.direction().map((each) => random.between(0, 0.5) * size * each);
	let start = direction.map((each, k) => aside[k] - back * each);
	const way = direction.map((each) => 2 * back * each * random.between(0.3, 2));
	if (random.chance(0.5)) {
		// beside it, as near as wanted
		const swept = new Pair(a, b, start, way);
		const { vector, square } = swept.findGap();
		if (square > 0n) {
			const gap = random.chance(0.2) ? 0 : tinyGap(random, 1e-13, 1e-2) * size;
			const by = gap - swept.separation;
			const most = vector.reduce((so, each) => ((each < 0n ? -each : each) > so ? (each < 0n ? -each : each) : so), 1n);
			const numbers = vector.map((each) => Number((each << 60n) / most));
			const length = Math.hypot(...numbers);
			start = start.map((each, k) => each + by * numbers[k] / length);
		}
	}
	return { start, way };
}

/** All pairs of kinds, the first as often as the second. */
export const KIND_PAIRS = KINDS.flatMap((first, i) => KINDS.slice(i).map((second) => [first, second]));
