/** Tests of what the npm package makes of arguments that are not what they have to be, and of what tools see of its objects. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import util from "node:util";

const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = path.join(root, "bin/module");
const manifest = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
const engine = await import(pathToFileURL(path.join(folder, manifest.exports["."].default)));
const {
	Agent, AgentFilter, AgentPlaces, AgentPredicate, AgentQueries, AgentRays, AgentMotions, BinCollider, Box, BuiltInModel, Collision, CombinationCollider, ErrorEvent, Event, FrameTimes, GreatLand, HierarchicalCollider, HierarchiesLibrary, IllegalOperationError, Matrix3D, Model, ModelLoader, SeenAgents, Sphere, WalkOptions,
	Terrain, TightestFitCollider, Vector3D, sphereSphere,
} = engine;

/** What is no number, and how errors name it. */
const NO_NUMBERS = [
	["3", '"3"'], ["", '""'], [[5], "[5]"], [[], "[]"], [null, "null"], [true, "true"], [false, "false"], [undefined, "undefined"], [new Date(0), "an object of class Date"],
	[{ valueOf: () => 3 }, "a plain object"], [3n, "3n"], [Symbol("x"), "Symbol(x)"], [() => 3, "the function without a name"], [new Number(3), "an object of class Number"],
];
const NOT_FINITE = [NaN, Infinity, -Infinity];
const NO_BOOLEANS = [["no", '"no"'], ["false", '"false"'], [0, "0"], [1, "1"], [null, "null"], [undefined, "undefined"], [{}, "a plain object"]];

/** What somebody could set of an agent, to see that nothing has changed. */
const stateOf = (agent) => JSON.stringify(agent) + agent.transform.rawData.join();

function makeLand() {
	const land = new GreatLand();
	for (const model of [BuiltInModel.sphere(), BuiltInModel.cube()]) land.addModel(model);
	return land;
}

/** Asserts that something throws an error that names all of these. */
function refused(action, name, ...parts) {
	assert.throws(action, (error) => {
		assert.ok(error instanceof Error && ["ArgumentError", "RangeError"].includes(error.name), String(error));
		for (const part of [name, ...parts]) assert.ok(error.message.includes(part), `${error.message} - says nothing of ${part}`);
		return true;
	});
}

test("every number of an agent is a finite number", () => {
	const agent = new Agent("cube", "bears");
	agent.moveTo(1, 2, 3);
	agent.heading = 20;
	const before = stateOf(agent);
	const traits = ["x", "y", "z", "heading", "pitch", "roll", "size", "color"];
	for (const trait of traits) {
		for (const [value, shown] of NO_NUMBERS) refused(() => (agent[trait] = value), trait, `agent ${agent.id}`, '"bears"', `not ${shown}`);
		for (const value of NOT_FINITE) refused(() => (agent[trait] = value), trait, `agent ${agent.id}`, String(value));
	}
	for (const method of ["moveTo", "jumpTo"]) {
		for (const [value, shown] of NO_NUMBERS) {
			refused(() => agent[method](value, 0, 0), "x must", shown);
			refused(() => agent[method](0, value, 0), "y must", shown);
			refused(() => agent[method](0, 0, value), "z must", shown);
		}
		refused(() => agent[method](1, 2), "z must", "undefined");
	}
	assert.equal(stateOf(agent), before);
	agent.x = 5;
	agent.color = 1e9;
	assert.deepEqual([agent.x, agent.color], [5, 1e9]);
});

test("questions in parts take and refuse what all questions do", () => {
	const land = makeLand();
	const agents = [new Agent("cube"), new Agent("sphere")];
	const all = new AgentQueries(new TightestFitCollider(land));
	const seen = new SeenAgents(new TightestFitCollider(land));
	for (const each of [all, seen]) each.update(agents);
	const parts = [new AgentPlaces(seen), new AgentRays(seen), new AgentMotions(seen)];
	const ask = (queries, name, values) => {
		try {
			return JSON.stringify(queries[name](...values));
		} catch (error) {
			return `${error.constructor.name}: ${error.message.replace(/Agent(Queries|Places|Rays|Motions)/, "")}`;
		}
	};
	const cases = { inCone: [agents[0], 9, 90], near: [agents[0], 9], nearestFew: [agents[0], 3, 9], nearPoint: [new Vector3D(), 9], moveUntilTouch: [agents[0], 0, 0, 0],
		cast: [new Vector3D(0, 0, 9), new Vector3D(0, 0, -1), 20], canSee: agents, castAgent: [agents[0], 0, 0, 1], slide: [agents[0], 0, 0, 0], walk: [agents[0], 0, 0] };
	let answered = 0;
	for (const [name, values] of Object.entries(cases)) {
		const part = parts.find((each) => each[name]);
		for (let i = 0; i < values.length; i++) {
			for (const value of [values[i], Infinity, -1, NaN, null, "a"]) {
				const given = values.with(i, value);
				const expected = ask(all, name, given);
				answered += expected?.includes("Error") ? 0 : 1;
				assert.equal(ask(part, name, given), expected, `${name}, argument ${i}: ${value}`);
			}
		}
	}
	assert.ok(answered > 30, `${answered} answers`);
});

test("levels and depths are whole numbers", () => {
	const agent = new Agent("cube");
	const collider = new HierarchicalCollider(new GreatLand());
	const library = new HierarchiesLibrary();
	for (const [object, name] of [[agent, "traversalDepth"], [collider, "maxDepth"], [library, "maxDepth"], [library, "minVerticesToSplit"]]) {
		const before = object[name];
		for (const [value, shown] of NO_NUMBERS) refused(() => (object[name] = value), `${name} must be a whole number`, shown);
		for (const value of [...NOT_FINITE, 2.5, 2 ** 31]) refused(() => (object[name] = value), `${name} must be a whole number`, String(value));
		assert.equal(object[name], before);
		object[name] = 7;
		assert.equal(object[name], 7);
	}
	refused(() => (agent.traversalDepth = -1), "traversalDepth", "-1");
	refused(() => (collider.maxDepth = 2.5), "HierarchicalCollider.maxDepth must be a whole number", "2.5");
	refused(() => (agent.traversalDepth = 2 ** 31), "traversalDepth must be a whole number in the range of 32 bits", "2147483648");
	// in a constructor the object is not whole yet
	for (const capacity of [1.5, NaN]) refused(() => new FrameTimes(capacity), "new FrameTimes: capacity must be a whole number", String(capacity));
});

test("what is true or false is a Boolean", () => {
	const land = new GreatLand();
	const cases = [
		[new Agent("cube"), ["hierarchical", "sweeps"]],
		[new HierarchicalCollider(land), ["exact"]],
		[land, ["loadTightestFit", "loadHierarchies", "loadAllBoundingStructures", "prepareExact"]],
		[land.hierarchies, ["splitByMean"]],
		[new ModelLoader(land), ["usesTransforms"]],
	];
	for (const [object, names] of cases) {
		for (const name of names) {
			const before = object[name];
			for (const [value, shown] of NO_BOOLEANS) refused(() => (object[name] = value), `${name} must be true or false`, `not ${shown}`);
			assert.equal(object[name], before);
			object[name] = !before;
			assert.equal(object[name], !before);
		}
	}
});

test("names are strings", () => {
	const agent = new Agent("cube", "bears");
	for (const value of [1, true, {}, ["cube"], Symbol("cube"), new String("cube")]) {
		refused(() => new Agent(value), "shape must be a string");
		refused(() => new Agent("cube", value), "breed must be a string");
		for (const name of ["shape", "breed", "collideAs"]) refused(() => (agent[name] = value), name, `agent ${agent.id}`);
	}
	for (const name of ["shape", "breed"]) {
		for (const value of [null, undefined]) refused(() => (agent[name] = value), `${name} must be a string, not ${value}`);
		refused(() => (agent[name] = ""), `${name} must be a name`);
	}
	for (const name of [null, undefined]) {
		refused(() => new engine.ObjModel(name, "v 0 0 0"), `new ObjModel: name must be a string, not ${name}`);
		refused(() => new engine.ObjModel("bear", name), `new ObjModel: text must be a string, not ${name}`);
		refused(() => engine.GltfModel.fromBytes(name, new ArrayBuffer(4)), `GltfModel.fromBytes: name must be a string, not ${name}`);
		refused(() => engine.StlModel.fromBytes("bear", name), "StlModel.fromBytes: bytes must be an ArrayBuffer, ", `not ${name}`);
		refused(() => new ModelLoader(new GreatLand()).load("bear", name), `ModelLoader.load: url must be a string, not ${name}`);
	}
	assert.deepEqual([agent.shape, agent.breed, agent.collideAs], ["cube", "bears", "tightest"]);
});

test("the ground of questions may be taken away, with null", () => {
	const collider = new BinCollider(new GreatLand());
	for (const asked of [new AgentQueries(collider), new SeenAgents(collider), new Collision(collider)]) {
		asked.terrain = new Terrain(2, 2);
		asked.terrain = null;
		assert.equal(asked.terrain, null);
		refused(() => (asked.terrain = {}), "terrain must be a Terrain");
	}
});

