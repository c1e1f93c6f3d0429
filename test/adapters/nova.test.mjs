/** Tests of the adapter to the StarLogo Nova client, in a small client of their own; nova-page.test.mjs and nova-view.test.mjs have those in the real one. */
import assert from "node:assert/strict";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import vm from "node:vm";
import { BuiltInModel, Model, ModelTransform, ObjModel, TightestFitCollider, GreatLand, Agent } from "../../bin/module/starlogo-collision.js";
import { serve } from "../../build/headless/server.mjs";
import { asset, randomNumbers } from "../benchmark/games.mjs";
import { addBlocks, addButton, installInto, toggle } from "../../bin/module/nova/index.js";
import { alive, bruteCollisions, hatch, makeWindow, pairKeys, playGame, within } from "./nova-client.mjs";
import { warningsIn } from "./warnings.mjs";

/** Checks that answers are equal, and counts those that say something. */
function checker() {
	const seen = { pairs: 0, noPairs: 0, count: 0, nearest: 0, empty: 0 };
	const check = (what, got, expected) => {
		assert.deepEqual(got, expected, what);
		if (what === "pairs") seen[expected === "" ? "noPairs" : "pairs"]++;
		else if (what === "count" && expected > 0) seen.count++;
		else if (what === "nearest") seen.nearest++;
		else if (what === "empty" && !expected) seen.empty++;
	};
	return { check, seen };
}

test("bins: every pair, count and nearest of random games is that of brute force", () => {
	const { check, seen } = checker();
	for (let seed = 1; seed <= 12; seed++) {
		const window = makeWindow();
		installInto(window, { system: "bins" });
		playGame(window, seed, 60, check, { spread: [50.5, 10, 70][seed % 3] });
		assert.equal(window.Execution.Collisions.calls, 0);
	}
	assert.ok(seen.pairs > 300 && seen.noPairs > 5 && seen.count > 1000 && seen.nearest > 2000 && seen.empty > 500, JSON.stringify(seen));
});

test("the client's own answers come back with uninstall, in the middle of a game, and ours with another install", () => {
	const window = makeWindow();
	const { Collisions, AgentController } = window.Execution;
	const given = Object.getOwnPropertyDescriptors(Collisions);
	const scatter = AgentController.scatterAllAgents;
	const { check } = checker();
	playGame(window, 1, 5, check);
	for (let round = 0; round < 3; round++) {
		const calls = Collisions.calls;
		const installation = installInto(window);
		const { count, getCollisions } = Collisions;
		playGame(window, 2 + round, 10, check);
		assert.equal(Collisions.calls, calls);
		assert.notEqual(count, given.count.value);
		installation.uninstall();
		assert.ok(!installation.isInstalled);
		assert.deepEqual(Object.getOwnPropertyDescriptors(Collisions), { ...given, calls: { ...given.calls, value: calls } });
		assert.equal(AgentController.scatterAllAgents, scatter);
		assert.deepEqual([...window.added].sort((a, b) => a.id - b.id), alive(window).sort((a, b) => a.id - b.id));
		installation.uninstall();
		assert.equal(window.added.size, alive(window).length);
		playGame(window, 12 + round, 5, check);
		assert.ok(Collisions.calls > calls && Collisions.getCollisions !== getCollisions);
	}
});

test("what is installed a second time takes the place of the first, which then does nothing", () => {
	const window = makeWindow();
	const first = installInto(window);
	const second = installInto(window, { system: "tightest" });
	assert.ok(!first.isInstalled && second.isInstalled);
	first.uninstall();
	assert.ok(second.isInstalled);
	window.Execution.Collisions.getCollisions();
	assert.equal(window.Execution.Collisions.calls, 0);
	second.uninstall();
	window.Execution.Collisions.getCollisions();
	assert.equal(window.Execution.Collisions.calls, 1);
});

