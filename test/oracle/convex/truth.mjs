/**
 * The exact distance, depth and time of touch of two convex bodies. All is computed in integers of one unit, and every answer is proved:
 *
 * - cores that are apart: a vector between a point of each, such that no point of either is beyond the planes through its ends;
 * - cores that overlap: a point of both, as weights of the points of each;
 * - the depth: no direction has less. The directions that may have least are perpendicular to two edges, of the same core or of both.
 */
import { edgesOf, shifted } from "./bodies.mjs";
import { cross, dot, exact, inUnit, minus, plus, pointsIn, rootOf, rootRatio, times, toNumber, unitOf } from "./exact.mjs";

// The weights of points whose sum is nearest to the origin, in the plane, line or space through them; null if one of the points is in that of the others.
function weightsOf(points) {
	if (points.length === 1) return [1n];
	const edges = points.slice(1).map((point) => minus(point, points[0]));
	const gram = edges.map((p) => edges.map((q) => dot(p, q)));
	const right = edges.map((edge) => -dot(edge, points[0]));
	const whole = determinant(gram);
	if (whole === 0n) return null;
	const weights = edges.map((_, column) => determinant(gram.map((row, i) => row.map((each, k) => (k === column ? right[i] : each)))));
	return [weights.reduce((sum, each) => sum - each, whole), ...weights];
}

