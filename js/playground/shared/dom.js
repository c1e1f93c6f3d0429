/** Makes elements with few words. Styles are classes, because the page's policy allows no style attributes. */
import { mainFileOf } from "./files/files.js";
import { fixed } from "./language.js";

/**
 * Makes an element.
 *
 * @param {string} tag its name, with classes: "div.card.wide"
 * @param {object} properties attributes; names that begin with "on" are listeners; null and false are left out
 * @param {...(Node|string|null)} children its content
 */
export function h(tag, properties = {}, ...children) {
	const [name, ...classes] = tag.split(".");
	const element = document.createElement(name);
	if (classes.length > 0) element.className = classes.join(" ");
	for (const [key, value] of Object.entries(properties)) {
		if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
		else if (value === true) element.setAttribute(key, "");
		else if (value !== null && value !== undefined && value !== false) element.setAttribute(key, value);
	}
	element.append(...children.filter((child) => child !== null));
	return element;
}

let labelled = 0;

/** A control with a label above it. */
export function field(label, control, note = null) {
	control.id ||= `control-${++labelled}`;
	const hint = note === null ? null : h("small", { id: `${control.id}-note` }, note);
	if (hint) control.setAttribute("aria-describedby", hint.id);
	return h("div.field", {}, h("label", { for: control.id }, label), control, hint);
}

/** A menu. Its options are [value, text]. */
export function choice(options, value, onChange) {
	const select = h("select", { onchange: () => onChange(select.value) }, ...options.map(([each, text]) => h("option", { value: each, selected: each === value }, text)));
	return select;
}

/** The modes of a view, of which one is chosen: words.mode names them, and words.modes has the text of each. */
export const modes = (words, chosen, onPick) => h("div.modes", { role: "radiogroup", "aria-label": words.mode }, ...Object.entries(words.modes).map(([name, text]) => h("label.tick", {},
	h("input", { type: "radio", name: "mode", value: name, checked: name === chosen, onchange: () => onPick(name) }), text)));

/** A check box with its label. */
export function checkBox(label, checked, onChange) {
	const box = h("input", { type: "checkbox", checked, onchange: () => onChange(box.checked) });
	return h("label.tick", {}, box, label);
}

/** A slider with its label and value. */
export function slider(label, { min, max, step, value, format = String }, onInput) {
	const output = h("output", {}, format(value));
	const input = h("input", { type: "range", min, max, step, value });
	const show = () => {
		output.textContent = format(Number(input.value));
	};
	input.addEventListener("input", () => {
		show();
		onInput(Number(input.value));
	});
	const element = h("div.slider", {}, field(label, input), output);
	return {
		element,
		input,
		set(next) {
			input.value = next;
			show();
		},
	};
}

/** A table: the contents of its heads, and its rows. */
export const table = (heads, rows, ...more) => h("table", {}, h("thead", {}, h("tr", {}, ...heads.map((head) => h("th", { scope: "col" }, head)))), h("tbody", {}, ...rows), ...more);

export function button(text, onclick, properties = {}) {
	return h("button", { type: "button", onclick, ...properties }, text);
}

/** Opens a dialog of the page's own. It is gone when it is closed. */
export function openDialog(tag, label, ...content) {
	const dialog = h(tag, { "aria-label": label, onclose: () => dialog.remove() }, ...content);
	document.body.append(dialog);
	dialog.showModal();
	return dialog;
}

/** A button that asks for files. onFile is called with the main file, and with all files. */
export function fileButton(text, accept, onFile) {
	const input = h("input.visually-hidden", { type: "file", accept, multiple: true, tabindex: "-1", "aria-hidden": "true", onchange: () => {
		const files = [...input.files];
		if (files.length > 0) onFile(mainFileOf(files), files);
		input.value = "";
	} });
	return h("span", {}, button(text, () => input.click()), input);
}

/** Calls a function when the user's preference for light or dark changes. */
export function onThemeChange(listener) {
	const query = matchMedia("(prefers-color-scheme: dark)");
	query.addEventListener("change", listener);
	return () => query.removeEventListener("change", listener);
}

export const isDark = () => matchMedia("(prefers-color-scheme: dark)").matches;

/** A number with three significant digits. */
export function short(value) {
	if (!Number.isFinite(value)) return "–";
	const digits = Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : Math.abs(value) >= 1 ? 2 : 3;
	return fixed(value, digits);
}

/** The width and the height of a picture on a card, in pixels. */
export const CARD = [240, 150];

/**
 * Draws pictures one after the other, so that the page stays responsive. One that cannot be drawn becomes blank.
 *
 * @param {Iterable<HTMLImageElement>} pictures
 * @param {(picture: HTMLImageElement) => Promise<string|null>} addressOf
 * @returns {Promise<boolean>} whether all are drawn. False if they have left the page
 */
export async function drawAll(pictures, addressOf) {
	for (const picture of pictures) {
		await new Promise((resolve) => setTimeout(resolve));
		if (!picture.isConnected) return false;
		const address = await addressOf(picture);
		if (address) picture.src = address;
		else picture.replaceWith(h("span.blank"));
	}
	return true;
}
