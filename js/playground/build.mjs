#!/usr/bin/env node
/**
 * Bundles the playground into static files, and into a single one.
 *
 * node js/playground/build.mjs MODULE OUT API     MODULE is the npm package of the engine (bin/module), API the pages of its API (bin/typedoc)
 */
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { build } from "esbuild";
import { models } from "../../assets/generator/models/index.mjs";
import { palette } from "../../assets/generator/palette.mjs";
import { flatten } from "../../assets/generator/scene.mjs";
import { writeDocs } from "./docs.mjs";
import { engineInParts } from "./parts.mjs";
import { picturesInside, writeSingle } from "./single.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const [engine, out, api] = process.argv.slice(2).map((folder) => path.resolve(folder));
const npm = path.join(here, "node_modules");
const { exports } = JSON.parse(readFileSync(path.join(engine, "package.json"), "utf8"));
const module = path.join(engine, exports["."].default);
const { ColladaModel, Model, ObjModel } = await import(pathToFileURL(module));

/** The page's own scripts are in these folders. */
const USERS = [here, path.join(here, "../../examples/level"), path.join(engine, "three")];
const STYLE = 'style:"display: none;"';
const WARNINGS = /[\w$]+\(\s*"Blockly\.Workspace\.get\w*Variable\w*",\s*"v12",\s*"v13",\s*"[^"]+"\s*\);/g;

/**
 * Changes two things in Blockly. It sets a style attribute, which the page's policy forbids; an SVG attribute has the same effect. And it
 * writes console warnings about deprecated methods that it calls itself.
 */
const tameBlockly = (isSingle) => ({
	name: "tame-blockly",
	setup({ onLoad, onResolve, resolve }) {
		// its keyboard plugin imports all of it
		onResolve({ filter: /^blockly$/ }, ({ kind, resolveDir }) => resolve("blockly/core", { kind, resolveDir }));
		onLoad({ filter: /blockly_compressed\.js$/ }, ({ path: file }) => {
			const text = readFileSync(file, "utf8");
			if (!text.includes(STYLE) || text.search(WARNINGS) < 0) throw new Error(`${file} is not as it was: look whether it needs taming`);
			const tame = text.replaceAll(STYLE, 'display:"none"').replace(WARNINGS, "");
			return { contents: isSingle ? picturesInside(tame, path.join(npm, "blockly/media")) : tame, loader: "js" };
		});
	},
});

