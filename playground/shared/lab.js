/** A stage for a closer look: what has no triangles is drawn as points. */
import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "three";
import { Stage } from "./stage.js";

const POINT_SIZE = 0.025;

export class Lab extends Stage {
	#clouds = [];

	showAgents(agents, models) {
		const isCloud = ({ shape }) => !models.get(shape).triangles;
		super.showAgents(agents.filter((agent) => !isCloud(agent)), models);
		this.#forgetClouds();
		for (const agent of agents.filter(isCloud)) {
			const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(Float32Array.from(models.get(agent.shape).vertices), 3));
			this.#clouds.push(new Points(geometry, new PointsMaterial({ color: agent.color, size: POINT_SIZE })));
			const cloud = this.#clouds.at(-1);
			cloud.matrixAutoUpdate = false;
			cloud.matrix.fromArray(agent.transform.rawData);
			this.scene?.add(cloud);
		}
	}

	#forgetClouds() {
		for (const cloud of this.#clouds.splice(0)) {
			cloud.removeFromParent();
			cloud.geometry.dispose();
			cloud.material.dispose();
		}
	}

	close() {
		this.#forgetClouds();
		super.close();
	}
}
