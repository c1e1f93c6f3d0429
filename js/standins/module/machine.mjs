/** What the stand-ins for Flash's classes need of the machine: time, frames, files. Nothing of it is looked at before it is needed. */

/** Milliseconds from one frame to the next. */
const FRAME_MS = 1000 / 60;

/** Milliseconds. */
export function now() {
	return performance.now();
}

/** Throws an error that no caller can catch, for whoever listens for such. */
export function uncaught(error) {
	setTimeout(() => {
		throw error;
	});
}

/** The error of an error event that nothing listens for. */
export function unheard(type, text) {
	return new Error(text);
}

/** The list of who listens for frames; frames come while there is anybody. */
export class FrameListeners extends Array {
	#isTicking = false;

	static get [Symbol.species]() {
		return Array;
	}

	push(...listeners) {
		const length = super.push(...listeners);
		this.#tick();
		return length;
	}

	#tick() {
		if (this.#isTicking) return;
		this.#isTicking = true;
		setTimeout(() => {
			this.#isTicking = false;
			for (const listener of [...this]) listener.dispatchEvent(new Event(Event.ENTER_FRAME));
			if (this.length > 0) this.#tick();
		}, FRAME_MS);
	}
}

/** Who listens for frames: EventDispatchers, each once. */
export const frameListeners = /* @__PURE__ */ new FrameListeners();

/** The name of an object's class. */
export function classNameOf(value) {
	return value.constructor.name;
}

/** Fetches a file as fetchFile does, but hands over a ByteArray. */
export function fetchBytes(url, onProgress, onDone, onError) {
	return fetchFile(url, onProgress, (bytes) => onDone(new ByteArray(bytes)), onError);
}

/**
 * Fetches a file.
 *
 * @param url its address
 * @param onProgress called with the bytes that are here and those of all, 0 if that is not known
 * @param onDone called with the bytes, a Uint8Array
 * @param onError called with what is wrong
 * @returns a function that stops it
 */
export function fetchFile(url, onProgress, onDone, onError) {
	const controller = new AbortController();
	read(url, controller.signal, onProgress).then(
		(bytes) => controller.signal.aborted || onDone(bytes),
		(error) => controller.signal.aborted || onError(String(error?.message ?? error)),
	);
	return () => controller.abort();
}

async function read(url, signal, onProgress) {
	const response = await fetch(url, { signal });
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

/** Bytes in the page's local storage; null where there are none, or no storage. */
export function readLocal(name) {
	try {
		const text = localStorageOfPage()?.getItem(name) ?? null;
		return text === null ? null : new ByteArray(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));
	} catch {
		return null;
	}
}

/** Puts bytes into the page's local storage; returns whether they are there now. */
export function writeLocal(name, bytes) {
	try {
		const storage = localStorageOfPage();
		storage?.setItem(name, btoa(Array.from(bytes.toUint8Array(), (byte) => String.fromCharCode(byte)).join("")));
		return storage !== null;
	} catch {
		return false;
	}
}

/** Takes something out of the page's local storage. */
export function removeLocal(name) {
	try {
		localStorageOfPage()?.removeItem(name);
	} catch {
		// it is switched off: nothing is there
	}
}

/** Node's own is for all programs of a machine, and not asked for here. */
function localStorageOfPage() {
	return typeof document === "object" ? globalThis.localStorage : null;
}
