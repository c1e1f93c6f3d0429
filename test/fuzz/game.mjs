/**
 * A game that is made of a list of calls, each an array of plain values: [name, ...arguments]. After each that asks something, the answers are
 * compared with loops over all agents, and with a collision system that has never seen a frame. Any part of a list is a list, so that one that fails can
 * be made shorter. Kinds of calls with checks of their own are in kinds/.
 */
import assert from "node:assert/strict";
import { files } from "./kinds/files.mjs";
import { handlers, MEANT } from "./kinds/handlers.mjs";
import { gapToGround, ground, heightsOf, isBesideGround } from "./kinds/ground.mjs";
import { models, solid } from "./kinds/models.mjs";
import { points } from "./kinds/points.mjs";
import { snapshots } from "./kinds/snapshots.mjs";
import { walks } from "./kinds/walks.mjs";
import { watch } from "./kinds/watch.mjs";
import { prismsOf } from "./geometry.mjs";
import { OPEN } from "./open.mjs";
import { bodiesOf } from "./shapes.mjs";
import { engine, HAIR } from "./tools.mjs";

const { Agent, AgentQueries, BinCollider, BuiltInModel, ByteArray, Collision, CombinationCollider, GreatLand, HierarchicalCollider, Model, ObjModel, TightestFitCollider } = engine;

/** Calls that have a file of their own. */
const KINDS = { files, ground, handlers, models, points, snapshots, walks, watch };
export const MORE = Object.assign({}, ...Object.values(KINDS));

const SYSTEMS = [BinCollider, TightestFitCollider, HierarchicalCollider, CombinationCollider];
export const SHAPES = ["sphere", "cube", "cylinder", "blob 1", "blob 2"];

/** Models without volume: what is in one place, on a line or in a plane. */
export const THIN = {
	"point": [[0, 0, 0]],
	"one place": [[0, 0, 0, 0, 0, 0, 0, 0, 0], [0, 1, 2]],
	"two points": [[0, 0, 0, 1, 0, 0]],
	"mast": [[0, 0, 0, 0, 0, 1]],
	"triangle": [[0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]],
	"plane": [[0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]],
};
export const TRAITS = ["shape", "breed", "size", "heading", "pitch", "roll", "sweeps", "hierarchical", "traversalDepth", "collideAs"];

class Game {
	land = new GreatLand();
	agents = [];
	handlers = [];
	calls = [];
	thrown = 0;
	modelChanges = 0;
	groundChanges = 0;
	models = new Map();
	clouds = new Set();

	constructor() {
		for (const model of [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()]) this.take(model);
		for (const [name, [vertices, triangles = null]] of Object.entries(THIN)) this.take(new Model(name, vertices, triangles));
		this.setting = { system: 1, exact: false, depth: 5 };
		this.collision = new Collision(this.makeSystem());
		this.queries = new AgentQueries(this.collision);
	}

	/** Makes a call. @throws Error if an answer is wrong */
	play([name, ...values]) {
		if (name in MORE) MORE[name].play(this, ...values);
		else this[name](...values);
	}

	/** A check that can be left out, as long as its fault is known: see open.mjs. */
	expect(name, isRight, text) {
		if (!isRight && !OPEN.has(name)) assert.fail(`${name}: ${text}`);
	}

	makeSystem({ system, exact, depth } = this.setting) {
		const made = new SYSTEMS[system](this.land);
		if (system >= 2) Object.assign(made, { exact, maxDepth: depth });
		return made;
	}

	at(place) {
		return this.agents[place % this.agents.length];
	}

	/** What an agent can touch: the others, and the ground. */
	others(agent) {
		const { terrain } = this.collision;
		return [...this.agents.filter((other) => other !== agent), ...(terrain ? [terrain.agent] : [])];
	}

	setGround(terrain) {
		this.collision.terrain = terrain;
		this.groundChanges++;
	}

	setEdges(bounds) {
		this.collision.bounds = bounds;
		this.groundChanges++;
	}

	// what a game does

