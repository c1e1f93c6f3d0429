/**
 * A game that is made of a list of calls, each an array of plain values: [name, ...arguments]. After each that asks something, the answers are
 * compared with loops over all agents, and with a collision system that has never seen a frame. Any part of a list is a list, so that one that fails can
 * be made shorter. This file is long because each kind of call is a method of it.
 */
import assert from "node:assert/strict";
import * as engine from "../../bin/module/starlogo-collision.min.js";
import { randomNumbers } from "../module/games.mjs";

const { Agent, AgentQueries, BinCollider, BuiltInModel, ByteArray, Collision, CombinationCollider, GreatLand, HierarchicalCollider, Model, ModelError, ObjModel, TightestFitCollider } = engine;

const SYSTEMS = [BinCollider, TightestFitCollider, HierarchicalCollider, CombinationCollider];
const BREEDS = ["bears", "balls", "walls"];
const SHAPES = ["sphere", "cube", "cylinder", "blob 1", "blob 2"];

/** Models without volume: what is in one place, on a line or in a plane. */
const THIN = {
	"point": [[0, 0, 0]],
	"one place": [[0, 0, 0, 0, 0, 0, 0, 0, 0], [0, 1, 2]],
	"two points": [[0, 0, 0, 1, 0, 0]],
	"mast": [[0, 0, 0, 0, 0, 1]],
	"triangle": [[0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]],
	"plane": [[0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]],
};
const KINDS = ["onCollision", "onCollisionStart", "onCollisionEnd"];
const TRAITS = ["shape", "breed", "size", "heading", "pitch", "roll", "sweeps", "hierarchical", "traversalDepth", "collideAs"];
const MEANT = "meant";

/** What numbers may be apart by rounding, as a part of them. */
const HAIR = 1e-9;

