/** How the game looks, on this page and in the playground. */
import { BoxGeometry, BufferAttribute, CapsuleGeometry, CircleGeometry, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3 } from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";

const SQUARE = 2; // patches
const LIFT = 0.04; // of a shadow above the ground, in patches
const UP = new Vector3(0, 0, 1);

/** What a walker looks like: the capsule that collides, of a radius of 0.3 and a height of 1.8, with eyes and two arms in front. It stands on the origin, y up. */
export function personShape() {
	const body = new CapsuleGeometry(0.3, 1.2, 8, 20).translate(0, 0.9, 0);
	const box = (length, height, width, ...place) => new BoxGeometry(length, height, width).translate(...place);
	const dark = [box(0.12, 0.13, 0.36, 0.25, 1.5, 0), box(0.6, 0.13, 0.13, 0.3, 1.1, 0.36), box(0.6, 0.13, 0.13, 0.3, 1.1, -0.36)];
	const coats = [body, ...dark].map((part, i) => paint(part, () => (i === 0 ? 1 : 0.25)));
	return mergeGeometries(coats);
}

/** Gives the vertices of a geometry greys, from 0 to 1, that darken its colour. */
function paint(geometry, greyAt) {
	const { position } = geometry.attributes;
	const colours = new Float32Array(3 * position.count);
	for (let i = 0; i < position.count; i++) colours.fill(greyAt(position.getX(i), position.getY(i)), 3 * i, 3 * i + 3);
	return geometry.setAttribute("color", new BufferAttribute(colours, 3));
}

/** Makes the level's ground chequered, so that one sees how far and how fast one goes. */
export function chequer(level) {
	level.getObjectByName("land").traverse(({ isMesh, geometry, material }) => {
		if (!isMesh) return;
		paint(geometry, (x, y) => ((Math.floor(x / SQUARE) + Math.floor(y / SQUARE)) % 2 === 0 ? 1 : 0.8));
		material.vertexColors = true;
	});
}

/** The shadows below the walkers: a dark spot on the ground for each. z is up. */
export class Shadows extends InstancedMesh {
	constructor(count) {
		const spot = new CircleGeometry(0.5, 20); // its first vertex is its middle
		const { count: corners } = spot.attributes.position;
		const colours = Float32Array.from({ length: 4 * corners }, (_, i) => (i === 3 ? 0.7 : 0));
		spot.setAttribute("color", new BufferAttribute(colours, 4));
		super(spot, new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }), count);
		this.frustumCulled = false;
	}

	/** Puts them where the walkers of a game are. A walker that falls has its shadow below it. */
	follow(game) {
		const [matrix, turn] = [new Matrix4(), new Quaternion()];
		game.walkers.forEach((walker, i) => {
			const ground = game.groundBelow(walker);
			const { x, y, z } = ground?.normal ?? UP;
			turn.setFromUnitVectors(UP, new Vector3(x, y, z));
			const size = ground ? walker.size : 0; // there may be no ground
			matrix.compose(new Vector3(walker.x + LIFT * x, walker.y + LIFT * y, (ground?.z ?? 0) + LIFT * z), turn, new Vector3(size, size, size));
			this.setMatrixAt(i, matrix);
		});
		this.instanceMatrix.needsUpdate = true;
	}
}