	add(x, y, z, size) {
		const agent = new Agent("sphere", "bears");
		agent.moveTo(x, y, z);
		agent.size = size;
		this.agents.push(agent);
	}

	/** Cubes side by side, of which some are left out. */
	tiles(x, y, z, size, holes) {
		for (let i = 0; i < 9; i++) {
			if (holes & 1 << i) continue;
			const tile = new Agent("cube", "walls");
			tile.moveTo(size * (x + i % 3), size * (y + Math.floor(i / 3)), size * z);
			tile.size = size;
			this.agents.push(tile);
		}
	}

	/** To a whole place, by quarters: among tiles it touches exactly. */
	walk(place, x, y, z, dx, dy, dz, slides) {
		if (this.agents.length === 0) return;
		this.at(place).jumpTo(x, y, z);
		for (let i = 0; i < 4; i++) this.go(place, dx, dy, dz, slides);
	}

	leave(place) {
		this.agents.splice(place % (this.agents.length || 1), 1);
	}

	move(place, x, y, z, jumps) {
		if (this.agents.length > 0) this.at(place)[jumps ? "jumpTo" : "moveTo"](x, y, z);
	}

	trait(place, name, value) {
		if (this.agents.length > 0) this.at(place)[name] = value;
	}

	model(name, seed, prepareExact, all) {
		Object.assign(this.land, { prepareExact, loadAllBoundingStructures: all, loadHulls: all });
		this.take(solid(name, seed));
	}

	/** Of models without triangles exact mode does not know where they are. */
	take(model) {
		this.land.addModel(model);
		this.clouds[model.triangles === null ? "add" : "delete"](model.name);
		this.models.set(model.name, model);
	}

	forget(name) {
		this.land.removeModel(name);
	}

	system(system, exact, depth) {
		this.setting = { system, exact, depth };
		this.collision.collisionSystem = this.makeSystem();
	}

	// what is looked at

	known() {
		return this.agents.every(({ shape }) => this.land.hasModel(shape));
	}

	numberOf(agent) {
		return agent.number ??= (this.count = (this.count ?? 0) + 1);
	}

	/** A frame, with what is called. */
	frame() {
		this.calls = [];
		this.thrown = 0;
		this.isReset = false;
		const isKnown = this.known();
		this.frameSystem = this.collision.collisionSystem;
		this.contacts = isKnown ? this.findContacts() : new Map();
		const before = JSON.stringify(this.traits());
		let problem = null;
		try {
			this.collision.update(this.agents);
		} catch (error) {
			problem = error;
		}
		const failed = this.collision.handlerErrors.find(({ name }) => name === "AssertionError");
		if (failed) throw failed;
		if (!isKnown) {
			assert.ok(problem && /no model/.test(problem.message), `a model is gone, and ${problem}`);
			assert.equal(this.calls.length, 0, "handlers of a frame that was refused");
			assert.equal(JSON.stringify(this.traits()), before, "a frame that was refused has changed agents");
			return this.calls;
		}
		const breeds = / \(in the handler for ".*" and ".*"\)$/;
		assert.equal(problem?.message.replace(breeds, "") ?? null, this.thrown > 0 ? MEANT : null, `update: ${problem?.stack}`);
		assert.ok(!problem || breeds.test(problem.message), "the error names no breeds");
		assert.equal(this.collision.handlerErrors.length, this.thrown, "handlers' errors");
		return this.calls;
	}

	/** The depth of each contact that handlers can be given, by a system that has seen nothing. */
	findContacts() {
		const fresh = this.makeSystem();
		const { terrain, bounds } = this.collision;
		const standing = this.agents.filter(({ sweeps }) => !sweeps);
		const found = fresh.findCollisions(standing);
		const depths = new Map();
		const add = (a, b) => depths.set(`${this.numberOf(a)} ${this.numberOf(b)}`, fresh.contactOf(a, b).depth);
		for (let i = 0; i < found.length; i += 2) add(found[i], found[i + 1]);
		for (const agent of standing) {
			for (const fixture of [terrain, bounds]) if (fixture && fresh.areColliding(agent, fixture.agent)) add(agent, fixture.agent);
		}
		return depths;
	}

