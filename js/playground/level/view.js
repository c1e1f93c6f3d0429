/** A level: the game of examples/level, with its figures and its source. */
import { CapsuleGeometry, ConeGeometry, Mesh, MeshLambertMaterial } from "three";
import { BuiltInModel, GreatLand } from "starlogo-collision";
import { levelFromObject, modelFromObject } from "starlogo-collision/three";
import { Game } from "../../../examples/level/game.js";
import source from "../../../examples/level/game.js" with { type: "text" };
import { listing } from "../shared/copying.js";
import { button, h, short } from "../shared/dom.js";
import { texts } from "../shared/language.js";
import { DOCS, readLevel } from "../shared/served.js";
import { Stage } from "../shared/stage.js";
import { sceneIn } from "./glb.js";

const words = texts.level;
const FRAMES_A_SECOND = 60;
/** The most frames that are computed between two pictures to make up for lost time. */
const MOST_AT_ONCE = 4;
/** What was is kept every so many frames, so many times. */
const [KEPT_EVERY, MOST_KEPT] = [6, 600];
/** The times of so many frames give the figure, which is shown after so many pictures. */
const [TIMED, SHOWN_AFTER] = [120, 12];
/** The keys of the game, by the names of their words. */
const KEYS = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right", Space: "space", KeyF: "shoot", KeyR: "back" };

export async function createView(main) {
	const land = sceneIn(await readLevel());
	const person = modelFromObject("person", new CapsuleGeometry(0.3, 1.2, 8, 16));
	const ball = BuiltInModel.sphere();
	const level = levelFromObject("level", land);
	const greatLand = new GreatLand();
	for (const model of [person, ball, level]) greatLand.addModel(model);
	return new LevelView(main, greatLand, land, new Map([["person", person], ["sphere", ball]]), level.triangles.length / 3);
}

class LevelView {
	#request = 0;
	#last = 0;
	#owed = 0;
	#shown = 0;
	#held = new Set();
	/** Keys that were pressed since the last frame. */
	#taps = new Set();
	#times = [];

