/** How near a camera can be to see certain places. */
import { Vector3 } from "three";

/** How many times it comes as near as they fit, and looks at the middle of them. */
const ROUNDS = 3;

/** Looks at a place from another one, which is told as the way there. */
export function look(camera, offset, target) {
	camera.position.copy(offset).add(target);
	camera.lookAt(target);
	camera.updateMatrixWorld();
}

/**
 * The distance from which places fit into a camera's picture.
 *
 * @param {import("three").PerspectiveCamera} camera is moved
 * @param {Vector3} from the way from what it looks at to itself, as long as it may
 * @param {Vector3} target what it looks at; moved over the ground so that the places are as far from every border
 * @param {number[][]} places x, y and z of each
 * @param {number} farthest the largest distance
 */
export function fit(camera, from, target, places, farthest) {
	const half = Math.tan((camera.fov * Math.PI) / 360);
	const ahead = new Vector3(-from.x, -from.y, 0).normalize();
	const right = new Vector3(ahead.y, -ahead.x, 0);
	let distance = farthest;
	for (let round = 0; round < ROUNDS; round++) {
		distance = Math.min(farthest, 1.5 * distance);
		for (let step = distance / 2; step > 0.01; step /= 2) {
			look(camera, from.setLength(distance - step), target);
			const { width, height } = extentOf(camera, places);
			if (width < 0.97 && height < 0.92) distance -= step;
		}
		for (let i = 0; i < 4; i++) {
			look(camera, from.setLength(distance), target);
			const { across, up } = extentOf(camera, places);
			// not all of the way, which is not the same for those in front and behind
			const scale = 0.8 * half * distance;
			target.addScaledVector(ahead, (up * scale * distance) / from.z).addScaledVector(right, across * scale * camera.aspect);
		}
	}
	return distance;
}

/** How wide and high places are seen, and where the middle of them all is; half of the picture is 1. */
function extentOf(camera, places) {
	const seen = places.map((place) => new Vector3(...place).project(camera));
	const [[left, right], [low, high]] = ["x", "y"].map((axis) => [Math.min(...seen.map((each) => each[axis])), Math.max(...seen.map((each) => each[axis]))]);
	const isBehind = seen.some(({ z }) => z > 1);
	return { width: isBehind ? Infinity : (right - left) / 2, height: (high - low) / 2, across: (right + left) / 2, up: (high + low) / 2 };
}
