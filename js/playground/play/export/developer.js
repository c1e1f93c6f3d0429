/** Shows a program as a JavaScript module, to copy or download, with links to documentation and examples. */
import { copying } from "../../shared/copying.js";
import { button, h, openDialog } from "../../shared/dom.js";
import { download } from "../../shared/files/download.js";
import { texts } from "../../shared/language.js";
import { DOCS } from "../../shared/files/served.js";
import { javascriptOf } from "./javascript.js";
import { pageOf } from "./javascriptpage.js";

const words = texts.play.javascript;

/**
 * Opens a dialog with a program's module.
 *
 * @param {object} program in Blockly's notation
 * @param {string} title the program's title
 * @param {string} file the file's name without its ending
 * @param {Map} models by their names
 */
export function showJavascript(program, title, file, models) {
	const text = javascriptOf(program, title, models, file);
	const code = h("code", {}, text);
	const [copy, said] = copying(code, { class: "primary" });
	const dialog = openDialog("dialog.ask.javascript", words.title,
		h("h2", {}, words.title), h("p", {}, words.note),
		h("div.tools", {}, copy, button(words.download, () => download(text, `${file}.mjs`, "text/javascript")), button(words.page, () => download(pageOf(program, title, models, file), `${file}.html`, "text/html")),
			...(DOCS ? [h("a", { href: `${DOCS}index.html`, target: "_blank" }, words.documentation), h("a", { href: `${DOCS}examples.html`, target: "_blank" }, words.examples)] : []), said,
			button(texts.gallery.close, () => dialog.close(), { class: "close" })),
		h("pre", { tabindex: "0", "aria-label": words.title }, code));
}
