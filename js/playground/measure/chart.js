/**
 * A chart of agents against milliseconds with logarithmic axes. Each system has a line with a sign. The lines of another machine are
 * dashed.
 */
import { plain } from "../shared/language.js";

/** The sizes of the chart with the names at the ends of the lines, and those with the names below it, for narrow windows. */
const WIDE = { left: 56, right: 150, top: 16, bottom: 44 };
const NARROW = { width: 350, height: 440, left: 46, right: 20, top: 16, bottom: 150 };
const NARROW_BELOW = 520;
const LEAST_HIGH = 200;
const MILLISECONDS = [0.001, 0.01, 0.1, 1, 10, 100, 1000];
const SPACE = "http://www.w3.org/2000/svg";
/** The systems' signs: paths around the middle. */
const SIGNS = ["M-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z", "M-4-4h8v8h-8z", "M0-5L5 4H-5z", "M0-5.500L5.500 0 0 5.500-5.500 0z", "M-4-4L4 4M-4 4L4-4"];
/** The distance between names at the ends of lines. */
const LINE = 15;

function s(tag, attributes, ...children) {
	const element = document.createElementNS(SPACE, tag);
	for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
	element.append(...children);
	return element;
}

const between = (value, low, high, from, to) => from + ((Math.log(value) - Math.log(low)) / (Math.log(high) - Math.log(low))) * (to - from);

/**
 * Draws the chart.
 *
 * @param {object} words the page's words for it
 * @param {number[]} counts the numbers of agents
 * @param {{name: string, points: number[][]}[]} systems their names, and pairs of a number of agents and milliseconds
 * @param {{name: string, points: number[][]}[]|null} others the same for another machine
 * @param {number} width the width that there is, in pixels; 0 if there is no place for it yet
 * @param {number} height the height that there is
 */
export function chart(words, counts, systems, others, width, height) {
	const isNarrow = width > 0 && width < NARROW_BELOW;
	const { left: LEFT, right: RIGHT, top: TOP, bottom: BOTTOM } = isNarrow ? NARROW : WIDE;
	// letters keep their size: a wide one is as large as its place
	const [WIDTH, HEIGHT] = isNarrow || width === 0 ? [NARROW.width, NARROW.height] : [width, Math.max(LEAST_HIGH, height)];
	const values = [...systems, ...(others ?? [])].flatMap(({ points }) => points.map(([, ms]) => ms));
	const low = Math.max(...MILLISECONDS.filter((each) => each <= Math.min(0.1, ...values)), MILLISECONDS[0]);
	const high = Math.min(...MILLISECONDS.filter((each) => each >= Math.max(100, ...values)), MILLISECONDS.at(-1));
	const x = (count) => between(count, counts[0], counts.at(-1), LEFT, WIDTH - RIGHT);
	const y = (ms) => between(Math.min(high, Math.max(low, ms)), low, high, HEIGHT - BOTTOM, TOP);
	const faint = { stroke: "currentColor", "stroke-opacity": 0.18 };
	const label = { fill: "currentColor", "font-size": 12 };
	const picture = s("svg", { xmlns: SPACE, viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": words.chart, "font-family": "system-ui, sans-serif" });
	for (const count of counts) {
		picture.append(s("line", { x1: x(count), x2: x(count), y1: TOP, y2: HEIGHT - BOTTOM, ...faint }), s("text", { x: x(count), y: HEIGHT - BOTTOM + 16, "text-anchor": "middle", ...label }, String(count)));
	}
	for (const ms of MILLISECONDS.filter((each) => each >= low && each <= high)) {
		picture.append(s("line", { x1: LEFT, x2: WIDTH - RIGHT, y1: y(ms), y2: y(ms), ...faint }), s("text", { x: LEFT - 6, y: y(ms) + 4, "text-anchor": "end", ...label }, plain(ms, 3)));
	}
	const frame = y(1000 / 60);
	picture.append(
		s("line", { x1: LEFT, x2: WIDTH - RIGHT, y1: frame, y2: frame, stroke: "currentColor", "stroke-dasharray": "1 5", "stroke-linecap": "round", "stroke-width": 2 }),
		s("text", { x: LEFT + 6, y: frame - 5, ...label }, words.frame),
		s("text", { x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - BOTTOM + 36, "text-anchor": "middle", ...label }, words.agents),
		s("text", { x: 14, y: (TOP + HEIGHT - BOTTOM) / 2, "text-anchor": "middle", transform: `rotate(-90 14 ${(TOP + HEIGHT - BOTTOM) / 2})`, ...label }, words.ms));
	const line = ({ name, points }, i, isOther) => {
		if (points.length === 0) return;
		const group = s("g", { "data-system": name, opacity: isOther ? 0.6 : 1 });
		group.append(s("polyline", { points: points.map(([count, ms]) => `${x(count).toFixed(1)},${y(ms).toFixed(1)}`).join(" "), fill: "none", stroke: "currentColor", "stroke-width": isOther ? 1 : 1.75, ...(isOther && { "stroke-dasharray": "6 4" }) }));
		for (const [count, ms] of points) group.append(s("path", { d: SIGNS[i], transform: `translate(${x(count).toFixed(1)} ${y(ms).toFixed(1)})`, fill: isOther || i === 4 ? "none" : "currentColor", stroke: "currentColor" }));
		picture.append(group);
	};
	(others ?? []).forEach((each, i) => line(each, i, true));
	systems.forEach((each, i) => line(each, i, false));
	if (isNarrow) list(picture, systems, LEFT, HEIGHT - BOTTOM + 62, label);
	else names(picture, systems, x, y, HEIGHT - BOTTOM, label);
	return picture;
}

/** Writes the names in a list. */
function list(picture, systems, left, top, label) {
	systems.forEach(({ name }, i) => {
		const y = top + i * LINE * 1.2;
		picture.append(s("path", { d: SIGNS[i], transform: `translate(${left + 6} ${y})`, fill: i === 4 ? "none" : "currentColor", stroke: "currentColor" }), s("text", { x: left + 18, y: y + 4, ...label }, name));
	});
}

/** Writes the names at the ends of the lines, so that none covers another, or is below the bottom, where the numbers of agents are. */
function names(picture, systems, x, y, bottom, label) {
	const ends = systems.map(({ name, points }, i) => ({ name, i, at: points.at(-1) })).filter(({ at }) => at).map(({ name, i, at: [count, ms] }) => ({ name, i, left: x(count), top: y(ms) }));
	ends.sort((a, b) => a.top - b.top);
	const tops = [];
	for (const { top } of ends) tops.push(Math.max(top, (tops.at(-1) ?? -Infinity) + LINE));
	for (let k = tops.length - 1; k >= 0; k--) tops[k] = Math.min(tops[k], (tops[k + 1] ?? bottom + LINE) - LINE);
	ends.forEach(({ name, i, left }, k) => {
		picture.append(s("path", { d: SIGNS[i], transform: `translate(${left + 14} ${tops[k]})`, fill: i === 4 ? "none" : "currentColor", stroke: "currentColor" }), s("text", { x: left + 24, y: tops[k] + 4, ...label }, name));
	});
}

/** The chart as a file's text, black on white. */
export function fileOf(picture) {
	const copy = picture.cloneNode(true);
	copy.setAttribute("color", "#1c2430");
	copy.prepend(s("rect", { width: "100%", height: "100%", fill: "#fff" }));
	return new XMLSerializer().serializeToString(copy);
}
