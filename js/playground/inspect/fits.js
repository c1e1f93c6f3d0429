/** Fits all structures to a model, for Inspect's table. */
import {
	AxisAlignedBoxFitter, CapsuleFitter, CentredRitterSphereFitter, CylinderFitter, FitSession, GreatLand, HullFitter, MinimalCapsuleFitter, MinimalSphereFitter,
	NaiveSphereFitter, OrientedBoxFitter, RitterSphereFitter, ZAlignedBoxFitter,
} from "starlogo-collision";
import { shortestTimes } from "../shared/timing.js";

/** The fitters, in the table's order. */
const FITTERS = {
	naiveSphere: () => new NaiveSphereFitter(),
	ritterSphere: () => new RitterSphereFitter(),
	centredRitterSphere: () => new CentredRitterSphereFitter(),
	minimalSphere: () => new MinimalSphereFitter(),
	axisAlignedBox: () => new AxisAlignedBoxFitter(),
	zAlignedBox: (increment) => new ZAlignedBoxFitter(increment),
	orientedBox: (increment) => new OrientedBoxFitter(increment),
	capsule: (increment) => new CapsuleFitter(new OrientedBoxFitter(increment)),
	minimalCapsule: () => new MinimalCapsuleFitter(),
	cylinder: (increment) => new CylinderFitter(new OrientedBoxFitter(increment)),
	hull: () => new HullFitter(),
};

/** The fitters that the engine compares by default (thesis §3.7). */
const COMPARED = ["naiveSphere", "orientedBox", "capsule"];

/**
 * Fits all structures to a model.
 *
 * @param {object} model
 * @param {{increment: number, minVertices: number, byMean: boolean}} settings
 * @param {() => boolean} isWanted whether to go on
 * @returns {Promise<{rows: object[], chosen: string, root: object, hullMs: number, hierarchyMs: number, volume: number, greatLand: object} | null>} null if it is no longer wanted
 * @throws {Error} the engine's own error, if a setting is not possible
 */
export async function measure(model, settings, isWanted) {
	const greatLand = new GreatLand();
	greatLand.orientedBoxDegIncrement = settings.increment;
	greatLand.hierarchies.minVerticesToSplit = settings.minVertices;
	greatLand.hierarchies.splitByMean = settings.byMean;
	const works = Object.entries(FITTERS).map(([name, make]) => ({ name, run: () => make(settings.increment).fit(model.vertices) }));
	works.push({ name: HULL, run: () => new FitSession(model.vertices).hull }, { name: HIERARCHY, run: () => greatLand.hierarchies.add(model.name, model.vertices, model.triangles) });
	const times = await shortestTimes(works, ROUNDS, isWanted);
	if (!times) return null;
	const rows = times.filter(({ name }) => name in FITTERS).map(({ result: structure, ...time }) => ({ ...time, structure, volume: structure.volume }));
	const msOf = (wanted) => times.find(({ name }) => name === wanted).ms;
	// each fit computes the hull too, and one may have had a quieter moment
	const hullMs = Math.min(msOf(HULL), ...rows.map(({ ms }) => ms));
	greatLand.addModel(model);
	const chosen = greatLand.boundingStructures.tightestFit(model.name);
	const tightest = rows.find(({ name, structure }) => COMPARED.includes(name) && structure.kind === chosen.kind);
	return { rows, chosen: tightest.name, root: greatLand.hierarchies.root(model.name), greatLand, hullMs, hierarchyMs: msOf(HIERARCHY), volume: volumeOf(model) };
}

const [HULL, HIERARCHY] = ["convex hull", "hierarchy"];
const ROUNDS = { warm: 3, counted: 6 };

/** The number of levels of a hierarchy. */
export function depthOf(node) {
	return node.isLeaf ? 1 : 1 + Math.max(depthOf(node.left), depthOf(node.right));
}

/** The number of nodes that a collider reaches if it visits this many levels. */
export function nodesAt(node, level) {
	return level === 1 || node.isLeaf ? 1 : nodesAt(node.left, level - 1) + nodesAt(node.right, level - 1);
}

const COLUMNS = 160;

/**
 * The volume inside a model's surface. Overlapping parts count once. It sums the lengths of columns along z between entering and leaving
 * the surface. NaN if the surface is not closed.
 */
function volumeOf({ vertices, triangles }) {
	if (!triangles) return NaN;
	const cell = 1.0001 / COLUMNS;
	const columns = Array.from({ length: COLUMNS * COLUMNS }, () => []);
	// not in the middle, so that no column runs along an edge
	const at = (i) => (i + 0.4997) * cell - 0.50003;
	const from = (x) => Math.max(0, Math.ceil((x + 0.50003) / cell - 0.4997));
	const to = (x) => Math.min(COLUMNS - 1, Math.floor((x + 0.50003) / cell - 0.4997));
	for (let t = 0; t < triangles.length; t += 3) {
		const [a, b, c] = [0, 1, 2].map((k) => vertices.slice(3 * triangles[t + k], 3 * triangles[t + k] + 3));
		const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
		if (area === 0) continue;
		for (let i = from(Math.min(a[0], b[0], c[0])); i <= to(Math.max(a[0], b[0], c[0])); i++) {
			for (let j = from(Math.min(a[1], b[1], c[1])); j <= to(Math.max(a[1], b[1], c[1])); j++) {
				const [x, y] = [at(i), at(j)];
				const u = ((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x)) / area;
				const v = ((c[0] - x) * (a[1] - y) - (c[1] - y) * (a[0] - x)) / area;
				const w = 1 - u - v;
				if (u >= 0 && v >= 0 && w >= 0) columns[i * COLUMNS + j].push([u * a[2] + v * b[2] + w * c[2], Math.sign(area)]);
			}
		}
	}
	let length = 0;
	let open = 0;
	let crossed = 0;
	for (const crossings of columns) {
		if (crossings.length === 0) continue;
		crossed++;
		crossings.sort((p, q) => p[0] - q[0]);
		let winding = 0;
		crossings.forEach(([z, sign], k) => {
			winding += sign;
			if (winding !== 0 && k + 1 < crossings.length) length += crossings[k + 1][0] - z;
		});
		if (winding !== 0) open++;
	}
	return open > crossed * 0.02 ? NaN : length * cell * cell;
}
