/** The user's own models. The browser keeps them between visits, if it can. */
import { MODEL_FILE, contentOf, toBytes, toText } from "../../shared/files/files.js";
import { parseModel } from "../../shared/files/models.js";
import { cabinet } from "../../shared/files/ownmodels.js";
import { texts } from "../../shared/language.js";
import { freeName } from "./programtext.js";

const words = texts.play;

export class ModelShelf {
	/** The models of this page: names and files' contents. */
	#known = new Map();

	/** @param {object} view Play, which gets their shapes */
	constructor(view) {
		this.view = view;
	}

	/** The files of all models that the browser keeps, as text. */
	static async kept() {
		const all = await cabinet.all();
		return Object.fromEntries(all.map(({ name, bytes }) => [name, toText(bytes)]));
	}

	get names() {
		return [...this.#known.keys()];
	}

	/** Loads the models of earlier visits. */
	async loadKept() {
		for (const { name, bytes } of await cabinet.all()) {
			try {
				await this.#register(name, bytes);
			} catch {
				// another release may be able to read it
			}
		}
	}

	async #register(name, bytes) {
		const { world, models } = this.view;
		const model = await parseModel(name, bytes);
		world.greatLand.addModel(model);
		models.set(name, model);
		const { addToMenu } = await import("../blocks/blocks.js");
		addToMenu("SHAPE", name);
		this.#known.set(name, bytes);
	}

	/** Makes a shape for agents from a file and the files that came with it. Gives it a name that is not in use. */
	async add(file, files) {
		await this.#addAs(file.name.replace(MODEL_FILE, ""), file.name, () => contentOf(file, files));
	}

	/** Adds a model under the name that its content has here already, or under a free one. Returns the name. If it cannot be read, says why, and returns null. */
	async #addAs(title, fileName, read) {
		try {
			const bytes = await read();
			const name = this.#nameOf(bytes) ?? freeName(title, (name) => this.view.models.has(name));
			if (!this.#known.has(name)) await this.#register(name, bytes);
			await this.#keep(name, bytes);
			return name;
		} catch (error) {
			this.view.say(texts.brokenModel(fileName, error.message), true);
			return null;
		}
	}

	/** The user's own models in a program: their names and their files as text. */
	filesFor(program) {
		const found = {};
		JSON.stringify(program, (key, value) => {
			if (key === "SHAPE" && this.#known.has(value)) found[value] = toText(this.#known.get(value));
			return value;
		});
		return found;
	}

	/**
	 * Takes the models that came with a program.
	 *
	 * @param {object} program
	 * @param {Record<string, string>} models by their names, their files as text
	 * @returns {Promise<object>} the program with the names that the models have here
	 */
	async bring(program, models) {
		const names = new Map();
		for (const [name, text] of Object.entries(models)) names.set(name, await this.#addAs(name, name, () => toBytes(text)) ?? name);
		return JSON.parse(JSON.stringify(program, (key, value) => (key === "SHAPE" ? names.get(value) ?? value : value)));
	}

	/** The name of a file that was added before, or null. */
	#nameOf(bytes) {
		const [name] = [...this.#known].find(([, known]) => known.length === bytes.length && known.every((byte, i) => byte === bytes[i])) ?? [null];
		return name;
	}

	async #keep(name, bytes) {
		this.#known.set(name, bytes);
		try {
			await cabinet.within((store) => store.put({ name, bytes }));
			this.view.say(words.newShape(name));
		} catch {
			this.view.say(words.newShapeForNow(name), true);
		}
	}

	/** Makes the browser forget all models. */
	forgetAll() {
		return cabinet.within((store) => store.clear()).catch(() => {});
	}

	/** Makes the browser forget a model. This can be undone. */
	async remove(name) {
		const bytes = this.#known.get(name);
		this.#known.delete(name);
		// a browser without storage has nothing to forget
		await cabinet.within((store) => store.delete(name)).catch(() => {});
		this.view.offer(texts.gallery.removedModel(name), words.undo, () => this.#keep(name, bytes));
	}
}
