/** Numbers that no place can have, and agents that no question is about: refused, and nothing has changed. */
import { engine } from "../tools.mjs";

const { AgentQueries, Box, Capsule, Sphere, Terrain, TerrainSurface, Vector3D, WorldBounds, WalkOptions } = engine;

/** Values that are beyond the world, or no numbers. */
const BEYOND = [NaN, Infinity, -Infinity, 1e10, -5e9, 1e100, 1e155, -1e200, 1e308];

/** Radii and greatest distances may be endless. */
const NO_LENGTHS = [NaN, -1, -Infinity, -1e-300];

/** Each takes a bad value, and the axis that has it. */
function triesOf(game, agent) {
	const { queries, collision } = game;
	const at = (value, axis) => new Vector3D(...[0.1, 0.2, 0.3].map((each, k) => (k === axis ? value : each)));
	const way = (value, axis) => [0.1, 0, 0.2].map((each, k) => (k === axis ? value : each));
	const ball = () => new Sphere(new Vector3D(), 1);
	const tries = {
		nearPoint: (value, axis) => queries.nearPoint(at(value, axis), 1),
		countNearPoint: (value, axis) => queries.countNearPoint(at(value, axis), 1),
		nearestToPoint: (value, axis) => queries.nearestToPoint(at(value, axis)),
		distanceToPoint: (value, axis) => queries.distanceToPoint(agent, at(value, axis)),
		cast: (value, axis) => queries.cast(at(value, axis), new Vector3D(1, 0, 0)),
		castAll: (value, axis) => queries.castAll(at(value, axis), new Vector3D(0, 0, -1)),
		overlapsAgent: (value, axis) => queries.overlapsAgent(agent, ...way(value, axis)),
		moveUntilTouch: (value, axis) => queries.moveUntilTouch(agent, ...way(value, axis)),
		slide: (value, axis) => queries.slide(agent, ...way(value, axis)),
		castAgent: (value, axis) => queries.castAgent(agent, ...way(value, axis)),
		castAgentAll: (value, axis) => queries.castAgentAll(agent, ...way(value, axis)),
		castShape: (value, axis) => queries.castShape(ball(), ...way(value, axis)),
		castShapeAll: (value, axis) => queries.castShapeAll(ball(), ...way(value, axis)),
		walk: (value, axis) => queries.walk(agent, ...way(value, axis % 2).slice(0, 2)),
		moveTo: (value, axis) => agent.moveTo(...way(value, axis)),
		jumpTo: (value, axis) => agent.jumpTo(...way(value, axis)),
		overlapping: (value, axis) => queries.overlapping(new Sphere(at(value, axis), 1)),
		overlappingBox: (value, axis) => queries.overlapping(new Box(at(value, axis), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1), 1, 1, 1)),
		overlappingCapsule: (value, axis) => queries.overlapping(new Capsule(at(value, axis), new Vector3D(), 1)),
		castBall: (value, axis) => queries.castShape(new Sphere(at(value, axis), 1), 1, 0, 0),
		radius: (value) => queries.overlapping(new Sphere(new Vector3D(), Math.abs(value))),
		terrain: (value, axis) => new Terrain(3, 3, ...[[value, 0, 0], [1, value, 0], [1, 0, value]][axis]),
	};
	const { terrain, bounds } = collision;
	if (terrain) {
		Object.assign(tries, {
			height: (value) => terrain.setHeight(1, 1, value),
			mound: (value, axis) => terrain.raiseMound(...[[value, 0, 1, 1], [0, 0, value, 1], [0, 0, 1, value]][axis]),
			groundToPoint: (value, axis) => queries.distanceToPoint(terrain.agent, at(value, axis)),
			surface: (value, axis) => new TerrainSurface(terrain, ...[[value, 0, 1, 1], [0, value, 1, 1], [0, 0, value === Infinity ? NaN : value > 0 ? -value : value, 1]][axis]),
		});
	}
	if (bounds) tries.edges = (value, axis) => bounds.setTo(...[[NaN, -1, -1, 1, 1, 1], [Infinity, -1, -1, 1, 1, 1], [1, -1, -1, -1, 1, 1]][axis]);
	return tries;
}

/** With these an endless value has a meaning. */
const MAY_BE_ENDLESS = ["surface"];

const lengthsOf = ({ queries }, agent) => ({
	near: (value) => queries.near(agent, value), countNear: (value) => queries.countNear(agent, value), nearest: (value) => queries.nearest(agent, value), nearestOf: (value) => queries.nearestOf(agent, 3, value),
	inCone: (value) => queries.inCone(agent, value, 90), degrees: (value) => queries.inCone(agent, 1, value), maxDistance: (value) => queries.cast(new Vector3D(), new Vector3D(1, 0, 0), value),
	stepHeight: (value) => Object.assign(new WalkOptions(), { stepHeight: value }), snap: (value) => Object.assign(new WalkOptions(), { snap: value }), fall: (value) => Object.assign(new WalkOptions(), { fall: value }),
	slope: (value) => Object.assign(new WalkOptions(), { slopeDegrees: value }),
});

