/** A level: the game of examples/level, with its figures and its source. */
import { BuiltInModel, GreatLand } from "starlogo-collision";
import { levelFromObject } from "starlogo-collision/three";
import { Game, wander } from "../../../examples/level/game.js";
import { Shadows, chequer, personShape } from "../../../examples/level/looks.js";
import source from "../../../examples/level/game.js" with { type: "text" };
import { outdoors } from "../shared/drawing/backdrop.js";
import { listing } from "../shared/copying.js";
import { button, h, short } from "../shared/dom.js";
import { Figures } from "../shared/figures.js";
import { median } from "../shared/timing.js";
import { Input } from "../shared/input.js";
import { texts } from "../shared/language.js";
import { Loop } from "../shared/loop.js";
import { padKey } from "../shared/pad.js";
import { DOCS, readLevel } from "../shared/files/served.js";
import { Stage } from "../shared/drawing/stage.js";
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
/** Keys that do the same as others. */
const SAME = { KeyW: "ArrowUp", KeyS: "ArrowDown", KeyA: "ArrowLeft", KeyD: "ArrowRight" };
const keyOf = (code) => SAME[code] ?? code;

export async function createView(main) {
	const land = sceneIn(await readLevel());
	chequer(land);
	const ball = BuiltInModel.sphere();
	const level = levelFromObject("level", land);
	const greatLand = new GreatLand();
	greatLand.addModel(ball);
	greatLand.addModel(BuiltInModel.capsule(0.3, 1.8, "person"));
	greatLand.addLevel(level);
	return new LevelView(main, greatLand, land, new Map([["person", drawnPerson()], ["sphere", ball]]), level.triangles.length / 3);
}

/** What is drawn of a walker, as the stage draws models: z up, with its colours. */
function drawnPerson() {
	const { attributes: { position, color }, index } = personShape();
	const vertices = Array.from({ length: position.count }, (_, i) => [position.getX(i), -position.getZ(i), position.getY(i)]).flat();
	const triangles = [...index.array];
	const colours = triangles.filter((_, i) => i % 3 === 0).map((vertex) => [1, color.getX(vertex) === 1 ? "#ffffff" : "#1c2430"]);
	return { vertices, triangles, colours };
}

class LevelView {
	#loop = new Loop((now) => this.#frames(now));
	#shown = 0;
	#input = new Input();
	#times = [];

