/** Signs over agents and pairs, for people who do not see the colours: a dot for "hit", a triangle for "wrong", a ring for "missed". */
import { CircleGeometry, MeshBasicMaterial, RingGeometry, Vector3 } from "three";
import { INK, VERDICTS } from "./colours.js";
import { Instances } from "./marks.js";

/** The radius of a sign, in pixels. */
const RADIUS = 6;
const BORDER = 1.35;

export class Signs {
	#shown = [];

	constructor(scene) {
		const material = new MeshBasicMaterial({ depthTest: false, transparent: true });
		const upright = Math.PI / 2;
		const make = (geometry, order) => new Instances(scene, geometry, material, order);
		this.grounds = { hit: make(new CircleGeometry(BORDER, 20), 6), wrong: make(new CircleGeometry(1.25 * BORDER, 3, upright), 6), missed: make(new CircleGeometry(BORDER, 20), 6) };
		this.faces = { hit: make(new CircleGeometry(1, 20), 7), wrong: make(new CircleGeometry(1.1, 3, upright), 7), missed: make(new RingGeometry(0.55, 1, 20), 7) };
	}

	/** @param {{kind: string, x: number, y: number, z: number}[]} signs the signs to show from now on */
	show(signs) {
		this.#shown = signs;
	}

	/**
	 * Turns the signs to the camera, and gives all of them the same size in the picture.
	 *
	 * @param {import("three").PerspectiveCamera} camera
	 * @param {number} height the height of its picture, in pixels
	 */
	face(camera, height) {
		const scale = (2 * RADIUS * Math.tan((camera.fov * Math.PI) / 360)) / height;
		for (const { kind, x, y, z } of this.#shown) {
			place.set(x, y, z);
			const size = scale * camera.position.distanceTo(place);
			this.grounds[kind].addAt(place, camera.quaternion, size, INK);
			this.faces[kind].addAt(place, camera.quaternion, size, VERDICTS[kind]);
		}
		for (const each of this.#all) each.finish();
	}

	/** The number of signs of a kind. */
	count(kind) {
		return this.#shown.filter((sign) => sign.kind === kind).length;
	}

	get #all() {
		return [...Object.values(this.grounds), ...Object.values(this.faces)];
	}

	dispose() {
		for (const each of this.#all) each.dispose();
	}
}

const place = new Vector3();
