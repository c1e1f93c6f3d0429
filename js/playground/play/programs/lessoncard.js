/** The card of the open lesson: its subject, its task, whether the task is done, and the explanation. */
import { button, h } from "../../shared/dom.js";
import { texts } from "../../shared/language.js";
import { LESSON_NAMES } from "../builtin/names.js";

const words = texts.lessons;
/** Those that are about the collision system: what chooses and shows it is always in sight there. */
const ABOUT_SYSTEM = ["helmet", "wing"];

export class LessonCard {
	#name = null;
	#memory = {};
	#lessons = null;
	/** Called when another card is shown, or none. */
	onShow = () => {};

	/**
	 * @param {import("./progress.js").Progress} progress
	 * @param {(name: string|null, isNew: boolean) => void} onOpen called to open a lesson's program; with null to leave the lesson. If isNew is
	 * true, the lesson's own program is meant, and not what the user has made of it
	 * @param {Record<string, () => void>} onward what follows the last lesson, by the names of its words
	 */
	constructor(progress, onOpen, onward) {
		Object.assign(this, { progress, onOpen, onward });
		this.element = h("div.lead", { hidden: true });
	}

	/** Whether a lesson is open. */
	get isOpen() {
		return this.#name !== null;
	}

	/** Whether the game that runs has been found right or wrong. */
	get isJudged() {
		return Boolean(this.#memory.isDone || this.#memory.wrong);
	}

	/** Whether the open lesson is done by the choice of a collision system. */
	get isOfSystem() {
		return Boolean(this.#lessons?.[this.#name]?.isOfSystem);
	}

	/**
	 * Shows a lesson's card; null hides it.
	 *
	 * @param {string|null} name
	 * @param {boolean} isOwn whether the user has changed the lesson's program
	 */
	show(name, isOwn = false) {
		this.#name = name;
		this.element.hidden = name === null;
		this.element.dataset.needs = ABOUT_SYSTEM.includes(name) ? "system" : "";
		this.element.replaceChildren();
		if (name === null) return this.onShow();
		if (!this.#lessons) import("../builtin/library.js").then(({ LESSONS }) => {
			this.#lessons = LESSONS;
		});
		const at = LESSON_NAMES.indexOf(name);
		const { title, text, challenge, hint } = words.list[name];
		const go = (to) => () => this.onOpen(LESSON_NAMES[to]);
		this.sign = h("p.why", { role: "status" });
		this.isLast = at === LESSON_NAMES.length - 1;
		this.next = this.isLast ? button(words.onward.games, this.onward.games) : button(words.next, go(at + 1));
		this.heading = h("h2", { tabindex: "-1" }, title);
		this.hintButton = button(words.hint, () => this.#turnTo(this.card.dataset.shows === "hint" ? "text" : "hint"), { class: "hint-button" });
		this.foldButton = button("", () => this.#fold(!this.card.classList.contains("folded")), { class: "fold" });
		this.againButton = button(words.again, () => this.onOpen(name, true), { class: "again" });
		this.isOwn = isOwn;
		// all of what it may say takes its place from the beginning, so that nothing below it moves
		const kept = (...each) => h("p.kept-free", { "aria-hidden": "true" }, ...each);
		const said = h("div.said", {}, h("p.text", {}, text), h("p.hint", {}, hint), this.sign, kept(`${words.done} ${this.#why(name)}`, this.#onwards()), ...Object.values(texts.mistakes[name]).map((each) => kept(`${words.notYet} ${each}`)));
		this.card = h("div.lesson", { role: "region", "aria-label": words.lesson(at + 1, LESSON_NAMES.length) },
			h("div.head", {}, h("small", {}, words.lesson(at + 1, LESSON_NAMES.length)), this.heading, this.againButton, this.foldButton,
				button("✕", () => this.onOpen(null), { class: "leave", "aria-label": words.leave, title: words.leave })),
			said,
			h("div.turn", {}, h("p.challenge", {}, h("strong", {}, `${words.challenge} `), challenge)),
			h("div.steps", {}, this.hintButton, button(words.previous, go(at - 1), { disabled: at === 0 }), this.next));
		this.begin();
		this.#fold(false);
		this.element.append(this.card);
		this.onShow();
		this.#turnTo("text");
		if (this.progress.isDone(name)) this.#sayDone();
	}

	/** The place beside the task, if the open lesson is about the collision system; or else null. */
	get placeOfSystem() {
		return this.element.dataset.needs === "" ? null : this.element.querySelector(".turn");
	}

	/** Shows or hides the button that goes back to the lesson's own program. */
	set isOwn(isOwn) {
		// it keeps its place, so that nothing moves when it comes
		this.againButton?.classList.toggle("away", !isOwn);
	}

	/** Moves the focus to the card. */
	focus() {
		this.heading?.focus({ preventScroll: true });
	}

	/** Shows the lesson's text, its hint, or why it is done or not done yet. */
	#turnTo(part) {
		this.card.dataset.shows = part;
		this.hintButton.setAttribute("aria-pressed", String(part === "hint"));
		if (part === "text" && this.sign.textContent !== "") this.card.dataset.shows = "why";
	}

	/** Shows only the task, or the whole card. */
	#fold(isFolded) {
		this.card.classList.toggle("folded", isFolded);
		const label = isFolded ? words.unfold : words.fold;
		this.foldButton.setAttribute("aria-label", label);
		this.foldButton.title = label;
		this.foldButton.setAttribute("aria-expanded", String(!isFolded));
	}

	#say(sign, text) {
		this.sign.replaceChildren(sign, ` ${text}`);
		this.#fold(false);
		this.#turnTo("why");
	}

	/** Why a lesson is done, and, if it is the last one, that all are. */
	#why(name) {
		const isLast = LESSON_NAMES.every((each) => each === name || this.progress.isDone(each));
		return `${words.list[name].why}${isLast ? ` ${words.all}` : ""}`;
	}

	#sayDone() {
		this.#say(h("strong.done", {}, words.done), this.#why(this.#name));
		this.sign.append(this.#onwards());
		this.next.classList.add("primary");
	}

	/** What follows the last lesson. */
	#onwards() {
		return this.isLast ? h("span.onward", {}, ...["change", "own"].map((name) => button(words.onward[name], this.onward[name]))) : "";
	}

	/** Called when a game begins again. */
	begin() {
		this.#memory = {};
		this.hush();
	}

	/** Takes back what was said to be wrong. If it still is, the next frame says so again. */
	hush() {
		this.#memory.wrong = null;
		if (this.#name === null || this.progress.isDone(this.#name) || this.sign.textContent === "") return;
		this.sign.replaceChildren();
		this.#turnTo("text");
	}

	/** Checks a game after a frame. Returns true if the frame has completed the lesson. If the game cannot complete it, the card says why. */
	look(world) {
		const name = this.#name;
		const memory = this.#memory;
		const lesson = this.#lessons?.[name];
		if (!lesson || memory.isDone) return false;
		if (lesson.isDone(world, memory)) {
			memory.isDone = true;
			this.progress.tickLesson(name);
			this.#sayDone();
			return true;
		}
		const wrong = lesson.wrong(world, memory);
		if (wrong !== null && wrong !== memory.wrong && !this.progress.isDone(name)) this.#say(h("strong.not-yet", {}, words.notYet), texts.mistakes[name][wrong]);
		memory.wrong = wrong ?? memory.wrong;
		return false;
	}
}
