/** The models of the game: the twelve of the thesis's table, and the two that only the playground has. */
import { BuiltInModel, ErrorEvent, Model, ModelEvent, ModelLoader } from "starlogo-collision";
import { turtle, wall } from "./made.js";

const BUILT_IN = { sphere: () => BuiltInModel.sphere(), cube: () => BuiltInModel.cube(), cylinder: () => BuiltInModel.cylinder() };
const FILES = { bear: "bear.obj", dragon: "dragon.dae", seagull: "seagull.dae", tree: "tree.obj", kelp: "kelp.obj", fortress: "fortress.obj", spaceship: "spaceship.obj", fireman: "fireman.dae", person: "person.dae" };
const MADE = { turtle, wall };

const loaded = new Map();

/**
 * A model by its name; loaded once, and again only if that failed. Its `colours` are of its triangles, in their order: how many of one, and
 * that.
 */
export function loadModel(name) {
	if (!loaded.has(name)) {
		const model = read(name).then(async (each) => Object.assign(each, { colours: MADE[name]?.colours ?? (await colours())[name] }));
		loaded.set(name, model);
		model.catch(() => loaded.delete(name));
	}
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
	return parseModel(name, new Uint8Array(await response.arrayBuffer()));
}

/**
 * The model in a file, whose content says what it is; throws an error that says what is wrong if it is none.
 *
 * @param {string} name what the model is called
 * @param {Uint8Array} bytes the file's content
 */
export function parseModel(name, bytes) {
	return new Promise((resolve, reject) => {
		const loader = new ModelLoader({ expect() {}, expectNoMore() {}, receive: () => null });
		loader.addEventListener(ModelEvent.LOADED, ({ model }) => resolve(model));
		loader.addEventListener(ErrorEvent.ERROR, ({ text }) => reject(new Error(text)));
		loader.loadBytes(name, bytes);
	});
}
