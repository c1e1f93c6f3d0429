/** What is on the first screen: all programs and lessons, and models of the user's own. */
import { texts } from "../../shared/language.js";
import { builtInProgram, lessonOf, programOfLesson } from "../builtin/builtin.js";
import { LESSON_NAMES } from "../builtin/names.js";
import { create, program, size, start } from "../builtin/notation.js";

const words = texts.play;
/** The ids of models have this prefix. */
const MODEL = "model ";
const modelOf = (id) => (id.startsWith(MODEL) ? id.slice(MODEL.length) : null);

export class Gallery {
	/** @param {import("./programs.js").Programs} programs */
	constructor(programs) {
		this.programs = programs;
	}

	/** Groups of entries, and what the user can do with them. */
	get groups() {
		const { progress, shelf, view: { modelShelf } } = this.programs;
		const named = (table) => Object.entries(table).map(([id, name]) => ({ id, name }));
		const next = LESSON_NAMES.find((name) => !progress.isDone(name));
		return [
			{ title: texts.gallery.lessons, isNumbered: true, entries: LESSON_NAMES.map((name) => ({ id: programOfLesson(name), name: texts.lessons.list[name].title, isDone: progress.isDone(name), isNext: name === next })) },
			{ title: texts.gallery.games, isNumbered: true, entries: Object.entries(words.games).map(([id, name]) => ({ id, name, note: texts.programs[id].goal, isDone: progress.isWon(id) })) },
			{ title: texts.gallery.own, canRename: true, canRemove: true, canAdd: true, entries: shelf.all.map(({ id, name }) => ({ id, name })) },
			...(modelShelf.names.length > 0 ? [{ title: texts.gallery.models, canRemove: true, entries: modelShelf.names.map((name) => ({ id: MODEL + name, name })) }] : []),
			{ title: words.brought, entries: named(words.examples) },
		];
	}

	/** The program of an entry. That of a model shows it. */
	async programOf(id) {
		const model = modelOf(id);
		if (model !== null) return program(start(create(1, "turtles", model, size(3))));
		return this.programs.shelf.find(id)?.program ?? builtInProgram(id);
	}

	async open(id) {
		const model = modelOf(id);
		if (model !== null) await this.programs.openAsNew(await this.programOf(id), model);
		else await this.programs.choose(id, lessonOf(id) !== null);
	}

	remove(id) {
		const model = modelOf(id);
		return model === null ? this.programs.remove(id) : this.programs.view.modelShelf.remove(model);
	}
}