/** Rapier writes a console warning about how it calls its own WebAssembly. */
const tameRapier = {
	name: "tame-rapier",
	setup({ onLoad }) {
		onLoad({ filter: /rapier3d-compat[/\\]rapier\.mjs$/ }, ({ path: file }) => {
			const text = readFileSync(file, "utf8");
			const tame = text.replace(/console\.warn\("using deprecated parameters for the initialization function[^"]*"\)/, "0");
			if (tame === text) throw new Error(`${file} is not as it was: look whether it needs taming`);
			return { contents: tame, loader: "js" };
		});
	},
};

/** Keeps only those of Blockly's messages that bundled code names, in each language. */
const fewMessages = {
	name: "few-messages",
	setup({ onLoad }) {
		onLoad({ filter: /blockly\/msg\/\w+\.js$/ }, ({ path: file }) => {
			const plugin = path.join(npm, "@blockly/keyboard-navigation/src");
			const files = [path.join(npm, "blockly/blockly_compressed.js"), ...readdirSync(plugin, { recursive: true }).filter((each) => each.endsWith(".ts")).map((each) => path.join(plugin, each))];
			const sources = files.map((each) => readFileSync(each, "utf8")).join("\n");
			const text = readFileSync(file, "utf8");
			const kept = text.replace(/^Blockly\.Msg\["(\w+)"\] = .*$/gm, (line, name) => (new RegExp(`\\b${name}\\b`).test(sources) ? line : ""));
			if (kept.length > 0.8 * text.length) throw new Error(`${file} is not as it was: look how its messages are written`);
			return { contents: kept, loader: "js" };
		});
	},
};

/**
 * Shaders for materials, lights and effects that the page does not use, by their names in three.js. Some are only the beginnings of names.
 */
const UNUSED_SHADERS = ["background", "cube_", "distanceRGBA", "equirect", "linedashed", "meshmatcap", "meshnormal", "meshphong", "meshphysical", "meshtoon", "shadow_", "sprite", "depth_vert", "depth_frag",
	"alphahash", "aomap", "batching", "bumpmap", "clearcoat", "clipping_planes", "displacementmap", "emissivemap", "envmap", "gradientmap", "iridescence", "lightmap", "lights_phong", "lights_physical",
	"lights_toon", "logdepthbuf", "metalnessmap", "morph", "normalmap", "roughnessmap", "shadowmap", "shadowmask", "skin", "specularmap_pars", "packing", "bsdfs", "lights_fragment_maps", "tonemapping_pars", "transmission", "dithering", "alphamap"];

/**
 * Parts of three.js's renderer that the page does not use: headsets, shadows, morphs, uniform groups, clipping planes and environment maps. Each is replaced
 * by the members that the renderer still calls.
 */
const UNUSED_PARTS = {
	"class WebXRManager": "class WebXRManager extends EventDispatcher { enabled = false; isPresenting = false; getEnvironmentBlendMode() {} setAnimationLoop() {} dispose() {} }",
	"class PMREMGenerator": "class PMREMGenerator {}",
	"function WebGLClipping": "function WebGLClipping() { this.uniform = { value: null }; this.numPlanes = this.numIntersection = 0; this.init = () => false; }",
	"function WebGLShadowMap": "function WebGLShadowMap() { this.enabled = false; this.render = () => {}; }",
	"function WebGLMorphtargets": "function WebGLMorphtargets() {}",
	"function WebGLUniformsGroups": "function WebGLUniformsGroups() { this.dispose = () => {}; }",
	"function WebGLUtils": "function WebGLUtils(gl) { return { convert: (p) => ({ [UnsignedByteType]: gl.UNSIGNED_BYTE, [RGBAFormat]: gl.RGBA })[p] ?? null }; }",
	"function WebGLCubeMaps": "function WebGLCubeMaps() { return { get: (texture) => texture, dispose() {} }; }",
	"function WebGLCubeUVMaps": "function WebGLCubeUVMaps() { return { get: (texture) => texture, dispose() {} }; }",
};

/**
 * Functions within three.js's renderer that the page never reaches: it draws into no other target than the canvas, has textures of no more
 * than two dimensions, and the materials of UNUSED_SHADERS are not there. Each becomes empty.
 */
const UNUSED_FUNCTIONS = ["renderTransmissionPass", "uploadCubeTexture", "setTexture3D", "setTexture2DArray", "setupRenderTarget", "setupDepthRenderbuffer", "setupDepthTexture", "setupFrameBufferTexture", "setupRenderBufferStorage",
	"rebindTextures", "updateRenderTargetMipmap", "updateMultisampleRenderTarget", "deallocateRenderTarget", "refreshUniformsPhysical", "refreshUniformsStandard", "refreshUniformsToon", "refreshUniformsPhong", "refreshUniformsMatcap",
	"refreshUniformsDistance", "refreshUniformsSprites", "refreshUniformsDash", "readRenderTargetPixels", "readRenderTargetPixelsAsync", "copyFramebufferToTexture", "copyTextureToTexture", "initRenderTarget", "compile", "compileAsync",
	"setRenderTargetTextures", "setRenderTargetFramebuffer", "resetState", "addToRenderList"];

/** Materials that the page does not have, in three.js's table of shaders. */
const UNUSED_MATERIALS = ["phong", "standard", "toon", "matcap", "dashed", "normal", "sprite", "background", "backgroundCube", "cube", "equirect", "shadow"];

/**
 * Classes of three.js for animations and files, which the page does not use. Bundlers keep them, because members are added after their
 * definition.
 */
const UNUSED_CLASSES = ["KeyframeTrack", "BooleanKeyframeTrack", "ColorKeyframeTrack", "NumberKeyframeTrack", "QuaternionKeyframeTrack", "StringKeyframeTrack", "VectorKeyframeTrack", "PropertyBinding", "Loader"];

/**
 * Removes unused parts of three.js. three.js contains every shader for every material as text, which no bundler leaves out. Shaders that
 * the page does not use become empty. Other shaders include them only if a feature switches them on. Unused parts of the renderer are
 * removed too, and what writes scenes into files.
 */
const leanThree = {
	name: "lean-three",
	setup({ onLoad }) {
		onLoad({ filter: /three\.module\.js$/ }, ({ path: file }) => ({ contents: moduleWithout(file), loader: "js" }));
		onLoad({ filter: /three\.core\.js$/ }, ({ path: file }) => ({ contents: coreWithout(file), loader: "js" }));
	},
};

/** A text in which a class or function has become a short one. */
function replacePart(file, text, beginning, short) {
	const from = text.indexOf(`\n${beginning}`);
	const to = text.indexOf("\n}\n", from);
	if (from < 0 || to < 0) throw new Error(`${file} is not as it was: look for ${beginning}`);
	return `${text.slice(0, from)}\n${short}${text.slice(to + 2)}`;
}

/** three.js's renderer without its unused parts. */
function moduleWithout(file) {
	let text = readFileSync(file, "utf8");
	const [, table] = /^const ShaderChunk = \{([^}]*)\};/m.exec(text) ?? [];
	const chunks = [...(table ?? "").matchAll(/^\t(\w+): ([\w$]+),?$/gm)];
	const unused = chunks.filter(([, name]) => UNUSED_SHADERS.some((each) => name.startsWith(each)));
	for (const [, name, variable] of unused) {
		const before = text;
		text = text.replace(new RegExp(`^(const|var) ${variable.replace("$", "\\$")} = ".*";$`, "m"), (_, kind) => `${kind} ${variable} = "";`);
		if (text === before) throw new Error(`${file} is not as it was: look how ${name} is written`);
	}
	if (UNUSED_SHADERS.some((each) => !unused.some(([, name]) => name.startsWith(each)))) throw new Error(`${file} is not as it was: look which shaders there are`);
	for (const [beginning, short] of Object.entries(UNUSED_PARTS)) text = replacePart(file, text, beginning, short);
	for (const name of UNUSED_FUNCTIONS) {
		const before = text;
		text = text.replace(new RegExp(`^(\\t+)(function ${name}|this\\.${name} = (?:async )?function) ?\\([^)]*\\) \\{\\n[^]*?^\\1\\}`, "m"), "$1$2() {}");
		if (text === before) throw new Error(`${file} is not as it was: look for ${name}`);
	}
	for (const name of UNUSED_MATERIALS) {
		const before = text;
		text = text.replace(new RegExp(`^\\t${name}: \\{\\n[^]*?^\\t\\},?\\n`, "m"), "");
		if (text === before) throw new Error(`${file} is not as it was: look for the material ${name}`);
	}
	const end = text.indexOf("\nShaderLib.physical = {");
	return text.slice(0, end) + text.slice(text.indexOf("\n};\n", end) + 4);
}

