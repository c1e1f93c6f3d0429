/** Files that the user gives together: one is the model, and a glTF file may need others. */
import { texts } from "../language.js";

export const MODEL_FILE = /\.(obj|dae|glb|gltf|stl)$/i;

/** Bytes as text, with the letters of base 64. */
export function toText(bytes) {
	let text = "";
	for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
	return btoa(text);
}

export const toBytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));

/** The main file among some files. */
export function mainFileOf(files) {
	return files.find(({ name }) => MODEL_FILE.test(name)) ?? files.find(({ name }) => /\.json$/i.test(name)) ?? files[0];
}

/**
 * The content of a model file. Data from other files are put inside. Throws an error that names missing files.
 *
 * @param {File} file
 * @param {File[]} files the files that came with it
 */
export async function contentOf(file, files) {
	const bytes = new Uint8Array(await file.arrayBuffer());
	const scene = gltfIn(bytes);
	if (!scene) return bytes;
	const missing = [];
	for (const buffer of scene.buffers) {
		if (typeof buffer?.uri !== "string" || /^[a-z][a-z0-9+.-]*:/i.test(buffer.uri)) continue;
		const name = decodeURIComponent(buffer.uri).split("/").at(-1);
		const other = files.find((each) => each.name === name);
		if (other) buffer.uri = await inPlace(other);
		else missing.push(name);
	}
	if (missing.length > 0) throw new Error(texts.needsFiles(file.name, missing.join(", ")));
	return new TextEncoder().encode(JSON.stringify(scene));
}

/** The glTF scene in a text file with buffers, or null. The engine itself reports other problems. */
function gltfIn(bytes) {
	try {
		const scene = JSON.parse(new TextDecoder().decode(bytes));
		return scene.asset && Array.isArray(scene.buffers) ? scene : null;
	} catch {
		return null;
	}
}

/** A data address with a file's content. */
const inPlace = async (file) => `data:application/octet-stream;base64,${toText(new Uint8Array(await file.arrayBuffer()))}`;
