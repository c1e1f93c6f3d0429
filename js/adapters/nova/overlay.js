import { CollisionLines } from "starlogo-collision";
import { Overrides } from "./overrides.js";

/** The line colours of agents that collide, and of agents that do not. */
const COLORS = [0xff2020, 0xffcc00];

/** A wireframe of the colliding shapes over the view of a window's client. It is hidden at first. */
export class Overlay {
	#window;
	#forEachShown;
	#lines;
	#view = null;

	/**
	 * @param window the client's
	 * @param greatLand has the models
	 * @param forEachShown calls a function for each agent at a fraction of its way since the last tick: with an Agent of the engine, the collider, and
	 * whether it collides
	 */
	constructor(window, greatLand, forEachShown) {
		this.#window = window;
		this.#forEachShown = forEachShown;
		this.#lines = new CollisionLines(greatLand);
	}

	/** Shows or hides it. */
	show(isOn) {
		if (isOn && this.#view === null) this.#view = new (viewClassOf(this.#window))(this.#window, (fraction) => this.#draw(fraction));
		if (!isOn && this.#view !== null) {
			this.#view.remove();
			this.#view = null;
		}
		// other things may have to be drawn too
		if (this.#window.viewport) this.#window.viewport.needsUpdate = true;
	}

	/** Draws the lines of each colour. `fraction` says where on their way since the last tick the agents are shown. */
	#draw(fraction) {
		const lists = COLORS.map(() => []);
		this.#forEachShown(fraction, (agent, collider, isHit) => this.#lines.linesOf(agent, collider, lists[isHit ? 0 : 1]));
		return lists;
	}
}

/** The class that draws into a window's view. */
export function viewClassOf({ viewport, THREE }) {
	if (viewport?.scene && THREE) return SolidView;
	if (viewport?.drawScene && viewport.context) return FlatView;
	throw new TypeError("the client has no view that a wireframe can be drawn in");
}

/** Draws into the three.js view. */
class SolidView {
	#overrides = new Overrides();
	#scene;
	#three;
	#objects;

	constructor({ viewport, THREE }, draw) {
		this.#scene = viewport.scene;
		this.#three = THREE;
		this.#objects = COLORS.map((color) => {
			// lines inside a model or under the ground must be visible too
			const object = new THREE.LineSegments(geometryOf(THREE, 0), new THREE.LineBasicMaterial({ color, depthTest: false, transparent: true }));
			object.frustumCulled = false;
			this.#scene.add(object);
			return object;
		});
		this.#overrides.apply(viewport, "render", (render) => (fraction, ...others) => {
			if (viewport.needsUpdate || viewport.terrain?.needsUpdate) draw(fraction ?? 1).forEach((lines, i) => this.#write(this.#objects[i], lines));
			return render.call(viewport, fraction, ...others);
		});
	}

	remove() {
		this.#overrides.restore();
		for (const object of this.#objects) {
			this.#scene.remove(object);
			object.geometry.dispose();
			object.material.dispose();
		}
	}

	#write(object, lines) {
		if (lines.length > object.geometry.attributes.position.array.length) {
			object.geometry.dispose();
			object.geometry = geometryOf(this.#three, 2 * lines.length);
		}
		const { position } = object.geometry.attributes;
		position.array.set(lines);
		position.needsUpdate = true;
		object.geometry.setDrawRange(0, lines.length / 3);
		object.visible = lines.length > 0;
	}
}

/** A geometry with room for this many numbers. */
function geometryOf({ BufferGeometry, BufferAttribute }, length) {
	const geometry = new BufferGeometry();
	geometry.addAttribute("position", new BufferAttribute(new Float32Array(length), 3));
	return geometry;
}

/** Draws into the two-dimensional view, which shows agents at their last places. */
class FlatView {
	#overrides = new Overrides();

	constructor({ viewport }, draw) {
		this.#overrides.apply(viewport, "drawScene", (drawScene) => (...given) => {
			const result = drawScene.apply(viewport, given);
			draw(1).forEach((lines, i) => strokeLines(viewport, lines, COLORS[i]));
			return result;
		});
	}

	remove() {
		this.#overrides.restore();
	}
}

function strokeLines({ context, camera }, lines, color) {
	context.save();
	context.strokeStyle = `#${color.toString(16).padStart(6, "0")}`;
	context.beginPath();
	for (let i = 0; i < lines.length; i += 6) {
		const [fromX, fromY, fromFar] = camera.projectPoint(lines[i], lines[i + 1], lines[i + 2]);
		const [toX, toY, toFar] = camera.projectPoint(lines[i + 3], lines[i + 4], lines[i + 5]);
		// points behind the camera have no place in the view
		if (!(Math.min(fromFar, toFar) > camera.nearDist)) continue;
		context.moveTo(fromX, fromY);
		context.lineTo(toX, toY);
	}
	context.stroke();
	context.restore();
}
