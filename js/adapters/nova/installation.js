import { NovaCollisions } from "./collisions.js";
import { Overlay, viewOf } from "./overlay.js";
import { Replaced } from "./replaced.js";

/** The methods of the client's Collisions that are replaced. */
const METHODS = ["add", "remove", "update", "getCollisions", "empty", "reset"];
const QUESTIONS = ["count", "nearest"];

/** The name of the symbol under which a client keeps its installation. Other copies of this script find it there too. */
export const KEY = "starlogo-collision.nova";
const INSTALLED = Symbol.for(KEY);

/** The installation in the client of a window, or undefined. */
export function installedIn(window) {
	return window.Execution?.Collisions?.[INSTALLED] ?? null;
}

/** Replaces the collisions of the StarLogo Nova client in a window with the engine's. An earlier installation is uninstalled first. */
export function installInto(window, options = {}) {
	const client = window?.Execution?.Collisions;
	if (!client || !window.Common?.State || !window.Execution.AgentController) throw new TypeError("the window has no StarLogo Nova client: Execution.Collisions is not there");
	if (options.overlay) viewOf(window);
	const collisions = new NovaCollisions(window, options);
	installedIn(window)?.uninstall();
	const installation = new Installation(window, client, collisions);
	Object.defineProperty(client, INSTALLED, { value: installation, configurable: true });
	return installation;
}

/** An installation of the engine in a client. */
class Installation {
	#window;
	#client;
	#collisions;
	#overlay;
	#replaced = new Replaced();

	constructor(window, client, collisions) {
		this.#window = window;
		this.#client = client;
		this.#collisions = collisions;
		client.reset();
		const { neighbours } = collisions;
		for (const name of METHODS) this.#replaced.put(client, name, () => collisions[name].bind(collisions));
		for (const name of QUESTIONS) this.#replaced.put(client, name, () => neighbours[name].bind(neighbours));
		// it moves all agents without an update
		if (typeof window.Execution.AgentController.scatterAllAgents === "function") {
			this.#replaced.put(window.Execution.AgentController, "scatterAllAgents", (scatter) => function (...args) {
				neighbours.forgetPlaces();
				return scatter.apply(this, args);
			});
		}
		this.#addAll();
		this.#overlay = new Overlay(window, collisions);
		this.#overlay.show(Boolean(collisions.options.overlay));
	}

	/** Whether it is still installed. */
	get isInstalled() {
		return this.#replaced.any;
	}

	/** The options in use. */
	get options() {
		return this.#collisions.options;
	}

	/** The GreatLand with the models. */
	get greatLand() {
		return this.#collisions.greatLand;
	}

	/** The number of models that are still loading. */
	get pendingCount() {
		return this.#collisions.shapes.pendingCount;
	}

	/** The models that could not be loaded, and why. */
	get problems() {
		return this.#collisions.shapes.problems;
	}

	/** Whether two agents touch now. */
	areColliding(a, b) {
		return this.#collisions.areColliding(a, b);
	}

	/** Changes options. */
	exchange(options) {
		if (options.overlay) viewOf(this.#window);
		this.#collisions.exchange(options);
		if (this.isInstalled) this.#overlay.show(Boolean(this.options.overlay));
	}

	/** Shows or hides the colliding shapes in the client's view. */
	showOverlay(isOn = true) {
		this.exchange({ overlay: isOn });
	}

	/** Sets traits that the client has no blocks for. */
	setTraits(whose, traits) {
		this.#collisions.setTraits(whose, traits);
	}

	/** Sets some of an agent's traits, as its blocks do. The others stay. */
	changeTraits(agent, traits) {
		this.#collisions.changeTraits(agent, traits);
	}

	/** Gives the client its own collisions back, with all agents in its bins. */
	uninstall() {
		if (!this.isInstalled) return;
		this.#overlay.show(false);
		this.#replaced.giveBack();
		delete this.#client[INSTALLED];
		this.#collisions.shapes.stop();
		this.#collisions.reset();
		this.#client.reset();
		this.#addAll();
	}

	#addAll() {
		const { data, numAgents } = this.#window.Execution.AgentController;
		for (let i = 1; i < numAgents; i++) {
			const agent = data[i];
			if (!agent) continue;
			agent.jbins = [];
			if (!agent.isDead) this.#client.add(agent);
		}
	}
}
