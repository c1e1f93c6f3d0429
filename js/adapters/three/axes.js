import { Quaternion, Vector3 } from "three";
import { ArgumentError, Vector3D } from "starlogo-collision";
import { requirePoint, textOf } from "./arguments.js";

/** Whether y is up. The only other axis is z. */
export function isYUp(up) {
	if (up !== "y" && up !== "z") throw new ArgumentError(`up must be "y" or "z", not ${textOf(up)}`);
	return up === "y";
}

/** A point or direction of a scene with y up, in the engine's axes. */
export function toEngine(vector, out = null) {
	const { x, y, z } = requirePoint("toEngine", vector);
	return put(out ?? new Vector3D(), x, -z, y);
}

/** A point or direction of the engine, in the axes of a scene with y up. */
export function toScene(vector, out = null) {
	const { x, y, z } = requirePoint("toScene", vector);
	return put(out ?? new Vector3(), x, z, -y);
}

// not -0, which prints differently
function put(out, x, y, z) {
	return Object.assign(out, { x: x + 0, y: y + 0, z: z + 0 });
}

const turn = [0, 0, 0, 1];

/**
 * An agent's place in a scene, in the scene's axes. The engine has z up. If the scene has y up, its (x, y, z) is the engine's (x, -z, y).
 * That is a turn, so nothing is mirrored.
 */
export class AgentPlace {
	agent;
	position = new Vector3();
	quaternion = new Quaternion();
	size = 1;
	#isYUp;
	// the agent's revisions when it was last read: of everything, and of everything but the position
	#revision = -1;
	#bodyRevision = -1;

	/**
	 * @param {object} agent the agent
	 * @param {boolean} isYUp whether the scene has y up
	 * @param {string} call the function that has got the agent
	 */
	constructor(agent, isYUp, call) {
		if (typeof agent?.getQuaternion !== "function") throw new ArgumentError(`${call}: agent must be an Agent, not ${textOf(agent)}`);
		this.agent = agent;
		this.#isYUp = isYUp;
	}

	/** Whether the agent is elsewhere than it was last read. */
	get hasChanged() {
		return this.agent.$revision !== this.#revision;
	}

	/** Reads the agent's present place. Returns whether it has changed. */
	takeChange() {
		if (!this.hasChanged) return false;
		const { agent } = this;
		this.#revision = agent.$revision;
		const placement = agent.$placement;
		if (this.#isYUp) this.position.set(placement.x, placement.z, -placement.y);
		else this.position.set(placement.x, placement.y, placement.z);
		if (agent.$bodyRevision === this.#bodyRevision) return true;
		this.#bodyRevision = agent.$bodyRevision;
		this.size = placement.size;
		// by indices, because destructuring the list is slower
		agent.$freshPlacement().readQuaternion(turn);
		if (this.#isYUp) this.quaternion.set(turn[0], turn[2], -turn[1], turn[3]);
		else this.quaternion.set(turn[0], turn[1], turn[2], turn[3]);
		return true;
	}

	/** A size of the scene; if the agent already has it, up to rounding, its own. */
	sizeFor(size) {
		return Math.abs(size - this.agent.size) <= ROUNDING * size ? this.agent.size : size;
	}

	/** Moves the agent to a place in the scene. If it already has the rotation, up to rounding, its angles stay. */
	write(position, quaternion, size) {
		const { agent } = this;
		this.takeChange();
		if (this.#isYUp) agent.moveTo(position.x, -position.z, position.y);
		else agent.moveTo(position.x, position.y, position.z);
		agent.size = size;
		if (!isNear(quaternion, this.quaternion)) {
			if (this.#isYUp) agent.setQuaternion(quaternion.x, -quaternion.z, quaternion.y, quaternion.w);
			else agent.setQuaternion(quaternion.x, quaternion.y, quaternion.z, quaternion.w);
			this.quaternion.copy(quaternion);
		}
		// the values that takeChange() would give, up to rounding
		this.position.copy(position);
		this.size = size;
		this.#revision = agent.$revision;
		this.#bodyRevision = agent.$bodyRevision;
	}
}

const ROUNDING = 1e-15;

/** Whether two quaternions are the same rotation, up to rounding. */
function isNear(a, b) {
	const sign = a.dot(b) < 0 ? -1 : 1;
	return Math.abs(a.x - sign * b.x) <= ROUNDING && Math.abs(a.y - sign * b.y) <= ROUNDING
		&& Math.abs(a.z - sign * b.z) <= ROUNDING && Math.abs(a.w - sign * b.w) <= ROUNDING;
}
