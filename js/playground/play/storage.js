/** Stores programs: in the browser, each under its own name, in files, and in links. */

const KEY = "starlogo-playground.programs";
/** The key for the last program, from a release in which programs had no names. */
const OLD_KEY = "starlogo-playground.program";

/**
 * The programs of the browser's user, each {id, name, program, picture, changed}. Another tab may change them too, so they are read again
 * before each change.
 */
export class Shelf {
	/** Whether the last change is stored. */
	isKept = true;
	/** The programs, if the browser refuses to store them. */
	#unkept = null;

	get all() {
		return this.#unkept ?? read(KEY) ?? this.#taken();
	}

	/** The program that an earlier release has stored. */
	#taken() {
		const old = read(OLD_KEY);
		return old?.name === "own" && isProgram(old.program) ? [{ id: "own", name: "1", program: old.program, changed: 0 }] : [];
	}

	find(id) {
		return this.all.find((each) => each.id === id) ?? null;
	}

	/** Adds a program, or replaces the one with the same id. */
	put(entry) {
		const { all } = this;
		const at = all.findIndex(({ id }) => id === entry.id);
		if (at < 0) all.push(entry);
		else all[at] = { ...all[at], ...entry };
		this.#write(all);
	}

	remove(id) {
		this.#write(this.all.filter((each) => each.id !== id));
	}

	/** The id of the program that was open last. */
	get last() {
		return read(`${KEY}.last`);
	}

	set last(id) {
		this.#keep(`${KEY}.last`, id);
	}

	#write(all) {
		this.#keep(KEY, all);
		this.#unkept = this.isKept ? null : all;
	}

	#keep(key, value) {
		try {
			localStorage.setItem(key, JSON.stringify(value));
			this.isKept = true;
		} catch {
			this.isKept = false;
		}
	}

	/** Calls the listener for changes by other tabs, until the returned function is called. */
	watch(listener) {
		const heard = ({ key }) => {
			if (key === KEY) listener();
		};
		addEventListener("storage", heard);
		return () => removeEventListener("storage", heard);
	}
}

function read(key) {
	try {
		return JSON.parse(localStorage.getItem(key));
	} catch {
		return null;
	}
}

/** Whether a value from outside can be a program. */
export const isProgram = (value) => Array.isArray(value?.blocks?.blocks);

/** A program without data that Blockly makes again: ids of blocks, places. */
function bare(value, key) {
	if (Array.isArray(value)) return value.map((each) => bare(each));
	if (value === null || typeof value !== "object") return value;
	const isBlock = "type" in value && key !== "variables";
	return Object.fromEntries(Object.entries(value).filter(([name]) => !(isBlock && ["id", "x", "y"].includes(name)) && name !== "languageVersion")
		.map(([name, each]) => [name, name === "variables" ? each : bare(each, name)]));
}

/** Frequent words in links, for the compressor. */
const WORDS = ["starlogo_", "\"inputs\":{", "\"fields\":{", "{\"block\":{\"type\":\"", "{\"shadow\":{\"type\":\"math_number\",\"fields\":{\"NUM\":", "\"next\":{\"block\":{\"type\":\"", "\"BREED\":\"", "\"WHO\":\"", "\"SHAPE\":\"", "\"COLOUR\":", "\"STEPS\":", "\"DO\":{\"block\":{\"type\":\"", "\"collapsed\":true", "\"DEGREES\":", "\"}},", "}}}"];
const shorten = (text) => WORDS.reduce((all, word, i) => all.replaceAll(word, String.fromCharCode(1 + i)), text);
const lengthen = (text) => WORDS.reduceRight((all, word, i) => all.replaceAll(String.fromCharCode(1 + i), word), text);

// A Response would read it in one call. But if it cannot be read, Firefox writes an error on the console.
async function squeezed(text, stream) {
	const parts = [];
	const reader = new Blob([text]).stream().pipeThrough(stream).getReader();
	for (let part = await reader.read(); !part.done; part = await reader.read()) parts.push(part.value);
	return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** A program as text for an address. */
export async function toLink(program) {
	const bytes = await squeezed(shorten(JSON.stringify(bare(program))), new CompressionStream("deflate-raw"));
	const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
	return text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The program in such a text. Throws if there is none. */
export async function fromLink(text) {
	const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
	const program = JSON.parse(lengthen(new TextDecoder().decode(await squeezed(bytes, new DecompressionStream("deflate-raw")))));
	if (!isProgram(program)) throw new Error("no program");
	return program;
}

/**
 * The parts of a program that change its game. Left out are the places of blocks, which ones are folded, and the collision system, which
 * can change during the game.
 */
export const meaning = (program) => JSON.stringify(program, function meant(key, value) {
	return key === "system" || key === "languageVersion" || ("type" in this && ["id", "x", "y", "collapsed"].includes(key)) ? undefined : value;
});

/** A name that is allowed for a file on every system. */
export const fileName = (title) => title.replaceAll(/[\\/:*?"<>|\p{Cc}]+/gu, " ").replaceAll(/\s+/g, " ").trim() || "program";
