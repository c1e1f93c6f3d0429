/**
 * A glTF file with a skinned mesh, a mesh with morph targets, and an animation of their nodes, joints and weights, all random.
 *
 * @param {object} dice
 * @param {string} interpolation "LINEAR", "STEP" or "CUBICSPLINE"
 * @returns {Uint8Array}
 */
export function animatedFile(dice, interpolation) {
	const accessors = [];
	const bufferViews = [];
	const chunks = [];
	let length = 0;
	const add = (numbers, type, ArrayType, extra = {}) => {
		const width = { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 }[type];
		const bytes = Buffer.from(new ArrayType(numbers).buffer);
		bufferViews.push({ buffer: 0, byteOffset: length, byteLength: bytes.length });
		accessors.push({ bufferView: bufferViews.length - 1, type, count: numbers.length / width, componentType: ArrayType === Float32Array ? 5126 : 5123, ...extra });
		const padded = Buffer.concat([bytes, Buffer.alloc((4 - bytes.length % 4) % 4)]);
		chunks.push(padded);
		length += padded.length;
		return accessors.length - 1;
	};
	const numbers = (count, most = 1) => Array.from({ length: count }, () => dice.number(-most, most));
	const turn = () => {
		const q = numbers(4);
		const size = Math.hypot(...q);
		return q.map((part) => part / size);
	};
	const count = 12;
	const positions = () => add(numbers(3 * count), "VEC3", Float32Array, { min: [-1, -1, -1], max: [1, 1, 1] });
	const triangles = add(Array.from({ length: 30 }, (_, i) => (i < count ? i : dice.below(count))), "SCALAR", Uint16Array);
	const weights = Array.from({ length: count }, () => dice.below(257) / 256).flatMap((share) => [share, 1 - share, 0, 0]);
	const attributes = { POSITION: positions(), JOINTS_0: add(Array.from({ length: count }, () => [0, 1, 0, 0]).flat(), "VEC4", Uint16Array), WEIGHTS_0: add(weights, "VEC4", Float32Array) };
	const inverse = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.5, 0, 1];
	const times = [0, 0.5, 1.25, 2];
	const input = add(times, "SCALAR", Float32Array, { min: [0], max: [2] });
	const keys = times.length * (interpolation === "CUBICSPLINE" ? 3 : 1);
	const samplers = [];
	const channels = [];
	const animate = (node, path, values, type) => {
		samplers.push({ input, output: add(values, type, Float32Array), interpolation });
		channels.push({ sampler: samplers.length - 1, target: { node, path } });
	};
	const turns = () => Array.from({ length: keys }, turn).flat();
	animate(0, "translation", numbers(3 * keys, 2), "VEC3");
	animate(2, "rotation", turns(), "VEC4");
	animate(3, "rotation", turns(), "VEC4");
	animate(3, "translation", numbers(3 * keys), "VEC3");
	animate(4, "scale", Array.from({ length: 3 * keys }, () => dice.number(0.5, 2)), "VEC3");
	animate(4, "weights", numbers(2 * keys), "SCALAR");
	const json = {
		asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0, 1] }], accessors, bufferViews,
		nodes: [
			{ children: [2] }, { mesh: 0, skin: 0, translation: [9, 9, 9] }, { children: [3], rotation: turn() }, { children: [4], translation: [0, 0.5, 0] },
			{ mesh: 1, translation: numbers(3) },
		],
		meshes: [
			{ primitives: [{ attributes, indices: triangles }] },
			{ primitives: [{ attributes: { POSITION: positions() }, indices: triangles, targets: [{ POSITION: positions() }, { POSITION: positions() }] }], weights: [0.5, 0] },
		],
		skins: [{ joints: [2, 3], inverseBindMatrices: add([...inverse, ...inverse], "MAT4", Float32Array) }],
		animations: [{ name: "walk", samplers, channels }],
	};
	json.buffers = [{ byteLength: length }];
	const text = Buffer.from(JSON.stringify(json));
	const padded = Buffer.concat([text, Buffer.alloc((4 - text.length % 4) % 4, " ")]);
	const word = (number) => {
		const bytes = Buffer.alloc(4);
		bytes.writeUInt32LE(number);
		return bytes;
	};
	// "glTF", version 2, then the chunks of JSON and of the buffer
	return new Uint8Array(Buffer.concat([word(0x46546c67), word(2), word(28 + padded.length + length), word(padded.length), word(0x4e4f534a), padded,
		word(length), word(0x004e4942), ...chunks]));
}