test("options that cannot be are refused, and what is installed stays", () => {
	const window = makeWindow();
	assert.throws(() => installInto({}), /no StarLogo Nova client/);
	const installation = installInto(window);
	assert.throws(() => installInto(window, { system: "spheres" }), /RangeError.*bins, tightest, hierarchical, combination, not spheres/s);
	assert.throws(() => installation.exchange({ exact: true }), /exact is for hierarchical/);
	assert.throws(() => installation.exchange({ breeds: { Fish: { deep: 3 } } }), /not deep/);
	assert.throws(() => installation.exchange({ sweeps: "yes" }), /RangeError.*not yes/);
	for (const options of [null, 3]) assert.throws(() => installInto(window, options), /options must be a literal/);
	assert.throws(() => installation.exchange(), /options must be a literal/);
	assert.throws(() => installation.setTraits("Fish", { structure: "cone" }), /not cone/);
	for (const depth of [-1, 0.5, 2 ** 40, "2", null]) assert.throws(() => installation.setTraits("Fish", { depth }), /RangeError.*depth/);
	for (const trait of ["hierarchical", "sweeps"]) {
		for (const value of ["false", 1, null]) assert.throws(() => installation.setTraits("Fish", { [trait]: value }), /RangeError.*must be true or false/);
	}
	// whatever the system is, and also what the next could not use
	for (const depth of [-1, 0, 2.5, "3", null]) {
		assert.throws(() => installInto(window, { depth }), /maxDepth must be/);
		assert.throws(() => installation.exchange({ depth }), /maxDepth must be/);
	}
	for (const breeds of [5, [], "Fish", { Fish: true }]) assert.throws(() => installation.exchange({ breeds }), /RangeError.*must be an object, not/);
	// what is read at installation alone cannot change, but may be named again
	for (const options of [{ shapes: { Cube: null } }, { manifest: "manifest.json" }]) assert.throws(() => installation.exchange(options), /RangeError.*once/);
	installation.exchange(installation.options);
	installation.setTraits("Fish", { hierarchical: undefined, depth: 2 });
	installation.exchange({ system: undefined, exact: undefined });
	assert.deepEqual(installation.options.breeds, { Fish: { depth: 2 } });
	assert.throws(() => (installation.options.breeds.Fish.depth = -1), TypeError);
	assert.throws(() => (installation.options.breeds.Fish = {}), TypeError);
	assert.throws(() => installation.exchange({ sytem: "tightest" }), /^ArgumentError: options\.sytem is no option; .*there are system, exact, /);
	const { system, exact } = installation.options;
	assert.deepEqual([system, exact], ["bins", false]);
	assert.ok(installation.isInstalled);
});

/** Two agents of a breed with a block for itself. */
function two(options, ...states) {
	const window = makeWindow();
	const { Execution: { AgentController, Collisions }, Common: { State } } = window;
	AgentController.addBreed("Fish", 2);
	State.collidingBreeds.add(2);
	State.collidedBreeds.set(2, [2]);
	const installation = installInto(window, options);
	const agents = states.map((state) => hatch(window, "Fish", state));
	for (const agent of agents) Collisions.add(agent);
	return { window, Collisions, State, installation, agents, pairs: () => Collisions.getCollisions().length };
}

test("bins: spheres about their places, a size of 0 is a point, touching is not colliding", () => {
	assert.equal(two({}, { x: 0 }, { x: 1 }).pairs(), 0);
	assert.equal(two({}, { x: 0 }, { x: 1 - 2 ** -52 }).pairs(), 1);
	assert.equal(two({}, { size: 0 }, { size: 0 }).pairs(), 0);
	assert.equal(two({}, { size: 0, x: 0.4 }, { size: 1 }).pairs(), 1);
	assert.equal(two({}, { size: 0, x: 0.5 }, { size: 1 }).pairs(), 0);
	assert.equal(two({}, { size: 1, z: -2 }, { size: 5, z: 0.9 }).pairs(), 1);
	assert.equal(two({}, { size: 1, z: -2 }, { size: 5, z: 1.1 }).pairs(), 0);
	assert.equal(two({}, { x: 50.5, y: 50.5 }, { x: 50.5, y: 50.2 }).pairs(), 1);
	assert.equal(two({}, { x: NaN }, { x: 0 }, { size: Infinity }, { x: 0.5 }).pairs(), 1);
	assert.equal(two({ system: "tightest" }, { size: 0 }, { size: 1 }).pairs(), 0);
	assert.equal(two({ system: "tightest" }, { x: 0 }, { x: 1 }).pairs(), 1);
});

