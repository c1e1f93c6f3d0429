/** Random objects of three.js, of all kinds that models are made of. */

/** A generator of Park and Miller, with what scenes need of it. */
export class Dice {
	#seed;

	constructor(seed) {
		this.#seed = seed;
	}

	/** From 0 to 1, or from low to high. */
	number(low = 0, high = 1) {
		this.#seed = (this.#seed * 48271) % 2147483647;
		return low + ((high - low) * this.#seed) / 2147483647;
	}

	/** 0 to count - 1. */
	below(count) {
		return Math.min(count - 1, Math.floor(this.number(0, count)));
	}

	isLuckyIn(times) {
		return this.below(times) === 0;
	}

	direction() {
		for (;;) {
			const [x, y, z] = [this.number(-1, 1), this.number(-1, 1), this.number(-1, 1)];
			const length = Math.hypot(x, y, z);
			if (length > 0.1 && length < 1) return [x / length, y / length, z / length];
		}
	}
}

export class Scenes {
	/** How often each kind was made. */
	counts = {};

	/**
	 * @param {object} THREE the version of three.js that makes them
	 * @param {number} seed of what is random
	 * @param {{isForRays?: boolean}} options whether to leave out what a Raycaster sees otherwise than what is drawn: levels of detail, points, shear, groups
	 *     without a material
	 */
	constructor(THREE, seed, { isForRays = false } = {}) {
		this.THREE = THREE;
		this.isForRays = isForRays;
		this.dice = new Dice(seed);
	}

	#count(kind) {
		this.counts[kind] = (this.counts[kind] ?? 0) + 1;
	}

	quaternion() {
		const { THREE, dice } = this;
		const [x, y, z] = dice.direction();
		return new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(x, y, z), dice.number(-Math.PI, Math.PI));
	}

	/** Puts an object anywhere, turned and uniformly scaled: as an agent can be. Now and then near gimbal lock, or mirrored twice. */
	place(object) {
		const { dice } = this;
		object.position.set(dice.number(-5, 5), dice.number(-5, 5), dice.number(-5, 5));
		object.quaternion.copy(this.quaternion());
		object.scale.setScalar(dice.number(0.2, 3));
		if (dice.isLuckyIn(5)) {
			this.#count("near gimbal lock");
			object.rotation.set(dice.number(-3, 3), Math.PI / 2 - dice.number(0, 1e-7), dice.number(-3, 3));
		}
		if (dice.isLuckyIn(5)) {
			this.#count("mirrored twice");
			const axis = dice.below(3);
			for (let i = 0; i < 3; i++) if (i !== axis) object.scale.setComponent(i, -object.scale.getComponent(i));
		}
		if (dice.isLuckyIn(5)) {
			this.#count("placed by its matrix");
			object.updateMatrix();
			object.matrixAutoUpdate = false;
			object.position.set(0, 0, 0);
		}
		return object;
	}

	/** A tree of objects: non-uniform scales and mirrors below its root. */
	tree(depth = 0) {
		const { THREE, dice } = this;
		const object = depth > 2 || (depth > 0 && dice.isLuckyIn(2)) ? this.mesh() : !this.isForRays && dice.isLuckyIn(6) ? this.#lod() : new THREE.Group();
		if (depth > 0) {
			object.position.set(dice.number(-2, 2), dice.number(-2, 2), dice.number(-2, 2));
			object.quaternion.copy(this.quaternion());
			object.scale.set(dice.number(0.5, 2), dice.number(0.5, 2), dice.number(0.5, 2));
			// what is sheared reaches out of the sphere that a Raycaster tests first
			if (this.isForRays) object.scale.setScalar(object.scale.x);
			if (dice.isLuckyIn(4)) {
				this.#count("mirrored");
				object.scale.x *= -1;
			}
			if (dice.isLuckyIn(6)) {
				object.updateMatrix();
				object.matrixAutoUpdate = false;
			}
			object.visible = !dice.isLuckyIn(8);
		}
		for (let i = dice.below(3) + (depth === 0 ? 1 : 0); i > 0 && depth < 3 && !object.isLOD; i--) object.add(this.tree(depth + 1));
		if (!this.isForRays && dice.isLuckyIn(5)) object.add(new THREE.Points(this.#geometry()), new THREE.Sprite(), new THREE.PointLight());
		return object;
	}

	#lod() {
		const { THREE } = this;
		this.#count("levels of detail");
		const lod = new THREE.LOD();
		lod.addLevel(this.mesh(), 10);
		lod.addLevel(this.mesh(), 0);
		return lod;
	}

	/** A mesh of some kind. */
	mesh() {
		const { THREE, dice } = this;
		const geometry = this.#geometry();
		const material = dice.isLuckyIn(3) ? this.#materials(geometry) : new THREE.MeshBasicMaterial({ side: THREE.DoubleSide });
		switch (dice.below(4)) {
			case 0:
				return this.#instanced(geometry, material);
			case 1:
				return this.#skinned(geometry, material);
			case 2:
				return this.#morphed(geometry, material);
			default:
				this.#count("plain");
				return new THREE.Mesh(geometry, material);
		}
	}

	#geometry() {
		const { THREE, dice } = this;
		const made = [() => new THREE.BoxGeometry(1, dice.number(0.2, 2), 1), () => new THREE.IcosahedronGeometry(dice.number(0.3, 1), 1),
			() => new THREE.TorusGeometry(1, 0.3, 5, 7), () => new THREE.ConeGeometry(0.6, 1.5, 6)][dice.below(4)]();
		let geometry = made;
		if (made.index && dice.isLuckyIn(3)) geometry = made.toNonIndexed();
		if (geometry.index) this.#count("indexed");
		if (dice.isLuckyIn(4)) {
			this.#count("interleaved");
			const { count } = geometry.attributes.position;
			const buffer = new THREE.InterleavedBuffer(new Float32Array(5 * count), 5);
			const interleaved = new THREE.InterleavedBufferAttribute(buffer, 3, 1);
			for (let i = 0; i < count; i++) interleaved.setXYZ(i, ...new THREE.Vector3().fromBufferAttribute(geometry.attributes.position, i).toArray());
			geometry.setAttribute("position", interleaved);
		} else if (dice.isLuckyIn(4)) {
			this.#count("quantized");
			const { array } = geometry.attributes.position;
			geometry.setAttribute("position", new THREE.BufferAttribute(Int16Array.from(array, (value) => Math.round(value * 16000)), 3, true));
		}
		geometry.clearGroups();
		if (dice.isLuckyIn(3)) {
			this.#count("a draw range");
			const total = (geometry.index ?? geometry.attributes.position).count;
			geometry.setDrawRange(3 * dice.below(3), total - 3 * dice.below(5));
		}
		return geometry;
	}

	/** Materials for groups: some groups have none. */
	#materials(geometry) {
		const { THREE, dice } = this;
		this.#count("groups");
		const total = (geometry.index ?? geometry.attributes.position).count;
		const half = 3 * Math.floor(total / 6);
		geometry.addGroup(0, half, 0);
		geometry.addGroup(half, Infinity, dice.below(this.isForRays ? 2 : 3));
		return [0, 1].map(() => new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
	}

	#instanced(geometry, material) {
		const { THREE, dice } = this;
		this.#count("instanced");
		const mesh = new THREE.InstancedMesh(geometry, material, 4);
		for (let i = 0; i < 4; i++) {
			const scale = new THREE.Vector3(dice.number(0.3, 1), dice.number(0.3, 1), dice.isLuckyIn(2) ? 0.5 : -0.5);
			if (dice.isLuckyIn(6)) scale.setScalar(0);
			mesh.setMatrixAt(i, new THREE.Matrix4().compose(new THREE.Vector3(...dice.direction()), this.quaternion(), scale));
		}
		mesh.count = 1 + dice.below(4);
		return mesh;
	}

	#skinned(geometry, material) {
		const { THREE, dice } = this;
		this.#count("skinned");
		const { count } = geometry.attributes.position;
		const index = [];
		const weight = [];
		for (let i = 0; i < count; i++) {
			// exact in single precision: where the sum is not 1, three.js moves vertices with the world's origin
			const share = dice.below(257) / 256;
			index.push(0, 1, 0, 0);
			weight.push(share, 1 - share, 0, 0);
		}
		geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(index, 4));
		geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(weight, 4));
		const bones = [new THREE.Bone(), new THREE.Bone()];
		bones[0].add(bones[1]);
		bones[1].position.y = 0.5;
		const mesh = new THREE.SkinnedMesh(geometry, material);
		mesh.add(bones[0]);
		mesh.bind(new THREE.Skeleton(bones));
		bones[0].quaternion.copy(this.quaternion());
		bones[1].position.set(...dice.direction());
		bones[1].quaternion.copy(this.quaternion());
		return mesh;
	}

	#morphed(geometry, material) {
		const { THREE, dice } = this;
		this.#count("morphed");
		const { count } = geometry.attributes.position;
		const target = new THREE.Float32BufferAttribute(Array.from({ length: 3 * count }, () => dice.number(-0.3, 0.3)), 3);
		geometry.morphAttributes.position = [target];
		geometry.morphTargetsRelative = true;
		const mesh = new THREE.Mesh(geometry, material);
		mesh.morphTargetInfluences[0] = dice.number();
		return mesh;
	}
}

