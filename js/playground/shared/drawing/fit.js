/** Finds how near a camera can be and still show certain places. */
import { Vector3 } from "three";

/** The number of times that it moves as near as possible and turns to their middle. */
const ROUNDS = 3;

/** Points a camera at a target, from an offset relative to it. */
export function look(camera, offset, target) {
	camera.position.copy(offset).add(target);
	camera.lookAt(target);
	camera.updateMatrixWorld();
}

/**
 * The distance from which all places fit into a camera's picture.
 *
 * @param {import("three").PerspectiveCamera} camera is moved
 * @param {Vector3} from the offset from the target to the camera, at its longest
 * @param {Vector3} target is moved over the ground so that the places are equally far from all borders
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
			// not the whole way, because it differs for near and far places
			const scale = 0.8 * half * distance;
			target.addScaledVector(ahead, (up * scale * distance) / from.z).addScaledVector(right, across * scale * camera.aspect);
		}
	}
	return distance;
}

/** The width and height of all places in the picture, and their middle; half of the picture is 1. */
function extentOf(camera, places) {
	const seen = places.map((place) => new Vector3(...place).project(camera));
	const [[left, right], [low, high]] = ["x", "y"].map((axis) => [Math.min(...seen.map((each) => each[axis])), Math.max(...seen.map((each) => each[axis]))]);
	const isBehind = seen.some(({ z }) => z > 1);
	return { width: isBehind ? Infinity : (right - left) / 2, height: (high - low) / 2, across: (right + left) / 2, up: (high + low) / 2 };
}
