/** The ground and the edges of the world: slopes, columns, corners of two and three faces, the outer side. Prisms say who touches them, and how far away they are. */
import assert from "node:assert/strict";
import { gapToPrism, length, prismsOf, toPrism } from "../geometry.mjs";
import { bodiesOf } from "../shapes.mjs";
import { engine, HAIR, numbersOf } from "../tools.mjs";

const { Terrain, WorldBounds } = engine;

/** No contact is so much longer than another way out: it leads out by about the shortest way, mostly within 1.5 times. */
const LONGEST = 3;

/** Heights by their column and row. */
const STYLES = {
	flat: () => () => 0,
	rough: (random) => () => 1.5 * random() - 0.75,
	steps: (random) => () => Math.floor(3 * random()) / 4,
	wall: () => (column) => (column === 2 ? 1.5 : 0),
	corner: () => (column, row) => (column === 2 ? 1.5 : 0) + (row === 2 ? 1 : 0),
	groove: () => (column) => 1.3 * Math.abs(column - 2),
	pit: () => (column, row) => (column === 2 && row === 2 ? -1 : 0),
	needle: () => (column, row) => (column === 2 && row === 2 ? 2.5 : 0),
	mound: () => (column, row) => Math.max(0, 1.5 - 0.4 * Math.hypot(column - 2, row - 2)),
	ravine(random) {
		const [way, steep] = [2 * Math.PI * random(), 1 + 2 * random()];
		return (column, row) => steep * Math.abs((column - 2.2) * Math.cos(way) + (row - 2.2) * Math.sin(way)) + 0.2 * random();
	},
};

export const heightsOf = (terrain) => Array.from({ length: terrain.columns * terrain.rows }, (_, i) => terrain.getHeight(i % terrain.columns, Math.floor(i / terrain.columns)));

/** Directions to the neighbours of a cube among 27. */
const WAYS = Array.from({ length: 27 }, (_, i) => [i % 3 - 1, Math.floor(i / 3) % 3 - 1, Math.floor(i / 9) - 1]).filter((way) => length(way) > 0).map((way) => way.map((part) => part / length(way)));

const reachOf = (bodies) => {
	const all = (name, pick) => pick(...bodies.map(({ extents }) => extents[name]));
	return Math.max(all("maxX", Math.max) - all("minX", Math.min), all("maxY", Math.max) - all("minY", Math.min), all("maxZ", Math.max) - all("minZ", Math.min));
};

/** Moves an agent for a question, and back. */
export function standing(agent, [x, y, z], ask) {
	const [fromX, fromY, fromZ] = [agent.x, agent.y, agent.z];
	agent.moveTo(fromX + x, fromY + y, fromZ + z);
	const answer = ask();
	agent.moveTo(fromX, fromY, fromZ);
	return answer;
}

/** The contact leads out, a little less does not; and no other way out is much shorter. */
function checkContact(game, agent, fixture, extent, tag) {
	const fresh = game.makeSystem();
	const { depth, normal } = fresh.contactOf(agent, fixture);
	const text = `${agent} and ${fixture}, depth ${depth} along ${normal}, in ${JSON.stringify(game.setting)}`;
	game.expect(`${tag} normal`, Math.abs(length([normal.x, normal.y, normal.z]) - 1) < HAIR && depth >= 0, text);
	// what a part of nothing is leads nowhere
	if (extent === 0) return;
	const touchesAt = (way, part) => standing(agent, way.map((each) => each * part), () => fresh.areColliding(agent, fixture));
	const out = [normal.x, normal.y, normal.z];
	// a hair is more than rounding: of coordinates too
	const hair = 2 * HAIR * extent + 1e-13;
	game.expect(`${tag} frees`, !touchesAt(out, depth + hair), text);
	game.expect(`${tag} holds`, depth <= hair || touchesAt(out, depth - hair), text);
	const limit = depth / LONGEST;
	if (limit < 1e-5 * extent) return;
	for (const way of WAYS) {
		for (const part of [1, 0.7, 0.4]) game.expect(`${tag} least`, touchesAt(way, part * limit), `${text}, not ${part * limit} along ${way}`);
	}
}

/** The distance of bodies from the ground: at least and at most. */
export function gapToGround(bodies, prisms) {
	let least = Infinity;
	let most = Infinity;
	for (const body of bodies) {
		for (const prism of prisms) {
			const gap = gapToPrism(body, prism);
			least = Math.min(least, gap);
			if (gap < most) most = Math.min(most, ...body.corners.map((corner) => toPrism(corner, prism) - (body.radius ?? 0)));
		}
	}
	return { least, most: Math.max(least, most) };
}

/** Whether an agent is free of all prisms where it is, or a bit beside. A point between two prisms is deep in neither of them, but deep in the ground. */
export function isBesideGround(game, agent) {
	const { terrain } = game.collision;
	if (!terrain || !bodiesOf(game, agent)) return true;
	const prisms = prismsOf(terrain, heightsOf(terrain));
	return [[0, 0, 0], ...WAYS].some((way) => standing(agent, way.map((part) => 10 * HAIR * agent.size * part), () => gapToGround(bodiesOf(game, agent), prisms).least > 0));
}

/** Where to put an agent: its share of the ground, or a bit beside it. */
export function spotOn(terrain, u, v) {
	const half = terrain.isBlocky ? terrain.cellWidth / 2 : 0;
	const [x, y] = [terrain.x - half + u * (terrain.cellWidth * (terrain.columns - 1) + 2 * half), terrain.y - half + v * (terrain.cellWidth * (terrain.rows - 1) + 2 * half)];
	const height = terrain.heightAt(x, y);
	return [x, y, Number.isNaN(height) ? 0 : height];
}

