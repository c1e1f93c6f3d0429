/** Tests of the npm package that the build makes: bin/module. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, symlinkSync, writeFileSync } from "node:fs";
import { SourceMap, createRequire } from "node:module";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import vm from "node:vm";
import { PATIENCE, launch } from "../../build/headless/browsers.mjs";
import { serve } from "../../build/headless/server.mjs";
import { publicSignatures } from "../../js/module/names.mjs";
import { mayHaveNull } from "../../js/module/signatures.mjs";
import { writeDeclarations } from "../../js/module/types/declarations.mjs";

const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = path.join(root, "bin/module");
const work = path.join(root, "bin/generated/module/package-test");
const tools = createRequire(path.join(root, "js/module/package.json"));
const esbuild = tools("esbuild");
const manifest = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
const minified = path.join(folder, "starlogo-collision.min.js");
const readable = path.join(folder, manifest.exports["."].node);
const sample = path.join(root, "test/module/sample.ts");
const bear = readFileSync(path.join(root, "assets/bear.obj"), "utf8");

// as if it were installed, for the sample
before(() => {
	rmSync(work, { recursive: true, force: true });
	mkdirSync(path.join(work, "node_modules"), { recursive: true });
	symlinkSync(folder, path.join(work, "node_modules/starlogo-collision"));
	const config = { target: "es2022", module: "nodenext", moduleResolution: "nodenext", strict: true, noEmit: true, types: [], lib: ["es2022"] };
	writeFileSync(path.join(work, "package.json"), '{ "type": "module" }');
	writeFileSync(path.join(work, "sample.ts"), readFileSync(sample));
	writeFileSync(path.join(work, "tsconfig.json"), JSON.stringify({ compilerOptions: config, files: ["sample.ts"] }));
	bundle("sample.bundle.js");
});

function bundle(name, options = {}) {
	esbuild.buildSync({ entryPoints: [path.join(work, "sample.ts")], bundle: true, format: "esm", outfile: path.join(work, name), logLevel: "silent", ...options });
	return path.join(work, name);
}

/** The JSON that a program prints in a process of its own. */
function printedBy(program) {
	return JSON.parse(execFileSync(process.execPath, ["--input-type=module", "--eval", program], { encoding: "utf8", timeout: PATIENCE }));
}

/** The first lines of a program: it imports names of one of the package's modules, and lists its warnings in said. */
const beginning = (names, module) => `import { ${names} } from ${JSON.stringify(pathToFileURL(path.join(folder, module)))};
		const said = [];
		console.warn = (text) => said.push(text);`;

/** The warnings that a program prints, given the readable module. Given the minified one, it has none. */
function warningsOf(program) {
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")), []);
	return printedBy(program("starlogo-collision.js"));
}

/** Asserts that texts match patterns, each its own, in this order. */
function assertEach(said, patterns) {
	assert.equal(said.length, patterns.length, said.join("\n"));
	patterns.forEach((pattern, i) => assert.match(said[i], pattern));
}

/** What the sample does, as an object that can be compared. */
const use = async (sample, base, bear, bytes) => ({
	calls: sample.play(bear),
	volumes: sample.fitAll(Float64Array.from({ length: 300 }, (_, i) => Math.sin(i * i))),
	pairs: sample.testPairs(),
	loaded: await sample.load(base, bytes),
	kept: sample.keep(),
	errors: sample.refuse(),
});

