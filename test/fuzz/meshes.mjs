#!/usr/bin/env node
/**
 * Walks of spheres, capsules, boxes and hulls in levels that others have made: every model in the folder that the variable MESHES names.
 *
 *   MESHES=FOLDER node test/fuzz/meshes.mjs WALKERS [SEED] [NAME]
 *
 * The checks are loops over all triangles, and know nothing of the engine. After each step the walker must not be in a triangle, and its middle must not have
 * crossed one. It must go a way that is free, stand on a floor, and not stand on air. The third argument chooses the files whose names have this text.
 */
import { readFileSync, readdirSync } from "node:fs";
import { extname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { along, cross, dot, gapOf, leastOf, length, sub, toTriangle, triangleBody } from "./geometry.mjs";
import { bodiesOf } from "./shapes.mjs";
import { engine, numbersOf, toolsOf } from "./tools.mjs";

const { Agent, AgentFilter, AgentQueries, BuiltInModel, CombinationCollider, Footing, GltfModel, GreatLand, Model, ObjModel, StlModel, Vector3D, WalkOptions } = engine;

// Lengths are parts of the walker's size. So deep in a triangle it is too deep.
const DEEP = 1e-7;

// What is farther away than this is not in the way. A walker that climbs steps goes over what is lower than LOW, too.
const CLEAR = 2e-11;
const LOW = 1e-4;

// A walker that stands has something as near as this.
const CLOSE = 2e-6;

/** The part of a free way that a walker goes at least. */
const MOST = 0.5;

/** How many steps a walker goes, unless it falls off the level before. */
const STEPS = 300;

/** Seeds that may find no place for a walker, for each that finds one. */
const PATIENCE = 100;

const WALKERS = [["sphere", "sphere"], ["hero", "capsule"], ["cube", "box"], ["cube", "hull"]];

/** How files are read. OBJ and STL files do not say which axis points up, so they are read with two. */
const READERS = {
	".obj": (bytes) => ["y", "z"].map((up) => ObjModel.fromBytes("level", bytes, up, Model.AS_GIVEN)),
	".stl": (bytes) => ["y", "z"].map((up) => StlModel.fromBytes("level", bytes, up, Model.AS_GIVEN)),
	".glb": (bytes) => [GltfModel.fromBytes("level", bytes, null, Model.AS_GIVEN)],
};

const AXES = [0, 1, 2];
const isModel = (file) => extname(file).toLowerCase() in READERS;

/** A level's plain triangles, with their extents and those of all. */
export function plainLevel(bodies) {
	const corners = bodies.flatMap((body) => body.corners);
	const extents = Float64Array.from(bodies.flatMap((body) => [...leastIn(body.corners), ...mostIn(body.corners)]));
	return { bodies, extents, least: leastIn(corners), most: mostIn(corners) };
}

/** The levels of a file, as the engine has them and as plain triangles. */
export const levelsOf = (file) => READERS[extname(file).toLowerCase()](readFileSync(file)).map((model, i) => {
	const { vertices, triangles } = model;
	const bodies = Array.from({ length: triangles.length / 3 }, (_, k) => {
		const corners = AXES.map((corner) => AXES.map((axis) => vertices[3 * triangles[3 * k + corner] + axis]));
		return triangleBody(corners);
	});
	return { name: `${file}, reading ${i + 1}`, land: landOf(model), ...plainLevel(bodies) };
});

/** The levels of all files of a folder whose names have this text. */
export function levelsIn(folder, text = "") {
	const files = readdirSync(folder).filter((file) => isModel(file) && file.includes(text)).sort();
	if (files.length === 0) throw new Error(`${folder} has no model: ${Object.keys(READERS).join(", ")}`);
	return files.flatMap((file) => levelsOf(join(folder, file)));
}

function leastIn(points) {
	return AXES.map((axis) => points.reduce((least, at) => Math.min(least, at[axis]), Infinity));
}

function mostIn(points) {
	return AXES.map((axis) => points.reduce((most, at) => Math.max(most, at[axis]), -Infinity));
}

function landOf(level) {
	const land = Object.assign(new GreatLand(), { loadTightestFit: false });
	land.addModel(level);
	Object.assign(land, { loadTightestFit: true, loadAllBoundingStructures: true, loadHulls: true });
	for (const model of [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.capsule(0.3, 1, "hero")]) land.addModel(model);
	return land;
}

const leastOfBody = ({ extents: { minX, minY, minZ } }) => [minX, minY, minZ];
const mostOfBody = ({ extents: { maxX, maxY, maxZ } }) => [maxX, maxY, maxZ];
const middleOf = (body) => along(leastOfBody(body), sub(mostOfBody(body), leastOfBody(body)), 0.5);

function movedBy(body, way) {
	const [minX, minY, minZ] = along(leastOfBody(body), way, 1);
	const [maxX, maxY, maxZ] = along(mostOfBody(body), way, 1);
	return { ...body, corners: body.corners.map((corner) => along(corner, way, 1)), extents: { minX, minY, minZ, maxX, maxY, maxZ } };
}

/** The triangles whose extents reach into a box that is wider by so much: one loop, because a level may have many. */
function trianglesNear({ bodies, extents }, [minX, minY, minZ], [maxX, maxY, maxZ], by = 0) {
	const near = [];
	for (let i = 0; i < bodies.length; i++) {
		const k = 6 * i;
		if (extents[k] > maxX + by || extents[k + 1] > maxY + by || extents[k + 2] > maxZ + by) continue;
		if (extents[k + 3] >= minX - by && extents[k + 4] >= minY - by && extents[k + 5] >= minZ - by) near.push(bodies[i]);
	}
	return near;
}

/** How far a point is above the plane of a triangle. */
const heightAbove = (point, { corners: [corner], normals: [normal] }) => dot(sub(point, corner), normal) / length(normal);

/** How far a body and a triangle are apart along a direction. */
function gapAlong(axis, { corners, radius = 0 }, triangle) {
	const size = length(axis);
	const [a, b] = [corners, triangle.corners].map((points) => points.map((point) => dot(point, axis) / size));
	return Math.max(Math.min(...a) - Math.max(...b), Math.min(...b) - Math.max(...a)) - radius;
}

/** The distance of a body from a triangle, less than 0 if they overlap. If it is more than `limit`, a lower bound of it. */
function gapToTriangle(body, triangle, limit) {
	for (const axis of [triangle.normals[0], ...(body.normals ?? [])]) {
		// without an area there is no normal: the gap is no number
		const gap = gapAlong(axis, body, triangle);
		if (gap > limit) return gap;
	}
	if (body.radius === undefined) return gapOf(body, triangle);
	const [a, b = a] = body.corners;
	return leastOf((part) => toTriangle(along(a, sub(b, a), part), triangle.corners)) - body.radius;
}

/** The least distance of a body from the triangles of a level. If it is more than `limit`, some number above this. */
function gapToLevel(body, level, limit) {
	const near = trianglesNear(level, leastOfBody(body), mostOfBody(body), Math.max(0, limit));
	return Math.min(Infinity, ...near.map((triangle) => gapToTriangle(body, triangle, limit)));
}

/**
 * Whether a body stays farther than so much from all triangles of a level on a straight way. A few places on it rule out most ways. The gap to one
 * triangle is a convex function of the way's part, so its least is found.
 */
export function isFreeWay(level, body, way, clear) {
	const bodyAt = (part) => movedBy(body, way.map((each) => part * each));
	if ([0, 0.25, 0.5, 0.75, 1].some((part) => gapToLevel(bodyAt(part), level, clear) <= clear)) return false;
	const end = bodyAt(1);
	const near = trianglesNear(level, leastIn([leastOfBody(body), leastOfBody(end)]), mostIn([mostOfBody(body), mostOfBody(end)]), clear);
	return near.every((triangle) => leastOf((part) => gapToTriangle(bodyAt(part), triangle, Infinity)) > clear);
}

/** Whether a straight way crosses the inside of a triangle. */
function crosses(level, from, to) {
	return trianglesNear(level, leastIn([from, to]), mostIn([from, to])).some((triangle) => {
		const [begin, end] = [from, to].map((point) => heightAbove(point, triangle));
		if (!(begin > 0 !== end > 0)) return false;
		const at = along(from, sub(to, from), begin / (begin - end));
		return AXES.every((i) => {
			const [p, q] = [triangle.corners[i], triangle.corners[(i + 1) % 3]];
			return dot(cross(sub(q, p), sub(at, p)), triangle.normals[0]) > 0;
		});
	});
}

/** Whether all these ways are closed: straight on; at the height of the upper end, and down; down first, and then on. */
function isClosed(level, from, to) {
	return [null, Math.max(from[2], to[2]), Math.min(from[2], to[2])].every((height) => {
		const places = height === null ? [from, to] : [from, [from[0], from[1], height], [to[0], to[1], height], to];
		return places.slice(1).some((place, i) => crosses(level, places[i], place));
	});
}

/** Whether a round body rests on the inside of a triangle whose normal has at least this z. */
function isOnFloor(level, body, leastZ, near) {
	if (body.radius === undefined) return false;
	const center = body.corners.reduce((low, corner) => (corner[2] < low[2] ? corner : low));
	return trianglesNear(level, leastOfBody(body), mostOfBody(body), near).some((triangle) => {
		const z = triangle.normals[0][2] / length(triangle.normals[0]);
		const height = heightAbove(center, triangle);
		return z * Math.sign(height) >= leastZ && Math.abs(height) <= body.radius + near && toTriangle(center, triangle.corners) === Math.abs(height);
	});
}

/** A walker at a random place above what a ray from above meets; null if there is no room. */
function walkerIn(level, { between, pick, random }) {
	const extent = Math.max(...sub(level.most, level.least));
	const size = extent * 0.005 * 20 ** random();
	const [shape, kind] = pick(WALKERS);
	const agent = Object.assign(new Agent(shape, "walkers"), { size, collideAs: kind, heading: between(0, 360) });
	const queries = new AgentQueries(Object.assign(new CombinationCollider(level.land), { exact: true }));
	queries.update([Object.assign(new Agent("level", "levels"), { hierarchical: true }), agent]);
	const [x, y] = [0, 1].map((axis) => between(level.least[axis], level.most[axis]));
	const hits = queries.castAll(new Vector3D(x, y, level.most[2] + extent), new Vector3D(0, 0, -1), Infinity, AgentFilter.ofBreeds("levels"), null, true);
	if (hits.length === 0) return null;
	agent.jumpTo(x, y, pick([...hits]).point.z + size * between(0.01, 0.6));
	queries.moved(agent);
	const walker = {
		level, agent, queries, kind, size, footing: new Footing(), speed: 0,
		// of a sphere inside of it
		radius: size * (kind === "capsule" ? 0.3 : 0.5),
		get place() { return [agent.x, agent.y, agent.z]; },
		get body() { return bodiesOf({ land: level.land, setting: { system: 1 } }, agent)[0]; },
	};
	// what is closed is solid, and a walker inside of it is not stopped
	return gapToLevel(walker.body, level, 0) < 0 || queries.touching(agent).length > 0 ? null : walker;
}

/** The jump or the fall of a frame, as docs/queries.md has them; returns the body before its walk. */
function jumpOrFall(walker, jumps) {
	const { queries, agent, footing, radius, size } = walker;
	if (footing.stands) walker.speed = jumps ? 0.9 * radius : 0;
	// no faster than its radius, so that no wall fits between two places in turn
	else walker.speed = Math.max(-radius, walker.speed - 0.04 * size);
	if (walker.speed > 0) queries.moveUntilTouch(agent, 0, 0, walker.speed);
	return walker.body;
}

/** What is wrong after a step from a body's place, with the kind of the fault. */
function faultsOf({ level, footing, body, size, radius, place, speed }, { begin, before, stood, dx, dy, options }) {
	const faults = [];
	const gap = gapToLevel(body, level, CLOSE * size);
	if (!place.every(Number.isFinite)) faults.push(["through", "has no place"]);
	if (gap < -DEEP * size) faults.push(["through", `${-gap} deep`]);
	if (isClosed(level, middleOf(begin), middleOf(before)) || isClosed(level, middleOf(before), middleOf(body))) faults.push(["through", "has crossed a triangle"]);
	if (footing.pushed > 0) faults.push(["through", `was pushed ${footing.pushed}`]);
	if (footing.stands && gap > CLOSE * size) faults.push(["afloat", "stands on nothing"]);
	// less than a hundredth of a degree is not decided
	if (!footing.stands && isOnFloor(level, body, Math.cos((options.slopeDegrees - 0.01) * Math.PI / 180), 1e-9 * size)) faults.push(["afloat", "does not stand on a floor"]);
	// a longer way downhill may meet more than the eight surfaces after which a slide ends
	if (footing.part < MOST && Math.hypot(dx, dy) < radius) {
		const isFree = (rise) => isFreeWay(level, movedBy(before, [0, 0, rise]), [dx, dy, 0], CLEAR * size);
		const climbs = stood && speed <= 0 && options.stepHeight > LOW * size;
		if (isFree(0) || climbs && isFree(LOW * size)) faults.push(["stuck", `has gone ${footing.part} of a free way`]);
	}
	return faults;
}

/** Lets a walker go its steps, and adds what went wrong. */
function go(walker, steps, { between, pick, random }, label, found) {
	const { level, size, radius, footing } = walker;
	let way = between(0, 2 * Math.PI);
	for (let i = 0; i < steps && walker.place[2] > level.least[2] - 2 * size; i++) {
		way += footing.part < 0.3 ? between(1, 5) : between(-0.4, 0.4);
		// a walk in one piece
		const stride = pick([0.04 * radius, 0.2 * radius, 0.6 * radius, 0.9 * radius, size]);
		const [dx, dy] = [stride * Math.cos(way), stride * Math.sin(way)];
		const options = Object.assign(new WalkOptions(), { stepHeight: size * pick([0, 0.1, 0.25, 0.4]), slopeDegrees: pick([20, 45, 45, 60]), snap: size * pick([0, 0.25, 0.25]) });
		const [from, begin, stood] = [walker.place, walker.body, footing.stands];
		const jumps = random() < 0.03;
		const lands = i === 0 || random() < 0.02;
		const before = jumpOrFall(walker, jumps);
		options.fall = lands ? Infinity : Math.max(0, -walker.speed);
		walker.queries.walk(walker.agent, dx, dy, options, footing);
		const faults = faultsOf(walker, { begin, before, stood, dx, dy, options });
		for (const [kind, text] of faults) found[kind].push(`${label}, ${walker.kind} of size ${size}, step ${i} by ${dx},${dy} from ${from} to ${walker.place}, ${JSON.stringify(options)}: ${text}`);
		found.steps++;
		if (footing.stands) found.standing++;
		if (footing.part < MOST) found.blocked++;
	}
}

/** Walkers in these levels in turn, and what went wrong: a text for each. */
export function walkMeshes(levels, count, seed, steps = STEPS) {
	const found = { walkers: 0, steps: 0, standing: 0, blocked: 0, ends: [], through: [], stuck: [], afloat: [] };
	for (let each = seed; found.walkers < count && each < seed + PATIENCE * count; each++) {
		const level = levels[each % levels.length];
		const tools = toolsOf(numbersOf(each));
		const walker = walkerIn(level, tools);
		if (walker === null) continue;
		go(walker, steps, tools, `seed ${each}: ${level.name}`, found);
		found.walkers++;
		found.ends.push(walker.place.join());
	}
	return found;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
	const [count = "1000", seed = "1", text = ""] = process.argv.slice(2);
	const levels = levelsIn(process.env.MESHES, text);
	const { walkers, steps, standing, blocked, through, stuck, afloat } = walkMeshes(levels, Number(count), Number(seed));
	console.log(`${levels.length} levels, ${walkers} walkers, ${steps} steps, ${standing} of them standing, ${blocked} blocked`);
	for (const [what, texts] of Object.entries({ through, stuck, afloat })) console.log(`${what}: ${texts.length}${texts.slice(0, 5).map((each) => `\n  ${each}`).join("")}`);
	process.exitCode = through.length + stuck.length + afloat.length > 0 ? 1 : 0;
}
