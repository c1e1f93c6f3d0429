/**
 * Convex bodies: the hull of points, grown by a radius. Their numbers are doubles, and are taken as they are: a box is the sum of its three half-axes even if
 * rounding leaves its axes not quite perpendicular.
 *
 * A body has its kind, the numbers that describe it (as in LAYOUT), its points as triples of exact numbers, and its radius.
 */
import { exact, plus, times } from "./exact.mjs";

export const KINDS = ["sphere", "capsule", "box", "triangle", "hull"];

/** The numbers of each kind. */
export const LAYOUT = {
	sphere: "centre x y z, radius",
	capsule: "start x y z, end x y z, radius",
	box: "centre x y z, axes x, y, z with x y z each, half-extents along them",
	triangle: "corners with x y z each",
	hull: "origin x y z, corners with x y z each, relative to it",
};

const pointsOf = (numbers, count = numbers.length / 3) => Array.from({ length: count }, (_, i) => numbers.slice(3 * i, 3 * i + 3).map(exact));

function boxPoints(numbers) {
	const [center] = pointsOf(numbers, 1);
	const halves = [0, 1, 2].map((axis) => {
		const half = exact(numbers[12 + axis]);
		return numbers.slice(3 + 3 * axis, 6 + 3 * axis).map((each) => times(exact(each), half));
	});
	let points = [center];
	for (const half of halves) points = points.flatMap((point) => [-1n, 1n].map((sign) => point.map((each, k) => plus(each, [sign * half[k][0], half[k][1]]))));
	return points;
}

/** The body that a kind and numbers describe. */
export function body(kind, numbers) {
	switch (kind) {
	case "sphere":
		return { kind, numbers, points: pointsOf(numbers, 1), radius: numbers[3] };
	case "capsule":
		return { kind, numbers, points: pointsOf(numbers, 2), radius: numbers[6] };
	case "box":
		return { kind, numbers, points: boxPoints(numbers), radius: 0 };
	case "hull": {
		const [origin, ...corners] = pointsOf(numbers);
		return { kind, numbers, points: corners.map((corner) => corner.map((each, k) => plus(each, origin[k]))), radius: 0 };
	}
	default:
		return { kind, numbers, points: pointsOf(numbers), radius: 0 };
	}
}

/** How many of a body's numbers are coordinates that move with it. */
const movingNumbers = { sphere: 3, capsule: 6, box: 3, triangle: 9, hull: 3 };

/** A body like another, moved by a vector of doubles. Its numbers are rounded; what they describe then is exact again. */
export const moved = ({ kind, numbers }, by) => body(kind, numbers.map((each, i) => (i < movingNumbers[kind] ? each + by[i % 3] : each)));

/** A body with a larger radius or half-extents, by a factor. Triangles and hulls stay as they are. */
export function widened({ kind, numbers }, factor) {
	const first = { sphere: 3, capsule: 6, box: 12 }[kind] ?? numbers.length;
	return body(kind, numbers.map((each, i) => (i < first ? each : factor * each)));
}

/** A body's points moved by an exact vector. */
export const shifted = (points, by) => points.map((point) => point.map((each, k) => plus(each, by[k])));

/** The vectors along a body's edges, and perhaps some more between its points: as pairs of indices of points. */
export function edgesOf({ kind, points }) {
	switch (kind) {
	case "sphere":
		return [];
	case "capsule":
		return [[0, 1]];
	case "box":
		return [[0, 1], [0, 2], [0, 4]];
	default:
		return points.flatMap((_, i) => points.slice(0, i).map((_, k) => [k, i]));
	}
}

/** Half of the extent along each axis and the middle, in doubles; the radius is included. */
export function extentsOf({ points, radius }) {
	const numbers = points.map((point) => point.map(([integer, exponent]) => Number(integer) * 2 ** exponent));
	const low = [0, 1, 2].map((k) => Math.min(...numbers.map((point) => point[k])));
	const high = [0, 1, 2].map((k) => Math.max(...numbers.map((point) => point[k])));
	return { half: low.map((each, k) => (high[k] - each) / 2 + radius), middle: low.map((each, k) => (high[k] + each) / 2) };
}

/** Half of the diagonal of the axis-aligned box around a body. */
export const sizeOf = (each) => Math.hypot(...extentsOf(each).half);