test("bins with sweeps: who stands collides by the client's rule, who moves along its way", () => {
	const game = two({ sweeps: true }, { x: 0 }, { x: 1 });
	const { installation, agents: [first, second] } = game;
	for (let i = 0; i < 3; i++) assert.deepEqual([game.pairs(), installation.areColliding(first, second)], [0, false]);
	second.state.x = second.prevState.x = 0.99;
	assert.equal(game.pairs(), 1);
	second.state.x = -5;
	assert.deepEqual([game.pairs(), installation.areColliding(first, second)], [1, false]);
});

test("agents without blocks collide where they are now", () => {
	for (const system of ["bins", "tightest", "combination"]) {
		const { installation, window, Collisions } = two({ system }, { x: 0 });
		window.Execution.AgentController.addBreed("Algae", 3);
		const [first, second] = [{ x: 10, y: 10 }, { x: -20 }].map((state) => hatch(window, "Algae", state));
		for (const agent of [first, second]) Collisions.add(agent);
		Collisions.getCollisions();
		assert.equal(installation.areColliding(first, second), false, system);
		Object.assign(second.state, { x: 10.2, y: 10 });
		assert.equal(installation.areColliding(first, second), true, system);
	}
});

test("a toggle that fails leaves nothing behind", () => {
	const window = makeWindow();
	const given = Object.getOwnPropertyDescriptors(window.Execution.Collisions);
	for (let i = 0; i < 2; i++) assert.throws(() => toggle(window), /no StarLogo Nova client with a toolbar/);
	assert.deepEqual(Object.getOwnPropertyDescriptors(window.Execution.Collisions), given);
});

test("pairs come as the client comes upon them: by its list, bins, breeds of blocks, and who was updated last", () => {
	const { window, Collisions, State, agents } = two({}, { x: 0 }, { x: 0.1 }, { x: 0.2 }, { x: -0.6 });
	const order = () => Collisions.getCollisions().map(({ a, b }) => `${agents.indexOf(a)}${agents.indexOf(b)}`).join(" ");
	assert.equal(order(), "01 02 03 12 13 23");
	Collisions.update(agents[1]);
	assert.equal(order(), "02 03 01 12 13 23");
	window.Execution.AgentController.addBreed("Algae", 3);
	agents[0].breed = window.Execution.AgentController.getByName("Algae");
	State.collidedBreeds.set(2, [3, 2]);
	assert.equal(order(), "01 12 13 02 23 03");
	const { data } = window.Execution.AgentController;
	[data[2], data[4]] = [data[4], data[2]];
	assert.equal(order(), "03 02 23 01 12 13");
});

test("count and nearest beyond the ground's diagonal are the client's; of radii that are none there is nobody", () => {
	const { Collisions, agents, window } = two({}, { x: 0 }, { x: 1 }, { x: 2, size: 3 });
	assert.equal(Collisions.count(agents[0], "Fish", 143), 3);
	assert.equal(Collisions.count(agents[0], "Everyone", 143), 4);
	assert.equal(Collisions.count(agents[0], "Everyone", 142), 2);
	// gone in the same tick, without an update
	const { x } = agents[1].state;
	agents[1].state.x = 49;
	assert.equal(Collisions.count(agents[0], "Fish", 25), 1);
	agents[1].state.x = x;
	assert.equal(Collisions.count(agents[0], "Fish", 143, "size", 3), 1);
	assert.equal(Collisions.nearest(agents[0], "Fish", 143), agents[1]);
	for (const radius of [-1, NaN, "a", undefined]) {
		assert.equal(Collisions.count(agents[0], "Fish", radius), 0);
		assert.equal(Collisions.nearest(agents[0], "Fish", radius), agents[0]);
	}
	assert.equal(Collisions.nearest(agents[0], "The World", 50), agents[0]);
	assert.throws(() => Collisions.count(agents[0], "Nobody", 5), /no breed "Nobody"/);
	assert.equal(within(window, agents[0], "Fish", 1).length, 1);
});

