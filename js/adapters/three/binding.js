/** Agents in the place of what three.js draws for them. */
import { Matrix4, Quaternion, Vector3 } from "three";
import { Agent, ArgumentError } from "starlogo-collision";
import { AgentPlace, isYUp, textOf } from "./axes.js";
import { upOf } from "./model.js";

/** What numbers of a scene may be off, relative: many are of single precision. */
const TOLERANCE = 1e-6;

const position = new Vector3();
const quaternion = new Quaternion();
const scale = new Vector3();
const matrix = new Matrix4();

/**
 * Keeps an agent and an object, or an instance of an InstancedMesh, in the same place: position, rotation and size. The object's parent,
 * the InstancedMesh itself for an instance, is the land: a unit is a patch.
 */
export class ThreeAgentBinding {
	#place;
	#drawn;
	// what the drawn was when both were last made the same
	#last = new Float64Array(16).fill(NaN);
	// where the model is in what is drawn, in the scene's axes: the model's origin at size 1 from the object's, the turn before the agent's, and
	// the object's scale at size 1
	#origin = new Vector3();
	#turn = null;
	#scale = 1;

	/**
	 * Changes neither.
	 *
	 * @param {object} agent the agent
	 * @param {object} object the Object3D that is drawn for it
	 * @param {object} model what the agent's shape was made of: the object, its geometry, or what is the same; null if the object is drawn as the
	 *     model is, normalised
	 * @param {{up?: "y" | "z", modelUp?: "y" | "z", index?: number}} options which axis of the land, and of the model's source, is up; which
	 *     instance it is of an InstancedMesh
	 */
	constructor(agent, object, model = null, { up = "y", modelUp = upOf(model) ?? up, index = null } = {}) {
		if (!object?.isObject3D) throw new ArgumentError(`an Object3D is needed, not ${textOf(object)}`);
		const isLandYUp = isYUp(up);
		this.#place = new AgentPlace(agent, isLandYUp);
		this.#drawn = index === null ? new DrawnObject(object) : new DrawnInstance(object, index);
		if (model !== null) this.#setModel(model, isLandYUp);
		if (isYUp(modelUp) !== isLandYUp) {
			const turn = new Quaternion(isLandYUp ? -Math.SQRT1_2 : Math.SQRT1_2, 0, 0, Math.SQRT1_2);
			this.#turn = this.#turn ? this.#turn.multiply(turn) : turn;
		}
	}

