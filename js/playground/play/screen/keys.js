/** The controls of a game: keys, the key pad below the world with labels, and the pointer. */
import { h } from "../../shared/dom.js";
import { STILL } from "../../shared/drawing/dragging.js";
import { padKey } from "../../shared/pad.js";
import { keysOf } from "../game/program.js";

const KEYS = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right", " ": "space", w: "w", a: "a", s: "s", d: "d", W: "w", A: "a", S: "s", D: "d" };

export class Keys {
	#known = new Set();

	/** @param {import("../../shared/input.js").Input} input gets the keys */
	constructor(input) {
		this.input = input;
		this.pad = h("div.pad.keys");
	}

	/** Shows the keys for which a program has scripts. */
	show(program) {
		const keys = [...keysOf(program)];
		this.#known = new Set(keys.map(([key]) => key));
		this.pad.hidden = keys.length === 0;
		this.pad.replaceChildren(...keys.map(([key, does]) => padKey(key, does, () => this.input.press(key), () => this.input.release(key))));
	}

	/**
	 * Listens to a stage's host.
	 *
	 * @param {import("../../shared/drawing/stage.js").Stage} stage
	 * @param {(agent: object) => void} onClick called with the agent that was clicked
	 * @param {() => void} onKey called when an arrow key or a letter is pressed for which the program has a script
	 */
	listen(stage, onClick, onKey) {
		const { input } = this;
		const { host } = stage;
		host.addEventListener("keydown", (event) => {
			if (!(event.key in KEYS) || event.ctrlKey || event.metaKey || event.altKey) return;
			if (!event.repeat) {
				if (event.key !== " " && this.#known.has(KEYS[event.key])) onKey();
				input.press(KEYS[event.key]);
			}
			event.preventDefault();
		});
		host.addEventListener("keyup", (event) => input.release(KEYS[event.key]));
		host.addEventListener("blur", () => input.releaseAll());
		const point = (event) => {
			const at = stage.renderer && stage.pointAt(event, 0);
			if (at) Object.assign(input.mouse, { x: at.x, y: at.y });
		};
		let down = null;
		host.addEventListener("pointermove", point);
		host.addEventListener("pointerdown", (event) => {
			down = event;
			input.mouse.isDown = true;
			point(event);
		});
		const up = (event) => {
			input.mouse.isDown = false;
			// a click, and not a drag that turns the world
			if (down && event.type === "pointerup" && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < STILL) {
				const agent = stage.agentAt(event);
				if (agent) onClick(agent);
			}
			down = null;
		};
		host.addEventListener("pointerup", up);
		host.addEventListener("pointercancel", up);
	}
}
