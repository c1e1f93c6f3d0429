/** The page of calls: what it says that a frame, a question, a walk and a model pass is what runs, as V8 counts it. Checks starlogo.collision. */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { beginCoverage } from "../runner/coverage.mjs";

const at = (file) => fileURLToPath(new URL(`../../${file}`, import.meta.url));
// readable; see engine.mjs
const engine = path.resolve(process.env.ENGINE || at("bin/module/starlogo-collision.js"));
const {
	Agent, AgentFilter, AgentQueries, BuiltInModel, ColladaModel, Collision, CombinationCollider, CookedModel, GltfModel, GreatLand, ObjModel, Terrain,
	TightestFitCollider,
} = await import(pathToFileURL(engine));
const code = readFileSync(engine, "utf8");
const sections = readFileSync(at("docs/calls.md"), "utf8").split("\n## ");
const section = (title) => sections.find((text) => text.startsWith(title + "\n"));
const namesIn = (text) => [...new Set([...text.matchAll(/`([A-Z]\w+)/g)].map(([, name]) => name))];

/** The classes of some rooms, with their folders. */
const classesOf = (...rooms) => new Set(rooms.flatMap((room) => readdirSync(at(`src/starlogo/${room}`), { recursive: true }))
	.filter((file) => file.endsWith(".as")).map((file) => file.split(/[\\/]/).pop().slice(0, -3)));
const FRAME = classesOf("agents", "broadphase", "search", "handlers", "collision");
const QUERIES = classesOf("queries");

// a class's static methods are functions behind it: Name$method
const parts = [...code.matchAll(/^(?:(?:const \w+ = .*)?class (\w+)|function ([A-Z][a-zA-Z\d]*)\$)/gm)]
	.map(({ 1: ofClass, 2: ofFunction, index }) => ({ name: ofClass ?? ofFunction, start: index, end: code.indexOf("\n}", index) }));

/** The classes, of those that are given, of which something runs in a call. */
function classesThatRun(among, call) {
	const take = beginCoverage(false);
	take();
	call();
	const { functions } = take().find(({ url }) => url === pathToFileURL(engine).href);
	const starts = functions.map(({ ranges }) => ranges[0]).filter(({ count }) => count > 0).map(({ startOffset }) => startOffset);
	const ran = parts.filter(({ name, start, end }) => among.has(name) && starts.some((each) => each >= start && each < end));
	return [...new Set(ran.map(({ name }) => name))];
}

test("docs/calls.md lists the classes that a frame passes, and those that it leaves out", () => {
	const land = new GreatLand();
	land.addModel(BuiltInModel.cube());
	const collision = new Collision(new TightestFitCollider(land));
	let calls = 0;
	collision.onCollision("turtles", "turtles", () => calls++);
	const agents = Array.from({ length: 400 }, () => new Agent("cube"));
	const move = () => agents.forEach((agent, i) => agent.moveTo(0.9 * (i % 20) + 0.01 * (calls % 7), 0.9 * Math.floor(i / 20), 0));
	for (let i = 0; i < 5; i++) {
		move();
		collision.update(agents);
	}
	move();
	const before = calls;
	const ran = classesThatRun(FRAME, () => collision.update(agents));
	assert.ok(calls - before > 1000, "handlers ran");
	const page = section("A frame");
	const listed = [...page.matchAll(/^\d+\. `(\w+)`/gm)].map(([, name]) => name);
	const leftOut = [...page.match(/leaves out ([^]*?)\.\n\n/)[1].matchAll(/`(\w+)`/g)].map(([, name]) => name);
	assert.match(page, new RegExp(`passes ${listed.length} classes`));
	assert.deepEqual([...listed, ...leftOut].filter((name) => FRAME.has(name)).sort(), ran.sort());
});

test("docs/calls.md lists the classes of queries that nearest passes", () => {
	const land = new GreatLand();
	land.addModel(BuiltInModel.cube());
	const queries = new AgentQueries(new CombinationCollider(land));
	const agents = Array.from({ length: 400 }, (_, i) => Object.assign(new Agent("cube", i % 2 ? "sheep" : "wolves"), { x: i % 20, y: Math.floor(i / 20) }));
	queries.update(agents);
	const sheep = new AgentFilter({ breeds: ["sheep"] });
	let found = null;
	const ran = classesThatRun(QUERIES, () => found = queries.nearest(agents[2], 20, sheep));
	assert.equal(found.breed, "sheep");
	const listed = namesIn(section("A question").match(/^1\. [^]*?\n\n/m)[0]);
	assert.deepEqual(listed.sort(), ran.filter((name) => name !== "AgentFilter").sort());
});

test("docs/calls.md lists the classes that a contact with the ground passes, and those that it leaves out", () => {
	const rooms = classesOf("ground", "search/penetration");
	const land = new GreatLand();
	land.addModel(BuiltInModel.capsule(0.3, 1.2, "hero"));
	const collision = new Collision(new TightestFitCollider(land));
	const terrain = collision.terrain = new Terrain(41, 41, 1, -20, -20);
	terrain.raiseMound(0, 0, 30, 4);
	let depth = 0;
	collision.onCollision("turtles", Collision.TERRAIN, (agent, ground, contact) => depth = contact.depth);
	const hero = new Agent("hero");
	const ran = new Set();
	for (let i = 0; i < 20; i++) {
		hero.moveTo(0.5 * i, 3, terrain.heightAt(0.5 * i, 3) - 0.1);
		depth = 0;
		// the first frame makes all objects
		const ofFrame = classesThatRun(rooms, () => collision.update([hero]));
		assert.ok(depth > 0.05 && depth < 0.15, `a contact of depth ${depth}`);
		if (i > 0) ofFrame.forEach((name) => ran.add(name));
	}
	const page = section("A contact with the ground");
	const listed = [...page.matchAll(/^\d+\. `(\w+)`/gm)].map(([, name]) => name);
	const leftOut = namesIn(page.match(/leaves out ([^]*?)\.\n\n/)[1]);
	assert.match(page, new RegExp(`passes ${listed.length} classes`));
	assert.deepEqual(listed.filter((name) => !ran.has(name)), []);
	assert.deepEqual([...ran].filter((name) => !listed.includes(name) && !leftOut.includes(name)), []);
});

test("docs/calls.md names the classes of queries that a walk passes", () => {
	const land = new GreatLand();
	for (const model of [BuiltInModel.box(40, 40, 8, "ground"), BuiltInModel.box(40, 1, 9, "wall"), BuiltInModel.capsule(0.3, 1.8, "hero"), BuiltInModel.cube()]) {
		land.addModel(model);
	}
	const queries = new AgentQueries(new CombinationCollider(land));
	const agents = [["ground", 0, -8], ["wall", 3, -2], ["cube", 0, -0.7], ["hero", -3, 0]].map(([shape, y, z]) => Object.assign(new Agent(shape), { y, z }));
	queries.update(agents);
	const hero = agents[3];
	const ran = classesThatRun(QUERIES, () => {
		for (let i = 0; i < 200; i++) queries.walk(hero, i < 100 ? 0.005 : 0.1, 0.06);
	});
	assert.ok(hero.y > 1 && hero.y < 3 && hero.x > 5, "it crosses the step, and slides along the wall");
	const named = [...namesIn(section("A question") + section("A walk")), "WalkOptions", "Footing"];
	assert.ok(ran.length > 15, ran.join());
	assert.deepEqual(ran.filter((name) => !named.includes(name)), []);
});

test("docs/calls.md says how many classes a model passes from its file to its structures", () => {
	const rooms = new Set([...classesOf("models", "libraries", "fitting", "geometry/hull", "hierarchy", "solid"), "GreatLand", "StepSequence"]);
	const corners = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0], [1, 1, 3]];
	const obj = corners.map((corner) => `v ${corner.join(" ")}\n`).join("") + "f 1 2 3 4 5\nf 1 6 2\nf 2 6 3\nf 3 6 4\nf 4 6 5\nf 5 6 1\n";
	const dae = '<COLLADA><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="f">' + corners.flat().join(" ") +
		'</float_array><technique_common><accessor source="#f" stride="3"/></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>' +
		'<polylist><input semantic="VERTEX" source="#v" offset="0"/><vcount>5 3 3 3 3 3</vcount><p>0 1 2 3 4 0 5 1 1 5 2 2 5 3 3 5 4 4 5 0</p></polylist></mesh></geometry></library_geometries>' +
		'<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>';
	const points = Buffer.from(new Float32Array(corners.flat()).buffer).toString("base64");
	const gltf = JSON.stringify({ asset: { version: "2.0" }, nodes: [{ mesh: 0, translation: [1, 2, 3] }], meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
		accessors: [{ bufferView: 0, componentType: 5126, type: "VEC3", count: 6 }], bufferViews: [{ buffer: 0, byteLength: 72 }],
		buffers: [{ byteLength: 72, uri: `data:application/octet-stream;base64,${points}` }] });
	const cooked = new GreatLand().cook(ObjModel.fromBytes("a", Buffer.from(obj)));
	const files = { "An OBJ": [ObjModel, Buffer.from(obj)], "a COLLADA": [ColladaModel, Buffer.from(dae)], "a glTF": [GltfModel, Buffer.from(gltf)], "a cooked": [CookedModel, cooked] };
	const told = section("A model").replace(/\s+/g, " ");
	for (const [format, [Reader, bytes]] of Object.entries(files)) {
		const land = new GreatLand();
		const ran = classesThatRun(rooms, () => land.addModel(Reader.fromBytes("a", bytes)));
		assert.ok(land.hasModel("a"));
		assert.match(told, new RegExp(`${format} file (passes )?${ran.length}\\b`, "i"), `${format} file: ${ran.length} classes, ${ran.join()}`);
	}
});
