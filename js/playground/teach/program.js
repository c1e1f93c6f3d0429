/** A program to print: its name, its picture and its blocks. */
import { button, h } from "../shared/dom.js";
import { texts } from "../shared/language.js";
import { loadMessages } from "../play/blocks/messages.js";

const words = texts.teach;
/** The largest height of the blocks in pixels, so that everything fits on one sheet of paper. */
const HIGHEST = 640;
/** The smallest scale at which blocks can be read. A long program takes more than one sheet. */
const SMALLEST = 0.5;

/**
 * Shows a program's page.
 *
 * @param {HTMLElement} main shows the page
 * @param {string} address the program's name, its id, or its link
 * @returns {Promise<boolean>} whether there is such a program
 */
export async function showProgram(main, address) {
	const [{ AddressError, Finder }, { Shelf }] = await Promise.all([import("../play/programs/finder.js"), import("../play/programs/shelf.js")]);
	const found = await new Finder(new Shelf()).find(address).catch((error) => {
		if (!(error instanceof AddressError)) throw error;
	});
	if (!found) return false;
	const { title: name, program, pupil, models } = found;
	const picture = h("img.shown", { alt: words.picture(name), width: 800, height: 500 });
	const blocks = h("div.shown-blocks", { role: "img", "aria-label": words.program(name), inert: true });
	const system = texts.systems[program.system ?? "tightest fits"];
	main.replaceChildren(h("section.sheet", { "aria-label": name },
		h("div.tools.no-print", {}, h("a", { href: `#play/${address}` }, words.backToPlay), button(words.print, () => print(), { class: "primary" })),
		h("h2", {}, name), h("p.by", {}, `${texts.handing.name}: `, pupil ? h("strong", {}, pupil) : h("span.blank-line")), picture,
		h("p.note", {}, `${texts.play.system}: ${system}`), h("h3", {}, words.blocks), blocks));
	const [{ drawInto }, { ModelShelf }] = await Promise.all([import("../play/screen/pictures.js"), import("../play/programs/modelshelf.js"), loadMessages()]);
	const own = Object.entries(models ?? await ModelShelf.kept()).filter(([each]) => JSON.stringify(program).includes(JSON.stringify(each)));
	await drawInto(picture, main, program, Object.fromEntries(own));
	const { showBlocks } = await import("../play/blocks/blockpicture.js");
	if (!blocks.isConnected) return true;
	showBlocks(blocks, program, HIGHEST, SMALLEST);
	main.dataset.drawn = address;
	return true;
}
