/** Tests of animations in COLLADA documents, with the loader of each version of three.js. What three.js says is the truth. */
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { peers, root } from "./peers.mjs";

// three.js reads documents by a page's DOMParser
const { JSDOM } = createRequire(path.join(root, "js/playground/package.json"))("jsdom");
const FOLDER = "/usr/share/assimp/models/Collada";
// three.js keeps times and numbers in 32 bits
const TOLERANCE = 5e-6;
globalThis.DOMParser = new JSDOM("").window.DOMParser;

/** A document with triangles in place of polygons: three.js takes only the first of several polygons, and cuts others than the engine does. */
function withTriangles(text) {
	return text.replace(/<polygons count="\d+"([^>]*)>([^]*?)<\/polygons>/g, (_, rest, body) => {
		const inputs = body.match(/<input[^>]*>/g);
		const width = 1 + Math.max(...inputs.map((input) => Number(/offset="(\d+)"/.exec(input)[1])));
		const triangles = [...body.matchAll(/<p>([^<]*)<\/p>/g)].flatMap(([, words]) => {
			const all = words.trim().split(/\s+/);
			const corners = Array.from({ length: all.length / width }, (_, i) => all.slice(i * width, (i + 1) * width));
			return corners.slice(2).map((corner, i) => [corners[0], corners[i + 1], corner].flat().join(" "));
		});
		return `<triangles count="${triangles.length}"${rest}>${inputs.join("")}<p>${triangles.join(" ")}</p></triangles>`;
	});
}

/** A document with the animations of one clip, because three.js plays those of all clips. */
function withClip(text, name) {
	const clip = new RegExp(`<animation_clip name="${name}"[^]*?</animation_clip>`).exec(text)[0];
	const ids = [...clip.matchAll(/url="#([^"]*)"/g)].map(([, id]) => id);
	const others = (animation, id) => (ids.includes(id) ? animation : "");
	return text.replace(/<library_animation_clips>[^]*<\/library_animation_clips>/, "").replace(/<animation id="([^"]*)">[^]*?<\/animation>/g, others);
}

/** The corners that three.js draws, z up. */
function drawnPoints(THREE, scene) {
	const points = [];
	const point = new THREE.Vector3();
	scene.updateMatrixWorld(true);
	scene.traverse((object) => {
		for (let i = 0; object.isMesh && i < object.geometry.attributes.position.count; i++) {
			object.getVertexPosition(i, point).applyMatrix4(object.matrixWorld);
			points.push([point.x, -point.z, point.y]);
		}
	});
	return points;
}

/** The corners of a model's triangles. */
function cornersOf({ vertices, triangles }) {
	return Array.from(triangles, (vertex) => [...vertices.slice(3 * vertex, 3 * vertex + 3)]);
}

/** The largest distance of one of the points from the other point in its place. */
function distanceOf(points, others) {
	assert.equal(points.length, others.length);
	return Math.max(...points.map((point, i) => Math.hypot(...point.map((number, axis) => number - others[i][axis]))));
}

