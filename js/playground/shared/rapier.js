/**
 * Rapier beside the engine. Its agents are sensors on kinematic bodies, so nothing is pushed. Each has the structure that is the tightest
 * fit of its model. This part is 2 MB of WebAssembly, so it loads only when it is asked for.
 */
import * as RAPIER from "@dimforge/rapier3d-compat";
import { Box, Capsule } from "starlogo-collision";
import { Matrix4, Quaternion, Vector3 } from "three";

const UP = new Vector3(0, 1, 0);
const vector = ({ x, y, z }) => new Vector3(x, y, z);

/** The structure of an agent, as Rapier has it: its capsules are along y, and its boxes along the axes. */
function shapeOf(structure, size) {
	if (structure instanceof Capsule) {
		const [start, end] = [vector(structure.start).multiplyScalar(size), vector(structure.end).multiplyScalar(size)];
		const along = end.clone().sub(start);
		const shape = RAPIER.ColliderDesc.capsule(along.length() / 2, structure.radius * size);
		return placed(shape, start.add(end).multiplyScalar(0.5), new Quaternion().setFromUnitVectors(UP, along.normalize()));
	}
	const centre = vector(structure.center).multiplyScalar(size);
	if (!(structure instanceof Box)) return placed(RAPIER.ColliderDesc.ball(structure.radius * size), centre, new Quaternion());
	const { halfX, halfY, halfZ } = structure;
	const [first, second] = [vector(structure.axisX), vector(structure.axisY)];
	const turn = new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(first, second, first.clone().cross(second)));
	return placed(RAPIER.ColliderDesc.cuboid(halfX * size, halfY * size, halfZ * size), centre, turn);
}

const placed = (shape, { x, y, z }, turn) => shape.setTranslation(x, y, z).setRotation({ x: turn.x, y: turn.y, z: turn.z, w: turn.w });

/** Waits for the WebAssembly. Throws where the browser has none. */
export const ready = () => RAPIER.init();

/** A world of Rapier with the same agents. */
export class RapierWorld {
	#world = new RAPIER.World({ x: 0, y: 0, z: 0 });

	/**
	 * @param {object} greatLand has the agents' models
	 * @param {object[]} agents
	 */
	constructor(greatLand, agents) {
		this.agents = agents;
		this.bodies = agents.map(({ shape, size, x, y, z }) => {
			const body = this.#world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(x, y, z));
			const form = shapeOf(greatLand.boundingStructures.tightestFit(shape), size);
			return { body, collider: this.#world.createCollider(form.setSensor(true).setActiveCollisionTypes(RAPIER.ActiveCollisionTypes.ALL), body) };
		});
	}

	/** Brings the bodies to the agents' places, does a step, and returns the number of pairs that touch: where they were before. */
	pairs() {
		this.agents.forEach(({ x, y, z, heading }, i) => {
			const { body } = this.bodies[i];
			const half = (heading * Math.PI) / 360;
			body.setTranslation({ x, y, z }, true);
			body.setRotation({ x: 0, y: 0, z: Math.sin(half), w: Math.cos(half) }, true);
		});
		return this.settled();
	}

	/** The number of pairs that touch where the bodies are. A step of Rapier's looks for pairs before it takes new places over, so this is one more. */
	settled() {
		this.#world.step();
		let touching = 0;
		for (const { collider } of this.bodies) this.#world.intersectionPairsWith(collider, () => touching++);
		return touching / 2;
	}

	close() {
		this.#world.free();
	}
}
