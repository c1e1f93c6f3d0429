/** The collision engine for the StarLogo Nova client. */
import { NovaCollisions } from "./collisions.js";

/** What the client's Collisions does, and is done in its place. */
const METHODS = ["add", "remove", "update", "getCollisions", "count", "nearest", "empty", "reset"];

/** Where a client has what is installed in it; other copies of this script find it there too. */
const INSTALLED = Symbol.for("starlogo-collision.nova");

/**
 * Puts the engine in the place of the collisions of the StarLogo Nova client that runs in a window. What was installed there before is uninstalled.
 */
export function installInto(window, options = {}) {
	const client = window?.Execution?.Collisions;
	if (!client || !window.Common?.State || !window.Execution.AgentController) throw new TypeError("the window has no StarLogo Nova client: Execution.Collisions is not there");
	const collisions = new NovaCollisions(window, options);
	client[INSTALLED]?.uninstall();
	const installation = new Installation(window, client, collisions);
	Object.defineProperty(client, INSTALLED, { value: installation, configurable: true });
	return installation;
}

/** What is installed in a client. */
class Installation {
	#window;
	#client;
	#collisions;
	#given = [];

	constructor(window, client, collisions) {
		this.#window = window;
		this.#client = client;
		this.#collisions = collisions;
		client.reset();
		for (const name of METHODS) this.#replace(client, name, () => collisions[name].bind(collisions));
		// it moves all agents and tells nobody
		if (typeof window.Execution.AgentController.scatterAllAgents === "function") {
			this.#replace(window.Execution.AgentController, "scatterAllAgents", (scatter) => function (...args) {
				collisions.forgetPlaces();
				return scatter.apply(this, args);
			});
		}
		this.#addAll();
	}

	/** Whether it is. */
	get isInstalled() {
		return this.#given.length > 0;
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
		this.#collisions.exchange(options);
	}

	/** Sets traits that the client has no blocks for. */
	setTraits(whose, traits) {
		this.#collisions.setTraits(whose, traits);
	}

	/** Gives the client its own collisions back, with all agents in its bins. */
	uninstall() {
		if (!this.isInstalled) return;
		for (const give of this.#given.splice(0)) give();
		delete this.#client[INSTALLED];
		this.#collisions.shapes.stop();
		this.#collisions.reset();
		this.#client.reset();
		this.#addAll();
	}

	#replace(object, name, make) {
		const given = Object.getOwnPropertyDescriptor(object, name);
		Object.defineProperty(object, name, { value: make(object[name]), writable: true, configurable: true, enumerable: given?.enumerable ?? false });
		this.#given.push(() => {
			if (given) Object.defineProperty(object, name, given);
			else delete object[name];
		});
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
