/** The movable line between blocks and world. The pointer and arrow keys move it. */
import { h } from "../shared/dom.js";
import { texts } from "../shared/language.js";
import { recall, remember } from "../shared/memory.js";

const KEY = "starlogo-playground.blocks-width";
/** A window that is lower than this, in pixels, gives the world more of its width. */
export const LOW = 700;
/** The least, the largest and the first width of the blocks, in percent of the window, and the first one in a low window: as in style.css. */
const [LEAST, MOST, FIRST, FIRST_IN_LOW] = [25, 72, 48, 40];
const STEP = 2;

/**
 * Makes the line.
 *
 * @param {HTMLElement} main its style gets the width
 */
export function splitter(main) {
	const line = h("div.splitter", { role: "separator", tabindex: "0", "aria-orientation": "vertical", "aria-label": texts.play.splitter, "aria-valuemin": LEAST, "aria-valuemax": MOST });
	let width = innerHeight < LOW ? FIRST_IN_LOW : FIRST;
	line.setAttribute("aria-valuenow", String(width));
	const set = (percent) => {
		width = Math.min(MOST, Math.max(LEAST, percent));
		main.style.setProperty("--blocks", `${width}vw`);
		line.setAttribute("aria-valuenow", String(Math.round(width)));
	};
	const keep = () => remember(KEY, String(width));
	if (Number(recall(KEY))) set(Number(recall(KEY)));
	line.addEventListener("pointerdown", (event) => {
		line.setPointerCapture(event.pointerId);
		event.preventDefault();
	});
	line.addEventListener("pointermove", (event) => {
		if (!line.hasPointerCapture(event.pointerId)) return;
		const { left, width: all } = main.getBoundingClientRect();
		set(((event.clientX - left) / all) * 100);
	});
	line.addEventListener("pointerup", keep);
	line.addEventListener("keydown", (event) => {
		const to = { ArrowLeft: width - STEP, ArrowRight: width + STEP, Home: LEAST, End: MOST }[event.key];
		if (to === undefined) return;
		event.preventDefault();
		set(to);
		keep();
	});
	return line;
}