	/** Every pair of agents that stand, by a system that knows nothing, and by loops. */
	check() {
		if (!this.known()) return;
		const before = JSON.stringify(this.traits());
		const fresh = this.makeSystem();
		const touches = (system, a, b) => system.areColliding(a, b);
		const stands = (agent) => !agent.sweeps;
		const found = new Set();
		const pairs = this.makeSystem().findCollisions(this.agents);
		for (let i = 0; i < pairs.length; i += 2) found.add(`${this.numberOf(pairs[i])} ${this.numberOf(pairs[i + 1])}`);
		assert.equal(found.size, pairs.length / 2, "a pair was found twice");
		const deeper = this.setting.system >= 2 ? this.makeSystem({ ...this.setting, depth: this.setting.depth + 2 }) : null;
		const exact = this.setting.system === 1 || this.setting.system >= 2 && !this.setting.exact ? this.makeSystem({ system: this.setting.system === 1 ? 2 : this.setting.system, exact: true, depth: 10 }) : null;
		this.queries.update(this.agents);
		this.agents.forEach((a, i) => this.agents.forEach((b, j) => {
			if (j <= i) return;
			const isTouching = touches(fresh, a, b);
			const text = `${a} and ${b} in ${JSON.stringify(this.setting)}`;
			assert.equal(touches(fresh, b, a), isTouching, `not symmetric: ${text}`);
			const times = [[a, b], [b, a]].filter(([one, other]) => found.has(`${this.numberOf(one)} ${this.numberOf(other)}`)).length;
			assert.equal(times, isTouching ? 1 : 0, `found and asked: ${text}`);
			if (!isTouching && deeper) assert.ok(!touches(deeper, a, b), `deeper finds more: ${text}`);
			const haveTriangles = !this.clouds.has(a.shape) && !this.clouds.has(b.shape);
			if (!isTouching && exact && haveTriangles) assert.ok(!touches(exact, a, b), `exact finds more: ${text}`);
			const distance = this.queries.distance(a, b);
			assert.equal(distance === 0, isTouching, `distance ${distance} of ${isTouching}: ${text}`);
			assert.equal(this.queries.distance(b, a), distance, `distance is not symmetric: ${text}`);
		}));
		assert.equal(JSON.stringify(this.traits()), before, "asking has changed agents");
	}

	/** Questions about an agent, against loops. */
	ask(place, to, radius, degrees) {
		if (this.agents.length < 2 || !this.known()) return;
		const { queries, agents } = this;
		const agent = this.at(place);
		const target = this.at(to);
		const before = JSON.stringify(this.traits());
		queries.update(agents);
		const away = (other) => Math.hypot(other.x - agent.x, other.y - agent.y, other.z - agent.z);
		const near = queries.near(agent, radius);
		for (const other of agents) {
			const isNear = near.includes(other);
			if (other === agent) assert.ok(!isNear, "near lists the agent itself");
			else if (isNear) assert.ok(away(other) <= radius * (1 + HAIR), `${other} is not near ${agent}`);
			else assert.ok(away(other) >= radius * (1 - HAIR), `${other} is near ${agent}, not listed`);
		}
		near.forEach((other, i) => i === 0 || assert.ok(away(near[i - 1]) <= away(other) * (1 + HAIR), "near is not sorted"));
		assert.equal(queries.countNear(agent, radius), near.length, "countNear");
		assert.equal(queries.nearest(agent, radius), near[0] ?? null, "nearest");
		for (const other of queries.inCone(agent, radius, degrees)) assert.ok(near.includes(other), "in the cone, not near");
		assert.deepEqual(new Set(queries.inCone(agent, radius, 360)), new Set(near), "a cone of 360 degrees");
		const fresh = this.makeSystem();
		const touching = new Set(this.others(agent).filter((other) => fresh.areColliding(agent, other)));
		assert.deepEqual(new Set(queries.touching(agent)), touching, `touching ${agent}`);
		if (agent !== target) {
			const [x, y, z] = [target.x - agent.x, target.y - agent.y, target.z - agent.z + 0.1];
			const origin = { x: agent.x, y: agent.y, z: agent.z + 0.3 };
			const ray = [new engine.Vector3D(origin.x, origin.y, origin.z), new engine.Vector3D(x, y, z)];
			if (Math.hypot(x, y, z) > 0) {
				const hit = queries.cast(...ray, 20);
				const all = queries.castAll(...ray, 20);
				// of two that are equally far away but for rounding, either may be the first
				const first = all.filter(({ distance }) => distance <= all[0].distance * (1 + 1e-14)).map((each) => each.agent);
				assert.ok(hit === null ? all.length === 0 : first.includes(hit.agent), `cast and the first of castAll: ${hit?.agent}, not ${first}`);
				for (const each of all) assert.ok(each.distance >= all[0].distance && each.distance <= 20, "castAll's distances");
				const surfaces = queries.castAll(...ray, 20, null, null, true);
				const firsts = new Map();
				for (const each of surfaces) if (!firsts.has(each.agent)) firsts.set(each.agent, each.distance);
				assert.deepEqual(firsts, new Map(all.map((each) => [each.agent, each.distance])), "each agent's first surface is its hit");
			}
			assert.equal(queries.canSee(agent, target), queries.canSee(target, agent), "canSee is not symmetric");
		}
		this.checkCasts(agent, target);
		assert.equal(JSON.stringify(this.traits()), before, "asking has changed agents");
	}