test("systems are exchanged while a game runs, and nobody is lost", () => {
	const window = makeWindow();
	const installation = installInto(window);
	const { check } = checker();
	playGame(window, 5, 10, check);
	const pairsOf = (options) => {
		installation.exchange(options);
		return pairKeys(window.Execution.Collisions.getCollisions());
	};
	window.Common.State.collidingBreeds = new Set([2, 3, 4]);
	window.Common.State.collidedBreeds = new Map([2, 3, 4].map((id) => [id, [2, 3, 4]]));
	for (const agent of alive(window)) {
		Object.assign(agent.state, { x: agent.state.x / 10, y: agent.state.y / 10, z: 0, size: 1 });
	}
	const expected = pairKeys(bruteCollisions(window));
	assert.ok(expected.length > 20);
	assert.deepEqual(pairsOf({ system: "bins" }), expected);
	// spheres of one size that stand on one ground
	for (const system of ["tightest", "combination"]) assert.deepEqual(pairsOf({ system }), expected);
	const boxes = pairsOf({ system: "hierarchical", depth: 1 });
	assert.ok(expected.every((pair) => boxes.includes(pair)) && boxes.length > expected.length);
	const exact = pairsOf({ system: "hierarchical", exact: true });
	assert.ok(exact.length < expected.length && exact.every((pair) => expected.includes(pair)));
	assert.deepEqual(pairsOf({ system: "bins", exact: false }), expected);
	playGame(window, 6, 10, check);
	// the option depth stays, and is nothing to these systems
	const warnings = warningsIn(() => {
		for (const system of ["tightest", "bins"]) pairsOf({ system, depth: 2 });
	});
	assert.deepEqual(warnings, []);
});

test("shapes are the client's models by their addresses, with transform files; spheres until they are there", async (context) => {
	const folder = fileURLToPath(new URL("../../bin/generated/nova-test", import.meta.url));
	rmSync(folder, { recursive: true, force: true });
	mkdirSync(folder, { recursive: true });
	copyFileSync(fileURLToPath(new URL("../../assets/bear.obj", import.meta.url)), path.join(folder, "bear.obj"));
	const slb = "rotate 90 0 30\ntranslate 0.4 0 0.2\n";
	writeFileSync(path.join(folder, "bear.slb"), slb);
	const server = await serve(null, { "": folder });
	context.after(() => server.close());

	const shape = `${server.url}bear.obj`;
	const game = two({ system: "tightest" }, { shape }, { shape: "Sphere" }, { shape: `${server.url}none.obj` }, { shape: "cube" });
	const { agents: [bear, ball, none, cube], installation } = game;
	none.state.x = 20;
	cube.state.x = -20;
	assert.equal(game.pairs(), 1);
	assert.ok(installation.areColliding(bear, ball) && !installation.areColliding(bear, none));
	const end = Date.now() + 300000;
	while (installation.pendingCount > 0 && Date.now() < end) await new Promise((resolve) => setTimeout(resolve, 10));
	assert.ok(installation.greatLand.hasModel(shape));
	assert.equal(installation.problems.length, 1);
	assert.match(installation.problems[0], /none\.obj/);

	const greatLand = new GreatLand();
	greatLand.addModel(new ObjModel("bear", asset("bear.obj"), ModelTransform.fromText(slb), Model.VOLUME));
	greatLand.addModel(BuiltInModel.sphere());
	const collider = new TightestFitCollider(greatLand);
	const [first, second] = [new Agent("bear"), new Agent("sphere")];
	const random = randomNumbers(3);
	let hits = 0;
	let departsFromSphere = 0;
	for (let i = 0; i < 400; i++) {
		bear.state.heading = first.heading = random() * 360;
		Object.assign(ball.state, { x: random() * 3 - 1.5, y: random() * 3 - 1.5, z: random() * 2 - 1 });
		second.moveTo(ball.state.x, ball.state.y, ball.state.z);
		const expected = collider.areColliding(first, second);
		assert.equal(game.pairs(), Number(expected));
		hits += Number(expected);
		departsFromSphere += Number(expected !== Math.hypot(ball.state.x, ball.state.y, ball.state.z) <= 1);
	}
	assert.ok(hits > 80 && hits < 320 && departsFromSphere > 20, `${hits} ${departsFromSphere}`);
});

