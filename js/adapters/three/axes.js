/** Space: the engine's z is up. Where a scene has y up, its (x, y, z) is the engine's (x, -z, y), which is a turn: nothing is mirrored. */
import { Quaternion, Vector3 } from "three";
import { ArgumentError } from "starlogo-collision";

/** Whether y is up; z is the other that can be. */
export function isYUp(up) {
	if (up !== "y" && up !== "z") throw new ArgumentError(`up must be "y" or "z", not ${textOf(up)}`);
	return up === "y";
}

/** How an error shows what was given. */
export function textOf(value) {
	return typeof value === "string" ? `"${value}"` : typeof value === "object" && value !== null ? `${value.constructor?.name ?? "object"}` : String(value);
}

const turn = [0, 0, 0, 1];

/** Where an agent is in a scene, in the scene's axes. */
export class AgentPlace {
	agent;
	position = new Vector3();
	quaternion = new Quaternion();
	size = 1;
	#isYUp;
	// those of the agent when it was read: of all, and of all but the position
	#revision = -1;
	#extentsRevision = -1;

	/**
	 * @param {object} agent the agent
	 * @param {boolean} isYUp whether the scene's y is up
	 */
	constructor(agent, isYUp) {
		if (typeof agent?.getQuaternion !== "function") throw new ArgumentError(`an Agent is needed, not ${textOf(agent)}`);
		this.agent = agent;
		this.#isYUp = isYUp;
	}

	/** Reads where the agent is now; whether it has changed since. */
	read() {
		const { agent } = this;
		if (agent.$revision === this.#revision) return false;
		this.#revision = agent.$revision;
		const placement = agent.$placement;
		if (this.#isYUp) this.position.set(placement.x, placement.z, -placement.y);
		else this.position.set(placement.x, placement.y, placement.z);
		if (placement.extentsRevision === this.#extentsRevision) return true;
		this.#extentsRevision = placement.extentsRevision;
		this.size = placement.size;
		// by their indices: taken apart as a list they are slower
		agent.$worldPlacement().readQuaternion(turn);
		if (this.#isYUp) this.quaternion.set(turn[0], turn[2], -turn[1], turn[3]);
		else this.quaternion.set(turn[0], turn[1], turn[2], turn[3]);
		return true;
	}

	/** Puts the agent at a place in the scene; a rotation that it has already, up to rounding, leaves its angles as they are. */
	write(position, quaternion, size) {
		const { agent } = this;
		this.read();
		if (this.#isYUp) agent.moveTo(position.x, -position.z, position.y);
		else agent.moveTo(position.x, position.y, position.z);
		agent.size = size;
		if (!isNear(quaternion, this.quaternion)) {
			if (this.#isYUp) agent.setQuaternion(quaternion.x, -quaternion.z, quaternion.y, quaternion.w);
			else agent.setQuaternion(quaternion.x, quaternion.y, quaternion.z, quaternion.w);
			this.quaternion.copy(quaternion);
		}
		// what it would read: the same, up to rounding
		this.position.copy(position);
		this.size = size;
		this.#revision = agent.$revision;
		this.#extentsRevision = agent.$placement.extentsRevision;
	}
}

const ROUNDING = 1e-15;

/** Whether two quaternions are the same rotation, up to rounding. */
function isNear(a, b) {
	const sign = a.dot(b) < 0 ? -1 : 1;
	return Math.abs(a.x - sign * b.x) <= ROUNDING && Math.abs(a.y - sign * b.y) <= ROUNDING
		&& Math.abs(a.z - sign * b.z) <= ROUNDING && Math.abs(a.w - sign * b.w) <= ROUNDING;
}
