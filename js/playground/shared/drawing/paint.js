/** Draws agents: each shape once with all its agents as instances, with outlines, in the model's own colours or painted. */
import {
	BackSide, BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, InstancedBufferAttribute, InstancedMesh, MeshBasicMaterial, MeshLambertMaterial,
} from "three";
import { INK, OWN_COLOURS } from "./colours.js";

/** The colour of a model without colours of its own. */
const PLAIN = 0xa9b3c1;
/** The width of outlines: visible from far away, and not too wide from near. */
const OUTLINE = 0.0024;

/** Mixes an instance's paint into its colours: `paint` is a colour and its share. Light and dark parts stay light and dark. */
function takePaint(shader) {
	shader.vertexShader = shader.vertexShader.replace("#include <common>", "#include <common>\nattribute vec4 paint;\nvarying vec4 vPaint;")
		.replace("#include <begin_vertex>", "#include <begin_vertex>\nvPaint = paint;");
	shader.fragmentShader = shader.fragmentShader.replace("#include <common>", "#include <common>\nvarying vec4 vPaint;")
		.replace("#include <color_fragment>", "#include <color_fragment>\nfloat light = dot(diffuseColor.rgb, vec3(0.3, 0.6, 0.1));\ndiffuseColor.rgb = mix(diffuseColor.rgb, vPaint.rgb * (0.55 + 0.6 * sqrt(light)), vPaint.a);");
}

/** Makes a shape a little larger, in proportion to its distance. */
function swell(shader) {
	shader.vertexShader = shader.vertexShader.replace("#include <project_vertex>", `#include <project_vertex>
		vec3 outward = normalize((modelViewMatrix * instanceMatrix * vec4(normal, 0.0)).xyz);
		gl_Position = projectionMatrix * (mvPosition + vec4(outward * ${OUTLINE} * min(-mvPosition.z, 40.0), 0.0));`);
}

/** Gives a material with a changed shader its own key. */
function changed(material, name, change) {
	material.onBeforeCompile = change;
	material.customProgramCacheKey = () => name;
	return material;
}

/** All agents of one shape. */
class Shape {
	count = 0;
	agents = [];

	constructor(model, parent, materials) {
		this.model = model;
		this.parent = parent;
		this.materials = materials;
		this.geometry = geometryOf(model);
		this.#grow(8);
	}

	#grow(capacity) {
		this.#remove();
		this.capacity = capacity;
		this.paint = new InstancedBufferAttribute(new Float32Array(4 * capacity), 4).setUsage(DynamicDrawUsage);
		this.geometry.setAttribute("paint", this.paint);
		this.body = new InstancedMesh(this.geometry, this.materials.body, capacity);
		this.outline = new InstancedMesh(this.geometry, this.materials.outline, capacity);
		this.outline.instanceMatrix = this.body.instanceMatrix.setUsage(DynamicDrawUsage);
		for (const mesh of [this.body, this.outline]) {
			mesh.frustumCulled = false;
			mesh.userData.shape = this;
		}
		this.outline.raycast = () => {};
		this.parent.add(this.body, this.outline);
	}

	#remove() {
		for (const mesh of [this.body, this.outline]) {
			if (!mesh) continue;
			this.parent.remove(mesh);
			mesh.dispose();
		}
	}

	add(agent, glow) {
		if (this.count === this.capacity) {
			const { array } = this.body.instanceMatrix;
			const paint = this.paint.array;
			this.#grow(2 * this.capacity);
			this.body.instanceMatrix.array.set(array);
			this.paint.array.set(paint);
		}
		this.body.instanceMatrix.array.set(agent.transform.rawData, 16 * this.count);
		const isPainted = agent.color !== OWN_COLOURS;
		colour.set(isPainted ? agent.color : 0xffffff);
		if (glow > 0) colour.lerp(WHITE, isPainted ? glow : 1);
		const alpha = isPainted ? 1 : glow;
		this.paint.array.set([colour.r, colour.g, colour.b, alpha], 4 * this.count);
		this.agents[this.count++] = agent;
	}

	finish() {
		this.agents.length = this.count;
		this.body.count = this.outline.count = this.count;
		this.body.visible = this.outline.visible = this.count > 0;
		this.body.instanceMatrix.needsUpdate = true;
		this.paint.needsUpdate = true;
		// they were computed for the instances' old places
		this.body.boundingSphere = null;
		this.count = 0;
	}

	dispose() {
		this.#remove();
		this.geometry.dispose();
	}
}

const colour = new Color();
const WHITE = new Color(0xffffff);

/** All agents that a stage shows. */
export class Agents {
	#shapes = new Map();

	constructor(parent) {
		this.parent = parent;
		this.materials = {
			body: changed(new MeshLambertMaterial({ vertexColors: true, flatShading: true }), "painted", takePaint),
			outline: changed(new MeshBasicMaterial({ color: INK, side: BackSide }), "swollen", swell),
		};
	}

	/** Draws outlines in a colour. */
	outline(ink) {
		this.materials.outline.color.set(ink);
	}

	/** Shows exactly these agents. glow gives the brightness of an agent's flash, from 0 to 1. */
	show(agents, models, glow) {
		for (const agent of agents) {
			const model = models.get(agent.shape);
			if (!this.#shapes.has(model)) this.#shapes.set(model, new Shape(model, this.parent, this.materials));
			this.#shapes.get(model).add(agent, glow(agent));
		}
		for (const shape of this.#shapes.values()) shape.finish();
	}

	/** The first agent that a ray meets, or null. */
	meets(caster) {
		const [hit] = caster.intersectObjects([...this.#shapes.values()].map(({ body }) => body).filter(({ visible }) => visible), false);
		return hit ? hit.object.userData.shape.agents[hit.instanceId] : null;
	}

	dispose() {
		for (const shape of this.#shapes.values()) shape.dispose();
		for (const material of Object.values(this.materials)) material.dispose();
	}
}

/** A model's triangles with flat shading, in its colours. The outline grows along the normals of smooth surfaces. */
function geometryOf(model) {
	const indexed = new BufferGeometry();
	indexed.setAttribute("position", new BufferAttribute(Float32Array.from(model.vertices), 3));
	if (model.triangles) indexed.setIndex(new BufferAttribute(Uint32Array.from(model.triangles), 1));
	indexed.computeVertexNormals();
	const flat = indexed.index ? indexed.toNonIndexed() : indexed;
	const colours = new Float32Array(flat.getAttribute("position").count * 3);
	let at = 0;
	for (const [triangles, value] of model.colours ?? []) {
		colour.set(value);
		for (const end = at + 9 * triangles; at < end; at += 3) colours.set([colour.r, colour.g, colour.b], at);
	}
	colour.set(PLAIN);
	for (; at < colours.length; at += 3) colours.set([colour.r, colour.g, colour.b], at);
	flat.setAttribute("color", new BufferAttribute(colours, 3));
	return flat;
}