test("a mesh or a material without a name has null in place of one", () => {
	const model = new Model("square", [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0], [0, 1, 2, 1, 2, 3]);
	model.setMeshes([0, 1], ["roof", null]);
	model.setMaterials([1, 0], [null, "brick"]);
	assert.deepEqual([model.meshNames, model.materialNames], [["roof", null], [null, "brick"]]);
	refused(() => model.setMeshes([0, 1], ["roof", undefined]), "names[1] must be a string, not undefined");
});

test("a copy of an agent's fields is no agent, in every collider", () => {
	const land = makeLand();
	for (const Collider of [BinCollider, TightestFitCollider, HierarchicalCollider, CombinationCollider]) {
		const hero = new Agent("cube", "heroes");
		for (const copy of [{ ...hero }, structuredClone({ ...hero }), JSON.parse(JSON.stringify(hero))]) {
			for (const updated of [new Collision(new Collider(land)), new AgentQueries(new Collider(land))]) refused(() => updated.update([hero, copy]), "agents[1] must be an Agent, not a plain object");
		}
	}
	const hero = Object.assign(new Agent("cube", "heroes"), { size: 2, heading: 30, x: 4, sweeps: true });
	const { x, y, z, size, heading, sweeps } = hero;
	const twin = Object.assign(new Agent(hero.shape, hero.breed), { x, y, z, size, heading, sweeps });
	const { id, ...traits } = hero.toJSON();
	assert.deepEqual(twin.toJSON(), { id: id + 1, ...traits });
	twin.moveTo(9, 9, 9);
	assert.equal(hero.x, 4);
});

test("lists are arrays of agents, and a frame that is refused changes nothing", () => {
	const collision = new Collision(new TightestFitCollider(makeLand()));
	const [a, b] = [new Agent("cube", "bears"), new Agent("sphere", "balls")];
	let calls = 0;
	collision.onCollision("bears", "balls", () => calls++);
	collision.update([a, b]);
	const pairs = collision.statistics.collisions;
	const like = { id: 7, breed: "bears", shape: "cube", x: 0, y: 0, z: 0, size: 1 };
	for (const list of [{}, new Set([a, b]), new Map(), "ab", 3, { length: 2, 0: a, 1: b }, new Uint8Array(2)]) refused(() => collision.update(list), "Collision.update: agents must be an array");
	for (const list of [null, undefined]) refused(() => collision.update(list), `Collision.update: agents must be an array, not ${list}`);
	for (const item of [like, null, undefined, "a", 1, [], () => a, Object.create(null)]) {
		for (const list of [[item], [a, item, b], [a, b, item]]) refused(() => collision.update(list), `agents[${list.indexOf(item)}]`);
		refused(() => collision.collisionSystem.findCollisions([a, item]), "agents[1]");
		if (item != null) refused(() => collision.collisionSystem.areColliding(a, item), "b must be an Agent");
	}
	// eslint-disable-next-line no-sparse-arrays -- a hole, as a second comma or a list that is too long leaves it
	refused(() => collision.update([a, , b]), "agents[1] must be an Agent, not undefined");
	refused(() => collision.update([a, a]), "listed twice", `agent ${a.id}`);
	refused(() => collision.update([b, a, Object.assign(new Agent("cube"), a)]), "is listed twice: agents[1] and agents[2], a copy");
	refused(() => collision.collisionSystem.findCollisions([a, b], {}), "out must be an array");
	assert.equal(calls, 1);
	collision.update([a, b]);
	assert.deepEqual([calls, collision.statistics.collisions, pairs], [2, 1, 1]);
});

test("handlers and listeners are functions", () => {
	const collision = new Collision(new BinCollider());
	for (const method of ["onCollision", "onCollisionStart", "onCollisionEnd", "removeHandler"]) {
		for (const handler of ["f", {}, 1, [], { call() {} }]) refused(() => collision[method]("a", "b", handler), `Collision.${method}: handler must be a function`);
		for (const handler of [null, undefined]) refused(() => collision[method]("a", "b", handler), "handler must be a function");
		refused(() => collision[method](1, "b", () => 0), "breed must be a string, not 1");
		refused(() => collision[method]("a", {}, () => 0), "otherBreed must be a string, not a plain object");
	}
	collision.update([new Agent("x", "a"), new Agent("x", "b")]);
	assert.equal(collision.statistics.handlerCalls, 0);
	const loader = new ModelLoader(new GreatLand());
	for (const listener of [null, undefined, {}, "f", { handleEvent() {} }]) refused(() => loader.addEventListener("complete", listener), "listener must be a function");
	refused(() => loader.addEventListener(3, () => 0), "type must be");
	refused(() => loader.addEventListener(undefined, () => 0), "type must be"); // the platform has an Event without COMPLETE
	refused(() => loader.addEventListener("complete", () => 0, "yes"), "useCapture must be");
	refused(() => loader.dispatchEvent({ type: "complete" }), "event must be an Event");
	assert.equal(loader.hasEventListener("complete"), false);
});

test("systems, models, files and settings are of their classes", () => {
	const land = makeLand();
	for (const system of [{}, { findCollisions() {} }, "bins", BinCollider]) refused(() => new Collision(system), "collisionSystem must be a CollisionSystem");
	refused(() => new Collision(), "collisionSystem");
	for (const value of [{}, "land", new HierarchiesLibrary(), GreatLand]) for (const System of [BinCollider, TightestFitCollider, HierarchicalCollider]) refused(() => new System(value), "greatLand must be a GreatLand");
	refused(() => new TightestFitCollider(), "greatLand");
	refused(() => land.addModel({ name: "x", vertices: [], triangles: null }), "model must be a Model");
	refused(() => (land.fitStore = {}), "fitStore must be a FitStore");
	refused(() => (land.boundingStructures.fitters = [{}]), "fitters[0]");
	for (const name of ["orientedBoxDegIncrement"]) {
		const before = land[name];
		for (const [value, shown] of NO_NUMBERS) refused(() => (land[name] = value), name, shown);
		for (const value of NOT_FINITE) assert.throws(() => (land[name] = value), String(value));
		assert.equal(land[name], before);
	}
	const loader = new ModelLoader(land);
	for (const bytes of [new Blob(["o x"]), "text", [1, 2], {}, new URL("file:///x")]) refused(() => loader.loadBytes("x", bytes), "bytes must be an ArrayBuffer", "not");
	refused(() => loader.load("x", new URL("http://localhost/x.obj")), "url must be a string", "URL");
	refused(() => loader.load({}, "x.obj"), "name must be a string");
	refused(() => loader.loadText("x", {}), "text must be a string");
	assert.equal(loader.pendingCount, 0);
	const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0];
	for (const list of [new Set(corners), "0 0 0", { length: 9 }, new DataView(new ArrayBuffer(8))]) refused(() => new Model("x", list), "vertices must be an array of numbers");
	refused(() => new Model("x", [...corners.slice(1), "0"]), "vertices[8] must be a number", '"0"');
	refused(() => new Model("x", corners, [0, 1, 2.5]), "triangles[2] must be an integer", "2.5");
	refused(() => new Model("x", corners, new Float64Array([0, 1, 2.5])), "triangles[2] must be an integer", "2.5");
	refused(() => new Model("x", new BigInt64Array(9)), "vertices[0] must be a number", "0");
	assert.throws(() => new Model("x", new Float32Array([...corners.slice(1), NaN])), /finite number, not NaN/);
	const filter = new AgentFilter();
	refused(() => (filter.breeds = "bears"), "breeds must be an array of strings");
	refused(() => (filter.breeds = ["a", 1]), "breeds[1]");
	refused(() => (filter.accepts = {}), "accepts must be a function");
	filter.breeds = null;
});

test("the data of a model comes from the engine alone", () => {
	const model = (data) => new Model("corner", [0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2], Model.AS_GIVEN, data);
	for (const none of [undefined, null]) assert.equal(model(none).name, "corner");
	for (const other of ["y", 7, {}, [0]]) assert.throws(() => model(other), /^ArgumentError: new Model: argument 5 must be left out, not /);
});

test("a fitter has to find a structure", () => {
	const { BoundingStructuresLibrary, Fitter } = engine;
	class AnyFitter extends Fitter {
		constructor(found) {
			super();
			this.found = found;
		}

		findStructure() {
			return this.found;
		}
	}
	const library = new BoundingStructuresLibrary();
	library.add("any", [0, 0, 0, 1, 1, 1]);
	const before = library.tightestFit("any");
	for (const [found, shown] of [[null, "null"], [undefined, "undefined"], [5, "5"], ["sphere", "sphere"], [{ center: { x: 0, y: 0, z: 0 }, radius: 9, kind: 0 }, "[object Object]"]]) {
		library.fitters = [new AnyFitter(found)];
		refused(() => library.add("any", [0, 0, 0, 2, 2, 2]), `shape "any": the library needs fitters of spheres, capsules or boxes, but `, `found ${shown}`);
	}
	assert.equal(library.tightestFit("any"), before);
});

test("structures and what Flash has take numbers and their own kind", () => {
	for (const [value] of NO_NUMBERS.filter(([each]) => each !== undefined)) {
		refused(() => new Sphere(new Vector3D(), value), "radius must be a number");
		refused(() => new Vector3D(value), "x must be a number");
		refused(() => new Matrix3D().appendTranslation(0, value, 0), "y must be a number");
	}
	refused(() => new Sphere({ x: 0, y: 0 }, 1), "center must be a Vector3D, or anything with x, y and z, not a plain object");
	refused(() => new Sphere({ x: 0, y: 0, z: "1" }, 1), 'center.z must be a number, not "1"');
	const broken = new Vector3D();
	broken.y = "2";
	refused(() => new Sphere(broken, 1), "center.y", '"2"');
	refused(() => sphereSphere(new Sphere(new Vector3D(), 1), new Agent("cube")), "sphereSphere: b must be a Sphere");
	refused(() => new Box(new Vector3D(), 1, 2, 3), "axisX must be a Vector3D");
	assert.equal(sphereSphere(new Sphere(new Vector3D(), 1), new Sphere(new Vector3D(1), 1)), true);
});

