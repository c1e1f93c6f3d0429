/** The StarLogo Nova client's own engine, without its page: where the environment's NOVA names the client's folder. */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import vm from "node:vm";

/** The client's folder, or undefined. */
export const NOVA = process.env.NOVA;

/** Its projects. */
export const PROJECTS = ["FishAlgae", "Anemia1", "Anemia2"].filter((project) => NOVA && existsSync(join(NOVA, project)));

/** Anything that the page has and the engine only names. */
function nothing() {
	return new Proxy(function () {}, {
		get: (_, name) => (name === Symbol.toPrimitive ? () => "" : nothing()),
		apply: () => nothing(),
		construct: () => nothing(),
	});
}

/** A window with the client's engine in it, and two breeds with collision blocks. */
export function loadEngine() {
	const window = { console, performance, slnova: nothing(), sb: nothing(), document: nothing(), viewport: nothing(), WidgetManager: { getWidgetsByType: () => [] } };
	window.window = window;
	vm.createContext(window);
	vm.runInContext(readFileSync(join(NOVA, "FishAlgae/en/slnova_static_files/ts/app.js"), "utf8"), window);
	const { AgentController, Collisions } = window.Execution;
	const { State } = window.Common;
	const ids = ["Fish", "Algae"].map((name) => AgentController.addBreed(name));
	for (const id of [0, 1, ...ids]) {
		State.buttonMap[id] = [];
		Collisions.bins.set(id, Array.from({ length: 10 }, () => Array.from({ length: 10 }, () => [])));
	}
	State.binningOn = true;
	State.collidingBreeds = new Set([ids[0]]);
	State.collidedBreeds = new Map([[ids[0], [ids[0], ids[1]]]]);
	AgentController.numAgents = 0;
	AgentController.worldInstance = new window.Execution.Observer();
	return window;
}

/** Agents of both breeds all over the ground. */
export function makeAgents({ Execution: { Agent, AgentController, Collisions } }, count, random) {
	return Array.from({ length: count }, (_, i) => {
		const agent = new Agent(AgentController.getByName(i % 2 ? "Algae" : "Fish"));
		agent.state.x = random() * 101 - 50.5;
		agent.state.y = random() * 101 - 50.5;
		Collisions.update(agent);
		return agent;
	});
}
