/**
 * The stand-ins' access to the machine: time, frames and files. Nothing is accessed before it is needed.
 *
 * All files here and the translated classes are one scope (js/module/assemble.mjs): Event is the engine's.
 */
import { ByteArray } from "./ByteArray.mjs";

/** Milliseconds from one frame to the next. */
const FRAME_MS = 1000 / 60;

/** The present time in milliseconds. */
export function now() {
	return performance.now();
}

/** Throws an error that no caller can catch, only global error listeners. */
export function reportError(error) {
	setTimeout(() => {
		throw error;
	});
}

/** The error for an error event without a listener. */
export function unhandledEvent(type, text) {
	return new Error(`${text}. Nothing listens to the event ${JSON.stringify(type)}`);
}

/** The EventDispatchers that get frames. */
const frameListeners = /* @__PURE__ */ new Set();
let isTicking = false;

/** Sends frames to a dispatcher from now on. */
export function addFrameListener(dispatcher) {
	frameListeners.add(dispatcher);
	tick();
}

/** Sends it no more frames. */
export function removeFrameListener(dispatcher) {
	frameListeners.delete(dispatcher);
}

/** Sends frames as long as somebody gets them. */
function tick() {
	if (isTicking || frameListeners.size === 0) return;
	isTicking = true;
	setTimeout(() => {
		isTicking = false;
		for (const dispatcher of [...frameListeners]) dispatcher.dispatchEvent(new Event(Event.ENTER_FRAME));
		tick();
	}, FRAME_MS);
}

/** The name of an object's class. */
export function classNameOf(value) {
	return value.constructor.name;
}

/**
 * Fetches a file.
 *
 * @param url its address
 * @param onProgress called with the number of bytes that have arrived and of all bytes, 0 if that is not known
 * @param onDone called with the bytes, a ByteArray
 * @param onError called with the problem
 * @returns a function that stops it
 */
export function fetchFile(url, onProgress, onDone, onError) {
	const controller = new AbortController();
	read(url, controller.signal, onProgress).then(
		(bytes) => controller.signal.aborted || onDone(new ByteArray(bytes)),
		(error) => controller.signal.aborted || onError(String(error?.message ?? error)),
	);
	return () => controller.abort();
}

async function read(url, signal, onProgress) {
	const response = await fetch(url, { signal }).catch((error) => {
		// a page has an address that others may be relative to
		if (typeof location === "object" || /^[a-z][a-z\d+.-]*:/i.test(url)) throw error;
		throw new Error("an address has to be absolute here; read the file, and give its bytes to loadBytes()");
	});
	if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
	const total = Number(response.headers.get("content-length") ?? 0);
	if (response.body === null) return new Uint8Array();
	const pieces = [];
	let count = 0;
	for (const reader = response.body.getReader(); ; ) {
		const { done, value } = await reader.read();
		if (done) break;
		pieces.push(value);
		count += value.length;
		onProgress(count, total);
	}
	const bytes = new Uint8Array(count);
	let at = 0;
	for (const piece of pieces) {
		bytes.set(piece, at);
		at += piece.length;
	}
	return bytes;
}

/** Reads bytes from the page's local storage; null if there are none, or no storage. */
export function readLocal(name) {
	return withStorage((storage) => {
		const text = storage.getItem(name);
		return text === null ? null : new ByteArray(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));
	}, null);
}

/** Writes bytes to the page's local storage. Returns whether they are stored. */
export function writeLocal(name, bytes) {
	return withStorage((storage) => {
		storage.setItem(name, btoa(Array.from(bytes.toUint8Array(), (byte) => String.fromCharCode(byte)).join("")));
		return true;
	}, false);
}

/** Removes an entry from the page's local storage. */
export function removeLocal(name) {
	withStorage((storage) => storage.removeItem(name));
}

/**
 * Uses the page's local storage, which may be absent, switched off or full. Node's own storage is shared by all programs of a machine, so it is not
 * used.
 */
function withStorage(use, otherwise) {
	try {
		const storage = typeof document === "object" ? globalThis.localStorage : null;
		return storage ? use(storage) : otherwise;
	} catch {
		return otherwise;
	}
}
