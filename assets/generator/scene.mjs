// A model is a tree of nodes. A node has a name, a pose (a list of steps, in the order in which COLLADA writes them:
// the last step is applied first), and either a mesh with a colour or children. A mesh or a node that appears twice
// in the tree is written once to a COLLADA file and instanced.

import { IDENTITY, apply, determinant, multiply, radians } from "./vectors.mjs";

export const move = (x, y, z) => ({
    element: "translate", values: [x, y, z], matrix: [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z],
});

export const scale = (x, y = x, z = x) => ({
    element: "scale", values: [x, y, z], matrix: [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0],
});

export function turn(axis, degrees) {
    const c = Math.cos(radians(degrees));
    const s = Math.sin(radians(degrees));
    const rotations = {
        x: [[1, 0, 0], [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0]],
        y: [[0, 1, 0], [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0]],
        z: [[0, 0, 1], [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0]],
    };
    const [direction, matrix] = rotations[axis];
    return { element: "rotate", values: [...direction, degrees], matrix };
}

/** The same steps as one matrix. */
export function asMatrix(...steps) {
    const matrix = poseMatrix(steps);
    return { element: "matrix", values: [...matrix, 0, 0, 0, 1], matrix };
}

const MIRROR = scale(1, -1, 1);

export const part = (name, colour, mesh, ...pose) => ({ name, pose, colour, mesh });
export const group = (name, pose, ...children) => ({ name, pose, children });

/** Something on the left (y > 0), and its mirror image on the right. */
export const pair = (name, ...children) => [
    group(`left ${name}`, [], ...children),
    group(`right ${name}`, [MIRROR], ...children),
];

function poseMatrix(pose) {
    return pose.reduce((matrix, step) => multiply(matrix, step.matrix), IDENTITY);
}

/** Every part of the tree with its mesh in the model's own coordinates: [{ name, colour, mesh }]. */
export function flatten(nodes, parent = IDENTITY, path = []) {
    return nodes.flatMap(node => {
        const matrix = multiply(parent, poseMatrix(node.pose));
        const names = [...path, node.name];
        if (node.children) {
            return flatten(node.children, matrix, names);
        }
        return [{ name: names.join(" "), colour: node.colour, mesh: bake(node.mesh, matrix) }];
    });
}

function bake(mesh, matrix) {
    const points = mesh.points.map(point => apply(matrix, point));
    const faces = determinant(matrix) < 0 ? mesh.faces.map(face => [...face].reverse()) : mesh.faces;
    return { ...mesh, points, faces };
}
