/** How Play looks: the controls of a game, its world, and the blocks beside it. What the controls do, the view says. */
import { CollisionBlocks } from "starlogo-collision";
import { button, checkBox, choice, field, h, slider } from "../../shared/dom.js";
import { recall, remember } from "../../shared/files/memory.js";
import { fixed, texts } from "../../shared/language.js";
import { LOW, splitter } from "./splitter.js";
import { FRAMES_A_SECOND } from "../game/world.js";

const words = texts.play;
const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];
/** Where the browser remembers whether the settings are open. */
const OPEN = "starlogo-playground.settings";
/** The milliseconds for which words that do not fit beside the buttons are over the world, if they are no problem. */
const TOLD = 6000;
/** The number of pieces of confetti, and the milliseconds that they fall. */
const [PIECES, CELEBRATED] = [36, 3000];

export class Layout {
	/** Puts what chooses and shows the collision system into an element; for null into its own place. */
	#placeSystem;
	/** What hides words over the world that are no problem. */
	#told = 0;

	/**
	 * @param {HTMLElement} main contains the view
	 * @param {object} parts the programs with the lessons' card, the bar for building and the panel
	 * @param {object} on what the controls do: run, step, reset, useSystem, putBeside, useCamera, setSpeed, goBack, showSeen; closeMenus, and playOn, which
	 * gives the keyboard back to the game
	 */
	constructor(main, { programs, buildBar, panel }, on) {
		this.main = main;
		this.on = on;
		this.lessonCard = programs.lessonCard;
		this.#makeControls(programs);
		this.#makeScreen();
		const tools = this.#makeTools();
		const program = h("section.program", { "aria-label": words.blocks }, programs.element, this.blocksHost);
		main.replaceChildren(
			// the lesson is read before the blocks, though it is above the world
			this.lessonCard.element,
			program,
			splitter(main, program),
			this.show = h("div.show", {}, this.controls, h("section.game", { "aria-label": words.world },
				tools,
				this.theatre,
				buildBar.element,
				h("div.time", {}, this.speed.element, this.rewind.element),
				panel.element)));
		const kept = recall(OPEN);
		this.#openSettings(kept === null ? innerHeight >= LOW : kept === "true");
	}

