/** Play: a program of blocks beside the world that it moves. */
import { CollisionBlocks, GreatLand } from "starlogo-collision";
import { button, choice, field, fileButton, h, slider, tick } from "../shared/dom.js";
import { loadModel } from "../shared/models.js";
import { SHAPES } from "../shared/names.js";
import { Stage } from "../shared/stage.js";
import { texts } from "../texts.js";
import { Editor } from "./editor.js";
import { EXAMPLES } from "./examples.js";
import { openGallery } from "./gallery.js";
import { LessonCard } from "./lessoncard.js";
import { LESSONS, LESSON_NAMES } from "./lessons.js";
import { Panel } from "./panel.js";
import { keysOf } from "./program.js";
import { Scene } from "./scene.js";
import { Shelf, download, fromLink, isProgram, toLink } from "./storage.js";
import { FRAMES_A_SECOND, HALF_WIDTH, World } from "./world.js";

const words = texts.play;
const KEYS = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right", " ": "space", w: "w", a: "a", s: "s", d: "d", W: "w", A: "a", S: "s", D: "d" };
const SIGNS = { up: "▲", down: "▼", left: "◀", right: "▶", space: "●" };
/** The programs that the page brings, by their names; those of lessons begin as addresses do. */
const BROUGHT = { ...EXAMPLES, ...Object.fromEntries(LESSON_NAMES.map((name) => [`lesson-${name}`, LESSONS[name].program])) };
/** How many frames may be made up for between two pictures. */
const MOST_AT_ONCE = 8;
const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];
const PICTURE = [240, 150];

export async function createView(main, link) {
	const models = new Map(await Promise.all(SHAPES.map(async (name) => [name, await loadModel(name)])));
	const greatLand = new GreatLand();
	for (const model of models.values()) greatLand.addModel(model);
	const view = new PlayView(main, models, new World(greatLand));
	await view.open(link);
	return view;
}

class PlayView {
	#running = false;
	#request = 0;
	#last = 0;
	#owed = 0;
	#speed = 1;
	#broken = false;
	/** Which program is shown: an example's name, the id of one of the user's, or "link". */
	#name = "paintball";
	#begun = "";
	/** What was there before the program that replaced it. */
	#replaced = null;
	/** What another tab has made of the program that is open. */
	#isTaken = false;
	/** The lesson that is open, or null. */
	#lesson = null;

