/** A stage for a closer look, whose camera keys turn too. It draws models without triangles as points, and the depth of an overlap as an arrow. */
import { BufferAttribute, BufferGeometry, ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Points, PointsMaterial, Quaternion, Vector3 } from "three";
import { VERDICTS } from "./colours.js";
import { h } from "../dom.js";
import { Stage } from "./stage.js";

const POINT_SIZE = 0.025;
const [SHAFT, HEAD] = [0.014, 0.09];
const UP = new Vector3(0, 0, 1);

export class Lab extends Stage {
	#clouds = [];
	#arrow = null;
	/** The place of its label. */
	#told = null;

	constructor(host, view) {
		super(host, view);
		this.label = h("p.bubble.measure", { hidden: true });
		host.append(this.label);
		this.onDrawn = () => this.#placeLabel();
	}

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

	/**
	 * Shows the depth of an overlap as an arrow from the contact's point. The shaft is as long as the depth, and the head shows the direction.
	 *
	 * @param {object|null} contact the engine's contact; nothing is shown for null
	 */
	showDepth(contact) {
		if (!this.renderer) return;
		if (this.#arrow) this.#arrow.visible = contact !== null;
		if (contact === null) return;
		this.#arrow ??= this.#makeArrow();
		const { point, normal, depth } = contact;
		const [shaft, head] = this.#arrow.children;
		shaft.scale.set(1, 1, Math.max(depth, 1e-6));
		head.position.z = depth;
		this.#arrow.position.set(point.x, point.y, point.z);
		this.#arrow.quaternion.copy(turn.setFromUnitVectors(UP, along.set(normal.x, normal.y, normal.z).normalize()));
	}

	#makeArrow() {
		const material = new MeshBasicMaterial({ color: VERDICTS.hit, depthTest: false, transparent: true });
		const shaft = new Mesh(new CylinderGeometry(SHAFT, SHAFT, 1, 10).rotateX(Math.PI / 2).translate(0, 0, 0.5), material);
		const head = new Mesh(new ConeGeometry(2.6 * SHAFT, HEAD, 14).rotateX(Math.PI / 2).translate(0, 0, HEAD / 2), material);
		const arrow = new Group().add(shaft, head);
		for (const mesh of arrow.children) mesh.renderOrder = 8;
		this.scene.add(arrow);
		return arrow;
	}

	/** Shows a measure at its place in the picture; an empty one is hidden. */
	tell(text, x = 0, y = 0, z = 0) {
		this.label.textContent = text;
		this.#told = text === "" ? null : [x, y, z];
		this.label.hidden = true;
		this.redraw();
	}

	#placeLabel() {
		const at = this.#told && this.pixelOf(...this.#told);
		this.label.hidden = !at?.isSeen;
		if (at?.isSeen) this.label.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px) translate(-50%, -160%)`;
	}

	/** Moves the camera along its line of sight, so that a ball around the target fits. */
	frame(target, radius) {
		if (!this.renderer) return;
		const back = this.camera.position.clone().sub(this.controls.target).setLength(radius * (this.camera.aspect < 1 ? 3.4 : 3.1));
		this.controls.target.set(...target);
		this.camera.position.copy(this.controls.target).add(back);
		this.controls.update();
		this.redraw();
	}

	/** Turns the camera about the target, or moves it: for keys. */
	orbit(around, up, zoom) {
		if (!this.renderer) return;
		const { target } = this.controls;
		const from = this.camera.position.clone().sub(target).multiplyScalar(zoom);
		const distance = from.length();
		const azimuth = Math.atan2(from.y, from.x) + around;
		const height = Math.min(1.5, Math.max(-0.1, Math.asin(from.z / distance) + up));
		this.camera.position.set(Math.cos(azimuth) * Math.cos(height), Math.sin(azimuth) * Math.cos(height), Math.sin(height)).multiplyScalar(distance).add(target);
		this.controls.update();
		this.redraw();
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
		for (const { geometry } of this.#arrow?.children ?? []) geometry.dispose();
		super.close();
	}
}

const turn = new Quaternion();
const along = new Vector3();

/** Lets keys turn and zoom a stage whose host has the focus. */
export function orbitByKeys(stage, host) {
	const TURN = Math.PI / 24;
	const KEYS = { ArrowLeft: [-TURN, 0, 1], ArrowRight: [TURN, 0, 1], ArrowUp: [0, TURN, 1], ArrowDown: [0, -TURN, 1], "+": [0, 0, 0.9], "=": [0, 0, 0.9], "-": [0, 0, 1 / 0.9] };
	host.addEventListener("keydown", (event) => {
		if (event.target !== host || !(event.key in KEYS)) return;
		stage.orbit(...KEYS[event.key]);
		event.preventDefault();
	});
}
