/** The user's own models: those that Play keeps in the browser, and those that a view has opened since the page was loaded. */
import { Cabinet } from "./cabinet.js";
import { contentOf } from "./files.js";
import { texts } from "../language.js";
import { parseModel } from "./models.js";

/** Keeps the names and the files' contents of Play's models. */
export const cabinet = new Cabinet("starlogo-playground", "models", "name");

const opened = new Map();

/** Reads a model file that the user has opened. Other views offer the model too. */
export async function openModel(file, files = [file]) {
	const model = await parseModel(file.name, await contentOf(file, files));
	opened.set(file.name, model);
	return model;
}

/** Offers the model in a file to a view. If it cannot be read, an element says why. Returns whether it can. */
export async function offerFile(view, element, file, files) {
	element.textContent = "";
	try {
		view.offer([[file.name, await openModel(file, files)]]);
		return true;
	} catch (error) {
		element.textContent = `${texts.brokenModel(file.name, error.message)} ${texts.inspect.kinds}`;
		return false;
	}
}

/** All of the user's models, by their names. Play's are read again, because Play may have changed them. */
export async function ownModels() {
	const models = new Map(opened);
	for (const { name, bytes } of await cabinet.all()) {
		// another release may be able to read it
		const model = await parseModel(name, bytes).catch(() => null);
		if (model && !models.has(name)) models.set(name, model);
	}
	return models;
}
