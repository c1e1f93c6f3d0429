/** Play: a program of blocks beside the world that it moves. */
import { CollisionBlocks, GreatLand } from "starlogo-collision";
import { button, choice, field, fileButton, h, slider, tick } from "../shared/dom.js";
import { loadModel, parseModel } from "../shared/models.js";
import { SHAPES } from "../shared/names.js";
import { Stage } from "../shared/stage.js";
import { texts } from "../texts.js";
import { meet } from "./blocks.js";
import { Editor } from "./editor.js";
import { Panel } from "./panel.js";
import { keysOf } from "./program.js";
import { Scene } from "./scene.js";
import { MODEL_FILE, Programs } from "./programs.js";
import { download } from "./storage.js";
import { FRAMES_A_SECOND, HALF_WIDTH, World } from "./world.js";

const words = texts.play;
const KEYS = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right", " ": "space", w: "w", a: "a", s: "s", d: "d", W: "w", A: "a", S: "s", D: "d" };
const SIGNS = { up: "▲", down: "▼", left: "◀", right: "▶", space: "●" };
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
	isRunning = false;
	#request = 0;
	#last = 0;
	#owed = 0;
	#speed = 1;
	isBroken = false;
	#begun = "";

	constructor(main, models, world) {
		this.models = models;
		this.world = world;
		this.programs = new Programs(this);
		this.panel = new Panel(world);
		this.#build(main);
		this.editor = new Editor(this.blocksHost, (isDeletion) => this.programs.changed(isDeletion));
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
		this.runButton = button(words.run, () => (this.isRunning ? this.stop() : this.run()), { class: "primary" });
		this.status = h("p.status", { role: "status" }, words.ready);
		this.system = choice(CollisionBlocks.systemNames.map((name) => [name, texts.systems[name]]), CollisionBlocks.TIGHTEST_FITS, (name) => {
			this.world.useSystem(name);
			// a game that stands still is as the new one sees it
			if (!this.isRunning && this.world.frame > 0 && this.world.history.back === 0) this.#attempt(() => {
				this.world.collide();
				this.#take();
			});
			this.draw();
			this.#playOn();
		});
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
		const camera = choice(Object.entries(words.cameras), "all", (name) => {
			this.scene.camera = name;
			if (name === "all") this.stage.showAll();
			this.draw();
			this.#playOn();
		});
		// of a small window's two parts, one is in sight
		this.tabs = Object.entries(words.tabs).map(([name, text]) => button(text, () => this.#turnTo(name), { "data-tab": name }));
		this.#turnTo("game");
		main.replaceChildren(
			this.programs.lessons.element,
			h("div.controls.game", { role: "group", "aria-label": words.run },
				this.runButton, button(words.step, () => this.#step()), button(words.reset, () => this.reset()), h("div.tabs", { role: "group" }, ...this.tabs), this.status),
			h("section.program", { "aria-label": words.blocks },
				h("div.tools", {}, field(words.program, this.programs.menu), button(texts.gallery.open, () => this.programs.openGallery()),
					button(words.save, () => download(this.editor.program, words.fileName)),
					fileButton(words.open, ".json,.obj,.dae,.zae,.glb,.gltf,.stl", (file) => this.openFile(file)),
					button(words.share, () => this.programs.share()), this.programs.undoButton),
				this.blocksHost),
			h("section.game", { "aria-label": words.world },
				h("div.tools", {}, field(words.system, this.system), field(words.camera, camera),
					tick(words.structures, false, (on) => {
						this.scene.areAllShown = on;
						this.draw();
					}),
					tick(words.sees, false, (on) => {
						this.scene.isSeen = on;
						this.draw();
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
	}

	#click(agent) {
		if (!agent) return;
		this.world.click(agent);
		this.scene.chosen = agent;
		this.draw();
	}

	/** Gives the keys back to the game after a choice beside it. */
	#playOn() {
		if (this.isRunning) this.worldHost.focus({ preventScroll: true });
	}

	/** What a program's game looks like when it begins; null if it cannot. */
	pictureOf(program) {
		const world = new World(this.world.greatLand);
		try {
			world.begin(program);
			world.step();
		} catch {
			return null;
		}
		return this.scene.picture(world.agents, ...PICTURE);
	}

	/** Opens the program of a link, or that which was open last. */
	open(link) {
		return this.programs.open(link);
	}

	/** Opens what the user has chosen, or dropped anywhere on the page. */
	openFile(file) {
		return this.programs.openFile(file);
	}

	/** Says something, with what may be done about it. */
	offer(text, action, onclick) {
		this.say(text);
		this.status.append(" ", button(action, onclick));
	}

	async addModel(file) {
		let name = file.name.replace(MODEL_FILE, "");
		for (let number = 2; this.models.has(name); number++) name = words.another(file.name.replace(MODEL_FILE, ""), number);
		try {
			const model = await parseModel(name, new Uint8Array(await file.arrayBuffer()));
			this.world.greatLand.addModel(model);
			this.models.set(name, model);
			meet("SHAPE", name);
			this.say(words.newShape(name));
		} catch (error) {
			this.say(words.brokenModel(error.message), true);
		}
	}

	/** The program's beginning. */
	reset() {
		this.#halt();
		this.editor.mark(null);
		this.isBroken = false;
		this.say(words.ready);
		const { program } = this.editor;
		this.#begun = meaning(program);
		this.#showKeys(program);
		this.#attempt(() => this.world.begin(program));
		if (!this.isBroken && this.world.agents.length === 0) this.say(words.empty);
		this.panel.forget();
		this.scene.begin();
		this.programs.lessons.begin();
		this.draw();
	}

	run() {
		// what was changed since counts from the beginning
		if (this.isBroken || this.world.ended || this.isStale) this.reset();
		if (this.isBroken) return;
		this.isRunning = true;
		this.#turnTo("game");
		this.runButton.textContent = words.stop;
		this.say(words.running);
		this.worldHost.focus({ preventScroll: true });
		this.#last = performance.now();
		this.#owed = 0;
		this.panel.forget(this.#last);
		this.#request = requestAnimationFrame((now) => this.#frame(now));
	}

	get isStale() {
		return this.#begun !== meaning(this.editor.program);
	}

	stop() {
		this.#halt();
		this.say(words.stopped);
		this.draw();
	}

	#halt() {
		this.isRunning = false;
		cancelAnimationFrame(this.#request);
		this.runButton.textContent = words.run;
		this.world.releaseAll();
	}

	#step() {
		if (this.isRunning) this.stop();
		if (this.isBroken || this.world.ended || this.isStale) this.reset();
		if (this.isBroken) return;
		this.#tick();
		if (!this.isBroken) this.say(words.frame(this.world.frame));
		this.draw();
	}

	#tick() {
		this.#attempt(() => this.world.step());
		this.#take();
		if (this.world.ended) this.#end();
	}

	/** Takes a frame into account. */
	#take() {
		this.panel.count();
		if (!this.isBroken && this.programs.lessons.look(this.world)) this.say(texts.lessons.done);
	}

	#end() {
		const { text } = this.world.ended;
		this.#halt();
		this.say(text);
	}

	#goBack(back) {
		if (this.isRunning) this.stop();
		this.isBroken = false;
		this.world.history.show(back);
		this.say(words.frame(this.world.frame));
		this.draw();
	}

	#frame(now) {
		this.#owed = Math.min(MOST_AT_ONCE, this.#owed + ((now - this.#last) * FRAMES_A_SECOND * this.#speed) / 1000);
		this.#last = now;
		while (this.#owed >= 1 && this.isRunning) {
			this.#owed--;
			this.#tick();
		}
		this.draw(now);
		if (this.isRunning) this.#request = requestAnimationFrame((next) => this.#frame(next));
	}

	/** Does what a program may fail at; says how. */
	#attempt(action) {
		if (this.isBroken) return;
		try {
			action();
		} catch (error) {
			this.isBroken = true;
			this.#halt();
			this.editor.mark(error.block ?? null);
			this.say(words.problem(error.message), true);
		}
	}

	say(text, isProblem = false) {
		this.status.textContent = text;
		this.status.classList.toggle("problem", isProblem);
	}

	draw(now = 0) {
		const { world } = this;
		this.scene.draw(() => {
			this.reset();
			this.run();
		});
		this.panel.show(this.isRunning ? now : 0);
		this.rewind.input.min = -world.history.length;
		this.rewind.set(-world.history.back);
	}

	close() {
		this.#halt();
		this.programs.close();
		this.editor.close();
		this.stage.close();
	}
}

/** What of a program its game depends on: not where its blocks lie, nor which are folded. */
const meaning = (program) => JSON.stringify(program, (key, value) => (["x", "y", "collapsed"].includes(key) ? undefined : value));
