/** Who hides the agent that the camera follows: large ones that stand still, as walls do. */
import { AgentQueries, CollisionBlocks, Vector3D } from "starlogo-collision";

/** What is looked for of an agent: its feet and its head, as shares of its height. */
const PLACES = [0.15, 0.9];

export class Hiding {
	#still = [];
	#hits = [];
	#found = new Set();
	#eye = new Vector3D();
	#way = new Vector3D();

	constructor(greatLand) {
		this.queries = new AgentQueries(new CollisionBlocks(greatLand, []).systemNamed(CollisionBlocks.TIGHTEST_FITS));
	}

	/**
	 * @param {{agents: object[], frame: number}} world the game
	 * @param {object} main the agent that is followed
	 * @param {number} height its height
	 * @param {{x: number, y: number, z: number}} eye where it is seen from
	 * @returns {Set} those that are between the eye and it; overwritten by the next call
	 */
	of({ agents, frame }, main, height, eye) {
		this.#found.clear();
		this.#still.length = 0;
		for (const agent of agents) if (agent !== main && agent.size > main.size && isStill(agent, frame)) this.#still.push(agent);
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

/** Whether an agent is where it was, as everyone is who has just come. */
const isStill = (agent, frame) => agent.born === frame || (agent.before[0] === agent.x && agent.before[1] === agent.y);
