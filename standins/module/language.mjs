/**
 * What ActionScript has and JavaScript lacks: what the translated classes call beside themselves. A Vector is a plain array here; whoever
 * makes one longer says what the new elements are.
 */

const closures = new WeakMap();

/** `new Vector.<T>(length)`: zero is what T begins with. */
export function $vector(length, zero) {
	return new Array(length).fill(zero);
}

/** `vector.length = length`, which is the new length as an expression. */
export function $resize(vector, length, zero) {
	const before = vector.length;
	vector.length = length;
	if (length > before) vector.fill(zero, before);
	return length;
}

/** Numbers that a public method takes for a Vector: an array, or a typed array's numbers in one. */
export function $numbers(list) {
	return ArrayBuffer.isView(list) ? Array.from(list) : list;
}

const INTEGERS = { int: [-2147483648, 2147483647], uint: [0, 4294967295] };

/**
 * The same, of integers.
 *
 * @throws ArgumentError if one is nothing that such a Vector could have: it would be used as an index
 */
export function $integers(name, type, list) {
	const array = $numbers(list);
	const [least, most] = INTEGERS[type];
	for (let i = 0; i < (array?.length ?? 0); i++) {
		const value = array[i];
		if (!(Number.isInteger(value) && value >= least && value <= most)) {
			throw new ArgumentError(`${name}[${i}] must be an integer from ${least} to ${most}, not ${typeof value === "string" ? `"${value}"` : String(value)}`);
		}
	}
	return array;
}

/** What a `for each` goes over: the elements of an array, the values of an object, nothing of null. */
export function $values(list) {
	if (Array.isArray(list)) return list;
	if (list === null || list === undefined) return [];
	return typeof list[Symbol.iterator] === "function" ? list : Object.values(list);
}

/** `value is type`. */
export function $is(value, type) {
	switch (type) {
		case Object:
			return value !== null && value !== undefined;
		case String:
			return typeof value === "string";
		case Number:
			return typeof value === "number";
		case Boolean:
			return typeof value === "boolean";
		case Function:
			return typeof value === "function";
		default:
			return value instanceof type;
	}
}

/** `value as type`. */
export function $as(value, type) {
	return $is(value, type) ? value : null;
}

/** `Type(value)`. */
export function $cast(value, type) {
	if (value === null || value === undefined) return null;
	if (value instanceof type) return value;
	throw new TypeError(`Error #1034: Type Coercion failed: cannot convert ${value} to ${type.name}.`);
}

/** Whether a value has all members of an interface. */
export function $hasMembers(value, names) {
	return typeof value === "object" && value !== null && names.every((name) => name in value);
}

/** A method of an object as a function: the same one each time, as in ActionScript. */
export function $bound(object, name) {
	let own = closures.get(object);
	if (own === undefined) {
		own = new Map();
		closures.set(object, own);
	}
	const method = object[name];
	let closure = own.get(method);
	if (closure === undefined) {
		closure = method.bind(object);
		own.set(method, closure);
	}
	return closure;
}

/** `object[name]`, where it may be a method. */
export function $taken(object, name) {
	return typeof object[name] === "function" && name in Object.getPrototypeOf(object) ? $bound(object, name) : object[name];
}

/** A value in a variable of type String. */
export function $string(value) {
	return value === null || value === undefined ? null : String(value);
}

const DESCENDING = 2;
const INDEXED = 8;
const NUMERIC = 16;

/** `array.sort(...)`: with a function, or with the numbers of Array.NUMERIC, DESCENDING and RETURNINDEXEDARRAY. */
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

/** An argument is not what it has to be. */
export class ArgumentError extends Error {
	constructor(message = "") {
		super(message);
		this.name = "ArgumentError";
	}
}
