/** The graph of the parts of the last frames: moving, the engine and drawing one above the other, and other libraries as lines. */

import { short } from "../shared/dom.js";
import { isUneven } from "../shared/timing.js";

/** The frames in the graph. */
const FRAMES = 180;
/** The number of averages of which the least is shown. */
const AVERAGES = 15;
/** A frame of 60 a second, in milliseconds, and the least height of the graph, which is a little more. */
const FRAME = 1000 / 60;
const LEAST = 1.15 * FRAME;
const LEFT = 56;
/** The radius of the dots of the lines. */
const DOT = 2.5;

export class Parts {
	#frames = [];

	/**
	 * @param {HTMLCanvasElement} canvas
	 * @param {string[]} names the names of the parts, which begin at the bottom
	 * @param {string[]} lines the names of the lines
	 * @param {{empty: string, limit: string}} words stand in the graph: as long as it is empty, and above the time of a frame
	 */
	constructor(canvas, names, lines, words) {
		Object.assign(this, { canvas, names, lines, words });
	}

	clear() {
		this.#frames.length = 0;
	}

	/** The number of frames in the graph. */
	get count() {
		return this.#frames.length;
	}

	/** Adds a frame: the milliseconds of each part by its name. */
	add(frame) {
		this.#frames.push(frame);
		if (this.#frames.length > FRAMES) this.#frames.shift();
	}

	/** The least of each name: of averages over a fifteenth of the last frames each, because clocks are coarse. If the clock is too coarse for that, the average of all. */
	get leasts() {
		return Object.fromEntries([...this.names, ...this.lines].map((name) => {
			const all = this.#averages(name);
			return [name, all.length > 0 ? Math.min(...all) || all.reduce((sum, ms) => sum + ms, 0) / all.length : NaN];
		}));
	}

	/** Whether something else may have taken time in the last frames. */
	get isBusy() {
		return this.#frames.length === FRAMES && isUneven(this.#averages("engine"));
	}

	#averages(name) {
		const times = this.#timesOf(name);
		const count = Math.max(1, Math.ceil(times.length / AVERAGES));
		return Array.from({ length: Math.ceil(times.length / count) }, (_, i) => times.slice(count * i, count * (i + 1))).map((part) => part.reduce((sum, ms) => sum + ms, 0) / part.length);
	}

	/** The times of a name, in the frames that have one. */
	#timesOf(name) {
		return this.#frames.map((frame) => frame[name]).filter(Number.isFinite);
	}

	/** Draws the graph in the colours of the page. */
	draw() {
		const { canvas, names, lines } = this;
		const ratio = Math.min(2, devicePixelRatio);
		const { clientWidth: width, clientHeight: height } = canvas;
		if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
		if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
		const context = canvas.getContext("2d");
		const style = getComputedStyle(canvas);
		const colourOf = (name) => style.getPropertyValue(`--part-${name}`);
		const bars = this.#frames.map((frame) => names.reduce((sum, name) => sum + frame[name], 0));
		const most = Math.max(LEAST, ...[bars, ...lines.map((name) => this.#timesOf(name))].map((times) => 1.1 * usualMost(times)));
		const step = (width - LEFT) / FRAMES;
		const y = (ms) => height - (ms / most) * (height - 10);
		context.setTransform(ratio, 0, 0, ratio, 0, 0);
		context.clearRect(0, 0, width, height);
		this.#frames.forEach((frame, i) => {
			let from = 0;
			for (const name of names) {
				context.fillStyle = colourOf(name);
				context.fillRect(LEFT + i * step, y(from + frame[name]), Math.max(1, step), y(from) - y(from + frame[name]));
				from += frame[name];
			}
		});
		// what is longer than the graph is high has its dot at the top
		for (const line of lines) this.#drawLine(context, line, colourOf(line), (i) => LEFT + (i + 0.5) * step, (ms) => Math.max(DOT, y(ms)));
		context.fillStyle = context.strokeStyle = style.color;
		context.lineWidth = 1;
		context.font = "12px system-ui, sans-serif";
		context.textAlign = "right";
		context.setLineDash([1, 4]);
		for (const ms of most > 1.5 * FRAME ? [FRAME, most] : [FRAME]) {
			context.beginPath();
			context.moveTo(LEFT, y(ms));
			context.lineTo(width, y(ms));
			context.stroke();
			context.fillText(`${short(ms)} ms`, LEFT - 4, Math.max(10, y(ms) + 4));
		}
		context.setLineDash([]);
		context.fillText(this.words.limit, width - 6, y(FRAME) - 5);
		if (this.#frames.length > 0) return;
		context.font = "15px system-ui, sans-serif";
		context.textAlign = "center";
		context.fillText(this.words.empty, (LEFT + width) / 2, y(most / 2), width - LEFT - 16);
	}

	/** Draws a dot for each frame in which another library was asked. A faint line joins them, so that the parts below it stay in sight. */
	#drawLine(context, name, colour, x, y) {
		const asked = this.#frames.map((frame, i) => [i, frame[name]]).filter(([, ms]) => Number.isFinite(ms));
		context.strokeStyle = context.fillStyle = colour;
		context.globalAlpha = 0.35;
		context.beginPath();
		for (const [i, ms] of asked) context.lineTo(x(i), y(ms));
		context.stroke();
		context.globalAlpha = 1;
		context.beginPath();
		for (const [i, ms] of asked) {
			context.moveTo(x(i), y(ms));
			context.arc(x(i), y(ms), DOT, 0, 2 * Math.PI);
		}
		context.fill();
	}
}

/** The longest of some times, but for the longest tenth: a few long frames do not make all others small. 0 if there is none. */
const usualMost = (times) => [...times].sort((a, b) => a - b)[Math.floor(0.9 * (times.length - 1))] ?? 0;
