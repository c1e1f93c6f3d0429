import { Matrix4, Quaternion, Vector3 } from "three";
import { Agent, ArgumentError } from "starlogo-collision";
import { optionsOf, textOf, warnings } from "./arguments.js";
import { AgentPlace, isYUp } from "./axes.js";
import { isMadeOf, isPlaced, poseModel, upOf } from "./model.js";

/** The relative error that a scene's numbers may have, because many are of single precision. */
const TOLERANCE = 1e-6;

/**
 * What a call reads or writes; no call goes on with that of another one. The first four are where an object is in its land, and how large:
 * the matrix is what they were read from, if it was.
 */
const scratch = {
	matrix: new Matrix4(),
	position: new Vector3(),
	quaternion: new Quaternion(),
	scale: new Vector3(),
	composed: new Matrix4(),
	turn: new Quaternion(),
	offset: new Vector3(),
	numbers: new Float64Array(16),
};

/**
 * Keeps an agent and an object, or an instance of an InstancedMesh, in the same place: position, rotation and size. The object's parent is
 * the land, one unit per patch. For an instance the land is the InstancedMesh itself.
 */
export class ThreeAgentBinding {
	#place;
	#drawn;
	#model;
	// the object's place at the last update of either side
	#last = new Float64Array(16).fill(NaN);
	// The model's place in the object, in the scene's axes: the model's origin at size 1 relative to the object's, the turn before the
	// agent's, and the object's scale at size 1.
	#origin = new Vector3();
	#turn = null;
	#scale = 1;

	/**
	 * Creates a binding. It changes neither side.
	 *
	 * @param {object} agent the agent
	 * @param {object} object the Object3D that shows it
	 * @param {object} model the agent's model, if it was made of the object, of its geometry or of an equal one; null if the object is
	 * normalised like the model
	 * @param {{up?: "y" | "z", modelUp?: "y" | "z", index?: number}} options the up axis of the land and of the model's source; the index of
	 * the instance in an InstancedMesh
	 */
	constructor(agent, object, model = null, options = {}) {
		const { up, modelUp, index } = optionsOf("ThreeAgentBinding", options, { up: "y", modelUp: undefined, index: null });
		const isLandYUp = isYUp(up);
		this.#place = new AgentPlace(agent, isLandYUp, "ThreeAgentBinding");
		if (!object?.isObject3D) throw new ArgumentError(`ThreeAgentBinding: object must be an Object3D, not ${textOf(object)}`);
		this.#drawn = index === null ? new DrawnObject(agent, object) : new DrawnInstance(object, index, model);
		this.#model = model;
		if (model !== null) this.#setModel(model, isLandYUp);
		else warnings?.ofNoModel(agent, object);
		if (isYUp(modelUp === undefined ? upOf(model) ?? up : modelUp) !== isLandYUp) {
			const turn = new Quaternion(isLandYUp ? -Math.SQRT1_2 : Math.SQRT1_2, 0, 0, Math.SQRT1_2);
			this.#turn = this.#turn ? this.#turn.multiply(turn) : turn;
		}
	}

	#setModel(model, isLandYUp) {
		if (!model.source?.matrix) throw new ArgumentError(`ThreeAgentBinding: model must be a Model or null, not ${textOf(model)}`);
		if (isPlaced(model)) {
			throw new ArgumentError(`model "${model.name}" is of levelFromObject and has its object's place in it: its agent stays at the origin, without a binding. `
				+ "What moves has a model of modelFromObject(name, object, { scaling: Model.AS_GIVEN })");
		}
		const { matrix, position, quaternion, scale } = scratch;
		matrix.fromArray(model.source.matrix.rawData);
		if (!decompose()) throw new ArgumentError(`model "${model.name}" is mirrored or stretched in what it was made of: no object can be bound with it`);
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

