/**
 * Checks of the arguments of public members. js/module/translation/checks.mjs writes the calls.
 *
 * All files here and the translated classes are one scope (js/module/assemble.mjs): Vector3D is the engine's.
 */
import { ByteArray } from "./ByteArray.mjs";
import { $doubles, $vector, ArgumentError } from "./language.mjs";
import { $hintOfValue } from "./warnings/spelling.mjs";

/** Marks objects of this copy of the engine, because a page or program can load two copies. */
const $copy = {};

/**
 * The text for a value in an error.
 *
 * @param value the value
 * @param expected what is required, for example "an Agent"
 */
export function $textOf(value, expected = "") {
	if (isOfOtherCopy(value, expected)) return "one of another copy of the engine. There are two copies of the engine: import it from one address";
	switch (typeof value) {
		case "string":
			return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}...` : value);
		case "bigint":
			return `${value}n`;
		case "function":
			return `the function ${value.name || "without a name"}`;
		case "object": {
			if (value === null) return "null";
			if (Array.isArray(value)) return value.length > 4 ? `an array of ${value.length}` : `[${value.map((each) => $textOf(each)).join(", ")}]`;
			const name = Object.getPrototypeOf(value)?.constructor?.name ?? "Object";
			return name === "Object" ? "a plain object" : `an object of class ${name}`;
		}
		default:
			return String(value);
	}
}

/** Whether an object's class has the expected name, but belongs to another copy of the engine. three.js's Sphere has no internal fields. */
function isOfOtherCopy(value, expected) {
	const names = expected.match(/\b[A-Z]\w*/g) ?? [];
	for (let each = value; each != null; each = Object.getPrototypeOf(each)) {
		const type = Object.hasOwn(each, "constructor") && each.constructor;
		if (names.includes(type?.name) && type !== globalThis[type.name] && Object.keys(value).some((key) => /^[_$]/.test(key))) return true;
	}
	return false;
}

/**
 * Throws an error for an argument that is not what it has to be.
 *
 * @param target the object that gets the argument, if that identifies the member, otherwise null
 * @param name the argument's name, with the member's if there is no target
 * @param value the argument
 * @param expected what is required
 */
export function $refuse(target, name, value, expected) {
	const given = target === null ? name : `${target}: ${name}`;
	if (typeof value === "number" && expected.endsWith(" number")) {
		const finite = expected === "a number" ? "a finite number" : Number.isInteger(value) ? `${expected} in the range of 32 bits` : expected;
		throw new RangeError(`${given} must be ${finite}, not ${value}`);
	}
	throw new ArgumentError(`${given} must be ${expected}, not ${$textOf(value, expected)}${$hintOfValue(value, expected, given)}`);
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

/** Whether an object's class has such a mark, in this copy of the engine. */
export function $isMarked(value, mark) {
	return value?.[mark] === $copy;
}

/** Throws if the value is no array, or if an element fails the test. `expected` is what an element has to be, for example "an Agent". */
export function $checkList(target, name, list, expected = "", test = null) {
	if (!Array.isArray(list)) $refuse(target, name, list, expected === "" ? "an array" : `an array of ${expected.replace(/^an? /, "")}s`);
	if (test === null) return;
	const place = list.findIndex((each) => !test(each));
	if (place >= 0) $refuse(target, `${name}[${place}]`, list[place], expected);
}

/** A point or a vector that a public method takes: a Vector3D, or one with the x, y and z that something else has at the call. */
export function $point(target, name, value) {
	if (typeof value !== "object" || value === null || !("x" in value && "y" in value && "z" in value)) {
		$refuse(target, name, value, "a Vector3D, or anything with x, y and z");
	}
	if (typeof value.x !== "number") $refuse(target, `${name}.x`, value.x, "a number");
	if (typeof value.y !== "number") $refuse(target, `${name}.y`, value.y, "a number");
	if (typeof value.z !== "number") $refuse(target, `${name}.z`, value.z, "a number");
	return value instanceof Vector3D ? value : new Vector3D(value.x, value.y, value.z);
}

/** What the elements of a list of numbers have to be. */
const $NUMBER_TYPES = { Number: "a number", int: "an integer from -2147483648 to 2147483647", uint: "an integer from 0 to 4294967295" };

/** The numbers for a Vector argument of a public method: an array, or a copy of a typed array as an array. */
export function $numbers(target, name, list, type, isNullable) {
	if (isNullable && list == null) return null;
	const isView = ArrayBuffer.isView(list) && !(list instanceof DataView);
	if (!isView && !Array.isArray(list)) $refuse(target, name, list, "an array of numbers");
	// Array.from takes three times as long
	const numbers = !isView ? list : type === "Number" ? $doubles(list.length) : $vector(list.length, 0);
	for (let i = 0; i < list.length; i++) {
		const value = list[i];
		const isOfType = typeof value === "number" && (type === "Number" || value === (type === "int" ? value | 0 : value >>> 0));
		if (!isOfType) $refuse(target, `${name}[${i}]`, value, $NUMBER_TYPES[type]);
		if (isView) numbers[i] = value;
	}
	return numbers;
}

/** The bytes for an argument of a public method: a ByteArray. An ArrayBuffer or a view of one is converted to one. */
export function $bytes(target, name, value, isNullable) {
	if (isNullable && value == null) return null;
	const areBytes = value instanceof ByteArray || ArrayBuffer.isView(value) || /ArrayBuffer\]$/.test(Object.prototype.toString.call(value));
	if (!areBytes) $refuse(target, name, value, "an ArrayBuffer, a view of one, or a ByteArray");
	return ByteArray.from(value);
}

/** The bytes by name for an argument of a public method: a ByteArray under each name, or null if there are none. */
export function $bytesByName(target, name, value) {
	if (value == null) return null;
	if (typeof value !== "object") $refuse(target, name, value, "an object with bytes under each name");
	return Object.fromEntries(Object.entries(value).map(([key, bytes]) => [key, $bytes(target, `${name}[${JSON.stringify(key)}]`, bytes, true)]));
}
