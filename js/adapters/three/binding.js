import { Matrix4, Quaternion, Vector3 } from "three";
import { Agent, ArgumentError } from "starlogo-collision";
import { isYUp as isAxisY, optionsOf, textOf, warnings } from "./arguments.js";
import { AgentTransform, toSceneAxes } from "./axes.js";
import { conversionOf, poseModel } from "./model.js";

/** The relative error that a scene's numbers may have, because many are of single precision. */
const TOLERANCE = 1e-6;

const PUT_INTO_GROUP = ". Put what is scaled or mirrored into a Group, make the model of the group, and bind the group";

// for one call each: the numbers of a transform, where an object is in its land and how large, and what these are computed with
const snapshot = new Float64Array(16);
const components = { position: new Vector3(), quaternion: new Quaternion(), scale: new Vector3() };
const given = new Matrix4();
const composed = new Matrix4();
const turn = new Quaternion();
const offset = new Vector3();

/**
 * Keeps an agent and an object, or an instance of an InstancedMesh, in the same place: position, rotation and size. The object's parent is
 * the land, one unit per patch. For an instance the land is the InstancedMesh itself.
 */
export class ThreeAgentBinding {
	#agentTransform;
	#objectTransform;
	#model;
	// the object's transform at the last update of either side
	#lastSnapshot = new Float64Array(16).fill(NaN);
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
		const { isYUp, modelUp, index } = optionsOf("ThreeAgentBinding", options, { modelUp: undefined, index: null });
		this.#agentTransform = new AgentTransform(agent, isYUp, "ThreeAgentBinding");
		if (!object?.isObject3D) {
			const hint = object?.scene?.isObject3D ? ". Its scene is one" : "";
			throw new ArgumentError(`ThreeAgentBinding: object must be an Object3D, not ${textOf(object)}${hint}`);
		}
		this.#objectTransform = index === null ? new ObjectTransform(agent, object, model) : new InstanceTransform(object, index, model);
		this.#model = model;
		if (model !== null) this.#setModel(model, isYUp);
		else warnings?.ofNoModel(agent, object);
		if ((modelUp === undefined ? conversionOf(model)?.isYUp ?? isYUp : isAxisY(modelUp, "ThreeAgentBinding: options.modelUp")) !== isYUp) {
			const upright = new Quaternion(isYUp ? -Math.SQRT1_2 : Math.SQRT1_2, 0, 0, Math.SQRT1_2);
			this.#turn = this.#turn ? this.#turn.multiply(upright) : upright;
		}
	}

	#setModel(model, isYUp) {
		if (!model.source?.matrix) throw new ArgumentError(`ThreeAgentBinding: model must be a Model or null, not ${textOf(model)}: it comes third, before the options`);
		if (conversionOf(model)?.isPlaced) {
			throw new ArgumentError(`model "${model.name}" is of levelFromObject and has its object's place in it: its agent stays at the origin, without a binding. `
				+ "What moves has a model of modelFromObject(name, object, { scaling: Model.AS_GIVEN })");
		}
		const { position, quaternion, scale } = components;
		if (!decompose(given.fromArray(model.source.matrix.rawData), components)) {
			throw new ArgumentError(`model "${model.name}" is mirrored or stretched in what it was made of: no object can be bound with it`);
		}
		if (quaternion.w !== 1) this.#turn = toSceneAxes(quaternion.clone(), isYUp);
		toSceneAxes(this.#origin.copy(position), isYUp);
		this.#scale = scale.x;
	}

	get agent() {
		return this.#agentTransform.agent;
	}

	get object() {
		return this.#objectTransform.object;
	}

	/** Gives the object the agent's place, size and rotation. */
	updateObject() {
		const agentTransform = this.#agentTransform;
		const hasMoved = this.#hasMoved();
		const placeBefore = warnings?.placeIfFirst(this.agent, this.object);
		if (!agentTransform.readIfChanged() && !hasMoved) return;
		const placeGiven = warnings && hasMoved ? this.object.position.clone() : null;
		const { position, quaternion } = components;
		position.copy(this.#origin).multiplyScalar(agentTransform.size).applyQuaternion(agentTransform.quaternion).add(agentTransform.position);
		quaternion.copy(agentTransform.quaternion);
		if (this.#turn) quaternion.multiply(this.#turn);
		this.#objectTransform.compose(position, quaternion, agentTransform.size * this.#scale);
		if (placeBefore) warnings.ofFirstUpdate(this.agent, this.object, placeBefore);
		else warnings?.ofUpdateObject(this.agent, this.object, placeGiven);
		this.#objectTransform.snapshotInto(this.#lastSnapshot);
	}

	/** Gives the agent the object's place, size and rotation. */
	updateAgent() {
		const agentTransform = this.#agentTransform;
		const placeBefore = warnings?.placeIfMoved(this.agent);
		const hasMoved = this.#hasMoved();
		if (hasMoved) {
			this.#decomposeObject();
			const { position, quaternion, scale } = components;
			const size = agentTransform.sizeFor(scale.x / this.#scale);
			if (this.#turn) quaternion.multiply(turn.copy(this.#turn).conjugate());
			position.sub(offset.copy(this.#origin).multiplyScalar(size).applyQuaternion(quaternion));
			this.#check(position, size);
			agentTransform.moveAgentTo(position, quaternion, size);
			this.#objectTransform.snapshotInto(this.#lastSnapshot);
		} else if (agentTransform.hasChanged) {
			// where it was at the last update, without the rounding of a way back from the object
			agentTransform.moveAgentTo(agentTransform.position, agentTransform.quaternion, agentTransform.size);
		}
		warnings?.ofUpdateAgent(this.agent, this.object, placeBefore, hasMoved);
	}

	/** Gives the model the pose of the object. */
	updateModel() {
		if (this.#model === null) throw new ArgumentError(`the binding of ${this.agent} has no model: it is the third argument of new ThreeAgentBinding(agent, object, model)`);
		if (this.#objectTransform instanceof InstanceTransform) throw new ArgumentError("an instance has no pose of its own");
		poseModel(this.#model, this.object);
		warnings?.keepPose(this.#model, this.agent);
	}

	/** Whether the object is elsewhere than at the last update. */
	#hasMoved() {
		const last = this.#lastSnapshot;
		for (let i = this.#objectTransform.snapshotInto(snapshot) - 1; i >= 0; i--) if (snapshot[i] !== last[i]) return true;
		return false;
	}

	/** Writes the object's transform into the components. Throws if the scale is not positive and uniform. */
	#decomposeObject() {
		const isSimilarity = this.#objectTransform.decomposeInto(components);
		const { quaternion, scale } = components;
		const { x, y, z } = scale;
		// two mirrors are a turn
		if (x * y * z > 0 && !(x > 0 && y > 0)) {
			quaternion.multiply(turn.set(x > 0 ? 1 : 0, y > 0 ? 1 : 0, z > 0 ? 1 : 0, 0));
			scale.set(Math.abs(x), Math.abs(y), Math.abs(z));
		}
		if (!isSimilarity || !isUniform(scale)) {
			const found = isSimilarity ? `scale ${x}, ${y}, ${z}` : `matrix ${this.#objectTransform.matrix.elements.join(", ")}`;
			throw this.#error(`it must be turned, moved and uniformly scaled, and nothing else, not ${found}${Math.abs(x * y * z) > 0 ? PUT_INTO_GROUP : ""}`);
		}
		const length = quaternion.length();
		if (!(Math.abs(length - 1) <= TOLERANCE)) throw this.#error(`the quaternion must be of length 1, not ${length}`);
		if (length !== 1) quaternion.normalize();
	}

	#check({ x, y, z }, size) {
		const farthest = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
		if (!Number.isFinite(farthest)) throw this.#error(`the position must be finite numbers, not (${x}, ${y}, ${z})`);
		if (!(size >= Agent.SMALLEST_SIZE && size <= Agent.LARGEST_SIZE && farthest <= Agent.LARGEST_COORDINATE)) {
			throw new RangeError(`${this.agent} can't be of size ${size} at (${x}, ${y}, ${z}), as its object demands: see Agent's limits`);
		}
	}

	#error(why) {
		return new ArgumentError(`${this.agent} can't be as its object is: ${why}`);
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
	const { up, modelUp } = optionsOf("bindInstance", options, { modelUp: undefined });
	if (!mesh?.isInstancedMesh) throw new ArgumentError(`bindInstance: mesh must be an InstancedMesh, not ${textOf(mesh)}: it comes after the agent, before the index`);
	return new ThreeAgentBinding(agent, mesh, model, { up, modelUp, index: index ?? NaN });
}

/** The position, quaternion and scale of an object. If three.js does not use these for it, its matrix is read. */
class ObjectTransform {
	constructor(agent, object, model) {
		this.object = object;
		this.snapshotInto(snapshot);
		warnings?.ofScale(agent, object);
		warnings?.ofInstances(agent, object, model);
	}

	/** The object's matrix, which is computed from its components unless it is set itself. */
	get matrix() {
		return this.object.matrix;
	}

	/** Writes the numbers of the transform into an array. Returns how many there are. Throws if three.js would turn the object around a pivot. */
	snapshotInto(out) {
		const { name, pivot, matrixAutoUpdate, matrix, position, quaternion, scale } = this.object;
		if (pivot) throw new ArgumentError(`ThreeAgentBinding: object "${name}" must have no pivot: put it into a Group, and bind the group`);
		if (!matrixAutoUpdate) {
			matrix.toArray(out);
			return 16;
		}
		position.toArray(out, 0);
		quaternion.toArray(out, 3);
		scale.toArray(out, 7);
		return 10;
	}

	/** Writes the position, the quaternion and the scale. Returns whether these describe the transform completely. */
	decomposeInto(out) {
		const { object } = this;
		if (!object.matrixAutoUpdate) return decompose(object.matrix, out);
		out.position.copy(object.position);
		out.quaternion.copy(object.quaternion);
		out.scale.copy(object.scale);
		return true;
	}

	compose(position, quaternion, factor) {
		const { object } = this;
		object.position.copy(position);
		object.scale.set(factor, factor, factor);
		// three.js computes Euler angles on each change
		if (!object.quaternion.equals(quaternion)) object.quaternion.copy(quaternion);
		if (!object.matrixAutoUpdate) object.updateMatrix();
	}
}

/** The matrix of an instance of an InstancedMesh, with the members of an ObjectTransform. */
class InstanceTransform {
	constructor(mesh, index, model) {
		if (!mesh.isInstancedMesh) throw new ArgumentError(`ThreeAgentBinding: object must be an InstancedMesh, not ${textOf(mesh)}`);
		const { count } = mesh.instanceMatrix;
		if (!(Number.isInteger(index) && index >= 0 && index < count)) throw new RangeError(`the mesh has instances 0 to ${count - 1}, not ${textOf(index)}`);
		if (conversionOf(model)?.indices.has(mesh)) throw new ArgumentError(`model "${model.name}" was made of all instances: an instance has a model of the mesh's geometry`);
		this.object = mesh;
		this.index = index;
	}

	/** The instance's matrix. The next call overwrites it. */
	get matrix() {
		this.object.getMatrixAt(this.index, given);
		return given;
	}

	snapshotInto(out) {
		const { array } = this.object.instanceMatrix;
		const first = 16 * this.index;
		for (let i = 0; i < 16; i++) out[i] = array[first + i];
		return 16;
	}

	decomposeInto(out) {
		return decompose(this.matrix, out);
	}

	compose(position, quaternion, factor) {
		const { object: mesh } = this;
		mesh.setMatrixAt(this.index, composed.compose(position, quaternion, offset.setScalar(factor)));
		mesh.instanceMatrix.needsUpdate = true;
		// The bounding volumes would stay where the instances were, and three.js does not draw what they show off the screen.
		mesh.boundingSphere = null;
		mesh.boundingBox = null;
	}
}

/** Decomposes a matrix. Returns whether it is a similarity: a turn, a move and a uniform scale, which then describe it completely. */
function decompose(matrix, { position, quaternion, scale }) {
	matrix.decompose(position, quaternion, scale);
	composed.compose(position, quaternion, scale);
	return isUniform(scale) && areAlike(matrix.elements, composed.elements, TOLERANCE * scale.x);
}

/** Whether the elements of two matrices differ by at most so much, those for the position aside. False for NaN. */
function areAlike(elements, others, tolerance) {
	for (let i = 0; i < 12; i++) if (!(Math.abs(elements[i] - others[i]) <= tolerance)) return false;
	return Math.abs(elements[15] - others[15]) <= tolerance;
}

/** Whether a scale is positive, finite and the same in x, y and z. False for NaN. */
const isUniform = ({ x, y, z }) => x > 0 && x < Infinity && Math.abs(y - x) <= TOLERANCE * x && Math.abs(z - x) <= TOLERANCE * x;
