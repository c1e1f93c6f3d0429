/** For teachers: each lesson's aim, time and solution, with a link to it and one page to print. */
import { button, checkBox, h, table } from "../shared/dom.js";
import { texts } from "../shared/language.js";
import { LESSON_NAMES } from "../play/builtin/names.js";

const words = texts.teach;
/** The minutes that a class needs for each lesson. */
const MINUTES = [10, 10, 10, 15, 15, 15, 15, 20, 20, 25, 25];
/** The largest height of a lesson's blocks in pixels, so that everything fits on one sheet of paper. */
const HIGHEST = 390;
/** The same of the solution's blocks, which have a page of their own. */
const HIGHEST_SOLVED = 700;

export async function createView(main, name) {
	const view = new TeachView(main);
	await view.open(name);
	return view;
}

class TeachView {
	constructor(main) {
		this.main = main;
	}

	/** Shows the page of a lesson, or of all of them. */
	open(name) {
		delete this.main.dataset.drawn;
		this.asked = name;
		this.main.scrollTop = 0;
		if (LESSON_NAMES.includes(name)) this.#showSheets([name]);
		else if (name === "sheets") this.#showSheets(LESSON_NAMES);
		else if (name === "") this.#showAll();
		else return this.#showPage(name);
		return null;
	}

	/** Shows how a class gets the page, the work of a class, or a program to print. */
	async #showPage(name) {
		if (name === "in-class") {
			const { showInClass } = await import("./inclass.js");
			if (this.asked === name && this.main.isConnected) showInClass(this.main);
			return;
		}
		const [{ ClassPage }, { showProgram }, { handed }] = await Promise.all([import("./class.js"), import("./program.js"), import("../shared/files/submissions.js")]);
		await handed.open();
		if (this.asked !== name || !this.main.isConnected) return;
		if (name === "class") this.class = new ClassPage(this.main);
		else if (!await showProgram(this.main, name)) this.#showAll(words.noPage);
	}

	/** Takes files that are dropped on the page: what pupils hand in. */
	async openFile(file, files) {
		if (this.asked !== "class") {
			history.pushState(null, "", "#teach/class");
			await this.open("class");
		}
		await this.class.take(files);
	}

	#showAll(note = "") {
		const total = MINUTES.reduce((sum, minutes) => sum + minutes, 0);
		this.main.replaceChildren(h("section.sheet", { "aria-label": words.title },
			note ? h("p.status.problem", { role: "alert" }, note) : null,
			h("h2", {}, words.title), h("p", {}, words.intro(total)),
			h("ol.steps", {}, ...[["in-class", texts.inClass.title, texts.inClass.note], ["sheets", words.allSheets, words.sheetsNote], ["class", texts.handing.classTitle, words.classNote]]
				.map(([page, name, note]) => h("li", {}, h("a", { href: `#teach/${page}` }, name), h("small", {}, note)))),
			h("div.table", {}, table([words.lesson, words.minutes, words.inPlay], LESSON_NAMES.map((name, i) => h("tr", {},
				h("th", { scope: "row" }, h("a", { href: `#teach/${name}` }, words.numbered(i + 1, texts.lessons.list[name].title)), h("small", {}, words.list[name].aim)),
				h("td", {}, String(MINUTES[i])), h("td", {}, h("a", { href: `#play/lesson-${name}`, "aria-label": words.openOf(i + 1) }, words.open))))))));
	}

	/** Shows the sheets of lessons, one after the other, to print. */
	#showSheets(names) {
		const sheets = names.map((name) => this.#sheetsOf(name));
		const solutions = sheets.map(({ solved }) => solved);
		sheets[0].given.prepend(h("div.tools.no-print", {}, h("a", { href: "#teach" }, words.all), button(words.print, () => print(), { class: "primary" }), checkBox(words.withSolution, true, (isOn) => {
			for (const sheet of solutions) sheet.hidden = !isOn;
		})));
		this.main.replaceChildren(...sheets.flatMap(({ given, solved }) => [given, solved]));
		this.#drawAll(names, sheets);
	}

	async #drawAll(names, sheets) {
		for (const [i, name] of names.entries()) {
			if (!await this.#draw(name, ...sheets[i].parts)) return;
		}
		this.main.dataset.drawn = this.asked;
	}

	/** The sheet of a lesson, and the one with its solution. */
	#sheetsOf(name) {
		const at = LESSON_NAMES.indexOf(name);
		const { title, text, challenge, hint } = texts.lessons.list[name];
		const { aim, ask, solution } = words.list[name];
		const address = new URL(location.href);
		address.hash = `play/lesson-${name}`;
		const part = (head, ...content) => [h("h3", {}, head), ...content.map((each) => h("p", {}, each))];
		const picture = h("img.shown", { alt: words.picture(title), width: 800, height: 500 });
		const blocks = h("div.shown-blocks", { role: "img", "aria-label": words.program(title), inert: true });
		const solvedBlocks = h("div.shown-blocks", { role: "img", "aria-label": words.solved(title), inert: true });
		// on a page of its own, so that it can stay with the teacher
		const solvedSheet = h("section.sheet.solution", { "aria-label": words.solution }, h("p.note", {}, words.of(at + 1, LESSON_NAMES.length, MINUTES[at])), h("h2", {}, `${title}: ${words.solution}`), h("p", {}, solution), solvedBlocks,
			...part(words.why, texts.lessons.list[name].why));
		return {
			solved: solvedSheet, parts: [picture, blocks, solvedBlocks],
			given: h("section.sheet", { "aria-label": title },
				h("p.note", {}, words.of(at + 1, LESSON_NAMES.length, MINUTES[at])),
				h("h2", {}, title),
				// the address of a file leads nowhere on another computer
				location.protocol === "file:" ? null : h("p", {}, h("a.address", { href: address.href }, address.href)),
				picture, ...part(words.aim, aim), ...part(words.told, text), ...part(texts.lessons.challenge, challenge), ...part(texts.lessons.hint, hint),
				h("h3", {}, words.given), blocks,
				...part(words.ask, ask), h("div.lines", { "aria-hidden": "true" })),
		};
	}

	/** Draws the pictures of a sheet, which come late. The words can be read meanwhile. Returns whether the sheet is still shown. */
	async #draw(name, picture, blocks, solvedBlocks) {
		const [{ LESSONS }, { drawInto }, { loadMessages }, { solved, isSolvedBySystem }] = await Promise.all([import("../play/builtin/library.js"), import("../play/screen/pictures.js"), import("../play/blocks/messages.js"), import("./solutions.js")]);
		if (!picture.isConnected) return false;
		const { program } = LESSONS[name];
		await drawInto(picture, this.main, program);
		await loadMessages();
		const { showBlocks } = await import("../play/blocks/blockpicture.js");
		if (!blocks.isConnected) return false;
		showBlocks(blocks, program, HIGHEST);
		// a system is chosen above the world, so the blocks stay as they are
		if (isSolvedBySystem(name)) solvedBlocks.remove();
		else showBlocks(solvedBlocks, solved(name), HIGHEST_SOLVED);
		return true;
	}

	close() {}
}
