/** Which program is open, and what becomes of it: the user's own are never lost, whatever is opened in their place. */
import { button, h } from "../shared/dom.js";
import { texts } from "../shared/language.js";
import { EXAMPLES } from "./examples.js";
import { MODEL_FILE } from "./kept.js";
import { LessonCard } from "./lessoncard.js";
import { LESSONS, LESSON_NAMES } from "./lessons.js";
import { create, program as programOf, size, start } from "./notation.js";
import { Shelf, fromLink, isProgram, toLink } from "./storage.js";

const words = texts.play;
/** What the gallery's names of models begin with. */
const MODEL = "model ";

/** The programs that the page brings, by their names; those of lessons begin as addresses do. */
const BROUGHT = { ...EXAMPLES, ...Object.fromEntries(LESSON_NAMES.map((name) => [`lesson-${name}`, LESSONS[name].program])) };

export class Programs {
	/** Which program is shown: an example's name, the id of one of the user's, or "link". */
	#name = "paintball";
	#isShown = false;
	/** What was there before the program that replaced it. */
	#replaced = null;
	/** Whether another tab has changed the program that is open. */
	#isTaken = false;
	/** The lesson that is open, or null. */
	#lesson = null;

	/** @param {object} view whose programs they are */
	constructor(view) {
		this.view = view;
		this.shelf = new Shelf();
		this.menu = h("select", { onchange: () => this.choose(this.menu.value) });
		this.undoButton = button(words.undo, () => this.undo(), { hidden: true });
		this.lessons = new LessonCard((name) => this.choose(name === null ? "paintball" : `lesson-${name}`));
		this.close = this.shelf.watch(() => this.#hearOtherTab());
	}

	/** Opens the program of a link, or one that the page brings, by its name (lesson-helmet); without one, that which was open last, or else the paintball game. */
	async open(link) {
		if (link in BROUGHT) {
			this.#show(BROUGHT[link], link);
			return;
		}
		if (link) {
			try {
				this.#show(await fromLink(link), "link");
				return;
			} catch {
				this.#openLast();
				this.view.say(words.brokenLink, true);
				return;
			}
		}
		this.#openLast();
	}

	/** The program that will be opened, as far as that is known. */
	async first(link) {
		try {
			return link in BROUGHT ? BROUGHT[link] : link ? await fromLink(link) : this.#last().program;
		} catch {
			return EXAMPLES.paintball;
		}
	}

	/** What was open last, or else the paintball game. */
	#last() {
		const { last, all } = this.shelf;
		const entry = this.shelf.find(last) ?? (last === null ? all.at(-1) : null);
		if (entry && isProgram(entry.program)) return { program: entry.program, name: entry.id };
		return last in BROUGHT ? { program: BROUGHT[last], name: last } : { program: EXAMPLES.paintball, name: "paintball" };
	}

