/** Models of several closed parts: inside out, overlapping, hollow, far from their origin; removed and replaced while they are asked about. Windings of each part say what is inside. */
import { randomNumbers } from "../../module/random.mjs";
import { toTriangle, windingOf } from "../geometry.mjs";
import { trianglesOf } from "../shapes.mjs";
import { engine, HAIR, numbersOf, toolsOf } from "../tools.mjs";

const { Agent, AgentQueries, CombinationCollider, HierarchicalCollider, Model, Sphere, Vector3D } = engine;

/** A random closed solid: an octahedron whose corners are elsewhere, cut by more corners. */
export function solid(name, seed) {
	const random = randomNumbers(seed);
	const sides = 3 + Math.floor(4 * random());
	const vertices = [];
	for (let i = 0; i < sides; i++) {
		const radius = 0.3 + random();
		vertices.push(radius * Math.cos(2 * Math.PI * i / sides), radius * Math.sin(2 * Math.PI * i / sides), 0.2 * random());
	}
	vertices.push(0, 0, -0.1 - random(), 0, 0, 0.3 + random());
	const triangles = [];
	for (let i = 0; i < sides; i++) triangles.push(sides, (i + 1) % sides, i, sides + 1, i, (i + 1) % sides);
	return new Model(name, vertices, seed % 5 === 0 ? null : triangles);
}

/** The corners of a box's sides, counter-clockwise seen from outside. */
const SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/** A closed part: a box, or a double pyramid around the same middle. */
function part(center, halves, isBox, isTurned) {
	const at = (x, y, z) => [center[0] + x * halves[0], center[1] + y * halves[1], center[2] + z * halves[2]];
	let triangles;
	if (isBox) {
		const corners = Array.from({ length: 8 }, (_, i) => at(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
		triangles = SIDES.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]).map((each) => each.map((i) => corners[i]));
	} else {
		triangles = [];
		for (const [sx, sy, sz] of [[1, 1, 1], [1, 1, -1], [1, -1, 1], [1, -1, -1], [-1, 1, 1], [-1, 1, -1], [-1, -1, 1], [-1, -1, -1]]) {
			const corners = [at(sx, 0, 0), at(0, sy, 0), at(0, 0, sz)];
			triangles.push(sx * sy * sz > 0 ? corners : corners.reverse());
		}
	}
	return isTurned ? triangles.map(([a, b, c]) => [c, b, a]) : triangles;
}

/**
 * Solids in a row that reach into each other, each turned inside out or not, and a shell, whose inner surface bounds a cavity. There may be a solid
 * in the cavity, and one across the shell's outer surface. Returns the parts of the solids, and those of the shell.
 */
function partsOf(seed) {
	const { random, between, integer } = toolsOf(numbersOf(seed));
	const solids = Array.from({ length: 1 + integer(3) }, (_, i) => part([0.55 * i + between(0, 0.1), between(-0.2, 0.2), between(-0.2, 0.2)], [between(0.4, 0.5), between(0.4, 0.5), between(0.4, 0.5)], random() < 0.7, random() < 0.4));
	if (random() < 0.5) return { solids, shell: [] };
	const isTurned = random() < 0.5;
	const isBox = random() < 0.7;
	const shell = [part([0, 3, 0], [0.6, 0.6, 0.6], isBox, isTurned), part([0, 3, 0], isBox ? [0.35, 0.3, 0.4] : [0.25, 0.2, 0.3], isBox, !isTurned)];
	// a solid in the cavity, and one across the outer surface
	if (random() < 0.4) solids.push(part([between(-0.02, 0.02), 3, 0], [0.08, 0.06, 0.07], random() < 0.7, random() < 0.5));
	if (isBox && random() < 0.4) solids.push(part([between(-0.2, 0.2), 3.75, between(-0.2, 0.2)], [between(0.1, 0.3), 0.25, 0.2], random() < 0.7, random() < 0.5));
	return { solids, shell };
}

/** The model of parts: with corners of its own for each triangle, or shared ones. */
function modelOf(name, parts, isSoup, far, scaling) {
	const places = new Map();
	const vertices = [];
	const triangles = [];
	for (const corner of parts.flat(2)) {
		const key = corner.join();
		const index = isSoup ? vertices.length / 3 : places.get(key) ?? vertices.length / 3;
		if (index === vertices.length / 3) vertices.push(corner[0] + far, corner[1], corner[2]);
		places.set(key, index);
		triangles.push(index);
	}
	return new Model(name, vertices, triangles, scaling);
}

/** Whether a point is inside: each part that winds around it counts, whichever way it is turned; the cavity of a shell does not. */
function isInside(point, { solids, shell }) {
	const winds = (triangles) => Math.abs(windingOf(triangles, point)) > 0.5;
	return solids.some(winds) || shell.length > 0 && winds(shell[0]) && !winds(shell[1]);
}

const PROBE = new Model("probe", part([0, 0, 0], [1, 1, 1], false, false).flat(2), Array.from({ length: 24 }, (_, i) => i), Model.AS_GIVEN);

