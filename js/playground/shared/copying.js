/** Copies texts, links and listings. */
import { button, h } from "./dom.js";
import { texts } from "./language.js";

/** Puts a text on the clipboard. Returns whether the browser allows it. */
export async function toClipboard(text) {
	try {
		await navigator.clipboard.writeText(text);
		return true;
	} catch {
		return false;
	}
}

/** Puts a link to a part of the page on the clipboard. If the browser refuses, returns a field with the link, to copy it by hand. */
export async function copyLink(hash) {
	const address = new URL(location.href);
	address.hash = hash;
	if (await toClipboard(address.href)) return null;
	return h("input.address", { type: "text", readonly: true, value: address.href, "aria-label": texts.play.link });
}

/**
 * Makes a button that copies a listing, and what it says then.
 *
 * @param {HTMLElement} code contains the text, which is selected if the browser refuses to copy
 * @param {object} properties the button's attributes
 * @returns {HTMLElement[]} the button and the message
 */
export function copying(code, properties = {}) {
	const said = h("small", { role: "status" });
	const copy = async () => {
		const isCopied = await toClipboard(code.textContent);
		if (!isCopied) getSelection().selectAllChildren(code);
		said.textContent = isCopied ? texts.copying.copied : texts.copying.notCopied;
	};
	return [button(texts.copying.copy, copy, properties), said];
}

/** A listing that opens, with its button. More is put beside the button. */
export function listing(title, code, ...more) {
	return h("details.code", {}, h("summary", {}, title), h("div.tools", {}, ...copying(code), ...more), h("pre", { tabindex: "0", "aria-label": title }, code));
}
