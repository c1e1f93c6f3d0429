/** Values as short texts, for addresses and codes. */
import { toBytes, toText } from "./files.js";

/** Frequent words in programs, for the compressor. */
const WORDS = ["starlogo_", "\"inputs\":{", "\"fields\":{", "{\"block\":{\"type\":\"", "{\"shadow\":{\"type\":\"math_number\",\"fields\":{\"NUM\":", "\"next\":{\"block\":{\"type\":\"", "\"BREED\":\"", "\"WHO\":\"", "\"SHAPE\":\"", "\"COLOUR\":", "\"STEPS\":", "\"DO\":{\"block\":{\"type\":\"", "\"collapsed\":true", "\"DEGREES\":", "\"}},", "}}}"];
const shorten = (text) => WORDS.reduce((all, word, i) => all.replaceAll(word, String.fromCharCode(1 + i)), text);
const lengthen = (text) => WORDS.reduceRight((all, word, i) => all.replaceAll(String.fromCharCode(1 + i), word), text);

/** A program without data that Blockly makes again: ids of blocks, places. */
function bare(value, key) {
	if (Array.isArray(value)) return value.map((each) => bare(each));
	if (value === null || typeof value !== "object") return value;
	const isBlock = "type" in value && key !== "variables";
	return Object.fromEntries(Object.entries(value).filter(([name]) => !(isBlock && ["id", "x", "y"].includes(name)) && name !== "languageVersion")
		.map(([name, each]) => [name, name === "variables" ? each : bare(each, name)]));
}

// A Response would read it in one call. But if it cannot be read, Firefox writes an error on the console.
async function squeezed(text, stream) {
	const parts = [];
	const reader = new Blob([text]).stream().pipeThrough(stream).getReader();
	for (let part = await reader.read(); !part.done; part = await reader.read()) parts.push(part.value);
	return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** A value that has programs in it, or is one, as text for an address. */
export async function packed(value) {
	const bytes = await squeezed(shorten(JSON.stringify(bare(value))), new CompressionStream("deflate-raw"));
	return toText(bytes).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The value in such a text. Throws if there is none. */
export const unpacked = async (text) => JSON.parse(lengthen(new TextDecoder().decode(await squeezed(toBytes(text.replaceAll("-", "+").replaceAll("_", "/")), new DecompressionStream("deflate-raw")))));

/** Whether a value from outside can be a program. */
export const isProgram = (value) => Array.isArray(value?.blocks?.blocks);

/** The mark of files and codes with a pupil's work. */
export const WORK = "starlogo-nova-work";
export const isWork = (value) => value?.kind === WORK;

/** The models in a file: their names, and their own files as text. */
export const modelsOf = (value) => Object.fromEntries(Object.entries(value && typeof value === "object" ? value : {}).filter(([, text]) => typeof text === "string"));