test("a point may be anything with x, y and z, which are read at the call", () => {
	class Place {
		#numbers;
		constructor(...numbers) {
			this.#numbers = numbers;
		}
		get x() {
			return this.#numbers[0];
		}
		get y() {
			return this.#numbers[1];
		}
		get z() {
			return this.#numbers[2];
		}
	}
	const land = makeLand();
	const cube = new Agent("cube");
	const queries = new engine.AgentQueries(new TightestFitCollider(land));
	queries.update([cube]);
	for (const at of [(x, y, z) => new Vector3D(x, y, z), (x, y, z) => ({ x, y, z }), (x, y, z) => new Place(x, y, z)]) {
		assert.equal(queries.nearestToPoint(at(2, 0, 0.5)), cube);
		assert.equal(queries.nearestToPoint(at(2, 0, 0.5), 1), null);
		assert.ok(Math.abs(queries.cast(at(-3, 0, 0.5), at(2, 0, 0)).distance - 2.5) < 1e-9);
		assert.ok(Math.abs(queries.distanceToPoint(cube, at(2, 0, 0.5)) - 1.5) < 1e-9);
		assert.equal(queries.castShape(new Sphere(at(-3, 0, 0.5), 0.5), 4, 0, 0).agent, cube);
		assert.ok(new Box(at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), 1, 1, 1).contains(at(0.5, 1, 0)));
	}
	const center = { x: 1, y: 2, z: 3 };
	const sphere = new Sphere(center, 1);
	center.x = 9;
	assert.equal(sphere.center.x, 1, "nothing of it is kept");
	assert.equal(sphere.translate({ x: 1, y: 0, z: 0 }).center.x, 2);
	const [onCube, other] = [{ x: 0, y: 0, z: 0, name: "mine" }, { x: 0, y: 0, z: 0 }];
	assert.ok(Math.abs(queries.distanceToPoint(cube, { x: 2, y: 0.25, z: 0.5 }, onCube) - 1.5) < 1e-9);
	assert.ok(Math.abs(onCube.x - 0.5) < 1e-9 && onCube.y === 0.25 && onCube.name === "mine");
	const hit = new engine.RayHit();
	for (const name of ["point", "normal", "weights"]) hit[name] = { x: 9, y: 9, z: 9 };
	assert.equal(queries.cast({ x: -3, y: 0, z: 0.5 }, { x: 1, y: 0, z: 0 }, 9, null, hit), hit);
	assert.ok(Math.hypot(hit.point.x + 0.5, hit.point.y, hit.point.z - 0.5, hit.normal.x + 1, hit.weights.x) < 1e-9);
	const far = new Agent("cube");
	far.x = 3;
	const apart = queries.distance(cube, far, onCube, other);
	assert.ok(Math.abs(apart - 2) < 1e-9 && Math.abs(other.x - onCube.x - apart) < 1e-9);
	const terrain = new engine.Terrain(2, 2);
	terrain.setHeights(0, 0, 2, 2, [0, 0, 1, 1]);
	for (const isBlocky of [false, true]) {
		terrain.isBlocky = isBlocky;
		assert.equal(terrain.normalAt(0.5, 0.25, other), other);
		assert.ok(Math.hypot(other.x, other.y + (isBlocky ? 0 : Math.SQRT1_2), other.z - (isBlocky ? 1 : Math.SQRT1_2)) < 1e-15);
	}
	refused(() => queries.cast([1, 2, 3], { x: 1, y: 0, z: 0 }), "AgentQueries.cast: origin must be a Vector3D, or anything with x, y and z");
	assert.throws(() => queries.nearPoint({ x: 1, y: NaN, z: 0 }, 1), RangeError);
});

test("a literal serves as options of a walk", () => {
	const queries = new engine.AgentQueries(new TightestFitCollider(makeLand()));
	const floor = new Agent("cube");
	floor.size = 9;
	floor.z = -9;
	queries.update([floor]);
	const walker = new Agent("cube");
	assert.equal(queries.walk(walker, 1, 0, { stepHeight: 0.5, snap: 0 }).on, floor);
	assert.equal(queries.walk(walker, 1, 0, {}).stands, true);
	assert.equal(queries.walk(walker, 0.1, 0, { stepHeight: undefined, slopeDegrees: undefined, snap: undefined, filter: undefined }).on, floor);
	assert.ok(queries.walk(walker, 1, 0).part > 0.999);
	walker.z = 5;
	assert.equal(queries.walk(walker, 0, 0, { fall: Infinity }).on, floor);
	const at = walker.x;
	refused(() => queries.walk(walker, 1, 0, 3), "AgentQueries.walk: options must be WalkOptions, or a literal such as { stepHeight: 0.3 }, not 3");
	for (const name of ["stepheight", "slope", "gravity"]) refused(() => queries.walk(walker, 1, 0, { [name]: 3 }), `AgentQueries.walk: options.${name} is no option; there are `, "stepHeight", "slopeDegrees", "snap", "fall", "carried", "filter");
	assert.throws(() => queries.walk(walker, 1, 0, { slopeDegrees: 90 }), RangeError);
	assert.throws(() => queries.walk(walker, 1, 0, { snap: "1" }), /snap must be a number/);
	assert.equal(walker.x, at);
});

test("while a game is developed, an error says which option is the nearest, if one is", async () => {
	const { Agent, AgentQueries, BinCollider } = await import(pathToFileURL(path.join(folder, manifest.exports["."].node)));
	const queries = new AgentQueries(new BinCollider());
	const walker = new Agent("cube");
	queries.update([]);
	for (const [name, nearest] of [["stepheight", "stepHeight"], ["stepHeigth", "stepHeight"], ["slope", "slopeDegrees"], ["carry", "carried"], ["filters", "filter"], ["steps", "stepHeight"]]) {
		refused(() => queries.walk(walker, 1, 0, { [name]: 0.5 }), `AgentQueries.walk: options.${name} is no option; the nearest is ${nearest}; there are `);
	}
	for (const name of ["gravity", "jump", "speed"]) refused(() => queries.walk(walker, 1, 0, { [name]: 0.5 }), `options.${name} is no option; there are `);
	refused(() => queries.near(walker, 1, { breed: ["a"] }), "AgentQueries.near: filter.breed is no option; the nearest is breeds; there are ");
});

