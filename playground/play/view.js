/** Play: a program of blocks beside the world that it moves. */
import { CollisionBlocks, GreatLand } from "starlogo-collision";
import { button, choice, field, fileButton, h, short, tick } from "../shared/dom.js";
import { loadModel } from "../shared/models.js";
import { SHAPES } from "../shared/names.js";
import { Stage } from "../shared/stage.js";
import { texts } from "../texts.js";
import { Editor } from "./editor.js";
import { EXAMPLES } from "./examples.js";
import { download, fromLink, isProgram, keep, kept, toLink } from "./storage.js";
import { FRAMES_A_SECOND, HALF_WIDTH, World } from "./world.js";

const words = texts.play;
const KEYS = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right", " ": "space" };
const SIGNS = { up: "▲", down: "▼", left: "◀", right: "▶", space: "●" };
/** How many frames may be made up for between two pictures. */
const MOST_AT_ONCE = 4;

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
	#shownAt = 0;
	#frames = 0;
	#ticks = 0;
	#collisionMs = 0;
	#broken = false;
	#name = "paintball";
	#begun = "";

	constructor(main, models, world) {
		this.models = models;
		this.world = world;
		this.#build(main);
		this.editor = new Editor(this.blocksHost, () => this.#changed());
		this.stage = new Stage(this.worldHost, { label: words.world, eye: [-11, -19, 17], target: [0, -1, 0], ground: 2 * HALF_WIDTH });
		this.#listen();
		world.onSystem = (name) => {
			this.system.value = name;
		};
		world.useSystem(CollisionBlocks.TIGHTEST_FITS);
	}

	#build(main) {
		this.runButton = button(words.run, () => (this.#running ? this.stop() : this.run()), { class: "primary" });
		this.status = h("p.status", { role: "status" }, words.ready);
		this.system = choice(CollisionBlocks.systemNames.map((name) => [name, texts.systems[name]]), CollisionBlocks.TIGHTEST_FITS, (name) => {
			this.world.useSystem(name);
			// a game that stands still is as the new one sees it
			if (!this.#running && this.world.frame > 0) this.#attempt(() => this.world.collide());
			this.#draw();
		});
		this.allStructures = false;
		const names = [["own", words.own], ...Object.entries(words.examples)];
		this.programs = choice(names, this.#name, (name) => this.#choose(name));
		this.blocksHost = h("div.blocks", { role: "group", "aria-label": words.blocks });
		this.worldHost = h("div.world", { tabindex: "0", role: "application", "aria-label": words.world });
		this.figures = Object.fromEntries(Object.keys(words.panel).map((name) => [name, h("dd", {}, "–")]));
		const panel = h("dl.figures", {}, ...Object.entries(words.panel).map(([name, text]) => h("div", {}, this.figures[name], h("dt", {}, text))));
		const pad = h("div.pad", {}, ...Object.entries(words.keys).map(([key, text]) => this.#padKey(key, text)));
		main.replaceChildren(
			h("section.program", { "aria-label": words.blocks },
				h("div.tools", {}, field(words.program, this.programs),
					button(words.save, () => download(this.editor.program, words.fileName)),
					fileButton(words.open, ".json,application/json", (file) => this.#openFile(file)),
					button(words.share, () => this.#share())),
				this.blocksHost),
			h("section.game", { "aria-label": words.world },
				h("div.tools", {}, this.runButton, button(words.step, () => this.#step()), button(words.reset, () => this.reset()),
					field(words.system, this.system),
					tick(words.structures, false, (on) => {
						this.allStructures = on;
						this.#draw();
					})),
				this.status,
				h("div.screen", {}, this.worldHost, pad),
				panel));
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
		this.worldHost.addEventListener("keydown", (event) => {
			if (!(event.key in KEYS) || event.ctrlKey || event.metaKey || event.altKey) return;
			if (!event.repeat) this.world.press(KEYS[event.key]);
			event.preventDefault();
		});
		this.worldHost.addEventListener("keyup", (event) => this.world.release(KEYS[event.key]));
		this.worldHost.addEventListener("blur", () => this.world.releaseAll());
	}

	/** Opens the program of a link; without one, that which the browser keeps, or else the paintball game. */
	async open(link) {
		const saved = kept();
		if (link) {
			try {
				this.#show(await fromLink(link), "own");
				return;
			} catch {
				this.#show(EXAMPLES.paintball, "paintball");
				this.#say(words.brokenLink, true);
				return;
			}
		}
		if (isProgram(saved?.program)) {
			try {
				this.#show(saved.program, saved.name);
				return;
			} catch {
				// one of another version
			}
		}
		this.#show(EXAMPLES.paintball, "paintball");
	}

	#show(program, name) {
		this.editor.show(program, name in EXAMPLES);
		this.#name = name in EXAMPLES ? name : "own";
		this.programs.value = this.#name;
		keep(this.#name, this.editor.program);
		this.reset();
	}

	#choose(name) {
		if (name in EXAMPLES) this.#show(EXAMPLES[name], name);
		else this.#changed();
	}

	#changed() {
		this.#name = "own";
		this.programs.value = "own";
		keep("own", this.editor.program);
		// what is kept counts from now on, not what a link brought
		if (location.hash.includes("/")) history.replaceState(null, "", "#play");
	}

	async #openFile(file) {
		try {
			const program = JSON.parse(await file.text());
			if (!isProgram(program)) throw new Error("no program");
			this.#show(program, "own");
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
		this.#begun = JSON.stringify(program);
		this.#attempt(() => this.world.begin(program));
		if (!this.#broken && this.world.agents.length === 0) this.#say(words.empty);
		this.#draw();
	}

	run() {
		// what was changed since counts from the beginning
		if (this.#broken || this.#isStale()) this.reset();
		if (this.#broken) return;
		this.#running = true;
		this.runButton.textContent = words.stop;
		this.#say(words.running);
		this.worldHost.focus({ preventScroll: true });
		this.#last = performance.now();
		this.#owed = 0;
		this.#shownAt = this.#last;
		this.#frames = 0;
		this.#request = requestAnimationFrame((now) => this.#frame(now));
	}

	#isStale() {
		return this.#begun !== JSON.stringify(this.editor.program);
	}

	stop() {
		this.#halt();
		this.#say(words.stopped);
	}

	#halt() {
		this.#running = false;
		cancelAnimationFrame(this.#request);
		this.runButton.textContent = words.run;
		this.figures.fps.textContent = "–";
		this.world.releaseAll();
	}

	#step() {
		if (this.#running) this.stop();
		if (this.#broken || this.#isStale()) this.reset();
		if (this.#broken) return;
		this.#tick();
		if (!this.#broken) this.#say(words.frame(this.world.frame));
		this.#draw();
	}

	#tick() {
		this.#attempt(() => this.world.step());
		this.#collisionMs += this.world.collisionMs;
		this.#ticks++;
	}

	#frame(now) {
		this.#owed = Math.min(MOST_AT_ONCE, this.#owed + ((now - this.#last) * FRAMES_A_SECOND) / 1000);
		this.#last = now;
		while (this.#owed >= 1 && this.#running) {
			this.#owed--;
			this.#tick();
		}
		this.#frames++;
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
		this.stage.showAgents(world.agents, this.models);
		const lines = [];
		if (this.allStructures) for (const agent of world.agents) world.structures.linesOf(agent, lines);
		else world.structures.lines(lines);
		this.stage.showLines("structures", lines, 0xff8a00);
		if (now === 0 || now - this.#shownAt > 500) this.#tell(now);
	}

	#tell(now) {
		const { statistics } = this.world.collisions.collision;
		const values = { ms: short(this.#collisionMs / this.#ticks), agents: this.world.agents.length, pairs: statistics.candidatePairs, tests: statistics.tests + statistics.hierarchyTests, collisions: statistics.collisions };
		for (const [name, value] of Object.entries(values)) this.figures[name].textContent = value;
		this.#ticks = this.#collisionMs = 0;
		if (now > 0) {
			this.figures.fps.textContent = Math.round((this.#frames * 1000) / (now - this.#shownAt));
			this.#shownAt = now;
			this.#frames = 0;
		}
	}

	close() {
		this.#halt();
		this.editor.close();
		this.stage.close();
	}
}
