/** Models that the playground makes itself, of three.js's shapes. */
import { BoxGeometry, Group, Mesh, SphereGeometry } from "three";
import { modelFromObject } from "starlogo-collision/three";

const [ROUND, RINGS] = [12, 6];
/** Of one ball. */
const TRIANGLES = 2 * ROUND * (RINGS - 1);
const [SHELL, SKIN, BRICK] = ["#1f6b3a", "#5d7f1e", "#a4553d"];

/** A ball, stretched along the axes. */
function ball(x, y, z, a, b, c) {
	return new Mesh(new SphereGeometry(1, ROUND, RINGS).rotateX(Math.PI / 2).scale(a, b, c).translate(x, y, z));
}

/** A turtle that looks along x: a shell, a head, four legs and a tail. */
export function turtle() {
	const legs = [-0.22, 0.24].flatMap((x) => [-0.26, 0.26].map((y) => ball(x, y, 0.07, 0.11, 0.08, 0.07)));
	const parts = new Group().add(ball(0, 0, 0.16, 0.36, 0.3, 0.18), ball(0.42, 0, 0.2, 0.13, 0.1, 0.1), ...legs, ball(-0.4, 0, 0.1, 0.08, 0.03, 0.03));
	return Object.assign(modelFromObject("turtle", parts, { up: "z" }), { colours: [[TRIANGLES, SHELL], [(parts.children.length - 1) * TRIANGLES, SKIN]] });
}

/** A wall along y: a plate. */
export function wall() {
	return Object.assign(modelFromObject("wall", new BoxGeometry(0.12, 1, 0.5), { up: "z" }), { colours: [[12, BRICK]] });
}
