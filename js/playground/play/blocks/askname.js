/** Asks for a name in a dialog of the page's own. */
import { button, h, openDialog } from "../../shared/dom.js";
import { texts } from "../../shared/language.js";

const words = texts.play.ask;

/**
 * Asks for a few words.
 *
 * @param {string} message the question
 * @param {string} value the first text
 * @param {number} longest the most letters of the answer
 * @returns {Promise<string|null>} the answer, or null if there is none
 */
export function ask(message, value, longest) {
	return new Promise((resolve) => {
		let answer = null;
		const note = h("small", { id: "ask-note", "aria-live": "polite" });
		const input = h("input", { type: "text", value, maxlength: longest, "aria-label": message, "aria-describedby": "ask-note", oninput: () => count() });
		const count = () => {
			note.textContent = words.letters(input.value.length, longest);
		};
		const take = () => {
			answer = input.value;
			dialog.close();
		};
		input.addEventListener("keydown", ({ key }) => {
			if (key === "Enter") take();
		});
		count();
		const dialog = openDialog("dialog.ask", message, h("p", {}, message), input, note,
			h("div.tools", {}, button(words.take, take, { class: "primary" }), button(words.leave, () => dialog.close())));
		dialog.addEventListener("close", () => resolve(answer));
	});
}
