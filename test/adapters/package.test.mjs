/** Tests of the adapter to three.js as a part of the npm package: its types, and what bundlers make of it. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { install, root } from "./peers.mjs";

const tools = createRequire(path.join(root, "js/module/package.json"));
const sample = path.join(root, "test/adapters/sample.ts");
const folder = install("package");

test("tsc --strict accepts the sample, and refuses wrong ones", () => {
	// three.js's own types speak of WebGPU's
	const webgpu = path.join(root, "js/adapters/three/node_modules/@webgpu/types");
	const settings = { target: "es2022", module: "nodenext", moduleResolution: "nodenext", strict: true, noEmit: true, types: [webgpu], lib: ["es2022", "dom"] };
	const wrong = ['modelFromObject("box", mesh, { up: "x" })', 'modelFromObject("box", "mesh")', "new ThreeAgentBinding(mesh, mesh)", "bindInstance(agents[0], mesh, 0)",
		"wireframe.showLevel(structure, 1)", "bindings[0].agent = agents[1]", 'modelFromObject("box", mesh, { scaling: "large" })', 'const scaling: ModelOptions = { scaling: "volume" as string }'];
	writeFileSync(path.join(folder, "sample.ts"), `${readFileSync(sample, "utf8")}\n${wrong.map((line) => `// @ts-expect-error\n${line};\n`).join("")}`);
	writeFileSync(path.join(folder, "tsconfig.json"), JSON.stringify({ compilerOptions: settings, files: ["sample.ts"] }));
	// an old compiler infers a type parameter from the type that is wanted; three.js's own types are beyond it
	const old = path.join(root, "js/adapters/three/node_modules/typescript-5.4/bin/tsc");
	for (const [tsc, ...more] of [[tools.resolve("typescript/bin/tsc")], [old, "--skipLibCheck"]]) execFileSync(process.execPath, [tsc, "-p", folder, ...more], { encoding: "utf8", stdio: "pipe" });
});

test("what the types declare is what is exported, and the other way round", async () => {
	const declared = readFileSync(path.join(root, "js/adapters/three/index.d.ts"), "utf8");
	writeFileSync(path.join(folder, "all.mjs"), 'export * from "starlogo-collision/three";\n');
	const exported = await import(pathToFileURL(path.join(folder, "all.mjs")));
	assert.deepEqual([...new Set([...declared.matchAll(/^export (?:class|function) (\w+)/gm)].map(([, name]) => name))].sort(), Object.keys(exported).sort());
	for (const name of ["ThreeAgentBinding", "ThreeWireframe"]) {
		const [, text] = new RegExp(`^export class ${name}\\b[^]*?\\n([^]*?)\\n}$`, "m").exec(declared);
		const members = [...text.matchAll(/^ {4}(?:get )?(\w+)\(/gm)].map((match) => match[1]);
		const own = Object.getOwnPropertyNames(exported[name].prototype).filter((member) => member !== "raycast");
		assert.deepEqual([...new Set(members)].sort(), own.sort());
	}
});

test("esbuild takes one engine and one three.js into a bundle, of it what is used", () => {
	const bundle = (text, options = {}) => {
		writeFileSync(path.join(folder, "entry.js"), text);
		const { metafile, outputFiles } = tools("esbuild").buildSync({ entryPoints: [path.join(folder, "entry.js")], bundle: true, format: "esm", write: false, metafile: true, minify: true, ...options });
		return { inputs: Object.keys(metafile.inputs), size: outputFiles[0].contents.length };
	};
	const { inputs } = bundle('import { Agent } from "starlogo-collision";\nimport { Scene } from "three";\nimport { modelFromObject } from "starlogo-collision/three";\nconsole.log(new Agent("bear"), new Scene(), modelFromObject);\n');
	assert.equal(inputs.filter((file) => /starlogo-collision(?:\.min)?\.js$/.test(file)).length, 1);
	assert.equal(inputs.filter((file) => /three\.core\.js$/.test(file)).length, 1);
	const { size } = bundle('import { ThreeWireframe, ThreeAgentBinding, modelFromObject } from "starlogo-collision/three";\nexport { ThreeWireframe, ThreeAgentBinding, modelFromObject };\n', { external: ["three", "starlogo-collision"] });
	assert.ok(size < 12 * 1024, `${size} bytes`);
	assert.ok(bundle('import { modelFromObject } from "starlogo-collision/three";\nexport const one = 1;\n', { external: ["three", "starlogo-collision"] }).size < 300);
});

test("only ./readable is an address of a second engine, for which the adapter's models are foreign: it is the readable file everywhere", () => {
	const { exports: { "./readable": readable, ...exports } } = JSON.parse(readFileSync(path.join(root, "bin/module/package.json"), "utf8"));
	for (const [condition, engine] of [["node", "./starlogo-collision.js"], ["development", "./starlogo-collision.js"], ["default", "./starlogo-collision.min.js"]]) {
		const files = Object.values(exports).map((each) => each[condition]).filter((file) => /starlogo-collision[^/]*\.js$/.test(file));
		assert.deepEqual([...new Set(files)], [engine]);
	}
	assert.deepEqual(readable, { types: "./index.d.ts", default: "./starlogo-collision.js" });
});

test("where two copies are loaded all the same, the error says so", async () => {
	writeFileSync(path.join(folder, "copies.mjs"), `import { BoxGeometry } from "three";
import { modelFromObject } from "starlogo-collision/three";
import { GreatLand } from ${JSON.stringify(pathToFileURL(path.join(root, "bin/module/starlogo-collision.min.js")).href)};
export const add = () => new GreatLand().addModel(modelFromObject("box", new BoxGeometry()));
`);
	const { add } = await import(pathToFileURL(path.join(folder, "copies.mjs")));
	assert.throws(add, /^ArgumentError: GreatLand\.addModel: model must be a Model, not one of another copy of the engine\. There are two copies of the engine: /);
});

test("it is in the package, and three.js is what it expects beside it", () => {
	const { exports, peerDependencies, peerDependenciesMeta, files } = JSON.parse(readFileSync(path.join(root, "bin/module/package.json"), "utf8"));
	assert.ok(exports["./three"].types && exports["./three"].default && files.includes("three"));
	assert.deepEqual(Object.keys(peerDependencies), ["three"]);
	assert.equal(peerDependenciesMeta.three.optional, true);
});
