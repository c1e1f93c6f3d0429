/** The card of the open lesson: its subject, its task, whether the task is done, and the explanation. */
import { button, h } from "../shared/dom.js";
import { texts } from "../shared/language.js";

const words = texts.lessons;
const KEY = "starlogo-playground.lessons";
export const LESSON_NAMES = Object.keys(words.list);

/** Remembers, in the browser, the lessons that were done and the games that were won. */
class Ticks {
	#names = new Set();

	constructor() {
		try {
			this.#names = new Set(JSON.parse(localStorage.getItem(KEY)));
		} catch {
			// the browser stores nothing
		}
	}

	has(name) {
		return this.#names.has(name);
	}

	add(name) {
		this.#names.add(name);
		this.#keep();
	}

	clear() {
		this.#names.clear();
		this.#keep();
	}

	#keep() {
		try {
			localStorage.setItem(KEY, JSON.stringify([...this.#names]));
		} catch {
			// remembered until the page is closed
		}
	}
}

export class LessonCard {
	#name = null;
	#memory = {};
	#ticks = new Ticks();
	#lessons = null;

	/**
	 * @param {(name: string|null) => void} onOpen called to open a lesson's program; with null to leave the lesson
	 * @param {Record<string, () => void>} onward what follows the last lesson, by the names of its words
	 */
	constructor(onOpen, onward) {
		Object.assign(this, { onOpen, onward });
		this.element = h("div.lead", { hidden: true });
	}

	/** The lessons that were done and the games that were won. */
	get results() {
		return { done: LESSON_NAMES.filter((name) => this.isDone(name)), won: Object.keys(texts.play.games).filter((name) => this.isWon(name)) };
	}

	/** Forgets what was done, for the browser's next user. */
	forget() {
		this.#ticks.clear();
	}

	/** Whether a lesson has been done, now or earlier. */
	isDone(name) {
		return this.#ticks.has(name);
	}

	/** Whether a game of the page's has been won, now or earlier. */
	isWon(name) {
		return this.#ticks.has(`game ${name}`);
	}

	win(name) {
		this.#ticks.add(`game ${name}`);
	}

	/** Shows a lesson's card; null hides it. */
	show(name) {
		this.#name = name;
		this.begin();
		this.element.hidden = name === null;
		this.element.replaceChildren();
		if (name === null) return;
		if (!this.#lessons) import("./library.js").then(({ LESSONS }) => {
			this.#lessons = LESSONS;
		});
		const at = LESSON_NAMES.indexOf(name);
		const { title, text, challenge, hint } = words.list[name];
		const go = (to) => () => this.onOpen(LESSON_NAMES[to]);
		this.sign = h("p.why", { role: "status" });
		this.isLast = at === LESSON_NAMES.length - 1;
		this.next = this.isLast ? button(words.onward.games, this.onward.games) : button(words.next, go(at + 1));
		this.heading = h("h2", { tabindex: "-1" }, title);
		const fold = button("", () => this.#fold(!card.classList.contains("folded")), { class: "fold" });
		const card = h("div.lesson", { role: "region", "aria-label": words.lesson(at + 1, LESSON_NAMES.length) },
			h("div.head", {}, h("small", {}, words.lesson(at + 1, LESSON_NAMES.length)), this.heading, fold),
			h("p.text", {}, text),
			h("p.challenge", {}, h("strong", {}, `${words.challenge} `), challenge),
			this.sign,
			h("div.steps", {}, button(words.previous, go(at - 1), { disabled: at === 0 }), this.next, button(words.leave, () => this.onOpen(null)),
				h("details.hint", {}, h("summary", {}, words.hint), h("p", {}, hint))));
		Object.assign(this, { card, foldButton: fold });
		this.#fold(false);
		this.element.append(card);
		this.#sayIfDone();
	}

	/** Moves the focus to the card. */
	focus() {
		this.heading?.focus({ preventScroll: true });
	}

	/** Shows only the task, or the whole card. */
	#fold(isFolded) {
		this.card.classList.toggle("folded", isFolded);
		this.foldButton.textContent = isFolded ? words.unfold : words.fold;
		this.foldButton.setAttribute("aria-expanded", String(!isFolded));
	}

	#sayIfDone() {
		if (!this.isDone(this.#name)) return;
		const isAll = LESSON_NAMES.every((name) => this.isDone(name));
		this.sign.replaceChildren(h("strong.done", {}, words.done), ` ${words.list[this.#name].why}${isAll ? ` ${words.all}` : ""}`);
		if (this.isLast) this.sign.append(h("span.onward", {}, ...["change", "own"].map((name) => button(words.onward[name], this.onward[name]))));
		this.next.classList.add("primary");
	}

	/** Called when a game begins again. */
	begin() {
		this.#memory = {};
	}

	/** Checks a game after a frame. Returns true if the frame has completed the lesson. */
	look(world) {
		const name = this.#name;
		if (name === null || this.#memory.isDone || !this.#lessons?.[name].isDone(world, this.#memory)) return false;
		this.#memory.isDone = true;
		this.#ticks.add(name);
		this.#sayIfDone();
		return true;
	}
}
