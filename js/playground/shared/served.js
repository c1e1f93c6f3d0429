/**
 * What the page loads from the folder that it is served from. The page in one file has another module in place of this one, which
 * single.mjs writes: the same exports, with the files' content.
 */
export const ICON = "icon.svg";
/** The folder of Blockly's pictures. */
export const MEDIA = "media/";
/** The folder of the documentation; null if it is not there. */
export const DOCS = "docs/";

/** A model's file as text. */
export async function readModel(name) {
	const response = await fetch(`models/${name}.json`);
	if (!response.ok) throw new Error(`${name}.json: ${response.status}`);
	return response.text();
}

/** The bytes of the level's GLB file. */
export async function readLevel() {
	const response = await fetch("models/level.glb");
	if (!response.ok) throw new Error(`level.glb: ${response.status}`);
	return response.arrayBuffer();
}

/** Loads Rapier, 2 MB. It is null where the page does not have it. */
export const loadRapier = () => import("../measure/rapier.js");
