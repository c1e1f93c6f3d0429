/** Stands in for FlexUnit, and for what of Flash only the tests use, where the tests run on the ES module. */

import { deflateRawSync } from "node:zlib";

/** A test can't be run here. */
export class AssumptionViolatedException extends Error {}

export function assertEquals(...args) {
	const [message, expected, actual] = withMessage(args, 2);
	if (!(expected == actual)) fail(`${message}expected:<${expected}> but was:<${actual}>`);
}

export function assertStrictlyEquals(...args) {
	const [message, expected, actual] = withMessage(args, 2);
	if (expected !== actual) fail(`${message}expected:<${expected}> but was:<${actual}>`);
}

export function assertTrue(...args) {
	const [message, value] = withMessage(args, 1);
	if (!value) fail(`${message}expected true but was false`);
}

export function assertFalse(...args) {
	const [message, value] = withMessage(args, 1);
	if (value) fail(`${message}expected false but was true`);
}

export function assertNull(...args) {
	const [message, value] = withMessage(args, 1);
	if (value != null) fail(`${message}object was not null: ${value}`);
}

export function assertNotNull(...args) {
	const [message, value] = withMessage(args, 1);
	if (value == null) fail(`${message}object was null: ${value}`);
}

export function fail(message = "") {
	throw new Error(message);
}

function withMessage(args, count) {
	return args.length > count ? [`${args[0]} - `, ...args.slice(1)] : ["", ...args];
}

/** What the running test waits for. */
export const waiting = [];

export const Async = {
	handleEvent(test, target, type, handler, timeout = 500, data = null) {
		const event = new Promise((resolve, reject) => {
			const timer = setTimeout(() => reject(new Error(`Timeout Occurred before expected event "${type}"`)), timeout);
			target.addEventListener(type, function listener(event) {
				target.removeEventListener(type, listener);
				clearTimeout(timer);
				try {
					handler(event, data);
					resolve();
				} catch (error) {
					reject(error);
				}
			});
		});
		event.catch(() => {}); // the test may have failed before
		waiting.push(event);
	},
};

/** A class with objects for keys. */
export class Dictionary extends Map {}

/** Gives ByteArray what only the tests use. */
export function extendByteArray(ByteArray) {
	ByteArray.prototype.readMultiByte = function (length, charset) {
		const bytes = this.toUint8Array().slice(this.position, this.position + length);
		this.position += length;
		return decoder(charset).decode(bytes);
	};
	ByteArray.prototype.writeMultiByte = function (text, charset) {
		const bytes = /^(iso-8859-1|latin1|us-ascii)$/i.test(charset) ? Uint8Array.from(text, (letter) => letter.charCodeAt(0))
			: /^(utf-16|unicode)(le)?$/i.test(charset) ? utf16(text, true)
			: /^(utf-16be|unicodeFFFE)$/i.test(charset) ? utf16(text, false) : new TextEncoder().encode(text);
		this.writeBytes(new ByteArray(bytes));
	};
	ByteArray.prototype.deflate = function () {
		const packed = deflateRawSync(this.toUint8Array());
		this.length = 0;
		this.writeBytes(new ByteArray(packed));
	};
}

function decoder(charset) {
	const label = { unicode: "utf-16le", unicodefffe: "utf-16be" }[charset.toLowerCase()] ?? charset;
	try {
		return new TextDecoder(label);
	} catch {
		return new TextDecoder();
	}
}

function utf16(text, isLittle) {
	const view = new DataView(new ArrayBuffer(2 * text.length));
	for (let i = 0; i < text.length; i++) view.setUint16(2 * i, text.charCodeAt(i), isLittle);
	return new Uint8Array(view.buffer);
}

export const ExternalInterface = {
	available: true,
	call(name) {
		if (name === "headless.now") return performance.now();
		if (name === "headless.memory") return process.memoryUsage().heapUsed;
		if (name === "headless.processorMs") return (process.cpuUsage().user + process.cpuUsage().system) / 1000;
		if (name === "headless.mostMemory") return 1024 * process.resourceUsage().maxRSS;
		if (name === "headless.collect") return globalThis.gc?.();
		if (name === "headless.player") return `Node ${process.versions.node}, as an ES module`;
		throw new Error(`${name} is nothing that a test may ask for`);
	},
};

/** The name of a value's class. */
export function getQualifiedClassName(value) {
	return (typeof value === "function" ? value : value.constructor).name;
}

/** What a class that is not here is: an error once it is used. */
export function missing(name) {
	return new Proxy(class {}, {
		get(target, key) {
			if (key === "prototype") return target.prototype;
			if (typeof key === "symbol") return undefined;
			throw new Error(`${name} is not here`);
		},
		construct() {
			throw new Error(`${name} is not here`);
		},
		apply() {
			throw new Error(`${name} is not here`);
		},
	});
}
