/** Models that the playground itself makes, from three.js's shapes. */
import { BoxGeometry, Group, Mesh, SphereGeometry } from "three";
import { Model } from "starlogo-collision";
import { modelFromObject } from "starlogo-collision/three";

const [SHELL, SKIN, BRICK] = ["#1f6b3a", "#5d7f1e", "#a4553d"];

/** A ball, stretched along the axes. It has few triangles, because crowds have many of them. */
function ball(x, y, z, a, b, c, round = 8) {
	return new Mesh(new SphereGeometry(1, round, round / 2).rotateX(Math.PI / 2).scale(a, b, c).translate(x, y, z));
}

const trianglesOf = ({ geometry }) => geometry.index.count / 3;

/** A turtle that looks along x: a shell, a head, four legs and a tail. */
export function turtle() {
	const legs = [-0.22, 0.24].flatMap((x) => [-0.26, 0.26].map((y) => ball(x, y, 0.07, 0.11, 0.08, 0.07)));
	const parts = [ball(0, 0, 0.16, 0.36, 0.3, 0.18, 12), ball(0.42, 0, 0.2, 0.13, 0.1, 0.1), ...legs, ball(-0.4, 0, 0.1, 0.08, 0.03, 0.03)];
	const colours = parts.map((part, i) => [trianglesOf(part), i === 0 ? SHELL : SKIN]);
	return made("turtle", new Group().add(...parts), colours);
}

/** A wall along y: a flat box. */
export function wall() {
	return made("wall", new BoxGeometry(0.12, 1, 0.5), [[12, BRICK]]);
}

/** A model from an object's triangles. Its coordinates have few digits, so that a program shown as text has exactly the same. */
function made(name, object, colours) {
	const { vertices, triangles } = modelFromObject(name, object, { up: "z" });
	const given = { vertices: Array.from(vertices, (value) => Number(value.toFixed(4))), triangles: Array.from(triangles) };
	return Object.assign(new Model(name, given.vertices, given.triangles), { colours, given });
}
