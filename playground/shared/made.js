/** Models that the playground makes itself. */

/** A turtle that looks along x: a shell, a head and four legs. */
export function turtle() {
	const mesh = { vertices: [], triangles: [] };
	addBall(mesh, 0, 0, 0.16, 0.36, 0.3, 0.18);
	addBall(mesh, 0.42, 0, 0.2, 0.13, 0.1, 0.1);
	for (const x of [-0.22, 0.24]) {
		for (const y of [-0.26, 0.26]) addBall(mesh, x, y, 0.07, 0.11, 0.08, 0.07);
	}
	addBall(mesh, -0.4, 0, 0.1, 0.08, 0.03, 0.03);
	return mesh;
}

/** Of one ball. */
const TRIANGLES = 2 * 12 * 5;
const [SHELL, SKIN] = ["#1f6b3a", "#5d7f1e"];
turtle.colours = [[TRIANGLES, SHELL], [6 * TRIANGLES, SKIN]];

/** A wall along y: a plate. */
export function wall() {
	const vertices = [];
	for (const x of [-0.06, 0.06]) for (const y of [-0.5, 0.5]) for (const z of [0, 0.5]) vertices.push(x, y, z);
	const triangles = [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3];
	return { vertices, triangles };
}

const ROUND = 12;
const RINGS = 6;

wall.colours = [[12, "#a4553d"]];

/** Adds a ball stretched along the axes. */
function addBall({ vertices, triangles }, x, y, z, a, b, c) {
	const first = vertices.length / 3;
	const at = (ring, i) => first + 1 + (ring - 1) * ROUND + (i % ROUND);
	vertices.push(x, y, z + c);
	for (let ring = 1; ring < RINGS; ring++) {
		const down = (Math.PI * ring) / RINGS;
		for (let i = 0; i < ROUND; i++) {
			const around = (2 * Math.PI * i) / ROUND;
			vertices.push(x + a * Math.sin(down) * Math.cos(around), y + b * Math.sin(down) * Math.sin(around), z + c * Math.cos(down));
		}
	}
	vertices.push(x, y, z - c);
	const last = vertices.length / 3 - 1;
	for (let i = 0; i < ROUND; i++) {
		triangles.push(first, at(1, i), at(1, i + 1));
		for (let ring = 1; ring < RINGS - 1; ring++) {
			triangles.push(at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i), at(ring + 1, i + 1), at(ring, i + 1));
		}
		triangles.push(last, at(RINGS - 1, i + 1), at(RINGS - 1, i));
	}
}