/** A random closed solid: an octahedron whose corners are elsewhere, cut by more corners. */
function solid(name, seed) {
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

class Game {
	land = new GreatLand();
	agents = [];
	handlers = [];
	calls = [];
	thrown = 0;
	modelChanges = 0;
	clouds = new Set();

	constructor() {
		for (const model of [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()]) this.land.addModel(model);
		for (const [name, [vertices, triangles = null]] of Object.entries(THIN)) this.take(new Model(name, vertices, triangles));
		this.setting = { system: 1, exact: false, depth: 5 };
		this.collision = new Collision(this.makeSystem());
		this.queries = new AgentQueries(this.collision);
	}

	/** Makes a call. @throws Error if an answer is wrong */
	play([name, ...values]) {
		this[name](...values);
	}

	makeSystem({ system, exact, depth } = this.setting) {
		const made = new SYSTEMS[system](this.land);
		if (system >= 2) Object.assign(made, { exact, maxDepth: depth });
		return made;
	}

	at(place) {
		return this.agents[place % this.agents.length];
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

	model(name, seed, prepareExact, all, bounds) {
		Object.assign(this.land, { prepareExact, loadAllBoundingStructures: all, hierarchyBounds: bounds });
		this.take(solid(name, seed));
	}

	/** Of models without triangles exact mode does not know where they are. */
	take(model) {
		this.land.addModel(model);
		this.clouds[model.triangles === null ? "add" : "delete"](model.name);
	}

	forget(name) {
		this.land.removeModel(name);
	}

	system(system, exact, depth) {
		this.setting = { system, exact, depth };
		this.collision.collisionSystem = this.makeSystem();
	}

	handler(kind, breed, other, action, takesContact) {
		const call = (collider, collidee, contact) => {
			this.calls.push([kind, this.numberOf(collider), this.numberOf(collidee), ...(contact ? [contact.time, contact.depth, contact.normal.x, contact.point.x] : [])]);
			if (contact) assert.ok(contact.time >= 0 && contact.time <= 1 && Math.abs(contact.normal.length - 1) < HAIR, `contact ${contact.time} ${contact.normal}`);
			if (action === "throw") {
				this.thrown++;
				throw new Error(MEANT);
			}
			if (action === "leave" && this.agents.length > 3) this.leave(this.agents.indexOf(collidee) + this.agents.length);
			if (action === "move") collidee.moveTo(collidee.x + 0.01, collidee.y, collidee.z);
			if (action === "system") this.system((this.setting.system + 1) % SYSTEMS.length, false, 4);
			if (action === "model") {
				this.modelChanges++;
				this.take(solid("blob 1", this.calls.length + 1));
			}
			if (action === "update") assert.throws(() => this.collision.update(this.agents), /must not be called from a handler/);
		};
		const handler = takesContact ? (a, b, contact) => call(a, b, contact) : (a, b) => call(a, b, null);
		this.collision[kind](breed, other, handler);
		this.handlers.push([breed, other, handler]);
	}

	unhandle(place) {
		if (this.handlers.length === 0) return;
		const [removed] = this.handlers.splice(place % this.handlers.length, 1);
		assert.ok(this.collision.removeHandler(...removed), "a handler was not there");
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
		const isKnown = this.known();
		const before = JSON.stringify(this.traits());
		let problem = null;
		try {
			this.collision.update(this.agents);
		} catch (error) {
			problem = error;
		}
		if (!isKnown) {
			assert.ok(problem && /no model/.test(problem.message), `a model is gone, and ${problem}`);
			assert.equal(this.calls.length, 0, "handlers of a frame that was refused");
			assert.equal(JSON.stringify(this.traits()), before, "a frame that was refused has changed agents");
			return this.calls;
		}
		assert.equal(problem?.message ?? null, this.thrown > 0 ? MEANT : null, `update: ${problem?.stack}`);
		assert.equal(this.collision.handlerErrors.length, this.thrown, "handlers' errors");
		return this.calls;
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
		const touching = new Set(agents.filter((other) => other !== agent && fresh.areColliding(agent, other)));
		assert.deepEqual(new Set(queries.touching(agent)), touching, `touching ${agent}`);
		if (agent !== target) {
			const [x, y, z] = [target.x - agent.x, target.y - agent.y, target.z - agent.z + 0.1];
			const origin = { x: agent.x, y: agent.y, z: agent.z + 0.3 };
			const ray = [new engine.Vector3D(origin.x, origin.y, origin.z), new engine.Vector3D(x, y, z)];
			if (Math.hypot(x, y, z) > 0) {
				const hit = queries.cast(...ray, 20);
				const all = queries.castAll(...ray, 20);
				assert.equal(hit?.agent ?? null, all[0]?.agent ?? null, "cast and the first of castAll");
				for (const each of all) assert.ok(each.distance >= all[0].distance && each.distance <= 20, "castAll's distances");
			}
			assert.equal(queries.canSee(agent, target), queries.canSee(target, agent), "canSee is not symmetric");
		}
		assert.equal(JSON.stringify(this.traits()), before, "asking has changed agents");
	}

	/**
	 * How deep an agent is in another, as a part of the larger size: no deeper than 5 hairs if one of 26 directions leads out within that. A contact's depth is
	 * along its normal, which in a corner need not be the shortest way.
	 */
	depthOf(system, agent, other) {
		const size = Math.max(agent.size, other.size);
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
		this.queries.update(this.agents);
		const fresh = this.makeSystem();
		const deepest = () => Math.max(0, ...this.agents.filter((other) => other !== agent && fresh.areColliding(agent, other)).map((other) => this.depthOf(fresh, agent, other)));
		const before = deepest();
		const [fromX, fromY, fromZ] = [agent.x, agent.y, agent.z];
		const part = this.queries[slides ? "slide" : "moveUntilTouch"](agent, x, y, z);
		assert.ok(part >= 0 && part <= 1, `a part of ${part}`);
		const went = Math.hypot(agent.x - fromX, agent.y - fromY, agent.z - fromZ);
		const whole = Math.hypot(x, y, z);
		assert.ok(went <= whole * (part + HAIR) + 1e-6, `${agent} went ${went} of ${whole}, said ${part}`);
		if (before <= HAIR) assert.ok(deepest() <= 5 * HAIR, `${agent} ends ${deepest()} deep, from ${before}`);
		if (!slides && part < 1) {
			// a bit farther it touches; where it grazes, only here
			const meets = () => this.agents.some((other) => other !== agent && fresh.areColliding(agent, other));
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

	/** A snapshot, some frames of motion, back, and the same again. */
	rewind(frames, step) {
		const listed = [...this.agents];
		this.frame();
		if (!listed.every(({ shape }) => this.land.hasModel(shape))) return;
		const staying = [...this.agents];
		const before = this.traits(listed);
		const setting = { ...this.setting };
		const bytes = this.collision.snapshot();
		const models = this.modelChanges;
		const runOn = () => {
			const all = [];
			for (let i = 0; i < frames; i++) {
				this.agents.forEach((agent, k) => agent.moveTo(agent.x + step * ((k + i) % 3 - 1), agent.y + step * ((k * 7 + i) % 5 - 2), agent.z));
				all.push(JSON.stringify(this.frame()));
			}
			return all.join("\n");
		};
		const first = runOn();
		// what has changed the models or the system can't be taken back
		if (JSON.stringify(setting) !== JSON.stringify(this.setting) || models !== this.modelChanges) return;
		this.agents = staying;
		listed.forEach((agent, i) => {
			agent.jumpTo(...before[i].slice(0, 3));
			TRAITS.forEach((name, k) => { agent[name] = before[i][3 + k]; });
		});
		const bad = new ByteArray(bytes);
		bad.length = Math.max(0, bad.length - 1 - frames);
		assert.throws(() => this.collision.restore(bad, listed), /no snapshot/);
		this.collision.restore(bytes, listed);
		assert.equal(runOn(), first, "after a restore it is not the same");
	}

	/** A damaged file is refused or read; nothing else comes of it. */
	file(kind, seed) {
		const random = randomNumbers(seed);
		const { text, read } = FILES[kind];
		const letters = [...text];
		for (let i = 1 + Math.floor(3 * random()); i > 0; i--) {
			const at = Math.floor(random() * letters.length);
			const damage = random();
			if (damage < 0.3) letters.splice(at, 1 + Math.floor(20 * random()));
			else if (damage < 0.7) letters[at] = PIECES[Math.floor(random() * PIECES.length)];
			else letters.splice(at, 0, ...letters.slice(Math.floor(random() * letters.length)).slice(0, 30));
		}
		let model;
		try {
			model = read("damaged", letters.join(""));
		} catch (error) {
			assert.ok(error instanceof ModelError || error.name === "ModelError", `${kind}: ${error.stack}`);
			return;
		}
		assert.ok(model.vertices.every(Number.isFinite), `${kind}: vertices that are not finite`);
		this.land.addModel(model);
		this.land.removeModel("damaged");
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

/** What goes wrong in a game of these calls: null, or the error's message. */
export function problemOf(calls) {
	const game = new Game();
	for (const call of calls) {
		try {
			game.play(call);
		} catch (error) {
			return error.message;
		}
	}
	return null;
}

const PIECES = ["nan", "-1", "1e308", "0", "999999999", "<", ">", "/", "\"", "{", "]", " ", "\n", "#", "f 1 1 1\n", "\u0000", "1e-320"];
const OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nf 1 3 2\nf 1 2 4\nf 2/1/1 3/1/1 4/1/1\nf -2 -4 -1\n";
const STL = `solid a\n${[[0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 0, 0, 1, 0, 0, 0, 0, 1], [1, 0, 0, 0, 1, 0, 0, 0, 1]].map((v) => `facet normal 0 0 1\nouter loop\nvertex ${v.slice(0, 3).join(" ")}\nvertex ${v.slice(3, 6).join(" ")}\nvertex ${v.slice(6).join(" ")}\nendloop\nendfacet`).join("\n")}\nendsolid a\n`;
const DAE = `<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><translate>1 2 3</translate><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>`;
const GLTF = JSON.stringify({
	asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, translation: [1, 2, 3] }],
	meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
	accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3" }],
	bufferViews: [{ buffer: 0, byteLength: 36 }],
	buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer).toString("base64")}` }],
});
const bytesOf = (text) => {
	const bytes = new ByteArray();
	bytes.writeUTFBytes(text);
	return bytes;
};
const FILES = {
	OBJ: { text: OBJ, read: (name, text) => new ObjModel(name, text) },
	COLLADA: { text: DAE, read: (name, text) => new engine.ColladaModel(name, text) },
	STL: { text: STL, read: (name, text) => engine.StlModel.fromBytes(name, bytesOf(text)) },
	glTF: { text: GLTF, read: (name, text) => engine.GltfModel.fromBytes(name, bytesOf(text)) },
};

/** A random call. */
export function randomCall(random) {
	const between = (low, high) => low + (high - low) * random();
	const integer = (count) => Math.floor(random() * count);
	const pick = (from) => from[integer(from.length)];
	const place = () => (random() < 0.3 ? pick([-1, 0, 0.5, 1]) : between(-2.5, 2.5));
	const breed = () => pick([...BREEDS, Collision.ANY_BREED]);
	const value = {
		shape: () => pick(random() < 0.2 ? Object.keys(THIN) : SHAPES), breed: () => pick(BREEDS), size: () => pick([1, 1, 0.5, between(0.1, 2.5)]),
		heading: () => pick([0, 45, 90, between(0, 360)]), pitch: () => pick([0, 30, 90]), roll: () => pick([0, 180, 77]),
		sweeps: () => random() < 0.3, hierarchical: () => random() < 0.5, traversalDepth: () => integer(7),
		collideAs: () => pick([Agent.TIGHTEST, Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE]),
	};
	const calls = {
		add: () => [place(), place(), place() / 2, value.size()],
		tiles: () => [integer(3) - 2, integer(3) - 2, integer(3) - 1, pick([1, 1, 0.1, 3]), integer(512)],
		walk: () => [integer(99), integer(5) - 2, integer(5) - 2, integer(3) - 1, integer(5) / 4 - 0.5, integer(5) / 4 - 0.5, pick([0, 0, -0.25, -0.1, 0.25]), random() < 0.6],
		leave: () => [integer(99)],
		move: () => [integer(99), place(), place(), place() / 2, random() < 0.1],
		trait: () => {
			const name = pick(TRAITS);
			return [integer(99), name, value[name]()];
		},
		model: () => [pick(SHAPES.slice(3)), 1 + integer(1e6), random() < 0.5, true, pick([engine.BoundingStructure.BOX, engine.BoundingStructure.SPHERE, engine.BoundingStructure.CAPSULE])],
		forget: () => [pick(SHAPES.slice(3))],
		system: () => [integer(4), random() < 0.4, 1 + integer(8)],
		handler: () => [pick(KINDS), breed(), breed(), pick(["", "", "", "throw", "leave", "move", "system", "model", "update"]), random() < 0.5],
		unhandle: () => [integer(99)],
		frame: () => [],
		check: () => [],
		ask: () => [integer(99), integer(99), between(0, 4), between(0, 360)],
		go: () => [integer(99), place(), place(), place() / 2, random() < 0.4],
		rewind: () => [1 + integer(5), between(0, 0.3)],
		file: () => [pick(Object.keys(FILES)), 1 + integer(1e9)],
		wrong: () => [integer(99)],
	};
	const often = ["add", "add", "add", "move", "move", "move", "trait", "trait", "trait", "frame", "frame", "check", "ask", "ask", "go", "walk", "walk", "file"];
	const name = random() < 0.6 ? pick(often) : pick(Object.keys(calls));
	return [name, ...calls[name]()];
}