	constructor(main, greatLand, land, models, triangles) {
		Object.assign(this, { greatLand, land, models });
		this.host = h("div.world.unplayed", { tabindex: "0", role: "application", "aria-label": words.world });
		this.runButton = button(words.run, () => (this.#loop.isRunning ? this.stop() : this.#play()), { class: "primary" });
		this.figures = new Figures(words.figures);
		const code = listing(words.code, h("code", {}, source), DOCS ? h("a", { href: `${DOCS}examples.html#a-game-in-a-level`, target: "_blank", hreflang: "en" }, words.whole) : null);
		// a narrow window has no room beside the world
		code.open = matchMedia("(min-width: 60.01rem)").matches;
		main.replaceChildren(
			h("section.seen", { "aria-label": words.title },
				h("div.tools", {}, this.runButton, button(words.again, () => this.begin()), button(words.save, () => this.save()), this.loadButton = button(words.load, () => this.load())),
				h("div.screen", {}, this.host), h("div.pad", {}, ...Object.entries(KEYS).map(([code, name]) => padKey(name, words.keys[name], () => this.#press(code), () => this.#input.release(code))))),
			h("div.side", {}, h("h2", {}, words.title), h("p", {}, words.how), this.figures.element,
				h("p.note", {}, words.what(triangles)), h("p.note", {}, words.timed),
				code));
		this.game = new Game(this.greatLand);
		this.stage = new Stage(this.host, { label: words.picture, eye: [-5, 0, 3], backdrop: outdoors, fov: 50, isTurnable: false });
		if (this.stage.renderer) this.#furnish();
		this.#listen();
		this.begin();
	}

	/** Puts the level and the walkers' shadows into the picture. */
	#furnish() {
		const { stage, land } = this;
		// its file has y up
		land.rotation.x = Math.PI / 2;
		this.shadows = new Shadows(this.game.walkers.length);
		stage.scene.add(land, this.shadows);
	}

	/** Begins the game anew. */
	begin() {
		this.game = new Game(this.greatLand);
		this.frame = 0;
		/** Until a key is pressed the player goes round by itself. */
		this.isLed = false;
		this.past = [];
		this.step();
		this.loadButton.disabled = true;
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
		if (!this.isLed) this.#say(words.led);
		this.host.classList.remove("unplayed");
		this.runButton.textContent = words.stop;
		this.#loop.run();
	}

	#frames(now) {
		for (let due = this.#loop.due(now, FRAMES_A_SECOND, MOST_AT_ONCE); due > 0; due--) this.step();
		this.draw();
		if (++this.#shown % SHOWN_AFTER === 0) this.#show();
	}

	stop() {
		this.#loop.stop();
		this.runButton.textContent = words.run;
		this.#input.releaseAll();
		this.#show();
	}

	/** Does a frame, or goes back by some if that key is held. */
	step() {
		const { game, past } = this;
		if (this.#input.isDown("KeyR")) {
			if (past.length > 0 && ++this.frame % 3 === 0) game.goBackTo(past.pop());
			return;
		}
		if (++this.frame % KEPT_EVERY === 0) past.splice(0, Math.max(0, past.push(game.save()) - MOST_KEPT));
		const wish = this.#wish();
		this.#input.endFrame();
		const start = performance.now();
		game.step(wish);
		// timed too: a game asks for it in each frame
		game.cameraPlace();
		this.#times.push(performance.now() - start);
		if (this.#times.length > TIMED) this.#times.shift();
	}

	#wish() {
		const input = this.#input;
		if (!this.isLed) return wander(this.frame);
		const between = (less, more) => Number(input.isDown(more)) - Number(input.isDown(less));
		return { turn: between("ArrowLeft", "ArrowRight"), walk: between("ArrowDown", "ArrowUp"), jumps: input.isDown("Space"), shoots: input.wasPressed("KeyF") };
	}

	save() {
		this.saved = this.game.save();
		this.loadButton.disabled = false;
		this.#say(words.saved);
	}

	/** Says something in the picture for some seconds, so that nothing moves. */
	#say(text) {
		this.said?.remove();
		this.said = h("p.drag-note", { role: "status" }, text);
		this.host.after(this.said);
	}

	load() {
		this.game.goBackTo(this.saved);
		this.draw();
		this.#show();
	}

	draw() {
		const { game, stage } = this;
		if (!stage.renderer) return;
		const { camera, aim } = game.cameraPlace();
		this.shadows.follow(game);
		stage.showAgents(game.agents.filter((agent) => agent !== game.level), this.models);
		stage.lookFrom(camera, aim);
	}

	#show() {
		const { bullets, hits, shots, walkers } = this.game;
		this.figures.show({ ms: short(median(this.#times)), walkers: walkers.length, bullets: bullets.length, shots, hits });
	}

	#press(code) {
		// a key leads the player; going back does not
		this.isLed ||= code !== "KeyR";
		this.#input.press(code);
		if (!this.#loop.isRunning) this.run();
	}

	#listen() {
		const { host } = this;
		host.addEventListener("keydown", (event) => {
			const key = keyOf(event.code);
			if (!(key in KEYS) || event.ctrlKey || event.metaKey || event.altKey) return;
			if (!event.repeat) this.#press(key);
			event.preventDefault();
		});
		host.addEventListener("keyup", ({ code }) => this.#input.release(keyOf(code)));
		host.addEventListener("blur", () => this.#input.releaseAll());
		host.addEventListener("pointerdown", () => {
			if (this.#loop.isRunning) this.#press("KeyF");
			else if (host.classList.contains("unplayed")) this.run();
		});
		host.addEventListener("pointerup", () => this.#input.release("KeyF"));
	}

	close() {
		this.stop();
		this.stage.close();
	}
}
