/**
 * Functions for features of ActionScript that JavaScript lacks. The translated classes call them. A Vector is a plain array here, so the
 * code that makes one longer passes the value of the new elements.
 */
import { $hintOfOption, $hintOfValue } from "./warnings/spelling.mjs";

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
export function $fixedInts(length) {
	return new Int32Array(length);
}

/** A list of numbers whose length stays. */
export function $fixedNumbers(length) {
	return new Float64Array(length);
}

/** `vector.length = length`. As an expression it is the new length. */
export function $resize(vector, length, zero) {
	const before = vector.length;
	vector.length = length;
	if (length > before) vector.fill(zero, before);
	return length;
}

/** Marks objects of this copy of the engine, because a page or program can load two copies. */
const $copy = {};

/**
 * The text for a value in an error.
 *
 * @param value the value
 * @param wanted the kind that is required, for example "an Agent"
 */
export function $named(value, wanted = "") {
	if (isOfOtherCopy(value, wanted)) return "one of another copy of the engine. There are two copies of the engine: import starlogo-collision from one address";
	switch (typeof value) {
		case "string":
			return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}...` : value);
		case "bigint":
			return `${value}n`;
		case "function":
			return `the function ${value.name || "without a name"}`;
		case "object": {
			if (value === null) return "null";
			if (Array.isArray(value)) return value.length > 4 ? `an array of ${value.length}` : `[${value.map((each) => $named(each)).join(", ")}]`;
			const name = Object.getPrototypeOf(value)?.constructor?.name ?? "Object";
			return name === "Object" ? "a plain object" : `an object of class ${name}`;
		}
		default:
			return String(value);
	}
}

/** Whether an object's class has the wanted name, but belongs to another copy of the engine. three.js's Sphere has no internal fields. */
function isOfOtherCopy(value, wanted) {
	const names = wanted.match(/\b[A-Z]\w*/g)?.filter((name) => name !== "ArrayBuffer") ?? [];
	if (names.length === 0 || typeof value !== "object") return false;
	for (let each = value; each !== null; each = Object.getPrototypeOf(each)) {
		const type = Object.hasOwn(each, "constructor") ? each.constructor : null;
		if (names.includes(type?.name) && type !== globalThis[type.name] && Object.keys(value).some((key) => key.startsWith("_"))) return true;
	}
	return false;
}

/**
 * Throws an error for an argument of the wrong kind.
 *
 * @param target the object that gets the argument, if that identifies the member, otherwise null
 * @param name the argument's name, with the member's if there is no target
 * @param value the argument
 * @param kind the required kind
 */
export function $refuse(target, name, value, kind) {
	const given = target === null ? name : `${target}: ${name}`;
	if (typeof value === "number" && kind.endsWith(" number")) {
		const range = Number.isInteger(value) ? " in the range of 32 bits" : "";
		throw new RangeError(`${given} must be ${kind === "a number" ? "a finite number" : kind + range}, not ${value}`);
	}
	throw new ArgumentError(`${given} must be ${kind}, not ${$named(value, kind)}${$hintOfValue(value, kind)}`);
}

/** Checks of arguments, for members outside of hot loops: `$aNumber("Class.method: name", value)`. */
export function $aNumber(name, value) {
	if (typeof value !== "number") $refuse(null, name, value, "a number");
}

export function $aFiniteNumber(name, value) {
	if (typeof value !== "number" || value - value !== 0) $refuse(null, name, value, "a number");
}

export function $anInt(name, value) {
	if (typeof value !== "number" || value !== (value | 0)) $refuse(null, name, value, "a whole number");
}

export function $anOffset(name, value) {
	if (typeof value !== "number" || value !== (value & 0x7fffffff)) $refuse(null, name, value, "a whole number, 0 or more");
}

export function $aUint(name, value) {
	if (typeof value !== "number" || value !== value >>> 0) $refuse(null, name, value, "a whole number");
}

export function $aBoolean(name, value) {
	if (typeof value !== "boolean") $refuse(null, name, value, "true or false");
}

export function $aString(name, value) {
	if (typeof value !== "string") $refuse(null, name, value, "a string");
}

export function $aFunction(name, value) {
	if (typeof value !== "function") $refuse(null, name, value, "a function");
}

/** Throws if one of a method's arguments is no number. `names` is the method, a colon, and the arguments' names. */
export function $checkNumbers(names, ...values) {
	const place = values.findIndex((value) => typeof value !== "number");
	if (place >= 0) $refuse(null, names.replace(/: .*/, `: ${names.split(": ")[1].split(", ")[place]}`), values[place], "a number");
}

/** Whether an object's class has such a mark, in this copy of the engine. */
export function $isMarked(value, mark) {
	return typeof value === "object" && value !== null && value[mark] === $copy;
}

/** Throws if the value is no array, or if an element fails the test. `kind` is the required kind of an element, for example "an Agent". */
export function $checkList(target, name, list, kind = "", test = null) {
	if (!Array.isArray(list)) $refuse(target, name, list, kind === "" ? "an array" : `an array of ${kind.replace(/^an? /, "")}s`);
	if (test === null) return;
	const place = list.findIndex((each) => !test(each));
	if (place >= 0) $refuse(target, `${name}[${place}]`, list[place], kind);
}

/** A point or a vector that a public method takes: a Vector3D, or one with the x, y and z that something else has at the call. */
export function $point(target, name, value) {
	if (typeof value !== "object" || value === null || !("x" in value && "y" in value && "z" in value)) $refuse(target, name, value, "a Vector3D, or anything with x, y and z");
	if (typeof value.x !== "number") $refuse(target, `${name}.x`, value.x, "a number");
	if (typeof value.y !== "number") $refuse(target, `${name}.y`, value.y, "a number");
	if (typeof value.z !== "number") $refuse(target, `${name}.z`, value.z, "a number");
	return value instanceof Vector3D ? value : new Vector3D(value.x, value.y, value.z);
}

/** What the elements of a list have to be. */
const $KINDS = { Number: "a number", int: "an integer from -2147483648 to 2147483647", uint: "an integer from 0 to 4294967295" };

/** The numbers for a Vector argument of a public method: an array, or a copy of a typed array as an array. */
export function $numbers(target, name, list, type, isNullable) {
	if (isNullable && (list === null || list === undefined)) return null;
	if (ArrayBuffer.isView(list) && !(list instanceof DataView)) return $numbers(target, name, Array.from(list), type, false);
	if (!Array.isArray(list)) $refuse(target, name, list, "an array of numbers");
	for (let i = 0; i < list.length; i++) {
		const value = list[i];
		if (typeof value !== "number" || type !== "Number" && value !== (type === "int" ? value | 0 : value >>> 0)) $refuse(target, `${name}[${i}]`, value, $KINDS[type]);
	}
	return list;
}

/** The bytes for an argument of a public method: a ByteArray. An ArrayBuffer or a view of one is converted to one. */
export function $bytes(target, name, value, isNullable) {
	if (isNullable && (value === null || value === undefined)) return null;
	const areBytes = value instanceof ByteArray || ArrayBuffer.isView(value) || value instanceof ArrayBuffer || Object.prototype.toString.call(value) === "[object SharedArrayBuffer]";
	if (!areBytes) $refuse(target, name, value, "an ArrayBuffer, a view of one, or a ByteArray");
	return ByteArray.from(value);
}

/** The bytes by name for an argument of a public method: a ByteArray under each name, or null if there are none. */
export function $bytesByName(target, name, value) {
	if (value === null || value === undefined) return null;
	if (typeof value !== "object") $refuse(target, name, value, "an object with bytes under each name");
	return Object.fromEntries(Object.entries(value).map(([key, bytes]) => [key, $bytes(target, `${name}[${JSON.stringify(key)}]`, bytes, true)]));
}

/**
 * Options or a filter that a public method receives as a literal: a copy, whose setters check the values. An undefined value counts as absent.
 *
 * @param options an object of the class that has the options
 * @param kind the required kind
 */
export function $options(target, name, value, options, kind) {
	if (typeof value !== "object" || Array.isArray(value)) $refuse(target, name, value, kind);
	for (const key of Object.keys(value)) {
		if (!(key in options)) {
			if (/^[_$]/.test(key)) $refuse(target, name, value, kind);
			const names = Object.keys($stateOf(options));
			throw new ArgumentError(`${target === null ? "" : `${target}: `}${name}.${key} is no option; ${$hintOfOption(key, names, value)}there are ${names.join(", ")}`);
		}
		if (value[key] !== undefined) options[key] = value[key];
	}
	return options;
}

/** Whether an object was passed instead of a Boolean: the options of the platform's own addEventListener. */
export function $areOptions(value) {
	return typeof value === "object" && value !== null;
}

/** `addEventListener(type, listener, { once, capture, signal })`. */
export function $listen(target, type, listener, { once = false, capture = false, signal = null }) {
	if (signal?.aborted) return;
	const isOwn = (each) => each.call === listener && each.isCapturing === capture;
	const isKnown = target.$listenersTo(type).some(isOwn);
	target.addEventListener(type, listener, capture);
	if (isKnown) return;
	target.$listenersTo(type).find(isOwn).isOnce = once;
	signal?.addEventListener("abort", () => target.removeEventListener(type, listener, capture), { once: true });
}

/** `loader.loadAsync(name, url, { upAxis, scaling, signal })`. */
export function $loadAsync(loader, name, url, given) {
	return new Promise((resolve, reject) => {
		const kind = "a literal such as { upAxis: \"y\" }";
		if (given === null) $refuse("ModelLoader.loadAsync", "options", given, kind);
		const { upAxis, scaling, signal } = $options("ModelLoader.loadAsync", "options", given, { upAxis: "z", scaling: "footprint", signal: null }, kind);
		signal?.throwIfAborted();
		loader.load(name, url, upAxis, scaling);
		const load = loader._loads.at(-1);
		const stop = () => loader.drop(load);
		signal?.addEventListener("abort", stop);
		load.whenOver = (model, problem) => {
			signal?.removeEventListener("abort", stop);
			if (model !== null) resolve(model);
			else reject(problem ?? (signal?.aborted ? signal.reason : new DOMException(`the load of ${name} was cancelled`, "AbortError")));
		};
	});
}

/** The state of an object, for tools: its public fields and settable properties that are no objects. Internal names begin with _ or $. */
function $stateOf(object) {
	const state = {};
	const note = (name, value) => {
		if (!/^[_$]/.test(name) && typeof value !== "function") state[name] = value;
	};
	const chain = [];
	for (let each = Object.getPrototypeOf(object); each !== null && each !== Object.prototype; each = Object.getPrototypeOf(each)) chain.unshift(each);
	for (const [name, { get, set }] of chain.flatMap((each) => Object.entries(Object.getOwnPropertyDescriptors(each)))) {
		if (!get || name === "__proto__") continue;
		try {
			const value = get.call(object);
			if (set || typeof value !== "object" || value === null) note(name, value);
		} catch {
			// it can't be read now
		}
	}
	for (const name of Object.keys(object)) note(name, object[name]);
	return state;
}

/** Makes JSON.stringify and Node's console.log show a class's objects as $stateOf describes them. */
export function $shown(type) {
	const inspect = function(depth, options, inspectAny) {
		const name = this.constructor.name;
		if (depth < 0 || typeof inspectAny !== "function") return `[${name}]`;
		return `${name} ${inspectAny($stateOf(this), { ...options, depth: options.depth === null ? null : options.depth })}`;
	};
	Object.defineProperties(type.prototype, {
		[Symbol.toStringTag]: { configurable: true, get() { return this.constructor.name; } },
		toJSON: { configurable: true, writable: true, value: function toJSON() { return $stateOf(this); } },
		[Symbol.for("nodejs.util.inspect.custom")]: { configurable: true, writable: true, value: inspect },
	});
	return type;
}

/** The values for a `for each`: the elements of an array, or the values of an object. Nothing for null. */
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
export function $taken(object, name) {
	return typeof object[name] === "function" && name in Object.getPrototypeOf(object) ? $bound(object, name) : object[name];
}

/** Converts a value for a variable of type String. */
export function $string(value) {
	return value === null || value === undefined ? null : String(value);
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
