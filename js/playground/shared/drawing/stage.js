/**
 * A world drawn with three.js: z up, with lights, agents, marks, signs and wireframes. It is drawn when something has changed. Without WebGL
 * it shows a message and draws nothing. Lab and LandStage add cameras of their own.
 */
import { AmbientLight, DirectionalLight, Group, Matrix4, PerspectiveCamera, Plane, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { ThreeWireframe } from "starlogo-collision/three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { h, isDark, onThemeChange } from "../dom.js";
import { Marks } from "./marks.js";
import { Signs } from "./signs.js";
import { Agents } from "./paint.js";
import { texts } from "../language.js";

export class Stage {
	#wireframes = new Map();
	#colours = new Map();
	/** The browser's request for the next drawing; 0 if nothing has changed. */
	#wanted = 0;
	#width = 1;
	#height = 1;
	/** Called after each drawing. */
	onDrawn = () => {};

	/**
	 * The camera turns about a target if the user drags. With isTurnable false the view moves it by lookFrom.
	 *
	 * @param {HTMLElement} host contains the stage
	 * @param {{label: string, eye: number[], target?: number[], backdrop: (scene: object) => object, fov?: number, near?: number, isTurnable?: boolean,
	 * powerPreference?: string}} view its label, the camera's place and target, and what makes the backdrop; the angle of the camera in degrees, 0
	 * for one that depends on the shape of the window
	 */
	constructor(host, { label, eye, target = [0, 0, 0], backdrop, fov = 0, near = 0.05, isTurnable = true, powerPreference = "low-power" }) {
		this.host = host;
		this.fov = fov;
		try {
			this.renderer = new WebGLRenderer({ antialias: !isDrawnSlowly(), powerPreference });
		} catch {
			this.renderer = null;
			host.append(h("p.notice", { role: "status" }, texts.noWebGL));
			return;
		}
		this.scene = new Scene();
		this.camera = new PerspectiveCamera(40, 1, near, 1000);
		this.camera.up.set(0, 0, 1);
		this.camera.position.set(...eye);
		this.canvas = this.renderer.domElement;
		this.canvas.setAttribute("role", "img");
		this.canvas.setAttribute("aria-label", label);
		host.append(this.canvas);
		sayIfLost(this);
		this.controls = new OrbitControls(this.camera, this.canvas);
		this.controls.enabled = isTurnable;
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
		this.backdrop = backdrop(this.scene);
		this.controls.update();
		this.applyTheme();
		this.resize(host.clientWidth || 1, host.clientHeight || 1);
		// an observer calls once at the beginning too
		this.observer = new ResizeObserver(() => this.#fit());
		this.observer.observe(host);
		this.forgetTheme = onThemeChange(() => this.applyTheme());
	}

	/** Gives everything its colours for light or dark. */
	applyTheme() {
		for (const wireframe of this.#wireframes.values()) this.#tint(wireframe);
		const { ambient, sun, ink } = this.backdrop.applyTheme(themeOfPage());
		this.ambient.intensity = ambient;
		this.sun.intensity = sun;
		this.agents.outline(ink);
		this.redraw();
	}

	#fit() {
		const { clientWidth: width, clientHeight: height } = this.host;
		if (width === 0 || height === 0) return;
		this.resize(width, height);
		this.adapt();
		this.draw();
	}

	/** Called when the picture has another shape, before it is drawn: the camera may move. */
	adapt() {}

	/** Gives the picture a size in pixels, and the camera its angle. */
	resize(width, height, ratio = Math.min(devicePixelRatio, isDrawnSlowly() ? 1 : 2)) {
		this.renderer.setPixelRatio(ratio);
		this.renderer.setSize(width, height);
		// asking the host in every frame would cause a layout of the page in every frame
		[this.#width, this.#height] = [width, height];
		this.camera.aspect = width / height;
		// a window that is higher than wide shows as much from side to side as a square one
		this.camera.fov = this.fov || (360 / Math.PI) * Math.atan(Math.tan(Math.PI / 9) / Math.min(1, this.camera.aspect));
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
		this.onDrawn();
	}

	/** The place of a point in pixels from the host's corner, and whether it is in sight. */
	pixelOf(x, y, z) {
		const { x: across, y: up, z: depth } = new Vector3(x, y, z).project(this.camera);
		return { x: ((across + 1) / 2) * this.#width, y: ((1 - up) / 2) * this.#height, isSeen: depth < 1 && Math.abs(across) < 1 && Math.abs(up) < 1.05 };
	}

	/** Draws now from a place, with a target in the middle. */
	lookFrom(place, target) {
		this.camera.position.copy(place);
		this.camera.lookAt(target.x, target.y, target.z);
		this.draw();
	}

	/** The ray from the eye through the pointer. */
	rayAt(event) {
		return this.#ray(event).ray;
	}

	/** Shows exactly these agents, each in its colour. glow gives the brightness of an agent's flash, from 0 to 1. */
	showAgents(agents, models, glow = () => 0) {
		if (!this.renderer) return;
		this.agents.show(agents, models, glow);
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
		wireframe.material.color.set(typeof colour === "number" ? colour : colour[themeOfPage()]);
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

	close() {
		if (!this.renderer) return;
		cancelAnimationFrame(this.#wanted);
		this.observer.disconnect();
		this.forgetTheme();
		this.controls.dispose();
		this.agents.dispose();
		this.backdrop.dispose();
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
const themeOfPage = () => (isDark() ? "dark" : "light");
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
