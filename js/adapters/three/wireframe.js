import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments, Matrix4, Vector3 } from "three";
import { ArgumentError, Wireframes } from "starlogo-collision";
import { optionsOf, requirePoint, textOf } from "./arguments.js";
import { AgentTransform, toSceneAxes } from "./axes.js";

const matrix = new Matrix4();
const scale = new Vector3();
const point = new Vector3();

/** Half the width of the cross at a point, in patches. */
const CROSS = 0.05;

/**
 * Draws structures, levels of hierarchies, contacts and rays as lines, all in one LineSegments. Its parent is the land. Lines that belong
 * to an agent move with it.
 */
export class ThreeWireframe extends LineSegments {
	#isYUp;
	// { transform, lines, first }: the agent's transform or null; six numbers for each line, z up; the first index in the attribute
	#parts = [];
	#count = 0;

	/**
	 * Creates a wireframe without lines.
	 *
	 * @param {{color?: number | string, up?: "y" | "z"}} options the lines' colour, and the up axis of the land
	 */
	constructor(options = {}) {
		const { color, isYUp } = optionsOf("ThreeWireframe", options, { color: 0xffcc00 });
		super(new BufferGeometry(), new LineBasicMaterial({ color }));
		this.#isYUp = isYUp;
		this.frustumCulled = false;
		this.clearLines();
	}

	/** Shows a structure. With an agent, it is in the space of the agent's model, as in a library. Without one, it is in the world. */
	showStructure(structure, agent = null) {
		return this.showLines(Wireframes.ofStructure(structure), agent);
	}

	/** Shows the structures that a collider reaches if it visits this many levels of a hierarchy. */
	showLevel(root, level, agent = null) {
		return this.showLines(Wireframes.ofLevel(root, level), agent);
	}

	/** Shows a contact: its point, its normal and its depth. */
	showContact(contact) {
		const { x, y, z } = requirePoint("ThreeWireframe.showContact", contact?.point);
		const { normal, depth } = contact;
		requirePoint("ThreeWireframe.showContact", normal);
		const lines = crossAt(x, y, z);
		lines.push(x, y, z, x + normal.x * depth, y + normal.y * depth, z + normal.z * depth);
		return this.showLines(lines);
	}

	/** Shows a ray up to its hit, with the normal there. Without a hit it is `reach` long. */
	showRay(origin, direction, reach = 1, hit = null) {
		const { x, y, z } = requirePoint("ThreeWireframe.showRay", origin);
		requirePoint("ThreeWireframe.showRay", direction);
		if (hit) requirePoint("ThreeWireframe.showRay", hit.normal);
		const length = Math.hypot(direction.x, direction.y, direction.z);
		if (!(length > 0 && length < Infinity)) {
			throw new ArgumentError(`the direction must be finite and not 0, not (${direction.x}, ${direction.y}, ${direction.z})`);
		}
		const far = (hit ? hit.distance : reach) / length;
		const end = [x + direction.x * far, y + direction.y * far, z + direction.z * far];
		const lines = [x, y, z, ...end];
		if (hit) {
			const { normal } = hit;
			lines.push(...crossAt(...end), ...end, end[0] + normal.x * 4 * CROSS, end[1] + normal.y * 4 * CROSS, end[2] + normal.z * 4 * CROSS);
		}
		return this.showLines(lines);
	}

	/**
	 * Shows lines, six numbers each, z up. With an agent, they are in the space of its model. Without one, they are in the world. They are
	 * copied.
	 */
	showLines(lines, agent = null) {
		if (typeof lines?.length !== "number") throw new ArgumentError(`ThreeWireframe.showLines: lines must be an array of numbers, not ${textOf(lines)}`);
		if (lines.length % 6 !== 0) throw new ArgumentError(`a line is six numbers: ${lines.length} are no lines`);
		for (let i = 0; i < lines.length; i++) if (!Number.isFinite(lines[i])) throw new ArgumentError(`a line is six finite numbers, not ${textOf(lines[i])}`);
		const part = { transform: agent === null ? null : new AgentTransform(agent, this.#isYUp, "ThreeWireframe"), lines: Float64Array.from(lines), first: this.#count };
		this.#parts.push(part);
		this.#count += lines.length / 3;
		this.#makeRoom();
		part.transform?.readIfChanged();
		this.#write(part);
		this.geometry.setDrawRange(0, this.#count);
		return this;
	}

	/** Removes all lines. */
	clearLines() {
		this.#parts = [];
		this.#count = 0;
		this.geometry.setDrawRange(0, 0);
		return this;
	}

	/** Moves the lines to their agents. If no agent has changed, it does nothing. */
	update() {
		for (const part of this.#parts) if (part.transform?.readIfChanged()) this.#write(part);
	}

	/** Takes over another wireframe's lines. Unlike those of three.js, the two share no geometry, because each moves its own lines. */
	copy(source, isRecursive) {
		this.geometry.dispose();
		super.copy(source, isRecursive);
		this.geometry = new BufferGeometry();
		this.#isYUp = source.#isYUp;
		const parts = source.#parts;
		this.clearLines();
		for (const { transform, lines } of parts) this.showLines(lines, transform?.agent);
		return this;
	}

	/** the pointer never hits lines */
	raycast() {}

	/** Frees the renderer's data. */
	dispose() {
		this.geometry.dispose();
		this.material.dispose();
	}

	// Twice as much as is needed, because an attribute cannot grow.
	#makeRoom() {
		if (this.#count <= (this.geometry.getAttribute("position")?.count ?? -1)) return;
		this.geometry.dispose();
		this.geometry = new BufferGeometry();
		this.geometry.setAttribute("position", new BufferAttribute(new Float32Array(6 * this.#count), 3));
		for (const part of this.#parts) this.#write(part);
	}

	#write({ transform, lines, first }) {
		const attribute = this.geometry.getAttribute("position");
		if (transform) matrix.compose(transform.position, transform.quaternion, scale.setScalar(transform.size));
		else matrix.identity();
		for (let i = 0; i < lines.length; i += 3) {
			toSceneAxes(point.fromArray(lines, i), this.#isYUp).applyMatrix4(matrix);
			attribute.setXYZ(first + i / 3, point.x, point.y, point.z);
		}
		attribute.needsUpdate = true;
	}
}

const crossAt = (x, y, z) => [x - CROSS, y, z, x + CROSS, y, z, x, y - CROSS, z, x, y + CROSS, z, x, y, z - CROSS, x, y, z + CROSS];
