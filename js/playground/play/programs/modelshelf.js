/** The user's own models. The browser keeps them between visits, if it can. */
import { MODEL_FILE, contentOf, toBytes, toText } from "../../shared/files/files.js";
import { parseModel } from "../../shared/files/models.js";
import { cabinet } from "../../shared/files/ownmodels.js";
import { texts } from "../../shared/language.js";

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
	async takeKept() {
		for (const { name, bytes } of await cabinet.all()) {
			try {
				await this.#take(name, bytes);
			} catch {
				// another release may be able to read it
			}
		}
	}

	async #take(name, bytes) {
		const { world, models } = this.view;
		const model = await parseModel(name, bytes);
		world.greatLand.addModel(model);
		models.set(name, model);
		const { meet } = await import("../blocks/blocks.js");
		meet("SHAPE", name);
		this.#known.set(name, bytes);
	}

	/** Makes a shape for agents from a file and the files that came with it. Gives it a name that is not in use. */
	async add(file, files) {
		let [bytes, name] = [null, null];
		try {
			bytes = await contentOf(file, files);
			name = this.#nameOf(bytes);
			if (name === null) {
				name = this.#freeName(file.name.replace(MODEL_FILE, ""));
				await this.#take(name, bytes);
			}
		} catch (error) {
			this.view.say(texts.brokenModel(file.name, error.message), true);
			return;
		}
		await this.#keep(name, bytes);
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
		for (const [name, text] of Object.entries(models)) {
			try {
				const bytes = toBytes(text);
				const here = this.#nameOf(bytes) ?? this.#freeName(name);
				if (!this.#known.has(here)) await this.#take(here, bytes);
				await this.#keep(here, bytes);
				names.set(name, here);
			} catch (error) {
				this.view.say(texts.brokenModel(name, error.message), true);
			}
		}
		return JSON.parse(JSON.stringify(program, (key, value) => (key === "SHAPE" ? names.get(value) ?? value : value)));
	}

	/** A name that no shape has. */
	#freeName(title) {
		let name = title;
		for (let number = 2; this.view.models.has(name); number++) name = words.another(title, number);
		return name;
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