function check(result) {
	assert.equal(result.calls, 4);
	assert.deepEqual(result.pairs, [true, true, true, true, true, true, true]);
	assert.ok(result.volumes.every((volume) => volume > 1 && volume < 50), String(result.volumes));
	assert.deepEqual(result.loaded.filter((name) => !name.startsWith("model ")), ["bear", "cube", "dragon", "person"]);
	assert.match(result.loaded.find((name) => name.startsWith("model ")), /^model "nothing": its file can't be fetched: .*nothing\.obj/);
	assert.deepEqual(result.kept, ["11288", "true", "null"]);
	assert.match(result.errors[0], /^ArgumentError: new Agent: shape must be a name, not ""/);
	assert.match(result.errors[1], /^ModelError: model "broken", line 1: expected a vertex/);
	assert.match(result.errors[2], /^ModelError: model "broken", line 1: this is not well-formed XML/);
	assert.match(result.errors[4], /^IllegalOperationError: at this moment/);
	assert.match(result.errors[5], /^ModelError: model "broken", asset\.version: expected glTF 2\.0/);
	assert.match(result.errors[6], /^ModelError: model "broken"/);
	const indices = result.errors.slice(7);
	assert.deepEqual(indices.slice(0, 5), ["-1", "1.5", "NaN", "4294967296", "1.5"].map((index, i) => `ArgumentError: ${i < 4 ? "new Model" : "HierarchiesLibrary.add"}: triangles[2] must be an integer from 0 to 4294967295, not ${index}`));
	assert.match(indices[5], /^ModelError: model "broken": triangle 0 names vertex 1, the last one is 0/);
	assert.equal(result.errors.filter((text) => text.startsWith("unknown")).length, 0);
}

const bytes = readFileSync(path.join(root, "assets/person.dae"));

/** A server of the assets, the package and the sample, under a policy without eval, inline scripts or anything from elsewhere. */
const PAGE = "<!DOCTYPE html><script type=module src=/page.js></script>";
const POLICY = "default-src 'none'; script-src 'self'; worker-src 'self'; connect-src 'self'";
let server;

before(async () => {
	writeFileSync(path.join(work, "page.js"), `window.run = async (name) => {
	const worker = new Worker("/worker.js?" + name, { type: "module" });
	const inWorker = await new Promise((resolve, reject) => { worker.onmessage = (event) => resolve(event.data); worker.onerror = (event) => reject(new Error(event.message)); });
	return { here: await window.use(name), inWorker };
};
import { use } from "/use.js";
window.use = use;
`);
	writeFileSync(path.join(work, "worker.js"), `import { use } from "/use.js";
// nobody hears of a promise that is rejected
use(location.search.slice(1)).then(postMessage, (error) => setTimeout(() => { throw error; }));
`);
	writeFileSync(path.join(work, "use.js"), `const run = ${use};
export async function use(name) {
	const sample = await import(name);
	const bear = await (await fetch("/assets/bear.obj")).text();
	return run(sample, "/assets", bear, new Uint8Array(await (await fetch("/assets/person.dae")).arrayBuffer()));
}
`);
	bundle("sample.external.js", { external: ["starlogo-collision"] });
	writeFileSync(path.join(work, "sample.js"), readFileSync(path.join(work, "sample.external.js"), "utf8").replace('"starlogo-collision"', '"/module.js"'));
	copyFileSync(minified, path.join(work, "module.js"));
	server = await serve(PAGE, { "/assets": path.join(root, "assets"), "": work }, { headers: { "content-security-policy": POLICY } });
});

after(() => server.close());

test("the package says what it is", () => {
	assert.equal(manifest.type, "module");
	assert.equal(manifest.sideEffects, false);
	assert.equal(manifest.license, "MIT");
	assert.equal(manifest.exports["./package.json"], "./package.json");
	assert.ok(manifest.keywords.length > 5 && /^https:/.test(manifest.homepage));
	for (const file of [manifest.types, manifest.exports["."].default, "README.md", "CHANGELOG.md", "LICENSE"]) {
		assert.ok(readFileSync(path.join(folder, file), "utf8").length > 500, file);
	}
});

test("the package says what has changed in its version; older changes are in the project", () => {
	const changes = readFileSync(path.join(folder, "CHANGELOG.md"), "utf8");
	const all = readFileSync(path.join(root, "CHANGELOG.md"), "utf8");
	const [, newest, older] = all.match(/^(## [^]*?)^(## [^]*)/m);
	assert.ok(changes.includes(newest.trim()));
	assert.ok(!changes.includes(older.split("\n")[0]));
	assert.match(changes, /older versions.*CHANGELOG\.md/i);
	assert.equal(changes.includes(`is newer than ${manifest.version}, whose number it has`), newest.startsWith("## Unreleased"));
});

test("the pages of the package speak of JavaScript, and their links lead somewhere in it", () => {
	const anchorsOf = (text) => [...text.matchAll(/^#+ (.*)$/gm)].map(([, title]) => title.toLowerCase().replaceAll(/[^\w -]/g, "").replaceAll(" ", "-"));
	const pages = ["README.md", ...readdirSync(path.join(folder, "docs")).map((file) => `docs/${file}`)];
	assert.ok(pages.length > 6 && manifest.files.includes("docs"));
	for (const page of pages) {
		const text = readFileSync(path.join(folder, page), "utf8");
		assert.doesNotMatch(text, /```actionscript|\.as\b|:void|^Examples?: /m, page);
		if (page !== "README.md") assert.doesNotMatch(text, /ActionScript|Flash|SharedObject|FileReference|\btrace[sd]?\b/, page);
		for (const [, to] of text.replaceAll(/```[^]*?```/g, "").matchAll(/\]\(([^)]+)\)/g)) {
			const [file, anchor] = to.split("#");
			const target = file === "" ? page : path.join(path.dirname(page), file);
			assert.ok(existsSync(path.join(folder, target)), `${page}: ${to}`);
			if (anchor) assert.ok(anchorsOf(readFileSync(path.join(folder, target), "utf8")).includes(anchor), `${page}: ${to}`);
		}
	}
});

test("the types speak of JavaScript, and name pages that the package has", () => {
	for (const file of ["index.d.ts", "three/index.d.ts", "nova/index.d.ts"]) {
		const text = readFileSync(path.join(folder, file), "utf8");
		assert.doesNotMatch(text, /ActionScript|Flash|SharedObject|\btrace[sd]?\b|\bVector\.<|:void\b|`\w+:[A-Z]|\bvar \w+ =|\bpublic function\b|\bSprite\b|^\s*\*  [A-Z]/m, file);
		for (const [page] of text.matchAll(/\bdocs\/[\w-]+\.md\b/g)) assert.ok(existsSync(path.join(folder, page)), `${file}: ${page}`);
	}
});

test("every public class is exported, declared, and used by the sample", async () => {
	const exported = Object.keys(await import(pathToFileURL(minified))).sort();
	assert.deepEqual(Object.keys(await import(pathToFileURL(readable))).sort(), exported);
	const declarations = readFileSync(path.join(folder, "index.d.ts"), "utf8");
	const declared = [...declarations.matchAll(/^export (?:(?:abstract )?class|function) (\w+)/gm)].map((match) => match[1]).sort();
	// the platform has these names too: editors must not offer them for its own
	const unnamed = ["ErrorEvent", "Event", "ProgressEvent", "TextEvent"];
	assert.deepEqual(exported, [...declared, ...unnamed].sort());
	assert.doesNotMatch(declarations, /ENTER_FRAME|enterFrame|[sS]tage/);
	const listed = readFileSync(sample, "utf8").split("} from")[0];
	const used = readFileSync(sample, "utf8").split("} from")[1];
	for (const [, name] of declarations.matchAll(/^export (?:(?:abstract )?class|function|interface) (\w+)/gm)) {
		assert.match(listed, new RegExp(`\\b${name}\\b`), `the sample does not import ${name}`);
		assert.match(used, new RegExp(`\\b${name}\\b`), `the sample does not use ${name}`);
	}
	assert.ok(exported.length > 50);
});

test("every static member that the types show is there, for extending classes too", async () => {
	const engine = await import(pathToFileURL(minified));
	const declarations = readFileSync(path.join(folder, "index.d.ts"), "utf8");
	const members = [...declarations.matchAll(/^export (?:abstract )?class (\w+)[^]*?^}/gm)]
		.flatMap(([text, name]) => [...text.matchAll(/^\t(?:protected )?static (?:readonly |get )?(\w+)/gm)].map(([, member]) => [name, member]));
	assert.ok(members.some(([name, member]) => name === "BoundingStructure" && member === "checkLength"));
	assert.deepEqual(members.filter(([name, member]) => engine[name][member] === undefined), []);
});

// Flash's own classes and parts that no game extends show some more.
test("a game's own subclass may have any method without $ that the types do not show", async () => {
	const shown = new Set(readFileSync(path.join(folder, "index.d.ts"), "utf8").match(/[\w$]+/g));
	shown.add("toJSON");
	for (const file of [minified, readable]) {
		const { BreedInterests, ByteArray, Event, HierarchyNode, ModelLoader, ModelTransform, ...extendable } = await import(pathToFileURL(path.resolve(folder, file)));
		const hidden = Object.values(extendable).flatMap((type) => Object.getOwnPropertyNames(type.prototype ?? {})).filter((name) => !shown.has(name));
		assert.ok(hidden.length > 100);
		assert.deepEqual(hidden.filter((name) => !/^_?\$/.test(name)), [], file);
		class Bear extends extendable.Agent {
			turnBy(degrees) {
				this.heading += degrees;
			}
		}
		const bear = new Bear("cube");
		bear.turnBy(30);
		bear.heading += 60;
		assert.equal(bear.heading, 90);
	}
});

test("a game's own subclass may have any field without $ that the types do not show", async () => {
	for (const file of [minified, readable]) {
		const engine = await import(pathToFileURL(path.resolve(folder, file)));
		const fields = Object.values(engine).filter((type) => type.prototype).flatMap((type) => [...String(type).matchAll(/\bthis\.(_[\w$]*)/g)].map(([, name]) => name));
		assert.deepEqual(fields.filter((name) => !/^_\$/.test(name)), [], file);
		const { Agent, AgentFilter, AgentQueries, BinCollider, Collision, WalkOptions } = engine;
		class Player extends Agent {
			_turn = 0;
			_color = "red";
			_isOneWay = "sometimes";
			_placement = null;
		}
		class Game extends Collision {
			_handlers = [];
			_system = null;
			_filter = "own";
		}
		const [player, other] = [new Player("cube", "players"), new Agent("cube", "coins")];
		player.heading = 40;
		player.x = 0.2;
		const game = new Game(new BinCollider());
		let touches = 0;
		game.onCollision("players", "coins", () => touches++);
		game.update([player, other]);
		const saved = game.snapshot(true);
		player.moveTo(9, 9, 9);
		player.color = 3;
		game.restore(saved, [player, other]);
		assert.deepEqual([touches, player.heading, player.x, player.color, player.isOneWay, player._color], [1, 40, 0.2, 0, false, "red"]);
		assert.equal(game.filter, null);
		assert.deepEqual(JSON.parse(JSON.stringify(player)), player.toJSON());
		const queries = new (class extends AgentQueries {
			_seen = 1;
			_moves = 2;
		})(game);
		queries.update([player, other]);
		assert.equal(queries.walk(player, 1, 0, new (class extends WalkOptions { _stepHeight = "high"; })()).on, null);
		assert.deepEqual(queries.near(player, 9, new (class extends AgentFilter { _breeds = 3; })()), [other]);
	}
});

test("names of classes are the sources' own, minified too", async () => {
	const all = await import(pathToFileURL(minified));
	const classes = Object.entries(all).filter(([, value]) => /^class/.test(String(value)));
	assert.ok(classes.length > 50);
	for (const [name, value] of classes) assert.equal(value.name, name);
	assert.equal(String(new all.Sphere(new all.Vector3D(), 1)), "a Sphere of radius 1 at Vector3D(0, 0, 0)");
});

// see #classText in js/module/translation/translate.mjs
test("V8 can compile constructors: no class is a dictionary", () => {
	for (const file of [minified, readable]) {
		const script = `import(${JSON.stringify(pathToFileURL(path.resolve(folder, file)))}).then((all) => console.log(Object.keys(all).filter((name) => !%HasFastProperties(all[name])).join()))`;
		assert.equal(execFileSync(process.execPath, ["--allow-natives-syntax", "-e", script], { encoding: "utf8" }).trim(), "", file);
	}
});

test("tsc --strict accepts the sample", () => {
	execFileSync(process.execPath, [tools.resolve("typescript/bin/tsc"), "-p", work], { encoding: "utf8", stdio: "pipe" });
});

test("importing it reads no global but the language's own, and adds none", () => {
	const code = readFileSync(minified, "utf8").replace(/export\{.*?\};/, "");
	const asked = new Set();
	const language = vm.runInNewContext("globalThis");
	const sandbox = vm.createContext(new Proxy({}, {
		has(target, name) {
			asked.add(name);
			return name in target;
		},
		get(target, name) {
			asked.add(name);
			return name in target ? target[name] : language[name];
		},
	}));
	const own = new Set(Object.getOwnPropertyNames(language));
	const before = Object.keys(sandbox);
	new vm.Script(`"use strict"; (() => { ${code} })();`).runInContext(sandbox);
	const foreign = [...asked].filter((name) => typeof name === "string" && !own.has(name));
	assert.deepEqual(foreign, []);
	assert.ok(asked.has("Math"), "the sandbox sees what is asked for");
	assert.deepEqual(Object.keys(sandbox), before);
	assert.doesNotMatch(code, /\beval\(|new Function\(/);
	// a function of the stand-ins that is left out; what is there has a short name, and methods have a body
	const missing = [...code.matchAll(/(?<![\w$."']|\bget )(\$[a-z]\w{3,})\((?!\w*\)\{)/g)].map((match) => match[1]);
	assert.deepEqual(missing, []);
});

test("the types of functions are the same wherever they stand, what subclasses set is protected, and \"null for all\" is no element", () => {
	const types = [...publicSignatures()];
	const agents = types.find(([qname]) => qname === "starlogo.collision.Collision");
	const finish = types.find(([, type]) => type.name === "finish")[1];
	const parameters = [{ name: "agent", type: "Agent", value: null, isRest: false }];
	const declared = writeDeclarations(new Map([agents, ["of", { ...finish, name: "of", parameters, result: "Agent" }], ...types.filter(([, type]) => type.name === "Agent")]));
	assert.match(declared, /export function of\(agent: Agent\): Agent;/);
	const [qname, withSetter] = types.find(([, type]) => type.members.some((member) => member.kind === "set" && !member.isStatic));
	const members = withSetter.members.map((member) => (member.kind === "set" ? { ...member, isProtected: true } : member));
	assert.match(writeDeclarations(new Map([...types, [qname, { ...withSetter, members }]])), /^\tprotected set \w+/m);
	for (const [docs, isSo] of [["null for a mesh", true], ["null for an object", true], ["null for all", false], ["null for any", false]]) {
		assert.equal(mayHaveNull(docs), isSo, docs);
	}
});

test("the package weighs 3.1 MB at most, and its map 1.2", () => {
	const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((file) => file.isFile()).map((file) => path.join(file.parentPath ?? file.path, file.name));
	const sizeOf = (some) => some.reduce((sum, file) => sum + statSync(file).size, 0);
	const isMap = (file) => path.dirname(file) === path.join(folder, "maps");
	assert.ok(sizeOf(files.filter((file) => !isMap(file))) < 3.1e6);
	assert.ok(sizeOf(files.filter(isMap)) < 1.2e6);
});

test("the minified module has a map to the readable one, in a folder of its own", () => {
	const [, name] = /\n\/\/# sourceMappingURL=(.*)\n$/.exec(readFileSync(minified, "utf8"));
	const map = new SourceMap(JSON.parse(readFileSync(path.join(folder, name), "utf8")));
	const [small, readable] = [minified, path.join(folder, "starlogo-collision.js")].map((file) => readFileSync(file, "utf8").split("\n"));
	assert.deepEqual(readdirSync(path.join(folder, "maps")), [path.basename(name)]);
	for (const said of ["is listed twice: agents[", "there is no model ", " is no option; ", "the receiver of the models must not be null", "must not be called from a filter's accepts"]) {
		const line = small.findIndex((text) => text.includes(said));
		const { originalSource, originalLine } = map.findEntry(line, small[line].indexOf(said));
		assert.equal(originalSource, "../starlogo-collision.js");
		assert.ok(readable.slice(originalLine - 2, originalLine + 3).join().includes(said), `${said}: ${readable[originalLine]}`);
	}
});

test("while a game is developed, names that do nothing are warned of, once", () => {
	const program = (module) => `${beginning("Agent, AgentFilter, AgentQueries, BinCollider, BuiltInModel, Collision, CombinationCollider, GreatLand, Model, ModelLoader, WalkOptions", module)}
		class Wolf extends Agent { hunger = 3; colour = 0x808080; }
		class Herd extends Agent { colour = "grey"; sizes = 3; headings = []; shapes = {}; breeds = ["cows"]; }
		const [agent, wolf, plain] = [new Agent("sphere"), new Wolf("sphere"), new Agent("sphere")];
		agent.sweep = true;
		agent.speed = 3;
		wolf.Heading = 3;
		wolf.sweep = true;
		const collider = new BinCollider();
		collider.exact = true;
		const collision = new Collision(collider);
		for (let i = 0; i < 3; i++) collision.update([agent, wolf, plain, new Herd("sphere")]);
		const flock = new Collision(new BinCollider());
		flock.onCollision("wolfs", "sheep", function eat(a, b, contact, more) {});
		flock.onCollision(Collision.ANY_BREED, "team2", (a, b, contact) => 0);
		const queries = new AgentQueries(flock);
		const list = ["wolves", "sheep", "sheep", "team1"].map((breed) => new Agent("sphere", breed));
		for (let i = 0; i < 3; i++) {
			flock.update([...list]);
			queries.update(list);
			for (const breeds of [["sheeps", "birds"], ["sheep"], ["Wolves"]]) queries.near(list[0], 9, AgentFilter.ofBreeds(...breeds));
			if (i === 1) list.push(new Agent("sphere", "birdes"));
		}
		const land = new GreatLand();
		const side = 80;
		const vertices = Array.from({ length: side * side }, (_, i) => [i % side, Math.floor(i / side), Math.sin(i)]).flat();
		const triangles = Array.from({ length: side * (side - 1) - 1 }, (_, i) => [i, i + 1, i + side, i + 1, i + side + 1, i + side]).flat();
		land.addModel(new Model("level", vertices, triangles, Model.AS_GIVEN));
		const other = new Collision(new CombinationCollider(land));
		const [level, boxed] = [new Agent("level"), new Agent("level")];
		boxed.collideAs = "box";
		class Bird extends Agent { sweeps = true; x = 3; xs = []; }
		other.filter = Object.assign(new AgentFilter(), { exceptBreeds: ["turtle"] });
		other.update([level, boxed, new Bird("level")]);
		const misspelt = Object.assign(new AgentFilter(), { breed: ["sheep"] });
		for (let i = 0; i < 2; i++) queries.near(list[0], 9, misspelt);
		queries.walk(list[0], 0, 0, Object.assign(new WalkOptions(), { stepheight: 1 }));
		const moved = Object.assign(new Agent("sphere"), { position: [1, 2, 3], isHierarchical: true });
		const own = Object.assign(new Wolf("sphere"), { position: [1, 2, 3], oneWay: true });
		for (let i = 0; i < 2; i++) collision.update([moved, own]);
		land.loadTightestfit = false;
		for (let i = 0; i < 2; i++) land.addModel(BuiltInModel.capsule(0.3, 1.8, "hero"));
		const loader = new ModelLoader(land);
		for (const type of ["load", "complete", "cancel", "progress", "error", "modelLoaded"]) loader.addEventListener(type, () => 0);
		const room = new GreatLand();
		room.addModel(BuiltInModel.box(10, 10, 4, "room"));
		room.addModel(BuiltInModel.capsule(0.3, 1.8, "hero"));
		const rooms = new AgentQueries(Object.assign(new CombinationCollider(room), { exact: true }));
		const [shell, hero] = [Object.assign(new Agent("room"), { hierarchical: true }), new Agent("hero")];
		rooms.update([shell]);
		hero.moveTo(0, 0, 4);
		rooms.walk(hero, 0.1, 0);                       // on its roof
		hero.moveTo(-7, 0, 0);
		if (rooms.moveUntilTouch(hero, 9, 0, 0) === 1) throw new Error("a wall stops it from outside");
		if (said.some((text) => text.includes("not stop it"))) throw new Error("it is not inside yet");
		hero.moveTo(0, 0, 1);
		for (let i = 0; i < 100; i++) rooms.slide(hero, 0.1, 0, 0);
		if (!(hero.x > 9.9)) throw new Error("from inside nothing stops it");
		console.log(JSON.stringify(said));`;
	const said = warningsOf(program);
	const expected = [/exact does nothing on a BinCollider/, /sweep is no property of Agent.*is sweeps meant/, /colour is no property of Wolf.*is color meant/, /Heading is no property of Wolf.*is heading meant/, /sweep is no property of Wolf/, /the handler eat for "wolfs" and "sheep" has 4 parameters, and gets three/, /no agent is of the breed "wolfs"; is "wolves" meant/, /"sheeps"; is "sheep" meant/, /"Wolves"; is "wolves" meant/, /"birds"; is "birdes" meant/, /"turtle"; is "turtles" meant/, /12638 triangles.*set hierarchical/, /sweeps is a field of Bird that hides the engine's: set it in the constructor/, /x is a field of Bird that hides/,
		/breed is no property of AgentFilter.*is breeds meant/, /stepheight is no property of WalkOptions.*is stepHeight meant/, /position is no property of Agent .*is moveTo\(x, y, z\) meant/, /isHierarchical is no .*is hierarchical meant/, /position is no property of Wolf .*is moveTo/, /oneWay is no property of Wolf.*is isOneWay meant/,
		/loadTightestfit is no property of GreatLand.*is loadTightestFit meant/, /a ModelLoader sends no event "load"; it sends modelLoaded, error, progress, complete, cancel/, /agent \d+ \(breed "turtles", shape "hero"\) begins a motion at \(0, 0, 1\), \S+ deep inside of agent \d+ \(breed "turtles", shape "room"\), which does not stop it\. What is inside of a closed model/];
	assertEach(said, expected);
});

test("while a game is developed, names that do nothing are warned of when they are set after the first frame, too", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BinCollider, BuiltInModel, Collision, CombinationCollider, Footing, GreatLand, LevelCollider, LevelShapes, Terrain", module)}
		const collision = new Collision(new BinCollider());
		const queries = new AgentQueries(new BinCollider());
		const agents = [new Agent("sphere", "wolves"), new Agent("sphere")];
		const asked = [new Agent("cube")];
		for (let frame = 1; frame <= 40; frame++) {
			collision.update(agents);
			queries.update(asked);
			if (frame === 1) agents[1].sweep = true;
			if (frame === 5) agents[0].colour = "grey";
			if (frame === 9) asked[0].isHierarchical = true;
			if (frame === 3) collision.collider = 3;
			if (frame === 17) collision.exact = collision.collisionSystem.maxDepth = 3;
		}
		new AgentQueries(Object.assign(new LevelCollider(new LevelShapes()), { exact: true })).update([]);
		const land = new GreatLand();
		land.addModel(BuiltInModel.sphere());
		const game = new Collision(new CombinationCollider(land));
		const footing = new Footing();
		game.terrain = new Terrain(9, 9);
		for (let frame = 1; frame <= 20; frame++) {
			new AgentQueries(game).update(agents);
			game.update(agents);
			if (frame === 5) Object.assign(land, { prepareexact: true, levels: [] });
			if (frame === 6) Object.assign(game.terrain, { blocky: true, name: "hills" });
			if (frame === 7) game.collisionSystem.isExact = true;
		}
		const walks = new AgentQueries(game);
		walks.update(agents);
		for (let i = 1; i <= 9; i++) {
			walks.walk(agents[0], 0, 0, null, footing);
			if (i === 5) Object.assign(footing, { standing: true, surface: null, speed: 3 });
		}
		// a name that a game's class does not have in its text, and those that it has
		class Car extends Agent { position = [1, 2]; turn() { this.yaw = 3; } }
		class Bus extends Car { }
		const cars = [new Bus("cube"), new Bus("cube")];
		cars[0].turn();
		cars[1].rotation = [1, 2, 3];
		new Collision(new BinCollider()).update(cars);
		console.log(JSON.stringify(said));`;
	const said = warningsOf(program);
	const expected = [/sweep is no property of Agent .*is sweeps meant/, /collider is no property of Collision that the engine reads; is collisionSystem meant/, /colour is no property of Agent .*is color meant/, /isHierarchical is no property of Agent .*is hierarchical meant/,
		/exact does nothing on a Collision: it is for a HierarchicalCollider/, /maxDepth does nothing on a BinCollider/,
		/exact does nothing on a LevelCollider: set exact of its LevelShapes$/, /prepareexact is no property of GreatLand.*is prepareExact meant/, /blocky is no property of Terrain.*is isBlocky meant/,
		/isExact is no property of CombinationCollider.*is exact meant/, /standing is no property of a Footing that the engine reads; is stands meant/, /rotation is no property of Bus that the engine reads; is heading, pitch/];
	assertEach(said, expected);
});

test("while a game is developed, handlers and places that can't be meant are warned of, once", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BinCollider, BuiltInModel, Collision, CombinationCollider, GreatLand, Model", module)}
		const collision = new Collision(new BinCollider());
		const [hero, coin, wall] = [new Agent("hero", "heroes"), new Agent("coin"), new Agent("wall")];
		// own fields that no property is called
		Object.assign(hero, { heading3: 1, size2: 2, toString: () => "the hero" });
		Object.assign(wall, { heirarchical: true });
		collision.onCollisionEnd("heroes", "walls", function leave(a, b, contact) { return contact.depth; });
		collision.onCollisionEnd("heroes", "walls", (a, b, { depth }) => depth);
		for (const shared of [(a, b, contact) => contact?.depth, (a, b, contact) => contact && contact.depth, (a, b, touch) => { if (touch) return touch.depth; }, (a, b, hit) => (hit === null ? 0 : hit.depth), (a, b, c) => a, (a, b) => b]) collision.onCollisionEnd("heroes", "walls", shared);
		collision.onCollision("heroes", "walls", (contact, a, b) => a);
		collision.onCollision("heroes", "coin", (a, b) => 0);
		for (let i = 0; i < 400; i++) collision.update([hero, coin, wall]);
		// names that every object has
		const built = new Collision(new BinCollider());
		built.onCollision("heroes", "constructer", () => 0);
		built.update([hero, new Agent("wall", "constructor")]);
		const busy = new Collision(new BinCollider());
		busy.onCollision("heroes", "*", () => 0);
		busy.onCollision("turtles", "monsters", () => 0);
		for (let i = 0; i < 400; i++) busy.update([hero, coin, wall]);
		const land = new GreatLand();
		land.addModel(BuiltInModel.box(40, 40, 8, "ground"));
		const barrel = BuiltInModel.box(1, 1, 1.8);
		land.addModel(new Model("barrel", barrel.vertices.map((value, i) => (i % 3 === 2 ? value - 0.9 : value)), barrel.triangles, Model.AS_GIVEN));
		const queries = new AgentQueries(Object.assign(new CombinationCollider(land), { exact: true }));
		const [ground, player] = [Object.assign(new Agent("ground", "levels"), { hierarchical: true }), new Agent("barrel", "heroes")];
		ground.moveTo(0, 0, -8);
		player.moveTo(2, 3, -0.1);
		queries.update([ground, player]);
		for (let i = 0; i < 3; i++) queries.walk(player, 0.1, 0, { slopeDegrees: 0.785 });
		queries.walk(player, 0.1, 0, { slopeDegrees: 0 });
		// who walks and what stands still need no update
		for (let i = 0; i < 400; i++) busy.update([hero]), queries.walk(player, 0.001, 0), queries.cast({ x: 9, y: 9, z: 9 }, { x: 0, y: 0, z: -1 });
		const before = said.length;
		for (let i = 0; i < 3; i++) ground.moveTo(0, 0, -8 - i), queries.walk(player, 0.001, 0);
		if (before > 0 && said.length !== before + 1) throw new Error(said.join());
		console.log(JSON.stringify(said));`;
	const said = warningsOf(program);
	const expected = [/the handler leave for "heroes" and "walls" is for the end of a touch, where its third argument is null/, /the handler without a name for "heroes" and "walls" is for the end/, /its contact too early: it gets the two agents first/,
		/no agent is of the breed "coin", which is the shape of agent \d+ \(breed "turtles", shape "coin"\)/, /heirarchical is no property of Agent that the engine reads; is hierarchical meant/, /in 300 frames no handler was called, and no agent is of the breed "walls" or "coin"\. The agents' breeds are "heroes", "turtles"/,
		/no agent is of the breed "constructer"; is "constructor" meant/,
		/slopeDegrees is 0\.785.*take 45$/, /agent \d+ \(breed "heroes", shape "barrel"\) begins a motion at \(2, 3, -0\.1\), 1 deep inside of agent \d+ \(breed "levels", shape "ground"\).* 0\.9 below its place.*See docs\/questions\.md/,
		/questions see agent \d+ \(breed "levels", shape "ground"\) where it was at the last queries\.update\(agents\), 400 frames ago/];
	assert.equal(said.length, expected.length, said.join("\n"));
	for (const pattern of expected) assert.ok(said.some((text) => pattern.test(text)), `${pattern}: ${said.join("\n")}`);
});

test("while a game is developed, async handlers and generators are warned of, once, and no breed that a handler names is another's name", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BinCollider, Collision", module)}
		const collision = new Collision(new BinCollider());
		const [hero, wall] = [new Agent("hero", "heroes"), new Agent("wall", "walls")];
		async function save(a, b, contact) {}
		function* steps(a, b) {}
		for (const handler of [save, save, steps, async function* () {}, (async) => async, () => Promise.resolve()]) collision.onCollision("heroes", "walls", handler);
		collision.update([hero, wall]);
		collision.onCollisionStart("heroes", "balls", () => 0);
		collision.update([hero, wall]);
		const queries = new AgentQueries(collision);
		queries.update([hero, wall]);
		queries.near(hero, 9, { breeds: ["balls"] });
		queries.near(hero, 9, { breeds: ["halls"] });
		queries.near(hero, 9, { accepts: function* () {} });
		console.log(JSON.stringify(said));`;
	const said = warningsOf(program);
	const expected = [/the handler save for "heroes" and "walls" is async: after an await its contact is another pair's, and its errors are not in handlerErrors/,
		/the handler steps for "heroes" and "walls" is a generator, so a call runs nothing of it/, /the handler without a name for .* is a generator/,
		/no agent is of the breed "halls"; is "walls" meant/, /accepts is an async function or a generator, whose result counts as true/];
	assertEach(said, expected);
});

test("while a game is developed, angles in radians are warned of, once, and angles in degrees never", () => {
	const turning = 'let i = 0; for (const angle of angles) agents[i % 2][["heading", "pitch", "roll"][i++ % 3]] = angle;';
	const seeing = "for (const angle of angles) queries.inCone(agents[0], 5, angle);";
	const program = (module, angles, use) => `${beginning("Agent, AgentQueries, BinCollider", module)}
		const agents = [new Agent("sphere", "wolves"), new Agent("sphere", "sheep")];
		const queries = new AgentQueries(new BinCollider());
		queries.update(agents);
		const angles = ${angles};
		${use}
		console.log(JSON.stringify(said));`;
	const run = (angles, use = turning, module = "starlogo-collision.js") => printedBy(program(module, angles, use));
	const many = (of) => `Array.from({ length: 900 }, (_, i) => ${of})`;
	const radians = [["[0, 3, -Math.PI / 2, Math.PI]", /^starlogo-collision: roll of agent \d+ \(breed "wolves", shape "sphere"\) is -1\.57, a part of π\..* here -90$/], ["[Math.PI / 6]", /here 30$/],
		[many("Math.atan2(Math.sin(i), Math.cos(i))"), /and was -?[23]\.\d+; all angles were between -3\.1\d? and 3\.\d+\. Angles are in degrees/], [many("0.1 * i % (2 * Math.PI)"), /and was [56]\.\d+; all angles were between 0 and 6\.\d+\. /]];
	for (const [angles, pattern] of radians) {
		const said = run(angles);
		assert.equal(said.length, 1, `${angles}: ${said.join("\n")}`);
		assert.match(said[0], pattern);
		assert.deepEqual(run(angles, turning, "starlogo-collision.min.js"), []);
	}
	const [cone, ...others] = run("[Math.PI / 3, Math.PI / 2]", seeing);
	assert.match(cone, /^starlogo-collision: inCone\(\) takes an angle in degrees\. 1\.05 is a part of π: .* here 60$/);
	assert.deepEqual(others, []);
	assert.deepEqual(run("[0, 1, 2, 3, 6, 60, 90, 180, 360, Infinity]", seeing), []);
	for (const degrees of ["[90, 180, 3, -3, 0.5]", many("5 * Math.sin(i)"), many("10 * Math.sin(i)"), many("i % 7"), many("i % 360 - 180"), many("0.01 * i"), many("Math.atan2(Math.sin(i), Math.cos(i)) * 180 / Math.PI")]) assert.deepEqual(run(degrees), [], degrees);
});

test("while a game is developed, settings for a constructor that takes none are warned of", () => {
	const program = (module) => `${beginning("Agent, AgentFilter, BinCollider, BuiltInModel, Collision, Contact, Footing, GreatLand, LevelShapes, RayHit, ShapeHit, WalkOptions", module)}
		new GreatLand(), new AgentFilter(), AgentFilter.ofBreeds("heroes"), new WalkOptions(), new LevelShapes(), new Collision(new BinCollider());
		new GreatLand({ loadHulls: true }), new LevelShapes(true);
		new AgentFilter({ breeds: ["heroes"] }), new WalkOptions({ stepHeight: 1 });
		new Footing(), new RayHit(), new ShapeHit(), new Contact(), BuiltInModel.sphere(), BuiltInModel.cube(2), BuiltInModel.cube(3);
		new Footing({ stands: true }), new RayHit({}), new ShapeHit({}), new Contact({});
		new Collision(new BinCollider(), { terrain: null });
		class Wolf extends Agent { constructor(...all) { super(...all); this.all = all; } }
		new Agent("sphere"), new Agent("sphere", "wolves"), new Wolf("sphere", "wolves", 3), new Agent("sphere", "wolves", { sweeps: true });
		console.log(JSON.stringify(said));`;
	const none = (name, such) => `starlogo-collision: new ${name} takes no arguments, and does nothing with those that it got: settings${such} are set after it`;
	assert.deepEqual(warningsOf(program), [none("GreatLand", " such as loadHulls"),
		none("LevelShapes", ""), "starlogo-collision: BuiltInModel.cube() takes no arguments: it is one unit wide, and agent.size is its width in patches", none("Footing", " such as stands"), none("RayHit", ""), none("ShapeHit", ""), none("Contact", ""), "starlogo-collision: new Collision takes 1 argument, and does nothing with the others: settings such as terrain are set after it",
		"starlogo-collision: new Agent takes 2 arguments, and does nothing with the others: settings such as sweeps are set after it"]);
});

test("while a game is developed, what is made anew in each frame, traits that do nothing, long strides and forgotten updates are warned of, once", () => {
	const program = (module) => `${beginning("Agent, AgentFilter, AgentPlaces, AgentQueries, BinCollider, BuiltInModel, Collision, CombinationCollider, GreatLand, HierarchicalCollider, LevelShapes, SeenAgents, TightestFitCollider", module)}
		const land = new GreatLand();
		land.addModel(BuiltInModel.sphere());
		const wolf = Object.assign(new Agent("sphere", "wolves"), { hierarchical: true, traversalDepth: 3, collideAs: "box" });
		const pack = [wolf, new Agent("sphere", "sheep")];
		const game = new Collision(new TightestFitCollider(land));
		const other = new Collision(new CombinationCollider(land));
		const exchanged = new Collision(new BinCollider(land));
		const deep = new Collision(new HierarchicalCollider(land));
		const anew = new Collision(new BinCollider());
		const inReverse = new Collision(new BinCollider());
		const younger = [new Agent("sphere", "wolves"), new Agent("sphere", "sheep")].reverse();
		const eat = (a, b) => 0;
		for (let frame = 0; frame < 70; frame++) {
			for (const collision of [game, other, exchanged, deep]) collision.update(pack);
			anew.update([new Agent("sphere", "wolves"), new Agent("sphere", "sheep")]);
			inReverse.update(younger);
			if (frame < 60) game.onCollision("wolves", "sheep", eat);
			if (frame % 10 === 0) other.onCollision("wolves", "sheep", eat);
			if (frame === 1) exchanged.collisionSystem = new CombinationCollider(land);
		}
		game.update(pack, 0.016);
		const walker = new Agent("sphere", "wolves");
		const queries = new AgentQueries(game);
		const takesMore = { accepts: (agent) => pack.some((each) => { return each === agent; }) };
		queries.update([pack[1]]);
		for (let i = 0; i < 29; i++) queries.walk(walker, 3, 0, { fall: 0, filter: takesMore });
		queries.walk(walker, 1, 0, { fall: 0 });
		for (let i = 0; i < 29; i++) queries.walk(walker, 3, 0, { fall: 0, filter: { accepts(agent) { throw 3; }, breeds: [] } });
		if (said.length > 6) throw new Error(said.join());
		queries.walk(walker, 3, 0, { fall: 0 });
		new AgentFilter({ accepts: async (agent) => true });
		queries.near(wolf, 3, { accepts: (agent) => { agent.size > 1; } });
		const shapes = Object.assign(new LevelShapes(), { exakt: true });
		shapes.addModel(BuiltInModel.sphere());
		const seen = new SeenAgents(game);
		const places = new AgentPlaces(seen);
		seen.update(pack);
		for (let i = 0; i < 310; i++) {
			game.update(pack);
			pack[1].x += 0.001;
			places.countNear(wolf, 3);
		}
		for (let i = 0; i < 40; i++) {
			const other = new Collision(new TightestFitCollider(new GreatLand()));
			other.onCollision("cats", "dogs", () => {});
			other.update([]);
		}
		console.log(JSON.stringify(said));`;
	const said = warningsOf(program);
	const expected = [/handlers for "wolves" and "sheep" were added in 30 frames in turn/, /all agents are new in 30 frames in turn/,
		/hierarchical of agent \d+ \(breed "wolves", shape "sphere"\) does nothing in a TightestFitCollider: it is for a CombinationCollider/, /traversalDepth of agent .* in a TightestFitCollider: it is for a Hier/,
		/collideAs of agent .* in a HierarchicalCollider/, /Collision\.update takes the list alone: the engine knows no time/, /accepts returns nothing/, /walks 3 patches in each frame/, /accepts is an async function/, /exakt is no property of LevelShapes/, /questions see agent \d+ \(breed "sheep"/];
	assert.equal(said.length, expected.length, said.join("\n"));
	for (const pattern of expected) assert.ok(said.some((text) => pattern.test(text)), `${pattern}: ${said.join("\n")}`);
});

test("while a game is developed, agents that are made anew beside a level that stays are warned of, once, and not if others move, nothing lasts, or one breed lives for a frame", () => {
	const program = (module) => `${beginning("Agent, BinCollider, Collision", module)}
		/** Plays frames with new agents of some breeds beside a level and a hero that stay. */
		function play(breeds, { handler = "onCollisionStart", sweeps = false, speed = 0 } = {}) {
			const game = new Collision(new BinCollider());
			if (handler) game[handler]("heroes", "coins", () => 0);
			const [level, hero] = [new Agent("cube", "levels"), new Agent("cube", "heroes")];
			for (let frame = 0; frame < 400; frame++) {
				hero.x += speed;
				const made = breeds.map((breed) => Object.assign(new Agent("sphere", breed), { sweeps }));
				game.update([level, hero, ...made]);
			}
			return said.filter((text) => /new in/.test(text)).length;
		}
		const both = ["heroes", "coins"];
		const counts = [play(["beams"]), play(both, { speed: 0.1 }), play(both, { handler: "onCollision" }), play(both, { handler: null, sweeps: false }), play([]),
			play(both), play(["heroes", "shots"], { handler: null, sweeps: true })];
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 0, 0, 0, 0, 1, 1], said.join("\n"));
	assert.match(said.find((text) => /new in/.test(text)), /all agents of "heroes", "coins" are new in 300 frames in turn, so no touch lasts, and nothing sweeps: make each agent once/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, questions without frames, models that replace others and grounds that are missing are warned of, once", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BinCollider, BuiltInModel, Collision, GreatLand, LevelShapes, Sphere, Terrain, WorldBounds", module)}
		const game = new Collision(new BinCollider());
		const queries = new AgentQueries(game);
		const [hero, foe] = [new Agent("sphere", "heroes"), new Agent("sphere", "foes")];
		const update = () => queries.update([hero, foe]);
		for (let i = 0; i < 4000; i++) update();
		// a title screen, before the first frame of a game
		const patient = new Collision(new BinCollider());
		const asked = new AgentQueries(patient);
		patient.onCollision("heroes", "foes", () => 0);
		for (let i = 0; i < 2900; i++) asked.update([hero]);
		patient.update([hero, foe]);
		for (let i = 0; i < 200; i++) asked.update([hero]);
		game.onCollision("heroes", "edge", () => 0);
		game.onCollision("heroes", Collision.EDGE, () => 0);
		game.onCollision(Collision.TERRAIN, "heroes", () => 0);
		if (said.length > 0) throw new Error(said.join());
		for (let i = 0; i < 3002; i++) update();
		// a title, where some stand, far apart
		const idle = new Collision(new BinCollider());
		const title = new AgentQueries(idle);
		idle.onCollision("pages", "foes", () => 0);
		const far = new Agent("sphere", "foes");
		far.moveTo(50, 0, 0);
		for (let i = 0; i < 400; i++) {
			title.update([hero, far]);
			title.moveUntilTouch(i % 2 ? hero : far, 0.01 * (i % 4 < 2 ? 1 : -1), 0, 0);
		}
		// a game that is played
		const played = new Collision(new BinCollider());
		const moved = new AgentQueries(played);
		played.onCollision("knights", "foes", () => 0);
		for (let i = 0; i < 310; i++) {
			moved.update([hero]);
			moved.moveUntilTouch(hero, 0.01, 0, 0);
			if (i === 298 && said.length > 1) throw new Error(said.join());
		}
		for (let i = 0; i < 400; i++) game.update([hero, foe]);
		const whole = new Collision(new BinCollider());
		whole.terrain = new Terrain(4, 4);
		whole.bounds = new WorldBounds(-9, -9, -9, 9, 9, 9);
		whole.onCollision("foes", Collision.EDGE, () => 0);
		whole.onCollision("foes", Collision.TERRAIN, () => 0);
		foe.moveTo(0, 0, 5);
		for (let i = 0; i < 400; i++) whole.update([foe]);
		for (const receiver of [new GreatLand(), new LevelShapes()]) {
			for (const lengths of [[1, 2, 3], [1, 2, 3], [4, 2, 3], [5, 2, 3]]) receiver.addModel(BuiltInModel.box(...lengths));
			for (const name of ["low", "high", "low"]) receiver.addModel(BuiltInModel.capsule(0.3, 1 + name.length, name));
			for (const height of [1, 2]) receiver.addModel(BuiltInModel.capsule(0.3, height, "hero"));
			receiver.addModel(BuiltInModel.cube());
			receiver.addModel(BuiltInModel.cube());
		}
		// nothing is replaced
		const land = new GreatLand();
		land.addModel(BuiltInModel.capsule(0.3, 1));
		land.removeModel("capsule");
		land.addModel(BuiltInModel.capsule(0.4, 1));
		const shapes = new LevelShapes();
		shapes.addModel(BuiltInModel.capsule(0.3, 1));
		shapes.addStructure("capsule", new Sphere({ x: 0, y: 0, z: 0 }, 1));
		shapes.addModel(BuiltInModel.capsule(0.4, 1));
		console.log(JSON.stringify(said));`;
	const said = warningsOf(program);
	const expected = [/questions were updated 3000 times, and their Collision with handlers for "heroes" and "edge" never/,
		/questions were updated 301 times, and their Collision with handlers for "knights" and "foes" never/, /no agent is of the breed "edge"; is Collision\.EDGE meant/,
		/in 300 frames no handler was called, and handlers for Collision\.TERRAIN need the Collision's terrain, which is null/, /handlers for Collision\.EDGE need the Collision's bounds/, /no agent is of the breed "edge"\. The/, /a box of other lengths takes the place of the first.*BuiltInModel\.box\(\) takes a name last/,
		/a hero of other lengths takes the place of the first, because both are called "hero": give one of them another name/];
	assertEach(said, expected);
});

test("while a game is developed, a cast that begins inside of a hull is told from a walk", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BuiltInModel, GreatLand, Sphere, TightestFitCollider, Vector3D", module)}
		const land = new GreatLand();
		land.addModel(BuiltInModel.box(40, 40, 8, "ground"));
		const queries = new AgentQueries(new TightestFitCollider(land));
		queries.update([new Agent("ground", "levels")]);
		for (let i = 0; i < 2; i++) queries.castShape(new Sphere(new Vector3D(2, 3, 5), 0.5), 1, 0, 0);
		console.log(JSON.stringify(said));`;
	const [cast, ...others] = warningsOf(program);
	assert.match(cast, /a structure that is cast begins a motion 3\.5 deep inside of the structure around agent \d+ \(breed "levels", shape "ground"\), which it meets at once or not at all\. If it should go through "levels", .*\{ exceptBreeds: \["levels"\] \}\. If this is a level/);
	assert.deepEqual(others, []);
});

test("while a game is developed, a card that only touches others in its plane is not warned of", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BuiltInModel, CombinationCollider, GreatLand, ObjModel", module)}
		const land = new GreatLand();
		land.addModel(BuiltInModel.box(3, 3, 1, "table"));
		land.addModel(new ObjModel("card", "v -1 -1 0\\nv 1 -1 0\\nv 1 1 0\\nv -1 1 0\\nf 1 2 3 4"));
		const [card, other, table] = [new Agent("card"), new Agent("card"), new Agent("table")];
		other.moveTo(0.4, 0, 0);
		table.moveTo(0, 0, -1);
		other.hierarchical = table.hierarchical = true;
		const queries = new AgentQueries(Object.assign(new CombinationCollider(land), { exact: true }));
		queries.update([card, other, table]);
		queries.slide(card, 1, 0, 0);
		console.log(JSON.stringify(said));`;
	assert.deepEqual(warningsOf(program), []);
});

test("while a game is developed, a walker whose way up is blocked by who stands on it is warned of, and a cast agent is named", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BuiltInModel, CombinationCollider, GreatLand", module)}
		const rise = (breed, exceptBreeds) => {
			const land = new GreatLand();
			for (const model of [BuiltInModel.box(3, 3, 0.4, "lift"), BuiltInModel.box(1, 1, 1, breed), BuiltInModel.capsule(0.3, 1.8, "hero")]) land.addModel(model);
			const queries = new AgentQueries(Object.assign(new CombinationCollider(land), { exact: true }));
			const [lift, crate, hero] = [["lift", "lifts"], [breed, breed], ["hero", "heroes"]].map(([shape, of]) => new Agent(shape, of));
			lift.hierarchical = true;
			crate.moveTo(0, 0, 0.401);
			hero.moveTo(0, 0, 1.402);
			for (let i = 0; i < 150; i++) {
				lift.moveTo(0, 0, 0.01 * Math.max(0, i - 20));
				queries.update([lift, crate, hero]);
				queries.walk(crate, 0, 0, { fall: 0.1, filter: { exceptBreeds } });
				queries.walk(hero, 0, 0, { fall: 0.1 });
			}
			if ((crate.z > lift.z) !== exceptBreeds.length > 0) throw new Error(crate.z + " " + lift.z);
			if (exceptBreeds.length > 0) crate.moveTo(0, 0, lift.z - 0.3), queries.castAgent(crate, 0.1, 0, 0, { except: [hero] });
		};
		rise("crates", []);
		rise("boxes", ["heroes"]);
		const enemy = Object.assign(new Agent("lift", "enemies"), { hierarchical: true });
		const land = new GreatLand();
		land.addModel(BuiltInModel.box(3, 3, 3, "lift"));
		land.addModel(BuiltInModel.sphere());
		const queries = new AgentQueries(Object.assign(new CombinationCollider(land), { exact: true }));
		for (let i = 0; i < 30; i++) enemy.moveTo(0.1 * i, 0, 0);
		const guest = Object.assign(new Agent("sphere", "guests"), { x: 2.9, z: 1.5, size: 0.2 });
		queries.update([enemy, guest]);
		queries.walk(guest, 0.01, 0);
		console.log(JSON.stringify(said));`;
	const [blocked, cast, moving, ...others] = warningsOf(program);
	assert.match(blocked, /agent \d+ \(breed "crates".*deep inside of agent \d+ \(breed "lifts".* Its way up is blocked by agent \d+ \(breed "heroes".*leave that one out of the filter of its walk/);
	assert.match(cast, /agent \d+ \(breed "boxes", shape "boxes"\) begins a motion at/);
	assert.match(moving, /\(breed "enemies", shape "lift"\), which does not stop it\. That one moves: /);
	assert.deepEqual(others, []);
});

test("while a game is developed, settings that a constructor does not take, levels without a tree and falls without end are warned of, once", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BinCollider, BuiltInModel, CombinationCollider, GreatLand, HierarchicalCollider, TightestFitCollider", module)}
		const land = new GreatLand();
		land.addModel(BuiltInModel.box(40, 40, 8, "ground"));
		land.addModel(BuiltInModel.capsule(0.3, 1.8, "hero"));
		new TightestFitCollider(land), new BinCollider();
		for (let i = 0; i < 2; i++) new HierarchicalCollider(land, { exact: true });
		class Own extends TightestFitCollider { constructor(land, more) { super(land); this.more = more; } }
		new Own(land, 3);
		const queries = new AgentQueries(Object.assign(new CombinationCollider(land), { exact: true }));
		const [level, hero, twin] = [new Agent("ground", "levels"), new Agent("hero", "heroes"), new Agent("hero", "heroes")];
		level.moveTo(0, 0, -8);
		queries.update([level, hero, twin]);
		queries.walk(hero, 0.1, 0);                     // in its twin, which is no larger
		if (said.length > 1) throw new Error(said.join());
		hero.moveTo(2, 3, -6);
		for (let i = 0; i < 3; i++) queries.walk(hero, 0.1, 0);
		hero.moveTo(100, 0, 500);
		for (let i = 0; i < 199; i++) queries.walk(hero, 0.1, 0);
		hero.moveTo(100, 0, 500);                       // begun anew
		for (let i = 0; i < 199; i++) queries.walk(hero, 0.1, 0);
		if (said.some((text) => text.includes("has fallen"))) throw new Error("too early");
		const [lift, rider] = [new Agent("ground", "lifts"), new Agent("hero", "riders")];
		rider.moveTo(300, 0, 408);
		for (let i = 0; i < 250; i++) {                 // it stands on a lift that sinks
			lift.moveTo(300, 0, 400 - 0.05 * i);
			queries.update([level, hero, twin, lift, rider]);
			if (i > 0 && Math.abs(queries.walk(rider, 0, 0).on.z - rider.z + 8) > 1e-6) throw new Error("it is not carried");
		}
		for (let i = 0; i < 199; i++) queries.walk(hero, 0.1, 0);
		console.log(JSON.stringify(said));`;
	const said = warningsOf(program);
	const expected = [/new HierarchicalCollider takes 1 argument, and does nothing with the others: settings such as exact are set after it/,
		/agent \d+ \(breed "heroes", shape "hero"\) begins a motion 3\.8 deep inside of the structure around agent \d+ \(breed "levels", shape "ground"\), and a walk pushes it out.*hierarchical.*CombinationCollider/,
		/agent \d+ \(breed "heroes", shape "hero"\) has fallen in 200 walks, from z = 500 to 400: .*queries\.update\(\), which is called once a frame.*breeds of the walk's filter.*AS_GIVEN or of levelFromObject.*"y"/];
	assertEach(said, expected);
});

test("while a game is developed, a level that collides as the structure around it is warned of, once", () => {
	const program = (module) => `${beginning("Agent, BuiltInModel, Collision, CombinationCollider, GreatLand, HierarchicalCollider, Model, TightestFitCollider", module)}
		const land = new GreatLand();
		const cube = BuiltInModel.cube();
		const triangles = Array.from({ length: 10001 }, (_, i) => [...cube.triangles.slice(0, 3)]).flat();
		land.addModel(new Model("level", cube.vertices, triangles));
		land.addModel(new Model("figure", cube.vertices, triangles.slice(3)));
		const seenBy = (system, shape, traits) => {
			const handled = new Collision(system);
			handled.onCollision("a", "a", () => {});
			for (let i = 0; i < 2; i++) handled.update([0, 1].map(() => Object.assign(new Agent(shape, "a"), traits)));
			return said.splice(0);
		};
		console.log(JSON.stringify([
			seenBy(new HierarchicalCollider(land), "level", {}),
			seenBy(new CombinationCollider(land), "level", { hierarchical: true }),
			seenBy(new TightestFitCollider(land), "level", { collideAs: "box" }),
			seenBy(new TightestFitCollider(land), "figure", {}),
			seenBy(new TightestFitCollider(land), "level", {}),
			seenBy(new CombinationCollider(land), "level", {}),
		]));`;
	const said = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(said.map((texts) => texts.length), [0, 0, 0, 0, 1, 1], JSON.stringify(said));
	assert.match(said[4][0], /\(breed "a", shape "level"\) has 10001 triangles, and collides as the structure around them: for a level set hierarchical to true in a CombinationCollider/);
	assert.ok(printedBy(program("starlogo-collision.min.js")).every((texts) => texts.length === 0));
});

test("while a game is developed, a shot that is moved before its first frame is warned of, once", () => {
	const program = (module) => `${beginning("Agent, BinCollider, Collision", module)}
		const collision = new Collision(new BinCollider());
		const agents = [];
		const counts = [];
		/** A frame with a shot that is put somewhere and then moved. */
		function shoot(shot, put, dx) {
			shot[put](1, 2, 0);
			agents.push(shot);
			shot.x += dx;
			collision.update(agents);
			shot.moveTo(shot.x + 3, 2, 0);
			collision.update(agents);
			counts.push(said.length);
		}
		const shot = (settings) => Object.assign(new Agent("sphere", "shots"), { sweeps: true, size: 0.5 }, settings);
		const pooled = shot();
		shoot(pooled, "moveTo", 0);
		shoot(shot(), "jumpTo", 0.2);
		shoot(shot({ sweeps: false }), "moveTo", 2);
		const late = shot();
		late.moveTo(0, 0, 0);
		collision.update(agents);
		shoot(late, "moveTo", 0);
		agents.length = 0;
		shoot(pooled, "jumpTo", 2);
		shoot(shot(), "moveTo", 2);
		// it is where its field says, and not where it was put
		class Bullet extends Agent { x = 9; sweeps = true; }
		const bullet = new Bullet("sphere");
		bullet.moveTo(1, 2, 0);
		collision.update([bullet]);
		counts.push(said.length);
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 0, 0, 0, 1, 1, 3], said.join("\n"));
	["x", "sweeps"].forEach((name, i) => assert.match(said[i + 1], new RegExp(`: ${name} is a field of Bullet that hides the engine's`)));
	assert.match(said[0], /^starlogo-collision: agent \d+ \(breed "shots", shape "sphere"\) sweeps, and was moved by 2 between its place \(1, 2, 0\) and its first frame\. /);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, a shot that passes through another agent without sweeps is warned of, once, and not what meets nobody, nobody handles, a question moves, turns, jumps or is slow", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BinCollider, Collision", module)}
		const collision = new Collision(new BinCollider());
		for (const breed of ["shots", "birds"]) collision.onCollisionStart(breed, "walls", () => 0);
		const queries = new AgentQueries(collision);
		const agents = [new Agent("sphere", "walls")];
		agents[0].size = 0.5;
		agents[0].moveTo(11.8, 50, 0);
		const counts = [];
		/** Puts an agent somewhere, and moves it in twelve frames. */
		function fly(agent, move, put = "moveTo") {
			agent.size = 0.5;
			agent[put](1, 50, 0);
			agents.push(agent);
			collision.update(agents);
			for (let i = 0; i < 12; i++) {
				move(agent, i);
				queries.update(agents);
				collision.update(agents);
			}
			agents.pop();
			counts.push(said.length);
		}
		const ahead = (agent, i) => agent.moveTo(agent.x + 1.4 + 0.1 * (i % 2), 50, 0);
		fly(new Agent("sphere", "sparks"), ahead);
		fly(Object.assign(new Agent("sphere", "shots"), { sweeps: true }), ahead);
		fly(new Agent("sphere", "shots"), (agent) => queries.moveUntilTouch(agent, 1.4, 0, 0));
		fly(new Agent("sphere", "birds"), (agent, i) => agent.moveTo(10 * Math.cos(i), 50 + 10 * Math.sin(i), 0));
		fly(new Agent("sphere", "birds"), (agent) => agent.jumpTo(agent.x + 1.4, 50, 0));
		fly(new Agent("sphere", "birds"), (agent) => agent.moveTo(agent.x + 0.9, 50, 0));
		const pooled = new Agent("sphere", "shots");
		fly(pooled, (agent) => agent.moveTo(agent.x + 0.1, 50, 0));
		const wall = agents[0];
		wall.jumpTo(1, 90, 0);
		fly(pooled, ahead, "jumpTo");
		wall.size = 8;
		wall.jumpTo(11.8, 50, -4);
		fly(pooled, ahead, "jumpTo");
		wall.size = 0.5;
		// a convoy
		wall.sweeps = true;
		fly(new Agent("sphere", "shots"), (agent, i) => (ahead(agent, i), wall.moveTo(agent.x - 0.7, 50, 0)));
		wall.sweeps = false;
		// one that flies ahead of another, and a wall that a filter leaves out
		fly(new Agent("sphere", "shots"), (agent, i) => (agent.moveTo(agent.x + 1.5, 50, 0), wall.moveTo(agent.x - 0.8, 50, 0)));
		wall.jumpTo(11.8, 50, 0);
		collision.filter = { exceptBreeds: ["walls"] };
		fly(new Agent("sphere", "shots"), ahead);
		collision.filter = null;
		fly(pooled, ahead, "jumpTo");
		fly(new Agent("sphere", "birds"), ahead);
		// sweeps see no jumps
		fly(Object.assign(new Agent("sphere", "sparks"), { sweeps: true }), (agent, i) => (i % 2 ? agent.moveTo(agent.x + 1, 50, 0) : agent.jumpTo(agent.x + 1, 50, 0)));
		for (let i = 0; i < 2; i++) fly(Object.assign(new Agent("sphere", "shots"), { sweeps: true }), (agent) => agent.jumpTo(agent.x + 1.4, 50, 0));
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 2, 2], said.join("\n"));
	assert.match(said[1], /^starlogo-collision: agent \d+ \(breed "shots", shape "sphere"\) sweeps, and is moved by jumpTo\(\): a jump goes through everything\./);
	assert.match(said[0], /^starlogo-collision: agent \d+ \(breed "shots", shape "sphere"\) does not sweep, and has passed through agent \d+ \(breed "walls".*\): it moves by 1\.[45] patches in a frame, [23](\.\d+)? times its size\. /);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, a shot that passes through a level or a thin box without sweeps is warned of, and not one that ends in it, bends, or passes beside it", () => {
	const program = (module) => `${beginning("Agent, BuiltInModel, Collision, CombinationCollider, GreatLand", module)}
		const land = new GreatLand();
		for (const model of [BuiltInModel.sphere(), BuiltInModel.box(0.2, 6, 4, "thin"), BuiltInModel.box(4, 6, 4, "thick")]) land.addModel(model);
		const counts = [];
		/** Shots that fly along x at walls, each from another place. */
		function fly(shape, hierarchical, step, y = 0, bend = 0) {
			const collision = new Collision(Object.assign(new CombinationCollider(land), { exact: true }));
			collision.onCollisionStart("shots", "walls", () => 0);
			const wall = Object.assign(new Agent(shape, "walls"), { hierarchical });
			wall.moveTo(6, y, 0);
			for (let k = 0; k < 5; k++) {
				const shot = new Agent("sphere", "shots");
				shot.size = 0.2;
				shot.moveTo(0.5 + 0.1 * k, 0, 1);
				for (let i = 0; i < 10; i++) {
					const { x, z } = shot;
					collision.update([wall, shot]);
					if (shot.x !== x || shot.z !== z) throw new Error("it was moved");
					shot.moveTo(x + step, bend * (i % 2), 1);
				}
			}
			counts.push(said.splice(0).length);
		}
		fly("thick", true, 1.5);
		fly("thick", false, 1.5);
		fly("thin", true, 0.1);
		fly("thin", true, 1.5, 3.2);
		fly("thin", true, 1.5, 0, 1);
		if (HIERARCHICAL) fly("thin", true, 1.5);
		fly("thin", false, 1.5);
		console.log(JSON.stringify(counts));`;
	const counts = (hierarchical) => printedBy(program("starlogo-collision.js").replace("HIERARCHICAL", hierarchical));
	assert.deepEqual(counts(true), [0, 0, 0, 0, 0, 1, 0]);
	assert.deepEqual(counts(false), [0, 0, 0, 0, 0, 1]);
});