function determinant(m) {
	if (m.length === 1) return m[0][0];
	if (m.length === 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
	return dot(m[0], cross(m[1], m[2]));
}

const subsets = Array.from({ length: 16 }, (_, mask) => [0, 1, 2, 3].filter((i) => mask & (1 << i))).slice(1).sort((p, q) => q.length - p.length);

// The point of a simplex that is nearest to the origin: the corners that it is made of, their weights, and the vector, sum times as long.
function nearestOf(simplex) {
	for (const subset of subsets) {
		if (subset.at(-1) >= simplex.length) continue;
		const corners = subset.map((i) => simplex[i]);
		const weights = weightsOf(corners.map((corner) => corner.at));
		if (weights === null || weights.some((weight) => weight <= 0n)) continue;
		const vector = [0, 1, 2].map((k) => corners.reduce((sum, corner, i) => sum + weights[i] * corner.at[k], 0n));
		const sum = weights.reduce((total, weight) => total + weight, 0n);
		const square = dot(vector, vector);
		if (simplex.every((corner) => dot(vector, corner.at) * sum >= square)) return { corners, weights, vector, sum, square };
	}
	throw new Error("a simplex without a nearest point");
}

function leastOf(points, along) {
	let best = 0;
	let least = null;
	for (let i = 0; i < points.length; i++) {
		const reach = dot(along, points[i]);
		if (least === null || reach < least) [least, best] = [reach, i];
	}
	return [least, best];
}

/**
 * The vector from b's core to a's, of points in integers: vector / sum, with the square of the vector. It is 0 if they touch or overlap. This is the
 * algorithm of Gilbert, Johnson and Keerthi. In integers it ends, because each simplex is nearer than the one before. Its last step is the proof.
 *
 * @param start pairs of indices of points to begin with, such as the corners of a result for the same points nearby
 */
export function gapOf(a, b, start = [[0, 0]]) {
	const corner = (i, k) => ({ i, k, at: minus(a[i], b[k]) });
	let simplex = start.map(([i, k]) => corner(i, k));
	for (;;) {
		const nearest = nearestOf(simplex);
		const { vector, sum, square } = nearest;
		if (square === 0n) return nearest;
		const [low, i] = leastOf(a, vector);
		const [negative, k] = leastOf(b, vector.map((each) => -each));
		if ((low + negative) * sum >= square) return nearest;
		simplex = [...nearest.corners, corner(i, k)];
	}
}

/** Whether a result of gapOf() is right, whatever made it. */
export function isProved(a, b, { corners, weights, vector, sum, square }) {
	const total = [0, 1, 2].map((k) => corners.reduce((so, corner, i) => so + weights[i] * (a[corner.i][k] - b[corner.k][k]), 0n));
	const isOfBoth = weights.every((weight) => weight > 0n) && weights.reduce((so, weight) => so + weight, 0n) === sum && total.every((each, k) => each === vector[k])
		&& dot(vector, vector) === square;
	return isOfBoth && a.every((p) => b.every((q) => dot(vector, minus(p, q)) * sum >= square));
}

const asNumbers = (vector, scale) => vector.map((each) => Number(each) * scale);

// A vector of integers as a unit vector, however long it is.
function unitVector(vector) {
	const most = Math.max(...vector.map((each) => (each < 0n ? -each : each).toString(16).length));
	const shift = BigInt(Math.max(0, 4 * most - 120));
	const numbers = vector.map((each) => Number(each >> shift));
	const length = Math.hypot(...numbers);
	return numbers.map((each) => each / length);
}

/** The part of the size within which directions are compared in doubles; those that may be least are then compared exactly. */
const HAIR = 1e-8;

/** The squared sine below which a direction across two edges is not computed in doubles. */
const STEEP = 1e-10;

/**
 * The depth of cores that overlap, of points in integers: the least translation of a that takes it out of b, as its square, numerator / denominator, and its
 * direction. The square is 0 if the cores only touch, or if both are in one plane.
 *
 * @param edges vectors along all edges of the two, in integers
 */
export function depthOf(a, b, edges) {
	const scale = 1 / Math.max(...[...a, ...b].flat().map((each) => Math.abs(Number(each))), 1);
	const [p, q, e] = [minusFirst(a, a[0]), minusFirst(b, a[0]), edges].map((list) => list.map((each) => asNumbers(each, scale)));
	const size = Math.max(...p.flat().map(Math.abs), ...q.flat().map(Math.abs), 0);
	let least = Infinity;
	const candidates = [];
	const note = (direction, i, k) => {
		for (const sign of [1, -1]) {
			const depth = highest(q, direction, sign) - lowest(p, direction, sign);
			if (depth > least + HAIR * size) continue;
			candidates.push({ depth, i, k, sign });
			least = Math.min(least, depth);
		}
	};
	for (let i = 1; i < edges.length; i++) {
		for (let k = 0; k < i; k++) {
			const across = cross(e[i], e[k]);
			const square = dot(across, across);
			if (square > STEEP * dot(e[i], e[i]) * dot(e[k], e[k])) {
				const length = Math.sqrt(square);
				note(across.map((each) => each / length), i, k);
			} else {
				const direction = cross(edges[i], edges[k]);
				if (direction.some((each) => each !== 0n)) note(unitVector(direction), i, k);
			}
		}
	}
	let best = { numerator: 0n, denominator: 1n, direction: null };
	const seen = new Set();
	for (const { depth, i, k, sign } of candidates) {
		if (depth > least + HAIR * size) continue;
		const direction = reduced(cross(edges[i], edges[k]).map((each) => BigInt(sign) * each));
		const key = direction.join();
		if (seen.has(key)) continue;
		seen.add(key);
		const reach = -leastOf(a, direction)[0] - leastOf(b, direction.map((each) => -each))[0];
		const numerator = reach * reach;
		const denominator = dot(direction, direction);
		if (best.direction === null || numerator * best.denominator < best.numerator * denominator) best = { numerator, denominator, direction, reach };
	}
	return best;
}

const minusFirst = (points, first) => points.map((point) => minus(point, first));

function lowest(points, [x, y, z], sign) {
	let least = Infinity;
	for (const point of points) {
		const reach = sign * (x * point[0] + y * point[1] + z * point[2]);
		if (reach < least) least = reach;
	}
	return least;
}

const highest = (points, direction, sign) => -lowest(points, direction, -sign);

// A direction without the factors of two that all of its numbers have.
function reduced(direction) {
	let all = direction.reduce((so, each) => so | (each < 0n ? -each : each), 0n);
	let shift = 0n;
	while ((all & 0xffffn) === 0n) [all, shift] = [all >> 16n, shift + 16n];
	while ((all & 1n) === 0n) [all, shift] = [all >> 1n, shift + 1n];
	return direction.map((each) => each >> shift);
}

/** Two bodies where they stand, or the first one moved by an exact vector. */
export class Pair {
	/**
	 * @param by moves the first body: three doubles, or exact numbers
	 * @param way sweeps the first body along this vector too: its core is then all of its places on the way
	 */
	constructor(a, b, by = null, way = null) {
		this.a = a;
		this.b = b;
		const vector = (each) => each.map((number) => (typeof number === "number" ? exact(number) : number));
		const first = by === null ? a.points : shifted(a.points, vector(by));
		const all = way === null ? first : [...first, ...shifted(first, vector(way))];
		this.unit = Math.min(unitOf([...all, ...b.points].flat()), unitOf([exact(a.radius), exact(b.radius)]));
		if (this.unit === Infinity) this.unit = 0;
		this.first = pointsIn(all, this.unit);
		this.second = pointsIn(b.points, this.unit);
		this.radii = [a, b].reduce((sum, each) => sum + inUnit(exact(each.radius), this.unit), 0n);
		this.hasWay = way !== null;
		this.gap = null;
	}

	/** The vector between the cores: see gapOf(). */
	findGap(start) {
		return (this.gap ??= gapOf(this.first, this.second, start));
	}

	/** Pairs of indices from which the search for the gap of another pair of the same bodies begins. */
	get start() {
		return this.findGap().corners.map(({ i, k }) => [i, k]);
	}

	/** Whether the bodies touch or overlap, exactly. */
	areTouching() {
		const { sum, square } = this.findGap();
		return square <= this.radii * this.radii * sum * sum;
	}

	/** The distance of the cores, rounded once. */
	get coreDistance() {
		const { sum, square } = this.findGap();
		return rootRatio(square, sum, this.unit);
	}

	/** The distance of the cores less the radii, rounded once. It is the signed distance of bodies whose cores do not overlap. */
	get separation() {
		const { sum, square } = this.findGap();
		// 300 bits more than the integers have; if the root is none of these numbers, what is cut off is not seen
		const extra = 300n;
		const numerator = rootOf(square << (2n * extra)) - ((this.radii * sum) << extra);
		return toNumber(numerator, sum << extra, this.unit);
	}

	/** The signed distance: above 0 the gap, below 0 the depth, the shortest translation that separates the two. */
	get signedDistance() {
		if (this.findGap().square > 0n) return this.separation;
		return -this.coreDepth - toNumber(this.radii, 1n, this.unit);
	}

	/** How deep the cores overlap. */
	get coreDepth() {
		const { numerator, denominator } = this.findDepth();
		return rootRatio(numerator * denominator, denominator, this.unit);
	}

	/** The depth of cores that overlap: see depthOf(). */
	findDepth() {
		const vectors = (each, points) => edgesOf(each).map(([i, k]) => minus(points[k], points[i]));
		const edges = [...vectors(this.a, this.first), ...vectors(this.b, this.second)];
		// the first places of a's points come first
		if (this.hasWay) edges.push(minus(this.first[this.a.points.length], this.first[0]));
		return (this.depth ??= depthOf(this.first, this.second, edges.filter((edge) => edge.some((number) => number !== 0n))));
	}

	/** A unit vector, in doubles, along which moving the first body away from the second one is shortest; null if there is none. */
	get direction() {
		const { square, vector } = this.findGap();
		const direction = square > 0n ? vector : this.findDepth().direction;
		return direction === null ? null : unitVector(direction);
	}
}

/** Where a point is that moves along a vector of doubles, exactly. */
export const placeAt = (start, way, time) => start.map((each, k) => plus(exact(each), times(exact(way[k]), exact(time))));

/** A vector of doubles times a double, exactly. */
export const scaled = (vector, factor) => vector.map((each) => times(exact(each), exact(factor)));

/** The first double from 0 to 1 from which on a condition holds, within a unit in the last place; 2 if it does not hold at 1. */
function firstTime(holds) {
	if (!holds(1)) return 2;
	let [low, high] = [0, 1];
	for (;;) {
		const middle = (low + high) / 2;
		if (middle === low || middle === high) return high;
		if (holds(middle)) high = middle;
		else low = middle;
	}
}

/**
 * When a body that moves first touches one that stands: the first time at which they are no farther apart than a length, and the first time at which the way
 * so far goes as deep as another length into the other body; 2 if there is none.
 */
export function touchTimes(a, b, start, way, near, deep) {
	const swept = (time) => new Pair(a, b, start, scaled(way, time));
	const earliest = firstTime((time) => swept(time).separation <= near);
	return { earliest, latest: earliest === 2 ? 2 : firstTime((time) => time >= earliest && swept(time).signedDistance <= -deep) };
}
