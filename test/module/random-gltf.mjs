/** Random glTF files that use all that there is of nodes, meshes, accessors, skins and morph targets. */

const FLOAT = 5126;
const KINDS = {
	5120: { size: 1, write: "writeInt8", most: 127 },
	5121: { size: 1, write: "writeUInt8", most: 255 },
	5122: { size: 2, write: "writeInt16LE", most: 32767 },
	5123: { size: 2, write: "writeUInt16LE", most: 65535 },
	5125: { size: 4, write: "writeUInt32LE" },
	[FLOAT]: { size: 4, write: "writeFloatLE" },
};
const WIDTHS = { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 };

/** A file, and the names of what it uses. */
export function randomGltf(seed) {
	const file = new RandomGltf(seed);
	return { bytes: file.bytes(), features: file.features };
}

class RandomGltf {
	features = new Set();
	#state;
	#json = { asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [] }], nodes: [], meshes: [], skins: [], accessors: [], bufferViews: [], buffers: [] };
	#pieces = [];
	#length = 0;

	constructor(seed) {
		this.#state = seed * 2654435761 >>> 0;
		const meshCount = this.#integer(1, 3);
		for (let i = 0; i < meshCount; i++) this.#json.meshes.push(this.#mesh());
		const nodeCount = this.#integer(meshCount, 6);
		for (let i = 0; i < nodeCount; i++) this.#addNode(i);
	}