	#openLast() {
		const { program, name } = this.#last();
		try {
			this.#show(program, name);
		} catch {
			// one of another version
			this.#show(EXAMPLES.paintball, "paintball");
		}
	}

	/** Shows a program; throws if it is none, and leaves what was there. */
	#show(program, name) {
		const before = !this.#isShown ? null : { program: this.view.editor.program, name: this.#name };
		this.view.editor.show(program, name in BROUGHT || name === "link");
		this.#isShown = true;
		this.#replaced = before;
		this.#offerUndo();
		this.#name = name;
		this.#isTaken = false;
		// what is made of a lesson's program is in the lesson
		this.#lesson = lessonOf(name) ?? this.shelf.find(name)?.lesson ?? null;
		this.lessons.show(this.#lesson);
		if (name !== "link") this.shelf.last = name;
		this.#listPrograms();
		this.view.reset();
		this.view.lookAt(program);
		if (before) this.#sayOpened();
	}

	#sayOpened() {
		if (!this.view.isBroken && this.view.world.agents.length > 0) this.view.say(words.opened(this.#title(this.#name)));
	}

	/** Takes back the last change of blocks, or, where there was none, what replaced a program. */
	undo() {
		const { editor } = this.view;
		if (editor.canUndo) editor.undo();
		else {
			const { program, name } = this.#replaced;
			this.#show(program, name);
			this.#replaced = null;
		}
		this.#offerUndo();
	}

	#offerUndo() {
		this.undoButton.hidden = this.#replaced === null && !this.view.editor.canUndo;
	}

	#title(name) {
		return words.examples[name] ?? texts.lessons.list[lessonOf(name)]?.title ?? this.shelf.find(name)?.name ?? words.fromLink;
	}

	async openGallery() {
		if (this.view.isRunning) this.view.stop();
		const { openGallery } = await import("./gallery.js");
		const { own } = this.view;
		const modelOf = (id) => (id.startsWith(MODEL) ? id.slice(MODEL.length) : null);
		const showing = (shape) => programOf(start(create(1, "turtles", shape, size(3))));
		const find = (id) => (modelOf(id) === null ? this.shelf.find(id)?.program ?? BROUGHT[id] : showing(modelOf(id)));
		openGallery([
			{ title: texts.gallery.own, canRename: true, canRemove: true, entries: this.shelf.all.map(({ id, name }) => ({ id, name })) },
			...(own.names.length > 0 ? [{ title: texts.gallery.models, canRemove: true, entries: own.names.map((name) => ({ id: MODEL + name, name })) }] : []),
			{ title: words.brought, entries: Object.entries(words.examples).map(([id, name]) => ({ id, name })) },
			{ title: texts.gallery.lessons, entries: LESSON_NAMES.map((name) => ({ id: `lesson-${name}`, name: texts.lessons.list[name].title, isDone: this.lessons.isDone(name) })) },
		], {
			picture: (id) => this.view.pictureOf(find(id)),
			open: (id) => (modelOf(id) === null ? this.choose(id) : this.#open(find(id), modelOf(id))),
			rename: (id, name) => {
				this.shelf.put({ id, name });
				this.#listPrograms();
			},
			remove: (id) => (modelOf(id) === null ? this.#remove(id) : own.remove(modelOf(id))),
		});
		this.view.draw();
	}

	/** Deletes a program of the user's; it can be taken back. */
	#remove(id) {
		const entry = this.shelf.find(id);
		this.shelf.remove(id);
		if (this.#name === id) this.choose("paintball");
		this.#listPrograms();
		this.view.offer(texts.gallery.removed(entry.name), words.undo, () => {
			this.shelf.put(entry);
			this.choose(id);
		});
	}

	#listPrograms() {
		const group = (label, entries) => (entries.length > 0 ? [h("optgroup", { label }, ...entries.map(([value, text]) => h("option", { value, selected: value === this.#name }, text)))] : []);
		this.menu.replaceChildren(
			...(this.#name === "link" ? [h("option", { value: "link", selected: true }, words.fromLink)] : []),
			...group(words.own, this.shelf.all.map(({ id, name }) => [id, name])),
			...group(words.brought, Object.entries(words.examples)),
			...group(texts.gallery.lessons, LESSON_NAMES.map((name) => [`lesson-${name}`, texts.lessons.list[name].title])));
	}

	choose(name) {
		const entry = this.shelf.find(name);
		try {
			this.#show(entry?.program ?? BROUGHT[name], name);
		} catch {
			this.#listPrograms();
			this.view.say(words.brokenProgram, true);
		}
	}

	/** What the user changes is the user's: an example, and what a link brought, becomes a program with a name of its own. */
	changed(isDeletion) {
		this.#offerUndo();
		if (!this.shelf.find(this.#name) || this.#isTaken) {
			const title = words.copyOf(this.#title(this.#name));
			this.#name = this.#putNew(title, this.view.editor.program);
			this.#isTaken = false;
			// what is kept counts from now on, not what a link brought
			if (location.hash.includes("/")) history.replaceState(null, "", "#play");
		} else {
			this.shelf.put({ id: this.#name, program: this.view.editor.program, changed: Date.now() });
		}
		if (!this.shelf.isKept) this.view.say(words.notKept, true);
		else if (this.view.isRunning && this.view.isStale) this.view.offer(words.stale, words.startAnew, () => {
			this.view.reset();
			this.view.run();
		});
		else if (isDeletion && !this.view.isRunning) this.view.offer(words.deleted, words.undo, () => {
			this.view.editor.undo();
			this.view.say(words.ready);
		});
	}

	/** A program of the user's under a name that no other has; its id. */
	#putNew(title, program) {
		const names = new Set(this.shelf.all.map(({ name }) => name));
		let name = title;
		for (let number = 2; names.has(name); number++) name = words.another(title, number);
		const id = `own-${Date.now().toString(36)}-${Math.floor(Math.random() * 1e6).toString(36)}`;
		this.shelf.put({ id, name, program, lesson: this.#lesson, changed: Date.now() });
		this.shelf.last = id;
		this.#name = id;
		this.#listPrograms();
		return id;
	}

	#hearOtherTab() {
		const entry = this.shelf.find(this.#name);
		this.#listPrograms();
		if (this.#isTaken || this.#name in BROUGHT || this.#name === "link") return;
		if (entry && JSON.stringify(entry.program) === JSON.stringify(this.view.editor.program)) return;
		this.#isTaken = true;
		this.view.say(words.elsewhere(entry?.name ?? this.menu.selectedOptions[0]?.textContent ?? ""));
	}

	/** Opens a program, or makes a model a shape that agents can have. */
	async openFile(file, files = [file]) {
		if (MODEL_FILE.test(file.name)) {
			await this.view.own.add(file, files);
			return;
		}
		if (!/\.json$/i.test(file.name)) {
			this.view.say(words.wrongFile(file.name), true);
			return;
		}
		try {
			const program = JSON.parse(await file.text());
			if (!isProgram(program)) throw new Error("no program");
			this.#open(program, file.name.replace(/\.json$/i, ""));
		} catch {
			this.view.say(words.brokenProgram, true);
		}
	}

	/** Opens a program as one more of the user's; throws if it is none. */
	#open(program, title) {
		const before = this.#name;
		this.#show(program, "link");
		const replaced = this.#replaced;
		this.#putNew(title, this.view.editor.program);
		this.#replaced = replaced ?? { program: BROUGHT[before], name: before };
		this.#offerUndo();
		this.#sayOpened();
		if (!this.shelf.isKept) this.view.say(words.notKept, true);
	}

	async share() {
		const address = new URL(location.href);
		address.hash = `play/${await toLink(this.view.editor.program)}`;
		history.replaceState(null, "", address);
		try {
			await navigator.clipboard.writeText(address.href);
			this.view.say(words.shared);
		} catch {
			this.view.say(words.sharedHere);
		}
	}
}

/** The lesson that a program of the page is of, or null. */
const lessonOf = (name) => (/^lesson-/.test(name) ? name.slice(7) : null);
