/**
 * Functions for features of ActionScript that JavaScript lacks. The translated classes call them. A Vector is a plain array here, so the
 * code that makes one longer passes the value of the new elements.
 */

/**
 * Zeros to copy: small integers if the first is 0, doubles if it is not. V8 knows that they have no gaps. It takes for granted that
 * `new Array(length)` has some, and looks for them at each reading.
 */
function zerosAfter(first) {
	const zeros = [first];
	while (zeros.length < 1024) zeros.push(0);
	zeros[0] = 0;
	return zeros;
}

const integers = zerosAfter(0);
const doubles = zerosAfter(0.5);

function copiesOf(zeros, length) {
	return length < 1024 ? zeros.slice(0, length) : [].concat(...new Array(length >> 10).fill(zeros), zeros.slice(0, length & 1023));
}

/** `new Vector.<T>(length)`. zero is the first value of a T. */
export function $vector(length, zero) {
	return zero === 0 ? copiesOf(integers, length) : new Array(length).fill(zero);
}

/** `new Vector.<Number>(length)`. It begins as an array of doubles, because V8 copies an array of small integers when the first double comes. */
export function $doubles(length) {
	return copiesOf(doubles, length);
}

/** A list of small integers whose length stays. It is there at once, and takes half the memory of an array. */
export function $zeroedInts(length) {
	return new Int32Array(length);
}

/** A list of numbers whose length stays. */
export function $zeroedNumbers(length) {
	return new Float64Array(length);
}

/** `vector.length = length`. As an expression it is the new length. */
export function $resize(vector, length, zero) {
	const before = vector.length;
	vector.length = length;
	if (length > before) vector.fill(zero, before);
	return length;
}

/** The values for a `for each`: the elements of an array, or the values of an object. Nothing for null. */
export function $values(list) {
	if (Array.isArray(list)) return list;
	if (list == null) return [];
	return typeof list[Symbol.iterator] === "function" ? list : Object.values(list);
}

const typeNames = /* @__PURE__ */ new Map([[String, "string"], [Number, "number"], [Boolean, "boolean"], [Function, "function"]]);

/** `value is type`. */
export function $is(value, type) {
	if (type === Object) return value != null;
	return typeNames.has(type) ? typeof value === typeNames.get(type) : value instanceof type;
}

/** `value as type`. */
export function $as(value, type) {
	return $is(value, type) ? value : null;
}

/** `Type(value)`. */
export function $cast(value, type) {
	if (value == null) return null;
	if (value instanceof type) return value;
	throw new TypeError(`Error #1034: Type Coercion failed: cannot convert ${value} to ${type.name}.`);
}

/** Whether a value has all members of an interface. */
export function $hasMembers(value, names) {
	return typeof value === "object" && value !== null && names.every((name) => name in value);
}

/** Makes a class that extends it add its private fields to a given object. */
class Given {
	constructor(object) {
		return object;
	}
}

/**
 * The closures of an object's methods, by method, in a private field of the object. A WeakMap would keep the object until V8 collects its whole heap,
 * because a closure has the object. So each collection of young objects would copy it.
 */
class Closures extends Given {
	#own = new Map();

	static of(object) {
		if (#own in object) return object.#own;
		if (Object.isExtensible(object)) return new Closures(object).#own;
		if (!closuresOfFixed.has(object)) closuresOfFixed.set(object, new Map());
		return closuresOfFixed.get(object);
	}
}

/** The closures of objects that are not extensible: newer engines add no private fields to these. */
const closuresOfFixed = new WeakMap();

/** A method of an object as a function. It is the same function each time, as in ActionScript. */
export function $bound(object, name) {
	const own = Closures.of(object);
	const method = object[name];
	let closure = own.get(method);
	if (closure === undefined) {
		closure = method.bind(object);
		own.set(method, closure);
	}
	return closure;
}

/** `object[name]`, which may be a method. */
export function $memberOrClosure(object, name) {
	return typeof object[name] === "function" && name in Object.getPrototypeOf(object) ? $bound(object, name) : object[name];
}

/** Converts a value for a variable of type String. */
export function $string(value) {
	return value == null ? null : String(value);
}

const DESCENDING = 2;
const INDEXED = 8;
const NUMERIC = 16;

/** `array.sort(...)`, with a function, or with the flags Array.NUMERIC, DESCENDING and RETURNINDEXEDARRAY. */
export function $sort(array, how = 0) {
	if (typeof how === "function") return array.sort((a, b) => Number(how(a, b)));
	const compare = comparison(how);
	if ((how & INDEXED) === 0) return array.sort(compare);
	return array.map((_, index) => index).sort((a, b) => compare(array[a], array[b]));
}

/** `array.sortOn(name, options)`. */
export function $sortOn(array, name, how = 0) {
	const compare = comparison(how);
	return array.sort((a, b) => compare(a[name], b[name]));
}

function comparison(how) {
	const sign = how & DESCENDING ? -1 : 1;
	if (how & NUMERIC) return (a, b) => sign * (a - b);
	return (a, b) => {
		const first = String(a);
		const second = String(b);
		return first < second ? -sign : first > second ? sign : 0;
	};
}

/** Thrown if an argument is of the wrong kind or has a wrong value. */
export class ArgumentError extends Error {
	static get name() {
		return "ArgumentError";
	}

	constructor(message = "") {
		super(message);
		this.name = "ArgumentError";
	}
}