/** three.js's other classes without what is written into unused ones, and without what writes scenes into files. */
function coreWithout(file) {
	// lights cast no shadows
	let text = replacePart(file, readFileSync(file, "utf8"), "class DirectionalLightShadow", "class DirectionalLightShadow { dispose() {} }");
	for (const name of UNUSED_CLASSES) {
		const short = text.replace(new RegExp(`^${name}\\.[\\w.]+ = (.*;|[[{]\\n(\\t.*\\n|\\n)*[\\]}];)$`, "gm"), "");
		if (short === text) throw new Error(`${file} is not as it was: look what is written into ${name}`);
		text = short;
	}
	// colours are numbers
	const nameless = text.replace(/^const _colorKeywords = \{[^}]*\};/m, "const _colorKeywords = {};");
	if (nameless.length > text.length - 2000) throw new Error(`${file} is not as it was: look for the names of colours`);
	text = nameless;
	const silent = text.replace(/^\ttoJSON\([^)]*\) \{\n[^]*?^\t\}\n/gm, "");
	if (silent.length > text.length - 20000) throw new Error(`${file} is not as it was: look how toJSON is written`);
	return silent;
}

const parts = engineInParts(path.join(engine, "../generated/module/short.js"), USERS, loadedWith);

/**
 * What a script is loaded with, where the engine is divided: its view, what its view loads later, files of the user, or "" for every view. The page
 * does not use all of the adapter and the example.
 */
function loadedWith(file) {
	if (/(three[/\\](binding|terrain)|level[/\\]page)\.js$/.test(file)) return null;
	if (/formats\.js$/.test(file)) return "files";
	if (/(asking|questions)\.js$/.test(file)) return path.relative(here, file);
	if (/inspect[/\\]measure\.js$/.test(file)) return "inspect";
	if (/sight\.js$/.test(file)) return "compare";
	return /(play|compare|measure|level)[/\\]\w+\.js$/.exec(file)?.[1] ?? "";
}

/** The settings of esbuild for the page, as it is served or as a single file. */
const settings = (isSingle) => ({
	entryPoints: [path.join(here, "main.js")],
	outdir: out,
	bundle: true,
	splitting: true,
	format: "esm",
	target: "es2022",
	minify: true,
	metafile: true,
	legalComments: "none",
	chunkNames: "parts/[name]-[hash]",
	define: isSingle ? {} : parts.define,
	alias: { "starlogo-collision": module, ...Object.fromEntries(["en", "de"].map((code) => [`blockly/msg/${code}`, path.join(npm, `blockly/msg/${code}.js`)])), "starlogo-collision/three": path.join(engine, exports["./three"].default) },
	nodePaths: [npm],
	plugins: [tameBlockly(isSingle), ...(isSingle ? [] : [parts.plugin]), tameRapier, fewMessages, leanThree],
	logLevel: "warning",
});

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const result = await build(settings(false));
parts.check(Object.keys(result.metafile.outputs));
for (const file of ["open.js", "style.css", "icon.svg"]) cpSync(path.join(here, file), path.join(out, file));
cpSync(path.join(npm, "blockly/media"), path.join(out, "media"), { recursive: true, filter: (file) => !/\.(mp3|ogg|wav)$/.test(file) });
mkdirSync(path.join(out, "models"));
for (const model of models) writeFileSync(path.join(out, "models", `${model.name}.json`), JSON.stringify(baked(model)));
cpSync(path.join(here, "../../examples/level/level.glb"), path.join(out, "models/level.glb"));
writeFileSync(path.join(out, "LICENSES.txt"), licences());
writeDocs(path.join(here, "../.."), path.join(out, "docs"));
cpSync(api, path.join(out, "docs/api"), { recursive: true });
await writeSingle(out, "starlogo-nova.html", settings(true));

