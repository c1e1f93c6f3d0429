/** Models for what the client draws: its built-in shapes, and the files that agents' shapes are addresses of. */
import { BuiltInModel, Model, ModelLoader } from "starlogo-collision";

/** What an agent is as long as there is no model for it: a sphere of its size that stands on its place. */
export const SPHERE = "Sphere";

// what the client draws for the names that are no addresses; corners, and triangles of them
const BUILT_IN = {
	Cube: () => ({ vertices: BuiltInModel.cube().vertices, triangles: BuiltInModel.cube().triangles }),
	Pyramid: () => ({ vertices: [0, 0, 1, 0.5, 0, 0, -0.5, 0.7, 0, -0.5, -0.7, 0], triangles: [0, 1, 2, 0, 2, 3, 0, 3, 1, 3, 2, 1] }),
	Sphere: () => ({ vertices: BuiltInModel.sphere().vertices, triangles: BuiltInModel.sphere().triangles }),
	Triangle: () => ({ vertices: [0, 0, 0, 0, 1, 0, 1, 0, 0], triangles: [0, 1, 2] }),
};

/** The models of a GreatLand, by the shapes of the client's agents. */
export class Shapes {
	#greatLand;
	#window;
	#own;
	#loader;
	#asked = new Map();

	/** What could not be loaded, and why. */
	problems = [];

	/**
	 * Shapes of a page, taken into a GreatLand; `own` says for a shape which Model or address is to be taken: an object, a function, or null
	 * for the client's own.
	 */
	constructor(greatLand, window, { own = null, manifest = null, budget = 8 } = {}) {
		this.#greatLand = greatLand;
		this.#window = window;
		this.#own = typeof own === "function" ? own : (shape) => (own && Object.hasOwn(own, shape) ? own[shape] : undefined);
		this.#loader = new ModelLoader(greatLand, budget);
		this.#loader.usesTransforms = true;
		this.#loader.manifest = manifest;
		this.#loader.addEventListener("error", (event) => this.problems.push(event.text));
		this.modelOf(SPHERE);
	}

	/** How many files are not loaded yet. */
	get pendingCount() {
		return this.#loader.pendingCount;
	}

	/** The name of a shape's model, or the sphere's as long as there is none; asks for it the first time. */
	modelOf(shape) {
		let name = this.#asked.get(shape);
		if (name === undefined) this.#asked.set(shape, name = this.#ask(shape));
		return name === SPHERE || this.#greatLand.hasModel(name) ? name : SPHERE;
	}

	/** Loads nothing more. */
	stop() {
		this.#loader.cancel();
	}

	#ask(shape) {
		if (typeof shape !== "string" || shape === "") return SPHERE;
		const own = this.#own(shape);
		if (own === null || own === false) return SPHERE;
		if (own instanceof Model) {
			if (!this.#greatLand.hasModel(own.name)) this.#greatLand.addModel(own);
			return own.name;
		}
		if (own === undefined && Object.hasOwn(BUILT_IN, shape)) {
			const { vertices, triangles } = BUILT_IN[shape]();
			this.#greatLand.addModel(new Model(shape, vertices, triangles, Model.AS_GIVEN));
			return shape;
		}
		const address = own ?? this.#window.viewport?.modelManager?.tagToUrl?.get(shape) ?? shape;
		// "cube", say, with which agents begin, is the address of nothing
		if (!/\.\w+(?:[?#].*)?$/.test(address)) return this.#retryable(shape);
		this.#loader.load(shape, address, "z", Model.VOLUME);
		return shape;
	}

	/** A tag may get its address later. */
	#retryable(shape) {
		queueMicrotask(() => this.#asked.delete(shape));
		return SPHERE;
	}
}
