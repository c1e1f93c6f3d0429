/** Draws an example on a canvas, in patches. It also moves agents, follows the pointer and calls each frame. It finds no collisions. */
import { Pictures, SHADOW } from "./pictures.js";

export const red = 0xe4572e, orange = 0xf3a712, yellow = 0xf7d154, green = 0x4caf6e, blue = 0x3f88c5, purple = 0x8f5fbf, brown = 0xb08a5e, grey = 0xa3adb8, white = 0xffffff;

const FRAMES_A_SECOND = 60;
const radians = (degrees) => (degrees * Math.PI) / 180;
const degrees = (y, x) => (Math.atan2(y, x) * 180) / Math.PI;
/** The colours of hills, from hollows to tops, a patch and a half apart, and the heights between lines. */
const HEIGHT_COLOURS = [[58, 128, 132], [84, 158, 112], [140, 190, 104], [214, 200, 128], [250, 244, 228]];
const CONTOUR = 0.5;
/** How dark shadows are. */
const DARKNESS = 0.24;
/** The place between two corners that has a height. */
const between = (low, high, height) => {
	const part = (height - low.height) / (high.height - low.height || 1);
	return { x: low.x + part * (high.x - low.x), y: low.y + part * (high.y - low.y) };
};
const css = (colour) => (typeof colour === "number" ? `#${colour.toString(16).padStart(6, "0")}` : colour);

export class Stage {
	/** The keys that are held down, by the names of KeyboardEvent. */
	keys = new Set();
	/** The place of the pointer, in patches. While the pointer is elsewhere, this place moves by itself. */
	pointer = { x: 0, y: 0, isDown: false };

	#context = null;
	#pictures;
	#isGuided = true;
	#frame = 0;
	#seed = 7;
	#clicked = null;

	/**
	 * @param {object} options
	 * @param {number} options.width patches from left to right
	 * @param {boolean} options.isSideView whether the land is seen from the side, z up, and not from above
	 * @param {boolean} options.hasKeys whether the example uses the arrow keys, so that they do not scroll the page
	 * @param {boolean} options.isEmpty whether something else draws on the canvas
	 */
	constructor({ width = 24, isSideView = false, hasKeys = false, isEmpty = false } = {}) {
		this.width = width;
		this.height = (width * 2) / 3;
		this.isSideView = isSideView;
		this.#pictures = new Pictures(isSideView);
		this.canvas = document.createElement("canvas");
		this.canvas.setAttribute("role", "img");
		this.canvas.setAttribute("aria-label", document.title);
		this.output = document.createElement("output");
		this.output.setAttribute("aria-live", "off");
		this.bar = document.createElement("div");
		this.bar.className = "bar";
		this.bar.append(this.output);
		document.querySelector(".picture").replaceChildren(this.canvas, this.bar);
		this.canvas.classList.toggle("side", isSideView);
		if (!isEmpty) this.#context = this.canvas.getContext("2d");
		this.#listen(hasKeys);
	}

	/** The right edge, in patches. */
	get right() { return this.width / 2; }
	/** The upper edge, in patches. */
	get top() { return this.height / 2; }

	/** Says something below the picture. */
	say(text) {
		if (this.output.textContent !== text) this.output.textContent = text;
	}

