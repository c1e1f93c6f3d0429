/**
 * Continuous collision queries with exact truth, as Continuous-Collision-Detection/Sample-Queries publishes them: eight rows for each, six
 * integers a row, which are the numerators and denominators of x, y and z. The first four rows are the places of the vertices at the
 * beginning, the others at the end. For "vertex-face" these are a point and a triangle, for "edge-edge" two edges.
 */
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";

/**
 * The queries of a folder in which both sides move without changing their form: [{ name, moving, fixed, way, isTouch }]. moving has one or two
 * points, fixed three or two, all at the beginning. way is how far the one moves seen from the other.
 */
export function translationsIn(folder) {
	const files = readdirSync(folder, { recursive: true }).map(String).filter((file) => /(vertex-face|edge-edge).*\.csv$/.test(file)).sort();
	return files.flatMap((file) => {
		const movingCount = file.includes("vertex-face") ? 1 : 2;
		const rows = readFileSync(path.join(folder, file), "utf8").trim().split(/\r?\n/).map((line) => line.split(",").map((word) => word.trim()));
		return Array.from({ length: Math.floor(rows.length / 8) }, (_, i) => rows.slice(8 * i, 8 * i + 8)).flatMap((query, i) => {
			const points = query.map((row) => [0, 2, 4].map((at) => [BigInt(row[at]), BigInt(row[at + 1])]));
			const moves = [0, 1, 2, 3].map((k) => minus(points[k + 4], points[k]));
			if (!moves.every((move, k) => isZero(minus(move, moves[k < movingCount ? 0 : movingCount])))) return [];
			const places = points.slice(0, 4).map(numbersOf);
			return [{
				name: `${file}, query ${i}`, moving: places.slice(0, movingCount), fixed: places.slice(movingCount),
				way: numbersOf(minus(moves[0], moves[movingCount])), isTouch: query[0][6] === "1",
			}];
		});
	});
}

/** The least distance between the two sides of a query while the one moves, to some roundings. */
export function distanceOf({ moving, fixed, way }) {
	const ends = moving.map((point) => plus(point, way));
	if (moving.length === 1) return segmentTriangle(moving[0], ends[0], fixed);
	const swept = [[moving[0], moving[1], ends[0]], [moving[1], ends[1], ends[0]]];
	return Math.min(...swept.map((triangle) => segmentTriangle(fixed[0], fixed[1], triangle)));
}

const minus = (a, b) => a.map(([n, d], k) => [n * b[k][1] - b[k][0] * d, d * b[k][1]]);
const isZero = (a) => a.every(([n]) => n === 0n);
const numbersOf = (point) => point.map(([n, d]) => numberOf(n, d));

// Sixty-odd bits of the quotient, which are rounded once.
function numberOf(n, d) {
	if (n === 0n) return 0;
	const sign = n < 0n === d < 0n ? 1 : -1;
	const [top, bottom] = [n < 0n ? -n : n, d < 0n ? -d : d];
	const shift = top.toString(2).length - bottom.toString(2).length - 66;
	return sign * Number(shift < 0 ? (top << BigInt(-shift)) / bottom : top / (bottom << BigInt(shift))) * 2 ** shift;
}

const plus = (a, b) => a.map((x, k) => x + b[k]);
const to = (a, b) => b.map((x, k) => x - a[k]);
const times = (a, factor) => a.map((x) => x * factor);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const within = (x) => Math.min(1, Math.max(0, x));
const sidesOf = ([a, b, c]) => [[a, b], [b, c], [c, a]];

function segmentTriangle(p, q, triangle) {
	const normal = normalOf(triangle);
	const [above, below] = [dot(to(triangle[0], p), normal), dot(to(triangle[0], q), normal)];
	if (above * below < 0 && isOver(plus(p, times(to(p, q), above / (above - below))), triangle, normal)) return 0;
	return Math.min(pointTriangle(p, triangle), pointTriangle(q, triangle), ...sidesOf(triangle).map(([a, b]) => segmentSegment(p, q, a, b)));
}

function pointTriangle(point, triangle) {
	const normal = normalOf(triangle);
	const length = Math.sqrt(dot(normal, normal));
	const toSides = sidesOf(triangle).map(([a, b]) => segmentSegment(point, point, a, b));
	const toPlane = length > 0 && isOver(point, triangle, normal) ? Math.abs(dot(to(triangle[0], point), normal)) / length : Infinity;
	return Math.min(toPlane, ...toSides);
}

const normalOf = ([a, b, c]) => cross(to(a, b), to(a, c));
const isOver = (point, triangle, normal) => sidesOf(triangle).every(([a, b]) => dot(cross(to(a, b), to(a, point)), normal) >= 0);

function segmentSegment(p, q, r, s) {
	const [u, v, w] = [to(p, q), to(r, s), to(r, p)];
	const [uu, uv, vv, uw, vw] = [dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)];
	const determinant = uu * vv - uv * uv;
	const pairs = [0, 1].flatMap((end) => [[end, vv > 0 ? within((uv * end + vw) / vv) : 0], [uu > 0 ? within((uv * end - uw) / uu) : 0, end]]);
	if (determinant > 0) pairs.push([within((uv * vw - vv * uw) / determinant), within((uu * vw - uv * uw) / determinant)]);
	return Math.min(...pairs.map(([alongU, alongV]) => Math.hypot(...to(plus(r, times(v, alongV)), plus(p, times(u, alongU))))));
}