const share = ({ random, pick }) => (random() < 0.4 ? pick([0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 1]) : -0.1 + 1.2 * random());

export const ground = {
	ground: {
		random: ({ pick, random, integer }) => [3 + integer(4), 3 + integer(4), random() < 0.5, pick([1, 1, 1, 0.5, 2]), integer(4) - 3, integer(4) - 3, pick(Object.keys(STYLES)), 1 + integer(1e6)],
		play(game, columns, rows, isBlocky, cell, x, y, style, seed) {
			const heightAt = STYLES[style](numbersOf(seed));
			const terrain = new Terrain(columns, rows, cell, x, y);
			terrain.isBlocky = isBlocky;
			for (let row = 0; row < rows; row++) {
				for (let column = 0; column < columns; column++) terrain.setHeight(column, row, heightAt(column, row));
			}
			game.setGround(terrain);
		},
	},
	noGround: { random: () => [], play: (game) => game.setGround(null) },
	raise: {
		random: ({ integer, pick, between }) => [integer(99), integer(99), pick([0, 0.25, 1, between(-1, 1)])],
		play(game, column, row, height) {
			const { terrain } = game.collision;
			if (terrain) terrain.setHeight(column % terrain.columns, row % terrain.rows, height);
			game.groundChanges++;
		},
	},
	edges: {
		random: ({ between, random }) => [between(1, 4), between(1, 4), random() < 0.3 ? Infinity : between(1, 4), random() < 0.5],
		play(game, x, y, z, isMoved) {
			if (isMoved && game.collision.bounds) game.collision.bounds.setTo(-x, -y, -z, x, y, z);
			else game.setEdges(new WorldBounds(-x, -y, -z, x, y, z));
		},
	},
	beside: {
		random: ({ integer, between, pick }) => [integer(99), integer(3), pick([-1, 1]), pick([0, between(-1, 1)])],
		play(game, place, axis, side, away) {
			const { bounds } = game.collision;
			if (!bounds || game.agents.length === 0 || !game.known()) return;
			const agent = game.at(place);
			const edge = [[bounds.minX, bounds.maxX], [bounds.minY, bounds.maxY], [bounds.minZ, bounds.maxZ]][axis][side > 0 ? 1 : 0];
			if (Math.abs(edge) < Infinity) agent.jumpTo(...[agent.x, agent.y, agent.z].map((at, k) => (k === axis ? edge - side * away : at)));
			checkEdges(game, agent, bounds);
		},
	},
	noEdges: { random: () => [], play: (game) => game.setEdges(null) },
	stand: {
		random: (tools) => [tools.integer(99), share(tools), share(tools), tools.pick([0, 0.001, 0.02, 0.3, tools.between(-0.3, 1)])],
		play(game, place, u, v, depth) {
			const { terrain } = game.collision;
			if (!terrain || game.agents.length === 0 || !game.known()) return;
			const agent = game.at(place);
			const [x, y, z] = spotOn(terrain, u, v);
			agent.jumpTo(x, y, z - depth * agent.size);
			checkGround(game, agent, terrain);
			checkEdges(game, agent, game.collision.bounds);
		},
	},
};

function checkGround(game, agent, terrain) {
	const fresh = game.makeSystem();
	const isTouching = fresh.areColliding(agent, terrain.agent);
	assert.equal(fresh.areColliding(terrain.agent, agent), isTouching, `ground: not symmetric ${agent}`);
	const bodies = bodiesOf(game, agent);
	if (bodies === null) return;
	const { least, most } = gapToGround(bodies, prismsOf(terrain, heightsOf(terrain)));
		const text = `${agent} in ${JSON.stringify(game.setting)}, ${least} to ${most} away`;
	if (least > 5 * HAIR) game.expect("ground touches", !isTouching, `too early: ${text}`);
	if (least < -5 * HAIR) game.expect("ground touches", isTouching, `not: ${text}`);
	game.queries.update(game.agents);
	const away = game.queries.distance(agent, terrain.agent);
	game.expect("ground distance", away === 0 === isTouching && away >= least - 5 * HAIR && away <= Math.max(0, most) + 5 * HAIR, `${away}: ${text}`);
	game.expect("ground distance", Math.abs(game.queries.distance(terrain.agent, agent) - away) < HAIR, `from the ground: ${text}`);
	if (isTouching) checkContact(game, agent, terrain.agent, reachOf(bodies), "ground contact");
}

function checkEdges(game, agent, bounds) {
	if (bounds === null) return;
	const bodies = bodiesOf(game, agent);
	if (bodies === null) return;
	const gaps = bodies.map(({ extents: e }) => Math.min(e.minX - bounds.minX, bounds.maxX - e.maxX, e.minY - bounds.minY, bounds.maxY - e.maxY, e.minZ - bounds.minZ, bounds.maxZ - e.maxZ));
	const gap = Math.min(...gaps);
	game.queries.update(game.agents);
	const isTouching = game.queries.touchesEdge(agent, bounds);
	const away = game.queries.distance(agent, bounds.agent);
	const text = `${agent} in ${JSON.stringify(game.setting)}, ${gap} from the edges`;
	if (Math.abs(gap) > 5 * HAIR) game.expect("edges touch", isTouching === gap < 0, text);
	game.expect("edges distance", away === 0 === isTouching && Math.abs(away - Math.max(0, gap)) < 5 * HAIR, `${away}: ${text}`);
	const width = Math.min(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY, bounds.maxZ - bounds.minZ);
	if (isTouching && reachOf(bodies) < 0.9 * width) checkContact(game, agent, bounds.agent, reachOf(bodies), "edges contact");
}

