/** All programs with pictures of how they begin: the user's own, which can be renamed and deleted, examples, lessons. */
import { button, h } from "../shared/dom.js";
import { texts } from "../shared/language.js";

const words = texts.gallery;

/**
 * Opens the gallery.
 *
 * @param {{title: string, canRename?: boolean, canRemove?: boolean, entries: {id: string, name: string, isDone?: boolean}[]}[]} groups
 * @param {{picture: (id: string) => string|null, open: (id: string) => void, rename: (id: string, name: string) => void, remove: (id: string) => void}} actions
 */
export function openGallery(groups, actions) {
	const dialog = h("dialog.gallery", { "aria-label": words.title, onclose: () => dialog.remove() });
	dialog.append(
		h("div.head", {}, h("h2", {}, words.title), button(words.close, () => dialog.close())),
		...groups.flatMap(({ title, entries, ...may }) => [
			h("h3", {}, title),
			entries.length === 0 ? h("p.note", {}, words.none) : h("ul.cards", {}, ...entries.map((entry) => card(entry, may, actions, dialog))),
		]));
	document.body.append(dialog);
	dialog.showModal();
	return dialog;
}

function card({ id, name, isDone }, { canRename, canRemove }, { picture, open, rename, remove }, dialog) {
	const address = picture(id);
	const act = (action) => () => {
		dialog.close();
		action(id);
	};
	const item = h("li", {}, h("button.open", { type: "button", onclick: act(open) }, address ? h("img", { src: address, alt: "", width: 240, height: 150 }) : h("span.blank"), h("span", {}, isDone ? `${name} ✓` : name)));
	if (!canRemove) return item;
	const input = h("input", { type: "text", value: name, maxlength: 40, "aria-label": words.rename(name), onchange: () => {
		const text = input.value.trim();
		if (text === "") input.value = name;
		else rename(id, text);
	} });
	item.append(h("div.own", {}, canRename ? input : null, button("✕", act(remove), { "aria-label": words.remove(name), title: words.remove(name) })));
	return item;
}