test("while a game is developed, an error says where a value of another kind belongs", async () => {
	const { Agent, AgentMotions, AgentQueries, BinCollider, BuiltInModel, Collision, CollisionRecorder, Contact, Footing, GreatLand, Model, RayHit, ShapeHit, Sphere } = await import(pathToFileURL(path.join(folder, manifest.exports["."].node)));
	const queries = new AgentQueries(new BinCollider());
	const walker = new Agent("cube");
	queries.update([walker]);
	const isLarge = (agent) => agent.size > 1;
	refused(() => queries.near(walker, 5, isLarge), "AgentQueries.near: filter must be an AgentFilter", "not the function isLarge. A function goes into one: { accepts: (agent) => agent.size > 1 }");
	refused(() => queries.walk(walker, 0.1, 0, new Footing()), "is no option; a Footing is the argument after the options: walk(agent, dx, dy, null, footing); there are ");
	for (const kind of ["isObject3D", "isBufferGeometry"]) {
		refused(() => new GreatLand().addModel({ [kind]: true }), "model must be a Model, not a plain object. modelFromObject() and levelFromObject() of starlogo-collision/three make a model of it");
	}
	refused(() => queries.nearest(walker, { breeds: ["coins"] }), "AgentQueries.nearest: radius must be a number, not a plain object. A filter is an argument after it. Infinity is no limit");
	refused(() => queries.cast([0, 0, 1], { x: 1, y: 0, z: 0 }), "AgentQueries.cast: origin must be a Vector3D, or anything with x, y and z, not [0, 0, 1]. A point is an object: { x: 1, y: 2, z: 3 }");
	refused(() => new CollisionRecorder(new Collision(new BinCollider())), "new CollisionRecorder: collisionSystem must be a CollisionSystem, ", ". Its collisionSystem is one");
	refused(() => new AgentMotions(new Collision(new BinCollider())), "new AgentMotions: seen must be a SeenAgents, not an object of class Collision: new SeenAgents(collision) makes one of it");
	refused(() => queries.walk(walker, 0.1, 0, { exceptBreeds: ["coins"] }), "options.exceptBreeds is no option; a filter is one of them: { filter: { exceptBreeds: ... } }; there are ");
	refused(() => queries.walk(walker, 0.1, 0, 0), "AgentQueries.walk: options must be WalkOptions", "not 0. A walk has no dz: its options come after dx and dy");
	refused(() => new GreatLand().addModel(Promise.resolve()), "GreatLand.addModel: model must be a Model, not an object of class Promise: await it first");
	refused(() => queries.near(walker, 5, { except: walker }), "AgentQueries.near: filter.except must be an array of Agents, not an object of class Agent: put it into one, [agent]");
	const ray = [{ x: 0, y: 0, z: 9 }, { x: 0, y: 0, z: -1 }, 20];
	const ball = new Sphere({ x: 0, y: 0, z: 9 }, 1);
	for (const [call, kind, ask] of [["cast", "a RayHit", () => queries.cast(...ray, new RayHit())], ["castShape", "a ShapeHit", () => queries.castShape(ball, 1, 0, 0, new ShapeHit())],
		["moveUntilTouch", "a Contact", () => queries.moveUntilTouch(walker, 0, 0, 1, new Contact())], ["slide", "a Contact", () => queries.slide(walker, 0, 0, 1, new Contact())]]) {
		refused(ask, `AgentQueries.${call}: filter.`, `is no option; ${kind} is the argument after the filter: ${call}(..., null, ${kind === "a Contact" ? "contact" : "hit"}); there are `);
	}
	for (const ask of [() => queries.castAll(...ray, []), () => queries.near(walker, 5, [])]) refused(ask, "filter must be an AgentFilter", "not []. A list that is filled is the argument after the filter");
	refused(() => queries.near(walker, 5, ["coins"]), 'not ["coins"]. Breeds go into one: { breeds: ["sheep"] }');
	refused(() => new Collision(new BinCollider()).update(walker, new Agent("cube")), "Collision.update: agents must be an array, not an object of class Agent: all agents are in one, [level, hero]");
	for (const [call, ask] of [["moveUntilTouch", () => queries.moveUntilTouch(walker, 0.1, 0, { breeds: ["coins"] })], ["slide", () => queries.slide(walker, 0.1, 0, { breeds: ["coins"] })]]) {
		assert.throws(ask, new RegExp(`${call}: dz must be a number, not a plain object\\. A filter is an argument after it$`));
	}
	refused(() => queries.near({ x: 1, y: 2, z: 3 }, 5), "AgentQueries.near: agent must be an Agent, not a plain object. For a point there is nearPoint()");
	refused(() => queries.nearest({ x: 1, y: 2, z: 3 }), ". For a point there is nearestToPoint()");
	refused(() => new Sphere(1, { x: 0, y: 0, z: 0 }), "not 1. Points come before numbers");
	for (const [call, given] of [["capsule", '0.3, 1.8, "hero"'], ["box", '4, 0.5, 3, "hero"']]) refused(() => BuiltInModel[call]("hero", 0.3, 1.8), `must be a number, not "hero". The name comes last: ${call}(${given})`);
	assert.throws(() => BuiltInModel.capsule("0.3", 1.8), /must be a number, not "0\.3"$/);
	refused(() => walker.setQuaternion({ x: 0, y: 0, z: 0, w: 1, isQuaternion: true }), "quaternion one by one: quaternion.x, quaternion.y, quaternion.z, quaternion.w");
	for (const breeds of ["heroes", ["heroes"]]) refused(() => queries.nearest(walker, breeds), 'Breeds are in a filter after it: nearest(..., Infinity, { breeds: ["heroes"] })');
	assert.throws(() => queries.nearest(walker, "5"), /radius must be a number, not "5"$/);
	const collision = new Collision(new BinCollider());
	for (const method of ["onCollision", "onCollisionStart", "onCollisionEnd", "removeHandler"]) {
		refused(() => collision[method](() => 0, "heroes", "coins"), "breed must be a string, not the function without a name. The handler comes last: ");
		refused(() => collision[method](walker, "coins", () => 0), "not an object of class Agent. A handler is for all agents of a breed: hero.breed");
		refused(() => collision[method]("heroes", ["coins", "gems"], () => 0), 'otherBreed must be a string, not ["coins", "gems"]. Each pair of breeds has a call of its own');
	}
	for (const bytes of [{ 0: 1 }, [1, 2], "abc"]) refused(() => collision.restore(bytes, []), 'JSON does not keep bytes', 'See docs/snapshots.md in the package, "A saved game"');
	refused(() => collision.restore(Promise.resolve(), []), "await it first");
	refused(() => queries.cast(ray[0], { x: 1, y: 0 }), "direction must be a Vector3D, or anything with x, y and z, not a plain object. Its z is undefined");
	refused(() => queries.cast({ z: 1 }, ray[1]), "origin must be", "Its x and y are undefined");
	assert.throws(() => queries.cast(ray[0], {}), /not a plain object$/);
	for (const agents of [[JSON.parse(JSON.stringify(walker))], [{ ...walker }]]) refused(() => collision.update(agents), "Collision.update: agents[0] must be an Agent, not a plain object. A copy of an agent's fields is no agent");
	refused(() => queries.castAll(...ray, null, { allSurfaces: true }), "AgentQueries.castAll: out must be an array, not a plain object. Options are the argument after it: castAll(..., null, { allSurfaces: true })");
	for (const [list, spread] of [[new Set([walker]), "[...set]"], [new Map(), "[...map.values()]"], [[walker].values(), "[...agents]"]]) {
		refused(() => collision.update(list), "Collision.update: agents must be an array, not a", `. ${spread} is one`);
	}
	for (const args of [["cube", "*"], [], [""]]) assert.throws(() => new Agent(...args), /^ArgumentError: new Agent: /);
	for (const list of ["vertices", "triangles"]) {
		const lists = { vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2], [list]: [[0, 1, 2]] };
		refused(() => new Model("flat", lists.vertices, lists.triangles), `new Model: ${list}[0] must be`, "not [0, 1, 2]. All numbers are in one flat list: list.flat()");
	}
	const small = new engine.AgentQueries(new engine.BinCollider());
	assert.throws(() => small.near(new engine.Agent("cube"), 5, isLarge), /not the function isLarge$/);
});

test("while a game is developed, an error about a value in a literal names the call, and so does one about a direction", async () => {
	const { Agent, AgentFilter, AgentQueries, AgentRays, BinCollider, Collision, SeenAgents, WalkOptions } = await import(pathToFileURL(path.join(folder, manifest.exports["."].node)));
	const collision = new Collision(new BinCollider());
	const queries = new AgentQueries(collision);
	const walker = new Agent("cube");
	queries.update([walker]);
	const filter = { breeds: "coins" };
	const meant = 'breeds must be an array of strings, not "coins"; is ["coins"] meant?';
	refused(() => queries.near(walker, 5, filter), `AgentQueries.near: filter.${meant}`);
	refused(() => queries.walk(walker, 1, 0, { filter }), `AgentQueries.walk: options.filter.${meant}`);
	refused(() => (collision.filter = filter), `Collision.filter.${meant}`);
	refused(() => new WalkOptions({ filter }), `new WalkOptions: settings.filter.${meant}`);
	refused(() => (new AgentFilter().breeds = "coins"), `AgentFilter.${meant}`);
	refused(() => queries.walk(walker, 1, 0, { stepHeight: -1 }), "AgentQueries.walk: options.stepHeight must be between 0 and 1000000000, not -1");
	refused(() => queries.near(walker, 5, { except: ["coins"] }), 'AgentQueries.near: filter.except[0] must be an Agent, not "coins"');
	refused(() => collision.snapshot({ traits: true }), "Collision.snapshot: options.traits is no option; the nearest is withTraits; there are withTraits, withGround");
	refused(() => collision.update("coins"), 'Collision.update: agents must be an array, not "coins"');
	// an object of three.js has an id, too
	for (const each of [undefined, "coin", { id: 3, isObject3D: true }]) {
		refused(() => collision.update([walker, each]), "Collision.update: agents[1] must be an Agent, not ");
		refused(() => queries.update([walker, each]), "AgentQueries.update: agents[1] must be an Agent, not ");
	}
	refused(() => collision.update([{ id: 3, isObject3D: true }]), "An object of three.js has an agent: new ThreeAgentBinding(agent, object)");
	refused(() => collision.restore(collision.snapshot(), [{ id: 3 }]), "Collision.restore: agents[0] must be an Agent, not a plain object", 'See docs/snapshots.md in the package, "A saved game"');
	for (const rays of [queries, new AgentRays(new SeenAgents(collision))]) {
		for (const call of ["cast", "castAll"]) {
			refused(() => rays[call](new engine.Vector3D(), { x: 0, y: 0, z: 0 }), `${rays.constructor.name}.${call}: direction must not be 0`);
			refused(() => rays[call](new engine.Vector3D(), { x: 1, y: 0, z: 0 }, NaN), `${rays.constructor.name}.${call}: maxDistance must be 0 or more, not NaN`);
			refused(() => rays[call](new engine.Vector3D(), { x: 0, y: Infinity, z: 0 }), `${rays.constructor.name}.${call}: direction must be finite, not (0, Infinity, 0)`);
			refused(() => rays[call]({ x: 0, y: NaN, z: 0 }, { x: 0, y: 0, z: 1 }), `${rays.constructor.name}.${call}: origin.y must be a finite number, not NaN`);
		}
	}
});

