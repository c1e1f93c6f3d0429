/** Manages which program is open, and what happens to it. The user's own programs are never lost when another one is opened. */
import { CollisionBlocks } from "starlogo-collision";
import { button, fileButton, h } from "../../shared/dom.js";
import { MODEL_FILE } from "../../shared/files/files.js";
import { fixed, loadWords, texts } from "../../shared/language.js";
import { builtInProgram, isBuiltIn, programOfLesson } from "../builtin/builtin.js";
import { LESSON_NAMES } from "../builtin/names.js";
import { AddressError, FIRST, Finder } from "./finder.js";
import { Gallery } from "./gallery.js";
import { downloadProgram, handIn, print, share, showJavascript } from "./sharing.js";
import { LessonCard } from "./lessoncard.js";
import { menu, menuButton } from "./menu.js";
import { create, program as programOf, size, start } from "../builtin/notation.js";
import { isProgram, isWork, modelsOf } from "../../shared/files/packing.js";
import { Requests } from "../../shared/requests.js";
import { freeName, meaning, toLink } from "./programtext.js";
import { Progress } from "./progress.js";
import { Shelf } from "./shelf.js";

const words = texts.play;

/** The button that leads to the first screen. Where it has little room, it has only its sign. */
const homeButton = (onclick) => h("button.homeward", { type: "button", "aria-label": texts.gallery.open, title: texts.gallery.open, onclick }, h("span.icon"), h("span", {}, texts.gallery.open));

export class Programs {
	/**
	 * The program that is shown, or null: {name, title, system, lesson, isChangedElsewhere, isStopgap}. Its name is the name of one of the page's, the id of
	 * one of the user's, or "link". The system is null if it is the default one, and so is the lesson if none is open. It is changed elsewhere if another
	 * tab has done so, and a stopgap if it is only there because something has to be: the user has not chosen it.
	 */
	#open = null;
	#requests = new Requests();
	/** Tells whether no program has been requested yet. */
	#isUnasked = this.#requests.begin();
	#home = null;

