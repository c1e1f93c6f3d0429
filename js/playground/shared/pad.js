/** A key of the key pad below a game's world: a button that is held as long as the pointer, Enter or Space is. */
import { button, h } from "./dom.js";
import { texts } from "./language.js";

/**
 * @param {string} name the key's name in the words of all languages, or its letter
 * @param {string} does what the key does
 * @param {() => void} press
 * @param {() => void} release
 */
export function padKey(name, does, press, release) {
	const { keysOf, keyName } = texts.play;
	const pad = button(h("kbd", {}, keysOf[name] ?? name.toUpperCase()), () => {}, { class: `key ${name}`, "aria-label": keyName(does) });
	pad.append(h("span", {}, does));
	// the game keeps the keyboard; without it, all keys would be released
	pad.addEventListener("mousedown", (event) => event.preventDefault());
	pad.addEventListener("pointerdown", (event) => {
		pad.setPointerCapture(event.pointerId);
		press();
	});
	pad.addEventListener("keydown", (event) => {
		if (event.key === "Enter" || event.key === " ") press();
	});
	for (const type of ["pointerup", "pointercancel", "keyup", "blur"]) pad.addEventListener(type, release);
	return pad;
}
