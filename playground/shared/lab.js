/** A stage for a closer look: what has no triangles is drawn as points. */
import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "three";
import { Stage } from "./stage.js";

const POINT_SIZE = 0.025;
const edges = new WeakMap();

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

/** The edges of a model's triangles as lines, each once. */
export function edgesOf(model) {
	if (!edges.has(model)) {
		const { vertices, triangles } = model;
		const lines = [];
		const known = new Set();
		triangles.forEach((from, i) => {
			const to = triangles[i % 3 === 2 ? i - 2 : i + 1];
			const key = Math.min(from, to) * vertices.length + Math.max(from, to);
			if (known.has(key)) return;
			known.add(key);
			for (const corner of [from, to]) lines.push(...vertices.slice(3 * corner, 3 * corner + 3));
		});
		edges.set(model, Float64Array.from(lines));
	}
	return edges.get(model);
}
