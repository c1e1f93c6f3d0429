/** The first screen: lessons, games and the user's own programs. Each has a picture of its beginning. */
import { CARD, button, drawAll, h } from "../../shared/dom.js";
import { texts } from "../../shared/language.js";
import { handIn, nextPupil } from "./sharing.js";

const words = texts.gallery;

export class Home {
	/**
	 * @param {import("./programs.js").Programs} programs
	 * @param {HTMLElement} main shows the screen instead of everything else
	 * @param {string} note why it is shown, if the user has not asked for it
	 */
	constructor(programs, main, note) {
		Object.assign(this, { programs, main });
		this.heading = h("h2", { tabindex: "-1" }, words.title);
		const isOpen = Boolean(programs.view.editor);
		this.element = h("section.gallery", { "aria-label": words.title, onkeydown: ({ key }) => {
			if (key === "Escape" && isOpen) this.#close();
		} },
		h("div.head", {}, h("div", {}, this.heading, h("p.intro", {}, texts.play.intro)), isOpen ? button(words.close, () => this.#close()) : null),
		note ? h("p.status.problem", { role: "alert" }, note) : null,
		...programs.gallery.groups.map((group) => this.#group(group)),
		h("div.tools", {}, button(words.handIn, () => handIn(programs)), button(words.nextPupil, () => nextPupil(programs))));
		main.append(this.element);
		main.classList.add("choosing");
		scrollTo(0, 0);
		this.heading.focus({ preventScroll: true });
		this.#draw();
	}

	/** Goes back to the program that is open. */
	#close() {
		this.leave();
		this.programs.view.draw();
		this.programs.title.focus();
	}

	leave() {
		this.element.remove();
		this.main.classList.remove("choosing");
	}

	#group({ title, isNumbered, canAdd, entries, ...may }) {
		const add = canAdd ? [h("li", {}, h("button.open.new", { type: "button", onclick: () => this.programs.openNew() }, h("span.blank", {}, "+"), h("span", {}, texts.play.new)))] : [];
		return h("section", {}, h("h3", {}, title), h(isNumbered ? "ol.cards" : "ul.cards", {}, ...add, ...entries.map((entry, i) => this.#card(entry, may, isNumbered ? i + 1 : null))));
	}

	#card({ id, name, note, isDone, isNext }, { canRename, canRemove }, number) {
		const picture = h("img", { "data-program": id, alt: "", width: CARD[0], height: CARD[1] });
		const item = h("li", {}, h("button.open", { type: "button", class: isNext ? "open next" : "open", "aria-label": canRename ? name : null, onclick: () => this.programs.gallery.open(id) },
			h("span.picture", {}, picture, number === null ? null : h("span.number", {}, String(number)), isDone ? h("span.tick", { role: "img", "aria-label": texts.lessons.done }, "✓") : null),
			canRename ? null : h("span.name", {}, name), note ? h("small", {}, note) : null, isNext ? h("strong.here", {}, number === 1 ? words.begin : words.here) : null));
		if (!canRemove) return item;
		const input = h("input", { type: "text", value: name, maxlength: 60, "aria-label": words.rename(name), onchange: () => {
			const text = input.value.trim();
			if (text === "") input.value = input.defaultValue;
			else this.programs.rename(id, input.defaultValue = text);
		} });
		item.append(h("div.own", {}, canRename ? input : null, button("✕", () => {
			this.#close();
			this.programs.gallery.remove(id);
		}, { "aria-label": words.remove(name), title: words.remove(name) })));
		return item;
	}

	async #draw() {
		const { gallery, view } = this.programs;
		const isDrawn = await drawAll(this.element.querySelectorAll("img"), async ({ dataset }) => {
			const program = await gallery.programOf(dataset.program);
			// after it has closed, the stage shows the game
			return this.element.isConnected ? view.scene.pictureOfGame(program, ...CARD) : null;
		});
		if (isDrawn) this.element.dataset.drawn = "";
	}
}