	#setModel(model, isLandYUp) {
		if (!model.source?.matrix) throw new ArgumentError(`a Model is needed, or null, not ${textOf(model)}`);
		matrix.fromArray(model.source.matrix.rawData);
		if (!decompose(matrix)) throw new ArgumentError(`model "${model.name}" is mirrored or stretched in what it was made of: no object can be bound with it`);
		const { x, y, z, w } = quaternion;
		if (w !== 1) this.#turn = isLandYUp ? new Quaternion(x, z, -y, w) : quaternion.clone();
		if (isLandYUp) this.#origin.set(position.x, position.z, -position.y);
		else this.#origin.copy(position);
		this.#scale = scale.x;
	}

	get agent() {
		return this.#place.agent;
	}

	get object() {
		return this.#drawn.object;
	}

	/** Puts the object where the agent is, as large, turned the same way. */
	updateObject() {
		const place = this.#place;
		if (!place.read() && !this.#drawn.differsFrom(this.#last)) return;
		position.copy(this.#origin).multiplyScalar(place.size).applyQuaternion(place.quaternion).add(place.position);
		quaternion.copy(place.quaternion);
		if (this.#turn) quaternion.multiply(this.#turn);
		this.#drawn.write(position, quaternion, place.size * this.#scale);
		this.#drawn.fill(this.#last);
	}

	/** Gives the agent the object's place, size and rotation. */
	updateAgent() {
		const place = this.#place;
		if (!place.read() && !this.#drawn.differsFrom(this.#last)) return;
		this.#readDrawn();
		const size = scale.x / this.#scale;
		if (this.#turn) quaternion.multiply(turned.copy(this.#turn).conjugate());
		position.sub(offset.copy(this.#origin).multiplyScalar(size).applyQuaternion(quaternion));
		this.#check(size);
		place.write(position, quaternion, size);
		this.#drawn.fill(this.#last);
	}

	/** Reads the place of what is drawn, with a scale that is the same and positive in x, y and z. */
	#readDrawn() {
		const isSimilar = this.#drawn.read();
		const { x, y, z } = scale;
		// mirrored twice is turned
		if (x * y * z > 0 && !(x > 0 && y > 0)) {
			quaternion.multiply(turned.set(x > 0 ? 1 : 0, y > 0 ? 1 : 0, z > 0 ? 1 : 0, 0));
			scale.set(Math.abs(x), Math.abs(y), Math.abs(z));
		}
		if (!isSimilar || !isEven(scale)) {
			const said = isSimilar ? `scale ${x}, ${y}, ${z}` : `matrix ${matrix.elements.join(", ")}`;
			throw new ArgumentError(`${this.agent} can't be as its object is: it must be turned, moved and evenly scaled, and nothing else, not ${said}`);
		}
		const length = quaternion.length();
		if (!(Math.abs(length - 1) <= TOLERANCE)) throw new ArgumentError(`${this.agent} can't be as its object is: the quaternion must be of length 1, not ${length}`);
		if (length !== 1) quaternion.normalize();
	}

	#check(size) {
		const { x, y, z } = position;
		if (!Number.isFinite(x + y + z)) throw new ArgumentError(`${this.agent} can't be where its object is: the position must be finite numbers, not (${x}, ${y}, ${z})`);
		if (!(size >= Agent.SMALLEST_SIZE && size <= Agent.LARGEST_SIZE && Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) <= Agent.LARGEST_COORDINATE)) {
			throw new RangeError(`${this.agent} can't be of size ${size} at (${x}, ${y}, ${z}), as its object is: see Agent's limits`);
		}
	}
}

/**
 * Binds an agent to an instance of an InstancedMesh, whose matrices are of single precision. The model is of the mesh's geometry.
 *
 * @param {object} agent the agent
 * @param {object} mesh the InstancedMesh
 * @param {number} index which instance
 * @param {object} model as ThreeAgentBinding takes it
 * @param {object} options up and modelUp, as ThreeAgentBinding takes them
 */
export const bindInstance = (agent, mesh, index, model = null, options = {}) => new ThreeAgentBinding(agent, mesh, model, { ...options, index });

const turned = new Quaternion();
const offset = new Vector3();
const composed = new Matrix4();

/** An object by its position, quaternion and scale; by its matrix if three.js does not make that of them. */
class DrawnObject {
	constructor(object) {
		this.object = object;
	}

	/** Whether an array of 16 numbers has not what says where it is. */
	differsFrom(last) {
		const { object } = this;
		if (!object.matrixAutoUpdate) return differ(object.matrix.elements, 0, last);
		const { position: at, quaternion: turn, scale: factors } = object;
		return at.x !== last[0] || at.y !== last[1] || at.z !== last[2] || turn.x !== last[3] || turn.y !== last[4] || turn.z !== last[5] || turn.w !== last[6]
			|| factors.x !== last[7] || factors.y !== last[8] || factors.z !== last[9];
	}

	/** Writes that into it. */
	fill(last) {
		const { object } = this;
		if (!object.matrixAutoUpdate) {
			last.set(object.matrix.elements);
			return;
		}
		const { position: at, quaternion: turn, scale: factors } = object;
		last[0] = at.x;
		last[1] = at.y;
		last[2] = at.z;
		last[3] = turn.x;
		last[4] = turn.y;
		last[5] = turn.z;
		last[6] = turn.w;
		last[7] = factors.x;
		last[8] = factors.y;
		last[9] = factors.z;
	}

	/** Reads position, quaternion and scale; whether they are all that there is. */
	read() {
		const { object } = this;
		if (!object.matrixAutoUpdate) return decompose(matrix.copy(object.matrix));
		position.copy(object.position);
		quaternion.copy(object.quaternion);
		scale.copy(object.scale);
		return true;
	}

	write(at, turn, factor) {
		const { object } = this;
		object.position.copy(at);
		object.scale.set(factor, factor, factor);
		// three.js computes Euler's angles each time
		if (!object.quaternion.equals(turn)) object.quaternion.copy(turn);
		if (!object.matrixAutoUpdate) object.updateMatrix();
	}
}

class DrawnInstance {
	constructor(mesh, index) {
		if (!mesh.isInstancedMesh) throw new ArgumentError(`an InstancedMesh is needed, not ${textOf(mesh)}`);
		const { count } = mesh.instanceMatrix;
		if (!(Number.isInteger(index) && index >= 0 && index < count)) throw new RangeError(`the mesh has instances 0 to ${count - 1}, not ${textOf(index)}`);
		this.object = mesh;
		this.index = index;
	}

	differsFrom(last) {
		return differ(this.object.instanceMatrix.array, 16 * this.index, last);
	}

	fill(last) {
		const { array } = this.object.instanceMatrix;
		const first = 16 * this.index;
		for (let i = 0; i < 16; i++) last[i] = array[first + i];
	}

	read() {
		this.object.getMatrixAt(this.index, matrix);
		return decompose(matrix);
	}

	write(at, turn, factor) {
		const { object: mesh } = this;
		mesh.setMatrixAt(this.index, matrix.compose(at, turn, scale.set(factor, factor, factor)));
		mesh.instanceMatrix.needsUpdate = true;
		// they would be where instances were: what is off the screen is not drawn
		mesh.boundingSphere = null;
		mesh.boundingBox = null;
	}
}

/** Whether 16 numbers of an array, from one on, are not those of another. */
function differ(array, first, last) {
	for (let i = 0; i < 16; i++) if (array[first + i] !== last[i]) return true;
	return false;
}

/** Takes a matrix apart, into position, quaternion and scale; whether it turns, evenly scales and moves, and nothing else. */
function decompose(from) {
	from.decompose(position, quaternion, scale);
	composed.compose(position, quaternion, scale);
	return isEven(scale) && from.elements.every((element, i) => Math.abs(element - composed.elements[i]) <= TOLERANCE * scale.x || (i > 11 && i < 15));
}

/** Whether a scale is positive, finite and the same in x, y and z; false for NaN. */
const isEven = ({ x, y, z }) => x > 0 && x < Infinity && Math.abs(y - x) <= TOLERANCE * x && Math.abs(z - x) <= TOLERANCE * x;
