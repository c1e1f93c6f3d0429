/** The user's programs, as the browser keeps them. */
import { recallValue, rememberValue } from "../../shared/files/memory.js";
import { isProgram } from "../../shared/files/packing.js";

const KEY = "starlogo-playground.programs";
/** The key for the last program, from a release in which programs had no names. */
const OLD_KEY = "starlogo-playground.program";

/**
 * The programs of the browser's user, each {id, name, program, lesson, changed}. Another tab may change them too, so they are read again
 * before each change.
 */
export class Shelf {
	/** The programs, if the browser refuses to store them. */
	#unkept = null;

	/** Whether the browser stores the programs. */
	get isKept() {
		return this.#unkept === null;
	}

	get all() {
		return this.#unkept ?? recallValue(KEY) ?? this.#taken();
	}

	/** The program that an earlier release has stored. */
	#taken() {
		const old = recallValue(OLD_KEY);
		return old?.name === "own" && isProgram(old.program) ? [{ id: "own", name: "1", program: old.program, changed: 0 }] : [];
	}

	find(id) {
		return this.all.find((each) => each.id === id) ?? null;
	}

	/** Adds a program, or replaces the one with the same id. */
	put(entry) {
		const { all } = this;
		const at = all.findIndex(({ id }) => id === entry.id);
		if (at < 0) all.push(entry);
		else all[at] = { ...all[at], ...entry };
		this.#write(all);
	}

	remove(id) {
		this.#write(this.all.filter((each) => each.id !== id));
	}

	/** Removes all programs, the memory of the last one, the best times, the cameras and the solutions. */
	forget() {
		this.#write([]);
		for (const part of ["records", "cameras", "solutions"]) rememberValue(`${KEY}.${part}`, {});
		this.last = null;
	}

	/** The seconds of the best victory in a game, or null. */
	recordOf(id) {
		return this.#read("records")[id] ?? null;
	}

	/** Keeps a best time. A program from a link has none, because the next link is another one. */
	putRecord(id, seconds) {
		if (id !== "link") this.#add("records", id, seconds);
	}

	/** The camera that was chosen for a program, or null. A program from a link has none, because the next link is another one. */
	cameraOf(id) {
		return this.#read("cameras")[id] ?? null;
	}

	putCamera(id, camera) {
		if (id !== "link") this.#add("cameras", id, camera);
	}

	/** The programs that did lessons, by the lessons' names. If the lesson's own program did it, only its collision system is kept. */
	get solutions() {
		return this.#read("solutions");
	}

	putSolution(lesson, program) {
		this.#add("solutions", lesson, program);
	}

	/** The id of the program that was open last. */
	get last() {
		return recallValue(`${KEY}.last`);
	}

	set last(id) {
		rememberValue(`${KEY}.last`, id);
	}

	/** What is kept beside the programs, by ids or names. */
	#read(part) {
		return recallValue(`${KEY}.${part}`) ?? {};
	}

	#add(part, id, value) {
		rememberValue(`${KEY}.${part}`, { ...this.#read(part), [id]: value });
	}

	#write(all) {
		this.#unkept = rememberValue(KEY, all) ? null : all;
	}

	/** Calls the listener for changes by other tabs, until the returned function is called. */
	watch(listener) {
		const heard = ({ key }) => {
			if (key === KEY) listener();
		};
		addEventListener("storage", heard);
		return () => removeEventListener("storage", heard);
	}
}
