/** The colour of shadows: nothing shines on them. */
export const SHADOW = "#0a1e1e";

/** Pictures of balls, and of models from above or from the side: the triangles that face the viewer, from the farthest to the nearest. */
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
		faces.sort((a, b) => a.near - b.near);
		this.#faces.set(name, { faces, reach: Math.max(...faces.flatMap(({ corners }) => corners.flat().map(Math.abs))) });
	}

	has(shape) {
		return this.#faces.has(shape);
	}

	/** A picture of a ball or a model that is so many pixels wide, drawn once. It is larger, because models may be taller than they are wide. */
	of(shape, colour, pixels) {
		const key = `${shape} ${colour} ${pixels}`;
		if (!this.#drawn.has(key)) {
			const { faces, reach } = this.#faces.get(shape) ?? { reach: 0.5 };
			const width = Math.ceil(2 * reach * pixels) + 4;
			const picture = new OffscreenCanvas(width, width);
			const context = picture.getContext("2d");
			context.setTransform(pixels, 0, 0, -pixels, width / 2, width / 2);
			context.lineWidth = Math.min(0.06, 1 / pixels);
			if (faces) drawFaces(context, faces, colour);
			else drawBall(context, colour);
			this.#drawn.set(key, picture);
		}
		return this.#drawn.get(key);
	}

	/** Forgets what is drawn, because the scale has changed. */
	clear() {
		this.#drawn.clear();
	}
}

function drawFaces(context, faces, colour) {
	for (const { corners, light } of faces) {
		// steep faces are darker. A line of the same colour closes the seam to the next face
		context.fillStyle = context.strokeStyle = `color-mix(in srgb, ${colour} ${Math.round(45 + 55 * light)}%, #1c2a30)`;
		context.beginPath();
		for (const [x, y] of corners) context.lineTo(x, y);
		context.closePath();
		context.fill();
		context.stroke();
	}
}

/** Draws a ball with light from the upper left. */
function drawBall(context, colour) {
	context.arc(0, 0, 0.5, 0, 7);
	context.fillStyle = colour;
	context.fill();
	if (colour === SHADOW) return;
	context.fillStyle = context.createRadialGradient(-0.18, 0.2, 0, -0.08, 0.1, 0.7);
	context.fillStyle.addColorStop(0, "rgb(255 255 255 / 42%)");
	context.fillStyle.addColorStop(0.5, "rgb(255 255 255 / 0%)");
	context.fillStyle.addColorStop(1, "rgb(0 0 0 / 26%)");
	context.fill();
	context.strokeStyle = "rgb(0 0 0 / 40%)";
	context.stroke();
}

/** How much a triangle faces the viewer: 1 fully, less than 0 if it faces away. */
function nearOf([a, b, c], isSideView) {
	const [u, v] = [b, c].map((corner) => corner.map((value, axis) => value - a[axis]));
	const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
	return (isSideView ? -normal[1] : normal[2]) / (Math.hypot(...normal) || 1);
}