/** The corners of all triangles that three.js draws of an object, in the world: x, y, z, ...; and whether each triangle is mirrored. */
export function drawnCorners(THREE, root) {
	const corners = [];
	const flips = [];
	const visit = (object) => {
		if (object.isMesh) for (const place of placesOf(THREE, object)) cornersOf(THREE, object, place, corners, flips);
		const children = object.isLOD ? [object.levels[0].object] : object.children;
		children.forEach(visit);
	};
	root.updateWorldMatrix(true, true);
	root.updateMatrixWorld(true);
	visit(root);
	return { corners, flips };
}

function placesOf(THREE, mesh) {
	if (!mesh.isInstancedMesh) return [mesh.matrixWorld];
	const places = Array.from({ length: mesh.count }, (_, i) => {
		const place = new THREE.Matrix4();
		mesh.getMatrixAt(i, place);
		return place;
	});
	return places.filter((place) => place.getMaxScaleOnAxis() > 0).map((place) => place.premultiply(mesh.matrixWorld));
}

function cornersOf(THREE, mesh, place, corners, flips) {
	const { geometry, material } = mesh;
	const { drawRange, index } = geometry;
	const total = (index ?? geometry.attributes.position).count;
	for (let i = 0; i + 2 < total; i += 3) {
		const isDrawn = i >= drawRange.start && i + 2 < drawRange.start + drawRange.count;
		const group = geometry.groups.find(({ start, count }) => i >= start && i < start + count);
		if (!isDrawn || (Array.isArray(material) && !material[group.materialIndex])) continue;
		flips.push(place.determinant() < 0);
		for (let k = i; k < i + 3; k++) {
			const point = mesh.getVertexPosition(index ? index.getX(k) : k, new THREE.Vector3()).applyMatrix4(place);
			corners.push(point.x, point.y, point.z);
		}
	}
}
