/** Finds the agents that hide the agent followed by the camera: large ones that stand still, for example walls. */
import { CollisionBlocks, Vector3D } from "starlogo-collision";
import { lateEngine } from "../game/late.js";

/** The two points of an agent that must be visible, feet and head, as shares of its height. */
const PLACES = [0.15, 0.9];

export class Occluders {
	#still = [];
	#hits = [];
	#found = new Set();
	#eye = new Vector3D();
	#way = new Vector3D();

	constructor(greatLand) {
		this.queries = new lateEngine.AgentQueries(new CollisionBlocks(greatLand, []).systemNamed(CollisionBlocks.TIGHTEST_FITS));
	}

	/**
	 * @param {{agents: object[], frame: number}} world the game
	 * @param {object} main the agent that is followed
	 * @param {number} height its height
	 * @param {{x: number, y: number, z: number}} eye the camera's place
	 * @returns {Set} the agents between the eye and it; overwritten by the next call
	 */
	of({ agents, frame }, main, height, eye) {
		this.#found.clear();
		this.#still.length = 0;
		for (const agent of agents) if (agent !== main && agent.size > main.size && !isMoving(agent, frame)) this.#still.push(agent);
		if (this.#still.length === 0) return this.#found;
		this.queries.update(this.#still);
		this.#eye.setTo(eye.x, eye.y, eye.z);
		for (const share of PLACES) {
			this.#way.setTo(main.x - eye.x, main.y - eye.y, main.z + share * height - eye.z);
			this.queries.castAll(this.#eye, this.#way, this.#way.length, null, this.#hits);
			for (const { agent } of this.#hits) this.#found.add(agent);
		}
		return this.#found;
	}
}

/** Whether an agent has moved in this frame. A new agent has not. */
export const isMoving = (agent, frame) => agent.born !== frame && (agent.before[0] !== agent.x || agent.before[1] !== agent.y);
