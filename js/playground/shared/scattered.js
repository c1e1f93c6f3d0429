/** The engine's own scattered scene (ScatteredScene.as). Nothing here draws. */
import { Agent } from "starlogo-collision";

/** Half the width of the ground. */
export const HALF_WIDTH = 50;
const STEP = 0.3;
const SIZE = 5;

/** The shapes of its agents, used in turn. */
export const CAST = ["bear", "dragon", "fireman", "seagull", "fortress", "person"];

/** A game of agents all over the ground. They walk straight on and turn a little every frame. An agent that leaves comes in on the other side. */
export class ScatteredGame {
	agents = [];
	#random = 20150601;

	/**
	 * @param {number} count the number of agents
	 * @param {number} halfWidth half the width of their ground
	 * @param {string[]} cast their shapes, used in turn
	 */
	constructor(count, halfWidth = HALF_WIDTH, cast = CAST) {
		this.halfWidth = halfWidth;
		for (let i = 0; i < count; i++) {
			const agent = new Agent(cast[i % cast.length]);
			agent.moveTo(this.#between(-halfWidth, halfWidth), this.#between(-halfWidth, halfWidth), 0);
			agent.heading = this.#between(0, 360);
			agent.size = SIZE;
			// every other agent is hierarchical, for the combination
			agent.hierarchical = i % 2 === 0;
			this.agents.push(agent);
		}
	}

	step() {
		for (const agent of this.agents) {
			agent.heading += this.#between(-10, 10);
			const angle = (agent.heading * Math.PI) / 180;
			agent.moveTo(this.#wrapped(agent.x + STEP * Math.cos(angle)), this.#wrapped(agent.y + STEP * Math.sin(angle)), 0);
		}
	}

	#wrapped(coordinate) {
		const { halfWidth } = this;
		return coordinate > halfWidth ? coordinate - 2 * halfWidth : coordinate < -halfWidth ? coordinate + 2 * halfWidth : coordinate;
	}

	// Knuth, TAOCP 2, §3.3.4
	#between(low, high) {
		this.#random = (Math.imul(this.#random, 1664525) + 1013904223) >>> 0;
		return low + ((high - low) * this.#random) / 4294967296;
	}
}