test("while a game is developed, a platform that jumps sideways below a walker is warned of, once, and one that carries, goes up or down, or is far away never", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BuiltInModel, Footing, GreatLand, TightestFitCollider", module)}
		const land = new GreatLand();
		for (const model of [BuiltInModel.box(3, 3, 1, "lift"), BuiltInModel.capsule(0.3, 1.8, "hero")]) land.addModel(model);
		const queries = new AgentQueries(new TightestFitCollider(land));
		const footing = new Footing();
		const counts = [];
		function ride(move, way, rise = () => 0, isTaken = false) {
			const [lift, hero] = [new Agent("lift", "lifts"), new Agent("hero", "heroes")];
			hero.moveTo(0, 0, 1);
			for (let i = 0; i < 30; i++) {
				lift[move](lift.x + way(i), 0, lift.z + rise(i));
				if (isTaken) hero.jumpTo(lift.x, 0, hero.z);
				queries.update([lift, hero]);
				queries.walk(hero, 0, 0, null, footing);
			}
			counts.push(said.length);
		}
		const [none, little] = [() => 0, () => 0.02];
		ride("moveTo", little);
		ride("jumpTo", (i) => i % 10 === 0 ? 20 : 0);
		ride("jumpTo", none, little);
		ride("jumpTo", none, () => -0.02);
		ride("jumpTo", little, none, true);
		ride("jumpTo", (i) => i % 2 ? 0.02 : -0.02);
		ride("jumpTo", little);
		ride("jumpTo", little);
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 0, 0, 0, 0, 0, 1, 1], said.join("\n"));
	assert.match(said[0], /^starlogo-collision: agent \d+ \(breed "lifts", shape "lift"\) is moved by jumpTo\(\) while agent \d+ \(breed "heroes", shape "hero"\) stands on it\. /);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, a level that was normalised is warned of, once, and what is placed or small is not", () => {
	const program = (module) => `${beginning("Agent, BuiltInModel, Collision, CombinationCollider, GreatLand, Model", module)}
		const wide = [0, 0, 0, 40, 0, 0, 0, 30, 0, 0, 0, 3];
		const corners = [0, 1, 2, 0, 1, 3, 0, 2, 3];
		const land = new GreatLand();
		land.addModel(new Model("small", wide.map((each) => each / 10), corners));
		land.addModel(new Model("given", wide, corners, Model.AS_GIVEN));
		land.addModel(new Model("level", wide, corners));
		const counts = [];
		for (const [shape, settings] of [["small", {}], ["given", {}], ["level", { size: 40 }], ["level", { x: 3 }], ["level", { hierarchical: false }], ["level", {}]]) {
			const collision = new Collision(new CombinationCollider(land));
			const agents = [Object.assign(new Agent(shape), { hierarchical: true }, settings)];
			for (let frame = 0; frame < 70; frame++) collision.update(agents);
			counts.push(said.length);
		}
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 0, 0, 0, 0, 1], said.join("\n"));
	assert.match(said[0], /agent \d+ \(.*shape "level"\) is one patch wide, and its model was 40 units wide before it was normalised\. .*Model\.AS_GIVEN.*levelFromObject/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, a model without triangles where triangles decide is warned of, once", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BuiltInModel, CombinationCollider, GreatLand, HierarchicalCollider, Model", module)}
		const corners = [-5, -5, 0, 5, -5, 0, 5, 5, 0];
		const land = new GreatLand();
		land.addModel(BuiltInModel.cube());
		land.addModel(new Model("points", corners));
		land.addModel(new Model("triangle", corners, [0, 1, 2]));
		const counts = [];
		for (const [Collider, exact, shape, hierarchical] of [[CombinationCollider, false, "points", true], [CombinationCollider, true, "points", false], [CombinationCollider, true, "triangle", true],
			[HierarchicalCollider, true, "cube", false], [HierarchicalCollider, true, "points", false], [CombinationCollider, true, "points", true]]) {
			const queries = new AgentQueries(Object.assign(new Collider(land), { exact }));
			queries.update([Object.assign(new Agent(shape), { hierarchical })]);
			counts.push(said.length);
		}
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 0, 0, 0, 1, 1], said.join("\n"));
	assert.match(said[0], /agent \d+ \(.*shape "points"\) has gaps: .* its model has only vertices\. .*new Model\(.*levelFromObject/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, a forgotten update of questions is warned of if no Collision counts the frames, once", () => {
	const program = (module) => `${beginning("Agent, AgentMotions, AgentQueries, BuiltInModel, GreatLand, SeenAgents, TightestFitCollider", module)}
		const land = new GreatLand();
		for (const model of [BuiltInModel.capsule(0.3, 1.8, "hero"), BuiltInModel.box(4, 4, 0.2, "lift")]) land.addModel(model);
		const [lift, hero, friend] = [new Agent("lift", "lifts"), new Agent("hero", "heroes"), new Agent("hero", "heroes")];
		friend.moveTo(1, 1, 0.2);
		/** Plays some frames in which the lift goes down, or up; sees what has moved in these ways. */
		function play(frames, { update = null, refresh = null, motions }) {
			for (let i = 0; i < frames; i++) {
				lift.moveTo(0, 0, i * 0.0001);
				update?.([lift, hero, friend]);
				refresh?.(lift);
				motions.walk(hero, 0.001, 0, { fall: 0 });
				motions.slide(friend, 0, 0.001, 0);
			}
			return said.length;
		}
		const queries = new AgentQueries(new TightestFitCollider(land));
		const seen = new SeenAgents(new TightestFitCollider(land));
		for (const each of [queries, seen]) each.update([lift, hero, friend]);
		// far from the lift: what carries nobody may have moved for longer
		hero.moveTo(9, 0, 0);
		const counts = [play(400, { update: (agents) => queries.update(agents), motions: queries }), play(400, { refresh: (agent) => queries.refresh(agent), motions: queries }),
			play(299, { motions: new AgentMotions(seen) }), play(9, { motions: new AgentMotions(seen) }), play(400, { motions: queries })];
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 0, 0, 1, 1], said.join("\n"));
	assert.match(said[0], /questions see agent \d+ \(.*shape "lift"\) where it was at the last queries\.update\(agents\), 30\d motions of agent \d+ \(.*shape "hero"\) ago: call it once a frame/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, a lift that rises below a walker without an update of questions is warned of soon, and one that is refreshed or left never", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BuiltInModel, Footing, GreatLand, TightestFitCollider", module)}
		const land = new GreatLand();
		for (const model of [BuiltInModel.capsule(0.3, 1.8, "hero"), BuiltInModel.box(4, 4, 0.2, "lift")]) land.addModel(model);
		const [lift, hero, floor] = [new Agent("lift", "lifts"), new Agent("hero", "heroes"), new Agent("lift", "floors")];
		const queries = new AgentQueries(new TightestFitCollider(land));
		const footing = new Footing();
		/** Plays frames in which the lift rises and the hero stands on it, or beside it. */
		function play(frames, x, see) {
			hero.moveTo(x, 0, 0.2);
			lift.moveTo(0, 0, 0);
			floor.moveTo(6, 0, 0);
			queries.update([lift, floor, hero]);
			for (let i = 0; i < frames; i++) {
				lift.moveTo(0, 0, 0.01 * i);
				see?.();
				queries.walk(hero, 0, 0, { fall: 0.2 }, footing);
			}
			return said.length;
		}
		const counts = [play(60, 0, () => queries.update([lift, floor, hero])), play(60, 0, () => queries.refresh(lift)), play(60, 6), play(29, 0),
			play(40, 0, () => (queries.update([lift, floor, hero]), lift.moveTo(0, 0, lift.z + 0.005))), play(40, 0), play(40, 0)];
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 0, 0, 0, 1, 2, 2], said.join("\n"));
	assert.match(said[0], /shape "lift"\) moves after queries\.update\(agents\), in 30 frames in turn, and then agent \d+ .*shape "hero"\) moves, which stands on it: move it before the update/);
	assert.match(said[1], /questions see agent \d+ \(.*shape "lift"\) where it was at the last queries\.update\(agents\), 3\d motions of agent \d+ \(.*shape "hero"\), which stands on it, ago: call it once a frame/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, a platform that moves after the update is warned of if others walk too, on the floor and with the same Footing", () => {
	const { said } = printedBy(`${beginning("Agent, AgentQueries, BuiltInModel, Footing, GreatLand, TightestFitCollider", "starlogo-collision.js")}
		const land = new GreatLand();
		for (const model of [BuiltInModel.capsule(0.3, 1.8, "hero"), BuiltInModel.box(4, 4, 0.2, "lift")]) land.addModel(model);
		const [lift, hero, floor, friend] = [new Agent("lift", "lifts"), new Agent("hero", "heroes"), new Agent("lift", "floors"), new Agent("hero", "friends")];
		const queries = new AgentQueries(new TightestFitCollider(land));
		const footing = new Footing();
		floor.moveTo(6, 0, 0);
		hero.moveTo(0, 0, 0.2);
		friend.moveTo(6, 0, 0.2);
		for (let i = 0; i < 40; i++) {
			queries.update([lift, floor, hero, friend]);
			lift.moveTo(0, 0, lift.z + 0.005);
			for (const walker of [friend, hero]) queries.walk(walker, 0, 0, { fall: 0.2 }, footing);
		}
		console.log(JSON.stringify({ said }));`);
	assert.equal(said.length, 1);
	assert.match(said[0], /shape "lift"\) moves after queries\.update\(agents\), in 30 frames in turn, and then agent \d+ \(breed "heroes"/);
});