	/** The buttons of a game, and what it says; the room for the blocks. */
	#makeControls(programs) {
		const { on } = this;
		this.runLabel = h("span", {}, words.run);
		this.runButton = button(h("span.icon"), () => on.run(), { class: "primary run" });
		this.runButton.append(this.runLabel);
		this.status = h("p.status", { role: "status" }, words.ready);
		this.editBar = h("div.edit", { role: "group", "aria-label": words.editor.label });
		programs.menuButton.before(this.editBar);
		this.blocksHost = h("div.blocks", { role: "group", "aria-label": words.blocksKeys });
		// a small window shows one of the two parts
		this.tabs = Object.entries(words.tabs).map(([name, text]) => button(text, () => this.turnTo(name), { "data-tab": name }));
		this.turnTo("game");
		this.controls = h("div.controls.game", { role: "group", "aria-label": words.run },
			this.runButton, button(words.step, () => on.step()), button(words.reset, () => on.reset()), h("div.tabs", { role: "group" }, ...this.tabs), h("div.saying", {}, this.status));
		this.settings = button(words.settings, () => {
			const isOpen = this.main.classList.contains("folded");
			remember(OPEN, String(isOpen));
			this.#openSettings(isOpen);
		}, { class: "settings" });
	}

	/** The world, and what lies over it. In full screen, the button Run is included. */
	#makeScreen() {
		this.worldHost = h("div.world", { tabindex: "0", role: "application", "aria-label": words.world });
		this.dragNote = h("p.drag-note", { hidden: true }, words.drag);
		// words that are more than fit beside the buttons; readers have them there
		this.whole = h("p.whole", { hidden: true, "aria-hidden": "true" });
		this.screen = h("div.screen", {}, this.worldHost, this.dragNote, this.whole);
		this.screens = h("div.screens", {}, this.screen);
		this.theatre = h("div.theatre", {}, this.screens);
		this.fullscreen = button(h("span.icon"), () => this.theatre.requestFullscreen?.(), { class: "fullscreen", "aria-label": words.fullscreen, title: words.fullscreen });
		this.theatre.addEventListener("fullscreenchange", () => {
			if (document.fullscreenElement === this.theatre) this.theatre.prepend(this.controls);
			else this.show.prepend(this.controls);
			this.on.playOn();
		});
	}

	/** The settings: systems, camera, speed and time. */
	#makeTools() {
		const { on } = this;
		const systems = CollisionBlocks.systemNames.map((name) => [name, texts.systems[name]]);
		this.system = choice(systems, CollisionBlocks.TIGHTEST_FITS, (name) => on.useSystem(name));
		this.camera = choice(Object.entries(words.cameras), "all", (name) => on.useCamera(name));
		this.speed = slider(words.speed, { min: 0, max: SPEEDS.length - 1, step: 1, value: SPEEDS.indexOf(1), format: (i) => words.speeds(SPEEDS[i]) }, (i) => on.setSpeed(SPEEDS[i]));
		// keys may move the slider on
		this.speed.input.addEventListener("pointerup", () => on.playOn());
		this.rewind = slider(words.rewind, { min: 0, max: 0, step: 1, value: 0, format: (at) => (at < 0 ? words.rewindBack(fixed(-at / FRAMES_A_SECOND, 1)) : words.rewindNow) }, (at) => on.goBack(-at));
		const system = field(words.system, this.system);
		const sees = checkBox(words.sees, false, (isOn) => on.showSeen(isOn));
		const besides = choice([["", words.alone], ...systems], "", (name) => on.putBeside(name));
		const tools = h("div.tools", {}, field(words.beside, besides), field(words.camera, this.camera));
		this.#placeSystem = (host) => {
			if (host) host.append(system, sees);
			else {
				tools.prepend(system);
				tools.append(sees);
			}
		};
		return tools;
	}

	/**
	 * Puts the keys below the world, and what belongs to the world beside them. In a low and wide window, it is beside “Run”, and the collision
	 * system beside the task of a lesson that is about it, so that the world is higher.
	 *
	 * @param {HTMLElement[]} foot what is below the world
	 * @param {HTMLElement[]} buttons what is beside it, between the settings and full screen
	 */
	placeCorner(foot, buttons) {
		const corner = h("div.corner", {}, this.settings, ...buttons, this.fullscreen);
		const below = h("div.foot", {}, ...foot);
		const place = () => {
			(this.room.matches ? this.controls : below).append(corner);
			this.#placeSystem(this.room.matches ? this.lessonCard.placeOfSystem : null);
		};
		this.lessonCard.onShow = place;
		this.room = matchMedia(`(min-width: 75rem) and (max-height: ${LOW - 1}px)`);
		this.room.onchange = place;
		this.theatre.append(below);
		place();
	}

	/** Opens or folds the systems, the camera, speed and numbers. Folded, the world has their room. */
	#openSettings(isOpen) {
		this.main.classList.toggle("folded", !isOpen);
		this.settings.setAttribute("aria-expanded", String(isOpen));
	}

	/** Shows the world ("game") or the blocks, in a window that has no room for both. */
	turnTo(tab) {
		this.main.dataset.tab = tab;
		this.on.closeMenus();
		for (const each of this.tabs) each.setAttribute("aria-pressed", each.dataset.tab === tab);
	}

	/** Makes the game and the blocks usable, or not. */
	set isUsable(isUsable) {
		for (const part of [this.show, this.blocksHost.parentElement]) part.inert = !isUsable;
	}

	/** Shows what the button does: run, stop, or start a changed program anew. */
	showRun(isRunning, isAnew) {
		const isChanged = isRunning && isAnew;
		this.runLabel.textContent = isChanged ? words.startAnew : isRunning ? words.stop : words.run;
		this.runButton.classList.toggle("running", isRunning);
		this.runButton.classList.toggle("changed", isChanged);
	}

	/** Shows how far the game can go back, and how far it has. */
	showTime({ length, back }) {
		this.rewind.input.disabled = length === 0;
		this.rewind.input.min = -Math.max(1, length);
		this.rewind.set(-back);
	}

	/** Says that agents can be dragged, for some seconds: see style.css. */
	showDragNote(isShown) {
		this.dragNote.hidden = !isShown;
		for (const each of this.dragNote.getAnimations()) each.currentTime = 0;
	}

	/** Writes words beside the buttons, with further elements behind them. If the words do not fit there, they are over the world as well. */
	say(text, isProblem, ...more) {
		this.status.replaceChildren(text, ...more.flatMap((each) => [" ", each]));
		this.status.classList.toggle("problem", isProblem);
		this.whole.textContent = text;
		this.whole.classList.toggle("problem", isProblem);
		this.whole.hidden = this.status.scrollHeight <= this.status.clientHeight + 1;
		clearTimeout(this.#told);
		if (!isProblem) this.#told = setTimeout(() => {
			this.whole.hidden = true;
		}, TOLD);
	}

	/** Lets confetti fall. */
	celebrate() {
		const confetti = h("div.confetti", { "aria-hidden": "true" }, ...Array.from({ length: PIECES }, (_, i) => pieceOf(i)));
		this.screen.append(confetti);
		setTimeout(() => confetti.remove(), CELEBRATED);
	}

	close() {
		clearTimeout(this.#told);
		this.room.onchange = null;
	}
}

/** A piece of confetti, which falls at a place, at a time and at a speed of its own. */
function pieceOf(i) {
	const piece = h("i");
	Object.assign(piece.style, { left: `${(29 * i) % 97}%`, animationDelay: `${(137 * i) % 700}ms`, animationDuration: `${1.7 + 0.4 * (i % 3)}s` });
	return piece;
}