test("traits of breeds and agents: what sweeps is not missed, what was set elsewhere has not moved there", () => {
	const game = two({ system: "tightest", breeds: { Fish: { sweeps: true } } }, { x: -5 }, { x: 0 });
	const [fast] = game.agents;
	assert.equal(game.pairs(), 0);
	const move = (x, before) => {
		fast.prevState.x = before;
		fast.state.x = x;
		game.Collisions.update(fast);
	};
	move(5, -5);
	assert.equal(game.pairs(), 1);
	move(-5, -5);
	assert.equal(game.pairs(), 0);
	game.installation.setTraits("Fish", null);
	move(5, -5);
	assert.equal(game.pairs(), 0);
	game.installation.setTraits(fast, { sweeps: true });
	move(-5, 5);
	assert.equal(game.pairs(), 1);
	// a question before a move does not end its way
	move(-5, -5);
	game.pairs();
	assert.equal(game.installation.areColliding(fast, game.agents[1]), false);
	move(5, -5);
	assert.equal(game.pairs(), 1);
	// nor do options beside the system
	for (const change of [(it) => it.setTraits("Shark", { depth: 2 }), (it) => it.exchange({}), (it) => it.exchange({ depth: 3, system: "tightest" })]) {
		move(-5, -5);
		assert.equal(game.pairs(), 0);
		move(5, -5);
		change(game.installation);
		assert.equal(game.pairs(), 1);
	}
});

test("models and structures may be given: a cube is as wide as a box, and its corners as far as a sphere", () => {
	const cube = new Model("block", BuiltInModel.cube().vertices, BuiltInModel.cube().triangles);
	const game = two({ system: "tightest", shapes: { Fisch: cube } }, { shape: "Fisch" }, { shape: "Fisch", x: 0.95, y: 0.95 });
	assert.equal(game.pairs(), 1);
	game.agents[1].state.x = 1.01;
	assert.equal(game.pairs(), 0);
	game.installation.setTraits("Fish", { structure: "sphere" });
	assert.equal(game.pairs(), 1);
	for (const shape of ["Cube", "Pyramid", "Triangle"]) {
		const built = two({ system: "hierarchical", exact: true }, { shape }, { shape, z: 0.2, y: 0.1 });
		assert.equal(built.pairs(), shape === "Triangle" ? 0 : 1);
		assert.ok(built.installation.greatLand.hasModel(shape));
	}
});

/** Gives a window a flat view seen from above, one pixel a patch; `strokes` has what was drawn last: ends of lines by colour. */
function giveView(window) {
	const strokes = new Map();
	let path = [];
	const context = {
		save() {},
		restore() {},
		beginPath: () => void (path = []),
		moveTo: (x, y) => void path.push([x, y]),
		lineTo: (x, y) => void path.push([x, y]),
		stroke: () => void strokes.set(context.strokeStyle, path),
	};
	const drawScene = () => strokes.clear();
	window.viewport = { context, drawScene, needsUpdate: false, camera: { nearDist: 0.1, projectPoint: (x, y, z) => [x, y, 100 - z] } };
	return { strokes, drawScene };
}

