/** Pictures of models from above or from the side: the triangles that face the viewer, from the farthest to the nearest. */
export class Pictures {
	#faces = new Map();
	#drawn = new Map();

	/** @param {boolean} isSideView whether models are seen from the side, z up, and not from above */
	constructor(isSideView = false) {
		this.isSideView = isSideView;
	}

	/** Agents may have the shape of this model from now on. */
	addModel({ name, vertices, triangles }) {
		const faces = [];
		for (let i = 0; i < triangles.length; i += 3) {
			const corners = [0, 1, 2].map((k) => vertices.slice(3 * triangles[i + k], 3 * triangles[i + k] + 3));
			const near = this.isSideView ? ([, y]) => -y : ([, , z]) => z;
			const light = nearOf(corners, this.isSideView);
			if (light > 0) faces.push({ corners: corners.map(([x, y, z]) => [x, this.isSideView ? z : y]), light, near: Math.max(...corners.map(near)) });
		}
		this.#faces.set(name, faces.sort((a, b) => a.near - b.near));
	}

	has(shape) {
		return this.#faces.has(shape);
	}

	/** A model's picture, drawn once. It is three times as wide as the model, because models may be taller than they are wide. */
	of(shape, colour, pixels) {
		const key = `${shape} ${colour} ${pixels}`;
		if (!this.#drawn.has(key)) {
			const picture = new OffscreenCanvas(3 * pixels, 3 * pixels);
			const context = picture.getContext("2d");
			context.setTransform(pixels, 0, 0, -pixels, 1.5 * pixels, 1.5 * pixels);
			context.lineWidth = 1 / pixels;
			for (const { corners, light } of this.#faces.get(shape)) {
				// steep faces are darker. A line of the same colour closes the seam to the next face
				context.fillStyle = context.strokeStyle = `color-mix(in srgb, ${colour} ${Math.round(45 + 55 * light)}%, #1c2a30)`;
				context.beginPath();
				for (const [x, y] of corners) context.lineTo(x, y);
				context.closePath();
				context.fill();
				context.stroke();
			}
			this.#drawn.set(key, picture);
		}
		return this.#drawn.get(key);
	}

	/** Forgets what is drawn, because the scale has changed. */
	clear() {
		this.#drawn.clear();
	}
}

/** How much a triangle faces the viewer: 1 fully, less than 0 if it faces away. */
function nearOf([a, b, c], isSideView) {
	const [u, v] = [b, c].map((corner) => corner.map((value, axis) => value - a[axis]));
	const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
	return (isSideView ? -normal[1] : normal[2]) / (Math.hypot(...normal) || 1);
}
