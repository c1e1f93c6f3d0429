/** The base colours of glTF files. The engine reads places and triangles alone, so a model gets its colours from here. */

const GLB = 0x46546c67;
/** The modes of primitives with triangles: lists, strips, fans. */
const [LIST, STRIP, FAN] = [4, 5, 6];

/** The JSON of a glTF or GLB file; null if it is neither. */
function jsonIn(bytes) {
	try {
		const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
		const part = view.getUint32(0, true) === GLB ? bytes.subarray(20, 20 + view.getUint32(12, true)) : bytes;
		const json = JSON.parse(new TextDecoder().decode(part));
		return json.asset && Array.isArray(json.meshes) ? json : null;
	} catch {
		return null;
	}
}

/** A part of a colour of light, from 0 to 1, as screens have it, in two digits. */
const digits = (light) => Math.round(255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055)).toString(16).padStart(2, "0");

/** The nodes that are shown, in the engine's order: each before the nodes in it. */
function* nodesOf({ nodes = [], scene, scenes = [] }) {
	const inner = new Set(nodes.flatMap(({ children = [] }) => children));
	const roots = scenes.length === 0 ? [...nodes.keys()].filter((i) => !inner.has(i)) : (scene === undefined ? scenes : [scenes[scene]]).flatMap((each) => each.nodes ?? []);
	const seen = new Set();
	const pending = [...roots].reverse();
	while (pending.length > 0) {
		const i = pending.pop();
		if (seen.has(i)) continue;
		seen.add(i);
		yield nodes[i];
		pending.push(...[...nodes[i].children ?? []].reverse());
	}
}

/**
 * The colours of a file's triangles in the engine's order: pairs of a count and a colour. They are undefined if the file has no colours, or
 * is no glTF.
 *
 * @param {Uint8Array} bytes the file's content
 * @param {number} count the triangles that the engine has found
 */
export function coloursIn(bytes, count) {
	const json = jsonIn(bytes);
	if (!json?.materials) return undefined;
	const colours = [];
	for (const { mesh } of nodesOf(json)) {
		for (const { attributes, indices, material, mode = LIST } of json.meshes[mesh]?.primitives ?? []) {
			const corners = json.accessors[indices ?? attributes.POSITION]?.count;
			const triangles = mode === LIST ? Math.floor(corners / 3) : mode === STRIP || mode === FAN ? Math.max(0, corners - 2) : 0;
			const light = json.materials[material]?.pbrMetallicRoughness?.baseColorFactor ?? [1, 1, 1];
			if (triangles > 0) colours.push([triangles, `#${light.slice(0, 3).map((each) => digits(Math.min(1, Math.max(0, each)))).join("")}`]);
		}
	}
	return colours.reduce((sum, [triangles]) => sum + triangles, 0) === count ? colours : undefined;
}
