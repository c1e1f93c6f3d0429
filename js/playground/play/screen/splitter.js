/** The movable line between blocks and world. The pointer and arrow keys move it. */
import { h } from "../../shared/dom.js";
import { texts } from "../../shared/language.js";
import { recall, remember } from "../../shared/files/memory.js";

const KEY = "starlogo-playground.blocks-width";
/** A window that is lower than this, in pixels, gives the world more of its width. */
export const LOW = 700;
/** The least and the largest width of the blocks, in percent of the window. The first one is in style.css. */
const [LEAST, MOST] = [25, 72];
const STEP = 2;

/**
 * Makes the line.
 *
 * @param {HTMLElement} main its style gets the width
 * @param {HTMLElement} part the part of it on the left
 */
export function splitter(main, part) {
	const line = h("div.splitter", { role: "separator", tabindex: "0", "aria-orientation": "vertical", "aria-label": texts.play.splitter, "aria-valuemin": LEAST, "aria-valuemax": MOST, "aria-valuenow": LEAST });
	const percentOf = (pixels) => (pixels / main.getBoundingClientRect().width) * 100;
	const width = () => percentOf(part.getBoundingClientRect().width);
	const set = (percent) => main.style.setProperty("--blocks", `${Math.min(MOST, Math.max(LEAST, percent))}vw`);
	const keep = () => remember(KEY, String(width()));
	new ResizeObserver(() => line.setAttribute("aria-valuenow", String(Math.round(width())))).observe(part);
	if (Number(recall(KEY))) set(Number(recall(KEY)));
	line.addEventListener("pointerdown", (event) => {
		line.setPointerCapture(event.pointerId);
		event.preventDefault();
	});
	line.addEventListener("pointermove", (event) => {
		if (line.hasPointerCapture(event.pointerId)) set(percentOf(event.clientX - main.getBoundingClientRect().left));
	});
	line.addEventListener("pointerup", keep);
	line.addEventListener("keydown", (event) => {
		const to = { ArrowLeft: width() - STEP, ArrowRight: width() + STEP, Home: LEAST, End: MOST }[event.key];
		if (to === undefined) return;
		event.preventDefault();
		set(to);
		keep();
	});
	return line;
}
