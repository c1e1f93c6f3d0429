/** Tests of stored fits and cooked models where browsers keep things: the package bin/module in headless Chromium, its local storage, and several tabs. */
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { launch } from "../../build/headless/browsers.mjs";
import { serve } from "../../build/headless/server.mjs";
import { engine } from "./engine.mjs";

const { CookedModel, ModelTransform, ObjModel } = engine;
const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = path.join(root, "bin/module");
const work = path.join(root, "bin/generated/module/store-test");
const FILES = ["bear.obj", "kelp.obj", "tree.obj", "person.dae"];

const PAGE = `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><script type="module">
import * as engine from "/module/starlogo-collision.min.js";

window.game = (capacity) => {
	const greatLand = new engine.GreatLand();
	if (capacity > 0) greatLand.fitStore = new engine.FitStore(capacity);
	return greatLand;
};
window.modelsOf = async (count, seed) => {
	const { vertices, triangles } = new engine.ObjModel("kelp", await (await fetch("/models/kelp.obj")).text());
	const taller = (factor) => vertices.map((coordinate, i) => (i % 3 === 2 ? factor * coordinate : coordinate));
	return Array.from({ length: count }, (_, i) => new engine.Model("kelp " + i, taller(1 + seed + i / 100), triangles));
};
window.addAll = (greatLand, models) => {
	const start = performance.now();
	for (const model of models) greatLand.addModel(model);
	return performance.now() - start;
};
window.structures = (greatLand, models) => models.map((model) => greatLand.boundingStructures.tightestFit(model.name).volume);
window.kept = (models) => {
	const greatLand = new engine.GreatLand();
	const settings = new engine.FitSettings(greatLand.boundingStructures, greatLand.hierarchies);
	const store = new engine.FitStore();
	return models.filter((model) => store.read(model, settings) !== null).length;
};
window.load = (files, manifest) => new Promise((resolve) => {
	const greatLand = new engine.GreatLand();
	const loader = new engine.ModelLoader(greatLand, 8);
	loader.manifest = manifest;
	const problems = [];
	loader.addEventListener("error", (event) => problems.push(event.text));
	loader.addEventListener("complete", () => resolve({ problems, volumes: files.map((file) => greatLand.boundingStructures.tightestFit(file).volume) }));
	for (const file of files) loader.load(file, "/models/" + file);
});
window.isReady = true;
</script>`;

let server;
let browser;

before(async () => {
	rmSync(work, { recursive: true, force: true });
	mkdirSync(path.join(work, "plain"), { recursive: true });
	for (const file of FILES) copyFileSync(path.join(root, "assets", file), path.join(work, "plain", file));
	execFileSync(process.execPath, [path.join(folder, "cook.mjs"), path.join(work, "plain"), "--out", path.join(work, "models")]);
	server = await serve(PAGE, { "/module": folder, "/models": path.join(work, "models") });
	browser = await launch();
});

after(async () => {
	await browser?.close();
	server?.close();
});

async function open(context, prepare) {
	const page = await context.newPage();
	page.problems = [];
	page.on("pageerror", (error) => page.problems.push(String(error)));
	page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
	if (prepare) await page.addInitScript(prepare);
	await page.goto(server.url);
	await page.waitForFunction(() => window.isReady);
	return page;
}

test("what one page computed the next one reads", async () => {
	const context = await browser.newContext();
	const first = await open(context);
	const computed = await first.evaluate(async () => {
		const models = await modelsOf(5, 0);
		const greatLand = game(1e6);
		addAll(greatLand, models);
		return structures(greatLand, models);
	});
	await first.close();
	const second = await open(context);
	const { read, count } = await second.evaluate(async () => {
		const models = await modelsOf(5, 0);
		const count = kept(models);
		const greatLand = game(1e6);
		addAll(greatLand, models);
		return { read: structures(greatLand, models), count };
	});
	assert.equal(count, 5);
	assert.deepEqual(read, computed);
	assert.deepEqual([...first.problems, ...second.problems], []);
	await context.close();
});

test("two tabs at once lose and mix nothing", async () => {
	const context = await browser.newContext();
	const tabs = await Promise.all([open(context), open(context), open(context)]);
	await Promise.all(tabs.map((tab, index) => tab.evaluate(async (seed) => {
		for (const model of await modelsOf(12, seed)) {
			addAll(game(1e6), [model]);
			await new Promise((resolve) => setTimeout(resolve, 1));
		}
	}, index)));
	const late = await open(context);
	for (let seed = 0; seed < tabs.length; seed++) {
		const [count, read, alone] = await late.evaluate(async (each) => {
			const models = await modelsOf(12, each);
			const count = kept(models);
			const [greatLand, without] = [game(1e6), game(0)];
			addAll(greatLand, models);
			addAll(without, models);
			return [count, structures(greatLand, models), structures(without, models)];
		}, seed);
		assert.equal(count, 12, `of tab ${seed}`);
		assert.deepEqual(read, alone);
	}
	const listed = await late.evaluate(() => atob(localStorage.getItem("starlogo-fits/index")));
	assert.equal(listed.match(/\n/g).length, 36, "all are listed by then");
	await context.close();
});

