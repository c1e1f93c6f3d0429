/** Damaged model files: each is refused or read, and nothing else comes of it. */
import assert from "node:assert/strict";
import { randomNumbers } from "../../module/random.mjs";
import { engine } from "../tools.mjs";

const { ByteArray, ModelError, ObjModel } = engine;

const PIECES = ["nan", "-1", "1e308", "0", "999999999", "<", ">", "/", "\"", "{", "]", " ", "\n", "#", "f 1 1 1\n", "\u0000", "1e-320"];
const OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nf 1 3 2\nf 1 2 4\nf 2/1/1 3/1/1 4/1/1\nf -2 -4 -1\n";
const STL = `solid a\n${[[0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 0, 0, 1, 0, 0, 0, 0, 1], [1, 0, 0, 0, 1, 0, 0, 0, 1]].map((v) => `facet normal 0 0 1\nouter loop\nvertex ${v.slice(0, 3).join(" ")}\nvertex ${v.slice(3, 6).join(" ")}\nvertex ${v.slice(6).join(" ")}\nendloop\nendfacet`).join("\n")}\nendsolid a\n`;
const DAE = `<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><translate>1 2 3</translate><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>`;
const GLTF = JSON.stringify({
	asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, translation: [1, 2, 3] }],
	meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
	accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3" }],
	bufferViews: [{ buffer: 0, byteLength: 36 }],
	buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer).toString("base64")}` }],
});
const bytesOf = (text) => new ByteArray(new TextEncoder().encode(text));
const FILES = {
	OBJ: { text: OBJ, read: (name, text) => new ObjModel(name, text) },
	COLLADA: { text: DAE, read: (name, text) => new engine.ColladaModel(name, text) },
	STL: { text: STL, read: (name, text) => engine.StlModel.fromBytes(name, bytesOf(text)) },
	glTF: { text: GLTF, read: (name, text) => engine.GltfModel.fromBytes(name, bytesOf(text)) },
};

export const files = {
	file: {
		random: ({ pick, integer }) => [pick(Object.keys(FILES)), 1 + integer(1e9)],
		play(game, kind, seed) {
			const random = randomNumbers(seed);
			const { text, read } = FILES[kind];
			const letters = [...text];
			for (let i = 1 + Math.floor(3 * random()); i > 0; i--) {
				const at = Math.floor(random() * letters.length);
				const damage = random();
				if (damage < 0.3) letters.splice(at, 1 + Math.floor(20 * random()));
				else if (damage < 0.7) letters[at] = PIECES[Math.floor(random() * PIECES.length)];
				else letters.splice(at, 0, ...letters.slice(Math.floor(random() * letters.length)).slice(0, 30));
			}
			let model;
			try {
				model = read("damaged", letters.join(""));
			} catch (error) {
				assert.ok(error instanceof ModelError || error.name === "ModelError", `${kind}: ${error.stack}`);
				return;
			}
			assert.ok(model.vertices.every(Number.isFinite), `${kind}: vertices that are not finite`);
			game.land.addModel(model);
			game.land.removeModel("damaged");
		},
	},
};
