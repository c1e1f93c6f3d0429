/** What JavaScriptCore's shell lacks of a browser. */
globalThis.performance ??= { now: () => Date.now() };
globalThis.process ??= { memoryUsage: () => ({ heapUsed: 0 }), versions: { node: "none" } };
globalThis.console ??= { log: (text) => globalThis.print(text) };

globalThis.TextEncoder ??= class {
	encode(text) {
		return Uint8Array.from(unescape(encodeURIComponent(text)), (letter) => letter.charCodeAt(0));
	}
};

globalThis.TextDecoder ??= class {
	#label;

	constructor(label = "utf-8") {
		this.#label = label;
	}

	decode(bytes) {
		const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
		if (this.#label !== "utf-8") return letters;
		return decodeURIComponent(escape(letters)).replace(/^\ufeff/, "");
	}
};