test("games work where storage is full, or off, or holds something else", async () => {
	const context = await browser.newContext();
	const full = await open(context);
	const [before, after] = await full.evaluate(async () => {
		let room = 6e6;
		for (let i = 0; room > 10; i++) {
			try {
				localStorage.setItem("other " + i, "x".repeat(room));
			} catch {
				room = Math.floor(room / 2);
			}
		}
		const before = localStorage.length;
		const models = await modelsOf(3, 0);
		const greatLand = game(1e6);
		addAll(greatLand, models);
		return [before, localStorage.length, structures(greatLand, models)];
	});
	assert.equal(after, before, "nothing of the others is touched");
	await full.evaluate(async () => {
		localStorage.clear();
		addAll(game(1e6), await modelsOf(3, 0));
		for (const name of Object.keys(localStorage)) localStorage.setItem(name, "no base 64! ☃");
		const models = await modelsOf(3, 0);
		const greatLand = game(1e6);
		addAll(greatLand, models);
		structures(greatLand, models);
	});
	const off = await open(context, () => {
		Object.defineProperty(window, "localStorage", {
			get() {
				throw new DOMException("switched off", "SecurityError");
			},
		});
	});
	await off.evaluate(async () => {
		const models = await modelsOf(3, 0);
		const greatLand = game(1e6);
		addAll(greatLand, models);
		structures(greatLand, models);
	});
	assert.deepEqual([...full.problems, ...off.problems], []);
	await context.close();
});

test("a ModelLoader takes what was cooked and nothing else, and reads the source where it is damaged or gone", async () => {
	const context = await browser.newContext();
	const page = await open(context);
	const asked = [];
	page.on("request", (request) => asked.push(new URL(request.url()).pathname));
	const computed = await page.evaluate((files) => load(files, null), FILES);
	assert.deepEqual(asked.splice(0).sort(), FILES.map((file) => `/models/${file}`).sort());
	const cooked = await page.evaluate((files) => load(files, "/models/manifest.json"), FILES);
	assert.deepEqual(asked.splice(0).sort(), ["/models/manifest.json", ...FILES.map((file) => `/models/${file}.cooked`)].sort());
	assert.deepEqual(cooked, computed);
	assert.deepEqual(cooked.problems, []);
	const names = readdirSync(path.join(work, "models")).filter((file) => file.endsWith(".cooked"));
	assert.equal(names.length, FILES.length);
	for (const name of names) {
		const bytes = readFileSync(path.join(work, "models", name));
		bytes[100] ^= 1;
		writeFileSync(path.join(work, "models", name), bytes);
	}
	rmSync(path.join(work, "models", names[0]));
	const damaged = await page.evaluate((files) => load(files, "/models/manifest.json"), FILES);
	assert.deepEqual(damaged, computed);
	assert.deepEqual(page.problems.filter((text) => !/404/.test(text)), []);
	await context.close();
});

