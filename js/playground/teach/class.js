/** The page of a class: what pupils have handed in, who has solved what, and each program with its picture, to play at a click. */
import { CARD, button, drawAll, fileButton, h } from "../shared/dom.js";
import { download } from "../shared/files/download.js";
import { handed } from "../shared/files/submissions.js";
import { failure, texts } from "../shared/language.js";
import { Requests } from "../shared/requests.js";

const words = texts.handing;
const LESSONS = texts.lessons.list;

/** The address at which a pupil's program plays. */
const addressIn = (work, number) => `#play/${handed.addressOf(work, number)}`;

/** When a work was handed in, in words. */
const dateOf = ({ when }) => new Intl.DateTimeFormat(document.documentElement.lang, { dateStyle: "medium", timeStyle: "short" }).format(when);

/** The lessons that each work was seen to do, or null if its programs cannot be played. A work that was not played yet is not in it. */
const solved = new WeakMap();

export class ClassPage {
	#requests = new Requests();

	/** @param {HTMLElement} main shows the page */
	constructor(main) {
		this.main = main;
		this.status = h("p.status", { role: "status" });
		this.code = h("textarea", { rows: 2, "aria-label": words.code, placeholder: words.codeHere });
		this.list = h("div.class");
		this.how = h("ol.steps.no-print", {}, ...words.classSteps.map((step) => h("li", {}, step)));
		this.forgetButton = button(words.forgetClass, () => this.#ask());
		this.tableButton = button(words.csv, () => download(this.#csv, "class.csv", "text/csv"));
		this.printButton = button(texts.teach.print, () => print());
		main.replaceChildren(h("section.sheet.wide", { "aria-label": words.classTitle },
			h("div.tools.no-print", {}, h("a", { href: "#teach" }, texts.teach.all), this.printButton),
			h("h2", {}, words.classTitle), this.how,
			h("div.tools.no-print", {}, fileButton(words.openFiles, ".json", (_, files) => this.take(files)), this.code, button(words.takeCode, () => this.#takeCode()), this.tableButton, this.forgetButton),
			this.status, this.list));
		this.#show();
	}

	/** Takes pupils' files. */
	async take(files) {
		const broken = [];
		let count = 0;
		for (const file of files) {
			try {
				if (await handed.take(await file.text(), file.name)) count++;
			} catch {
				broken.push(file.name);
			}
		}
		this.#say(broken.length > 0, words.taken(count, files.length - broken.length - count), broken.length > 0 ? words.broken(broken.join(", ")) : "");
		this.#show();
	}

	/** Says sentences, and whether the browser keeps the works. */
	#say(isProblem, ...sentences) {
		this.status.textContent = [...sentences, handed.isKept ? "" : words.notKept].join(" ").trim();
		this.status.classList.toggle("problem", isProblem);
	}

	async #takeCode() {
		const count = await handed.takeCodes(this.code.value);
		this.#say(count === null, count === null ? words.brokenCode : words.taken(count, count === 0 ? 1 : 0));
		if (count !== null) this.code.value = "";
		this.#show();
	}

	/** Asks whether all works are to be removed. */
	#ask() {
		this.status.classList.remove("problem");
		this.status.replaceChildren(`${words.askForget(handed.pupils.length)} `, button(words.forget, async () => {
			await handed.forget();
			this.status.textContent = "";
			this.#show();
		}));
	}

	#show() {
		delete this.main.dataset.drawn;
		delete this.main.dataset.checked;
		const { pupils } = handed;
		// of all that a pupil has handed in the newest counts
		const all = this.newest = pupils.map(([newest]) => newest);
		for (const each of [this.tableButton, this.forgetButton, this.printButton]) each.hidden = all.length === 0;
		this.how.hidden = all.length > 0;
		if (all.length === 0) {
			this.list.replaceChildren(h("p.note", {}, words.nothing));
			return;
		}
		const names = Object.keys(LESSONS);
		this.marks = all.map((work) => names.map((name) => ({ work, name, cell: h("td", { title: LESSONS[name].title }) })));
		this.sums = names.map(() => h("td"));
		this.list.replaceChildren(
			h("div.table", { tabindex: "0", role: "region", "aria-label": words.table }, h("table", {},
				h("thead", {}, h("tr", {}, h("th", { scope: "col" }, words.pupil), ...names.map((name, i) => h("th", { scope: "col", title: LESSONS[name].title }, h("a", { href: `#teach/${name}`, "aria-label": texts.teach.pageOf(i + 1) }, String(i + 1)))), h("th", { scope: "col" }, words.games), h("th", { scope: "col" }, words.programs))),
				h("tbody", {}, ...all.map((work, i) => h("tr", {}, h("th", { scope: "row" }, work.programs.length > 0 ? h("a", { href: addressIn(work, 0) }, work.pupil) : work.pupil), ...this.marks[i].map(({ cell }) => cell), h("td", {}, String(work.won.length)), h("td", {}, String(work.programs.length))))),
				h("tfoot", {}, h("tr", {}, h("th", { scope: "row" }, words.all(all.length)), ...this.sums, h("td"), h("td"))))),
			h("p.note", {}, words.signs),
			...pupils.map((works) => this.#pupil(...works)));
		this.#mark();
		const isNewest = this.#requests.begin();
		const isWanted = () => isNewest() && this.list.isConnected;
		Promise.all([this.#draw(), this.#check(isWanted)]).catch((error) => isWanted() && this.#fail(error));
	}

	/** Says that something could not be loaded. */
	#fail(error) {
		this.list.prepend(h("p.status.problem.no-print", { role: "alert" }, failure(error), " ", button(texts.again, () => this.#show())));
	}

	/** Writes the signs into the table: what was seen to be solved, what a pupil's file says, what is begun. */
	#mark() {
		const sign = (text, title) => h("span", { role: "img", "aria-label": title, title }, text);
		for (const { work, name, cell } of this.marks.flat()) {
			const seen = solved.get(work);
			const isSeen = seen?.has(name);
			const said = seen ? sign("✓?", words.notSeen) : sign("?", words.notPlayed);
			const isBegun = work.programs.some(({ lesson }) => lesson === name);
			cell.className = isSeen ? "done" : "";
			const mark = isSeen ? sign("✓", texts.lessons.done) : work.done.includes(name) ? said : isBegun ? sign("…", words.tried) : "";
			const at = work.programs.findIndex(({ lesson }) => lesson === name);
			cell.replaceChildren(mark && at >= 0 ? h("a", { href: addressIn(work, at) }, mark) : mark);
		}
		this.sums.forEach((cell, i) => {
			cell.textContent = this.marks.filter((row) => row[i].cell.className === "done").length;
		});
	}

	/** Plays the programs of all works, one after the other, to see which lessons they do. */
	async #check(isWanted) {
		const { solvedBy } = await import("./check.js");
		for (const work of this.newest) {
			if (solved.has(work)) continue;
			const found = await solvedBy(work, isWanted);
			if (!isWanted()) return;
			solved.set(work, found);
			this.#mark();
		}
		if (isWanted()) this.main.dataset.checked = "class";
	}

	/** The table as spreadsheets read it, with a mark of the encoding before it. */
	get #csv() {
		// a cell that begins like a formula would be run as one
		const cell = (text) => `"${String(text).replace(/^(?=[=+\-@\t])/, "'").replaceAll('"', '""')}"`;
		const rows = this.newest.map((work, i) => [work.pupil, dateOf(work), ...this.marks[i].map(({ cell: { textContent } }) => textContent), work.won.length, work.programs.length]);
		return `\uFEFF${[[words.pupil, words.when, ...Object.values(LESSONS).map(({ title }) => title), words.games, words.programs], ...rows].map((row) => row.map(cell).join(",")).join("\r\n")}\r\n`;
	}

	/** The part of the page about a pupil: the newest work, and the earlier ones folded below. */
	#pupil(work, ...earlier) {
		return h("section.pupil", { "aria-label": work.pupil },
			h("div.head", {}, h("h3", {}, work.pupil), h("small", {}, dateOf(work)), button("✕", async () => {
				await handed.remove(work.pupil);
				this.#show();
			}, { class: "no-print", "aria-label": words.remove(work.pupil), title: words.remove(work.pupil) })),
			work.programs.length === 0 ? h("p.note", {}, words.noPrograms) : h("ul.cards", {}, ...work.programs.map(({ name, lesson }, i) => h("li", {}, h("a.open", { href: addressIn(work, i) },
				h("span.picture", {}, h("img", { "data-program": handed.addressOf(work, i), alt: "", width: CARD[0], height: CARD[1] })),
				h("span.name", {}, name), Object.hasOwn(LESSONS, lesson) ? h("small", {}, texts.teach.numbered(Object.keys(LESSONS).indexOf(lesson) + 1, LESSONS[lesson].title)) : null)))),
			earlier.length === 0 ? null : h("details.no-print", {}, h("summary", {}, words.earlier(earlier.length)),
				...earlier.map((each) => h("p", {}, `${dateOf(each)}: `, ...each.programs.flatMap(({ name }, i) => [i > 0 ? ", " : "", h("a", { href: addressIn(each, i) }, name)])))));
	}

	async #draw() {
		const { Studio } = await import("../play/screen/pictures.js");
		const pictures = this.list.querySelectorAll("img");
		if (pictures.length === 0 || !this.list.isConnected) return;
		const studio = new Studio(this.main);
		try {
			const isDrawn = await drawAll(pictures, ({ dataset }) => {
				const { program, models } = handed.at(dataset.program);
				return studio.pictureOf(program, models, ...CARD);
			});
			if (isDrawn) this.main.dataset.drawn = "class";
		} finally {
			studio.close();
		}
	}
}
