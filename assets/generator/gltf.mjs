import { LICENCE } from "./obj.mjs";
import { channels } from "./palette.mjs";
import { asMatrix, turn } from "./scene.mjs";

const [FLOAT, UNSIGNED_SHORT] = [5126, 5123];
const [POINTS, INDICES] = [34962, 34963];

/** glTF 2.0, a file of bytes: y is up, facing +x; a node for each of the model's, flat triangles without normals. */
export function glb({ name, nodes: tree }) {
    const colours = new Map();
    const meshes = new Map();
    const buffers = [];
    const json = {
        asset: { version: "2.0", copyright: LICENCE }, scene: 0, scenes: [{ nodes: [0] }], nodes: [], meshes: [], materials: [],
        accessors: [], bufferViews: [], buffers: [],
    };

    const addBuffer = (values, target, accessor) => {
        const byteOffset = buffers.reduce((sum, { byteLength }) => sum + byteLength, 0);
        const bytes = Buffer.alloc(Math.ceil(values.byteLength / 4) * 4);
        bytes.set(Buffer.from(values.buffer));
        buffers.push(bytes);
        const view = json.bufferViews.push({ buffer: 0, byteOffset, byteLength: values.byteLength, target }) - 1;
        return json.accessors.push({ bufferView: view, ...accessor }) - 1;
    };

    const materialOf = colour => {
        if (!colours.has(colour)) {
            // what the palette has is for screens, what glTF has is linear
            const linear = channels(colour).map(value => Number((value ** 2.2).toFixed(4)));
            const pbrMetallicRoughness = { baseColorFactor: [...linear, 1], metallicFactor: 0, roughnessFactor: 0.9 };
            colours.set(colour, json.materials.push({ name: colour, pbrMetallicRoughness }) - 1);
        }
        return colours.get(colour);
    };

    const meshOf = ({ colour, mesh: { points, faces } }) => {
        const key = JSON.stringify([colour, points, faces]);
        if (!meshes.has(key)) {
            const bounds = pick => [0, 1, 2].map(axis => Math.fround(pick(...points.map(point => point[axis]))));
            const position = addBuffer(Float32Array.from(points.flat()), POINTS,
                { componentType: FLOAT, count: points.length, type: "VEC3", min: bounds(Math.min), max: bounds(Math.max) });
            const fans = faces.flatMap(face => face.slice(2).flatMap((corner, i) => [face[0], face[i + 1], corner]));
            const indices = addBuffer(Uint16Array.from(fans), INDICES, { componentType: UNSIGNED_SHORT, count: fans.length, type: "SCALAR" });
            const primitives = [{ attributes: { POSITION: position }, indices, material: materialOf(colour) }];
            meshes.set(key, json.meshes.push({ primitives }) - 1);
        }
        return meshes.get(key);
    };

    const addNode = node => {
        const at = json.nodes.push({ name: node.name }) - 1;
        if (node.pose.length > 0) {
            const rows = asMatrix(...node.pose).values;
            json.nodes[at].matrix = [0, 1, 2, 3].flatMap(column => [0, 1, 2, 3].map(row => Number(rows[4 * row + column].toFixed(6)) + 0));
        }
        if (node.children) {
            json.nodes[at].children = node.children.map(addNode);
        } else {
            json.nodes[at].mesh = meshOf(node);
        }
        return at;
    };

    addNode({ name, pose: [turn("x", -90)], children: tree });
    const binary = Buffer.concat(buffers);
    json.buffers.push({ byteLength: binary.length });
    const text = Buffer.from(JSON.stringify(json));
    const padded = Buffer.concat([text, Buffer.alloc((4 - text.length % 4) % 4, " ")]);
    return Buffer.concat([words("glTF", 2, 28 + padded.length + binary.length), words(padded.length, "JSON"), padded, words(binary.length, "BIN\0"), binary]);
}

/** Four bytes each: the letters of a text, or a number. */
function words(...values) {
    return Buffer.concat(values.map(value => {
        const word = Buffer.alloc(4);
        if (typeof value === "string") {
            word.write(value, "latin1");
        } else {
            word.writeUInt32LE(value);
        }
        return word;
    }));
}