test("the cook leaves what is there, cooks what has changed, and says what is wrong", () => {
	const run = (...args) => spawnSync(process.execPath, [path.join(folder, "cook.mjs"), ...args], { encoding: "utf8" });
	const plain = path.join(work, "plain");
	const again = path.join(work, "again");
	assert.match(run(plain, "--out", again).stdout, /^4 cooked$/m);
	assert.match(run(plain, "--out", again).stdout, /^0 cooked, 4 as they were$/m);
	// a damaged entry is as none
	const manifest = JSON.parse(readFileSync(path.join(again, "manifest.json")));
	manifest.models["kelp.obj"] = { files: 5 };
	writeFileSync(path.join(again, "manifest.json"), JSON.stringify(manifest));
	assert.match(run(plain, "--out", again).stdout, /^1 cooked, 3 as they were$/m);
	const names = Object.keys(JSON.parse(readFileSync(path.join(again, "manifest.json"))).models);
	assert.match(run(plain, "--out", again, "--up", "y").stdout, /^4 cooked$/m);
	// a run that is interrupted has taken the entries of what it has cooked out of the manifest
	const interrupted = spawnSync(process.execPath, ["--input-type=module", "-e", `import fs from "node:fs";
		import { syncBuiltinESMExports } from "node:module";
		const write = fs.writeFileSync;
		fs.writeFileSync = (file, bytes) => (write(file, bytes), /kelp\.obj\.cooked$/.test(file) && process.exit(9));
		syncBuiltinESMExports();
		process.argv = ["", ${JSON.stringify(plain)}, "--out", ${JSON.stringify(again)}];
		await import(${JSON.stringify(path.join(folder, "cook.mjs"))});`]);
	assert.equal(interrupted.status, 9);
	assert.deepEqual(Object.keys(JSON.parse(readFileSync(path.join(again, "manifest.json"))).models).sort(), names.filter((name) => name !== "kelp.obj"));
	assert.match(run(plain, "--out", again, "--up", "y").stdout, /^2 cooked, 2 as they were$/m);
	writeFileSync(path.join(plain, "kelp.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
	assert.match(run(plain, "--out", again, "--up", "y").stdout, /^1 cooked, 3 as they were$/m);
	writeFileSync(path.join(plain, "broken.obj"), "v 1 2\n");
	const broken = run(plain, "--out", again, "--up", "y");
	assert.equal(broken.status, 1);
	assert.match(broken.stderr, /broken\.obj: model "broken", line 1/);
	assert.match(broken.stdout, /^0 cooked, 4 as they were, 1 that are no models$/m);
	assert.match(run("--help").stdout, /--min-vertices N/);
	symlinkSync(path.join(plain, "gone"), path.join(plain, "gone.obj"));
	const dangling = run(plain, "--out", again, "--up", "y");
	assert.match(dangling.stderr, /^gone\.obj: .*ENOENT/m);
	assert.match(dangling.stdout, /^0 cooked, 4 as they were, 2 that are no models$/m);
	rmSync(path.join(plain, "gone.obj"));
	// the copies may be beside the folder's name
	assert.match(run(plain, "--out", path.dirname(plain)).stdout, /^[1-9]\d* cooked/m);
	// what belongs to a model counts as its source, and is copied with it
	rmSync(path.join(plain, "broken.obj"));
	const gltf = (uri) => JSON.stringify({ asset: { version: "2.0" }, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
		accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [1, 1, 0] }], bufferViews: [{ buffer: 0, byteLength: 36 }], buffers: [{ uri, byteLength: 36 }] });
	mkdirSync(path.join(plain, "deep"));
	writeFileSync(path.join(plain, "deep/three.gltf"), `\uFEFF${gltf("its%20data.bin?v=2")}`);
	writeFileSync(path.join(plain, "deep/its data.bin"), new Uint8Array(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer));
	writeFileSync(path.join(plain, "kelp.slb"), "\uFEFFrotate 90 0 0\n");
	const transformed = () => run(plain, "--out", path.join(plain, "out"), "--transforms").stdout;
	assert.match(transformed(), /^5 cooked$/m);
	assert.match(transformed(), /^0 cooked, 5 as they were$/m);
	assert.deepEqual(readdirSync(path.join(plain, "out/deep")).sort(), ["its data.bin", "three.gltf", "three.gltf.cooked"]);
	// the model is turned as a loader turns it
	const cooked = CookedModel.fromBytes("kelp", readFileSync(path.join(plain, "out/kelp.obj.cooked")));
	const turned = new ObjModel("kelp", readFileSync(path.join(plain, "kelp.obj"), "utf8"), ModelTransform.fromText("rotate 90 0 0"));
	assert.deepEqual([...cooked.vertices], [...turned.vertices]);
	assert.deepEqual(readFileSync(path.join(plain, "out/kelp.slb"), "utf8"), "\uFEFFrotate 90 0 0\n");
	writeFileSync(path.join(plain, "kelp.slb"), "rotate 0 90 0\n");
	assert.match(transformed(), /^1 cooked, 4 as they were$/m);
	writeFileSync(path.join(plain, "deep/its data.bin"), new Uint8Array(36));
	assert.match(transformed(), /^1 cooked, 4 as they were$/m);
	writeFileSync(path.join(plain, "deep/three.gltf"), gltf("../../its.bin"));
	assert.match(run(plain, "--out", again).stderr, /three\.gltf: model "three", buffers\[0\]\.uri: expected data, or a path from the file's folder on, but found "\.\.\/\.\.\/its\.bin"/);
	for (const [args, problem] of [[[], /needs a folder/], [["nowhere"], /nowhere is no folder/], [[plain, "--up", "w"], /--up is x, y or z, not w/],
		[[plain, "--depth", "0"], /--depth is a whole number/], [[plain, "--upp", "y"], /--upp is no option; the nearest is up; there are --out, --up, .*--help$/m],
		[[plain, "--gravity"], /--gravity is no option; there are/], [[plain, "--up"], /--up needs a value$/m], [[plain, "--force=3"], /--force takes no value$/m], [[plain, "--increment", "x"], /--increment is/]]) {
		const refused = run(...args);
		assert.equal(refused.status, 2);
		assert.match(refused.stderr, problem);
	}
});

test("the cook knows what is in a folder: on another drive of Windows nothing is, and a name may begin with two dots", () => {
	const [text] = /^function isIn\([^]*?^\}/m.exec(readFileSync(path.join(root, "js/module/cook.mjs"), "utf8"));
	const isInBy = ({ relative, isAbsolute, sep }) => new Function("relative", "isAbsolute", "sep", `return ${text}`)(relative, isAbsolute, sep);
	const onWindows = isInBy(path.win32);
	assert.equal(onWindows("D:\\out", "C:\\models\\a.obj"), false);
	assert.equal(onWindows("C:\\models", "C:\\models\\out\\a.obj"), true);
	assert.equal(onWindows("C:\\models\\out", "C:\\models\\a.obj"), false);
	const onOthers = isInBy(path.posix);
	assert.equal(onOthers("/models", "/models/..a/b.bin"), true);
	assert.equal(onOthers("/models", "/models.bin"), false);
	assert.equal(onOthers("/models", "/models"), true);
});
