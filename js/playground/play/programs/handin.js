/** Hands in a pupil's work: lessons, games, programs and models, as a file or a code for the teacher. Makes room for the next pupil. */
import { CollisionBlocks } from "starlogo-collision";
import { toClipboard } from "../../shared/copying.js";
import { button, field, h, openDialog } from "../../shared/dom.js";
import { download } from "../../shared/files/download.js";
import { toCode, toFile } from "../../shared/files/submissions.js";
import { texts } from "../../shared/language.js";
import { recall, remember } from "../../shared/files/memory.js";
import { fileName, meaning } from "./programtext.js";

const words = texts.handing;
const KEY = "starlogo-playground.pupil";

const keepName = (name) => remember(KEY, name || null);

/** All of the pupil's work. The programs that did lessons go along, so that the teacher's page can play them again. */
function workOf({ shelf, progress, view }, pupil) {
	const programs = shelf.all.map(({ name, lesson, program }) => ({ name, ...(lesson && { lesson }), program }));
	const isListed = (name, solution) => programs.some(({ lesson, program }) => lesson === name && (program.system ?? CollisionBlocks.TIGHTEST_FITS) === solution.system && meaning(program) === meaning(solution));
	const solutions = Object.fromEntries(Object.entries(shelf.solutions).filter(([name, solution]) => !isListed(name, solution)));
	return { pupil, ...progress.results, programs, solutions, models: view.modelShelf.filesFor([programs, solutions]) };
}

/** The numbers of lessons that were done, of programs, and of games that were won. */
function countsOf({ shelf, progress }) {
	const { done, won } = progress.results;
	return [done.length, shelf.all.length, won.length];
}

const openSheet = (title, ...content) => openDialog("dialog.ask.handing", title, h("h2", {}, title), ...content);

/**
 * Opens a dialog that hands in.
 *
 * @param {import("./programs.js").Programs} programs
 */
export function handIn(programs) {
	if (countsOf(programs).every((count) => count === 0)) {
		const dialog = openSheet(words.title, h("p", {}, words.noWork), h("div.tools", {}, button(texts.gallery.close, () => dialog.close())));
		return;
	}
	const said = h("p.note", { role: "status" });
	const place = h("textarea", { readonly: true, rows: 4, hidden: true, "aria-label": words.code });
	const name = h("input", { type: "text", maxlength: 60, value: recall(KEY) ?? "", autocomplete: "off", onchange: () => keepName(name.value.trim()) });
	const work = () => {
		const pupil = name.value.trim();
		if (pupil !== "") return workOf(programs, pupil);
		said.textContent = words.needsName;
		name.focus();
		return null;
	};
	const save = () => {
		const all = work();
		if (!all) return;
		download(toFile(all), words.fileName(fileName(all.pupil)), "application/json");
		said.textContent = words.saved(words.fileName(fileName(all.pupil)));
		leave.textContent = texts.gallery.close;
	};
	const copy = async () => {
		const all = work();
		if (!all) return;
		const code = await toCode(all);
		place.value = code;
		place.hidden = false;
		place.select();
		const isCopied = await toClipboard(code);
		said.textContent = isCopied ? words.copied(code.length) : words.notCopied;
		if (isCopied) leave.textContent = texts.gallery.close;
	};
	// who has handed in has nothing to cancel
	const leave = button(texts.play.ask.leave, () => dialog.close());
	const dialog = openSheet(words.title,
		h("p", {}, words.what(...countsOf(programs))), field(words.name, name),
		h("div.tools", {}, button(words.save, save, { class: "primary" }), button(words.copy, copy), leave),
		said, place, h("p.note", {}, words.how));
	if (name.value === "") name.focus();
}

/** Makes the browser forget everything of its user, for the next one. */
async function forgetAll({ shelf, progress, view }) {
	keepName("");
	shelf.forget();
	progress.forget();
	await view.modelShelf.forgetAll();
	location.hash = "play/all";
	location.reload();
}

/** Opens a dialog that makes the browser forget this pupil. */
export function nextPupil(programs) {
	const dialog = openSheet(texts.gallery.nextPupil, h("p", {}, words.nextNote(...countsOf(programs))),
		h("div.tools", {}, button(words.handFirst, () => {
			dialog.close();
			handIn(programs);
		}, { class: "primary" }), button(words.forget, () => {
			forgetAll(programs);
		}), button(texts.play.ask.leave, () => dialog.close())));
}
