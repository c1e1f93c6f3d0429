/** The game's models: the twelve in the thesis's table, and those that only the playground has. */
import { BuiltInModel, GreatLand, Model } from "starlogo-collision";
import { MADE } from "./generatedmodels.js";
import { readModel } from "./served.js";

const BUILT_IN = { sphere: () => BuiltInModel.sphere(), cube: () => BuiltInModel.cube(), cylinder: () => BuiltInModel.cylinder(), ...MADE };

const loaded = new Map();

/**
 * A model by its name. It is loaded once; after a failure, the next call tries again. Its `colours` are those of its triangles, in their
 * order: pairs of a count and a colour. `given` has the numbers of its file.
 */
export function loadModel(name) {
	if (!loaded.has(name)) {
		const model = read(name);
		loaded.set(name, model);
		model.catch(() => loaded.delete(name));
	}
	return loaded.get(name);
}

/** What a game needs of models: the models by their names, and the engine's land of them. */
export function landOf(models) {
	const greatLand = new GreatLand();
	greatLand.loadHulls = true;
	for (const model of models.values()) greatLand.addModel(model);
	return { models, greatLand };
}

/** The land of some of the game's models. */
export const loadLand = async (names) => landOf(new Map(await Promise.all(names.map(async (name) => [name, await loadModel(name)]))));

const heights = new WeakMap();

/** The height of a model's highest point. It is computed once. */
export function heightOf(model) {
	if (!heights.has(model)) heights.set(model, model.vertices.reduce((most, value, i) => (i % 3 === 2 ? Math.max(most, value) : most), 0));
	return heights.get(model);
}

async function read(name) {
	if (name in BUILT_IN) return BUILT_IN[name]();
	const { vertices, triangles, colours } = JSON.parse(await readModel(name));
	return Object.assign(new Model(name, vertices, triangles), { colours, given: { vertices, triangles } });
}

/**
 * The model in a file, with the base colours of a glTF file. The content decides the format. Throws an error that says what is wrong.
 *
 * @param {string} name the model's name
 * @param {Uint8Array} bytes the file's content
 */
export async function parseModel(name, bytes) {
	const [{ surfaceIn }, { coloursIn }] = await Promise.all([import("./formats.js"), import("../drawing/coats.js")]);
	const { vertices, triangles } = await surfaceIn(name, bytes);
	let colours;
	try {
		colours = coloursIn(bytes, (triangles?.length ?? 0) / 3);
	} catch {
		// the colours are not worth an error
	}
	return Object.assign(new Model(name, vertices, triangles, Model.AS_GIVEN), { colours });
}