	/** Gives the object the agent's place, size and rotation. */
	updateObject() {
		const place = this.#place;
		if (!place.takeChange() && !this.#hasMoved()) return;
		const { position, quaternion } = scratch;
		position.copy(this.#origin).multiplyScalar(place.size).applyQuaternion(place.quaternion).add(place.position);
		quaternion.copy(place.quaternion);
		if (this.#turn) quaternion.multiply(this.#turn);
		this.#drawn.write(position, quaternion, place.size * this.#scale);
		this.#drawn.fill(this.#last);
	}

	/** Gives the agent the object's place, size and rotation. */
	updateAgent() {
		const place = this.#place;
		if (!place.hasChanged && !this.#hasMoved()) return;
		this.#readDrawn();
		const { position, quaternion, scale, turn, offset } = scratch;
		const size = place.sizeFor(scale.x / this.#scale);
		if (this.#turn) quaternion.multiply(turn.copy(this.#turn).conjugate());
		position.sub(offset.copy(this.#origin).multiplyScalar(size).applyQuaternion(quaternion));
		this.#check(position, size);
		place.write(position, quaternion, size);
		this.#drawn.fill(this.#last);
	}

	/** Gives the model the pose of the object. */
	updateModel() {
		if (this.#model === null) throw new ArgumentError("the binding has no model: pass it to the constructor");
		if (this.#drawn instanceof DrawnInstance) throw new ArgumentError("an instance has no pose of its own");
		poseModel(this.#model, this.object);
	}

	/** Whether the object is elsewhere than at the last update. */
	#hasMoved() {
		const last = this.#last;
		const { numbers } = scratch;
		for (let i = this.#drawn.fill(numbers) - 1; i >= 0; i--) if (numbers[i] !== last[i]) return true;
		return false;
	}

	/** Reads the object's place. Throws if the scale is not positive and the same in x, y and z. */
	#readDrawn() {
		const isSimilar = this.#drawn.read();
		const { matrix, quaternion, scale, turn } = scratch;
		const { x, y, z } = scale;
		// two mirrors are a turn
		if (x * y * z > 0 && !(x > 0 && y > 0)) {
			quaternion.multiply(turn.set(x > 0 ? 1 : 0, y > 0 ? 1 : 0, z > 0 ? 1 : 0, 0));
			scale.set(Math.abs(x), Math.abs(y), Math.abs(z));
		}
		if (!isSimilar || !isEven(scale)) {
			const found = isSimilar ? `scale ${x}, ${y}, ${z}` : `matrix ${matrix.elements.join(", ")}`;
			throw new ArgumentError(`${this.agent} can't be as its object is: it must be turned, moved and evenly scaled, and nothing else, not ${found}`);
		}
		const length = quaternion.length();
		if (!(Math.abs(length - 1) <= TOLERANCE)) throw new ArgumentError(`${this.agent} can't be as its object is: the quaternion must be of length 1, not ${length}`);
		if (length !== 1) quaternion.normalize();
	}

	#check({ x, y, z }, size) {
		if (!Number.isFinite(x + y + z)) throw new ArgumentError(`${this.agent} can't be where its object is: the position must be finite numbers, not (${x}, ${y}, ${z})`);
		if (!(size >= Agent.SMALLEST_SIZE && size <= Agent.LARGEST_SIZE && Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) <= Agent.LARGEST_COORDINATE)) {
			throw new RangeError(`${this.agent} can't be of size ${size} at (${x}, ${y}, ${z}), as its object demands: see Agent's limits`);
		}
	}
}

/**
 * Binds an agent to an instance of an InstancedMesh, whose matrices have single precision. The model must have the mesh's geometry.
 *
 * @param {object} agent the agent
 * @param {object} mesh the InstancedMesh
 * @param {number} index the index of the instance
 * @param {object} model as for ThreeAgentBinding
 * @param {object} options up and modelUp, as for ThreeAgentBinding
 */
export function bindInstance(agent, mesh, index, model = null, options = {}) {
	return new ThreeAgentBinding(agent, mesh, model, { ...optionsOf("bindInstance", options, { up: "y", modelUp: undefined }), index: index ?? NaN });
}

/** The position, quaternion and scale of an object. If three.js does not use these for it, its matrix is read. */
class DrawnObject {
	constructor(agent, object) {
		this.object = object;
		this.fill(scratch.numbers);
		warnings?.ofScale(agent, object);
	}

	/** Writes the object's place into an array. Returns how many numbers it has. Throws if three.js would turn the object around a pivot. */
	fill(numbers) {
		const { object } = this;
		if (object.pivot) throw new ArgumentError(`ThreeAgentBinding: object "${object.name}" must have no pivot: put it into a Group, and bind the group`);
		if (!object.matrixAutoUpdate) {
			object.matrix.toArray(numbers);
			return 16;
		}
		object.position.toArray(numbers, 0);
		object.quaternion.toArray(numbers, 3);
		object.scale.toArray(numbers, 7);
		return 10;
	}

	/** Reads the object's place. Returns whether this describes the matrix completely. */
	read() {
		const { object } = this;
		if (!object.matrixAutoUpdate) {
			scratch.matrix.copy(object.matrix);
			return decompose();
		}
		scratch.position.copy(object.position);
		scratch.quaternion.copy(object.quaternion);
		scratch.scale.copy(object.scale);
		return true;
	}

	write(at, turn, factor) {
		const { object } = this;
		object.position.copy(at);
		object.scale.set(factor, factor, factor);
		// three.js computes Euler angles on each change
		if (!object.quaternion.equals(turn)) object.quaternion.copy(turn);
		if (!object.matrixAutoUpdate) object.updateMatrix();
	}
}

/** The matrix of an instance of an InstancedMesh, with the methods of a DrawnObject. */
class DrawnInstance {
	constructor(mesh, index, model) {
		if (!mesh.isInstancedMesh) throw new ArgumentError(`ThreeAgentBinding: object must be an InstancedMesh, not ${textOf(mesh)}`);
		const { count } = mesh.instanceMatrix;
		if (!(Number.isInteger(index) && index >= 0 && index < count)) throw new RangeError(`the mesh has instances 0 to ${count - 1}, not ${textOf(index)}`);
		if (isMadeOf(model, mesh)) throw new ArgumentError(`model "${model.name}" was made of all instances: an instance has a model of the mesh's geometry`);
		this.object = mesh;
		this.index = index;
	}

	fill(numbers) {
		const { array } = this.object.instanceMatrix;
		const first = 16 * this.index;
		for (let i = 0; i < 16; i++) numbers[i] = array[first + i];
		return 16;
	}

	read() {
		this.object.getMatrixAt(this.index, scratch.matrix);
		return decompose();
	}

	write(at, turn, factor) {
		const { object: mesh } = this;
		mesh.setMatrixAt(this.index, scratch.composed.compose(at, turn, scratch.scale.setScalar(factor)));
		mesh.instanceMatrix.needsUpdate = true;
		// The bounding volumes would stay where the instances were, and three.js does not draw what they show off the screen.
		mesh.boundingSphere = null;
		mesh.boundingBox = null;
	}
}

/** Decomposes the matrix that was read. Returns whether it only rotates, scales evenly and translates. */
function decompose() {
	const { matrix, position, quaternion, scale, composed } = scratch;
	matrix.decompose(position, quaternion, scale);
	composed.compose(position, quaternion, scale);
	return isEven(scale) && areAlike(matrix.elements, composed.elements, TOLERANCE * scale.x);
}

/** Whether the elements of two matrices differ by at most so much, those for the position aside. False for NaN. */
function areAlike(elements, others, tolerance) {
	for (let i = 0; i < 12; i++) if (!(Math.abs(elements[i] - others[i]) <= tolerance)) return false;
	return Math.abs(elements[15] - others[15]) <= tolerance;
}

/** Whether a scale is positive, finite and the same in x, y and z. False for NaN. */
const isEven = ({ x, y, z }) => x > 0 && x < Infinity && Math.abs(y - x) <= TOLERANCE * x && Math.abs(z - x) <= TOLERANCE * x;
