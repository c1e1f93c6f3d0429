/** Where programs are kept: in the browser, in files, in links. */

const KEY = "starlogo-playground.program";

/** The program kept in the browser, or null. */
export function kept() {
	try {
		return JSON.parse(localStorage.getItem(KEY));
	} catch {
		return null;
	}
}

/** Keeps a program in the browser, where that is allowed. */
export function keep(name, program) {
	try {
		localStorage.setItem(KEY, JSON.stringify({ name, program }));
	} catch {
		// a browser that keeps nothing: files and links are left
	}
}

/** Whether something read from outside may be a program. */
export const isProgram = (value) => Array.isArray(value?.blocks?.blocks);

/** A program as text for an address. */
export async function toLink(program) {
	const bytes = new Uint8Array(await new Response(new Blob([JSON.stringify(program)]).stream().pipeThrough(new CompressionStream("deflate-raw"))).arrayBuffer());
	const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
	return text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The program in such a text; throws if there is none. */
export async function fromLink(text) {
	const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
	const program = JSON.parse(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text());
	if (!isProgram(program)) throw new Error("no program");
	return program;
}

/** Hands a program over as a file. */
export function download(program, name) {
	const url = URL.createObjectURL(new Blob([JSON.stringify(program, null, 1)], { type: "application/json" }));
	const link = document.createElement("a");
	link.href = url;
	link.download = name;
	link.click();
	setTimeout(() => URL.revokeObjectURL(url), 1000);
}