/** The views' folders of words. */
const WORDS = { play: ["game"], inspect: ["lab"], compare: ["lab"], measure: ["lab"], level: ["lab"], teach: ["class", "game"] };
for (const [view, folders] of Object.entries(WORDS)) {
	const first = neededFor(`js/playground/${view}/view.js`, ...folders.map((folder) => `js/playground/languages/${folder}/en.js`));
	const editor = view === "play" ? neededFor("js/playground/play/editor.js").filter((file) => !first.includes(file)) : [];
	console.log(`${view}: ${sizes(first)}${editor.length > 0 ? `, and then for the blocks ${sizes(editor)}` : ""}`);
}
// last, because with this file the page counts as made
cpSync(path.join(here, "index.html"), path.join(out, "index.html"));
console.log(`written: ${path.relative(process.cwd(), out)}`);

/** The script files that some parts need before they run, including the page's first one and its words. */
function neededFor(...entries) {
	const { outputs } = result.metafile;
	const files = new Set();
	const add = (file) => {
		if (files.has(file)) return;
		files.add(file);
		for (const { path: other, kind } of outputs[file].imports) if (kind === "import-statement") add(other);
	};
	for (const [file, { entryPoint }] of Object.entries(outputs)) if ([...entries, "js/playground/main.js", "js/playground/languages/en.js"].some((each) => entryPoint?.endsWith(each))) add(file);
	return [...files];
}

function sizes(files) {
	const kilobytes = (size) => Math.round(files.reduce((sum, file) => sum + size(readFileSync(file)), 0) / 1024);
	return `${kilobytes((bytes) => bytes.length)} KB of script, ${kilobytes((bytes) => gzipSync(bytes).length)} KB compressed`;
}

/** A model in a short form of its file: coordinates in the file's unit with six decimals, triangles, colours. */
function baked(model) {
	const { name, format } = model;
	const [reader, ending] = format === "COLLADA" ? [ColladaModel, "dae"] : [ObjModel, "obj"];
	const { vertices, triangles, source: { unit, offset } } = reader.fromBytes(name, new Uint8Array(readFileSync(path.join(here, `../../assets/${name}.${ending}`))));
	const middle = [offset.x, offset.y, offset.z];
	const written = vertices.map((value, i) => Number((value * unit + middle[i % 3]).toFixed(6)));
	const again = new Model(name, written, triangles).vertices;
	if (vertices.some((value, i) => Math.abs(value - again[i]) > 1e-6)) throw new Error(`${name} needs more decimals`);
	return { vertices: written, triangles, colours: coloursOf(model) };
}

/** The colours of a model's triangles, in the engine's order: pairs of a count and a colour. */
function coloursOf({ build: make, format }) {
	const parts = flatten(make());
	const runs = (isOf) => parts.map(({ colour, mesh }) => [mesh.faces.filter(isOf).reduce((sum, face) => sum + face.length - 2, 0), palette[colour]]).filter(([count]) => count > 0);
	// polygons of OBJ files come after all triangles
	return format === "COLLADA" ? runs(() => true) : [...runs(({ length }) => length === 3), ...runs(({ length }) => length > 3)];
}

/** The licences of the bundled packages, except the engine's. */
function licences() {
	const files = Object.keys(result.metafile.inputs);
	const names = new Set(files.flatMap((file) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(file)?.[1] ?? []));
	const parts = [...names].sort().map((name) => {
		const folder = path.join(npm, name);
		const { version, license } = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
		// Blockly's package has no licence file
		const file = [path.join(folder, "LICENSE"), path.join(here, "licences", `${name}.txt`)].find(existsSync);
		return `${name} ${version} (${license})\n\n${readFileSync(file, "utf8").trim()}\n`;
	});
	return [readFileSync(path.join(here, "../../LICENSE"), "utf8"), ...parts].join("\n----\n\n");
}
