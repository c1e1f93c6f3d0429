/** Exact arithmetic on doubles. A double is an integer times a power of two, and so are sums and products of doubles: [integer, exponent]. */

const bits = new DataView(new ArrayBuffer(8));

export const ZERO = [0n, 0];

/** A double, exactly. */
export function exact(number) {
	if (number === 0) return ZERO;
	if (!Number.isFinite(number)) throw new RangeError(`not finite: ${number}`);
	bits.setFloat64(0, number);
	const word = bits.getBigUint64(0);
	const biased = Number((word >> 52n) & 0x7ffn);
	const fraction = word & 0xfffffffffffffn;
	let integer = biased === 0 ? fraction : fraction | (1n << 52n);
	let exponent = (biased === 0 ? 1 : biased) - 1075;
	const zeros = trailingZeros(integer);
	integer >>= BigInt(zeros);
	exponent += zeros;
	return [number < 0 ? -integer : integer, exponent];
}

function trailingZeros(integer) {
	const low = Number(integer & 0xffffffffn);
	return low === 0 ? 32 + trailingZeros(integer >> 32n) : 31 - Math.clz32(low & -low);
}

export const times = (p, q) => [p[0] * q[0], p[1] + q[1]];

export function plus(p, q) {
	if (p[0] === 0n) return q;
	if (q[0] === 0n) return p;
	const exponent = Math.min(p[1], q[1]);
	return [inUnit(p, exponent) + inUnit(q, exponent), exponent];
}

/** How many units of 2 to an exponent that is not greater than the number's. */
export const inUnit = ([integer, exponent], unit) => (integer === 0n ? 0n : integer << BigInt(exponent - unit));

/** The least exponent of some numbers. */
export const unitOf = (numbers) => numbers.reduce((least, [integer, exponent]) => (integer === 0n ? least : Math.min(least, exponent)), Infinity);

/** Points, as triples of numbers, as triples of integers of a unit. */
export const pointsIn = (points, unit) => points.map((point) => point.map((each) => inUnit(each, unit)));

export const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
export const minus = (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
export const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];

const lengthOf = (integer) => integer.toString(16).length * 4;

/** The root of an integer, rounded down. */
export function rootOf(integer) {
	if (integer < 2n) return integer;
	let root = 1n << BigInt((lengthOf(integer) >> 1) + 1);
	for (;;) {
		const next = (root + integer / root) >> 1n;
		if (next >= root) return root;
		root = next;
	}
}

/** The nearest double, or its neighbour, of a fraction times a power of two. */
export function toNumber(numerator, denominator = 1n, exponent = 0) {
	if (numerator < 0n) return -toNumber(-numerator, denominator, exponent);
	if (numerator === 0n) return 0;
	const shift = 70 + lengthOf(denominator) - lengthOf(numerator);
	const quotient = shift >= 0 ? (numerator << BigInt(shift)) / denominator : numerator / (denominator << BigInt(-shift));
	const scale = exponent - shift;
	// in two steps, because each power has to be a double
	return Number(quotient) * 2 ** (scale >> 1) * 2 ** (scale - (scale >> 1));
}

/** The root of an integer divided by another, in doubles: 2 to the exponent is the unit of the result. */
export function rootRatio(square, denominator, exponent) {
	const extra = BigInt(Math.max(0, 128 - (lengthOf(square) >> 1)));
	return toNumber(rootOf(square << (2n * extra)), denominator << extra, exponent);
}