	constructor(main, models, world) {
		this.models = models;
		this.world = world;
		this.shelf = new Shelf();
		this.panel = new Panel(world);
		this.#build(main);
		this.editor = new Editor(this.blocksHost, (isDeletion) => this.#changed(isDeletion));
		this.stage = new Stage(this.worldHost, { label: words.world, eye: [-4, -19, 8.5], target: [0, -1, 0], ground: 2 * HALF_WIDTH, isLand: true });
		this.scene = new Scene(this.stage, world, models, this.screen);
		this.#listen();
		world.onSystem = (name) => {
			this.system.value = name;
		};
		world.useSystem(CollisionBlocks.TIGHTEST_FITS);
	}

	#build(main) {
		this.main = main;
		this.runButton = button(words.run, () => (this.#running ? this.stop() : this.run()), { class: "primary" });
		this.status = h("p.status", { role: "status" }, words.ready);
		this.system = choice(CollisionBlocks.systemNames.map((name) => [name, texts.systems[name]]), CollisionBlocks.TIGHTEST_FITS, (name) => {
			this.world.useSystem(name);
			// a game that stands still is as the new one sees it
			if (!this.#running && this.world.frame > 0 && this.world.history.back === 0) this.#attempt(() => {
				this.world.collide();
				this.panel.count();
			});
			this.#draw();
			this.#playOn();
		});
		this.programs = h("select", { onchange: () => this.#choose(this.programs.value) });
		this.undoButton = button(words.undo, () => this.#undo(), { hidden: true });
		this.blocksHost = h("div.blocks", { role: "group", "aria-label": words.blocks });
		this.worldHost = h("div.world", { tabindex: "0", role: "application", "aria-label": words.world });
		this.pad = h("div.pad");
		this.keys = h("p.keys");
		this.speed = slider(words.speed, { min: 0, max: SPEEDS.length - 1, step: 1, value: SPEEDS.indexOf(1), format: (i) => words.speeds(SPEEDS[i]) }, (i) => {
			this.#speed = SPEEDS[i];
			this.#playOn();
		});
		this.rewind = slider(words.rewind, { min: 0, max: 0, step: 1, value: 0, format: (at) => (at < 0 ? words.rewindBack((-at / FRAMES_A_SECOND).toFixed(1)) : words.rewindNow) }, (at) => this.#goBack(-at));
		this.screen = h("div.screen", {}, this.worldHost, this.keys, this.pad);
		this.lessons = new LessonCard((name) => this.#choose(name === null ? "paintball" : `lesson-${name}`));
		const camera = choice(Object.entries(words.cameras), "all", (name) => {
			this.scene.camera = name;
			if (name === "all") this.stage.showAll();
			this.#draw();
			this.#playOn();
		});
		// of a small window's two parts, one is in sight
		this.tabs = Object.entries(words.tabs).map(([name, text]) => button(text, () => this.#turnTo(name), { "data-tab": name }));
		this.#turnTo("game");
		main.replaceChildren(
			this.lessons.element,
			h("div.controls.game", { role: "group", "aria-label": words.run },
				this.runButton, button(words.step, () => this.#step()), button(words.reset, () => this.reset()), h("div.tabs", { role: "group" }, ...this.tabs), this.status),
			h("section.program", { "aria-label": words.blocks },
				h("div.tools", {}, field(words.program, this.programs), button(texts.gallery.open, () => this.#openGallery()),
					button(words.save, () => download(this.editor.program, words.fileName)),
					fileButton(words.open, ".json,application/json", (file) => this.openFile(file)),
					button(words.share, () => this.#share()), this.undoButton),
				this.blocksHost),
			h("section.game", { "aria-label": words.world },
				h("div.tools", {}, field(words.system, this.system), field(words.camera, camera),
					tick(words.structures, false, (on) => {
						this.scene.areAllShown = on;
						this.#draw();
					}),
					tick(words.sees, false, (on) => {
						this.scene.isSeen = on;
						this.#draw();
					}),
					button(h("span.icon"), () => this.screen.requestFullscreen?.(), { class: "fullscreen", "aria-label": words.fullscreen, title: words.fullscreen })),
				this.screen,
				h("div.time", {}, this.speed.element, this.rewind.element),
				this.panel.element));
	}

	#turnTo(tab) {
		this.main.dataset.tab = tab;
		for (const each of this.tabs) each.setAttribute("aria-pressed", each.dataset.tab === tab);
	}

	/** Shows the keys that a program has scripts for. */
	#showKeys(program) {
		const keys = [...keysOf(program)];
		this.keys.hidden = keys.length === 0;
		this.keys.replaceChildren(...keys.flatMap(([key, does]) => [h("kbd", {}, words.keysOf[key] ?? key.toUpperCase()), ` ${does} `]));
		this.pad.replaceChildren(...keys.filter(([key]) => key in SIGNS).map(([key, does]) => this.#padKey(key, words.keyName(does))));
	}

	#padKey(key, text) {
		const pad = button(SIGNS[key], () => {}, { class: `key ${key}`, "aria-label": text });
		const release = () => this.world.release(key);
		pad.addEventListener("pointerdown", (event) => {
			pad.setPointerCapture(event.pointerId);
			this.world.press(key);
		});
		pad.addEventListener("pointerup", release);
		pad.addEventListener("pointercancel", release);
		pad.addEventListener("keydown", (event) => {
			if (event.key === "Enter" || event.key === " ") this.world.press(key);
		});
		pad.addEventListener("keyup", release);
		pad.addEventListener("blur", release);
		return pad;
	}

	#listen() {
		const { world, worldHost } = this;
		worldHost.addEventListener("keydown", (event) => {
			if (!(event.key in KEYS) || event.ctrlKey || event.metaKey || event.altKey) return;
			if (!event.repeat) world.press(KEYS[event.key]);
			event.preventDefault();
		});
		worldHost.addEventListener("keyup", (event) => world.release(KEYS[event.key]));
		worldHost.addEventListener("blur", () => world.releaseAll());
		const point = (event) => {
			const at = this.stage.renderer && this.stage.pointAt(event, 0);
			if (at) Object.assign(world.mouse, { x: at.x, y: at.y });
		};
		let down = null;
		worldHost.addEventListener("pointermove", point);
		worldHost.addEventListener("pointerdown", (event) => {
			down = event;
			world.mouse.isDown = true;
			point(event);
		});
		const up = (event) => {
			world.mouse.isDown = false;
			// a click, not a turn of the world
			if (down && event.type === "pointerup" && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < 6) this.#click(this.stage.agentAt(event));
			down = null;
		};
		worldHost.addEventListener("pointerup", up);
		worldHost.addEventListener("pointercancel", up);
		this.forgetShelf = this.shelf.watch(() => this.#hearOtherTab());
	}

	#click(agent) {
		if (!agent) return;
		this.world.click(agent);
		this.scene.chosen = agent;
		this.#draw();
	}

	/** Gives the keys back to the game after a choice beside it. */
	#playOn() {
		if (this.#running) this.worldHost.focus({ preventScroll: true });
	}

	/** Opens the program of a link; without one, that which was open last, or else the paintball game. */
	async open(link) {
		if (link) {
			try {
				this.#show(await fromLink(link), "link");
				return;
			} catch {
				this.#openLast();
				this.#say(words.brokenLink, true);
				return;
			}
		}
		this.#openLast();
	}

	#openLast() {
		const { last } = this.shelf;
		const { all } = this.shelf;
		const entry = this.shelf.find(last) ?? (last === null ? all.at(-1) : null);
		try {
			if (entry && isProgram(entry.program)) this.#show(entry.program, entry.id);
			else this.#show(BROUGHT[last] ?? EXAMPLES.paintball, last in BROUGHT ? last : "paintball");
		} catch {
			// one of another version
			this.#show(EXAMPLES.paintball, "paintball");
		}
	}

	/** Shows a program; throws if it is none, and leaves what was there. */
	#show(program, name) {
		const before = this.#begun === "" ? null : { program: this.editor.program, name: this.#name };
		this.editor.show(program, name in BROUGHT || name === "link");
		this.#replaced = before;
		this.undoButton.hidden = before === null;
		this.#name = name;
		this.#isTaken = false;
		// what is made of a lesson's program is in the lesson
		this.#lesson = lessonOf(name) ?? this.shelf.find(name)?.lesson ?? null;
		this.lessons.show(this.#lesson);
		if (name !== "link") this.shelf.last = name;
		this.#listPrograms();
		this.reset();
		this.scene.seeAll();
		if (before) this.#sayOpened();
	}

	#sayOpened() {
		if (!this.#broken && this.world.agents.length > 0) this.#say(words.opened(this.#title(this.#name)));
	}

	/** Takes back what replaced a program. */
	#undo() {
		const { program, name } = this.#replaced;
		this.#show(program, name);
		this.#replaced = null;
		this.undoButton.hidden = true;
	}

	#title(name) {
		return words.examples[name] ?? texts.lessons.list[lessonOf(name)]?.title ?? this.shelf.find(name)?.name ?? words.fromLink;
	}

	#openGallery() {
		if (this.#running) this.stop();
		const own = this.shelf.all.map(({ id, name }) => ({ id, name }));
		const programOf = (id) => this.shelf.find(id)?.program ?? BROUGHT[id];
		openGallery([
			{ title: texts.gallery.own, isOwn: true, entries: own },
			{ title: words.brought, entries: Object.entries(words.examples).map(([id, name]) => ({ id, name })) },
			{ title: texts.gallery.lessons, entries: LESSON_NAMES.map((name) => ({ id: `lesson-${name}`, name: texts.lessons.list[name].title, isDone: this.lessons.isDone(name) })) },
		], {
			picture: (id) => this.#picture(programOf(id)),
			open: (id) => this.#choose(id),
			rename: (id, name) => {
				this.shelf.put({ id, name });
				this.#listPrograms();
			},
			remove: (id) => this.#remove(id),
		});
		this.#draw();
	}

	/** What a program's game looks like when it begins; null if it cannot. */
	#picture(program) {
		const world = new World(this.world.greatLand);
		try {
			world.begin(program);
			world.step();
		} catch {
			return null;
		}
		return this.scene.picture(world.agents, ...PICTURE);
	}

	/** Deletes a program of the user's; it can be taken back. */
	#remove(id) {
		const entry = this.shelf.find(id);
		this.shelf.remove(id);
		if (this.#name === id) this.#choose("paintball");
		this.#listPrograms();
		this.#offer(texts.gallery.removed(entry.name), words.undo, () => {
			this.shelf.put(entry);
			this.#choose(id);
		});
	}

	#listPrograms() {
		const group = (label, entries) => (entries.length > 0 ? [h("optgroup", { label }, ...entries.map(([value, text]) => h("option", { value, selected: value === this.#name }, text)))] : []);
		this.programs.replaceChildren(
			...(this.#name === "link" ? [h("option", { value: "link", selected: true }, words.fromLink)] : []),
			...group(words.own, this.shelf.all.map(({ id, name }) => [id, name])),
			...group(words.brought, Object.entries(words.examples)),
			...group(texts.gallery.lessons, LESSON_NAMES.map((name) => [`lesson-${name}`, texts.lessons.list[name].title])));
	}

	#choose(name) {
		const entry = this.shelf.find(name);
		try {
			this.#show(entry?.program ?? BROUGHT[name], name);
		} catch {
			this.#listPrograms();
			this.#say(words.brokenProgram, true);
		}
	}

	/** What the user changes is the user's: an example, and what a link brought, becomes a program with a name of its own. */
	#changed(isDeletion) {
		if (!this.shelf.find(this.#name) || this.#isTaken) {
			const title = words.copyOf(this.#title(this.#name));
			this.#name = this.#putNew(title, this.editor.program);
			this.#isTaken = false;
			// what is kept counts from now on, not what a link brought
			if (location.hash.includes("/")) history.replaceState(null, "", "#play");
		} else {
			this.shelf.put({ id: this.#name, program: this.editor.program, changed: Date.now() });
		}
		if (!this.shelf.isKept) this.#say(words.notKept, true);
		else if (this.#running && this.#isStale()) this.#offer(words.stale, words.startAnew, () => {
			this.reset();
			this.run();
		});
		else if (isDeletion && !this.#running) this.#offer(words.deleted, words.undo, () => {
			this.editor.undo();
			this.#say(words.ready);
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

	/** Says something, with what may be done about it. */
	#offer(text, action, onclick) {
		this.#say(text);
		this.status.append(" ", button(action, onclick));
	}

	#hearOtherTab() {
		const entry = this.shelf.find(this.#name);
		this.#listPrograms();
		if (this.#isTaken || this.#name in BROUGHT || this.#name === "link") return;
		if (entry && JSON.stringify(entry.program) === JSON.stringify(this.editor.program)) return;
		this.#isTaken = true;
		this.#say(words.elsewhere(entry?.name ?? this.programs.selectedOptions[0]?.textContent ?? ""));
	}

	async openFile(file) {
		if (!/\.json$/i.test(file.name)) {
			this.#say(words.wrongFile(file.name), true);
			return;
		}
		try {
			const program = JSON.parse(await file.text());
			if (!isProgram(program)) throw new Error("no program");
			const before = this.#name;
			this.#show(program, "link");
			const replaced = this.#replaced;
			this.#putNew(file.name.replace(/\.json$/i, ""), this.editor.program);
			this.#replaced = replaced ?? { program: BROUGHT[before], name: before };
			this.#sayOpened();
			if (!this.shelf.isKept) this.#say(words.notKept, true);
		} catch {
			this.#say(words.brokenProgram, true);
		}
	}

	async #share() {
		const address = new URL(location.href);
		address.hash = `play/${await toLink(this.editor.program)}`;
		history.replaceState(null, "", address);
		try {
			await navigator.clipboard.writeText(address.href);
			this.#say(words.shared);
		} catch {
			this.#say(words.sharedHere);
		}
	}

	/** The program's beginning. */
	reset() {
		this.#halt();
		this.editor.mark(null);
		this.#broken = false;
		this.#say(words.ready);
		const { program } = this.editor;
		this.#begun = meaning(program);
		this.#showKeys(program);
		this.#attempt(() => this.world.begin(program));
		if (!this.#broken && this.world.agents.length === 0) this.#say(words.empty);
		this.panel.forget();
		this.scene.begin();
		this.lessons.begin();
		this.#draw();
	}

	run() {
		// what was changed since counts from the beginning
		if (this.#broken || this.world.ended || this.#isStale()) this.reset();
		if (this.#broken) return;
		this.#running = true;
		this.#turnTo("game");
		this.runButton.textContent = words.stop;
		this.#say(words.running);
		this.worldHost.focus({ preventScroll: true });
		this.#last = performance.now();
		this.#owed = 0;
		this.panel.forget(this.#last);
		this.#request = requestAnimationFrame((now) => this.#frame(now));
	}

	#isStale() {
		return this.#begun !== meaning(this.editor.program);
	}

	stop() {
		this.#halt();
		this.#say(words.stopped);
		this.#draw();
	}

	#halt() {
		this.#running = false;
		cancelAnimationFrame(this.#request);
		this.runButton.textContent = words.run;
		this.world.releaseAll();
	}

	#step() {
		if (this.#running) this.stop();
		if (this.#broken || this.world.ended || this.#isStale()) this.reset();
		if (this.#broken) return;
		this.#tick();
		if (!this.#broken) this.#say(words.frame(this.world.frame));
		this.#draw();
	}

	#tick() {
		this.#attempt(() => this.world.step());
		this.panel.count();
		if (!this.#broken && this.lessons.look(this.world)) this.#say(texts.lessons.done);
		if (this.world.ended) this.#end();
	}

	#end() {
		const { text } = this.world.ended;
		this.#halt();
		this.#say(text);
	}

	#goBack(back) {
		if (this.#running) this.stop();
		this.#broken = false;
		this.world.history.show(back);
		this.#say(words.frame(this.world.frame));
		this.#draw();
	}

	#frame(now) {
		this.#owed = Math.min(MOST_AT_ONCE, this.#owed + ((now - this.#last) * FRAMES_A_SECOND * this.#speed) / 1000);
		this.#last = now;
		while (this.#owed >= 1 && this.#running) {
			this.#owed--;
			this.#tick();
		}
		this.#draw(now);
		if (this.#running) this.#request = requestAnimationFrame((next) => this.#frame(next));
	}

	/** Does what a program may fail at; says how. */
	#attempt(action) {
		if (this.#broken) return;
		try {
			action();
		} catch (error) {
			this.#broken = true;
			this.#halt();
			this.editor.mark(error.block ?? null);
			this.#say(words.problem(error.message), true);
		}
	}

	#say(text, isProblem = false) {
		this.status.textContent = text;
		this.status.classList.toggle("problem", isProblem);
	}

	#draw(now = 0) {
		const { world } = this;
		this.scene.draw(() => {
			this.reset();
			this.run();
		});
		this.panel.show(this.#running ? now : 0);
		this.rewind.input.min = -world.history.length;
		this.rewind.set(-world.history.back);
	}

	close() {
		this.#halt();
		this.forgetShelf();
		this.editor.close();
		this.stage.close();
	}
}

/** The lesson that a program of the page is of, or null. */
const lessonOf = (name) => (/^lesson-/.test(name) ? name.slice(7) : null);

/** What of a program its game depends on: not where its blocks lie, nor which are folded. */
const meaning = (program) => JSON.stringify(program, (key, value) => (["x", "y", "collapsed"].includes(key) ? undefined : value));
