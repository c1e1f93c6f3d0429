/** Leaves out of three.js what the page does not use and no bundler leaves out. */
import { readFileSync } from "node:fs";
import { replaced } from "./packages.mjs";

/** Shaders for materials, lights and effects that the page does not use, by their names in three.js. Some are only the beginnings of names. */
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
export const leanThree = {
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
		const shader = new RegExp(`^(const|var) ${variable.replace("$", "\\$")} = ".*";$`, "m");
		text = replaced(file, text, shader, (_, kind) => `${kind} ${variable} = "";`, `how ${name} is written`);
	}
	if (UNUSED_SHADERS.some((each) => !unused.some(([, name]) => name.startsWith(each)))) throw new Error(`${file} is not as it was: look which shaders there are`);
	for (const [beginning, short] of Object.entries(UNUSED_PARTS)) text = replacePart(file, text, beginning, short);
	for (const name of UNUSED_FUNCTIONS) {
		const whole = new RegExp(`^(\\t+)(function ${name}|this\\.${name} = (?:async )?function) ?\\([^)]*\\) \\{\\n[^]*?^\\1\\}`, "m");
		text = replaced(file, text, whole, "$1$2() {}", `for ${name}`);
	}
	for (const name of UNUSED_MATERIALS) text = replaced(file, text, new RegExp(`^\\t${name}: \\{\\n[^]*?^\\t\\},?\\n`, "m"), "", `for the material ${name}`);
	return replaced(file, text, /\nShaderLib\.physical = \{[^]*?\n\};\n/, "", "for the physical material");
}

/** three.js's other classes without what is written into unused ones, and without what writes scenes into files. */
function coreWithout(file) {
	// lights cast no shadows
	let text = replacePart(file, readFileSync(file, "utf8"), "class DirectionalLightShadow", "class DirectionalLightShadow { dispose() {} }");
	for (const name of UNUSED_CLASSES) {
		text = replaced(file, text, new RegExp(`^${name}\\.[\\w.]+ = (.*;|[[{]\\n(\\t.*\\n|\\n)*[\\]}];)$`, "gm"), "", `what is written into ${name}`);
	}
	// colours are numbers
	const nameless = text.replace(/^const _colorKeywords = \{[^}]*\};/m, "const _colorKeywords = {};");
	if (nameless.length > text.length - 2000) throw new Error(`${file} is not as it was: look for the names of colours`);
	text = nameless;
	const silent = text.replace(/^\ttoJSON\([^)]*\) \{\n[^]*?^\t\}\n/gm, "");
	if (silent.length > text.length - 20000) throw new Error(`${file} is not as it was: look how toJSON is written`);
	return silent;
}
