/** What agents look like from above: their models' triangles that face upwards, from the lowest to the highest. */
export class Pictures {
	#context;
	#pixelsAPatch;
	#faces = new Map();
	#drawn = new Map();

	constructor(context, pixelsAPatch) {
		this.#context = context;
		this.#pixelsAPatch = pixelsAPatch;
	}

	/** Agents may have the shape of this model from now on. */
	addModel({ name, vertices, triangles }) {
		const faces = [];
		for (let i = 0; i < triangles.length; i += 3) {
			const corners = [0, 1, 2].map((k) => vertices.slice(3 * triangles[i + k], 3 * triangles[i + k] + 3));
			const up = upOf(corners);
			if (up > 0) faces.push({ corners, up, top: Math.max(...corners.map(([, , z]) => z)) });
		}
		this.#faces.set(name, faces.sort((a, b) => a.top - b.top));
	}

	/** Draws an agent in a colour. */
	draw({ shape, x, y, heading, size }, colour) {
		const context = this.#context;
		const { canvas } = context;
		const picture = this.#pictureOf(shape, colour, Math.ceil(size * this.#pixelsAPatch * 1.2));
		context.setTransform(1, 0, 0, 1, canvas.width / 2 + x * this.#pixelsAPatch, canvas.height / 2 - y * this.#pixelsAPatch);
		context.rotate((-heading * Math.PI) / 180);
		context.drawImage(picture, -picture.width / 2, -picture.height / 2);
	}

	/** A picture that is a fifth wider than the model, drawn once. */
	#pictureOf(shape, colour, pixels) {
		const key = `${shape} ${colour} ${pixels}`;
		if (!this.#drawn.has(key)) {
			const picture = new OffscreenCanvas(pixels, pixels);
			const context = picture.getContext("2d");
			context.setTransform(pixels / 1.2, 0, 0, -pixels / 1.2, pixels / 2, pixels / 2);
			for (const face of this.#faces.get(shape)) drawFace(context, face, colour, 1 / pixels);
			this.#drawn.set(key, picture);
		}
		return this.#drawn.get(key);
	}
}

/** Fills a triangle: the steeper, the darker. A line of the same colour closes the seams between neighbours. */
function drawFace(context, { corners, up }, colour, lineWidth) {
	context.fillStyle = `color-mix(in srgb, ${colour} ${Math.round(45 + 55 * up)}%, #1c2a30)`;
	context.strokeStyle = context.fillStyle;
	context.lineWidth = lineWidth;
	context.beginPath();
	for (const [x, y] of corners) context.lineTo(x, y);
	context.closePath();
	context.fill();
	context.stroke();
}

/** How far a triangle's normal points up: 1 for what is level, less than 0 for what faces down. */
function upOf([a, b, c]) {
	const [u, v] = [b, c].map((corner) => corner.map((value, axis) => value - a[axis]));
	const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
	return normal[2] / (Math.hypot(...normal) || 1);
}
