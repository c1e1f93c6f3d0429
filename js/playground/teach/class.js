/** The page of a class: what pupils have handed in, who has solved what, and each program with its picture, to play at a click. */
import { button, fileButton, h } from "../shared/dom.js";
import { handed } from "../shared/handed.js";
import { texts } from "../shared/language.js";

const words = texts.handing;
const LESSONS = texts.lessons.list;

export class ClassPage {
	/** @param {HTMLElement} main shows the page */
	constructor(main) {
		this.main = main;
		this.status = h("p.status", { role: "status" });
		this.code = h("textarea", { rows: 2, "aria-label": words.code, placeholder: words.codeHere });
		this.list = h("div.class");
		main.replaceChildren(h("section.sheet.wide", { "aria-label": words.classTitle },
			h("div.tools.no-print", {}, h("a", { href: "#teach" }, texts.teach.all), button(texts.teach.print, () => print())),
			h("h2", {}, words.classTitle), h("p.no-print", {}, words.classNote),
			h("div.tools.no-print", {}, fileButton(words.openFiles, ".json", (_, files) => this.take(files)), this.code, button(words.takeCode, () => this.#takeCode())),
			this.status, this.list));
		this.#show();
	}

	/** Takes pupils' files. */
	async take(files) {
		const broken = [];
		let count = 0;
		for (const file of files) {
			try {
				if (handed.take(await file.text(), file.name)) count++;
			} catch {
				broken.push(file.name);
			}
		}
		this.status.textContent = [words.taken(count, files.length - broken.length - count), broken.length > 0 ? words.broken(broken.join(", ")) : ""].join(" ");
		this.status.classList.toggle("problem", broken.length > 0);
		this.#show();
	}

	async #takeCode() {
		const count = await handed.takeCodes(this.code.value);
		this.status.textContent = count === null ? words.brokenCode : words.taken(count, count === 0 ? 1 : 0);
		this.status.classList.toggle("problem", count === null);
		if (count !== null) this.code.value = "";
		this.#show();
	}

	#show() {
		delete this.main.dataset.drawn;
		const { all } = handed;
		if (all.length === 0) {
			this.list.replaceChildren(h("p.note", {}, words.nothing));
			return;
		}
		const names = Object.keys(LESSONS);
		const mark = (work, name) => {
			if (work.done.includes(name)) return h("td.done", { title: LESSONS[name].title }, h("span", { role: "img", "aria-label": texts.lessons.done }, "✓"));
			const isTried = work.programs.some(({ lesson }) => lesson === name);
			return h("td", { title: LESSONS[name].title }, isTried ? h("span", { role: "img", "aria-label": words.tried }, "…") : "");
		};
		this.list.replaceChildren(
			h("div.table", { tabindex: "0", role: "region", "aria-label": words.table }, h("table", {},
				h("thead", {}, h("tr", {}, h("th", { scope: "col" }, words.pupil), ...names.map((name, i) => h("th", { scope: "col", title: LESSONS[name].title }, String(i + 1))), h("th", { scope: "col" }, words.games), h("th", { scope: "col" }, words.programs))),
				h("tbody", {}, ...all.map((work) => h("tr", {}, h("th", { scope: "row" }, work.pupil), ...names.map((name) => mark(work, name)), h("td", {}, String(work.won.length)), h("td", {}, String(work.programs.length))))),
				h("tfoot", {}, h("tr", {}, h("th", { scope: "row" }, words.all(all.length)), ...names.map((name) => h("td", {}, String(all.filter(({ done }) => done.includes(name)).length))), h("td"), h("td"))))),
			h("p.note", {}, words.signs),
			...all.map((work) => this.#pupil(work)));
		this.#draw();
	}

	#pupil(work) {
		return h("section.pupil", { "aria-label": work.pupil },
			h("div.head", {}, h("h3", {}, work.pupil), button("✕", () => {
				handed.remove(work);
				this.#show();
			}, { class: "no-print", "aria-label": words.remove(work.pupil), title: words.remove(work.pupil) })),
			work.programs.length === 0 ? h("p.note", {}, words.noPrograms) : h("ul.cards", {}, ...work.programs.map(({ name, lesson }, i) => h("li", {}, h("a.open", { href: `#play/${handed.addressOf(work, i)}` },
				h("span.picture", {}, h("img", { "data-program": handed.addressOf(work, i), alt: "", width: 240, height: 150 })),
				h("span.name", {}, name), lesson in LESSONS ? h("small", {}, texts.teach.numbered(Object.keys(LESSONS).indexOf(lesson) + 1, LESSONS[lesson].title)) : null)))));
	}

	/** Draws the pictures one after the other, so that the page stays responsive. */
	async #draw() {
		const { Studio } = await import("../play/pictures.js");
		const pictures = this.list.querySelectorAll("img");
		if (pictures.length === 0 || !this.list.isConnected) return;
		const studio = await Studio.open(this.main);
		try {
			for (const picture of pictures) {
				await new Promise((resolve) => setTimeout(resolve));
				if (!picture.isConnected) return;
				const { program, models } = handed.at(picture.dataset.program);
				const address = await studio.pictureOf(program, models, 240, 150);
				if (address) picture.src = address;
				else picture.replaceWith(h("span.blank"));
			}
			this.main.dataset.drawn = "class";
		} finally {
			studio.close();
		}
	}
}
