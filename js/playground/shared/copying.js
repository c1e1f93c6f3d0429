/** A button that copies a listing, and what it says then. */
import { button, h } from "./dom.js";
import { texts } from "./language.js";

/**
 * Makes both.
 *
 * @param {HTMLElement} code contains the text, which is selected if the browser refuses to copy
 * @param {object} properties the button's attributes
 * @returns {HTMLElement[]} the button and the message
 */
export function copying(code, properties = {}) {
	const said = h("small", { role: "status" });
	const copy = async () => {
		try {
			await navigator.clipboard.writeText(code.textContent);
			said.textContent = texts.copying.copied;
		} catch {
			getSelection().selectAllChildren(code);
			said.textContent = texts.copying.notCopied;
		}
	};
	return [button(texts.copying.copy, copy, properties), said];
}

/** A listing that opens, with its button. More is put beside the button. */
export function listing(title, code, ...more) {
	return h("details.code", {}, h("summary", {}, title), h("div.tools", {}, ...copying(code), ...more), h("pre", { tabindex: "0", "aria-label": title }, code));
}
