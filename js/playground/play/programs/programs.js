/** Manages which program is open, and what happens to it. The user's own programs are never lost when another one is opened. */
import { CollisionBlocks } from "starlogo-collision";
import { button, fileButton, h } from "../../shared/dom.js";
import { MODEL_FILE } from "../../shared/files/files.js";
import { fixed, learn, texts } from "../../shared/language.js";
import { builtInProgram, isBuiltIn, lessonOf, programOfLesson } from "../builtin/builtin.js";
import { Gallery } from "./gallery.js";
import { downloadProgram, handIn, print, share, showJavascript } from "./sharing.js";
import { LESSON_NAMES, LessonCard } from "./lessoncard.js";
import { menu, menuButton } from "./menu.js";
import { create, program as programOf, size, start } from "../builtin/notation.js";
import { isProgram, isWork, modelsOf } from "../../shared/files/packing.js";
import { Shelf, fromLink, meaning, toLink } from "./storage.js";

const words = texts.play;
/** The program that is opened if the browser remembers none. */
const FIRST = "paintball";
/** The address's argument for the first screen. */
const HOME = "all";
/** Addresses of programs that a teacher has opened begin with this. */
const HANDED = "handed-";
/** The id of one of the user's programs. */
const OWN = /^own-[a-z\d]+-[a-z\d]+$/;
/** A link with a program is longer. */
const LONGEST_NAME = 60;

/** The button that leads to the first screen. Where it has little room, it has only its sign. */
const homeButton = (onclick) => h("button.homeward", { type: "button", "aria-label": texts.gallery.open, title: texts.gallery.open, onclick }, h("span.icon"), h("span", {}, texts.gallery.open));

export class Programs {
	/** The program that is shown: the name of one of the page's, the id of one of the user's, or "link". */
	#name = null;
	#title = "";
	/** The collision system for the program, if it is not the default one. */
	#system = null;
	/** Whether another tab has changed the open program. */
	#isTaken = false;
	/** The lesson that is open, or null. */
	#lesson = null;
	/** The last program that was requested. */
	#asked = null;
	#home = null;
	/** The button that undoes the last deletion. It is no longer offered after another change. */
	#undo = null;
	/** Whether the program that is shown is only there because something has to be: the user has not chosen it. */
	#isStopgap = false;

