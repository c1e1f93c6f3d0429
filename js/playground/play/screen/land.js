/** The surroundings of agents: chequered ground, sky, and soft shadows on the ground. */
import {
	CanvasTexture, CircleGeometry, Color, DoubleSide, Fog, Group, LinearMipmapLinearFilter, Matrix4, Mesh, MeshBasicMaterial, NearestFilter, PlaneGeometry, Points, PointsMaterial, RepeatWrapping,
	RingGeometry, SphereGeometry, BackSide, BufferAttribute, BufferGeometry, SRGBColorSpace,
} from "three";
import { TerrainSurface } from "starlogo-collision";
import { GROUNDS } from "../../shared/drawing/colours.js";
import { Instances } from "../../shared/drawing/marks.js";

const FAR = 360;
/** The upward part of the normal down to which a slope is as green as the plain, and that from which it is all earth; and what earth makes of red, green and blue. */
const [GRASSY, BARE, EARTH] = [0.985, 0.75, [1, 0.6, 0.42]];

/** The width of a square of the ground. */
const CELL = 1;

export class Land {
	#name = "meadow";
	#shadows;
	#footprints = new Map();

	/**
	 * @param {object} scene contains the land
	 * @param {number} width the width of the field for games
	 */
	constructor(scene, width) {
		this.scene = scene;
		this.width = width;
		this.#shadows = new Instances(scene, new CircleGeometry(1, 24), shadowMaterial(), 0);
	}

	/** Sets the kind of ground: a name in GROUNDS. Returns whether it is another one: then applyTheme builds it. */
	setGround(name) {
		const isOther = this.#name !== name;
		this.#name = name;
		return isOther;
	}

	/** Builds it again for light or dark. Returns the brightness of the lights and the colour of the agents' outlines. */
	applyTheme(name) {
		const theme = GROUNDS[this.#name][name];
		const { zenith, horizon, field, around, edge, stars = 0 } = theme;
		this.dispose();
		this.group = new Group();
		this.scene.fog = new Fog(horizon, 2 * this.width, 7 * this.width);
		this.scene.background = new Color(horizon);
		const sky = new SphereGeometry(FAR, 24, 16).rotateX(Math.PI / 2);
		const position = sky.getAttribute("position");
		const [low, high] = [new Color(horizon), new Color(zenith)];
		const colours = Array.from({ length: position.count }, (_, i) => low.clone().lerp(high, Math.min(1, Math.max(0, position.getZ(i) / FAR) * 1.7)).toArray()).flat();
		sky.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 3));
		const dome = new Mesh(sky, new MeshBasicMaterial({ vertexColors: true, side: BackSide, depthWrite: false, fog: false }));
		// drawn last, so that hidden parts are not drawn
		dome.renderOrder = 3;
		const half = this.width / 2;
		const frame = new Mesh(new RingGeometry(half * Math.SQRT2, (half + 0.12) * Math.SQRT2, 4, 1, Math.PI / 4), new MeshBasicMaterial({ color: edge }));
		frame.position.z = 0.002;
		if (stars > 0) this.group.add(starry(stars));
		// a ring, so that it does not cover hollows in the field
		const surroundings = new RingGeometry(half * Math.SQRT2, FAR * Math.SQRT2, 4, 1, Math.PI / 4);
		const squares = Math.round(this.width / CELL);
		this.field = this.#ground(new PlaneGeometry(this.width, this.width, squares, squares), field, -0.006, 1);
		this.walls = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ color: field[1], vertexColors: true }));
		this.walls.visible = false;
		this.group.add(dome, this.#ground(surroundings, around, -0.03, 2), this.field, this.walls, frame);
		this.scene.add(this.group);
		this.terrain = null;
		return theme;
	}

	/**
	 * Gives the field the heights of a terrain.
	 *
	 * @returns {boolean} whether one of them has changed
	 */
	showTerrain(terrain) {
		const { geometry } = this.field;
		const position = geometry.getAttribute("position");
		let isChanged = false;
		for (let i = 0; i < position.count; i++) {
			const height = Math.fround(terrain?.heightAt(position.getX(i), position.getY(i)) || 0);
			isChanged ||= position.getZ(i) !== height;
			position.setZ(i, height);
		}
		this.terrain = terrain;
		if (isChanged) {
			shade(geometry);
			this.#closeBorder();
		}
		return isChanged;
	}

	/** Draws upright walls where the terrain ends. */
	#closeBorder() {
		this.walls.geometry.dispose();
		this.walls.geometry = new BufferGeometry();
		this.walls.visible = Boolean(this.terrain);
		if (!this.terrain) return;
		const surface = new TerrainSurface(this.terrain);
		surface.update();
		const { vertices, normals, triangles } = surface;
		const ofVertices = (numbers) => new BufferAttribute(Float32Array.from(numbers), 3);
		this.walls.geometry.setAttribute("position", ofVertices(vertices)).setAttribute("normal", ofVertices(normals));
		this.walls.geometry.setIndex(triangles.filter((vertex) => normals[3 * vertex + 2] === 0));
		light(this.walls.geometry);
	}

	#ground(geometry, colours, height, renderOrder) {
		const canvas = document.createElement("canvas");
		canvas.width = canvas.height = 2;
		const pen = canvas.getContext("2d");
		for (let i = 0; i < 4; i++) {
			pen.fillStyle = colours[(i + (i >> 1)) % 2];
			pen.fillRect(i % 2, i >> 1, 1, 1);
		}
		const texture = new CanvasTexture(canvas);
		texture.colorSpace = SRGBColorSpace;
		texture.wrapS = texture.wrapT = RepeatWrapping;
		const position = geometry.getAttribute("position");
		const at = Float32Array.from({ length: 2 * position.count }, (_, i) => position.array[3 * (i >> 1) + i % 2] / (2 * CELL));
		geometry.setAttribute("uv", new BufferAttribute(at, 2));
		shade(geometry);
		texture.magFilter = NearestFilter;
		texture.minFilter = LinearMipmapLinearFilter;
		texture.anisotropy = 8;
		const ground = new Mesh(geometry, new MeshBasicMaterial({ map: texture, vertexColors: true }));
		ground.position.z = height;
		ground.renderOrder = renderOrder;
		return ground;
	}

	/** Draws a soft shadow below each agent, as wide as its model. The higher the agent, the smaller the shadow. */
	showShadows(agents, models) {
		for (const agent of agents) {
			const { x, y, halfX, halfY } = this.#footprint(models.get(agent.shape));
			const angle = (agent.heading * Math.PI) / 180;
			const [cos, sin] = [Math.cos(angle) * agent.size, Math.sin(angle) * agent.size];
			const ground = this.terrain?.heightAt(agent.x, agent.y) || 0;
			const spread = 1.35 * Math.max(0.3, 1 - (agent.z - ground) / 14);
			this.#shadows.add(matrix.set(
				cos * halfX * spread, -sin * halfY * spread, 0, agent.x + cos * x - sin * y,
				sin * halfX * spread, cos * halfY * spread, 0, agent.y + sin * x + cos * y,
				0, 0, 1, ground + 0.008,
				0, 0, 0, 1,
			), 0xffffff);
		}
		this.#shadows.finish();
	}

	/** The middle and half the width of a model in x and y. */
	#footprint(model) {
		if (!this.#footprints.has(model)) {
			const [low, high] = [[Infinity, Infinity], [-Infinity, -Infinity]];
			model.vertices.forEach((value, i) => {
				if (i % 3 === 2) return;
				low[i % 3] = Math.min(low[i % 3], value);
				high[i % 3] = Math.max(high[i % 3], value);
			});
			this.#footprints.set(model, { x: (low[0] + high[0]) / 2, y: (low[1] + high[1]) / 2, halfX: (high[0] - low[0]) / 2, halfY: (high[1] - low[1]) / 2 });
		}
		return this.#footprints.get(model);
	}

	/** Frees everything except the shadows' places. */
	dispose() {
		this.group?.removeFromParent();
		this.group?.traverse(({ geometry, material }) => {
			geometry?.dispose();
			material?.map?.dispose();
			material?.dispose();
		});
	}
}

