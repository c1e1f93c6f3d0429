/** Marks in the world: rings where agents met, and translucent solids for the shapes that the engine tests. */
import { BoxGeometry, Color, CylinderGeometry, Group, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, RingGeometry, SphereGeometry, Vector3 } from "three";

/** One geometry at many places, in many colours. */
export class Instances {
	mesh = null;
	count = 0;

	/** `order` is the drawing order: later ones are drawn over earlier ones. */
	constructor(parent, geometry, material, order = 5) {
		Object.assign(this, { parent, geometry, material, order });
	}

	add(matrix, color) {
		if (!this.mesh || this.count === this.mesh.instanceMatrix.count) {
			const { mesh: old, count } = this;
			this.mesh = new InstancedMesh(this.geometry, this.material, 2 * count + 16);
			this.mesh.frustumCulled = false;
			this.mesh.renderOrder = this.order;
			this.mesh.setColorAt(0, tint.set(0));
			if (old) {
				this.mesh.instanceMatrix.array.set(old.instanceMatrix.array);
				this.mesh.instanceColor.array.set(old.instanceColor.array);
				old.removeFromParent();
				old.dispose();
			}
			this.parent.add(this.mesh);
		}
		this.mesh.setMatrixAt(this.count, matrix);
		this.mesh.setColorAt(this.count++, tint.set(color));
	}

	/** Adds one at a point, with a rotation, a size and a colour. */
	addAt(point, rotation, size, color) {
		this.add(matrix.compose(point, rotation, factors.setScalar(size)), color);
	}

	finish() {
		if (!this.mesh) return;
		this.mesh.count = this.count;
		this.mesh.visible = this.count > 0;
		this.mesh.instanceMatrix.needsUpdate = this.mesh.instanceColor.needsUpdate = true;
		this.count = 0;
	}

	dispose() {
		this.mesh?.dispose();
		this.geometry.dispose();
		this.material.dispose();
	}
}

const tint = new Color();
const matrix = new Matrix4();
const [place, along, factors] = [new Vector3(), new Vector3(), new Vector3()];
const turn = new Quaternion();
const UP = new Vector3(0, 0, 1);

/** Thin glass with lines in its colour, so that the colour stays the same over grass, and agents keep theirs behind it. */
function hatch(shader) {
	shader.fragmentShader = shader.fragmentShader.replace("#include <color_fragment>", "#include <color_fragment>\ndiffuseColor.a *= mod(gl_FragCoord.x + gl_FragCoord.y, 10.0) < 2.0 ? 5.0 : 1.0;");
}

export class Marks {
	constructor(scene) {
		this.group = new Group();
		scene.add(this.group);
		const glass = new MeshBasicMaterial({ transparent: true, opacity: 0.14, depthWrite: false });
		glass.onBeforeCompile = hatch;
		const ink = new MeshBasicMaterial({ depthTest: false, transparent: true });
		this.rings = new Instances(this.group, new RingGeometry(0.72, 1, 28), ink);
		this.dots = new Instances(this.group, new SphereGeometry(1, 10, 8), ink);
		this.boxes = new Instances(this.group, new BoxGeometry(2, 2, 2), glass);
		this.balls = new Instances(this.group, new SphereGeometry(1, 20, 14), glass);
		// from 0 to 1 along z
		this.tubes = new Instances(this.group, new CylinderGeometry(1, 1, 1, 20, 1, true).rotateX(Math.PI / 2).translate(0, 0, 0.5), glass);
	}

	/** A dot and a growing ring. Age is from 0 to 1. */
	addHit(point, age, color, eye) {
		place.set(point.x, point.y, point.z);
		if (age < 0.4) this.rings.add(matrix.compose(place, eye, factors.setScalar(0.15 + 1.6 * age)), color);
		this.dots.add(matrix.compose(place, turn.identity(), factors.setScalar(0.09 * (1 - age * age))), color);
	}

	/** Adds a Sphere, Box or Capsule of the engine. The matrix takes its space to the world. */
	addSolid(structure, world, color) {
		const { center, start, end, radius } = structure;
		if (structure.halfX !== undefined) {
			const { axisX: a, axisY: b, axisZ: c, halfX, halfY, halfZ } = structure;
			matrix.set(a.x * halfX, b.x * halfY, c.x * halfZ, center.x, a.y * halfX, b.y * halfY, c.y * halfZ, center.y, a.z * halfX, b.z * halfY, c.z * halfZ, center.z, 0, 0, 0, 1);
			this.boxes.add(matrix.premultiply(world), color);
			return;
		}
		for (const each of start ? [start, end] : [center]) {
			this.balls.add(matrix.compose(place.set(each.x, each.y, each.z), turn.identity(), factors.setScalar(radius)).premultiply(world), color);
		}
		if (!start) return;
		along.set(end.x - start.x, end.y - start.y, end.z - start.z);
		const length = along.length();
		turn.setFromUnitVectors(UP, along.normalize());
		this.tubes.add(matrix.compose(place.set(start.x, start.y, start.z), turn, factors.set(radius, radius, length)).premultiply(world), color);
	}

	finish() {
		for (const each of this.#all) each.finish();
	}

	get #all() {
		return [this.rings, this.dots, this.boxes, this.balls, this.tubes];
	}

	dispose() {
		for (const each of this.#all) each.dispose();
	}
}
