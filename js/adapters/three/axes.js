import { Quaternion, Vector3 } from "three";
import { ArgumentError, Vector3D } from "starlogo-collision";
import { requirePoint, textOf } from "./arguments.js";

/**
 * Turns a point, a direction or a quaternion from a scene's axes to the engine's, in place. The engine has z up. If the scene has y up, its (x, y, z)
 * is the engine's (x, -z, y). That is a turn, so nothing is mirrored.
 */
export function toEngineAxes(vector, isYUp) {
	if (isYUp) {
		const { y } = vector;
		vector.y = 0 - vector.z; // not -0, which prints differently
		vector.z = y;
	}
	return vector;
}

/** Turns a point, a direction or a quaternion from the engine's axes to a scene's, in place. */
export function toSceneAxes(vector, isYUp) {
	if (isYUp) {
		const { y } = vector;
		vector.y = vector.z;
		vector.z = 0 - y;
	}
	return vector;
}

/** A point or direction of a scene with y up, in the engine's axes. */
export function toEngine(vector, out = null) {
	return toEngineAxes(copyTo(out ?? new Vector3D(), requirePoint("toEngine", vector)), true);
}

/** A point or direction of the engine, in the axes of a scene with y up. */
export function toScene(vector, out = null) {
	return toSceneAxes(copyTo(out ?? new Vector3(), requirePoint("toScene", vector)), true);
}

const copyTo = (out, { x, y, z }) => Object.assign(out, { x: x + 0, y: y + 0, z: z + 0 });

// for one call each: an agent's rotation as the engine has it, and a place or a rotation on its way to the other axes
const numbers = [0, 0, 0, 1];
const rotation = new Quaternion();
const point = new Vector3();

const ROUNDING = 1e-15;

/** The transform of an agent when it was last read or written, in the axes of a scene. */
export class AgentTransform {
	agent;
	position = new Vector3();
	quaternion = new Quaternion();
	size = 1;
	#isYUp;
	// the agent's revisions then: of everything, and of everything but the position
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

	/** Whether the agent has changed since. */
	get hasChanged() {
		return this.agent.$revision !== this.#revision;
	}

	/** Reads the agent's present transform. Returns whether it has changed. */
	readIfChanged() {
		if (!this.hasChanged) return false;
		const { agent } = this;
		this.#revision = agent.$revision;
		const { x, y, z, size } = agent.$placement;
		toSceneAxes(this.position.set(x, y, z), this.#isYUp);
		if (agent.$bodyRevision === this.#bodyRevision) return true;
		this.#bodyRevision = agent.$bodyRevision;
		this.size = size;
		this.#readQuaternion(this.quaternion);
		return true;
	}

	/** A size of the scene; if the agent already has it, up to rounding, its own. */
	sizeFor(size) {
		return Math.abs(size - this.agent.size) <= ROUNDING * size ? this.agent.size : size;
	}

	/** Moves the agent to a place in the scene. If it already has the rotation, up to rounding, its angles stay. */
	moveAgentTo(position, quaternion, size) {
		const { agent } = this;
		const { x, y, z } = toEngineAxes(point.copy(position), this.#isYUp);
		agent.moveTo(x, y, z);
		agent.size = size;
		// the values that readIfChanged() would give, up to rounding
		this.position.copy(position);
		this.size = size;
		if (isNear(quaternion, this.#readQuaternion(rotation))) {
			this.quaternion.copy(rotation);
		} else {
			this.quaternion.copy(quaternion);
			toEngineAxes(rotation.copy(quaternion), this.#isYUp);
			agent.setQuaternion(rotation.x, rotation.y, rotation.z, rotation.w);
		}
		this.#revision = agent.$revision;
		this.#bodyRevision = agent.$bodyRevision;
	}

	#readQuaternion(out) {
		this.agent.$freshPlacement().readQuaternion(numbers);
		return toSceneAxes(out.fromArray(numbers), this.#isYUp);
	}
}

/** Whether two quaternions are the same rotation, up to rounding. */
function isNear(a, b) {
	const sign = a.dot(b) < 0 ? -1 : 1;
	return Math.abs(a.x - sign * b.x) <= ROUNDING && Math.abs(a.y - sign * b.y) <= ROUNDING
		&& Math.abs(a.z - sign * b.z) <= ROUNDING && Math.abs(a.w - sign * b.w) <= ROUNDING;
}
