/** A menu of buttons that opens above the page. The browser closes it: by Escape, by a click elsewhere. */
import { h } from "../../shared/dom.js";

let menus = 0;
const GAP = 4;

/** @param {...HTMLElement} entries its buttons. A click on one closes it. */
export const menu = (...entries) => h("div.menu", { popover: "auto", id: `menu-${++menus}`, onclick: ({ currentTarget, target }) => {
	if (target.closest("button")) currentTarget.hidePopover?.();
} }, ...entries);

/** The button that opens a menu below itself. */
export function menuButton(name, list) {
	const opener = h("button.tool.tool-menu", { type: "button", popovertarget: list.id, "aria-label": name, title: name });
	list.addEventListener("toggle", ({ newState }) => {
		if (newState !== "open") return;
		const { right, bottom } = opener.getBoundingClientRect();
		list.style.top = `${Math.min(bottom + GAP, innerHeight - list.offsetHeight - GAP)}px`;
		list.style.left = `${Math.max(GAP, right - list.offsetWidth)}px`;
		list.querySelector("button:not(:disabled)").focus();
	});
	return opener;
}
