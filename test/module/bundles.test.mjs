/** Tests of the npm package in fresh projects: what bundles weigh, what TypeScript says, and what the registry's own checks say. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { fencesIn } from "../docs/samples.mjs";

const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = path.join(root, "bin/module");
const work = path.join(root, "bin/generated/module/bundles-test");
const tools = createRequire(path.join(root, "js/module/package.json"));
const esbuild = tools("esbuild");
const KB = 1024;

// as if it were installed
before(() => {
	rmSync(work, { recursive: true, force: true });
	mkdirSync(path.join(work, "node_modules"), { recursive: true });
	symlinkSync(folder, path.join(work, "node_modules/starlogo-collision"));
	write("package.json", '{ "type": "module" }');
	write("types.ts", readFileSync(path.join(root, "test/module/types.ts"), "utf8"));
});

function write(name, text) {
	writeFileSync(path.join(work, name), text);
	return path.join(work, name);
}

/** A project of some names: its bundle. */
function bundle(names) {
	return bundleOf(`import { ${names.join(", ")} } from "starlogo-collision";\nglobalThis.used = [${names.join(", ")}];\n`);
}

/** A program's bundle by esbuild, minified. */
function bundleOf(contents) {
	const options = { stdin: { contents, resolveDir: work }, bundle: true, minify: true, format: "esm", target: "es2022", write: false };
	return esbuild.buildSync(options).outputFiles[0].text;
}

const weigh = (text) => gzipSync(text, { level: 9 }).length;

/** What a small game comes to, in a project of any kind. */
const GAME = `import { Agent, BinCollider, Collision, BuiltInModel, GreatLand, TightestFitCollider } from "starlogo-collision";

function play(collider) {
	const agents = Array.from({ length: 50 }, (_, i) => new Agent("cube", i % 2 ? "odd" : "even"));
	agents.forEach((agent, i) => agent.moveTo(0.9 * i, 0, 0));
	const collision = new Collision(collider);
	let calls = 0;
	collision.onCollision("odd", "even", (a, b, contact) => (calls += contact.depth > 0 ? 1 : 0));
	collision.update(agents);
	return calls;
}

const land = new GreatLand();
land.addModel(BuiltInModel.cube());
export const result = [play(new BinCollider()), play(new TightestFitCollider(land))].join();
`;
const RESULT = "49,49";

test("a bundle has what is used and no more", () => {
	const limits = [
		[["Vector3D"], 2],
		[["Agent", "Collision", "BinCollider"], 36.4],
		[["Agent", "Collision", "TightestFitCollider", "GreatLand", "BuiltInModel"], 83.8],
	];
	const sizes = limits.map(([names, limit]) => {
		const size = weigh(bundle(names)) / KB;
		assert.ok(size <= limit, `${names.join(", ")}: ${size.toFixed(1)} KB of ${limit}`);
		return size;
	});
	assert.deepEqual([...sizes].sort((a, b) => a - b), sizes);
	// parsers come with the loader alone
	assert.doesNotMatch(bundle(limits[2][0]), /COLLADA/);
	assert.match(bundle(["ModelLoader"]), /COLLADA/);
});

test("the package's page says what bundles weigh", () => {
	const [, table] = /^## What a bundle weighs\n([^]*?)^## /m.exec(readFileSync(path.join(root, "js/module/README.md"), "utf8"));
	const rows = [...table.matchAll(/^\|[^|]*\| (`.*`) \| ([\d.]+) \|$/gm)].map(([, names, said]) => [names.match(/[\w*]+/g), Number(said)]);
	assert.ok(rows.length > 15);
	for (const [names, said] of rows) {
		const size = weigh(names[0] === "*" ? bundleOf('export * from "starlogo-collision";') : bundle(names)) / KB;
		assert.ok(Math.abs(size - said) < (said < 10 ? 0.1 : 1), `${names.join(", ")}: ${size.toFixed(1)} KB, and the page says ${said}`);
	}
	const said = Number(/\[The lightest player\]\(.*?\) has (\d+) KB/.exec(table)[1]);
	assert.ok(Math.abs(weigh(bundleOf(COINS)) / KB - said) < 1, `the lightest player: ${(weigh(bundleOf(COINS)) / KB).toFixed(1)} KB, and the page says ${said}`);
});