const matrix = new Matrix4();

/** A dark spot that fades to its border. */
function shadowMaterial() {
	const canvas = document.createElement("canvas");
	canvas.width = canvas.height = 64;
	const pen = canvas.getContext("2d");
	const fade = pen.createRadialGradient(32, 32, 4, 32, 32, 32);
	for (const [at, alpha] of [[0, 0.55], [0.5, 0.4], [0.8, 0.12], [1, 0]]) fade.addColorStop(at, `rgb(10 25 30 / ${alpha})`);
	pen.fillStyle = fade;
	pen.fillRect(0, 0, 64, 64);
	return new MeshBasicMaterial({ map: new CanvasTexture(canvas), transparent: true, depthWrite: false, side: DoubleSide });
}

/** Darkens slopes that do not face the light. What is flat keeps its colour. */
function shade(geometry) {
	geometry.computeVertexNormals();
	light(geometry);
	geometry.getAttribute("position").needsUpdate = true;
}

/** Gives a geometry with normals the brightness of its vertices, and steep slopes the colour of earth. */
function light(geometry) {
	const normal = geometry.getAttribute("normal");
	const colours = Float32Array.from({ length: 3 * normal.count }, (_, i) => {
		const at = Math.floor(i / 3);
		const bare = Math.min(1, Math.max(0, (GRASSY - normal.getZ(at)) / (GRASSY - BARE)));
		return Math.min(1.15, Math.max(0.4, normal.getZ(at) - 0.35 * normal.getX(at) - 0.2 * normal.getY(at))) * (1 + bare * (EARTH[i % 3] - 1));
	});
	geometry.setAttribute("color", new BufferAttribute(colours, 3));
}

/** Stars all over the sky, placed by the golden angle. */
function starry(count) {
	const places = Array.from({ length: count }, (_, i) => {
		const height = (i + 0.5) / count;
		const [around, across] = [i * 2.399963, Math.sqrt(1 - height * height)];
		return [Math.cos(around) * across, Math.sin(around) * across, height].map((at) => 0.95 * FAR * at);
	});
	const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(Float32Array.from(places.flat()), 3));
	const stars = new Points(geometry, new PointsMaterial({ color: 0xdfe8ff, size: 1.6, sizeAttenuation: false, fog: false, depthWrite: false }));
	stars.renderOrder = 4;
	return stars;
}
