/**
 * What the page loads from the folder that it is served from. The page in one file has another module in place of this one, which
 * single.mjs writes: the same exports, with the files' content.
 */
import { LoadError } from "../language.js";

export const ICON = "icon.svg";
/** The folder of Blockly's pictures. */
export const MEDIA = "media/";
/** The folder of the documentation; null if it is not there. */
export const DOCS = "docs/";

/** The content of a model's file, in one of the forms that a Response gives. */
async function read(file, form) {
	// the browser's own messages are not in the page's language
	const response = await fetch(`models/${file}`).catch(() => null);
	const content = response?.ok ? await response[form]().catch(() => null) : null;
	if (content === null) throw new LoadError(response ? `${file} (${response.status})` : file);
	return content;
}

/** A model's file as text. */
export const readModel = (name) => read(`${name}.json`, "text");

/** The bytes of the level's GLB file. */
export const readLevel = () => read("level.glb", "arrayBuffer");

/** Loads Rapier, 2 MB. It is null where the page does not have it. */
export const loadRapier = () => import("../rapier.js");
