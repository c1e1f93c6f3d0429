#!/usr/bin/env node
/**
 * Draws the picture of README.md: the shapes that the collision systems use for a bear, computed by the package itself.
 *
 * node js/module/pages/picture.mjs after ./antw module
 */
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { GreatLand, ObjModel, Sphere, Vector3D, Wireframes } from "../../../bin/module/starlogo-collision.js";
import { ROOT } from "../names.mjs";

const WIDTH = 260;
const HEIGHT = 430;
const SCALE = 150;
// coordinates are whole numbers of quarters of a pixel, because that is short
const FINE = 4;
const [COS, SIN] = [Math.cos(0.6), Math.sin(0.6)];

/** The place of a point in the picture, seen from the front and above. */
function project(x, y, z) {
	const across = COS * x - SIN * y;
	const away = SIN * x + COS * y;
	return [WIDTH / 2 + SCALE * across, HEIGHT - 70 - SCALE * (0.94 * z + 0.34 * away)].map((value) => Math.round(FINE * value));
}

const drawn = (color, width) => `fill="none" stroke="${color}" stroke-width="${FINE * width}"/>`;

function path(lines) {
	let text = "";
	for (let i = 0; i < lines.length; i += 6) {
		const [x, y] = project(...lines.slice(i, i + 3));
		const [endX, endY] = project(...lines.slice(i + 3, i + 6));
		text += `M${x} ${y}l${endX - x} ${endY - y}`;
	}
	return `<path d="${text}" `;
}

/** The edges of a model's triangles. An edge that triangles share appears once. */
function edgesOf({ vertices, triangles }) {
	const edges = new Map();
	for (let i = 0; i < triangles.length; i++) {
		const [a, b] = [triangles[i], triangles[i % 3 === 2 ? i - 2 : i + 1]].sort((first, second) => first - second);
		edges.set(`${a} ${b}`, [...vertices.slice(3 * a, 3 * a + 3), ...vertices.slice(3 * b, 3 * b + 3)]);
	}
	return [...edges.values()].flat();
}

/** The picture as SVG text. */
function drawPicture() {
	const bear = new ObjModel("bear", readFileSync(join(ROOT, "assets/bear.obj"), "utf8"));
	const land = new GreatLand();
	land.addModel(bear);
	// drawn once in each panel
	const edges = `<defs>${path(edgesOf(bear))}id="bear"/></defs>`;
	const panels = [
		["BinCollider", Wireframes.ofStructure(new Sphere(new Vector3D(0, 0, 0.5), 0.5))],
		["TightestFitCollider", Wireframes.ofStructure(land.boundingStructures.tightestFit("bear"))],
		["HierarchicalCollider", Wireframes.ofLevel(land.hierarchies.root("bear"), 5)],
		["exact", []],
	];
	const groups = panels.map(([name, lines], i) => {
		const model = '<use href="#bear" ';
		const own = lines.length > 0 ? model + drawn("#b8b8b8", 0.4) + path(lines) + drawn("#d9480f", 1) : model + drawn("#d9480f", 0.6);
		return `<g transform="translate(${i * WIDTH} 0)"><g transform="scale(${1 / FINE})">${own}</g><text x="${WIDTH / 2}" y="${HEIGHT - 14}" text-anchor="middle">${name}</text></g>`;
	});
	const size = `width="${panels.length * WIDTH}" height="${HEIGHT}" viewBox="0 0 ${panels.length * WIDTH} ${HEIGHT}"`;
	return `<svg xmlns="http://www.w3.org/2000/svg" ${size} font-family="sans-serif" font-size="15"><rect width="100%" height="100%" fill="#fff"/>${edges}${groups.join("")}</svg>\n`;
}

writeFileSync(join(ROOT, "js/module/picture.svg"), drawPicture());