	/** @param {object} view shows the programs */
	constructor(view) {
		this.view = view;
		this.shelf = new Shelf();
		this.finder = new Finder(this.shelf);
		this.progress = new Progress();
		this.gallery = new Gallery(this);
		this.lessonCard = new LessonCard(this.progress, (name, isNew) => (name === null ? this.#leaveLesson() : this.choose(programOfLesson(name), true, isNew)), {
			games: () => this.openHome(), change: () => this.choose(FIRST), own: () => this.openNew(),
		});
		this.title = h("input.title", { type: "text", maxlength: 60, "aria-label": words.title, onchange: () => this.#renameByField() });
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
		const { system } = this.#open;
		return { ...this.view.editor.program, ...(system && { system }) };
	}

	/** Opens the program at an address. At the first screen's, it opens the last program below it. */
	async open(address) {
		if (address === this.#open?.name) {
			this.#home?.leave();
			this.view.draw();
		} else if (address !== "" && address !== "all") await this.choose(address);
		else {
			const isHome = this.#open !== null || this.finder.isHome(address);
			if (this.#open === null) await this.#openLast(this.#isUnasked);
			if (isHome && !this.#home?.element.isConnected) await this.openHome();
		}
	}

	/**
	 * Opens a program. If there is none, says why on the first screen.
	 *
	 * @param {string} address its name, its id, or its link. A lesson's name leads to what the user has made of it
	 * @param {boolean} isRead whether the focus goes to its lesson
	 * @param {boolean} isNew whether a lesson is opened as it was in the beginning, and not as the user has changed it
	 */
	async choose(address, isRead = false, isNew = false) {
		const isNewest = this.#requests.begin();
		await this.view.editing;
		try {
			const name = isNew ? address : this.finder.ownOf(address);
			const found = await this.finder.find(name);
			if (found.models && isNewest()) found.program = await this.view.modelShelf.bring(found.program, found.models);
			if (!isNewest()) return;
			this.#show(found.pupil ? { ...found, title: words.handedBy(found.title, found.pupil) } : found);
			if (found.name === name) this.#remember(name, true);
			if (isRead) this.lessonCard.focus();
		} catch (error) {
			if (!(error instanceof AddressError)) throw error;
			if (!isNewest()) return;
			if (this.#open === null) await this.#openLast(isNewest);
			this.view.say(error.message, true);
			await this.openHome(error.message);
		}
	}

	/** Opens the last program, unless another one has been requested meanwhile. */
	async #openLast(isNewest) {
		const found = await this.finder.last();
		if (!isNewest()) return;
		try {
			this.#show(found, true);
		} catch {
			// of another version
			this.#show(await this.finder.find(FIRST), true);
		}
	}

	/**
	 * Shows a program that Finder has found. Throws an AddressError if Blockly finds none in it; the old one stays.
	 *
	 * @param {object} found it may come with a lesson that it belongs to
	 * @param {boolean} isLast whether it is shown because something has to be, perhaps below the first screen
	 */
	#show({ name, program, title, lesson }, isLast = false) {
		const { view } = this;
		const isFirst = this.#open === null || (this.#open.isStopgap && view.world.frame === 0);
		const before = isFirst ? null : { ...this.#open, program: this.program };
		try {
			view.editor.show(program, isBuiltIn(name) || name === "link");
		} catch {
			throw new AddressError(name === "link" ? words.brokenLink : words.brokenProgram);
		}
		this.#requests.begin();
		if (!isLast) this.#home?.leave();
		this.#open = {
			name, title, isChangedElsewhere: false, isStopgap: isLast && !this.finder.hasLast,
			system: CollisionBlocks.systemNames.includes(program.system) ? program.system : null,
			// a program made from a lesson's program still belongs to the lesson
			lesson: LESSON_NAMES.includes(lesson) ? lesson : null,
		};
		this.lessonCard.show(this.#open.lesson, this.#isOwn);
		this.#showTitle(title);
		view.play(program, this.shelf.cameraOf(name));
		if (!before || view.isBroken || view.world.agents.length === 0) return;
		if (before.name === name) view.say(words.opened(title));
		else view.offer(words.opened(title), words.backTo(before.title), () => {
			this.#show(before);
			this.#remember(before.name);
		});
	}

	/** Whether the open program is one of the user's. */
	get #isOwn() {
		return this.shelf.find(this.#open.name) !== null;
	}

	#showTitle(title) {
		this.#open.title = title;
		this.title.value = this.title.title = title;
		const isOwn = this.#isOwn;
		this.kept.className = isOwn ? "keeping kept" : "keeping";
		this.kept.textContent = !isOwn ? "" : this.shelf.isKept ? words.kept : words.keptNowhere;
		this.keepButton.disabled = isOwn;
	}

	/** Renames the open program, and keeps it under the new name. */
	#renameByField() {
		const title = this.title.value.trim();
		if (title === "" || title === this.#open.title) this.title.value = this.#open.title;
		else if (this.#isOwn) this.rename(this.#open.name, title);
		else this.#putNew(title);
	}

	/** Renames one of the user's programs. */
	rename(id, title) {
		if (this.shelf.find(id)) this.shelf.put({ id, name: title });
		if (id === this.#open.name) this.#showTitle(title);
	}

	#keep() {
		this.#putNew();
		this.title.focus();
	}

	/** Makes an open program the last one, and puts its name into the address: as a step, or in place of the one before. */
	#remember(name, isStep = false) {
		if (name === "link") return;
		this.shelf.last = name;
		const hash = `#play/${name}`;
		if (location.hash === hash) return;
		if (isStep) history.pushState(null, "", hash);
		else history.replaceState(null, "", hash);
	}

	/** Opens the first screen: all programs and lessons, with pictures. It may say why it is shown. */
	async openHome(note = "") {
		if (this.view.isRunning) this.view.stop();
		const [{ Home }] = await Promise.all([import("./home.js"), loadWords("game")]);
		this.#home?.leave();
		this.#home = new Home(this, this.view.layout.main, note);
	}

	/** Called when a game is won. The page's own games get a tick. Returns what there is to say about the best time. */
	win(seconds) {
		const { name } = this.#open;
		if (Object.hasOwn(words.games, name)) this.progress.tickGame(name);
		const { record } = this;
		if (record !== null && record <= seconds) return words.best(fixed(record, 1));
		this.shelf.putRecord(name, seconds);
		return record === null ? "" : words.newBest;
	}

	/** Called when a game has done its lesson. Keeps what did it, for the teacher. */
	async solved(game) {
		const { lesson } = this.#open;
		const { system = CollisionBlocks.TIGHTEST_FITS } = this.program;
		const own = meaning(await builtInProgram(programOfLesson(lesson)));
		this.shelf.putSolution(lesson, game === own ? { system } : { ...JSON.parse(game), system });
	}

	/** Keeps the camera that the user has chosen for the open program. */
	keepCamera(camera) {
		this.shelf.putCamera(this.#open.name, camera);
	}

	/** The seconds of the best victory in the open game, or null. */
	get record() {
		return this.shelf.recordOf(this.#open.name);
	}

	/** Deletes one of the user's programs. This can be undone. */
	async remove(id) {
		const entry = this.shelf.find(id);
		this.shelf.remove(id);
		if (this.#open.name === id) await this.choose(FIRST);
		// another tab may have removed it before
		if (entry) this.view.offer(texts.gallery.removed(entry.name), words.undo, () => {
			this.shelf.put(entry);
			this.choose(id);
		});
	}

	/** Opens a new program of the user's, with one agent. */
	async openNew() {
		await this.openAsNew(programOf(start(create(1, "bears", "bear", size(1.4)))), words.newName);
		this.title.focus();
		this.title.select();
	}

	/** Leaves the lesson. The program stays. */
	#leaveLesson() {
		this.#open.lesson = null;
		if (this.#isOwn) this.shelf.put({ id: this.#open.name, lesson: null });
		this.lessonCard.show(null);
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
		this.#open.system = name === CollisionBlocks.TIGHTEST_FITS ? null : name;
		if (this.#isOwn && !this.#open.isChangedElsewhere) this.#put();
	}

	#put() {
		this.shelf.put({ id: this.#open.name, program: this.program, changed: Date.now() });
	}

	/**
	 * Keeps the program that the user has changed. A changed example, or a program from a link, becomes one of the user's with its own name.
	 *
	 * @returns {boolean} whether the browser keeps it
	 */
	keepChange() {
		if (this.#isOwn && !this.#open.isChangedElsewhere) this.#put();
		else this.#putNew();
		return this.shelf.isKept;
	}

	/** A name that none of the user's programs has. */
	#freeName(title) {
		const names = new Set(this.shelf.all.map(({ name }) => name));
		return freeName(title, (name) => names.has(name));
	}

	/** Keeps the program as a new one of the user's: under a title, or as a copy. If another one has the title, it gets a number. */
	#putNew(title = this.#open.name === "link" ? this.#open.title : words.copyOf(this.#open.title)) {
		const { name: before, lesson } = this.#open;
		const name = this.#freeName(title);
		const id = `own-${Date.now().toString(36)}-${Math.floor(Math.random() * 1e6).toString(36)}`;
		this.shelf.put({ id, name, program: this.program, lesson, changed: Date.now() });
		this.shelf.putCamera(id, this.shelf.cameraOf(before));
		Object.assign(this.#open, { name: id, isChangedElsewhere: false });
		this.lessonCard.isOwn = true;
		this.#showTitle(name);
		// the kept program counts from now on, not the link
		this.#remember(id);
	}

	#hearOtherTab() {
		if (this.#open === null) return;
		const { name, title, isChangedElsewhere } = this.#open;
		if (isChangedElsewhere || name === "link" || isBuiltIn(name)) return;
		const entry = this.shelf.find(name);
		if (entry && JSON.stringify(entry.program) === JSON.stringify(this.program)) return;
		this.#open.isChangedElsewhere = true;
		this.view.say(words.elsewhere(entry?.name ?? title));
	}

	/** Opens a program, or adds a model as a shape for agents. */
	async openFile(file, files = [file]) {
		if (MODEL_FILE.test(file.name)) {
			await this.view.modelShelf.add(file, files);
			return;
		}
		if (!/\.json$/i.test(file.name)) {
			this.view.say(words.wrongFile(file.name), true);
			return;
		}
		try {
			const { name, lesson, models, ...program } = JSON.parse(await file.text());
			if (isWork(program)) this.view.say(words.isWork(file.name), true);
			else if (!isProgram(program)) this.view.say(words.brokenProgram, true);
			else await this.openAsNew(await this.view.modelShelf.bring(program, modelsOf(models)), name ?? file.name.replace(/\.json$/i, ""), lesson);
		} catch {
			this.view.say(words.brokenProgram, true);
		}
	}

	/** Opens a program as a new one of the user's. Fails if it is none. */
	async openAsNew(program, title, lesson = null) {
		await this.view.editing;
		this.#show({ name: "link", program, title: this.#freeName(title), lesson });
		this.#putNew(title);
		if (!this.shelf.isKept) this.view.say(words.notKept, true);
	}

	/** The open program with its name and its lesson, for a file or a link. */
	get whole() {
		const { title, lesson } = this.#open;
		return { name: title, ...(lesson && { lesson }), ...this.program };
	}

	/** The address's argument for the open program: its name or id, or the program itself if it came in a link. */
	async address() {
		const { name } = this.#open;
		return name === "link" ? toLink(this.whole) : name;
	}
}