test("an error says that a point's numbers are passed one by one, while a game is developed", () => {
	const program = (module) => `import { Agent } from ${JSON.stringify(pathToFileURL(path.join(folder, module)))};
		try { new Agent("cube").moveTo({ x: 1, y: 2, z: 3 }); } catch ({ message }) { console.log(message); }`;
	const run = (module) => execFileSync(process.execPath, ["--input-type=module", "--eval", program(module)], { encoding: "utf8" }).trim();
	assert.match(run("starlogo-collision.js"), /: x must be a number, not a plain object\. It takes the numbers of a point one by one: point\.x, point\.y, point\.z$/);
	assert.match(run("starlogo-collision.min.js"), /: x must be a number, not a plain object$/);
});

test("while a game is developed, a ground that comes after the update of questions is warned of, once, and not if it is exchanged or new to a frame", () => {
	const program = (module) => `${beginning("Agent, AgentMotions, AgentQueries, BinCollider, Collision, SeenAgents, Terrain", module)}
		const ask = (queries) => queries.cast({ x: 0, y: 0, z: 9 }, { x: 0, y: 0, z: -1 });
		const hero = new Agent("hero");
		const makeQueries = (ground) => {
			const game = new Collision(new BinCollider());
			game.terrain = ground;
			const queries = new AgentQueries(game);
			queries.update([hero]);
			ask(queries);
			return queries;
		};
		const makeGround = () => new Terrain(9, 9, 1, -4, -4);
		const [exchanged, taken, late, early] = [makeGround(), makeGround(), null, null].map(makeQueries);
		exchanged.terrain = makeGround();
		taken.terrain = null;
		early.terrain = makeGround();
		early.update([hero]);
		for (const queries of [exchanged, taken, early]) ask(queries);
		const counts = [said.length];
		late.terrain = makeGround();
		for (let i = 0; i < 2; i++) ask(late);
		counts.push(said.length);
		console.log(JSON.stringify({ said, counts }));`;
	const { said, counts } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(counts, [0, 1], said.join("\n"));
	assert.match(said[0], /the ground was set after the last queries\.update\(agents\), so questions do not see it/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, snapshots that put nobody back are warned of, once, and those of games that keep the traits never", () => {
	const program = (module) => `${beginning("Agent, BinCollider, Collision", module)}
		const agents = ["heroes", "coins"].map((breed) => new Agent("sphere", breed));
		const places = () => agents.map(({ x, y, z }) => [x, y, z]);
		const putBack = (kept) => agents.forEach((agent, i) => agent.moveTo(...kept[i]));
		const play = (take) => {
			const game = new Collision(new BinCollider());
			game.onCollisionStart("heroes", "coins", (hero) => (hero.x += 2));
			return take(game, () => (agents[0].moveTo(0, 0, 0), game.update(agents), [...game.lastAgents]));
		};
		const right = [
			// with traits; without, but put back, after a handler has moved one too; of an empty game
			(game, frame) => { const listed = frame(); const bytes = game.snapshot({ withTraits: true }); agents[1].x += 5; game.restore(bytes, listed); },
			(game, frame) => { for (let i = 0; i < 3; i++) { const listed = frame(); const [bytes, kept] = [game.snapshot(), places()]; agents[1].x += 5; frame(); putBack(kept); game.restore(bytes, listed); } },
			(game, frame) => { const first = game.snapshot(); frame(); game.restore(first, []); },
			(game) => { game.update([]); game.restore(game.snapshot(true), []); },
			// other objects, and a game that rewinds frame by frame
			(game, frame) => { const listed = frame(); const bytes = game.snapshot(); game.restore(structuredClone(bytes), listed.map(({ shape, breed }) => new Agent(shape, breed))); },
			(game, frame) => { for (let i = 0; i < 99; i++) { const listed = frame(); const bytes = game.snapshot(); agents[1].x += 1; if (i > 50) game.restore(bytes, listed); } },
		];
		const wrong = [
			(game, frame) => { const [bytes, listed] = [game.snapshot(true), [...game.lastAgents]]; frame(); game.restore(bytes, listed); },
			(game, frame) => { const listed = frame(); const bytes = game.snapshot(); agents[1].moveTo(9, 0, 0); for (let i = 0; i < 2; i++) game.restore(structuredClone(bytes), listed); },
		];
		for (const each of right) play(each);
		const before = said.length;
		for (const each of wrong) play(each);
		console.log(JSON.stringify({ said, before }));`;
	const { said, before } = printedBy(program("starlogo-collision.js"));
	assert.equal(before, 0, said.join("\n"));
	assert.equal(said.length, 2, said.join("\n"));
	assert.match(said[0], /a snapshot before the first update has no agents/);
	assert.match(said[1], /restore\(\) leaves agent \d+ \(breed "coins".*\) at \(9, 0, 0\), and it was at \(.*\) when the snapshot was taken, which has no traits/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, walks that stop before what has a handler with the walker are warned of, once, unless the two meet otherwise", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BuiltInModel, Collision, Footing, GreatLand, Terrain, TightestFitCollider", module)}
		const land = new GreatLand();
		for (const model of [BuiltInModel.sphere(), BuiltInModel.capsule(0.3, 1.8, "hero"), BuiltInModel.box(1, 1, 3, "wall")]) land.addModel(model);
		const game = new Collision(new TightestFitCollider(land));
		const queries = new AgentQueries(game);
		let calls = 0;
		for (const breed of ["coins", "doors", "foes"]) game.onCollisionStart("heroes", breed, () => calls++);
		game.onCollision("coins", Collision.ANY_BREED, () => 0);
		const play = (shape, breed, filter, frames = 30) => {
			const [hero, other] = [new Agent("hero", "heroes"), new Agent(shape, breed)];
			other.moveTo(1.5, 0, 0.5);
			for (let i = 0; i < frames; i++) {
				queries.update([hero, other]);
				queries.walk(hero, 0.1, 0, { stepHeight: 0.3, fall: 0, filter });
				if (breed === "foes" && i === 12) other.moveTo(hero.x + 0.7, 0, 0.5);
				game.update([hero, other]);
			}
			return said.length + " " + calls;
		};
		const steps = [play("wall", "walls"), play("sphere", "coins", { exceptBreeds: ["coins"] }), play("sphere", "foes"), play("sphere", "doors", null, 9), play("wall", "doors"), play("wall", "doors")];
		const [hero, floor] = [new Agent("hero", "heroes"), new Agent("wall", "floors")];
		game.onCollision("heroes", "floors", () => calls++);
		hero.moveTo(0, 0, 3.2);
		for (let i = 0; i < 12; i++) {
			queries.update([hero, floor]);
			queries.walk(hero, 0.01, 0);
			game.update([hero, floor]);
		}
		steps.push(said.length + " " + calls);
		game.onCollision("heroes", Collision.TERRAIN, () => calls++);
		game.terrain = new Terrain(20, 20);
		hero.moveTo(9, 9, 0.1);
		for (let i = 0; i < 12; i++) {
			queries.update([hero]);
			queries.walk(hero, 0.01, 0);
			game.update([hero]);
		}
		game.terrain = null;
		steps.push(said.length + " " + calls);
		let asked = 0;
		const [blocked, wall] = [new Agent("hero", "heroes"), new Agent("wall", "doors")];
		wall.moveTo(1, 0, 0);
		for (let i = 0; i < 12; i++) {
			queries.update([blocked, wall]);
			queries.walk(blocked, 0.1, 0, { filter: { accepts: () => (asked++, true) } });
			const before = asked;
			game.update([blocked, wall]);
			if (asked !== before || asked === 0) throw new Error("a game's accepts was called in an update");
		}
		// a walk after one that was refused
		const footing = new Footing();
		for (const agent of [blocked, null, blocked]) {
			try {
				queries.walk(agent, 0.1, 0, null, footing);
			} catch ({ constructor: { name } }) {
				if (agent || name !== "ArgumentError") throw new Error(name);
			}
		}
		console.log(JSON.stringify({ said, steps }));`;
	const { said, steps } = printedBy(program("starlogo-collision.js"));
	// no handlers, left out, met after a while, not stopped for long, stopped, stood on, and on the ground
	assert.deepEqual(steps, ["0 0", "0 1", "0 2", "0 2", "1 2", "1 2", "2 2", "3 2"]);
	assert.match(said[0], /a walk of "heroes" stops before "doors" and does not touch them, so the handlers of the two do not run while it only stands there\..* leave them out: .*\{ filter: \{ exceptBreeds: \["doors"\] \} \}/);
	assert.match(said[0], /bump into them, ask what has stopped it: the Footing's against/);
	assert.match(said[1], /a walk of "heroes" ends on "floors" and does not touch them, so the handlers.* fall through them, leave them out: .*stand on them, ask what it stands on: the Footing's on$/);
	assert.match(said[2], /a walk of "heroes" ends on Collision\.TERRAIN and does not touch them, so the handlers of the two do not run while it only stands there\. If it should stand on them, ask what it stands on: the Footing's on$/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, handlers that are not there to be removed, the world's breeds without their mark, and a star in a filter are warned of, once", () => {
	const program = (module) => `${beginning("Agent, AgentFilter, AgentQueries, BinCollider, Collision, Terrain", module)}
		const collision = new Collision(new BinCollider());
		const eat = () => 0;
		collision.onCollision("wolves", "sheep", eat);
		collision.onCollisionEnd("wolves", "terrain", eat);
		collision.update([new Agent("sphere", "wolves"), new Agent("sphere", "sheep")]);
		// a right game whose ground is made of agents too
		const right = new Collision(new BinCollider());
		right.onCollision("wolves", Collision.TERRAIN, eat);
		right.terrain = new Terrain(3, 3);
		right.update([new Agent("sphere", "wolves"), new Agent("sphere", "terrain")]);
		const queries = new AgentQueries(right);
		const pack = [new Agent("sphere", "wolves"), new Agent("sphere", "sheep")];
		queries.update(pack);
		for (let i = 0; i < 2; i++) queries.touching(pack[0], { breeds: ["*"] });
		const removed = [["wolfs", "sheep", eat], ["wolves", "sheep", eat.bind(null)], ["wolves", "sheep", eat], ["wolves", "sheep", eat]].map((each) => collision.removeHandler(...each));
		try {
			const nobody = new AgentFilter();
			nobody.except = [null, undefined];
			nobody.except = ["sheep"];
		} catch (error) {
			removed.push(error.message);
		}
		console.log(JSON.stringify({ said, removed }));`;
	const { said, removed } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(removed, [false, false, true, false, 'AgentFilter.except[0] must be an Agent, not "sheep"']);
	const expected = [/no agent is of the breed "terrain"; is Collision\.TERRAIN meant\?/,
		/a filter names the breed "\*", which no agent has; without breeds it takes agents of any breed$/,
		/removeHandler removes nothing for "wolfs" and "sheep": the function eat is one for "wolves" and "sheep", "wolves" and "terrain"/,
		/removeHandler removes nothing for "wolves" and "sheep": the function bound eat was never added: .* bind\(\)/];
	assertEach(said, expected);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")), { said: [], removed });
});

test("while a game is developed, questions that have not seen what restore() has put back, and twins with one place, are warned of, once", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, BinCollider, BuiltInModel, Collision, CombinationCollider, GreatLand, HierarchicalCollider, TightestFitCollider", module)}
		const agents = ["heroes", "coins"].map((breed) => new Agent("sphere", breed));
		const [hero, coin] = agents;
		const collision = new Collision(new BinCollider());
		const queries = new AgentQueries(collision);
		const back = (move) => {
			collision.update(agents);
			const bytes = collision.snapshot(true);
			move();
			queries.update(agents);
			collision.restore(bytes, agents);
		};
		const counts = [];
		const count = () => { queries.near(hero, 9); queries.near(hero, 9); counts.push(said.length); };
		back(() => 0);                                  // nothing has moved
		count();
		back(() => coin.moveTo(99, 0, 0));
		queries.update(agents);
		count();
		for (let i = 0; i < 2; i++) {
			back(() => coin.moveTo(99, 0, 0));
			count();
		}
		const fields = { x: hero.x, y: hero.y };
		collision.update([Object.assign(new Agent("sphere", "heroes"), fields)]);
		counts.push(said.length);
		for (let i = 0; i < 2; i++) collision.update([Object.assign(new Agent("sphere", "heroes"), hero)]);
		counts.push(said.length);
		const land = new GreatLand();
		land.addModel(BuiltInModel.sphere());
		const refused = [];
		for (const collider of [new BinCollider(), new TightestFitCollider(land), new HierarchicalCollider(land), new CombinationCollider(land)]) {
			for (const updated of [new Collision(collider), new AgentQueries(collider)]) {
				try {
					updated.update([hero, { ...hero }]);
				} catch ({ message }) {
					refused.push(message);
				}
			}
		}
		console.log(JSON.stringify({ said, counts, refused }));`;
	const { said, counts, refused } = printedBy(program("starlogo-collision.js"));
	assert.deepEqual(refused.map((text) => /^(\w+)\.update: agents\[1\] must be an Agent, not a plain object\. A copy of .*docs\/questions\.md/.exec(text)?.[1]), Array.from({ length: 8 }, (_, i) => ["Collision", "AgentQueries"][i % 2]));
	assert.deepEqual(counts, [0, 0, 1, 1, 1, 2], said.join("\n"));
	assert.match(said[0], /questions do not see agent \d+ \(breed "coins", shape "sphere"\) where restore\(\) has put it: call queries\.update\(agents\) after restore\(\), before you ask$/);
	assert.match(said[1], /agent \d+ .* is at the place of another agent, always: .*Object\.assign has copied.*"How is an agent copied\?"$/);
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")).said, []);
});

