#!/usr/bin/env node
/**
 * Times the ES module in Node beside other engines, and what only the module has: bindings, snapshots' bytes, memory. The benchmarks that players run
 * too are those of in-node.mjs.
 *
 *   node test/benchmark/module.mjs [PART ...]      parts: memory, cold, exact, distances, rays, peers, boxes, queries, bindings, snapshots,
 *                                                         ground, level
 *
 * A number is what the faster tenth of many frames took at most, after as many to warm up: whatever else the machine does only slows.
 * It is the time of the processors, of all threads of this process, so that other programs count as little as possible.
 * One row's numbers are taken in turns.
 */
import { execFileSync } from "node:child_process";
import { copyFileSync, symlinkSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { install } from "../adapters/peers.mjs";
import { makeBvh, rayModels } from "./rays.mjs";
import { HALF_WIDTH, SYSTEMS, asset, engine, makeGreatLand, randomNumbers, scatter } from "./games.mjs";

const { Agent, AgentFilter, AgentQueries, BinCollider, ColladaModel, GreatLand, HierarchicalCollider, ObjModel, TightestFitCollider } = engine;

const COUNTS = [1000, 10000, 100000];

const parts = process.argv.slice(2);
const greatLand = makeGreatLand();

function fastTenth(values) {
	const sorted = [...values].sort((a, b) => a - b);
	return sorted[Math.floor(sorted.length / 10)];
}

/** Milliseconds of the processors that this process has used. */
function processorTime() {
	const { user, system } = process.cpuUsage();
	return (user + system) / 1000;
}

/** Milliseconds that each of some tasks takes: the tasks in turns, each with what prepares it untimed. */
function measure(tasks, rounds) {
	const times = tasks.map(() => []);
	for (let round = 0; round < 2 * rounds; round++) {
		tasks.forEach(({ prepare, run }, i) => {
			prepare?.(round);
			const start = processorTime();
			run();
			const time = processorTime() - start;
			if (round >= rounds) times[i].push(time);
		});
	}
	return times.map(fastTenth);
}

function print(title, head, rows) {
	const textOf = (cell) => (typeof cell !== "number" ? String(cell) : cell >= 1000 ? Math.round(cell).toLocaleString("en") : cell.toPrecision(3));
	const cells = [head, ...rows.map((row) => row.map(textOf))];
	const widths = head.map((_, column) => Math.max(...cells.map((row) => row[column].length)));
	console.log(`\n${title}\n${cells.map((row) => `  ${row.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join("  ")}`).join("\n")}`);
}

/** What a measure of fresh.mjs comes to in a process of its own. */
function fresh(measure, system, ...flags) {
	const file = fileURLToPath(new URL("fresh.mjs", import.meta.url));
	return Number(execFileSync(process.execPath, [...flags, file, measure, system], { encoding: "utf8" }));
}

/** What colliders keep, and what their frames leave for the collector, with room for all of that. */
function memory() {
	const room = ["--min-semi-space-size=256", "--max-semi-space-size=256"];
	const rows = Object.keys(SYSTEMS).map((system) => [
		system,
		String(Math.round(fresh("kept", system, "--expose-gc"))),
		String(Math.round(fresh("garbage", system, "--expose-gc", ...room))),
	]);
	print("10,000 scattered, all moving, bytes", ["", "kept for an agent", "garbage of a frame"], rows);
}

/** The first frame of a game, nothing compiled: each in a process of its own. */
function cold() {
	const rows = Object.keys(SYSTEMS).map((system) => {
		const times = Array.from({ length: 5 }, () => fresh("first", system)).sort((a, b) => a - b);
		return [system, times[2], times[0], times[4]];
	});
	print("The first frame of 10,000 new agents, ms", ["", "median of 5", "least", "most"], rows);
}

/** The same pairs of dragons for the exact test, for three-mesh-bvh and for Rapier. */
async function exact() {
	const { makeRapierMeshes } = await import("./peers.mjs");
	const dragon = new ColladaModel("dragon", asset("dragon.dae"));
	greatLand.addModel(dragon);
	const { three, geometry, bvh } = makeBvh(dragon);
	const inRapier = makeRapierMeshes(dragon);
	const treeless = geometry.clone();
	treeless.boundsTree = undefined;
	const random = randomNumbers(7);
	const collider = new HierarchicalCollider(greatLand);
	collider.exact = true;
	const pairs = Array.from({ length: 400 }, () => {
		const a = new Agent("dragon");
		const b = new Agent("dragon");
		b.heading = 360 * random();
		b.pitch = 360 * random();
		b.roll = 360 * random();
		b.moveTo(1.2 * random() - 0.6, 1.2 * random() - 0.6, 0.4 * random() - 0.2);
		return { a, b, turn: b.getQuaternion(), matrix: new three.Matrix4().fromArray(b.transform.rawData) };
	});
	const ask = {
		engine: ({ a, b }) => collider.areColliding(a, b),
		bvhcast: ({ matrix }) => bvh.bvhcast(bvh, matrix, { intersectsTriangles: (one, other) => one.intersectsTriangle(other) }),
		intersectsGeometry: ({ matrix }) => bvh.intersectsGeometry(geometry, matrix),
		rapier: ({ b, turn }) => inRapier(b, turn),
	};
	const [isHit, ...others] = Object.values(ask).map((test) => pairs.map(test));
	const same = others.map((verdicts) => verdicts.filter((verdict, i) => verdict === isHit[i]).length);
	const rows = [true, false].map((wanted) => {
		const chosen = pairs.filter((_, i) => isHit[i] === wanted && others.every((verdicts) => verdicts[i] === wanted));
		const jump = () => chosen.forEach(({ b }) => b.jumpTo(b.x, b.y, b.z));
		const times = measure(Object.values(ask).map((test) => ({ prepare: jump, run: () => chosen.forEach(test) })), 10).map((ms) => 1000 * ms / chosen.length);
		// 60,000 times as long as the engine: three pairs say enough
		const start = processorTime();
		chosen.slice(0, 3).forEach(({ matrix }) => bvh.intersectsGeometry(treeless, matrix));
		const slow = 1000 * (processorTime() - start) / 3;
		return [wanted ? "touching" : "not touching", String(chosen.length), ...times, slow, ...times.slice(1).map((time) => time / times[0]), slow / times[0]];
	});
	const head = ["", "pairs", "engine", "bvhcast", "intersectsGeometry", "Rapier", "no second tree", "times", "times", "times", "times"];
	print(`Two dragons of ${dragon.triangles.length / 3} triangles, exact, microseconds a pair. bvhcast and intersectsGeometry are three-mesh-bvh's, with a tree ` +
		`on both geometries; the last without one on the second. Of ${pairs.length} verdicts the same as the engine's: ${same.join(", ")}`, head, rows);
}

/** How far dragons are apart, and bears: by the engine, all of a question, and by three-mesh-bvh with a tree on both geometries. */
function distances() {
	const { Vector3D } = engine;
	const models = [new ObjModel("bear", asset("bear.obj")), new ColladaModel("dragon", asset("dragon.dae"))];
	const rows = models.flatMap((model) => [1.5, 20].map((spread) => {
		greatLand.addModel(model);
		const { three, geometry, bvh } = makeBvh(model);
		const exactly = new HierarchicalCollider(greatLand);
		exactly.exact = true;
		const random = randomNumbers(11);
		const pairs = Array.from({ length: 300 }, () => {
			const a = new Agent(model.name);
			const b = new Agent(model.name);
			[b.heading, b.pitch, b.roll] = [360 * random(), 360 * random(), 360 * random()];
			b.moveTo(spread * (2 * random() - 1), spread * (2 * random() - 1), spread * (2 * random() - 1));
			return { a, b, matrix: new three.Matrix4().fromArray(b.transform.rawData) };
		}).filter(({ a, b }) => !exactly.areColliding(a, b)).slice(0, 12);
		const [point, pointB] = [new Vector3D(), new Vector3D()];
		const target = [{}, {}];
		const ask = (queries) => ({ run: () => pairs.forEach(({ a, b }) => queries.distance(a, b, point, pointB)) });
		const [trees, own, other] = measure([
			ask(new AgentQueries(new HierarchicalCollider(greatLand))),
			ask(new AgentQueries(exactly)),
			{ run: () => pairs.forEach(({ matrix }) => bvh.closestPointToGeometry(geometry, matrix, ...target)) },
		], 2);
		const queries = new AgentQueries(exactly);
		const worst = Math.max(...pairs.map(({ a, b, matrix }) => {
			const distance = queries.distance(a, b);
			return Math.abs(distance - bvh.closestPointToGeometry(geometry, matrix, ...target).distance) / (1 + distance);
		}));
		return [`${model.name}s up to ${spread} away`, ...[trees, own, other].map((ms) => 1000 * ms / pairs.length), other / own, worst];
	}));
	print("Distances, microseconds a pair", ["", "at depth 5", "exact", "three-mesh-bvh", "times", "apart at most"], rows);
}

/** First hits of rays at one model, and what is kept for them. */
async function rays() {
	const { b3, makeBox3dMesh, makeCrashcatMesh } = await import("./peers.mjs");
	const rows = [];
	for (const model of rayModels(1000, 200)) {
		const land = new GreatLand();
		land.loadTightestFit = false;
		land.addModel(model);
		const { three, bvh, ms } = makeBvh(model, Float64Array);
		const casts = [makeCrashcatMesh(model), ...(b3 ? [makeBox3dMesh(model)] : [])];
		const agent = new Agent(model.name);
		const collider = new HierarchicalCollider(land);
		collider.exact = true;
		const queries = new engine.AgentQueries(collider);
		queries.update([agent]);
		const random = randomNumbers(7);
		const aimed = Array.from({ length: 20000 }, () => {
			const [angle, height] = [2 * Math.PI * random(), 2 * random() - 1];
			const flat = 2 * Math.sqrt(1 - height * height);
			const origin = new engine.Vector3D(flat * Math.cos(angle), flat * Math.sin(angle), 0.4 + 2 * height);
			const direction = new engine.Vector3D(random() - 0.5 - origin.x, random() - 0.5 - origin.y, 0.7 * random() - origin.z);
			const ray = new three.Ray(new three.Vector3().copy(origin), new three.Vector3().copy(direction).normalize());
			return { origin, direction, ray };
		});
		const hit = new engine.RayHit();
		const [found, expected] = [[], []];
		aimed.forEach(({ origin, direction }, i) => { found[i] = queries.cast(origin, direction)?.distance ?? Infinity; });
		aimed.forEach(({ ray }, i) => { expected[i] = bvh.raycastFirst(ray, three.DoubleSide)?.distance ?? Infinity; });
		const same = found.filter((distance, i) => distance === expected[i] || Math.abs(distance - expected[i]) < 1e-6).length;
		// Box3D has single precision
		const sameInOthers = casts.map((cast, other) => aimed.filter(({ ray }, i) => {
			const distance = cast(ray.origin, ray.direction, 10);
			return found[i] === distance || Math.abs(found[i] - distance) < (other === 0 ? 1e-6 : 1e-4);
		}).length);
		const times = measure([
			{ run: () => aimed.forEach(({ origin, direction }) => queries.cast(origin, direction, Infinity, null, hit)) },
			{ run: () => aimed.forEach(({ ray }) => bvh.raycastFirst(ray, three.DoubleSide)) },
			...casts.map((cast) => ({ run: () => aimed.forEach(({ ray }) => cast(ray.origin, ray.direction, 10)) })),
		], 10).map((each) => 1000 * each / aimed.length);
		const [own, ...others] = times;
		rows.push([model.name, String(model.triangles.length / 3), ...times, ...others.map((other) => other / own), ms, String(same), ...sameInOthers.map(String)]);
	}
	const names = ["three-mesh-bvh", "crashcat", ...(b3 ? ["Box3D"] : [])];
	const head = ["", "triangles", "engine", ...names, ...names.map(() => "times"), "three-mesh-bvh's tree, ms", ...names.map((name) => `${name}'s hits the same`)];
	print("First hits of 20,000 rays, exact, microseconds a ray", head, rows);
}

/**
 * A row of what takes how long to find all pairs that touch: the engine's own tasks, the other engines (null if it cannot), how many times as long as
 * the first each of these takes, and the pairs that each has found.
 */
function pairsRow(count, own, others, rounds, out) {
	const able = others.filter(Boolean);
	const times = measure([...own, ...able], rounds);
	const theirs = others.map((each) => (each ? times[own.length + able.indexOf(each)] : null));
	const pairs = [out.length / 2, ...able.map((each) => each.count())];
	for (const each of able) each.free?.();
	const cells = [...times.slice(0, own.length), ...theirs, ...theirs.map((time) => time && time / times[0])];
	return [count.toLocaleString("en"), ...cells.map((cell) => cell ?? "-"), pairs.every((each) => each === pairs[0]) ? String(pairs[0]) : `DIFFER: ${pairs.join()}`];
}

/** Spheres that move, all at once: who touches whom. */
async function peers() {
	const { askBox3d, askCannon, askCrashcat, askKdbush, askRapier, b3 } = await import("./peers.mjs");
	const rows = COUNTS.map((count) => {
		// as dense as 10,000 on SpaceLand
		const halfWidth = HALF_WIDTH * Math.sqrt(Math.max(1, count / 10000));
		const { agents, walk } = scatter(count, ["sphere"], { halfWidth });
		const [bins, fits] = [new BinCollider(greatLand), new TightestFitCollider(greatLand)];
		const out = [];
		const isLarge = count > 10000;
		const own = [
			{ prepare: walk, run: () => bins.findCollisions(agents, out) },
			{ run: () => fits.findCollisions(agents, out), prepare: () => agents.forEach((agent) => agent.moveTo(agent.x + 1e-9, agent.y, 0)) },
		];
		const others = [askKdbush(agents), askRapier(agents), askCrashcat(agents), isLarge ? null : askCannon(agents), ...(b3 ? [askBox3d(agents)] : [])];
		return pairsRow(count, own, others, isLarge ? 3 : 20, out);
	});
	const names = ["kdbush (2D, built anew)", "Rapier (WebAssembly)", "crashcat", "cannon-es", ...(b3 ? ["Box3D (WebAssembly)"] : [])];
	const head = ["spheres, all moving, ms a frame", "bins", "tightest fit", ...names, ...names.map(() => "times"), "pairs"];
	print("Beside other engines", head, rows);
}

/** Cubes that move, each turned another way, as dense as the spheres: who touches whom. */
async function boxes() {
	const { askBox3d, askCrashcat, askRapier, b3 } = await import("./peers.mjs");
	const rows = COUNTS.slice(0, 2).map((count) => {
		const { agents, walk } = scatter(count, ["cube"]);
		const fits = new TightestFitCollider(greatLand);
		const out = [];
		const others = [askRapier(agents), askCrashcat(agents), ...(b3 ? [askBox3d(agents)] : [])];
		return pairsRow(count, [{ prepare: walk, run: () => fits.findCollisions(agents, out) }], others, 20, out);
	});
	const names = ["Rapier (WebAssembly)", "crashcat", ...(b3 ? ["Box3D (WebAssembly)"] : [])];
	print("Cubes beside other engines", ["cubes, all moving, ms a frame", "tightest fit", ...names, ...names.map(() => "times"), "pairs"], rows);
}

/** Questions of each of 10,000 agents that all move, with the update, against a kd-tree that is made anew in every frame. */
async function queries() {
	const { KDBush } = await import("./peers.mjs");
	const { agents, walk } = scatter(10000, ["sphere"]);
	const asked = new AgentQueries(new TightestFitCollider(greatLand));
	let tree;
	let sum = 0;
	const build = () => {
		tree = new KDBush(agents.length);
		for (const agent of agents) tree.add(agent.x, agent.y);
		tree.finish();
	};
	// it knows no nearest: all within a radius that grows until there is one besides the agent itself
	const nearest = (agent, i) => {
		for (let radius = 1; ; radius *= 2) {
			let least = Infinity;
			let found = -1;
			for (const other of tree.within(agent.x, agent.y, radius)) {
				const square = (agents[other].x - agent.x) ** 2 + (agents[other].y - agent.y) ** 2;
				if (other !== i && square < least) {
					least = square;
					found = other;
				}
			}
			if (found >= 0) return found;
		}
	};
	asked.update(agents);
	build();
	const same = agents.filter((agent, i) => asked.nearest(agent) === agents[nearest(agent, i)]).length;
	const rows = [
		["nearest", () => agents.forEach((agent) => asked.nearest(agent)), () => agents.forEach(nearest)],
		["countNear 5", () => agents.forEach((agent) => (sum += asked.countNear(agent, 5))), () => agents.forEach((agent) => (sum += tree.within(agent.x, agent.y, 5).length))],
		["the update and one question", () => asked.nearest(agents[0]), () => nearest(agents[0], 0)],
	].map(([name, ask, askTree]) => {
		const [own, other] = measure([
			{ prepare: walk, run: () => { asked.update(agents); ask(); } },
			{ prepare: walk, run: () => { build(); askTree(); } },
		], 30);
		return [name, 1000 * own / agents.length, 1000 * other / agents.length, other / own];
	});
	const wolves = AgentFilter.ofBreeds("wolves");
	for (const count of [3000, 100000]) {
		const { agents: flock } = scatter(count, ["sphere"]);
		for (const agent of flock) agent.breed = "sheep";
		const wolf = new Agent("sphere", "wolves");
		wolf.moveTo(2 * Math.sqrt(count), 3 * Math.sqrt(count), 0);
		const all = [...flock, wolf];
		const nearestIn = (list, agent) => {
			let found = null;
			let least = Infinity;
			for (const other of list) {
				const square = (other.x - agent.x) ** 2 + (other.y - agent.y) ** 2;
				if (square < least) [found, least] = [other, square];
			}
			return found;
		};
		const [own, other] = measure([
			{ prepare: () => {}, run: () => { asked.update(all); for (const agent of flock) asked.nearest(agent, Infinity, wolves); } },
			{ prepare: () => {}, run: () => { const list = all.filter(({ breed }) => breed === "wolves"); for (const agent of flock) nearestIn(list, agent); } },
		], 10);
		rows.push([`the one wolf of ${count} sheep, beside a list of wolves`, 1000 * own / count, 1000 * other / count, other / own]);
	}
	print(`Questions, all moving, microseconds an agent (${same} nearest the same)`, ["", "engine", "kdbush", "times"], rows);
}

/** Agents bound to three.js's objects: each frame what moves them, untimed, and then the bindings. */
async function bindings() {
	const entry = join(install("benchmark"), "entry.mjs");
	writeFileSync(entry, 'export * as three from "three";\nexport { Agent } from "starlogo-collision";\nexport * from "starlogo-collision/three";\n');
	const { three, Agent: Bound, ThreeAgentBinding, bindInstance, modelFromObject } = await import(pathToFileURL(entry));
	const geometry = new three.BoxGeometry(1, 2, 3);
	const model = modelFromObject("box", geometry);
	const mesh = new three.InstancedMesh(geometry, new three.MeshBasicMaterial(), 1000);
	const random = randomNumbers(3);
	const bind = (make) => Array.from({ length: 1000 }, (_, i) => {
		const agent = new Bound("box");
		agent.moveTo(random(), random(), random());
		agent.heading = 360 * random();
		const binding = make(agent, i);
		binding.updateObject();
		return binding;
	});
	const kinds = { objects: bind((agent) => new ThreeAgentBinding(agent, new three.Object3D(), model)), instances: bind((agent, i) => bindInstance(agent, mesh, i, model)) };
	const taken = [];
	// what moves the agents, and what moves the objects
	const motions = {
		"none moving": [() => {}, () => {}],
		"all moving": [
			({ agent }, round) => agent.moveTo(round % 40, agent.y, agent.z),
			({ object }, round) => { object.position.x = -round % 40; },
		],
		"all moving and turning": [
			({ agent }, round) => {
				agent.moveTo(round % 40, agent.y, agent.z);
				agent.heading = round % 360;
				// as it is after the frame of a collider
				agent.getQuaternion(taken);
			},
			({ object }, round) => {
				object.position.x = -round % 40;
				object.rotation.y = 1 + (round % 360) / 100;
			},
		],
	};
	// what no binding can do without
	const alone = Array.from({ length: 1000 }, () => new three.Object3D());
	const turns = Array.from({ length: 360 }, (_, i) => new three.Quaternion(0, Math.sin(i), 0, Math.cos(i)));
	let count = 0;
	const place = (object, name) => {
		if (name === "none moving") return;
		object.position.set(count++, 2, 3);
		object.scale.set(2, 2, 2);
		if (name === "all moving and turning") object.quaternion.copy(turns[count % 360]);
	};
	const rows = Object.entries(motions).map(([name, [moveAgent, moveObject]]) => {
		const task = (all, move, update) => ({ prepare: (round) => all.forEach((binding) => move(binding, round)), run: () => all.forEach(update) });
		const times = measure([
			{ run: () => alone.forEach((object) => place(object, name)) },
			task(kinds.objects, moveAgent, (each) => each.updateObject()),
			task(kinds.objects, moveObject, (each) => each.updateAgent()),
			task(kinds.instances, moveAgent, (each) => each.updateObject()),
		], 200);
		return [name, ...times];
	});
	print(`1,000 agents bound to three.js ${three.REVISION}, ms a frame`, ["", "three.js alone", "updateObject", "updateAgent", "updateObject of instances"], rows);
}

/** What a snapshot of a game takes, and going back to it. */
function snapshots() {
	const { agents, walk } = scatter(10000, ["sphere"]);
	const rows = [false, true].map((hasEnds) => {
		const collision = new engine.Collision(new TightestFitCollider(greatLand));
		collision.onCollision("turtles", "turtles", () => {});
		if (hasEnds) collision.onCollisionEnd("turtles", "turtles", () => {});
		walk();
		collision.update(agents);
		let bytes = collision.snapshot();
		const [take, back] = measure([
			{ run: () => { bytes = collision.snapshot(); } },
			{ run: () => collision.restore(bytes, agents) },
		], 100);
		return [hasEnds ? "with starts and ends" : "collisions alone", take, back, bytes.length];
	});
	print("Snapshots of 10,000 agents, ms", ["", "snapshot", "restore", "bytes"], rows);
}

/** How each gets from the example's level, as three.js has read it, to a first ray, each time in a process of its own: by its name, the least of nine. */
function freshLevels(names) {
	const folder = install("benchmark-level");
	symlinkSync(fileURLToPath(new URL("../../js/module/node_modules/three-mesh-bvh", import.meta.url)), join(folder, "node_modules/three-mesh-bvh"));
	copyFileSync(new URL("fresh-level.mjs", import.meta.url), join(folder, "fresh-level.mjs"));
	const file = fileURLToPath(new URL("../../examples/level/level.glb", import.meta.url));
	const run = (name) => JSON.parse(execFileSync(process.execPath, [join(folder, "fresh-level.mjs"), name, file], { encoding: "utf8" }));
	const runs = Array.from({ length: 9 }, () => names.map(run));
	for (const all of runs) if (all.some(({ distance }) => Math.abs(distance - all[0].distance) > 1e-4)) throw new Error("the first rays differ");
	return Object.fromEntries(names.map((name, i) => [name, Math.min(...runs.map((all) => all[i].ms))]));
}

/** The level of the example, one mesh, beside other engines: preparing it, rays, a camera's sphere, a capsule that walks. */
async function level() {
	const { ENGINES, readLevel } = await import("./levels.mjs");
	const mesh = readLevel();
	const random = randomNumbers(51);
	const between = (from, to) => from + (to - from) * random();
	const names = Object.keys(ENGINES);
	const levels = names.map((name) => ENGINES[name](mesh));
	const aimed = Array.from({ length: 8000 }, () => {
		const [angle, rise] = [between(0, 2 * Math.PI), between(-0.3, 0.3)];
		const flat = Math.sqrt(1 - rise * rise);
		return { from: [between(-35, 35), between(-35, 35), between(2, 5)], to: [flat * Math.cos(angle), flat * Math.sin(angle), rise] };
	}).filter(({ from }) => levels[0].isFree(from));
	const starts = Array.from({ length: 20 }, (_, i) => [22 * Math.cos(2.4 * i) * Math.sqrt(i / 20), 22 * Math.sin(2.4 * i) * Math.sqrt(i / 20), 6]);
	const prepare = (name) => ENGINES[name](mesh).ray([0, 0, 5], [0, 0, -1], 100);
	const atFirst = freshLevels(["engine", "three-mesh-bvh"]);
	const preparing = measure(names.map((name) => ({ run: () => prepare(name) })), 5);
	const distances = levels.map(({ ray }) => aimed.map(({ from, to }) => ray(from, to, 60)));
	const rays = measure(levels.map(({ ray }) => ({ run: () => aimed.forEach(({ from, to }) => ray(from, to, 60)) })), 5);
	const ways = aimed.map(({ to }) => to.map((value) => 6 * value));
	const [cameras, pills] = [({ sphere }) => sphere && ((from, way) => sphere(from, 0.25, way)), ({ capsule }) => capsule].map((castOf) => {
		const able = levels.map(castOf).map((cast) => cast && (() => aimed.map(({ from }, i) => cast(from, ways[i]))));
		const times = measure(able.filter(Boolean).map((run) => ({ run })), 5);
		return able.map((run) => run && { ms: times.shift(), found: run() });
	});
	const walks = levels.map(({ walker }) => {
		if (!walker) return null;
		const walkers = starts.map(walker);
		let frame = 0;
		const stride = () => walkers.forEach((each, i) => each.walk(0.06 * Math.cos(i + frame / 90), 0.06 * Math.sin(i + frame / 90)));
		const [ms] = measure([{ prepare: () => frame++, run: stride }], 300);
		return { ms, fell: walkers.filter(({ place }) => place[2] < -6).length };
	});
	const near = (one, other) => one === other || Math.abs(one - other) < 1e-3 * (1 + Math.abs(one));
	print(`A level of ${mesh.triangles.length / 3} triangles`, ["", ...names], [
		["from three.js to a first ray, in a fresh process, ms", ...names.map((name) => atFirst[name] ?? "-")],
		["the same again, from arrays, ms", ...preparing],
		["a ray, microseconds", ...rays.map((ms) => 1000 * ms / aimed.length)],
		["a sphere's cast, microseconds", ...cameras.map((casts) => (casts ? 1000 * casts.ms / aimed.length : "-"))],
		["a capsule's cast, microseconds", ...pills.map((casts) => (casts ? 1000 * casts.ms / aimed.length : "-"))],
		["a capsule's walk, microseconds", ...walks.map((walk) => (walk ? 1000 * walk.ms / starts.length : "-"))],
		[`of ${aimed.length} rays the same`, ...distances.map((all) => all.filter((value, i) => near(value, distances[0][i])).length)],
		["a sphere's casts the same", ...cameras.map((casts) => (casts ? casts.found.filter((value, i) => near(value, cameras[0].found[i])).length : "-"))],
		["a capsule's casts the same", ...pills.map((casts) => (casts ? casts.found.filter((value, i) => near(value, pills[0].found[i])).length : "-"))],
		["fell through", ...walks.map((walk) => (walk ? walk.fell : "-"))],
	]);
}

/** Frames on a ground of a million cells; a hill that rises; rays across it, beside three-mesh-bvh on the same triangles. */
function ground() {
	const cells = 1000;
	const terrain = new engine.Terrain(cells + 1, cells + 1, 1, -cells / 2, -cells / 2);
	const fine = new engine.Terrain(cells + 1, cells + 1, 0.1, -HALF_WIDTH, -HALF_WIDTH);
	const heights = Array.from({ length: (cells + 1) ** 2 }, (_, i) => 3 * Math.sin(i % (cells + 1) / 17) + 2 * Math.cos(Math.floor(i / (cells + 1)) / 11));
	terrain.setHeights(0, 0, cells + 1, cells + 1, heights);
	fine.setHeights(0, 0, cells + 1, cells + 1, heights.map((height) => height / 10));
	const random = randomNumbers(38);
	const systems = Object.entries(SYSTEMS);
	const frames = systems.flatMap(([name, System]) => [[terrain, HALF_WIDTH], [terrain, cells / 2 - 1], [fine, HALF_WIDTH - 1]].map(([on, half]) => {
		const agents = Array.from({ length: 10000 }, () => new Agent("sphere"));
		const prepare = () => agents.forEach((agent) => {
			const [x, y] = [half * (2 * random() - 1), half * (2 * random() - 1)];
			agent.moveTo(x, y, on.heightAt(x, y) + 0.5 * random() - 0.1);
		});
		const tasks = [false, true].map((isOnGround) => {
			const collision = new engine.Collision(new System(greatLand));
			collision.onCollision("turtles", "turtles", () => {});
			if (isOnGround) {
				collision.terrain = on;
				collision.onCollision("turtles", engine.Collision.TERRAIN, () => {});
			}
			return { run: () => collision.update(agents) };
		});
		const [without, with_] = measure([{ prepare, run: tasks[0].run }, tasks[1]], 40);
		return [`${name}, ${2 * half} patches wide, cells of ${on.cellWidth}`, without, with_, with_ / without];
	}));
	print("10,000 spheres on 1,000 by 1,000 cells, ms a frame", ["", "without ground", "with", "ratio"], frames);
	const [mound] = measure([{ run: () => terrain.raiseMound(0, 0, 100, 0.001) }], 100);
	print("A mound of 100 by 100 cells", ["ms"], [[mound]]);

	const vertices = heights.flatMap((height, i) => [i % (cells + 1) - cells / 2, Math.floor(i / (cells + 1)) - cells / 2, height]);
	const triangles = [];
	for (let row = 0; row < cells; row++) {
		for (let column = 0; column < cells; column++) {
			const corner = row * (cells + 1) + column;
			triangles.push(corner, corner + 1, corner + cells + 2, corner, corner + cells + 2, corner + cells + 1);
		}
	}
	const { three, bvh } = makeBvh({ vertices, triangles });
	const queries = new AgentQueries(new BinCollider());
	queries.terrain = terrain;
	queries.update([]);
	terrain.raiseMound(0, 0, 100, -0.2);
	const rays = [["over it", 7], ["through the tops", 4.5], ["among the hills", 2]].map(([name, height]) => {
		const origins = Array.from({ length: 1000 }, () => [-cells / 2 + 1, 480 * (2 * random() - 1), height]);
		const directions = origins.map(() => [1, random() - 0.5, 0.001 * (random() - 0.5)]);
		const own = origins.map((origin, i) => [new engine.Vector3D(...origin), new engine.Vector3D(...directions[i])]);
		const its = origins.map((origin, i) => new three.Ray(new three.Vector3(...origin), new three.Vector3(...directions[i]).normalize()));
		const hit = new engine.RayHit();
		let [hits, bvhHits] = [0, 0];
		const [ours, theirs] = measure([
			{ run: () => { hits = own.filter(([origin, direction]) => queries.cast(origin, direction, 2 * cells, null, hit) !== null).length; } },
			{ run: () => { bvhHits = its.filter((ray) => bvh.raycastFirst(ray, three.DoubleSide) !== null).length; } },
		], 10);
		return [name, ours, theirs, ours / theirs, hits, bvhHits];
	});
	print("Rays across the ground, microseconds", ["", "engine", "three-mesh-bvh", "ratio", "hits", "its hits"], rays);
}

console.log(`the ES module in Node ${process.versions.node}`);
for (const part of [memory, cold, exact, distances, rays, peers, boxes, queries, bindings, snapshots, ground, level]) if (parts.length === 0 || parts.includes(part.name)) await part();