	/** A cast names the first in the list of those that it meets at the same time, the ground last. */
	checkCasts(agent, target) {
		const { queries } = this;
		const way = [target.x - agent.x + 0.3, target.y - agent.y, target.z - agent.z - 0.2];
		const hits = queries.castAgentAll(agent, ...way);
		const first = this.others(agent).find((other) => hits.some((hit) => hit.agent === other && hit.time === hits[0].time));
		const hit = queries.castAgent(agent, ...way);
		this.expect("cast names the first", (hit?.agent ?? null) === (first ?? null) && (hit === null || hit.time === hits[0].time), `${agent} meets ${hit?.agent} at ${hit?.time}, not ${first} at ${hits[0]?.time}, in ${JSON.stringify(this.setting)}`);
		for (const each of hits) this.expect("cast has a normal", Math.abs(each.normal.length - 1) < HAIR && each.time >= 0 && each.time <= 1, `${each.normal}, ${each.time}`);
	}

	/**
	 * How deep an agent is in another, as a part of the larger size: no deeper than 5 hairs if one of 26 directions leads out within that. A contact's depth is
	 * along its normal, which in a corner need not be the shortest way.
	 */
	depthOf(system, agent, other) {
		const size = Math.max(agent.size, other.size);
		const { terrain } = this.collision;
		const bodies = other === terrain?.agent ? bodiesOf(this, agent) : null;
		// a corridor exactly as wide as the agent has no way out but up
		if (bodies) return Math.max(0, -gapToGround(bodies, prismsOf(terrain, heightsOf(terrain))).least) / size;
		const [x, y, z] = [agent.x, agent.y, agent.z];
		const { depth } = system.contactOf(agent, other);
		for (let i = 0; i < 27 && depth > 5 * HAIR * size; i++) {
			const way = [i % 3 - 1, Math.floor(i / 3) % 3 - 1, Math.floor(i / 9) - 1].map((step) => step * 2.5 * HAIR * size);
			agent.moveTo(x + way[0], y + way[1], z + way[2]);
			const isOut = !system.areColliding(agent, other);
			agent.moveTo(x, y, z);
			if (isOut) return 5 * HAIR;
		}
		return depth / size;
	}