	/** @param {object} view shows the programs */
	constructor(view) {
		this.view = view;
		this.shelf = new Shelf();
		this.gallery = new Gallery(this);
		this.lessons = new LessonCard((name, isNew) => (name === null ? this.#leaveLesson() : this.choose(programOfLesson(name), true, isNew)), {
			games: () => this.openHome(), change: () => this.choose(FIRST), own: () => this.openNew(),
		});
		this.title = h("input.title", { type: "text", maxlength: 60, "aria-label": words.title, onchange: () => this.#rename() });
		this.kept = h("span.keeping");
		this.keepButton = button(words.keep, () => this.#keep(), { title: words.keepNote });
		this.menu = menu(button(words.new, () => this.openNew()), this.keepButton, button(words.save, () => downloadProgram(this)),
			fileButton(words.open, ".json,.obj,.dae,.glb,.gltf,.stl,.bin", (...files) => this.openFile(...files)),
			button(words.share, () => share(this)), button(words.javascript.title, () => showJavascript(this)), button(words.print, () => print(this)), button(texts.gallery.handIn, () => handIn(this)));
		this.menuButton = menuButton(words.menu, this.menu);
		this.element = h("div.naming", {}, homeButton(() => this.openHome()), this.title, this.kept, this.menuButton, this.menu);
		this.close = this.shelf.watch(() => this.#hearOtherTab());
	}

	/** The present program, with its collision system. */
	get program() {
		return { ...this.view.editor.program, ...(this.#system && { system: this.#system }) };
	}

	/**
	 * Opens the program in an address: one of the page's, one of the user's, or one in a link. Otherwise it opens the last program, or the
	 * first screen.
	 */
	async open(argument) {
		if (argument === this.#name) {
			this.#home?.leave();
			this.view.draw();
			return;
		}
		if (argument === "" || argument === HOME) {
			const isFirst = this.#name === null;
			const isHome = !isFirst || this.isHome(argument);
			if (isFirst) await this.#openLast();
			if (isHome && !this.#home?.element.isConnected) await this.openHome();
		} else if (isBuiltIn(argument) || this.shelf.find(argument)) await this.choose(argument);
		else if (argument.startsWith(HANDED)) await this.#openHanded(argument);
		else await this.#openLink(argument);
	}

	async #openLink(argument) {
		try {
			const { name, lesson, ...program } = await fromLink(argument);
			const title = name ?? words.fromLink;
			const mine = this.shelf.all.find((each) => each.name === title && meaning(each.program) === meaning(program));
			if (mine) this.#show(mine.program, mine.id, title);
			else this.#show(program, "link", title, lesson);
		} catch {
			await this.#openNone(OWN.test(argument) ? words.keptElsewhere : argument.length > LONGEST_NAME ? words.brokenLink : words.noAddress(argument));
		}
	}

	/** Opens a program that a pupil has handed in. */
	async #openHanded(argument) {
		const { handed } = await import("../../shared/files/submissions.js");
		await handed.open();
		const found = handed.at(argument);
		if (!found) return this.#openNone(words.handedElsewhere);
		const { name, lesson, program, models, pupil } = found;
		return this.#show(await this.view.own.bring(program, models), "link", words.handedBy(name, pupil), lesson);
	}

	/** Says what is wrong with an address, and shows the first screen. */
	async #openNone(problem) {
		if (this.#name === null) await this.#openLast();
		this.view.say(problem, true);
		await this.openHome(problem);
	}

	/** The program that will be opened, if it is known already. */
	async first(argument) {
		try {
			if (this.shelf.find(argument)) return this.shelf.find(argument).program;
			if (isBuiltIn(argument)) return await builtInProgram(argument);
			return argument && argument !== HOME ? await fromLink(argument) : (await this.#last()).program;
		} catch {
			return builtInProgram(FIRST);
		}
	}

	/** Whether an address leads to the first screen. */
	isHome(argument) {
		return argument === HOME || (argument === "" && !this.#hasLast);
	}

	get #hasLast() {
		return this.shelf.last !== null || this.shelf.all.length > 0;
	}

	/** The program that was open last, otherwise the paintball game. */
	async #last() {
		const { last, all } = this.shelf;
		const entry = this.shelf.find(last) ?? (last === null ? all.at(-1) : null);
		if (entry && isProgram(entry.program)) return { program: entry.program, name: entry.id };
		const name = last !== null && isBuiltIn(last) ? last : FIRST;
		return { program: await builtInProgram(name), name };
	}

	async #openLast() {
		const isChosen = this.#hasLast;
		const { program, name } = await this.#last();
		// the user has chosen another one meanwhile
		if (this.#asked !== null) return;
		try {
			this.#show(program, name);
		} catch {
			// of another version
			this.#show(await builtInProgram(FIRST), FIRST);
		}
		this.#isStopgap = !isChosen;
	}

	/** Shows a program. If it is none, it throws, and the old one stays. It may come with a lesson that it belongs to. */
	#show(program, name, title = this.#titleOf(name), lesson = null) {
		const { view } = this;
		const isFirst = this.#name === null || (this.#isStopgap && view.world.frame === 0);
		const before = isFirst ? null : { program: this.program, name: this.#name, title: this.#title, lesson: this.#lesson };
		view.editor.show(program, isBuiltIn(name) || name === "link");
		if (this.#name !== null || this.#asked !== null) this.#home?.leave();
		this.#isStopgap = false;
		this.#name = name;
		this.#isTaken = false;
		this.#system = CollisionBlocks.systemNames.includes(program.system) ? program.system : null;
		// a program made from a lesson's program still belongs to the lesson
		this.#lesson = lessonOf(name) ?? this.shelf.find(name)?.lesson ?? (LESSON_NAMES.includes(lesson) ? lesson : null);
		this.lessons.show(this.#lesson, this.shelf.find(name) !== null);
		this.#showTitle(title);
		view.begin();
		view.lookAt(program, this.shelf.cameraOf(name));
		if (before && !view.isBroken && view.world.agents.length > 0) {
			if (before.name === name) view.say(words.opened(title));
			else view.offer(words.opened(title), words.backTo(before.title), () => this.#goBackTo(before));
		}
	}

	/** Opens the program that another one has replaced, unchanged. */
	#goBackTo({ program, name, title, lesson }) {
		this.#show(program, name, title, lesson);
		if (name !== "link") this.shelf.last = name;
		this.#setAddress(name);
	}

	#titleOf(name) {
		return words.games[name] ?? words.examples[name] ?? texts.lessons.list[lessonOf(name)]?.title ?? this.shelf.find(name)?.name ?? words.fromLink;
	}

	#showTitle(title) {
		this.#title = title;
		this.title.value = this.title.title = title;
		const isOwn = this.shelf.find(this.#name) !== null;
		this.kept.className = isOwn ? "keeping kept" : "keeping";
		this.kept.textContent = !isOwn ? "" : this.shelf.isKept ? words.kept : words.keptNowhere;
		this.keepButton.disabled = isOwn;
	}

	/** Renames the program and keeps it under the new name. */
	#rename() {
		const title = this.title.value.trim();
		if (title === "" || title === this.#title) this.title.value = this.#title;
		else if (this.shelf.find(this.#name)) {
			this.shelf.put({ id: this.#name, name: title });
			this.#showTitle(title);
		} else this.#putNew(title);
	}

	#keep() {
		this.#putNew(this.#name === "link" ? this.#title : words.copyOf(this.#title));
		this.title.focus();
	}

	/** Puts the open program's name into the address. */
	#setAddress(name, isStep = false) {
		const hash = `#play/${name}`;
		if (name === "link" || location.hash === hash) return;
		if (isStep) history.pushState(null, "", hash);
		else history.replaceState(null, "", hash);
	}

	/** Opens the first screen: all programs and lessons, with pictures. It may say why it is shown. */
	async openHome(note = "") {
		if (this.view.isRunning) this.view.stop();
		const [{ Home }] = await Promise.all([import("./home.js"), learn("game")]);
		this.#home?.leave();
		this.#home = new Home(this, this.view.layout.main, note);
	}

	/** Called when a game is won. The page's own games get a tick. Returns what there is to say about the best time. */
	win(seconds) {
		if (Object.hasOwn(words.games, this.#name)) this.lessons.win(this.#name);
		const { record } = this;
		if (record !== null && record <= seconds) return words.best(fixed(record, 1));
		this.shelf.putRecord(this.#name, seconds);
		return record === null ? "" : words.newBest;
	}

	/** Called when a game has done its lesson. Keeps what did it, for the teacher. */
	async solved(game) {
		const { system = CollisionBlocks.TIGHTEST_FITS } = this.program;
		const own = meaning(await builtInProgram(programOfLesson(this.#lesson)));
		this.shelf.putSolution(this.#lesson, game === own ? { system } : { ...JSON.parse(game), system });
	}

	/** Keeps the camera that the user has chosen for the open program. */
	keepCamera(camera) {
		this.shelf.putCamera(this.#name, camera);
	}

	/** The seconds of the best victory in the open game, or null. */
	get record() {
		return this.shelf.recordOf(this.#name);
	}

	/** Renames one of the user's programs. */
	rename(id, name) {
		if (this.shelf.find(id)) this.shelf.put({ id, name });
		if (id === this.#name) this.#showTitle(name);
	}

	/** Deletes one of the user's programs. This can be undone. */
	async remove(id) {
		const entry = this.shelf.find(id);
		this.shelf.remove(id);
		if (this.#name === id) await this.choose(FIRST);
		// another tab may have removed it before
		if (entry) this.view.offer(texts.gallery.removed(entry.name), words.undo, () => {
			this.shelf.put(entry);
			this.choose(id);
		});
	}

	/**
	 * Opens one of the page's or the user's programs.
	 *
	 * @param {string} asked its name, or its id
	 * @param {boolean} isRead whether the focus goes to its lesson
	 * @param {boolean} isNew whether a lesson is opened as it was in the beginning, and not as the user has changed it
	 */
	async choose(asked, isRead = false, isNew = false) {
		const name = isNew ? asked : this.#ownOf(asked);
		this.#asked = name;
		await this.view.editing;
		const program = this.shelf.find(name)?.program ?? await builtInProgram(name);
		if (this.#asked !== name) return;
		try {
			this.#show(program, name);
			this.shelf.last = name;
			this.#setAddress(name, true);
			if (isRead) this.lessons.focus();
		} catch {
			this.view.say(words.brokenProgram, true);
		}
	}

	/** What the user has made of a lesson's program last, or else the lesson's program itself. */
	#ownOf(name) {
		const lesson = lessonOf(name);
		const own = lesson === null ? [] : this.shelf.all.filter((each) => each.lesson === lesson && isProgram(each.program));
		return own.sort((a, b) => b.changed - a.changed)[0]?.id ?? name;
	}

	/** Opens a new program of the user's, with one agent. */
	async openNew() {
		await this.view.editing;
		this.openAsNew(programOf(start(create(1, "bears", "bear", size(1.4)))), words.newName);
		this.title.focus();
		this.title.select();
	}

	/** Leaves the lesson. The program stays. */
	#leaveLesson() {
		this.#lesson = null;
		if (this.shelf.find(this.#name)) this.shelf.put({ id: this.#name, lesson: null });
		this.lessons.show(null);
		this.title.focus();
	}

	/** Plays the program with another collision system. If the program has a block for that, the block changes too. */
	useSystem(name) {
		const { editor } = this.view;
		if (editor.system !== null) {
			editor.system = name;
			this.view.say(words.systemOfBlock(texts.inSentence(texts.systems[name])));
			return;
		}
		this.#system = name === CollisionBlocks.TIGHTEST_FITS ? null : name;
		this.#put();
	}

	#put() {
		if (this.shelf.find(this.#name) && !this.#isTaken) this.shelf.put({ id: this.#name, program: this.program, changed: Date.now() });
	}

	/**
	 * Called when the user has changed the program. A changed example, or a program from a link, becomes one of the user's with its own name.
	 *
	 * @param {number} deleted the number of blocks that the change deleted
	 */
	changed(deleted) {
		const { view } = this;
		if (!this.shelf.find(this.#name) || this.#isTaken) this.#putNew(this.#name === "link" ? this.#title : words.copyOf(this.#title));
		else this.#put();
		if (!view.isRunning && view.isStale) view.showBeginning();
		view.showRun();
		if (!this.shelf.isKept) view.say(words.notKept, true);
		else if (view.isRunning && view.isStale) view.say(words.stale);
		else if (deleted > 0 && !view.isRunning) this.#undo = view.offer(words.deleted(deleted), words.undo, () => {
			view.editor.undo();
			view.say(words.ready);
		});
		else if (this.#undo?.isConnected) view.say(words.ready);
	}

	/** Keeps the program as a new one of the user's, under a new name. */
	#putNew(title) {
		const names = new Set(this.shelf.all.map(({ name }) => name));
		let name = title;
		for (let number = 2; names.has(name); number++) name = words.another(title, number);
		const id = `own-${Date.now().toString(36)}-${Math.floor(Math.random() * 1e6).toString(36)}`;
		this.shelf.put({ id, name, program: this.program, lesson: this.#lesson, changed: Date.now() });
		this.shelf.last = id;
		this.shelf.putCamera(id, this.shelf.cameraOf(this.#name));
		this.#name = id;
		this.#isTaken = false;
		this.lessons.isOwn = true;
		this.#showTitle(name);
		// the kept program counts from now on, not the link
		this.#setAddress(id);
		return name;
	}

	#hearOtherTab() {
		const entry = this.shelf.find(this.#name);
		if (this.#isTaken || this.#name === null || this.#name === "link" || isBuiltIn(this.#name)) return;
		if (entry && JSON.stringify(entry.program) === JSON.stringify(this.program)) return;
		this.#isTaken = true;
		this.view.say(words.elsewhere(entry?.name ?? this.#title));
	}

	/** Opens a program, or adds a model as a shape for agents. */
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
			const { name, lesson, models, ...program } = JSON.parse(await file.text());
			if (isWork(program)) {
				this.view.say(words.isWork(file.name), true);
				return;
			}
			if (!isProgram(program)) throw new Error("no program");
			this.openAsNew(await this.view.own.bring(program, modelsOf(models)), name ?? file.name.replace(/\.json$/i, ""), lesson);
		} catch {
			this.view.say(words.brokenProgram, true);
		}
	}

	/** Opens a program as a new one of the user's. Throws if it is none. */
	openAsNew(program, title, lesson = null) {
		this.#asked = title;
		this.#show(program, "link", title, lesson);
		const name = this.#putNew(title);
		const [, back] = this.view.layout.status.childNodes;
		if (back) this.view.layout.status.firstChild.textContent = words.opened(name);
		if (!this.shelf.isKept) this.view.say(words.notKept, true);
	}

	/** The open program with its name and its lesson, for a file or a link. */
	get whole() {
		return { name: this.#title, ...(this.#lesson && { lesson: this.#lesson }), ...this.program };
	}

	/** The address's argument for the open program: its name or id, or the program itself if it came in a link. */
	async address() {
		return this.#name === "link" ? toLink(this.whole) : this.#name;
	}
}
