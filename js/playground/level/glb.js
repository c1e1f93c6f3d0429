/** Reads the page's own level: a GLB file of nodes, meshes without textures, and plain colours. The engine's GltfModel reads users' files. */
import { BufferAttribute, BufferGeometry, Color, Group, Mesh, MeshLambertMaterial } from "three";

const HEADER = 12;
const CHUNK_HEADER = 8;
/** The kinds of numbers that the file has, by glTF's codes. */
const NUMBERS = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const WIDTHS = { SCALAR: 1, VEC3: 3 };

/** The scene in a file's bytes: an Object3D with the nodes' places, y up. */
export function sceneIn(buffer) {
	const length = new DataView(buffer).getUint32(HEADER, true);
	const start = HEADER + CHUNK_HEADER;
	const { accessors, bufferViews, materials, meshes, nodes, scene, scenes } = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, start, length)));
	const data = start + length + CHUNK_HEADER;
	const attributeOf = (at) => {
		const { bufferView, byteOffset = 0, componentType, count, type } = accessors[at];
		const Numbers = NUMBERS[componentType];
		const from = data + (bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
		return new BufferAttribute(new Numbers(buffer.slice(from, from + Numbers.BYTES_PER_ELEMENT * WIDTHS[type] * count)), WIDTHS[type]);
	};
	const coats = materials.map(({ pbrMetallicRoughness: { baseColorFactor } }) => new MeshLambertMaterial({ color: new Color(...baseColorFactor.slice(0, 3)), flatShading: true }));
	const shapes = meshes.map(({ primitives }) => primitives.map(({ attributes, indices, material }) => [new BufferGeometry().setAttribute("position", attributeOf(attributes.POSITION)).setIndex(attributeOf(indices)), coats[material]]));
	const made = ({ name, matrix, mesh, children = [] }) => {
		const group = Object.assign(new Group(), { name });
		if (matrix) group.applyMatrix4(group.matrix.clone().fromArray(matrix));
		if (mesh !== undefined) group.add(...shapes[mesh].map(([geometry, coat]) => new Mesh(geometry, coat)));
		if (children.length > 0) group.add(...children.map((each) => made(nodes[each])));
		return group;
	};
	return new Group().add(...scenes[scene].nodes.map((each) => made(nodes[each])));
}