test("the overlay shows what collides where it collides, red what does, as long as it is on", () => {
	const cube = new Model("block", BuiltInModel.cube().vertices, BuiltInModel.cube().triangles);
	const game = two({ shapes: { Fisch: cube } }, { x: 0, shape: "Fisch" }, { x: 0.9, shape: "Fisch" }, { x: 9, y: 4, size: 3, shape: "Fisch", heading: 30 });
	const { installation, window } = game;
	assert.throws(() => installation.showOverlay(), /no view/);
	assert.throws(() => installInto(window, { overlay: true }), /no view/);
	assert.ok(installation.isInstalled && !installation.options.overlay);
	const { strokes, drawScene } = giveView(window);
	const { viewport } = window;
	installation.showOverlay();
	assert.ok(viewport.needsUpdate && viewport.drawScene !== drawScene);
	assert.equal(game.pairs(), 1);
	viewport.drawScene();
	const far = ([x, y], { state }) => Math.hypot(x - state.x, y - state.y);
	const [first, second, third] = game.agents;
	const [red, yellow] = ["#ff2020", "#ffcc00"].map((color) => strokes.get(color));
	assert.ok(red.length === yellow.length * 2 && yellow.length > 60);
	// of a sphere's three circles from above, one is the rim
	for (const end of red) assert.ok(Math.min(far(end, first), far(end, second)) < 0.5 + 1e-8);
	for (const end of yellow) assert.ok(far(end, third) < 1.5 + 1e-8);
	assert.ok(yellow.filter((end) => far(end, third) > 1.5 - 1e-8).length >= 60);

	// from the side: about its place, half of it in the ground
	const { projectPoint } = viewport.camera;
	viewport.camera.projectPoint = (x, y, z) => [x, z, 100];
	viewport.drawScene();
	const heights = strokes.get("#ffcc00").map(([, z]) => z);
	assert.ok(Math.abs(Math.min(...heights) + 1.5) < 1e-8 && Math.abs(Math.max(...heights) - 1.5) < 1e-8);
	viewport.camera.projectPoint = projectPoint;

	// corners of cubes, turned with their agents; edges of boxes and of triangles, which have diagonals too
	const corners = ({ state: { x, y, size, heading } }) => [45, 135, 225, 315].map((turn) => (turn + heading) * Math.PI / 180)
		.map((angle) => [x + Math.SQRT1_2 * size * Math.cos(angle), y + Math.SQRT1_2 * size * Math.sin(angle)]);
	for (const [options, lines] of [[{ system: "tightest" }, 12], [{ system: "hierarchical", depth: 1 }, 12], [{ system: "hierarchical", exact: true }, 18]]) {
		installation.exchange(options);
		assert.equal(game.pairs(), 1);
		viewport.drawScene();
		const ends = strokes.get("#ffcc00");
		// the cube's faces have corners of their own
		assert.ok(options.exact ? ends.length >= 2 * lines : ends.length === 2 * lines, `${ends.length}`);
		for (const end of ends) assert.ok(corners(third).some((corner) => Math.hypot(end[0] - corner[0], end[1] - corner[1]) < 1e-9));
		assert.equal(strokes.get("#ff2020").length, 2 * ends.length);
	}

	third.isDead = true;
	second.state.x = 5;
	game.Collisions.update(second);
	assert.equal(game.pairs(), 0);
	viewport.drawScene();
	assert.equal(strokes.get("#ff2020").length, 0);
	assert.ok(strokes.get("#ffcc00").every((end) => far(end, third) > 2));
	installation.showOverlay(false);
	assert.equal(viewport.drawScene, drawScene);
	installation.exchange({ overlay: true });
	installation.uninstall();
	assert.equal(viewport.drawScene, drawScene);
	installation.showOverlay();
	assert.equal(viewport.drawScene, drawScene);
});

