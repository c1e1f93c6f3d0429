/** The user's own models, which the browser keeps between visits if it wants to. */
import { contentOf } from "../shared/files.js";
import { parseModel } from "../shared/models.js";
import { texts } from "../shared/language.js";
import { meet } from "./blocks.js";

const words = texts.play;
export const MODEL_FILE = /\.(obj|dae|zae|glb|gltf|stl)$/i;

const [DATABASE, STORE] = ["starlogo-playground", "models"];

/** What a request gives. */
const answer = (request) => new Promise((resolve, reject) => {
	request.onsuccess = () => resolve(request.result);
	request.onerror = () => reject(request.error);
});

/** Does something with all that is kept, and waits until it is so for good. */
async function within(action) {
	const opening = indexedDB.open(DATABASE, 1);
	opening.onupgradeneeded = () => opening.result.createObjectStore(STORE, { keyPath: "name" });
	const database = await answer(opening);
	try {
		const transaction = database.transaction(STORE, "readwrite");
		const ended = new Promise((resolve, reject) => {
			transaction.oncomplete = resolve;
			transaction.onabort = () => reject(transaction.error);
		});
		const [result] = await Promise.all([answer(action(transaction.objectStore(STORE))), ended]);
		return result;
	} finally {
		database.close();
	}
}

export class Models {
	/** Those that this page knows: names and files' contents. */
	#known = new Map();

	/** @param {object} view Play, whose shapes they become */
	constructor(view) {
		this.view = view;
	}

	get names() {
		return [...this.#known.keys()];
	}

	/** Takes what the user has brought before. */
	async takeKept() {
		for (const { name, bytes } of await within((store) => store.getAll()).catch(() => [])) {
			try {
				await this.#take(name, bytes);
			} catch {
				// one that another release can read
			}
		}
	}

	async #take(name, bytes) {
		const { world, models } = this.view;
		const model = await parseModel(name, bytes);
		world.greatLand.addModel(model);
		models.set(name, model);
		meet("SHAPE", name);
		this.#known.set(name, bytes);
	}

	/** Makes what is in a file, and in those that came with it, a shape that agents can have, under a name of its own. */
	async add(file, files) {
		let bytes;
		try {
			bytes = await contentOf(file, files);
		} catch (error) {
			this.view.say(words.brokenModel(error.message), true);
			return;
		}
		let name = this.#nameOf(bytes);
		if (name === null) {
			const title = file.name.replace(MODEL_FILE, "");
			name = title;
			for (let number = 2; this.view.models.has(name); number++) name = words.another(title, number);
			try {
				await this.#take(name, bytes);
			} catch (error) {
				this.view.say(words.brokenModel(error.message), true);
				return;
			}
		}
		await this.#keep(name, bytes);
	}

	/** What a file is called that was brought before, or null. */
	#nameOf(bytes) {
		const [name] = [...this.#known].find(([, known]) => known.length === bytes.length && known.every((byte, i) => byte === bytes[i])) ?? [null];
		return name;
	}

	async #keep(name, bytes) {
		this.#known.set(name, bytes);
		try {
			await within((store) => store.put({ name, bytes }));
			this.view.say(words.newShape(name));
		} catch {
			this.view.say(words.newShapeForNow(name), true);
		}
	}

	/** Makes the browser forget one, which can be taken back. */
	async remove(name) {
		const bytes = this.#known.get(name);
		this.#known.delete(name);
		// a browser that keeps nothing has nothing to forget
		await within((store) => store.delete(name)).catch(() => {});
		this.view.offer(texts.gallery.removedModel(name), words.undo, () => this.#keep(name, bytes));
	}
}
