/** The stage of a game: a land, and a camera that shows the whole ground or a part of it, follows an agent, or is where the user puts it. */
import { TOUCH, Vector3 } from "three";
import { h } from "../../shared/dom.js";
import { fit, look } from "../../shared/drawing/fit.js";
import { Stage } from "../../shared/drawing/stage.js";
import { Land } from "./land.js";
import { HALF_WIDTH } from "../game/moves.js";

/** The place of the first camera. It looks at the middle of the ground. */
const EYE = [-3, -18.5, 8.7];
/** The angle of the camera, in degrees. */
const ANGLE = 55;
const STEEPEST = (40 * Math.PI) / 180;

/** The corners of the room in which the camera's target stays. */
const LOWEST = new Vector3(-HALF_WIDTH, -HALF_WIDTH, 0);
const HIGHEST = new Vector3(HALF_WIDTH, HALF_WIDTH, 6);

export class LandStage extends Stage {
	/** Whether the camera has been turned or moved since it has shown all. */
	isTouched = false;
	/** The bounds of what showAll has shown last; null for the whole ground. */
	#part = null;

	/**
	 * @param {HTMLElement} host contains the stage
	 * @param {string} label
	 */
	constructor(host, label) {
		super(host, { label, eye: EYE, fov: ANGLE, near: 0.1, powerPreference: "high-performance", backdrop: (scene) => new Land(scene, 2 * HALF_WIDTH) });
		if (!this.renderer) return;
		this.#limitCamera();
		this.showAll();
	}

	/** The surroundings; undefined if nothing can be drawn. */
	get land() {
		return this.backdrop;
	}

	#limitCamera() {
		const { controls } = this;
		// not through the ground, and not too far away
		controls.maxPolarAngle = Math.PI * 0.485;
		controls.minDistance = 1.5;
		controls.maxDistance = 6 * HALF_WIDTH;
		controls.addEventListener("start", () => {
			this.isTouched = true;
		});
		controls.addEventListener("change", () => {
			const { target } = controls;
			const kept = target.clone().clamp(LOWEST, HIGHEST);
			if (kept.equals(target)) return;
			this.camera.position.add(kept).sub(target);
			target.copy(kept);
		});
		// one finger scrolls the page up and down, and turns the world sideways
		controls.touches.ONE = TOUCH.ROTATE;
		this.canvas.style.touchAction = "pan-y";
	}

	adapt() {
		if (!this.isTouched) this.showAll();
	}

	/** Sets the ground: a name in GROUNDS. */
	setGround(name) {
		if (this.land?.setGround(name)) this.applyTheme();
	}

	/** Shows the heights of the ground; null for a flat one. */
	showTerrain(terrain) {
		if (this.land?.showTerrain(terrain)) this.redraw();
	}

	/** Shows exactly these agents, each in its colour and with a shadow. glow gives the brightness of an agent's flash, from 0 to 1. */
	showAgents(agents, models, glow) {
		super.showAgents(agents, models, glow);
		this.land?.showShadows(agents, models);
	}

	/**
	 * Shows the whole ground, or a part of it, from the side of the first view.
	 *
	 * @param {number[]|null} part the bounds in x, y and z; null for the ground; without it, the same part as before
	 */
	showAll(part = this.#part) {
		if (!this.renderer) return;
		this.isTouched = false;
		this.#part = part;
		const [x, y, z, endX, endY, endZ] = part ?? [-HALF_WIDTH, -HALF_WIDTH, 0, HALF_WIDTH, HALF_WIDTH, 1.5];
		const target = part ? new Vector3((x + endX) / 2, (y + endY) / 2, (z + endZ) / 2) : new Vector3();
		// the narrower the window and the flatter the part, the more from above
		const isFlat = part !== null && 2 * (endZ - z) < endX - x;
		const steepness = isFlat ? 1 : Math.min(1, Math.max(0, (1.3 - this.camera.aspect) / 0.4));
		const from = new Vector3(...EYE).multiply(new Vector3(1, 1, 1 + 1.2 * steepness));
		// seen from higher, standing agents would seem to lie
		from.z = Math.min(from.z, Math.hypot(from.x, from.y) * Math.tan(STEEPEST));
		const corners = [[x, y, z], [endX, y, z], [endX, endY, endZ], [x, endY, endZ]];
		if (part) corners.push([x, y, endZ], [endX, y, endZ]);
		const distance = fit(this.camera, from, target, corners, this.controls.maxDistance);
		this.#placeCamera(from.setLength(distance), target);
		this.controls.update();
		this.redraw();
	}

	#placeCamera(offset, target) {
		this.controls.target.copy(target);
		look(this.camera, offset, target);
	}

	/** Looks over an agent's shoulder, or through its eyes. */
	follow(agent, height, isThroughEyes) {
		if (!this.renderer) return;
		this.isTouched = true;
		const angle = (agent.heading * Math.PI) / 180;
		const ahead = new Vector3(Math.cos(angle), Math.sin(angle), 0);
		const at = new Vector3(agent.x, agent.y, agent.z);
		const { target } = this.controls;
		if (isThroughEyes) {
			this.camera.position.copy(at).addScaledVector(ahead, 0.55 * agent.size).setZ(agent.z + 0.85 * height);
			target.copy(this.camera.position).addScaledVector(ahead, 4).setZ(agent.z + 0.55 * height);
		} else {
			const back = Math.max(2.2, 2.6 * Math.max(height, agent.size));
			this.camera.position.copy(at).addScaledVector(ahead, -back).setZ(agent.z + 0.4 * height + 0.55 * back);
			target.copy(at).addScaledVector(ahead, back).setZ(agent.z + 0.35 * height);
		}
		this.camera.lookAt(target);
		this.redraw();
	}

	/** Copies the camera of another stage. */
	lookAs({ camera, controls }) {
		if (!this.renderer || !camera) return;
		this.isTouched = true;
		this.controls.target.copy(controls.target);
		this.camera.position.copy(camera.position);
		this.camera.quaternion.copy(camera.quaternion);
		this.redraw();
	}

	/**
	 * The address of a small picture; null if nothing can be drawn. The view does not change.
	 *
	 * @param {number} width in pixels
	 * @param {number} height in pixels
	 * @param {() => void} look points the camera
	 */
	picture(width, height, look) {
		if (!this.renderer) return null;
		const { camera, controls, renderer } = this;
		const [position, target, isTouched, shown] = [camera.position.clone(), controls.target.clone(), this.isTouched, this.#part];
		this.resize(width, height, 1);
		look();
		this.draw();
		const canvas = h("canvas", { width, height });
		canvas.getContext("2d").drawImage(renderer.domElement, 0, 0);
		this.isTouched = isTouched;
		this.#part = shown;
		this.resize(this.host.clientWidth, this.host.clientHeight);
		this.#placeCamera(position.sub(target), target);
		return canvas.toDataURL("image/jpeg", 0.75);
	}
}