/** The ground and the edges have no place, and hide nothing. */
const fixturesOf = ({ queries }, agent, fixture) => ({
	nearOf: () => queries.near(fixture, 3), countNearOf: () => queries.countNear(fixture, 3), nearestOfIt: () => queries.nearest(fixture), overlapsOf: () => queries.overlapsAgent(fixture, 0, 0, 0), canSeeIt: () => queries.canSee(agent, fixture),
	coneOf: () => queries.inCone(fixture, 3, 90), moveIt: () => queries.moveUntilTouch(fixture, 1, 0, 0), walkIt: () => queries.walk(fixture, 1, 0),
});

/** Makes a call that must be refused. */
function refuse(game, name, call) {
	const { terrain, bounds } = game.collision;
	const state = () => JSON.stringify([game.traits(), terrain && [terrain.getHeight(1, 1), terrain.agent.x, terrain.agent.z], bounds && [bounds.minX, bounds.maxZ]].map(String));
	const before = state();
	let problem = null;
	let answer;
	try {
		answer = call();
	} catch (error) {
		problem = error;
	}
	game.expect("limits refuse", problem !== null && ["RangeError", "ArgumentError"].includes(problem.name), `${name}: ${problem ?? answer}`);
	game.expect("limits say which", problem === null || !/undefined|\[object|less than Infinity/.test(problem.message), `${name}: ${problem?.message}`);
	game.expect("limits change nothing", state() === before, name);
}

export const limits = {
	beyond: {
		random: ({ integer }) => [integer(99), integer(99), integer(BEYOND.length), integer(3)],
		play(game, place, which, bad, axis) {
			if (game.agents.length === 0 || !game.known()) return;
			game.queries.update(game.agents);
			const tries = triesOf(game, game.at(place));
			const name = Object.keys(tries)[which % Object.keys(tries).length];
			if (MAY_BE_ENDLESS.includes(name) && Math.abs(BEYOND[bad]) > 0) return;
			refuse(game, `${name}(${BEYOND[bad]}), axis ${axis}`, () => tries[name](BEYOND[bad], axis));
		},
	},
	lengths: {
		random: ({ integer }) => [integer(99), integer(99), integer(NO_LENGTHS.length)],
		play(game, place, which, bad) {
			if (game.agents.length === 0 || !game.known()) return;
			game.queries.update(game.agents);
			const tries = lengthsOf(game, game.at(place));
			const name = Object.keys(tries)[which % Object.keys(tries).length];
			refuse(game, `${name}(${NO_LENGTHS[bad]})`, () => tries[name](NO_LENGTHS[bad]));
		},
	},
	fixture: {
		random: ({ integer, random }) => [integer(99), integer(99), random() < 0.5],
		play(game, place, which, isEdge) {
			if (game.agents.length === 0 || !game.known()) return;
			const fixture = (isEdge ? game.collision.bounds : game.collision.terrain)?.agent;
			if (!fixture) return;
			game.queries.update(game.agents);
			const tries = fixturesOf(game, game.at(place), fixture);
			const name = Object.keys(tries)[which % Object.keys(tries).length];
			refuse(game, `${name}(${isEdge ? "edges" : "ground"})`, tries[name]);
		},
	},
	/** All questions at the border of the world give numbers, or nothing. */
	border: {
		random: ({ integer, pick }) => [integer(99), pick([1e9, -1e9, 999999999.5]), integer(3)],
		play(game, place, value, axis) {
			if (game.agents.length === 0 || !game.known()) return;
			const agent = game.at(place);
			const queries = new AgentQueries(game.collision);
			queries.update(game.agents);
			const point = new Vector3D(...[0, 0, 0].map((each, k) => (k === axis ? value : each)));
			const { terrain } = game.collision;
			for (const each of terrain ? [agent, terrain.agent] : [agent]) {
				const out = new Vector3D();
				const away = queries.distanceToPoint(each, point, out);
				game.expect("limits border", away >= 0 && away < 4e9 && Math.abs(Math.hypot(out.x - point.x, out.y - point.y, out.z - point.z) - away) < 2e-3 && (axis !== 2 || value < 0 || away > 9e8), `${away} from ${each} to ${point}, ${out}`);
			}
			if (axis === 2 && value > 0 && terrain) {
				const [x, y] = [terrain.x + 0.3 * terrain.cellWidth, terrain.y + 0.6 * terrain.cellWidth];
				const hit = queries.cast(new Vector3D(x, y, value), new Vector3D(0, 0, -1));
				game.expect("limits ray", hit !== null && (hit.agent !== terrain.agent || Math.abs(value - hit.distance - terrain.heightAt(x, y)) < 1e-5), `a ray from ${value} meets ${hit?.agent} at ${hit?.distance}`);
			}
			const hit = queries.castAgent(agent, ...[0, 0, 0].map((each, k) => (k === axis ? value : each)));
			game.expect("limits cast", hit === null || hit.time >= 0 && hit.time <= 1 && Math.abs(Math.hypot(hit.normal.x, hit.normal.y, hit.normal.z) - 1) < 1e-9, `${hit?.time} ${hit?.normal}`);
		},
	},
};
