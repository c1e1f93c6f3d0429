/** The world of a running measurement: every agent as a box of its colour. One draw call draws 20,000 of them. */
import { BoxGeometry, DynamicDrawUsage, InstancedBufferAttribute, InstancedMesh, MeshLambertMaterial } from "three";
import { grid } from "../shared/drawing/backdrop.js";
import { Stage } from "../shared/drawing/stage.js";

/** The width of the drawn ground, whatever the width of the game's. */
const GROUND = 100;

export class Crowd {
	#mesh = null;

	/**
	 * @param {HTMLElement} host contains the picture
	 * @param {string} label
	 */
	constructor(host, label) {
		this.stage = new Stage(host, { label, eye: [0, -49, 154], backdrop: grid(GROUND, 5) });
	}

	/** Makes room for a number of agents. */
	prepare(count) {
		this.#forget();
		if (!this.stage.renderer) return;
		this.#mesh = new InstancedMesh(new BoxGeometry(1, 0.6, 0.7).translate(0, 0, 0.35), new MeshLambertMaterial(), count);
		this.#mesh.frustumCulled = false;
		this.#mesh.instanceMatrix.setUsage(DynamicDrawUsage);
		this.#mesh.instanceColor = new InstancedBufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
		this.stage.scene.add(this.#mesh);
	}

	/**
	 * Draws the agents at their places.
	 *
	 * @param {object[]} agents
	 * @param {number} scale the drawn width of one unit
	 * @param {number[]} touching for an agent that touches, and for one that does not: red, green and blue, from 0 to 1
	 * @param {(agent: object) => boolean} isTouching
	 */
	draw(agents, scale, [hit, free], isTouching) {
		const mesh = this.#mesh;
		if (!mesh) return;
		const { array: places } = mesh.instanceMatrix;
		const { array: colours } = mesh.instanceColor;
		agents.forEach((agent, i) => {
			const size = scale * agent.size;
			const angle = (agent.heading * Math.PI) / 180;
			const [along, aside] = [size * Math.cos(angle), size * Math.sin(angle)];
			const at = 16 * i;
			places[at] = along;
			places[at + 1] = aside;
			places[at + 4] = -aside;
			places[at + 5] = along;
			places[at + 10] = size;
			places[at + 12] = scale * agent.x;
			places[at + 13] = scale * agent.y;
			places[at + 15] = 1;
			const colour = isTouching(agent) ? hit : free;
			colours[3 * i] = colour[0];
			colours[3 * i + 1] = colour[1];
			colours[3 * i + 2] = colour[2];
		});
		mesh.instanceMatrix.needsUpdate = mesh.instanceColor.needsUpdate = true;
		this.stage.draw();
	}

	#forget() {
		if (!this.#mesh) return;
		this.#mesh.removeFromParent();
		this.#mesh.geometry.dispose();
		this.#mesh.material.dispose();
		this.#mesh.dispose();
		this.#mesh = null;
	}

	close() {
		this.#forget();
		this.stage.close();
	}
}

export const DRAWN = GROUND;
