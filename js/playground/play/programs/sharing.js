/** Gives the open program away: as a file, a link, a module, a page to print; or all of the user's work to a teacher. */
import { copyLink } from "../../shared/copying.js";
import { download } from "../../shared/files/download.js";
import { loadWords, texts } from "../../shared/language.js";
import { fileName, toLink } from "./programtext.js";

const words = texts.play;

/** Saves the program as a file, with the user's own models in it. */
export function downloadProgram({ view, whole }) {
	const models = view.modelShelf.filesFor(whole);
	download(JSON.stringify({ ...whole, ...(Object.keys(models).length > 0 && { models }) }, null, 1), `${fileName(whole.name)}.json`, "application/json");
}

/** Copies a link to the program. If the browser refuses, the link is shown. */
export async function share({ view, whole }) {
	const place = await copyLink(`play/${await toLink(whole)}`);
	const models = Object.keys(view.modelShelf.filesFor(whole));
	const but = location.protocol === "file:" ? ` ${words.sharedFile}` : models.length > 0 ? ` ${words.sharedWithout(models.join(", "))}` : "";
	if (place === null) return view.say(words.shared + but);
	view.say(words.sharedHere, false, place, but);
	return place.select();
}

/** Shows the program as a module of JavaScript. */
export async function showJavascript({ program, view, whole: { name } }) {
	const developer = await import("../export/developer.js");
	developer.showJavascript(program, name, fileName(name), view.models);
}

/** Opens a page that prints the program. */
export async function print(programs) {
	location.hash = `teach/${await programs.address()}`;
}

const dialogs = () => loadWords("class").then(() => import("./handin.js"));

/** Opens the dialog that hands in all of the user's work. */
export const handIn = async (programs) => (await dialogs()).handIn(programs);

/** Opens the dialog that makes the browser forget this pupil. */
export const nextPupil = async (programs) => (await dialogs()).nextPupil(programs);