test("./readable is the readable file in every bundle, and in Node", () => {
	const { outputFiles: [{ text }] } = esbuild.buildSync({ stdin: { contents: 'export { Agent } from "starlogo-collision/readable";\n', resolveDir: work }, bundle: true, format: "esm", write: false });
	assert.match(text, /Angles are in degrees/);
	assert.doesNotMatch(bundle(["Agent"]), /Angles are in degrees/);
	assert.equal(createRequire(path.join(work, "package.json")).resolve("starlogo-collision/readable"), path.join(folder, "starlogo-collision.js"));
});

test("a game loads the questions that it asks", () => {
	const level = ["Agent", "Model", "Capsule", "LevelShapes", "SeenAgents"];
	const limits = [
		[["Agent", "BinCollider", "SeenAgents", "AgentPlaces"], 32.6],
		[["Agent", "Collision", "BinCollider", "SeenAgents", "AgentPlaces"], 40.9],
		[["Agent", "Collision", "BinCollider", "AgentQueries"], 73.5],
		[[...level, "AgentRays"], 45.6],
		[[...level, "AgentMotions"], 75.5],
		[[...level, "AgentRays", "AgentMotions"], 77.1],
	];
	for (const [names, limit] of limits) {
		const size = weigh(bundle(names)) / KB;
		assert.ok(size <= limit, `${names.join(", ")}: ${size.toFixed(1)} KB of ${limit}`);
	}
	assert.ok(weigh(bundle([...level, "AgentRays"])) < weigh(bundle([...level, "AgentMotions"])));
});

// the game in js/module/README.md that loads less
const COINS = `import { Agent, AgentMotions, BuiltInModel, Capsule, Collision, Footing, LevelCollider, LevelShapes, SeenAgents, Sphere } from "starlogo-collision";

const shapes = new LevelShapes();
shapes.exact = true;
shapes.addModel(BuiltInModel.box(20, 20, 1, "floor"));
shapes.addStructure("hero", new Capsule({ x: 0, y: 0, z: 0.3 }, { x: 0, y: 0, z: 1.5 }, 0.3));
shapes.addStructure("coin", new Sphere({ x: 0, y: 0, z: 0.25 }, 0.25));
const game = new Collision(new LevelCollider(shapes));
const seen = new SeenAgents(game);
const motions = new AgentMotions(seen);
const floor = new Agent("floor");
const hero = new Agent("hero", "heroes");
hero.moveTo(0, 0, 1);
const agents = [floor, hero, ...[1, 2, 3, 9].map((x) => {
	const coin = new Agent("coin", "coins");
	coin.moveTo(x, 0, 1);
	return coin;
})];
game.onCollisionStart("heroes", "coins", (walker, coin) => agents.splice(agents.indexOf(coin), 1));
const footing = new Footing();
for (let i = 0; i < 50; i++) {
	seen.update(agents);
	motions.walk(hero, 0.1, 0, { stepHeight: 0.3, filter: { exceptBreeds: ["coins"] } }, footing);
	game.update(agents);
}
export const result = [hero.x.toFixed(6), hero.z.toFixed(6), footing.stands, agents.slice(2).map((coin) => coin.x)].join();
`;

test("a game that walks and collects coins", async () => {
	const text = bundleOf(COINS);
	const size = weigh(text) / KB;
	assert.ok(size <= 92.2, `${size.toFixed(1)} KB of 92.2`);
	const { result } = await import(`data:text/javascript;base64,${Buffer.from(text).toString("base64")}`);
	assert.equal(result, "5.000000,1.000000,true,9");
	const player = weigh(bundle(["Agent", "Collision", "CombinationCollider", "GreatLand", "BuiltInModel", "Footing", "AgentQueries"])) / KB;
	assert.ok(player <= 114.5, `with all questions: ${player.toFixed(1)} KB of 114.5`);
});

