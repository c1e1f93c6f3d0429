/** What Play says first: what this is, and, while a lesson is open, what it is about, what is to be done, and whether it is. */
import { button, h } from "../shared/dom.js";
import { texts } from "../shared/language.js";
import { LESSONS, LESSON_NAMES } from "./lessons.js";

const words = texts.lessons;
const KEY = "starlogo-playground.lessons";

export class LessonCard {
	#name = null;
	#memory = {};
	#done = new Set();

	/** @param {(name: string) => void} onOpen called to open a lesson's program */
	constructor(onOpen) {
		this.onOpen = onOpen;
		try {
			this.#done = new Set(JSON.parse(localStorage.getItem(KEY)));
		} catch {
			// a browser that keeps nothing
		}
		this.element = h("div.lead");
		this.show(null);
	}

	/** Whether a lesson has been done, now or earlier. */
	isDone(name) {
		return this.#done.has(name);
	}

	/** Shows a lesson; none for null. */
	show(name) {
		this.#name = name;
		this.begin();
		if (name === null) {
			const next = LESSON_NAMES.find((each) => !this.isDone(each)) ?? LESSON_NAMES[0];
			this.element.replaceChildren(h("p.intro", {}, texts.play.intro, " ", button(words.begin, () => this.onOpen(next))));
			return;
		}
		const at = LESSON_NAMES.indexOf(name);
		const { title, text, challenge, hint } = words.list[name];
		const go = (to) => () => this.onOpen(LESSON_NAMES[to]);
		this.sign = h("strong.done", { role: "status" }, this.isDone(name) ? words.done : "");
		this.next = button(words.next, go(at + 1), { disabled: at === LESSON_NAMES.length - 1, class: this.isDone(name) ? "primary" : "" });
		this.element.replaceChildren(h("div.lesson", { role: "region", "aria-label": words.lesson(at + 1, LESSON_NAMES.length) },
			h("small", {}, words.lesson(at + 1, LESSON_NAMES.length)), h("h2", {}, title), h("p", {}, text),
			h("p", {}, h("strong", {}, `${words.challenge} `), challenge),
			h("div.steps", {}, button(words.previous, go(at - 1), { disabled: at === 0 }), this.next, button(words.leave, () => this.onOpen(null)), this.sign),
			h("details.hint", {}, h("summary", {}, words.hint), h("p", {}, hint))));
	}

	/** A game begins anew. */
	begin() {
		this.#memory = {};
	}

	/** Looks at a game after a frame of it: true when that has done the lesson. */
	look(world) {
		const name = this.#name;
		if (name === null || this.#memory.isDone || !LESSONS[name].isDone(world, this.#memory)) return false;
		this.#memory.isDone = true;
		this.#done.add(name);
		try {
			localStorage.setItem(KEY, JSON.stringify([...this.#done]));
		} catch {
			// it counts as long as the page is open
		}
		this.sign.textContent = this.#done.size === LESSON_NAMES.length ? words.all : words.done;
		this.next.classList.add("primary");
		return true;
	}
}