test("while a game is developed, motions that have not seen what restore() has put back are warned of", () => {
	const program = (ask) => `${beginning("Agent, AgentMotions, BinCollider, Collision, SeenAgents, Sphere, Vector3D", "starlogo-collision.js")}
		const agents = [new Agent("sphere", "heroes"), new Agent("sphere", "coins")];
		const [hero, coin] = agents;
		const collision = new Collision(new BinCollider());
		const seen = new SeenAgents(collision);
		const motions = new AgentMotions(seen);
		collision.update(agents);
		const bytes = collision.snapshot(true);
		coin.moveTo(99, 0, 0);
		seen.update(agents);
		collision.restore(bytes, agents);
		${ask};
		console.log(JSON.stringify(said));`;
	for (const ask of ["motions.castShape(new Sphere(new Vector3D(0, 0, 9), 1), 1, 0, 0)", "motions.slide(hero, 0, 0, 1)", "motions.walk(hero, 0, 0)"]) {
		const said = printedBy(program(ask));
		assert.equal(said.length, 1, ask);
		assert.match(said[0], /questions do not see agent \d+ \(breed "coins", shape "sphere"\) where restore\(\) has put it/, ask);
	}
	assert.deepEqual(printedBy(program("seen.update(agents); motions.slide(hero, 0, 0, 1)")), []);
});

