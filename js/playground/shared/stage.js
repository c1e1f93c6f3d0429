/**
 * A world drawn with three.js: z up, with orbit and zoom. It is drawn when something has changed. Without WebGL it shows a message and
 * draws nothing.
 *
 * This file is long because a stage has few fields, and the code for its camera, its contents and the pointer needs most of them.
 */
import { AmbientLight, Color, DirectionalLight, GridHelper, Group, Matrix4, PerspectiveCamera, Plane, Raycaster, Scene, TOUCH, Vector2, Vector3, WebGLRenderer } from "three";
import { ThreeWireframe } from "starlogo-collision/three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { h, isDark, onThemeChange } from "./dom.js";
import { fit, look } from "./fit.js";
import { Marks } from "./marks.js";
import { Signs } from "./signs.js";
import { GROUNDS } from "./colours.js";
import { Agents } from "./paint.js";
import { texts } from "./language.js";

const THEMES = {
	light: { sky: 0xeef1f6, outside: 0xa9d2f2, grid: 0xc9d1de, middle: 0xaab5c6, ambient: 1.5, sun: 2.2 },
	dark: { sky: 0x171b22, outside: 0x46618a, grid: 0x2c3440, middle: 0x46515f, ambient: 1.1, sun: 2.2 },
};

const STEEPEST = (40 * Math.PI) / 180;

export class Stage {
	/** Whether the camera has been turned or moved since it has shown all. */
	isTouched = false;
	#wireframes = new Map();
	#colours = new Map();
	#wanted = 0;
	#grid = null;
	#width = 1;
	#height = 1;
	#land = "meadow";

