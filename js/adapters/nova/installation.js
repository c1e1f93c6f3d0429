/** The engine in the place of a client's collisions. */
import { NovaCollisions } from "./collisions.js";
import { Overlay, viewOf } from "./overlay.js";
import { Replaced } from "./replaced.js";

/** What the client's Collisions does, and is done in its place. */
const METHODS = ["add", "remove", "update", "getCollisions", "count", "nearest", "empty", "reset"];

/** Names the symbol under which a client has what is installed in it; other copies of this script find it there too. */
export const KEY = "starlogo-collision.nova";
const INSTALLED = Symbol.for(KEY);

/** What is installed in the client of a window, if anything is. */
export function installedIn(window) {
	return window.Execution?.Collisions?.[INSTALLED] ?? null;
}

/**
 * Puts the engine in the place of the collisions of the StarLogo Nova client that runs in a window. What was installed there before is uninstalled.
 */
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

/** What is installed in a client. */
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
		for (const name of METHODS) this.#replaced.put(client, name, () => collisions[name].bind(collisions));
		// it moves all agents and tells nobody
		if (typeof window.Execution.AgentController.scatterAllAgents === "function") {
			this.#replaced.put(window.Execution.AgentController, "scatterAllAgents", (scatter) => function (...args) {
				collisions.forgetPlaces();
				return scatter.apply(this, args);
			});
		}
		this.#addAll();
		this.#overlay = new Overlay(window, collisions);
		this.#overlay.show(Boolean(collisions.options.overlay));
	}

	/** Whether it is. */
	get isInstalled() {
		return this.#replaced.any;
	}

	/** What it was told. */
	get options() {
		return this.#collisions.options;
	}

	/** The models. */
	get greatLand() {
		return this.#collisions.greatLand;
	}

	/** How many models are still being loaded. */
	get pendingCount() {
		return this.#collisions.shapes.pendingCount;
	}

	/** What could not be loaded. */
	get problems() {
		return this.#collisions.shapes.problems;
	}

	/** Whether two agents touch, as the last getCollisions saw them. */
	areColliding(a, b) {
		return this.#collisions.areColliding(a, b);
	}

	/** Goes on with other options. */
	exchange(options) {
		if (options.overlay) viewOf(this.#window);
		this.#collisions.exchange(options);
		if (this.isInstalled) this.#overlay.show(Boolean(this.options.overlay));
	}

	/** Shows what collides in the client's view, or ceases to. */
	showOverlay(isOn = true) {
		this.exchange({ overlay: isOn });
	}

	/** Sets traits that the client has no blocks for. */
	setTraits(whose, traits) {
		this.#collisions.setTraits(whose, traits);
	}

	/** Sets some of an agent's traits, as its blocks do; the others stay. */
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