	constructor(main, greatLand, land, models, triangles) {
		Object.assign(this, { greatLand, land, models });
		this.host = h("div.world", { tabindex: "0", role: "application", "aria-label": words.world });
		this.runButton = button(words.run, () => (this.#request ? this.stop() : this.#play()), { class: "primary" });
		this.figures = Object.fromEntries(Object.keys(words.figures).map((name) => [name, h("dd", {}, "–")]));
		const code = listing(words.code, h("code", {}, source), DOCS ? h("a", { href: `${DOCS}examples.html#a-game-in-a-level`, target: "_blank", hreflang: "en" }, words.whole) : null);
		// a narrow window has no room beside the world
		code.open = matchMedia("(min-width: 60.01rem)").matches;
		main.replaceChildren(
			h("section.seen", { "aria-label": words.title },
				h("div.tools", {}, this.runButton, button(words.again, () => this.begin()), button(words.save, () => this.save()), button(words.load, () => this.load())),
				h("div.screen", {}, this.host), h("div.pad", {}, ...Object.entries(KEYS).map(([code, name]) => this.#padKey(code, name)))),
			h("div.side", {}, h("h2", {}, words.title), h("p.note", {}, words.how(triangles)),
				h("dl.figures", {}, ...Object.entries(words.figures).map(([name, text]) => h("div", {}, this.figures[name], h("dt", {}, text)))),
				h("p.note", {}, words.timed),
				code));
		this.stage = new Stage(this.host, { label: words.picture, eye: [-5, 0, 3], fov: 60 });
		if (this.stage.renderer) this.#furnish();
		this.#listen();
		this.begin();
	}

	/** Puts the level into the picture, and a nose on the player. */
	#furnish() {
		const { stage, land } = this;
		// its file has y up
		land.rotation.x = Math.PI / 2;
		this.nose = new Mesh(new ConeGeometry(0.1, 0.4).rotateZ(-Math.PI / 2), new MeshLambertMaterial({ color: 0x143a66 }));
		stage.scene.add(land, this.nose);
	}

	/** Begins the game anew. */
	begin() {
		this.game = new Game(this.greatLand);
		this.frame = 0;
		/** Until a key is pressed the player goes round by itself. */
		this.isLed = false;
		this.past = [];
		this.step();
		// there is nothing to go back to before the first frame
		this.saved = this.game.save();
		// the browser has not compiled anything yet
		this.#times.length = 0;
		this.draw();
		this.#show();
	}

	#play() {
		this.run();
		this.host.focus({ preventScroll: true });
	}

	run() {
		this.runButton.textContent = words.stop;
		this.#last = performance.now();
		this.#owed = 0;
		const next = (now) => {
			this.#owed = Math.min(MOST_AT_ONCE, this.#owed + ((now - this.#last) * FRAMES_A_SECOND) / 1000);
			this.#last = now;
			for (; this.#owed >= 1; this.#owed--) this.step();
			this.draw();
			if (++this.#shown % SHOWN_AFTER === 0) this.#show();
			this.#request = requestAnimationFrame(next);
		};
		this.#request = requestAnimationFrame(next);
	}

	stop() {
		cancelAnimationFrame(this.#request);
		this.#request = 0;
		this.runButton.textContent = words.run;
		this.#held.clear();
		this.#show();
	}

	/** Does a frame, or goes back by some if that key is held. */
	step() {
		const { game, past } = this;
		if (this.#held.has("KeyR")) {
			if (past.length > 0 && ++this.frame % 3 === 0) game.goBackTo(past.pop());
			return;
		}
		if (++this.frame % KEPT_EVERY === 0) past.splice(0, Math.max(0, past.push(game.save()) - MOST_KEPT));
		const wish = this.#wish();
		const start = performance.now();
		game.step(wish);
		game.cameraPlace();
		this.#times.push(performance.now() - start);
		if (this.#times.length > TIMED) this.#times.shift();
	}

	#wish() {
		const held = this.#held;
		if (!this.isLed) return { turn: Math.sin(this.frame / 50), walk: 1, jumps: this.frame % 200 === 0, shoots: this.frame % 30 === 0 };
		const between = (less, more) => (held.has(more) ? 1 : 0) - (held.has(less) ? 1 : 0);
		return { turn: between("ArrowLeft", "ArrowRight"), walk: between("ArrowDown", "ArrowUp"), jumps: held.has("Space"), shoots: this.#taps.delete("KeyF") };
	}

	save() {
		this.saved = this.game.save();
	}

	load() {
		this.game.goBackTo(this.saved);
		this.draw();
		this.#show();
	}

	draw() {
		const { game, stage, nose } = this;
		if (!stage.renderer) return;
		const { camera, eye } = game.cameraPlace();
		const { player: { x, y, z, heading } } = game;
		const angle = (heading * Math.PI) / 180;
		nose.position.set(x + 0.3 * Math.cos(angle), y + 0.3 * Math.sin(angle), z + 1.5);
		nose.rotation.z = angle;
		stage.showAgents(game.agents.filter((agent) => agent !== game.level), this.models);
		stage.lookFrom(camera, eye);
	}

	#show() {
		const { bullets, enemies, hits, shots } = this.game;
		const times = [...this.#times].sort((a, b) => a - b);
		const values = { ms: short(times[times.length >> 1]), walkers: 1 + enemies.length, bullets: bullets.length, shots, hits };
		for (const [name, value] of Object.entries(values)) this.figures[name].textContent = value;
	}

	#press(code) {
		// a key leads the player; going back does not
		this.isLed ||= code !== "KeyR";
		this.#held.add(code);
		this.#taps.add(code);
		if (!this.#request) this.run();
	}

	#listen() {
		const { host } = this;
		host.addEventListener("keydown", (event) => {
			if (!(event.code in KEYS) || event.ctrlKey || event.metaKey || event.altKey) return;
			if (!event.repeat) this.#press(event.code);
			event.preventDefault();
		});
		host.addEventListener("keyup", ({ code }) => this.#held.delete(code));
		host.addEventListener("blur", () => this.#held.clear());
		host.addEventListener("pointerdown", () => this.#request && this.#press("KeyF"));
		host.addEventListener("pointerup", () => this.#held.delete("KeyF"));
	}

	#padKey(code, name) {
		const pad = button(h("kbd", {}, texts.play.keysOf[name]), () => {}, { class: `key ${name}`, "aria-label": texts.play.keyName(words.keys[name]) });
		pad.append(h("span", {}, words.keys[name]));
		const release = () => this.#held.delete(code);
		// the game keeps the keyboard
		pad.addEventListener("mousedown", (event) => event.preventDefault());
		pad.addEventListener("pointerdown", (event) => {
			pad.setPointerCapture(event.pointerId);
			this.#press(code);
		});
		pad.addEventListener("keydown", (event) => {
			if (event.key === "Enter" || event.key === " ") this.#press(code);
		});
		for (const type of ["pointerup", "pointercancel", "keyup", "blur"]) pad.addEventListener(type, release);
		return pad;
	}

	close() {
		this.stop();
		this.stage.close();
	}
}