/** Triangles whose node moves by components. One element has all channels, because in three.js those of the next one replace them. */
function moving(interpolation) {
	const times = [0, 0.5, 1.25, 2];
	const channels = { "translate.X": [0, 3, -1, 2], "translate.Z": [1, 0, 5, 2], "turn.ANGLE": [0, 40, 100, 20], "scale.Y": [1, 2, 0.5, 3] };
	const source = (id, values, width = 1, array = "float_array") => `<source id="${id}"><${array} id="${id}-array" count="${values.length}">${values.join(" ")}</${array}>` +
		`<technique_common><accessor source="#${id}-array" count="${values.length / width}" stride="${width}">${'<param name="A" type="float"/>'.repeat(width)}</accessor></technique_common></source>`;
	const parts = Object.entries(channels).map(([target, values], i) => {
		const tangents = (sign) => values.flatMap((value, key) => [times[key] + sign * 0.2, value + 0.3 * key]);
		const sources = [source(`i${i}`, times), source(`o${i}`, values), source(`k${i}`, times.map(() => interpolation), 1, "Name_array"), source(`a${i}`, tangents(1), 2), source(`b${i}`, tangents(-1), 2)];
		const inputs = ["INPUT", "OUTPUT", "INTERPOLATION", "OUT_TANGENT", "IN_TANGENT"].map((semantic, k) => `<input semantic="${semantic}" source="#${"iokab"[k]}${i}"/>`);
		return `${sources.join("")}<sampler id="s${i}">${inputs.join("")}</sampler><channel source="#s${i}" target="node/${target}"/>`;
	});
	const mesh = `<mesh>${source("p", [0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4], 3)}<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>` +
		'<triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2 0 2 3</p></triangles></mesh>';
	return '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset>' +
		`<library_animations><animation id="all">${parts.join("")}</animation></library_animations><library_geometries><geometry id="g">${mesh}</geometry></library_geometries>` +
		'<library_visual_scenes><visual_scene id="scene"><node id="node"><translate sid="translate">0 0 0</translate><rotate sid="turn">0 0 1 0</rotate>' +
		'<scale sid="scale">1 1 1</scale><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#scene"/></scene></COLLADA>';
}

/** Compares each key, and as many times after it as given. If there are clips, one of them is played. */
function compare(t, { version, THREE, engine }, Loader, name, text, { clip = null, between = 0 }) {
	text = withTriangles(text);
	const { scene } = new Loader().parse(clip === null ? text : withClip(text, clip), "");
	const model = new engine.ColladaModel(name, text, null, engine.Model.AS_GIVEN);
	const animations = new engine.ColladaAnimations(name, text);
	const index = animations.indexOf(clip ?? "");
	const start = clip === null ? 0 : Number(new RegExp(`name="${clip}" start="([^"]*)"`).exec(text)[1]);
	const atRest = distanceOf(cornersOf(model), drawnPoints(THREE, scene));
	const [played] = scene.animations;
	const keys = [...new Set(played.tracks.flatMap(({ times }) => [...times]))].filter((time) => time >= start);
	const mixer = new THREE.AnimationMixer(scene);
	const action = mixer.clipAction(played);
	action.setLoop(THREE.LoopOnce);
	action.clampWhenFinished = true;
	action.play();
	let most = 0;
	// after the last key the mixer would begin again
	const times = keys.flatMap((key) => Array.from({ length: 1 + between }, (_, i) => key + 0.05 * i)).filter((time) => time <= keys.at(-1));
	for (const time of times) {
		mixer.setTime(time);
		model.pose(animations.verticesAt(index, time - start));
		most = Math.max(most, distanceOf(cornersOf(model), drawnPoints(THREE, scene)));
	}
	t.diagnostic(`three ${version}, ${name}: ${keys.length} keys, ${most}`);
	assert.ok(keys.length > 3 && most < TOLERANCE, `${name}: ${most}`);
	assert.ok(atRest < TOLERANCE, `${name} at rest: ${atRest}`);
}

for (const peer of await peers()) {
	const { version, folder } = peer;
	test(`three ${version}: an animation of a COLLADA document poses the model as its mixer poses the object`, async (t) => {
		const { ColladaLoader } = await import(pathToFileURL(path.join(folder, "node_modules/three/examples/jsm/loaders/ColladaLoader.js")));
		// older loaders know no components
		const interpolations = Number(version.split(".")[1]) > 180 ? ["LINEAR", "STEP", "BEZIER"] : [];
		for (const interpolation of interpolations) compare(t, peer, ColladaLoader, interpolation, moving(interpolation), { between: interpolation === "BEZIER" ? 0 : 5 });
		if (!existsSync(FOLDER)) return t.skip("assimp-testmodels is not installed");
		const read = (name) => readFileSync(path.join(FOLDER, name), "utf8");
		compare(t, peer, ColladaLoader, "box_nested_animation", read("box_nested_animation.dae"), {});
		for (const clip of ["bend", "turn"]) compare(t, peer, ColladaLoader, clip, read("library_animation_clips.dae"), { clip });
	});
}
