/** Models that the playground itself makes, from three.js's shapes. */
import { BoxGeometry, CylinderGeometry, Group, Mesh, SphereGeometry } from "three";
import { Model } from "starlogo-collision";
import { modelFromObject } from "starlogo-collision/three";

const [SHELL, SKIN, BRICK, GOLD, STONE, GRASS, ROOF, PAINT, RUBBER] = ["#1f6b3a", "#5d7f1e", "#a4553d", "#d9a400", "#7d7f86", "#4f8f3a", "#9c3b2e", "#2f6fb5", "#33363d"];

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

/** A box with its middle at a place. */
const box = (x, y, z, a, b, c) => new Mesh(new BoxGeometry(a, b, c).translate(x, y, z));
/** A disc that stands, its axis along y. */
const disc = (x, y, z, radius, thick, round = 16) => new Mesh(new CylinderGeometry(radius, radius, thick, round).translate(x, y, z));
/** A model from parts, each with its colour. */
const ofParts = (name, ...parts) => made(name, new Group().add(...parts.map(([part]) => part)), parts.map(([part, colour]) => [trianglesOf(part), colour]));

/** A flat block to stand on: a patch long and wide, and a quarter of it high. */
export const platform = () => ofParts("platform", [box(0, 0, 0.1, 1, 1, 0.2), BRICK], [box(0, 0, 0.225, 1, 1, 0.05), GRASS]);

/** A coin that stands on its edge. */
export const coin = () => ofParts("coin", [disc(0, 0, 0.5, 0.5, 0.12, 20), GOLD]);

/** A key that looks along x: a ring, a shaft and two teeth. */
export const key = () => ofParts("key", [disc(-0.3, 0, 0.2, 0.2, 0.08, 12), GOLD], [box(0.2, 0, 0.2, 0.6, 0.08, 0.08), GOLD], [box(0.3, 0, 0.11, 0.07, 0.08, 0.12), GOLD], [box(0.45, 0, 0.09, 0.07, 0.08, 0.16), GOLD]);

/** A rock: a ball with few corners. */
export const rock = () => ofParts("rock", [ball(0, 0, 0.33, 0.5, 0.42, 0.33, 6), STONE]);

/** A house with a roof of four sides. */
export const house = () => ofParts("house", [box(0, 0, 0.3, 0.9, 0.9, 0.6), STONE], [new Mesh(new CylinderGeometry(0, 0.7, 0.45, 4).rotateY(Math.PI / 4).rotateX(Math.PI / 2).translate(0, 0, 0.825)), ROOF], [box(0, -0.46, 0.18, 0.2, 0.04, 0.36), BRICK]);

/** A car that looks along x. */
export const car = () => ofParts("car", [box(0, 0, 0.2, 1, 0.46, 0.18), PAINT], [box(-0.05, 0, 0.36, 0.5, 0.4, 0.16), PAINT], ...[-0.3, 0.3].flatMap((x) => [-0.22, 0.22].map((y) => [disc(x, y, 0.11, 0.11, 0.08, 10), RUBBER])));

/** Models by their names. */
export const MADE = { turtle, wall, platform, coin, key, rock, house, car };

/** A model from an object's triangles. Its coordinates have few digits, so that a program shown as text has exactly the same. */
function made(name, object, colours) {
	const { vertices, triangles } = modelFromObject(name, object, { up: "z" });
	const given = { vertices: Array.from(vertices, (value) => Number(value.toFixed(4))), triangles: Array.from(triangles) };
	return Object.assign(new Model(name, given.vertices, given.triangles), { colours, given });
}