test("nothing runs when it is imported, so that bundlers may leave it out", () => {
	const text = readFileSync(path.join(folder, "starlogo-collision.js"), "utf8");
	assert.doesNotMatch(text, /^\s+static \{/m);
	assert.doesNotMatch(text, /[\0-\x08\x0b-\x1f]|["`]Error #(?!2032)/);
	const contents = 'import * as all from "./starlogo-collision.js";\nexport const one = 1;\n';
	const { text: left } = esbuild.buildSync({ stdin: { contents, resolveDir: folder }, bundle: true, format: "esm", treeShaking: true, ignoreAnnotations: false, write: false }).outputFiles[0];
	assert.ok(left.length < 200, left.slice(0, 300));
	// each statement for itself, without what package.json says
	const statements = esbuild.transformSync(`${text.slice(0, text.lastIndexOf("export {"))}`, { format: "esm", treeShaking: true }).code;
	const rest = statements.replaceAll(/^(?:const|let|var) [\w$]+ = .*;$/gm, "").replaceAll(/^\/[/*].*$/gm, "").trim();
	assert.ok(rest.length < 200, rest.slice(0, 300));
});

test("a fresh project in Node reads the package's own package.json", () => {
	write("package.mjs", 'import data from "starlogo-collision/package.json" with { type: "json" };\nconsole.log(data.name);\n');
	assert.equal(execFileSync(process.execPath, ["--no-warnings", "package.mjs"], { cwd: work, encoding: "utf8" }).trim(), "starlogo-collision");
});

test("a fresh project with Vite", async () => {
	const { build } = await import(pathToFileURL(path.join(root, "js/module/node_modules/vite/dist/node/index.js")));
	const entry = write("vite.mjs", `${GAME}export default result;\n`);
	const lib = { entry, formats: ["es"], fileName: () => "vite.bundle.mjs" };
	await build({ root: work, configFile: false, logLevel: "error", build: { lib, outDir: path.join(work, "dist"), minify: true, emptyOutDir: true } });
	const file = path.join(work, "dist/vite.bundle.mjs");
	assert.equal((await import(pathToFileURL(file))).result, RESULT);
	assert.ok(weigh(readFileSync(file)) < 104 * KB);
});

for (const [module, moduleResolution] of [["nodenext", "nodenext"], ["esnext", "bundler"]]) {
	test(`a fresh project in TypeScript, ${moduleResolution}: what is right is taken, and what is wrong refused`, () => {
		const compilerOptions = { target: "es2022", module, moduleResolution, strict: true, exactOptionalPropertyTypes: true, noEmit: true, types: [], lib: ["es2022"] };
		write(`tsconfig.${moduleResolution}.json`, JSON.stringify({ compilerOptions, files: ["types.ts"] }));
		execFileSync(process.execPath, [tools.resolve("typescript/bin/tsc"), "-p", path.join(work, `tsconfig.${moduleResolution}.json`)], { encoding: "utf8" });
	});
}

test("the package's pages show what TypeScript accepts", () => {
	const used = { "js/module/README.md": "export const found: Coin[] = coins;", "docs/snapshots.md": "savedIn(textOf({ bytes: new Uint8Array(), listed: [], present: [] }));" };
	const files = Object.entries(used).map(([page, use], i) => {
		const samples = fencesIn(readFileSync(path.join(root, page), "utf8")).filter(({ language }) => language === "ts").map(({ text }) => text);
		assert.ok(samples.length > 0);
		return write(`page${i}.ts`, `${samples.join("\n")}\n${use}\n`);
	});
	const options = ["--strict", "--noEmit", "--noUncheckedIndexedAccess", "--target", "es2022", "--module", "nodenext", "--typeRoots", "none"];
	execFileSync(process.execPath, [tools.resolve("typescript/bin/tsc"), ...options, ...files], { encoding: "utf8" });
});

test("editors do not offer the package's events where a program means the platform's", async () => {
	const { default: ts } = await import(pathToFileURL(tools.resolve("typescript")));
	const offered = (text) => {
		const file = write("complete.ts", `import { Agent } from "starlogo-collision";\nnew Agent("cube");\n${text}`);
		const options = { target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.NodeNext, moduleResolution: ts.ModuleResolutionKind.NodeNext, lib: ["lib.es2022.d.ts", "lib.dom.d.ts"], types: [], allowImportingTsExtensions: true, noEmit: true };
		const service = ts.createLanguageService({
			getScriptFileNames: () => [file], getScriptVersion: () => text, getCurrentDirectory: () => work, getCompilationSettings: () => options, getDefaultLibFileName: ts.getDefaultLibFilePath,
			getScriptSnapshot: (name) => (ts.sys.fileExists(name) ? ts.ScriptSnapshot.fromString(ts.sys.readFile(name)) : undefined),
			fileExists: ts.sys.fileExists, readFile: ts.sys.readFile, readDirectory: ts.sys.readDirectory, directoryExists: ts.sys.directoryExists, getDirectories: ts.sys.getDirectories, realpath: ts.sys.realpath,
		});
		const position = readFileSync(file, "utf8").length;
		const { entries } = service.getCompletionsAtPosition(file, position, { includeCompletionsForModuleExports: true, includeCompletionsWithInsertText: true });
		return entries.filter(({ source }) => source?.includes("starlogo-collision")).map(({ name }) => name);
	};
	assert.ok(offered("const model = new Mod").includes("Model"), "what the package exports is offered");
	for (const name of ["Event", "ErrorEvent", "ProgressEvent", "TextEvent"]) {
		assert.ok(!offered(`new ${name}`).includes(name), name);
		assert.ok(!offered(`let event: ${name}`).includes(name), `${name}, as a type`);
	}
});

test("names in errors are the sources' own in a program that is minified without them", async () => {
	const contents = `import { AgentQueries, BinCollider, Box, BoundingStructure, Capsule, GreatLand, HierarchicalCollider, Sphere, Vector3D, intersects } from "starlogo-collision";
const land = new GreatLand();
class Ring extends BoundingStructure {}
const said = (action) => { try { action(); } catch (error) { return error.message; } };
export const texts = [
	said(() => land.addModel(land)), said(() => land.addModel(new Sphere(new Vector3D(), 1))), said(() => intersects(new Ring(7), new Sphere(new Vector3D(1, 2, 3), 0.5))),
	said(() => new AgentQueries(land)), String(new HierarchicalCollider(land)), String(new Capsule(new Vector3D(), new Vector3D(1, 0, 0), 2)), JSON.stringify([Box.name, Sphere.name]),
];`;
	const { outputFiles } = esbuild.buildSync({ stdin: { contents, resolveDir: work }, bundle: true, minify: true, format: "esm", target: "es2022", write: false });
	const { texts } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);
	assert.match(texts[0], /must be a Model, not an object of class GreatLand$/);
	assert.match(texts[1], /must be a Model, not an object of class Sphere$/);
	assert.match(texts[2], /^there is no intersection test for a Sphere of radius 0\.5 at Vector3D\(1, 2, 3\) and a structure of class [\w$]+$/, "a class of the program's own has the name that the bundler gives it");
	assert.match(texts[3], /, not an object of class GreatLand; a SeenAgents may also have a LevelShapes$/);
	assert.equal(texts[4], "[object HierarchicalCollider]");
	assert.equal(texts[5], "a Capsule of radius 2 from Vector3D(0, 0, 0) to Vector3D(1, 0, 0)");
	assert.equal(texts[6], '["Box","Sphere"]');
});

/** What index.d.ts says of each declaration, in one line each. */
function documentation() {
	const text = readFileSync(path.join(folder, "index.d.ts"), "utf8");
	return [...text.matchAll(/\/\*\*([\s\S]*?)\*\/\s*([^\n]*)/g)].map(([, said, of]) => ({ of, said: said.replaceAll(/```[\s\S]*?```/g, "").replaceAll(/\n\s*\* ?/g, " ").trim() }));
}

test("the documentation has whole sentences", () => {
	const all = documentation();
	assert.ok(all.length > 500);
	for (const { of, said } of all) {
		const count = (letter) => said.split(letter).length - 1;
		assert.equal(count("("), count(")"), `${of}: ${said}`);
		assert.doesNotMatch(said, /[,;(]\s*$|[,;(:]\s+@(?:param|returns|throws)|\. [a-z]{3,}/, of);
		assert.match(said, /^[A-Z0-9@"`([]/, of);
	}
});

test("the documentation has no remarks for those who maintain the engine, and no types of Flash", () => {
	const text = readFileSync(path.join(folder, "index.d.ts"), "utf8");
	assert.doesNotMatch(text, /for the engine alone/);
	assert.match(text, /constructor\(name: string, vertices: Numbers, triangles\?: Numbers \| null, scaling\?: Scaling\);/, "the fifth argument of a model is the engine's own");
	const known = new Set([...text.matchAll(/^(?:export |declare |abstract )+(?:class|function|interface|type) (\w+)/gm)].map(([, name]) => name));
	const platform = /^(?:AbortController|AbortError|AbortSignal|ArrayBuffer|ByteArrays|ImageData|InstancedMesh|JavaScript|LineSegments|StarLogo|NaN|RangeError|TypeError|Vector3Ds|WebAssembly)$/;
	for (const { of, said } of documentation()) {
		assert.doesNotMatch(said, /\bthis file\b|\bwritten out\b|\bflash\.|\bFlash|\bRuffle|\bAdobe|ActionScript|\bplayer (?:takes|lets|that compiles)|\bas in the player\b|display list/i, of);
		assert.doesNotMatch(said, /\bV8\b|\buint\b|: ?int\b|\bVector\b|function\(/, of);
		for (const [name] of said.matchAll(/\b[A-Z][a-z0-9]+[A-Z]\w*/g)) assert.ok(known.has(name) || platform.test(name), `${of} speaks of ${name}`);
	}
});

test("the types say nothing of any, and the documentation speaks of JavaScript", () => {
	const text = readFileSync(path.join(folder, "index.d.ts"), "utf8");
	const code = text.replaceAll(/\/\*\*[\s\S]*?\*\//g, "");
	assert.doesNotMatch(code, /\bany\b/);
	assert.doesNotMatch(text, /Ruffle|Adobe|Flash Player|§|Vector\.</);
});

test("AgentQueries has what its parts declare, and declares it nowhere again", () => {
	const text = readFileSync(path.join(folder, "index.d.ts"), "utf8");
	assert.match(text, /^export interface AgentQueries<.*> extends AgentPlaces<Breeds, GameAgent>, AgentRays<.*>, AgentMotions<.*> \{\}$/m);
	const methodsOf = (name) => [...text.match(new RegExp(`^export class ${name}<[^]*?^}`, "m"))[0].matchAll(/^\t(\w+)(?:<.*?>)?\(/gm)].map(([, method]) => method);
	const own = methodsOf("AgentQueries").filter((method) => method !== "constructor");
	for (const part of ["AgentPlaces", "AgentRays", "AgentMotions"]) assert.deepEqual(methodsOf(part).filter((method) => own.includes(method)), [], part);
	assert.match(text, /^\tcast<.*>\(.*\): RayHit<NoInfer<Found<FoundAgent, Breeds, Name, ExceptName>>> \| null;$/m);
});

test("editors strike out older names", () => {
	const older = [...readFileSync(path.join(folder, "index.d.ts"), "utf8").matchAll(/@deprecated Use `(\w+)\(\)`\.\n\t \*\/\n\t(\w+)/g)].map(([, now, before]) => [before, now]);
	assert.deepEqual(older.slice(0, 2), [["moved", "refresh"], ["nearestOf", "nearestFew"]]);
});

test("samples in the documentation are JavaScript", async () => {
	const { default: ts } = await import(pathToFileURL(tools.resolve("typescript")));
	const samples = [...readFileSync(path.join(folder, "index.d.ts"), "utf8").matchAll(/```js\n([\s\S]*?)```/g)].map(([, sample]) => sample.replaceAll(/^\s*\* ?/gm, ""));
	assert.ok(samples.length > 3);
	for (const sample of samples) {
		const { diagnostics } = ts.transpileModule(sample, { fileName: "sample.js", reportDiagnostics: true });
		assert.deepEqual(diagnostics.map(({ messageText }) => messageText), [], sample);
	}
});

test("publint has nothing to say", async () => {
	const { publint } = await import(pathToFileURL(tools.resolve("publint")));
	const { messages } = await publint({ pkgDir: folder, strict: true, pack: false });
	assert.deepEqual(messages, []);
});

// an ES module alone: require() of it is Node's own from 20.19 on, and its error before
test("attw has nothing to say", { skip: process.env.FULL_TESTS === "true" ? false : "only with -Dfull" }, () => {
	const attw = path.join(root, "js/module/node_modules/@arethetypeswrong/cli/dist/index.js");
	const out = execFileSync(process.execPath, [attw, "--pack", folder, "--profile", "esm-only", "--format", "json"], { encoding: "utf8", cwd: work });
	const { analysis } = JSON.parse(out);
	assert.equal(analysis.packageName, "starlogo-collision");
	assert.deepEqual(analysis.problems.filter((problem) => problem.resolutionKind !== "node10" && problem.kind !== "CJSResolvesToESM"), []);
});