	/** A random number between two. Each run gets the same numbers. */
	random(from, to) {
		this.#seed = (this.#seed * 16807) % 2147483647;
		return from + ((to - from) * this.#seed) / 2147483647;
	}

	/** A random one of some values. */
	pick(...values) {
		return values[Math.floor(this.random(0, values.length))];
	}

	/** Calls a function when the picture is clicked or touched. */
	onClick(listener) {
		this.#clicked = listener;
	}

	/** Adds a button below the picture. */
	addButton(label, listener) {
		const button = Object.assign(document.createElement("button"), { textContent: label });
		button.addEventListener("click", () => listener(button));
		this.bar.append(button);
		return button;
	}

	/** Adds a box to tick below the picture. */
	addTick(label, isTicked) {
		const [box, tick] = [document.createElement("label"), document.createElement("input")];
		Object.assign(tick, { type: "checkbox", checked: isTicked });
		box.append(tick, label);
		this.bar.append(box);
		return tick;
	}

	/** Moves an agent along its heading. It turns back at the edges. */
	walk(agent, distance) {
		const [right, top] = [this.right - agent.size / 2, this.top - agent.size / 2];
		let [dx, dy] = [Math.cos(radians(agent.heading)), Math.sin(radians(agent.heading))];
		if (Math.abs(agent.x) > right) dx = -Math.sign(agent.x) * Math.abs(dx);
		if (Math.abs(agent.y) > top) dy = -Math.sign(agent.y) * Math.abs(dy);
		agent.heading = degrees(dy, dx);
		agent.moveTo(agent.x + distance * dx, agent.y + distance * dy, agent.z);
	}

	/** The way from an agent to the pointer, no longer than a distance. */
	wayToPointer(agent, distance) {
		const [dx, dy] = [this.pointer.x - agent.x, this.pointer.y - (this.isSideView ? agent.z : agent.y)];
		const part = Math.min(1, distance / (Math.hypot(dx, dy) || 1));
		return [dx * part, dy * part];
	}

	/** Moves an agent towards the pointer, by at most a distance. */
	follow(agent, distance = 0.3) {
		const [dx, dy] = this.wayToPointer(agent, distance);
		if (this.isSideView) agent.moveTo(agent.x + dx, agent.y, agent.z + dy);
		else agent.moveTo(agent.x + dx, agent.y + dy, agent.z);
		if (!this.isSideView && Math.hypot(dx, dy) > 0.01) agent.heading = degrees(dy, dx);
	}

	/** Calls a function sixty times a second. With ?frames=100 in the address it makes 100 calls at once, and stops. */
	run(step) {
		const wanted = Number(new URLSearchParams(location.search).get("frames"));
		const isStill = wanted > 0 || matchMedia("(prefers-reduced-motion: reduce)").matches;
		let isPaused = isStill;
		this.addButton(isPaused ? "Play" : "Pause", (button) => {
			isPaused = !isPaused;
			button.textContent = isPaused ? "Play" : "Pause";
		});
		for (let i = 0; i < (wanted || (isStill ? 120 : 1)); i++) this.#step(step);
		document.documentElement.dataset.frame = this.#frame;
		let [last, due] = [performance.now(), 0];
		const tick = (now) => {
			due = isPaused ? 0 : Math.min(2, due + ((now - last) * FRAMES_A_SECOND) / 1000);
			last = now;
			if (due > 0.9) {
				due = Math.max(0, due - 1);
				this.#step(step);
				document.documentElement.dataset.frame = this.#frame;
			}
			requestAnimationFrame(tick);
		};
		requestAnimationFrame(tick);
	}

	// drawing: places are in patches

	/**
	 * Draws agents with their shadows: balls, cubes, and the models that were added. With `faces` balls have eyes. With `isEndless` opposite edges are
	 * joined. Above a `ground` the shadows are the farther away the higher the agents are.
	 */
	draw(agents, { faces = false, alpha = 1, isEndless = false, ground = null } = {}) {
		const context = this.#context;
		const rounds = isEndless ? [-1, 0, 1] : [0];
		for (const right of rounds) for (const up of rounds) {
			context.save();
			context.translate(right * this.width, up * this.height);
			context.globalAlpha = DARKNESS * alpha;
			for (const agent of agents) {
				const height = ground ? Math.max(0, agent.z - ground.heightAt(agent.x, agent.y)) : 0;
				this.#drawAgent(agent, SHADOW, 0.12 + 0.5 * height);
			}
			context.globalAlpha = alpha;
			for (const agent of agents) {
				this.#drawAgent(agent, css(agent.color));
				if (faces) this.#drawFace(agent, agent.size / 2);
			}
			context.restore();
		}
	}

	/** Draws very many agents, as small squares. */
	drawDots(agents) {
		const paths = new Map();
		for (const { x, y, size, color } of agents) {
			if (!paths.has(color)) paths.set(color, new Path2D());
			paths.get(color).rect(x - size / 2, y - size / 2, size, size);
		}
		for (const [color, path] of paths) {
			this.#context.fillStyle = css(color);
			this.#context.fill(path);
		}
	}

	/** Agents may have the shape of this model from now on. */
	addModel(model) {
		this.#pictures.addModel(model);
	}

	line(from, to, colour, width = 0.08) {
		this.#stroke(colour, width, (path) => {
			path.moveTo(from.x, this.#up(from));
			path.lineTo(to.x, this.#up(to));
		});
	}

	/** Draws lines as the engine gives them: six numbers each, for two points. */
	lines(numbers, colour, width = 0.05) {
		const up = this.isSideView ? 2 : 1;
		this.#stroke(colour, width, (path) => {
			for (let i = 0; i < numbers.length; i += 6) {
				path.moveTo(numbers[i], numbers[i + up]);
				path.lineTo(numbers[i + 3], numbers[i + 3 + up]);
			}
		});
	}

	ring(place, radius, colour, width = 0.1) {
		this.#stroke(colour, width, (path) => path.arc(place.x, this.#up(place), radius, 0, 7));
	}

	/** Draws the ground from above. The light comes from the upper left, hollows are blue-green, tops are pale, and a line joins places of equal height. */
	hills(terrain) {
		const { columns, rows, cellWidth } = terrain;
		const [picture, pixels] = [new OffscreenCanvas(columns, rows), new ImageData(columns, rows)];
		const heightOf = (column, row) => terrain.getHeight(Math.max(0, Math.min(columns - 1, column)), Math.max(0, Math.min(rows - 1, row)));
		for (let row = 0; row < rows; row++) for (let column = 0; column < columns; column++) {
			const right = (heightOf(column + 1, row) - heightOf(column - 1, row)) / (2 * cellWidth);
			const up = (heightOf(column, row + 1) - heightOf(column, row - 1)) / (2 * cellWidth);
			const light = 0.62 + 0.5 * Math.max(0, (0.5 * right - 0.5 * up + 0.7) / Math.hypot(right, up, 1));
			const place = Math.max(0, Math.min(HEIGHT_COLOURS.length - 1.001, (heightOf(column, row) + 2.5) / 1.5));
			const [below, above] = [HEIGHT_COLOURS[Math.floor(place)], HEIGHT_COLOURS[Math.floor(place) + 1]];
			const colour = below.map((value, i) => (value + (above[i] - value) * (place % 1)) * light);
			pixels.data.set([...colour, 255], 4 * (row * columns + column));
		}
		picture.getContext("2d").putImageData(pixels, 0, 0);
		this.#context.drawImage(picture, terrain.x - cellWidth / 2, terrain.y - cellWidth / 2, columns * cellWidth, rows * cellWidth);
		this.#contours(terrain);
	}

	/** Draws the lines of equal height, half a patch apart: in each triangle of the ground the line from edge to edge. */
	#contours(terrain) {
		const { columns, rows, cellWidth } = terrain;
		this.#stroke("rgb(30 50 40 / 22%)", 0.04, (path) => {
			const cornerAt = (column, row) => ({ x: terrain.x + column * cellWidth, y: terrain.y + row * cellWidth, height: terrain.getHeight(column, row) });
			for (let row = 0; row < rows - 1; row++) for (let column = 0; column < columns - 1; column++) {
				const [a, b, c, d] = [cornerAt(column, row), cornerAt(column + 1, row), cornerAt(column, row + 1), cornerAt(column + 1, row + 1)];
				for (const corners of [[a, b, c], [b, d, c]]) {
					corners.sort((one, other) => one.height - other.height);
					const [low, middle, high] = corners;
					for (let height = Math.ceil(low.height / CONTOUR) * CONTOUR; height < high.height; height += CONTOUR) {
						if (height === low.height) continue; // a flat edge
						const [from, to] = [between(low, high, height), height < middle.height ? between(low, middle, height) : between(middle, high, height)];
						path.moveTo(from.x, from.y);
						path.lineTo(to.x, to.y);
					}
				}
			}
		});
	}

	/** Fills a polygon. */
	area(places, colour, alpha = 1) {
		const context = this.#context;
		context.globalAlpha = alpha;
		context.fillStyle = css(colour);
		context.beginPath();
		for (const place of places) context.lineTo(place.x, this.#up(place));
		context.fill();
		context.globalAlpha = 1;
	}

	/** Fills the slice of a circle in front of an agent. */
	slice(agent, radius, width, colour, alpha) {
		const places = [agent];
		for (let i = -width / 2; i <= width / 2; i += width / 24) {
			const angle = radians(agent.heading + i);
			places.push({ x: agent.x + radius * Math.cos(angle), y: agent.y + radius * Math.sin(angle) });
		}
		this.area(places, colour, alpha);
	}

	/** Writes words. */
	text(words, x, y, size = 0.7) {
		const context = this.#context;
		context.save();
		context.translate(x, y);
		context.scale(1, -1);
		context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--text");
		context.font = `600 ${size}px system-ui, sans-serif`;
		context.fillText(words, 0, 0);
		context.restore();
	}

	#up(place) {
		return this.isSideView ? place.z : place.y;
	}

	#step(step) {
		this.#frame++;
		if (this.#isGuided) {
			this.pointer.x = this.right * 0.72 * Math.sin(this.#frame / 67);
			this.pointer.y = this.top * 0.66 * Math.sin(this.#frame / 43 + 0.7);
		}
		if (this.#context) this.#clear();
		step(this.#frame);
	}

	#clear() {
		const pixels = Math.min(2, devicePixelRatio);
		const width = Math.round((this.canvas.clientWidth || 600) * pixels);
		if (this.canvas.width !== width) {
			this.canvas.width = width;
			this.canvas.height = Math.round((width * 2) / 3);
			this.#pictures.clear();
		}
		this.scale = width / this.width;
		const context = this.#context;
		context.setTransform(1, 0, 0, 1, 0, 0);
		context.clearRect(0, 0, this.canvas.width, this.canvas.height);
		context.setTransform(this.scale, 0, 0, -this.scale, this.canvas.width / 2, this.canvas.height / 2);
		context.lineCap = context.lineJoin = "round";
	}

	#stroke(colour, width, make) {
		const context = this.#context;
		context.strokeStyle = css(colour);
		context.lineWidth = width;
		context.beginPath();
		make(context);
		context.stroke();
	}

	/** Draws an agent or its shadow, so far to the lower right. */
	#drawAgent(agent, colour, away = 0) {
		const context = this.#context;
		const { shape, size } = agent;
		context.save();
		// the place of a ball or cube that is seen from the side is below it
		context.translate(agent.x + away, this.#up(agent) - away + (this.isSideView && !this.#pictures.has(shape) ? size / 2 : 0));
		if (!this.isSideView && shape !== "sphere") context.rotate(radians(agent.heading));
		if (shape === "cube") this.#drawCube(size, colour);
		else {
			const pixels = Math.ceil(size * this.scale);
			const picture = this.#pictures.of(shape, colour, pixels);
			const width = (size * picture.width) / pixels;
			context.scale(1, -1);
			context.drawImage(picture, -width / 2, -width / 2, width, width);
		}
		context.restore();
	}

	#drawCube(size, colour) {
		const context = this.#context;
		context.fillStyle = colour;
		context.fillRect(-size / 2, -size / 2, size, size);
		if (colour === SHADOW) return;
		context.strokeStyle = "rgb(0 0 0 / 28%)";
		context.lineWidth = 0.06;
		context.strokeRect(-size / 2 + 0.03, -size / 2 + 0.03, size - 0.06, size - 0.06);
		context.fillStyle = "rgb(255 255 255 / 18%)"; // its top, within bevelled edges
		context.fillRect(-0.38 * size, -0.38 * size, 0.76 * size, 0.76 * size);
	}

	#drawFace({ x, y, heading }, radius) {
		const context = this.#context;
		for (const side of [-0.5, 0.5]) {
			const angle = radians(heading) + side;
			for (const [size, out, colour] of [[0.26, 0.62, "#fff"], [0.13, 0.72, "#1d2530"]]) {
				context.beginPath();
				context.arc(x + out * radius * Math.cos(angle), y + out * radius * Math.sin(angle), size * radius, 0, 7);
				context.fillStyle = colour;
				context.fill();
			}
		}
	}

	#listen(hasKeys) {
		const { canvas } = this;
		const follow = (event) => {
			const box = canvas.getBoundingClientRect();
			this.#isGuided = false;
			this.pointer.x = ((event.clientX - box.left) / box.width - 0.5) * this.width;
			this.pointer.y = (0.5 - (event.clientY - box.top) / box.height) * this.height;
		};
		canvas.addEventListener("pointermove", follow);
		canvas.addEventListener("pointerdown", (event) => {
			follow(event);
			this.pointer.isDown = true;
			this.#clicked?.(this.pointer);
		});
		for (const type of ["pointerup", "pointercancel"]) addEventListener(type, () => { this.pointer.isDown = false; });
		canvas.addEventListener("pointerleave", () => { this.#isGuided = true; });
		addEventListener("keydown", (event) => {
			this.keys.add(event.key);
			if (hasKeys && event.key.startsWith("Arrow")) event.preventDefault();
		});
		addEventListener("keyup", ({ key }) => this.keys.delete(key));
		addEventListener("blur", () => this.keys.clear());
	}
}
