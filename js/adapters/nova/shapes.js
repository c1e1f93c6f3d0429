import { BuiltInModel, Model, ModelLoader } from "starlogo-collision";

/** The shape of an agent that has no model yet: a sphere of its size that stands on its place. */
export const SPHERE = "Sphere";

// the client's own shapes, whose names are no addresses: corners, and triangles of them
const BUILT_IN = {
	Cube: () => ({ vertices: BuiltInModel.cube().vertices, triangles: BuiltInModel.cube().triangles }),
	Pyramid: () => ({ vertices: [0, 0, 1, 0.5, 0, 0, -0.5, 0.7, 0, -0.5, -0.7, 0], triangles: [0, 1, 2, 0, 2, 3, 0, 3, 1, 3, 2, 1] }),
	Sphere: () => ({ vertices: BuiltInModel.sphere().vertices, triangles: BuiltInModel.sphere().triangles }),
	Triangle: () => ({ vertices: [0, 0, 0, 0, 1, 0, 1, 0, 0], triangles: [0, 1, 2] }),
};

/** The models in a GreatLand for the shapes of the client's agents: its built-in shapes, and files whose address is the shape. */
export class Shapes {
	#greatLand;
	#window;
	#own;
	#loader;
	#asked = new Map();

	/** The models that could not be loaded, and why. */
	problems = [];

	/**
	 * Adds the shapes of a page to a GreatLand. `own` gives another Model or address for a shape: an object, a function, or null for the
	 * client's own.
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

	/** The number of files that are still loading. */
	get pendingCount() {
		return this.#loader.pendingCount;
	}

	/** The name of a shape's model. While there is none, it is the sphere's. The first call starts to load it. */
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
		// some names are no file's address, for example "cube", the first shape of agents
		if (!/\.\w+(?:[?#].*)?$/.test(address)) return this.#retryable(shape);
		this.#loader.load(shape, address, "z", Model.VOLUME);
		return shape;
	}

	/** Allows another attempt, because a tag may get its address later. */
	#retryable(shape) {
		queueMicrotask(() => this.#asked.delete(shape));
		return SPHERE;
	}
}