	/** Goes as far as it is free. */
	go(place, x, y, z, slides) {
		if (this.agents.length < 2 || !this.known()) return;
		const agent = this.at(place);
		const isBeside = isBesideGround(this, agent);
		this.queries.update(this.agents);
		const fresh = this.makeSystem();
		const deepest = () => Math.max(0, ...this.others(agent).filter((other) => fresh.areColliding(agent, other)).map((other) => this.depthOf(fresh, agent, other)));
		const before = deepest();
		const [fromX, fromY, fromZ] = [agent.x, agent.y, agent.z];
		const part = this.queries[slides ? "slide" : "moveUntilTouch"](agent, x, y, z);
		assert.ok(part >= 0 && part <= 1, `a part of ${part}`);
		const went = Math.hypot(agent.x - fromX, agent.y - fromY, agent.z - fromZ);
		const whole = Math.hypot(x, y, z);
		// what is less than a millionth of the larger extent deep is led out first (docs/mover.md), in a corner up to twice as far
		const lift = 2e-6 * Math.max(1, agent.size, ...this.others(agent).map(({ size }) => size));
		this.expect("goes as far as it says", went <= whole * (part + HAIR) + lift, `${agent} went ${went} of ${whole}, said ${part}`);
		if (before <= HAIR && isBeside) assert.ok(deepest() <= 5 * HAIR, `${agent} ends ${deepest()} deep, from ${before}`);
		if (!slides && part < 1) {
			// a bit farther it touches; where it grazes, only here, or it is as near as rounding
			const meets = () => this.others(agent).some((other) => fresh.areColliding(agent, other) || this.queries.distance(agent, other) < 1e-12);
			const probe = [agent.x, agent.y, agent.z];
			const meetsHere = meets();
			agent.moveTo(agent.x + 1e-6 * x / whole, agent.y + 1e-6 * y / whole, agent.z + 1e-6 * z / whole);
			const meetsFarther = meets();
			agent.moveTo(...probe);
			assert.ok(meetsHere || meetsFarther, `${agent} stopped at nothing`);
		}
	}

	traits(agents = this.agents) {
		return agents.map((agent) => [agent.x, agent.y, agent.z, ...TRAITS.map((name) => agent[name])]);
	}

	putBack(agents, traits) {
		agents.forEach((agent, i) => {
			agent.jumpTo(...traits[i].slice(0, 3));
			TRAITS.forEach((name, k) => { agent[name] = traits[i][3 + k]; });
		});
	}

	/** Calls that must fail, and change nothing. */
	wrong(which) {
		if (this.agents.length === 0 || !this.known()) return;
		// each time by a system that has seen nothing: the second frame of one would know motions
		const before = JSON.stringify([this.traits(), this.makeSystem().findCollisions(this.agents).map((agent) => this.numberOf(agent))]);
		const [agent] = this.agents;
		const tries = [
			() => this.collision.update([...this.agents, agent]),
			() => this.collision.update([...this.agents, null]),
			() => { agent.size = -1; },
			() => agent.moveTo(NaN, 0, 0),
			() => { agent.heading = Infinity; },
			() => this.queries.near(agent, -1),
			() => this.queries.moveUntilTouch(agent, NaN, 0, 0),
			() => this.land.addModel(null),
			() => new ObjModel("bad", "v 0 0\nf 1 2 3\n"),
			() => this.collision.onCollision("", "bears", () => {}),
			() => this.collision.restore(new ByteArray(), this.agents),
			() => this.queries.cast(new engine.Vector3D(), new engine.Vector3D()),
		];
		assert.throws(tries[which % tries.length], (error) => error instanceof Error && error.name !== "TypeError", `call ${which % tries.length} did not fail as it should`);
		assert.equal(JSON.stringify([this.traits(), this.makeSystem().findCollisions(this.agents).map((each) => this.numberOf(each))]), before, `call ${which % tries.length} has changed something`);
	}
}

/** What goes wrong in a game of these calls: null, or the error's message. @param onCall is told the number of each call before it is made */
export function problemOf(calls, onCall = () => {}) {
	const game = new Game();
	for (const [i, call] of calls.entries()) {
		onCall(i);
		try {
			game.play(call);
		} catch (error) {
			return error.message;
		}
	}
	return null;
}