function checkPoint(game, agent, parts, point, systems) {
	const radius = 0.01 * agent.size;
	const all = [...parts.solids, ...parts.shell];
	const away = Math.min(...all.flat().map((triangle) => toTriangle(point, triangle)));
	if (away < 2 * radius) return;
	const isIn = isInside(point, parts);
	const probe = new Agent("probe");
	probe.hierarchical = true;
	probe.size = radius;
	probe.moveTo(...point);
	for (const [system, age] of systems) {
		const text = `${point} is ${isIn ? "in" : "out"}, ${away} from the surface of ${agent}, ${age} ${system.constructor.name}`;
		game.expect("inside touches", system.areColliding(agent, probe) === isIn, text);
		game.expect("inside touches", system.areColliding(probe, agent) === isIn, text);
		const queries = new AgentQueries(system);
		queries.update([agent]);
		const to = queries.distanceToPoint(agent, new Vector3D(...point));
		game.expect("inside distance", isIn ? to === 0 : Math.abs(to - away) < 1e-6 * agent.size, `${text}, distance ${to}`);
		game.expect("inside overlaps", queries.overlapping(new Sphere(new Vector3D(...point), radius)).length === (isIn ? 1 : 0), text);
		const hit = queries.cast(new Vector3D(...point), new Vector3D(0.3, 0.5, 0.81));
		game.expect("inside casts", isIn ? hit?.distance === 0 : !(hit?.distance <= away - 1e-6 * agent.size), `${text}, hit at ${hit?.distance}`);
		game.expect("inside touching", queries.touchesAny(probe) === isIn, text);
	}
}

export const models = {
	/** Any model of parts for the game's other calls. */
	parts: {
		random: ({ integer, pick, random }) => [pick(["blob 1", "blob 2"]), 1 + integer(1e6), random() < 0.5],
		play(game, name, seed, isSoup) {
			const { solids, shell } = partsOf(seed);
			game.take(modelOf(name, [...solids, ...shell], isSoup, 0, Model.FOOTPRINT));
		},
	},
	/** Points in and around a model, asked of a system that knows the models before it, and of a new one. */
	inside: {
		random: ({ integer, pick, random, between }) => [1 + integer(1e6), random() < 0.5, pick([0, 0, 10, 1e3, 4e6, -3e7]), pick([1, 1, 0.25, 7]), pick([0, 0, 90, between(0, 360)]), random() < 0.2],
		play(game, seed, isSoup, far, size, heading, isRemoved) {
			const { land } = game;
			land.prepareExact = seed % 2 === 0;
			const { solids, shell } = partsOf(seed);
			if (isRemoved) land.removeModel("parts");
			const model = modelOf("parts", [...solids, ...shell], isSoup, far, Model.AS_GIVEN);
			land.addModel(model);
			if (!land.hasModel("probe")) land.addModel(PROBE);
			const agent = new Agent("parts");
			agent.hierarchical = true;
			agent.size = size;
			agent.heading = far === 0 ? heading : 0;
			agent.moveTo(-far * size, 0, 0);
			// the triangles where the agent has them, in the order of the parts
			const triangles = trianglesOf(model, agent);
			const take = (each) => triangles.splice(0, each.length);
			const parts = { solids: solids.map(take), shell: shell.map(take) };
			const corners = [...parts.solids, ...parts.shell].flat(2);
			const exact = (Class) => Object.assign(new Class(land), { exact: true });
			game.exact ??= exact(HierarchicalCollider);
			const systems = [[game.exact, "a long used"], [exact(HierarchicalCollider), "a new"], [exact(CombinationCollider), "a new"]];
			const { random, integer, between } = toolsOf(numbersOf(seed + 1));
			for (let i = 0; i < 12; i++) {
				const [a, b] = [corners[integer(corners.length)], corners[integer(corners.length)]];
				const part = random();
				const spread = 0.3 * size;
				checkPoint(game, agent, parts, a.map((from, k) => from + part * (b[k] - from) + between(-spread, spread)), systems);
			}
		},
	},
	/** An asker that has not moved, whose model is replaced, removed and there again: it has its new shape, or its questions are refused. */
	asker: {
		random: ({ integer, between, random }) => [1 + integer(1e6), 1 + integer(1e6), between(0, 2), integer(4), random() < 0.5],
		play(game, seed, other, away, which, isListed) {
			const { land } = game;
			land.loadAllBoundingStructures = true;
			const give = (from) => {
				const { solids, shell } = partsOf(from);
				land.addModel(modelOf("parts", [...solids, ...shell], false, 0, Model.AS_GIVEN));
			};
			give(seed);
			const [asker, ball] = [new Agent("parts"), new Agent("sphere")];
			ball.moveTo(away, 0.2, 0.1);
			const setting = { system: which, exact: seed % 2 === 0, depth: 5 };
			const queries = new AgentQueries(game.makeSystem(setting));
			queries.update(isListed ? [ball, asker] : [ball]);
			const point = new Vector3D(away, 3, 1);
			const questions = [(of) => of.touchesAny(asker), (of) => of.distance(asker, ball), (of) => of.distanceToPoint(asker, point), (of) => of.castAgent(asker, 1, 0.2, 0.1)?.time ?? null, (of) => of.touching(asker).length, (of) => of.overlapsAgent(asker, 0.1, 0.2, 0.3)];
			const compare = () => {
				const fresh = new AgentQueries(game.makeSystem(setting));
				fresh.update([ball]);
				const [known, meant] = [queries, fresh].map((of) => questions.map((ask) => ask(of)));
				game.expect("asker is stale", known.every((value, i) => value === meant[i] || Math.abs(value - meant[i]) < HAIR), `${known}, with new questions ${meant}, in system ${which}, away ${away}`);
			};
			for (const model of [seed, other]) {
				give(model);
				compare();
			}
			land.removeModel("parts");
			const needsModel = which > 0;
			for (const [i, ask] of questions.entries()) {
				let problem = null;
				try {
					ask(queries);
				} catch (error) {
					problem = error;
				}
				game.expect("asker without model", problem?.name === "ArgumentError" || !needsModel && problem === null, `question ${i}: ${problem}, in system ${which}`);
			}
			give(seed);
			compare();
		},
	},
};