test("blocks in the drawer set an agent's traits, which those that it makes have too, and do nothing while nothing is installed", () => {
	const game = two({ system: "tightest", shapes: { Fisch: new Model("block", BuiltInModel.cube().vertices, BuiltInModel.cube().triangles) } }, { shape: "Fisch" }, { shape: "Fisch", x: 0.95, y: 0.95 });
	const { window, agents, installation } = game;
	assert.throws(() => addBlocks(window), /no editor/);
	assert.throws(() => addButton(window), /no StarLogo Nova client with a toolbar/);
	const named = (name) => ({ spec: { name }, getName: () => name });
	const drawer = (...blocks) => ({
		blocks,
		getChildBlocks: () => [...blocks],
		getColor: () => "#999999",
		addBlock: (block) => void blocks.push(block),
		removeBlock: (block) => void blocks.splice(blocks.indexOf(block), 1),
	});
	const drawers = [drawer(named("agt-create")), drawer(named("collision"), named("count"))];
	const genusMap = {};
	window.sb = {
		Block: class {
			constructor(spec) {
				Object.assign(this, named(spec.name), { spec });
			}
		},
		WebLogoDemo: { workspace: { getDrawers: () => drawers } },
		ScriptBlocksJSON: { genusMap },
	};
	window.Compilation = { BlockTable: { table: new Map([["collision", Object]]) } };
	window.DataStructures = {
		ASTNode: class {
			constructor(count) {
				this.args = { data: new Array(count) };
			}
		},
	};
	const added = addBlocks(window);
	addBlocks(window).remove();
	const names = drawers[1].blocks.slice(2).map((block) => block.getName());
	assert.deepEqual(names.map((name) => name.replace("starlogo-collision-", "")), ["hierarchical", "depth", "sweeps", "structure"]);
	assert.deepEqual(Object.keys(genusMap), names);
	const value = (text) => ({ to_js_no_yield: () => text, to_js_setup: () => "", to_js_final: () => text });
	const run = (agent, trait, text, yields = false) => {
		const node = new (window.Compilation.BlockTable.table.get(`starlogo-collision-${trait}`))();
		node.args.data[0] = value(text);
		const code = yields ? `${node.to_js_setup()} ${node.to_js_final()}` : node.to_js_no_yield();
		new Function("Execution", "__wl_agt", code)(window.Execution, agent);
	};

	assert.equal(game.pairs(), 1);
	agents[1].state.x = 1.01;
	assert.equal(game.pairs(), 0);
	run(agents[0], "structure", '"sphere"');
	run(agents[1], "structure", '"sphere"', true);
	assert.equal(game.pairs(), 1);
	run(agents[0], "depth", "\"3.4\"");
	run(agents[0], "depth", '"none"');
	run(agents[0], "hierarchical", '"true"');
	assert.equal(game.pairs(), 1);
	for (const agent of agents) run(agent, "structure", '"box"');
	assert.equal(game.pairs(), 0);
	for (const agent of agents) run(agent, "structure", '"sphere"');
	// what it makes is a sphere too; one that nobody made is not
	const child = hatch(window, "Fish", { shape: "Fisch", x: 2.51, y: 0.95 });
	child.parent = agents[1];
	game.Collisions.add(child);
	assert.equal(game.pairs(), 2);
	const other = hatch(window, "Fish", { shape: "Fisch", x: 4.01, y: 0.95 });
	game.Collisions.add(other);
	assert.equal(game.pairs(), 2);
	run(other, "sweeps", '"true"');
	Object.assign(other.state, { x: -9, y: 0.5 });
	other.prevState.x = 4.01;
	game.Collisions.update(other);
	assert.equal(game.pairs(), 5);
	installation.uninstall();
	run(agents[0], "structure", '"box"');
	added.remove();
	assert.equal(drawers[1].blocks.length, 2);
});

test("what the types declare is what is there", async () => {
	const declared = readFileSync(new URL("../../bin/module/nova/index.d.ts", import.meta.url), "utf8");
	const exported = await import("../../bin/module/nova/index.js");
	assert.deepEqual([...declared.matchAll(/^export function (\w+)/gm)].map(([, name]) => name).sort(), Object.keys(exported).sort());
	const [, members] = /^export interface NovaInstallation \{([^]*?)\n\}$/m.exec(declared);
	const names = [...members.matchAll(/^ {4}(?:readonly )?(\w+)[:(]/gm)].map(([, name]) => name);
	assert.deepEqual(names.sort(), Object.getOwnPropertyNames(Object.getPrototypeOf(installInto(makeWindow()))).filter((name) => name !== "constructor").sort());
	const [, traits] = /^export interface NovaTraits \{([^]*?)\n\}$/m.exec(declared);
	const installation = installInto(makeWindow());
	for (const [, name] of traits.matchAll(/^ {4}(\w+)\?:/gm)) assert.throws(() => installation.setTraits("Fish", { [name]: undefined, wrong: 1 }), new RegExp(`${name}.*not wrong`));
});

test("nova.js is a classic script, with one global that does the same", () => {
	const context = vm.createContext({ console, performance, setTimeout, clearTimeout, queueMicrotask });
	vm.runInContext(readFileSync(new URL("../../bin/module/nova.js", import.meta.url), "utf8"), context);
	assert.deepEqual(Object.keys(context.StarLogoCollision).sort(), ["addBlocks", "addButton", "installInto", "toggle"]);
	const window = makeWindow();
	context.StarLogoCollision.installInto(window);
	const { check, seen } = checker();
	playGame(window, 1, 25, check, { spread: 10 });
	assert.ok(seen.pairs > 3 && window.Execution.Collisions.calls === 0, JSON.stringify(seen));
});