	bytes() {
		const binary = Buffer.concat(this.#pieces);
		const json = Object.fromEntries(Object.entries(this.#json).filter(([, value]) => !Array.isArray(value) || value.length > 0));
		const buffer = { byteLength: binary.length };
		json.buffers = [buffer];
		if (this.#chance(0.5)) {
			this.features.add("text");
			buffer.uri = `data:application/octet-stream;base64,${binary.toString("base64")}`;
			return Buffer.from(JSON.stringify(json));
		}
		this.features.add("binary");
		return container(JSON.stringify(json), binary);
	}

	#next() {
		this.#state = this.#state + 0x6d2b79f5 >>> 0;
		let t = Math.imul(this.#state ^ this.#state >>> 15, this.#state | 1);
		t ^= t + Math.imul(t ^ t >>> 7, t | 61);
		return ((t ^ t >>> 14) >>> 0) / 4294967296;
	}

	#integer(least, most) {
		return least + Math.floor(this.#next() * (most - least + 1));
	}

	#chance(share) {
		return this.#next() < share;
	}

	#between(least, most) {
		return least + this.#next() * (most - least);
	}

	#numbers(count, least = -2, most = 2) {
		return Array.from({ length: count }, () => Math.fround(this.#between(least, most)));
	}

	#addNode(i) {
		const { nodes, meshes, scenes } = this.#json;
		const node = { ...this.#place(), ...(this.#chance(0.8) || i < meshes.length ? { mesh: i < meshes.length ? i : this.#integer(0, meshes.length - 1) } : {}) };
		if (i >= meshes.length && node.mesh !== undefined) this.features.add("instanced");
		nodes.push(node);
		const mesh = meshes[node.mesh];
		const parent = this.#integer(-1, i - 1);
		if (parent < 0) scenes[0].nodes.push(i);
		else (nodes[parent].children ??= []).push(i);
		if (mesh?.primitives[0].targets && this.#chance(0.5)) node.weights = this.#numbers(mesh.primitives[0].targets.length, -1, 1);
		if (mesh?.primitives[0].attributes.JOINTS_0 !== undefined) {
			this.features.add("skin");
			const joints = Array.from({ length: 4 }, () => this.#integer(0, i));
			node.skin = this.#json.skins.push({ joints }) - 1;
			const matrices = joints.flatMap(() => [...this.#numbers(3), 0, ...this.#numbers(3), 0, ...this.#numbers(3), 0, ...this.#numbers(3), 1]);
			if (this.#chance(0.8)) this.#json.skins[node.skin].inverseBindMatrices = this.#accessor(matrices, "MAT4", FLOAT, {});
		}
	}

	#place() {
		if (this.#chance(0.2)) return {};
		const scale = this.#numbers(3, 0.3, 2).map((factor) => (this.#chance(0.15) ? -factor : factor));
		if (scale[0] * scale[1] * scale[2] < 0) this.features.add("mirror");
		const turn = this.#numbers(4, -1, 1);
		const length = Math.hypot(...turn);
		if (this.#chance(0.3)) {
			this.features.add("matrix");
			const [a, b, c] = scale;
			const [cos, sin] = [Math.cos(turn[0]), Math.sin(turn[0])];
			return { matrix: [a * cos, a * sin, 0, 0, -b * sin, b * cos, 0, 0, 0, 0, c, 0, ...this.#numbers(3), 1] };
		}
		return { translation: this.#numbers(3), rotation: turn.map((value) => value / length), scale };
	}

	#mesh() {
		const isSkinned = this.#chance(0.3);
		const targets = this.#chance(0.3) ? this.#integer(1, 3) : 0;
		const primitives = Array.from({ length: this.#integer(1, 3) }, () => this.#primitive(isSkinned, targets));
		// primitives of other triangles of the same vertices
		if (this.#chance(0.3) && primitives.length > 1) {
			const { indices, mode, ...first } = primitives[0];
			primitives[1] = { ...first, indices: this.#indices(this.#json.accessors[first.attributes.POSITION].count, 4) };
		}
		return { primitives, ...(targets > 0 && this.#chance(0.7) ? { weights: this.#numbers(targets, -1, 1) } : {}) };
	}

	// what adds up to a whole: three.js rounds other integers to what does
	#shares(whole) {
		const [a, b, c] = Array.from({ length: 3 }, () => this.#integer(0, whole)).sort((x, y) => x - y);
		return [a, b - a, c - b, whole - c];
	}

	#primitive(isSkinned, targets) {
		const count = 3 * this.#integer(1, 8);
		const attributes = { POSITION: this.#vertices(count) };
		if (isSkinned) {
			const joints = Array.from({ length: 4 * count }, () => this.#integer(0, 3));
			attributes.JOINTS_0 = this.#accessor(joints, "VEC4", this.#pick([5121, 5123]), {});
			const isWhole = this.#chance(0.4);
			const weights = Array.from({ length: count }, () => (isWhole ? this.#shares(255) : this.#numbers(4, 0, 1))).flat();
			attributes.WEIGHTS_0 = this.#accessor(weights, "VEC4", isWhole ? 5121 : FLOAT, { normalized: isWhole });
		}
		const primitive = { attributes };
		if (targets > 0) {
			this.features.add("morph");
			primitive.targets = Array.from({ length: targets }, () => ({ POSITION: this.#accessor(this.#numbers(3 * count), "VEC3", FLOAT, this.#layout(false)) }));
		}
		const mode = this.#pick([4, 4, 5, 6]);
		if (mode !== 4 || this.#chance(0.5)) primitive.mode = mode;
		if (mode > 4) this.features.add(mode === 5 ? "strip" : "fan");
		if (this.#chance(0.7)) primitive.indices = this.#indices(count, mode);
		else this.features.add("no indices");
		return primitive;
	}

	#indices(count, mode) {
		const length = mode === 4 ? 3 * this.#integer(1, 6) : this.#integer(3, 9);
		const indices = Array.from({ length }, () => this.#integer(0, count - 1));
		return this.#accessor(indices, "SCALAR", this.#pick([5121, 5123, 5125]), { sparse: this.#chance(0.1) });
	}

	#vertices(count) {
		const kind = this.#chance(0.5) ? FLOAT : this.#pick([5120, 5121, 5122, 5123]);
		if (kind !== FLOAT) this.features.add("quantised");
		const isSigned = kind === 5120 || kind === 5122;
		const { most } = KINDS[kind];
		const numbers = kind === FLOAT ? this.#numbers(3 * count) : Array.from({ length: 3 * count }, () => this.#integer(isSigned ? -most - 1 : 0, most));
		const normalized = kind !== FLOAT && this.#chance(0.6);
		if (normalized) this.features.add("normalised");
		return this.#accessor(numbers, "VEC3", kind, { normalized, ...this.#layout(true) });
	}

	#layout(canHaveStride) {
		// three.js writes what is sparse as if its rows had no gaps
		const hasStride = canHaveStride && this.#chance(0.4);
		return { hasStride, sparse: !hasStride && this.#chance(0.4) };
	}

	#pick(list) {
		return list[this.#integer(0, list.length - 1)];
	}

	/** Adds an accessor of numbers: as they are, or with some of them elsewhere. */
	#accessor(numbers, type, kind, { normalized = false, hasStride = false, sparse = false }) {
		const width = WIDTHS[type];
		const accessor = { componentType: kind, type, count: numbers.length / width };
		if (normalized) accessor.normalized = true;
		const isOfZeros = sparse && this.#chance(0.3);
		const base = [...numbers];
		if (sparse) {
			this.features.add("sparse");
			const replaced = Array.from({ length: accessor.count }, (_, i) => i).filter(() => isOfZeros || this.#chance(0.4));
			if (replaced.length === 0) replaced.push(0);
			const values = replaced.flatMap((i) => numbers.slice(width * i, width * (i + 1)));
			for (const i of replaced) base.fill(0, width * i, width * (i + 1));
			accessor.sparse = {
				count: replaced.length,
				indices: { bufferView: this.#view(replaced, 1, 5123, 0), componentType: 5123 },
				values: { bufferView: this.#view(values, width, kind, 0) },
			};
		}
		if (!isOfZeros) {
			const least = width * KINDS[kind].size;
			// three.js wants rows that are whole numbers of their elements
			const stride = hasStride ? Math.ceil(least / 4) * 4 + 4 * this.#integer(0, 3) : 0;
			if (stride > 0) this.features.add("stride");
			accessor.bufferView = this.#view(base, width, kind, stride);
		}
		return this.#json.accessors.push(accessor) - 1;
	}

	#view(numbers, width, kind, stride) {
		const { size, write } = KINDS[kind];
		const row = stride || width * size;
		const data = Buffer.alloc(Math.ceil(row * numbers.length / width / 4) * 4, 0x7f);
		numbers.forEach((number, i) => data[write](number, Math.floor(i / width) * row + i % width * size));
		this.#pieces.push(data);
		this.#length += data.length;
		return this.#json.bufferViews.push({ buffer: 0, byteOffset: this.#length - data.length, byteLength: data.length, ...(stride ? { byteStride: stride } : {}) }) - 1;
	}
}

/** A binary file. */
function container(json, binary) {
	const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4));
	const header = Buffer.alloc(20);
	header.write("glTF");
	header.writeUInt32LE(2, 4);
	header.writeUInt32LE(28 + text.length + binary.length, 8);
	header.writeUInt32LE(text.length, 12);
	header.write("JSON", 16);
	const chunk = Buffer.alloc(8);
	chunk.writeUInt32LE(binary.length);
	chunk.write("BIN\0", 4);
	return Buffer.concat([header, text, chunk, binary]);
}
