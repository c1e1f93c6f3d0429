/** A world drawn with three.js: z up, orbited and zoomed, drawn when something has changed. Without WebGL it says so, and draws nothing. */
import {
	AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, GridHelper, Group, Mesh,
	MeshLambertMaterial, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer, Plane,
} from "three";
import { ThreeAgentBinding, ThreeWireframe } from "starlogo-collision/three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { h, isDark, onThemeChange } from "./dom.js";
import { texts } from "../texts.js";

const THEMES = {
	light: { sky: 0xeef1f6, grid: 0xc9d1de, middle: 0xaab5c6, ambient: 1.5, sun: 2.2 },
	dark: { sky: 0x171b22, grid: 0x2c3440, middle: 0x46515f, ambient: 1.1, sun: 2.2 },
};

export class Stage {
	#geometries = new Map();
	#materials = new Map();
	#bindings = new Map();
	#lines = new Map();
	#wanted = 0;
	#grid = null;

	/**
	 * @param {HTMLElement} host what it fills
	 * @param {{label: string, eye: number[], target?: number[], ground?: number, cell?: number}} view what it is called, where it is seen from,
	 *     how wide the ground is and its cells are
	 */
	constructor(host, { label, eye, target = [0, 0, 0], ground = 0, cell = 1 }) {
		this.host = host;
		this.ground = ground;
		this.cell = cell;
		try {
			this.renderer = new WebGLRenderer({ antialias: true, powerPreference: "low-power" });
		} catch {
			this.renderer = null;
			host.append(h("p.notice", { role: "status" }, texts.noWebGL));
			return;
		}
		this.scene = new Scene();
		this.camera = new PerspectiveCamera(40, 1, 0.05, 500);
		this.camera.up.set(0, 0, 1);
		this.camera.position.set(...eye);
		this.canvas = this.renderer.domElement;
		this.canvas.setAttribute("role", "img");
		this.canvas.setAttribute("aria-label", label);
		host.append(this.canvas);
		sayIfLost(this);
		this.controls = new OrbitControls(this.camera, this.canvas);
		this.controls.target.set(...target);
		this.controls.maxPolarAngle = Math.PI * 0.55;
		this.controls.addEventListener("change", () => this.redraw());
		this.controls.update();
		this.ambient = new AmbientLight(0xffffff, 1);
		this.sun = new DirectionalLight(0xffffff, 1);
		this.sun.position.set(4, -6, 9);
		this.actors = new Group();
		this.scene.add(this.ambient, this.sun, this.actors);
		this.observer = new ResizeObserver(() => this.#fit());
		this.observer.observe(host);
		this.forgetTheme = onThemeChange(() => this.#dress());
		this.#dress();
		this.#fit();
	}

	#dress() {
		const theme = isDark() ? THEMES.dark : THEMES.light;
		this.scene.background = new Color(theme.sky);
		this.ambient.intensity = theme.ambient;
		this.sun.intensity = theme.sun;
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
		this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
		this.renderer.setSize(width, height);
		this.camera.aspect = width / height;
		this.camera.fov = width < height ? 55 : 40;
		this.camera.updateProjectionMatrix();
		this.draw();
	}

	/** Draws once, with the next frame of the browser. */
	redraw() {
		if (this.renderer && this.#wanted === 0) this.#wanted = requestAnimationFrame(() => this.draw());
	}

	/** Draws now. */
	draw() {
		if (!this.renderer) return;
		cancelAnimationFrame(this.#wanted);
		this.#wanted = 0;
		this.renderer.render(this.scene, this.camera);
	}

	/** The ray from the eye through the pointer. */
	rayAt(event) {
		return this.#ray(event).ray;
	}

	/** Moves the eye along its line of sight, so that a ball around the target fits. */
	frame(target, radius) {
		if (!this.renderer) return;
		const back = this.camera.position.clone().sub(this.controls.target).setLength(radius * (this.camera.aspect < 1 ? 3.4 : 3.1));
		this.controls.target.set(...target);
		this.camera.position.copy(this.controls.target).add(back);
		this.controls.update();
		this.redraw();
	}

	/** Turns the eye about the target, or moves it: for keys. */
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

	/** Shows exactly these agents, each in its colour. */
	showAgents(agents, models) {
		if (!this.renderer) return;
		const left = new Map(this.#bindings);
		for (const agent of agents) {
			let binding = left.get(agent);
			left.delete(agent);
			if (!binding) {
				binding = new ThreeAgentBinding(agent, new Mesh(), null, { up: "z" });
				binding.object.userData.agent = agent;
				this.#bindings.set(agent, binding);
				this.actors.add(binding.object);
			}
			binding.object.geometry = this.#geometryOf(models.get(agent.shape));
			binding.object.material = this.#materialOf(agent.color);
			binding.updateObject();
		}
		for (const [agent, { object }] of left) {
			this.actors.remove(object);
			this.#bindings.delete(agent);
		}
		this.redraw();
	}

	/** Shows lines under a name, in place of those that it had: x, y, z of one end, then of the other. */
	showLines(name, numbers, color) {
		if (!this.renderer) return;
		let wireframe = this.#lines.get(name);
		if (!wireframe) {
			wireframe = new ThreeWireframe({ up: "z" });
			this.#lines.set(name, wireframe);
			this.scene.add(wireframe);
		}
		wireframe.material.color.set(color);
		wireframe.clearLines().showLines(numbers);
		this.redraw();
	}

	/** Whom of the agents shown the pointer is on, or null. */
	agentAt(event) {
		if (!this.renderer) return null;
		return this.#ray(event).intersectObjects(this.actors.children, false)[0]?.object.userData.agent ?? null;
	}

	/** Where the pointer's ray meets a level plane, or null. */
	pointAt(event, height) {
		return this.#ray(event).ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -height), new Vector3());
	}

	#ray(event) {
		const box = this.canvas.getBoundingClientRect();
		const caster = new Raycaster();
		caster.setFromCamera(new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2), this.camera);
		return caster;
	}

	#geometryOf(model) {
		if (!this.#geometries.has(model)) {
			const indexed = new BufferGeometry();
			indexed.setAttribute("position", new BufferAttribute(Float32Array.from(model.vertices), 3));
			if (model.triangles) indexed.setIndex(new BufferAttribute(Uint32Array.from(model.triangles), 1));
			const flat = indexed.toNonIndexed();
			flat.computeVertexNormals();
			this.#geometries.set(model, flat);
		}
		return this.#geometries.get(model);
	}

	#materialOf(color) {
		if (!this.#materials.has(color)) this.#materials.set(color, new MeshLambertMaterial({ color, side: DoubleSide }));
		return this.#materials.get(color);
	}

	close() {
		if (!this.renderer) return;
		cancelAnimationFrame(this.#wanted);
		this.observer.disconnect();
		this.forgetTheme();
		this.controls.dispose();
		for (const geometry of this.#geometries.values()) geometry.dispose();
		for (const material of this.#materials.values()) material.dispose();
		for (const wireframe of this.#lines.values()) wireframe.dispose();
		this.renderer.dispose();
		this.canvas.remove();
	}
}

/** Says so, and draws again, when the browser takes the graphics card away and gives it back. */
function sayIfLost(stage) {
	const note = h("p.notice.lost", { role: "alert" }, texts.lostWebGL);
	stage.canvas.addEventListener("webglcontextlost", (event) => {
		// else it is not given back
		event.preventDefault();
		stage.host.append(note);
	});
	stage.canvas.addEventListener("webglcontextrestored", () => {
		note.remove();
		stage.redraw();
	});
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