test("while a game is developed, a figure that its own poses move out of its structure is warned of, once, and one that has its tree or stays inside is not", () => {
	const program = (module) => `${beginning("Agent, AgentQueries, Collision, CombinationCollider, GreatLand, Model", module)}
		const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
		const triangles = [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2];
		function play(name, reach, isHierarchical) {
			const land = new GreatLand();
			const model = new Model(name, corners, triangles, Model.AS_GIVEN);
			land.addModel(model);
			const figure = Object.assign(new Agent(name, "figures"), { hierarchical: isHierarchical });
			const collision = new Collision(new CombinationCollider(land));
			const queries = new AgentQueries(collision);
			for (let i = 0; i < 70; i++) {
				model.pose(corners.map((each, k) => (k === 3 ? 1 + reach * Math.min(1, i / 30) : each)));
				queries.update([figure]);
				collision.update([figure]);
			}
		}
		play("inside", -0.3, false);
		play("tree", 4, true);
		play("arm", 4, false);
		console.log(JSON.stringify(said));`;
	assertEach(warningsOf(program), [/shape "arm"\) collides as the structure around the first pose of its model/]);
});

test("while a game is developed, agents that are frozen are warned of, once", () => {
	const program = (module) => `${beginning("Agent, BinCollider, Collision", module)}
		const [moved, frozen] = [new Agent("cube"), new Agent("cube")];
		const collision = new Collision(new BinCollider());
		collision.update([moved, frozen]);
		Object.freeze(frozen);
		for (let i = 0; i < 9; i++) collision.update([moved, frozen]);
		console.log(JSON.stringify(said));`;
	assertEach(warningsOf(program), [/agent \d+ \(.*\) is frozen, so it can't move: keep agents out of a store that freezes its state$/]);
});

test("while a game is developed, a model's name that is misspelt is warned of, once", () => {
	const program = (module) => `${beginning("BuiltInModel, GreatLand", module)}
		const land = new GreatLand();
		land.addModel(BuiltInModel.sphere());
		land.addModel(BuiltInModel.capsule(0.3, 1.8, "hero"));
		land.expect("trees");
		const found = ["hero", "Hero", "Hero", "heros", "trees", "bear", ""].map((name) => land.modelOf(name)?.name ?? null);
		console.log(JSON.stringify({ said, found }));`;
	const found = ["hero", null, null, null, null, null, null];
	const said = ["Hero", "heros"].map((name) => `starlogo-collision: there is no model "${name}", so modelOf() is null; is "hero" meant?`);
	assert.deepEqual(printedBy(program("starlogo-collision.js")), { said, found });
	assert.deepEqual(printedBy(program("starlogo-collision.min.js")), { said: [], found });
});

test("it runs in Node", async () => {
	const sampleModule = await import(pathToFileURL(bundle("sample.node.js", { external: ["starlogo-collision"] })));
	check(await use(sampleModule, `${server.url}assets`, bear, new Uint8Array(bytes)));
	assert.ok(sampleModule.log.includes("500 of 500"), sampleModule.log.join("; "));
});

test("bundled by esbuild it runs in Node, and what is not used is left out", async () => {
	check(await use(await import(pathToFileURL(path.join(work, "sample.bundle.js"))), `${server.url}assets`, bear, new Uint8Array(bytes)));
	writeFileSync(path.join(work, "unused.ts"), 'import { GreatLand } from "starlogo-collision";\nexport const one = 1;\n');
	esbuild.buildSync({ entryPoints: [path.join(work, "unused.ts")], bundle: true, format: "esm", outfile: path.join(work, "unused.js") });
	assert.ok(readFileSync(path.join(work, "unused.js")).length < 200);
});

test("it runs in a browser and in a Worker there, bundled or not, under a strict content security policy", { timeout: PATIENCE }, async () => {
	const browser = await launch();
	try {
		const page = await browser.newPage();
		const complaints = [];
		page.on("pageerror", (error) => complaints.push(String(error)));
		page.on("console", (message) => message.type() === "error" && !/404/.test(message.text()) && complaints.push(message.text()));
		await page.goto(server.url);
		for (const name of ["/sample.js", "/sample.bundle.js"]) {
			const { here, inWorker } = await page.evaluate((each) => window.run(each), name);
			check(here);
			check(inWorker);
			assert.deepEqual(inWorker.volumes, here.volumes);
		}
		assert.deepEqual(complaints.filter((text) => !text.includes("favicon")), []);
	} finally {
		await browser.close();
	}
});
