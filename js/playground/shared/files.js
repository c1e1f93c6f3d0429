/** Files of the user's that come together: one is the model, and a glTF file has its data in others. */
import { texts } from "./language.js";

const MODEL = /\.(obj|dae|zae|glb|gltf|stl)$/i;

/** The one of some files that is to be opened. */
export function chiefOf(files) {
	return files.find(({ name }) => MODEL.test(name)) ?? files.find(({ name }) => /\.json$/i.test(name)) ?? files[0];
}

/**
 * A model file's content, with what it has in files beside it put inside; throws an error that names those that are missing.
 *
 * @param {File} file
 * @param {File[]} files those that came with it
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

/** The glTF scene in a file that is text and has buffers, or null: what is no such file, the engine has its own words for. */
function gltfIn(bytes) {
	try {
		const scene = JSON.parse(new TextDecoder().decode(bytes));
		return scene.asset && Array.isArray(scene.buffers) ? scene : null;
	} catch {
		return null;
	}
}

/** A file as an address that holds it. */
async function inPlace(file) {
	const bytes = new Uint8Array(await file.arrayBuffer());
	let text = "";
	for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
	return `data:application/octet-stream;base64,${btoa(text)}`;
}
