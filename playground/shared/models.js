/** The models of the game: the twelve of the thesis's table, and the two that only the playground has. */
import { BuiltInModel, ColladaModel, GltfModel, Model, ObjModel, StlModel } from "starlogo-collision";
import { turtle, wall } from "./made.js";

const BUILT_IN = { sphere: () => BuiltInModel.sphere(), cube: () => BuiltInModel.cube(), cylinder: () => BuiltInModel.cylinder() };
const FILES = { bear: "bear.obj", dragon: "dragon.dae", seagull: "seagull.dae", tree: "tree.obj", kelp: "kelp.obj", fortress: "fortress.obj", spaceship: "spaceship.obj", fireman: "fireman.dae", person: "person.dae" };
const MADE = { turtle, wall };
const READERS = { obj: ObjModel, dae: ColladaModel, zae: ColladaModel, glb: GltfModel, gltf: GltfModel, stl: StlModel };

const loaded = new Map();

/** A model by its name; loaded once. Its `colours` are of its triangles, in their order: how many of one, and that. */
export function loadModel(name) {
	if (!loaded.has(name)) loaded.set(name, read(name).then(async (model) => Object.assign(model, { colours: MADE[name]?.colours ?? (await colours())[name] })));
	return loaded.get(name);
}

async function colours() {
	if (!loaded.has(colours)) loaded.set(colours, fetch("models/colours.json").then((response) => (response.ok ? response.json() : {})));
	return loaded.get(colours);
}

async function read(name) {
	if (name in BUILT_IN) return BUILT_IN[name]();
	if (name in MADE) {
		const { vertices, triangles } = MADE[name]();
		return new Model(name, vertices, triangles);
	}
	const response = await fetch(`models/${FILES[name]}`);
	if (!response.ok) throw new Error(`${FILES[name]}: ${response.status}`);
	return parseModel(name, FILES[name], new Uint8Array(await response.arrayBuffer()));
}

/**
 * The model in a file; throws a ModelError if it is none.
 *
 * @param {string} name what the model is called
 * @param {string} file its file's name, which says what it is
 * @param {Uint8Array} bytes its content
 */
export function parseModel(name, file, bytes) {
	return READERS[/\w+$/.exec(file)[0].toLowerCase()].fromBytes(name, bytes);
}