	/**
	 * @param {HTMLElement} host contains the stage
	 * @param {{label: string, eye: number[], target?: number[], ground?: number, cell?: number, Land?: typeof import("../play/land.js").Land, fov?: number}} view
	 * its label, the direction of the camera, the width of the ground and of its cells, and the class of the surroundings, if there are any; the
	 * camera is so far away that everything fits. With fov, the angle of the camera in degrees, the view moves it by lookFrom
	 */
	constructor(host, { label, eye, target = [0, 0, 0], ground = 0, cell = 1, Land = null, fov = 0 }) {
		this.host = host;
		this.fov = fov;
		this.ground = ground;
		this.cell = cell;
		try {
			this.renderer = new WebGLRenderer({ antialias: !isDrawnSlowly(), powerPreference: Land ? "high-performance" : "low-power" });
		} catch {
			this.renderer = null;
			host.append(h("p.notice", { role: "status" }, texts.noWebGL));
			return;
		}
		this.scene = new Scene();
		this.camera = new PerspectiveCamera(40, 1, Land ? 0.1 : 0.05, 1000);
		this.camera.up.set(0, 0, 1);
		this.camera.position.set(...eye);
		this.canvas = this.renderer.domElement;
		this.canvas.setAttribute("role", "img");
		this.canvas.setAttribute("aria-label", label);
		host.append(this.canvas);
		sayIfLost(this);
		this.controls = new OrbitControls(this.camera, this.canvas);
		this.controls.enabled = !fov;
		this.controls.target.set(...target);
		this.controls.maxPolarAngle = Math.PI * 0.55;
		this.controls.addEventListener("change", () => this.redraw());
		this.ambient = new AmbientLight(0xffffff, 1);
		this.sun = new DirectionalLight(0xffffff, 1);
		this.sun.position.set(4, -6, 9);
		this.actors = new Group();
		this.agents = new Agents(this.actors);
		this.scene.add(this.ambient, this.sun, this.actors);
		this.marks = new Marks(this.scene);
		this.signs = new Signs(this.scene);
		if (Land) this.#makeLand(Land);
		this.controls.update();
		this.observer = new ResizeObserver(() => this.#fit());
		this.observer.observe(host);
		this.forgetTheme = onThemeChange(() => this.#dress());
		this.#dress();
		this.#fit();
	}

	#makeLand(Land) {
		const { controls } = this;
		this.land = new Land(this.scene, this.ground, this.cell);
		this.home = { from: this.camera.position.clone().sub(controls.target), target: controls.target.clone() };
		// not through the ground, and not too far away
		controls.maxPolarAngle = Math.PI * 0.485;
		controls.minDistance = 1.5;
		controls.maxDistance = 3 * this.ground;
		controls.addEventListener("start", () => {
			this.isTouched = true;
		});
		controls.addEventListener("change", () => {
			const half = this.ground / 2;
			const { target } = controls;
			const kept = target.clone().clamp(new Vector3(-half, -half, 0), new Vector3(half, half, 6));
			if (kept.equals(target)) return;
			this.camera.position.add(kept).sub(target);
			target.copy(kept);
		});
		// one finger scrolls the page up and down, and turns the world sideways
		controls.touches.ONE = TOUCH.ROTATE;
		this.canvas.style.touchAction = "pan-y";
	}

	/** Sets the ground: a name in GROUNDS. */
	setGround(name) {
		if (!this.land || this.#land === name) return;
		this.#land = name;
		this.#dress();
	}

	/** Shows the heights of the ground; null for a flat one. */
	showTerrain(terrain) {
		if (this.land?.showTerrain(terrain)) this.redraw();
	}

	#dress() {
		for (const wireframe of this.#wireframes.values()) this.#tint(wireframe);
		const name = isDark() ? "dark" : "light";
		const theme = this.land ? GROUNDS[this.#land][name] : THEMES[name];
		this.ambient.intensity = theme.ambient;
		this.sun.intensity = theme.sun;
		if (this.land) {
			this.land.dress(theme);
			this.agents.outline(theme.ink);
			this.redraw();
			return;
		}
		this.scene.background = new Color(this.fov ? theme.outside : theme.sky);
		if (this.#grid) {
			this.scene.remove(this.#grid);
			this.#grid.dispose();
		}
		if (this.ground > 0) {
			this.#grid = new GridHelper(this.ground, this.ground / this.cell, theme.middle, theme.grid);
			this.#grid.rotation.x = Math.PI / 2;
			this.scene.add(this.#grid);
		}
		this.redraw();
	}

	#fit() {
		const { clientWidth: width, clientHeight: height } = this.host;
		if (width === 0 || height === 0) return;
		this.#resize(width, height);
		if (this.land && !this.isTouched) this.showAll();
		this.draw();
	}

	#resize(width, height, ratio = Math.min(devicePixelRatio, isDrawnSlowly() ? 1 : 2)) {
		this.renderer.setPixelRatio(ratio);
		this.renderer.setSize(width, height);
		// asking the host in every frame would cause a layout of the page in every frame
		[this.#width, this.#height] = [width, height];
		this.camera.aspect = width / height;
		// a window that is higher than wide shows as much from side to side as a square one
		this.camera.fov = this.fov || (this.land ? 55 : (360 / Math.PI) * Math.atan(Math.tan(Math.PI / 9) / Math.min(1, this.camera.aspect)));
		this.camera.updateProjectionMatrix();
	}

	/** Draws once, in the browser's next frame. */
	redraw() {
		if (this.renderer && this.#wanted === 0) this.#wanted = requestAnimationFrame(() => this.draw());
	}

	/** Draws now. */
	draw() {
		if (!this.renderer) return;
		cancelAnimationFrame(this.#wanted);
		this.#wanted = 0;
		this.signs.face(this.camera, this.#height);
		this.renderer.render(this.scene, this.camera);
		this.onDrawn?.();
	}

	/**
	 * Shows the whole ground, or a part of it, from the side of the first view.
	 *
	 * @param {number[]|null} part the bounds in x, y and z; null for the ground; without it, the same part as before
	 */
	showAll(part = this.home?.part ?? null) {
		if (!this.renderer) return;
		this.isTouched = false;
		this.home.part = part;
		const border = this.ground / 2;
		const [x, y, z, endX, endY, endZ] = part ?? [-border, -border, 0, border, border, 1.5];
		const target = part ? new Vector3((x + endX) / 2, (y + endY) / 2, (z + endZ) / 2) : this.home.target.clone();
		// the narrower the window and the flatter the part, the more from above
		const isFlat = part !== null && 2 * (endZ - z) < endX - x;
		const steepness = isFlat ? 1 : Math.min(1, Math.max(0, (1.3 - this.camera.aspect) / 0.4));
		const from = this.home.from.clone().multiply(new Vector3(1, 1, 1 + 1.2 * steepness));
		// seen from higher, standing agents would seem to lie
		from.z = Math.min(from.z, Math.hypot(from.x, from.y) * Math.tan(STEEPEST));
		const corners = [[x, y, z], [endX, y, z], [endX, endY, endZ], [x, endY, endZ]];
		if (part) corners.push([x, y, endZ], [endX, y, endZ]);
		const distance = fit(this.camera, from, target, corners, this.controls.maxDistance);
		this.#lookFrom(from.setLength(distance), target);
		this.controls.update();
		this.redraw();
	}

	#lookFrom(offset, target) {
		this.controls.target.copy(target);
		look(this.camera, offset, target);
	}

	#seen(place) {
		return new Vector3(...place).project(this.camera);
	}

	/** The place of a point in pixels from the host's corner, and whether it is in sight. */
	pixelOf(x, y, z) {
		const { x: across, y: up, z: depth } = this.#seen([x, y, z]);
		return { x: ((across + 1) / 2) * this.#width, y: ((1 - up) / 2) * this.#height, isSeen: depth < 1 && Math.abs(across) < 1 && Math.abs(up) < 1.05 };
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

	/** Draws now from a place, with a target in the middle. */
	lookFrom(place, target) {
		this.camera.position.copy(place);
		this.camera.lookAt(target.x, target.y, target.z);
		this.draw();
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

	/** The ray from the eye through the pointer. */
	rayAt(event) {
		return this.#ray(event).ray;
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
		this.isTouched = true;
		const { target } = this.controls;
		const from = this.camera.position.clone().sub(target).multiplyScalar(zoom);
		const distance = from.length();
		const azimuth = Math.atan2(from.y, from.x) + around;
		const height = Math.min(1.5, Math.max(-0.1, Math.asin(from.z / distance) + up));
		this.camera.position.set(Math.cos(azimuth) * Math.cos(height), Math.sin(azimuth) * Math.cos(height), Math.sin(height)).multiplyScalar(distance).add(target);
		this.controls.update();
		this.redraw();
	}

	/** Shows exactly these agents, each in its colour. glow gives the brightness of an agent's flash, from 0 to 1. */
	showAgents(agents, models, glow = () => 0) {
		if (!this.renderer) return;
		this.agents.show(agents, models, glow);
		this.land?.showShadows(agents, models);
		this.redraw();
	}

	/** Shows the places of meetings, each with an age from 0 to 1 and a colour. */
	showMarks(hits, solids) {
		if (!this.renderer) return;
		for (const { point, age, color } of hits) this.marks.addHit(point, age, color, this.camera.quaternion);
		for (const { agent, structures, color } of solids) {
			// a sphere in the world has no agent
			const world = agent ? placement.fromArray(agent.transform.rawData) : placement.identity();
			for (const structure of structures) this.marks.addSolid(structure, world, color);
		}
		this.marks.finish();
		this.redraw();
	}

	/** Shows signs, each of a kind and at a place. */
	showSigns(signs) {
		this.signs?.show(signs);
		this.redraw();
	}

	/**
	 * The wireframe with a name, empty at first. If it is on top, nothing hides it. Its colour is a number, or one for day and one for night.
	 */
	wireframe(name, { color, opacity = 1, isOnTop = false }) {
		if (!this.#wireframes.has(name)) {
			const made = new ThreeWireframe({ up: "z" });
			// later ones are drawn over earlier ones
			made.renderOrder = isOnTop ? 1 : 0;
			this.#wireframes.set(name, made);
			this.scene?.add(made);
		}
		const wireframe = this.#wireframes.get(name);
		this.#colours.set(wireframe, color);
		this.#tint(wireframe);
		Object.assign(wireframe.material, { opacity, transparent: opacity < 1, depthTest: !isOnTop });
		this.redraw();
		return wireframe.clearLines();
	}

	#tint(wireframe) {
		const colour = this.#colours.get(wireframe);
		wireframe.material.color.set(typeof colour === "number" ? colour : colour[isDark() ? "dark" : "light"]);
	}

	/** Empties the wireframes with these names. */
	clearLines(...names) {
		for (const name of names) this.#wireframes.get(name)?.clearLines();
		this.redraw();
	}

	/** The agent under the pointer, or null. */
	agentAt(event) {
		return this.renderer ? this.agents.meets(this.#ray(event)) : null;
	}

	/** The point where the pointer's ray meets a level plane, or null. */
	pointAt(event, height) {
		return this.#ray(event).ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -height), new Vector3());
	}

	#ray(event) {
		const box = this.canvas.getBoundingClientRect();
		const caster = new Raycaster();
		caster.setFromCamera(new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2), this.camera);
		return caster;
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
		const { camera, controls, home, renderer } = this;
		const [position, target, isTouched, shown] = [camera.position.clone(), controls.target.clone(), this.isTouched, home.part];
		this.#resize(width, height, 1);
		look();
		this.draw();
		const canvas = h("canvas", { width, height });
		canvas.getContext("2d").drawImage(renderer.domElement, 0, 0);
		this.isTouched = isTouched;
		home.part = shown;
		this.#resize(this.host.clientWidth, this.host.clientHeight);
		this.#lookFrom(position.sub(target), target);
		return canvas.toDataURL("image/jpeg", 0.75);
	}

	close() {
		if (!this.renderer) return;
		cancelAnimationFrame(this.#wanted);
		this.observer.disconnect();
		this.forgetTheme();
		this.controls.dispose();
		this.agents.dispose();
		this.land?.dispose();
		this.marks.dispose();
		this.signs.dispose();
		for (const wireframe of this.#wireframes.values()) wireframe.dispose();
		this.renderer.dispose();
		this.canvas.remove();
	}
}

/** Shows a message if the browser loses the graphics card, and draws again when it is back. */
function sayIfLost(stage) {
	const note = h("p.notice.lost", { role: "alert" }, texts.lostWebGL);
	stage.canvas.addEventListener("webglcontextlost", (event) => {
		// otherwise it does not come back
		event.preventDefault();
		stage.host.append(note);
	});
	stage.canvas.addEventListener("webglcontextrestored", () => {
		note.remove();
		stage.redraw();
	});
}

const placement = new Matrix4();
let slowness = null;

/** Whether the processor draws. Smooth edges are then twice the work. */
function isDrawnSlowly() {
	if (slowness === null) {
		const probe = h("canvas").getContext("webgl2");
		const name = probe?.getParameter(probe.RENDERER) ?? "";
		// Chromium has it in another place, about which Firefox warns
		const names = /webkit/i.test(name) ? probe.getExtension("WEBGL_debug_renderer_info") : null;
		slowness = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(names ? probe.getParameter(names.UNMASKED_RENDERER_WEBGL) : name);
		probe?.getExtension("WEBGL_lose_context")?.loseContext();
	}
	return slowness;
}

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