test("Node prints an error of a model without the engine's own fields", () => {
	const error = new engine.ModelError("bear", "line 3", "no vertex 9");
	assert.deepEqual([error.modelName, error.place, error.message], ["bear", "line 3", 'model "bear", line 3: no vertex 9']);
	for (const each of [error, new engine.BlockError("walk", "needs an agent")]) assert.doesNotMatch(util.inspect(each), /\{$|_(?:modelName|place|block)/m);
	assert.equal(new engine.BlockError("walk", "needs an agent").block, "walk");
});

test("constructors of settings take a literal", () => {
	refused(() => new AgentFilter({ breed: ["a"] }), "new AgentFilter: settings.breed is no option; there are ");
	refused(() => new AgentFilter(["a"]), 'new AgentFilter: settings must be an AgentFilter, or a literal such as { breeds: ["sheep"] }, not ["a"]');
	refused(() => new WalkOptions({ stepHeight: "1" }), 'stepHeight must be a number, not "1"');
	const stride = new WalkOptions({ stepHeight: 0.5, filter: { exceptBreeds: ["a"] } });
	assert.deepEqual([stride.stepHeight, stride.snap, stride.filter.exceptBreeds], [0.5, 0.25, ["a"]]);
	assert.deepEqual(new AgentFilter(null).breeds, null);
});

test("a literal serves as a filter", () => {
	const queries = new AgentQueries(new TightestFitCollider(makeLand()));
	const [floor, wolf, sheep] = ["floors", "wolves", "sheep"].map((breed) => new Agent("cube", breed));
	queries.update([floor, wolf, sheep]);
	assert.deepEqual(queries.near(wolf, 1, { breeds: ["sheep"] }), [sheep]);
	assert.deepEqual(queries.near(wolf, 1, { exceptBreeds: ["sheep"], except: undefined }), [floor]);
	assert.deepEqual(queries.near(wolf, 1, { except: [floor], accepts: null }), [sheep]);
	assert.equal(queries.nearest(wolf, 1, { accepts: (agent) => agent === sheep }), sheep);
	wolf.z = 5;
	assert.equal(queries.walk(wolf, 0, 0, { fall: Infinity, filter: { breeds: ["sheep"] } }).on, sheep);
	refused(() => queries.near(wolf, 1, { tags: ["sheep"] }), "AgentQueries.near: filter.tags is no option; there are ", "breeds", "exceptBreeds", "except", "accepts");
	refused(() => queries.near(wolf, 1, { breeds: "sheep" }), 'AgentFilter.breeds must be an array of strings, not "sheep"');
	for (const wrong of [3, "sheep", ["sheep"], wolf]) refused(() => queries.near(wolf, 1, wrong), 'AgentQueries.near: filter must be an AgentFilter, or a literal such as { breeds: ["sheep"] }, not ');
	const collision = new Collision(new BinCollider());
	const met = [];
	collision.onCollision("*", "*", (a, b) => met.push(a, b));
	collision.filter = { exceptBreeds: ["sheep"] };
	collision.update([floor, sheep]);
	assert.deepEqual(met, []);
	assert.deepEqual(collision.filter.exceptBreeds, ["sheep"]);
	const lambs = new (class extends AgentPredicate { admits = () => true; })();
	for (const filter of [AgentFilter.ofBreeds("floors", "sheep"), lambs, null]) {
		collision.filter = filter;
		collision.update([floor, sheep]);
		assert.equal(collision.filter, filter);
	}
	assert.equal(met.length, 12);
	refused(() => (collision.filter = { breed: ["sheep"] }), "Collision.filter.breed is no option; ", "there are breeds");
	for (const wrong of [3, "sheep", ["sheep"], wolf]) refused(() => (collision.filter = wrong), 'Collision.filter must be an AgentFilter, or a literal such as { breeds: ["sheep"] }, not ');
});

test("a filter may answer with any values: those that count as true are true", () => {
	const agents = Array.from({ length: 40 }, (_, i) => Object.assign(new Agent("cube"), { x: 0.9 * i }));
	const [candidates, ofBooleans] = [["yes", undefined], [true, false]].map(([yes, no]) => {
		const collision = new Collision(new BinCollider());
		collision.onCollision("*", "*", () => {});
		collision.filter = new (class extends AgentPredicate { admits = (agent) => (agent.x < 20 ? yes : no); })();
		for (let frame = 0; frame < 5; frame++) collision.update(agents);
		return collision.statistics.candidatePairs;
	});
	assert.equal(candidates, ofBooleans);
});

test("null is refused by the call that gets it", () => {
	const land = makeLand();
	const queries = new AgentQueries(new TightestFitCollider(land));
	queries.update([]);
	const [one, other] = [new Agent("cube"), new Agent("cube")];
	for (const [call, ...values] of [["near", null, 1], ["nearest", null], ["inCone", null, 1, 1], ["touching", null], ["walk", null, 1, 0], ["slide", null, 1, 0, 0], ["refresh", null], ["castAgent", null, 1, 0, 0], ["wouldTouchAt", null, 0, 0, 0]]) {
		refused(() => queries[call](...values), `AgentQueries.${call}: agent must be an Agent, not null`);
	}
	refused(() => queries.canSee(one, null), "AgentQueries.canSee: b must be an Agent, not null");
	refused(() => queries.castShape(null, 1, 0, 0), "AgentQueries.castShape: structure must be this package's Sphere, Capsule, Box or Hull, not null");
	refused(() => land.addModel(null), "GreatLand.addModel: model must be a Model, not null");
	refused(() => new ModelLoader({}), "new ModelLoader: receiver must be a GreatLand, or another ModelReceiver, not a plain object");
	refused(() => (new Collision(new BinCollider()).bounds = {}), "Collision.bounds must be a WorldBounds, for example new WorldBounds(-50, -50, 0, 50, 50, 50), not a plain object");
	refused(() => (one.color = "red"), 'color must be 0xRRGGBB, a number, not "red"');
	refused(() => new TightestFitCollider(), "new TightestFitCollider: greatLand must be a GreatLand, not undefined");
	refused(() => new Collision(land), "collisionSystem must be a CollisionSystem, for example new TightestFitCollider(greatLand), not an object of class GreatLand");
	for (const type of [AgentQueries, SeenAgents]) refused(() => new type(land), "such as new TightestFitCollider(greatLand), not an object of class GreatLand");
	assert.ok(Math.abs(queries.distance(one, Object.assign(other, { x: 3 }), null, null) - 2) < 1e-9);
	queries.near(one, 1, null, null);
});

test("another library's Sphere is not taken for one of another copy", () => {
	const queries = new AgentQueries(new BinCollider());
	class Sphere {
		radius = 1;
	}
	refused(() => queries.castShape(new Sphere(), 1, 0, 0), "structure must be this package's Sphere, Capsule, Box or Hull, not an object of class Sphere");
	refused(() => sphereSphere(new Sphere(), new Sphere()), "sphereSphere: a must be a Sphere, not an object of class Sphere");
});

test("a BaseCollider around a collider is named as itself, where a collider is needed", () => {
	const around = new engine.BaseCollider(new BinCollider());
	const game = new Collision(around);
	game.terrain = new engine.Terrain(2, 2);
	for (const system of [around, game]) refused(() => new AgentQueries(system), "such as new TightestFitCollider(greatLand), not an object of class BaseCollider");
	assert.throws(() => game.update([]), /a terrain needs one of the engine's collision systems, not an object of class BaseCollider$/);
});

test("names of the wrong kind are shown short, with what is meant", async () => {
	const text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".repeat(50);
	assert.throws(() => new engine.ObjModel(text, "bear"), (error) => util.inspect(error).length < 2500 && /a model's name comes before its text$/.test(error.message) && error.modelName.length < 80);
	const { Agent, BinCollider, BuiltInModel, Collision, GreatLand, LevelShapes, SeenAgents } = await import(pathToFileURL(path.join(folder, manifest.exports["."].node)));
	const land = new GreatLand();
	for (const name of ["hero", "wall", "bear"]) land.addModel(BuiltInModel.capsule(0.3, 1.8, name));
	land.removeModel("bear");
	const collision = new Collision(new BinCollider(land));
	for (const [shape, said] of [["heroo", '; is "hero" meant?'], ["Wall", '; is "wall" meant?'], ["bears", "first"], ["tree", "first"]]) {
		assert.throws(() => collision.update([new Agent(shape)]), (error) => error.message.endsWith(said), shape);
	}
	assert.throws(() => collision.update([new Agent("monsters", "hero")]), /; is new Agent\("hero", "monsters"\) meant\? The model comes first$/);
	const shapes = new LevelShapes();
	shapes.addModel(BuiltInModel.box(9, 9, 1, "floor"));
	assert.throws(() => new SeenAgents(shapes).update([new Agent("levels", "floor")]), /; is new Agent\("floor", "levels"\) meant\? The model comes first$/);
	assert.throws(() => new SeenAgents(shapes).update([new Agent("flor")]), /add it to the LevelShapes first; is "floor" meant\?$/);
});

test("a literal with their names stands in place of the Booleans that a call ends with", () => {
	const land = makeLand();
	land.prepareExact = true;
	const collider = new HierarchicalCollider(land);
	collider.exact = true;
	const collision = new Collision(collider);
	const agent = new Agent("cube");
	collision.update([agent]);
	const queries = new AgentQueries(collision);
	queries.update([agent]);
	const ray = [{ x: -5, y: 0, z: 0.5 }, { x: 1, y: 0, z: 0 }, 99, null, null];
	assert.equal(queries.castAll(...ray, { allSurfaces: true }).length, 2);
	assert.equal(queries.castAll(...ray, { allSurfaces: false }).length, 1);
	assert.equal(queries.castAll(...ray, {}).length, 1);
	refused(() => queries.castAll(...ray, { surfaces: true }), "AgentQueries.castAll: options.surfaces is no option; ", "there are allSurfaces");
	refused(() => queries.castAll(...ray, { allSurfaces: 1 }), "AgentQueries.castAll: allSurfaces must be true or false, not 1");
	refused(() => queries.castAll(...ray, [true]), "AgentQueries.castAll: options must be true, false or options, not [true]");
	for (const [literal, given] of [[{ withTraits: true }, [true]], [{ withTraits: true, withGround: false }, [true, false]], [{ withGround: false }, [false, false]], [{}, []]]) {
		assert.deepEqual(collision.snapshot(literal), collision.snapshot(...given));
	}
	refused(() => collision.snapshot({ withtraits: true }), "Collision.snapshot: options.withtraits is no option; ", "there are withTraits, withGround");
	const bear = BuiltInModel.cube();
	assert.deepEqual(land.cook(bear, "z", { usesTransforms: true }), land.cook(bear, "z", true));
});

test("a snapshot from before the first frame says so", () => {
	const collision = new Collision(new BinCollider());
	const bytes = collision.snapshot();
	const agent = new Agent("cube");
	collision.update([agent]);
	refused(() => collision.restore(bytes, [agent]), "bytes are no snapshot of 1 agents, but of no agents: it was taken before the first frame");
});

test("an address that Node cannot fetch says what to do", async () => {
	const loader = new ModelLoader(new GreatLand());
	await assert.rejects(loader.loadAsync("bear", "assets/bear.obj"), /file can't be fetched: assets\/bear\.obj \(an address has to be absolute here; read the file, and give its bytes to loadBytes\(\)\)/);
});

test("subclasses are checked as what they extend, and override it", () => {
	class Hero extends Agent {
		moves = 0;

		constructor(life) {
			super("cube", "heroes");
			this.life = life;
		}

		get x() {
			return super.x;
		}

		set x(value) {
			super.x = value;
		}

		moveTo(x, y, z) {
			this.moves++;
			super.moveTo(x, y, z);
		}
	}
	const hero = new Hero("3");
	hero.x = 4;
	refused(() => (hero.x = "5"), "x must be a number", `agent ${hero.id}`, '"heroes"');
	refused(() => hero.moveTo(1, 2, "3"), "z must be a number");
	assert.deepEqual([hero.x, hero.moves, hero.life], [4, 2, "3"]);
	assert.equal(new BinCollider().areColliding(hero, new Hero(1)), false);
	class Slow extends BinCollider {
		findCollisions(agents, out) {
			return super.findCollisions(agents, out);
		}
	}
	hero.moveTo(0, 0, 0);
	const found = new Slow().findCollisions([hero, new Hero(2)]);
	assert.equal(found.length, 2);
	assert.ok(found[0] instanceof Hero);
});

test("a BinCollider needs no models", () => {
	const agents = Array.from({ length: 20 }, (_, i) => new Agent(`nothing ${i % 3}`));
	agents.forEach((agent, i) => agent.moveTo(0.9 * i, 0, 0));
	assert.equal(new BinCollider().findCollisions(agents).length, 2 * 19);
	assert.equal(new BinCollider(null).areColliding(agents[0], agents[1]), true);
	assert.throws(() => new BinCollider(makeLand()).findCollisions(agents), /there is no model "nothing 0"/);
});

test("handlers get the contact, however they say what they take", () => {
	const collision = new Collision(new BinCollider());
	const seen = [];
	const note = (how) => (all) => seen.push([how, all.length, all[2]?.depth, all[2]?.normal.x, all[2]?.time]);
	const noteRest = note("rest");
	const noteDefault = note("default");
	const noteArguments = note("arguments");
	const noteBound = note("bound");
	const noteThree = note("three");
	let two = 0;
	collision.onCollision("a", "b", (...all) => noteRest(all));
	collision.onCollision("a", "b", (a, b, contact = null) => noteDefault([a, b, contact]));
	collision.onCollision("a", "b", function() {
		noteArguments([...arguments]);
	});
	collision.onCollision("a", "b", function(...all) {
		noteBound(all);
	}.bind(null));
	const noteComment = note("comment");
	const noteNamed = note("named");
	const noteComputed = note("computed");
	collision.onCollision("a", "b", function(a, b/* :) */, ...rest) {
		noteComment([a, b, ...rest]);
	});
	const named = {
		"on(x)"(...all) {
			noteNamed(all);
		},
		["on(y)".trim()](...all) {
			noteComputed(all);
		},
	};
	for (const each of Object.values(named)) collision.onCollision("a", "b", each);
	collision.onCollision("a", "b", (a, b, contact) => noteThree([a, b, contact]));
	collision.onCollision("b", "a", (b, a, contact = null) => seen.push(["back", 3, contact.depth, contact.normal.x, contact.time]));
	collision.onCollisionStart("a", "b", (...all) => seen.push(["start", all.length, all[2].depth, all[2].normal.x, all[2].time]));
	collision.onCollisionEnd("a", "b", (...all) => seen.push(["end", all.length, all[2]?.depth]));
	collision.onCollision("a", "b", (a, b) => {
		two = a.id + b.id;
		a.moveTo(-9, 0, 0);
	});
	const [a, b] = [new Agent("x", "a"), new Agent("x", "b")];
	b.moveTo(0.75, 0, 0);
	collision.update([a, b]);
	const ways = ["start", "rest", "default", "arguments", "bound", "comment", "named", "computed", "three", "back"];
	assert.deepEqual(seen.map(([how]) => how), ways);
	for (const [how, count, depth, normal, time] of seen) assert.deepEqual([how, count, depth, normal, time], [how, 3, 0.25, how === "back" ? 1 : -1, 1]);
	assert.equal(two, a.id + b.id);
	seen.length = 0;
	collision.update([a, b]);
	assert.equal(seen.length, 1);
	assert.equal(seen[0][0], "end");
});

test("a contact is that of the frame before handlers, however they say what they take", () => {
	const collision = new Collision(new BinCollider());
	collision.terrain = new engine.Terrain(11, 11, 1, -5, -5);
	collision.bounds = new engine.WorldBounds(-9, -9, -9, 9, 9, 9);
	const depths = [];
	const change = (ball, ground) => {
		collision.terrain.setHeights(0, 0, 11, 11, new Float64Array(121).fill(5));
		collision.bounds.setTo(-1, -1, -1, 1, 1, 1);
	};
	const ways = [(...all) => depths.push(all[2].depth), (a, b, contact = null) => depths.push(contact.depth), function() {
		depths.push(arguments[2].depth);
	}, ((a, b, contact) => depths.push(contact.depth)).bind(null), (a, b, contact) => depths.push(contact.depth)];
	for (const way of [change, ...ways]) for (const other of [Collision.TERRAIN, Collision.EDGE]) collision.onCollision("a", other, way);
	const balls = [new Agent("x", "a"), new Agent("x", "a")];
	balls[0].moveTo(0, 0, -0.1);
	balls[1].moveTo(8.6, 0, 6);
	collision.update(balls);
	assert.equal(depths.length, 10);
	for (const depth of depths) assert.ok(Math.abs(depth - 0.1) < 1e-9, String(depth));
});

test("a contact for a handler that does not declare it is that of its own pair", () => {
	const collider = new BinCollider();
	const collision = new Collision(collider);
	const agents = Array.from({ length: 12 }, () => new Agent("x", "a"));
	agents.forEach((agent, i) => agent.moveTo(0.3 * i, 0.1 * ((i * 7) % 5), 0));
	const early = [];
	const late = [];
	collision.onCollision("a", "a", (a, b, contact) => early.push([a.id, b.id, contact.depth, contact.normal.x, contact.point.y]));
	collision.onCollision("a", "a", (...[a, b, contact]) => late.push([a.id, b.id, contact.depth, contact.normal.x, contact.point.y]));
	collision.update(agents);
	assert.ok(early.length > 30);
	assert.deepEqual(late, early);
});

test("a listener may listen once, and until a signal", () => {
	const loader = new ModelLoader(new GreatLand());
	const calls = [];
	const first = () => calls.push("first");
	const second = () => calls.push("second");
	const third = () => calls.push("third");
	const abort = new AbortController();
	loader.addEventListener("complete", first, { once: true });
	loader.addEventListener("complete", first, { once: true });
	loader.addEventListener("complete", second, { signal: abort.signal });
	loader.addEventListener("complete", third, {});
	const fire = () => {
		calls.length = 0;
		loader.dispatchEvent(new Event(Event.COMPLETE));
		return calls.join();
	};
	assert.equal(fire(), "first,second,third");
	assert.equal(fire(), "second,third");
	abort.abort();
	assert.equal(fire(), "third");
	loader.removeEventListener("complete", third, {});
	assert.equal(fire(), "");
	loader.addEventListener("complete", first, { once: true });
	loader.removeEventListener("complete", first);
	assert.equal(fire(), "");
	loader.addEventListener("complete", first, { capture: true });
	loader.addEventListener("complete", second, { once: true }, 5);
	assert.equal(fire(), "second,first");
	loader.removeEventListener("complete", first, { capture: true });
	assert.equal(fire(), "");
	loader.addEventListener("hasOwnProperty", second);
	loader.addEventListener("complete", first, true);
	assert.equal(fire(), "first");
	assert.deepEqual(["complete", "hasOwnProperty", "toString"].map((type) => loader.hasEventListener(type)), [true, true, false]);
	loader.removeEventListener("complete", first);
	assert.equal(fire(), "");
	// a dispatch inside of another, by a listener that comes before
	let depth = 0;
	loader.addEventListener("complete", () => depth++ === 0 && loader.dispatchEvent(new Event(Event.COMPLETE)), {}, 1);
	loader.addEventListener("complete", first, { once: true });
	assert.equal(fire(), "first");
	assert.equal(depth, 2);
	refused(() => loader.addEventListener("complete", first, { onec: true }), "addEventListener: options.onec is no option; ", "there are once, capture, signal");
});

test("a load may be awaited, and aborted alone", async () => {
	const land = new GreatLand();
	const loader = new ModelLoader(land);
	const url = `data:text/plain,${encodeURIComponent("v 0 0 0\nv 2 0 0\nv 0 1 3\nf 1 2 3\n")}`;
	const model = await loader.loadAsync("z", url);
	assert.ok(model instanceof Model && model.name === "z" && land.hasModel("z"));
	const turned = await loader.loadAsync("y", url, { upAxis: "y", scaling: Model.AS_GIVEN });
	assert.deepEqual([model.vertices[8], turned.vertices[8]], [1.5, 1]);
	// nothing but the promise hears of these, and of what is aborted none at all
	await assert.rejects(loader.loadAsync("broken", "data:text/plain,v 1 2"), { name: "ModelError", message: /^model "broken", line 1/ });
	await assert.rejects(loader.loadAsync("number", 7), /url must be a string/);
	await assert.rejects(loader.loadAsync("z", url, { upaxis: "y" }), /^ArgumentError: ModelLoader\.loadAsync: options\.upaxis is no option; (?:the nearest is upAxis; )?there are upAxis, scaling, signal$/);
	for (const none of [null, "y", 5, []]) await assert.rejects(loader.loadAsync("z", url, none), /^ArgumentError: ModelLoader\.loadAsync: options must be a literal such as \{ upAxis: "y" \}, not /);
	const texts = [];
	loader.addEventListener("error", (event) => texts.push(event.text));
	await assert.rejects(loader.loadAsync("damaged", "data:text/plain,v 1 2"), { name: "ModelError" });
	assert.match(texts.join("\n"), /^model "damaged", line 1[^\n]*$/);
	const abort = new AbortController();
	const first = loader.loadAsync("same", url, { signal: abort.signal });
	const second = loader.loadAsync("same", url);
	abort.abort(new Error("enough"));
	await assert.rejects(first, /^Error: enough$/);
	await assert.rejects(loader.loadAsync("late", url, { signal: abort.signal }), /^Error: enough$/);
	assert.equal(loader.pendingCount, 1);
	assert.equal((await second).name, "same");
	const cancelled = loader.loadAsync("cancelled", url, { signal: new AbortController().signal });
	loader.cancel();
	await assert.rejects(cancelled, { name: "AbortError" });
	assert.ok(!land.isLoading("late") && !land.isLoading("cancelled") && !land.hasModel("cancelled"));
	assert.equal(texts.length, 1);
});

test("an object of another copy of the engine is named as that", async () => {
	const other = await import(pathToFileURL(path.join(folder, manifest.exports["."].node)));
	const COPIES = "not one of another copy of the engine. There are two copies of the engine: ";
	const land = makeLand();
	const foreign = new other.GreatLand();
	class Hero extends other.Agent {}
	refused(() => land.addModel(other.BuiltInModel.cube()), "GreatLand.addModel: model must be a Model", COPIES);
	refused(() => new TightestFitCollider(foreign), "greatLand must be a GreatLand", COPIES);
	refused(() => new Collision(new BinCollider()).update([new Agent("x"), new Hero("x")]), "agents[1] must be an Agent", COPIES);
	refused(() => (land.fitStore = new other.FitStore()), "fitStore must be a FitStore", COPIES);
	refused(() => (land.boundingStructures.fitters = [new other.RitterSphereFitter()]), "fitters[0] must be a Fitter", COPIES);
	assert.equal(new Sphere(new other.Vector3D(1, 2, 3), 1).center.y, 2, "a point is a point");
	refused(() => new engine.AgentQueries(new other.BinCollider()), "questions need a Collision or one of", COPIES);
	refused(() => new engine.AgentQueries(new other.Collision(new other.BinCollider())), "questions need a Collision or one of", COPIES);
	class Model {}
	refused(() => land.addModel(new Model()), "model must be a Model, not an object of class Model");
	refused(() => land.addModel(new Date(0)), "model must be a Model, not an object of class Date");
	refused(() => new ModelLoader(land).dispatchEvent(new globalThis.Event("complete")), "event must be an Event, not an object of class Event");
	assert.equal(land.hasModel("cube"), true);
});

test("errors name structures, elements of lists, functions and settings as their users do", () => {
	const land = makeLand();
	const questions = new engine.AgentQueries(new TightestFitCollider(land));
	const sphere = new Sphere(new Vector3D(1, 2, 3), 0.5);
	const turned = [new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1)];
	class Ring extends engine.BoundingStructure {}
	assert.equal(String(sphere), "a Sphere of radius 0.5 at Vector3D(1, 2, 3)");
	assert.equal(String(new Box(new Vector3D(), ...turned, 1, 2, 3)), "a Box of half-extents (1, 2, 3) at Vector3D(0, 0, 0)");
	assert.equal(String(new engine.Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 2)), "a Cylinder of radius 2 from Vector3D(0, 0, 0) to Vector3D(0, 0, 1)");
	refused(() => questions.overlapping(new Ring(7)), "a sphere, box, capsule or hull is needed, not a structure of class Ring");
	refused(() => engine.Wireframes.ofStructure(new Ring(7)), "this kind of structure can't be drawn: a structure of class Ring");
	refused(() => new SeenAgents(land), "not an object of class GreatLand; a SeenAgents may also have a LevelShapes");
	const flat = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3";
	assert.throws(() => new engine.ObjModel("flat", flat, { up: "y" }), /the up axis must be "x", "y" or "z", or a ModelTransform, not a plain object$/);
	assert.throws(() => new engine.ObjModel("flat", flat, Model.AS_GIVEN), /the up axis must be .*, not "as given": a scaling is the argument after it$/);
	const filter = new AgentFilter();
	refused(() => (filter.breeds = [3]), "AgentFilter.breeds[0] must be a string, not 3");
	refused(() => (filter.breeds = "bears"), 'AgentFilter.breeds must be an array of strings, not "bears"');
	refused(() => (land.boundingStructures.fitters = [3]), "fitters[0] must be a Fitter, not 3");
	refused(() => sphere.extentsInto([], -1), "offset must be a whole number, 0 or more, not -1");
	refused(() => new Agent(), "new Agent: shape must be a string, not undefined");
	refused(() => new engine.AgentQueries({}), "one of the engine's collision systems, such as new TightestFitCollider(greatLand), not a plain object");
	const collision = new Collision(new BinCollider());
	refused(() => collision.onCollision("", "b", () => 0), 'breed must be the name of a breed or ANY_BREED, not ""');
	refused(() => collision.onCollision("a", undefined, () => 0), "Collision.onCollision: otherBreed must be a string, not undefined");
	refused(() => collision.onCollision("a", "b", undefined), "handler must be a function, not undefined");
	const one = new Agent("cube");
	refused(() => questions.distance(one, one), "two different agents are needed");
	const saysOf = (read) => assert.throws(read, (error) => error.name === "ModelError" && !/text/.test(error.message) && /empty|no glTF file|no STL file/.test(error.message));
	for (const bytes of [new Uint8Array(0), new Uint8Array(16)]) for (const type of [engine.GltfModel, engine.StlModel]) saysOf(() => type.fromBytes("x", bytes));
	assert.throws(() => new engine.ObjModel("x", "v 0 0 0", 3), /not 3$/);
});

test("no number of a Flash player's error is in a text", async () => {
	const loader = new ModelLoader(new GreatLand());
	const texts = [];
	loader.addEventListener("error", (event) => texts.push(event.text));
	loader.load("nothing", "http://localhost:1/nothing.obj");
	loader.loadBytes("damaged", new Uint8Array([0x50, 0x4b, 3, 4, ...new Uint8Array(40)]));
	await new Promise((resolve) => loader.addEventListener("complete", resolve, { once: true }));
	assert.equal(texts.length, 2);
	for (const text of texts) assert.doesNotMatch(text, /#\d|Stream Error/);
	assert.match(texts.find((text) => text.includes("nothing")), /^model "nothing": its file can't be fetched: http:\/\/localhost:1\/nothing\.obj \(.+\)$/);
	assert.ok(loader.toString().includes("ModelLoader"));
	assert.ok(new ErrorEvent("error", false, false, "x") instanceof Event && new IllegalOperationError("x") instanceof Error);
});

test("milliseconds come with their fractions", () => {
	const collision = new Collision(new BinCollider());
	const agents = Array.from({ length: 500 }, (_, i) => new Agent("x"));
	agents.forEach((agent, i) => agent.moveTo(i, 0, 0));
	const times = [];
	for (let i = 0; i < 20; i++) {
		collision.update(agents);
		const { findMs, frameMs } = collision.statistics;
		assert.ok(findMs >= 0 && frameMs >= findMs && frameMs < 1000, `${findMs} of ${frameMs}`);
		times.push(frameMs);
	}
	assert.ok(times.some((ms) => !Number.isInteger(ms)), String(times));
});

test("JSON and tools see what an object is like, and nothing of what is inside", () => {
	const land = makeLand();
	const collision = new Collision(new HierarchicalCollider(land));
	const agents = Array.from({ length: 40 }, (_, i) => new Agent(i % 2 ? "cube" : "sphere"));
	agents.forEach((agent, i) => agent.moveTo(0.3 * i, 0, 0));
	collision.onCollision("turtles", "turtles", () => {});
	collision.onCollisionStart("turtles", "turtles", (a, b, contact) => contact.depth);
	collision.update(agents);
	const [agent] = agents;
	assert.deepEqual(JSON.parse(JSON.stringify(agent)), {
		id: agent.id, breed: "turtles", shape: "sphere", x: 0, y: 0, z: 0, heading: 0, pitch: 0, roll: 0, size: 1, color: 0, hierarchical: false, traversalDepth: 0, collideAs: "tightest", sweeps: false, isOneWay: false,
	});
	for (const object of [agent, collision, collision.collisionSystem, land, land.hierarchies, collision.statistics, new ModelLoader(land)]) {
		for (const options of [{}, { depth: 10 }, { showHidden: true, depth: 10 }]) {
			const text = util.inspect(object, options);
			assert.ok(text.startsWith(object.constructor.name), text.slice(0, 40));
			assert.ok(text.length < 1500, `${object.constructor.name}: ${text.length}`);
			assert.doesNotMatch(text, /[^"\w][_$]\w/);
		}
		assert.ok(JSON.stringify(object).length < 1500);
	}
	assert.ok(util.inspect(agents, { maxArrayLength: null }).length < 40 * 500);
	class Hero extends Agent {
		life = 3;
	}
	assert.match(util.inspect(new Hero("cube")), /^Hero \{[\s\S]*life: 3/);
	assert.match(util.format("%s", agent), /^agent \d+/);
	assert.ok(String(util.inspect({ deep: { deeper: { agent } } })).includes("[Agent]"));
	for (const each of agents) each.mates = agents;
	assert.ok(util.inspect(agent).length < 20000);
	const [one, other] = [new Hero("cube"), new Hero("cube")];
	Object.assign(one, { friend: other });
	Object.assign(other, { friend: one });
	assert.match(util.inspect(one, { depth: null }), /^<ref \*1> Hero \{[^]*friend: Hero \{[^]*friend: \[Circular \*1\]/);
	assert.ok(util.inspect(agent, { depth: null }).length < 100000);
	assert.throws(() => JSON.stringify(one), /circular structure/);
	delete other.friend;
	assert.equal(JSON.parse(JSON.stringify([one, other]))[0].friend.friend, undefined);
	assert.notEqual(one.toJSON(), one.toJSON());
});

test("an error event that nothing hears says so", () => {
	const script = 'import { GreatLand, ModelLoader } from "./starlogo-collision.js"; new ModelLoader(new GreatLand()).load("bear", "http://localhost:1/bear.obj");';
	const { stderr, status } = spawnSync(process.execPath, ["--input-type=module", "-e", script], { cwd: folder, encoding: "utf8" });
	assert.equal(status, 1);
	assert.match(stderr, /Error: model "bear": its file can't be fetched: .*\. Nothing listens to the event "error"/);
});

test("an error that nothing catches shows a line, not the whole file", () => {
	const script = 'import { Agent } from "./starlogo-collision.js"; new Agent("cube").x = "3";';
	const { stderr, status } = spawnSync(process.execPath, ["--input-type=module", "-e", script], { cwd: folder, encoding: "utf8" });
	assert.equal(status, 1);
	assert.match(stderr, /x must be a number, not "3"/);
	assert.ok(stderr.length < 2000, `${stderr.length} characters`);
	assert.ok(manifest.exports["."].node.endsWith("starlogo-collision.js"));
	const longest = Math.max(...readFileSync(path.join(folder, "starlogo-collision.js"), "utf8").split("\n").map((line) => line.length));
	assert.ok(longest < 3000, `the longest line has ${longest} characters`);
});

test("options are the setters of a class, also inherited ones", () => {
	const collision = new Collision(new BinCollider());
	const queries = new AgentQueries(collision);
	const [sheep, wolf] = [new Agent("sphere", "sheep"), new Agent("sphere", "wolves")];
	queries.update([sheep, wolf]);
	for (const name of ["admits", "toString", "constructor", "hasOwnProperty"]) {
		refused(() => queries.near(sheep, 5, { [name]: () => false }), `AgentQueries.near: filter.${name} is no option`);
	}
	class Wolves {
		get breeds() {
			return ["wolves"];
		}
	}
	for (const filter of [Object.create({ breeds: ["wolves"] }), new Wolves(), new AgentFilter({ breeds: ["wolves"] }), new AgentFilter(new AgentFilter({ breeds: ["wolves"] }))]) {
		assert.deepEqual(queries.near(sheep, 5, filter), [wolf]);
		assert.deepEqual(queries.near(wolf, 5, filter), []);
	}
});

test("a listener's options are checked before it is added, and what ends it ends it alone", () => {
	const loader = new ModelLoader(new GreatLand());
	let calls = 0;
	const count = () => calls++;
	const fire = () => loader.dispatchEvent(new Event(Event.COMPLETE));
	refused(() => loader.addEventListener("complete", count, { signal: {} }), "addEventListener: options.signal must be an AbortSignal, not a plain object");
	refused(() => loader.addEventListener("complete", count, { once: "no" }), 'addEventListener: options.once must be true or false, not "no"');
	fire();
	assert.equal(calls, 0);
	const addAgain = () => {
		loader.removeEventListener("complete", addAgain);
		loader.removeEventListener("complete", count);
		loader.addEventListener("complete", count);
	};
	loader.addEventListener("complete", addAgain, false, 5);
	loader.addEventListener("complete", count, { once: true });
	for (let i = 0; i < 3; i++) fire();
	assert.equal(calls, 3);
	loader.removeEventListener("complete", count);
	const abort = new AbortController();
	loader.addEventListener("complete", count, { signal: abort.signal });
	loader.removeEventListener("complete", count);
	loader.addEventListener("complete", count);
	abort.abort();
	fire();
	assert.equal(calls, 4);
});

test("a model with wrong options is not fetched", async (context) => {
	const fetched = context.mock.method(globalThis, "fetch", async () => new Response("v 0 0 0"));
	for (const options of [{ scaling: "as_given" }, { upAxis: "Y" }]) {
		await assert.rejects(new ModelLoader(new GreatLand()).loadAsync("model", "http://localhost/model.obj", options), /^ArgumentError: model "model": the (?:scaling|up axis) must be/);
	}
	await assert.rejects(new ModelLoader(new GreatLand()).loadAsync("model", "http://localhost/model.obj", { signal: {} }), /ModelLoader.loadAsync: options.signal must be an AbortSignal/);
	assert.equal(fetched.mock.callCount(), 0);
});

test("an arrow function without parentheses takes no contact", async () => {
	const { mayTakeContact } = await import("../../js/standins/module/contacts.mjs");
	// eslint-disable-next-line arrow-parens
	const plain = [a => { a.hit = true; }, async a => { a.hit = true; }, (a, b) => { a.hit = b; }, function (a) { a.hit = a == null; }];
	for (const handler of plain) assert.equal(mayTakeContact(handler), false, String(handler));
	for (const handler of [(...all) => all, (a, b, c) => c, (a, b = () => 1) => b, function () { return arguments[2]; }]) assert.equal(mayTakeContact(handler), true, String(handler));
});

test("the readable module refuses what the minified one refuses, before it warns", () => {
	const code = `
		import { Agent, AgentQueries, BinCollider, Collision } from ${JSON.stringify(pathToFileURL(path.join(folder, "starlogo-collision.js")))};
		const warned = [];
		console.warn = (text) => warned.push(text);
		const shot = () => Object.assign(new Agent("sphere", "shots"), { sweeps: true });
		const collision = new Collision(new BinCollider());
		const queries = new AgentQueries(collision);
		const agent = shot();
		agent.moveTo(0, 0, 0);
		agent.moveTo(9, 0, 0);
		const symbol = Symbol("s");
		const calls = [...[{ length: 1 }, new Set([agent]), 3].map((list) => () => collision.update(list)), () => collision.onCollision(10n, "a", () => {}),
			() => collision.removeHandler("a", 10n, () => {}), () => queries.walk(agent, {}, 0), () => queries.walk(agent, 1, 0, { slopeDegrees: symbol })];
		for (const call of calls) try { call(); console.log("accepted " + call); } catch (error) { if (error.name !== "ArgumentError") console.log(String(error)); }
		const late = shot();
		try { late.moveTo(NaN, 0, 0); } catch {}
		late.moveTo(0, 0, 0);
		late.moveTo(9, 0, 0);
		collision.update([late]);
		console.log(warned.filter((text) => /sweeps, and was moved/.test(text)).length);`;
	const { stdout, stderr } = spawnSync(process.execPath, ["--input-type=module", "-e", code], { encoding: "utf8" });
	assert.equal(stdout + stderr, "1\n");
});
