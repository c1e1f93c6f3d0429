import { LICENCE } from "./obj.mjs";
import { decimals } from "./numbers.mjs";
import { channels } from "./palette.mjs";
import { cornerNormals } from "./shapes.mjs";

const WRITTEN = "2024-01-01T00:00:00Z"; // COLLADA wants a date; a fixed one keeps the files the same

// From z up to the up axis of the file.
const axes = {
    Z_UP: { vector: v => v, scale: v => v, matrix: m => m },
    Y_UP: {
        vector: ([x, y, z]) => [x, z, -y],
        scale: ([x, y, z]) => [x, z, y],
        matrix: m => [
            m[0], m[2], -m[1], m[3],
            m[8], m[10], -m[9], m[11],
            -m[4], -m[6], m[5], -m[7],
            0, 0, 0, 1,
        ],
    },
};

/** COLLADA 1.4.1: a geometry for each mesh, a library node for each group that appears twice, and the scene. */
export function collada({ name, nodes, upAxis = "Z_UP", unit }) {
    const axis = axes[upAxis];
    const { meshes, groups, colours } = inventory(nodes);
    const out = [];
    let depth = 0;
    const line = text => out.push(" ".repeat(depth) + text);
    const element = (open, body) => {
        line(`<${open}>`);
        depth++;
        body();
        depth--;
        line(`</${open.split(" ")[0]}>`);
    };

    function geometry(mesh, id) {
        const normals = new Map();
        const corners = cornerNormals(mesh).map((faceNormals, face) => faceNormals.map((normal, i) => {
            const text = decimals(axis.vector(normal), 3);
            if (!normals.has(text)) {
                normals.set(text, normals.size);
            }
            return `${mesh.faces[face][i]} ${normals.get(text)}`;
        }));
        const triangles = corners.filter(face => face.length === 3);
        const polygons = corners.filter(face => face.length > 3);
        element(`geometry id="${id}"`, () => element("mesh", () => {
            source(`${id}-positions`, mesh.points.map(point => decimals(axis.vector(point))));
            source(`${id}-normals`, [...normals.keys()]);
            element(`vertices id="${id}-vertices"`, () =>
                line(`<input semantic="POSITION" source="#${id}-positions"/>`));
            const primitive = (kind, faces) => element(`${kind} material="paint" count="${faces.length}"`, () => {
                line(`<input semantic="VERTEX" source="#${id}-vertices" offset="0"/>`);
                line(`<input semantic="NORMAL" source="#${id}-normals" offset="1"/>`);
                if (kind === "polylist") {
                    line(`<vcount>${faces.map(face => face.length).join(" ")}</vcount>`);
                }
                line(`<p>${faces.map(face => face.join(" ")).join(" ")}</p>`);
            });
            if (polygons.length > 0) {
                primitive("polylist", polygons);
            }
            if (triangles.length > 0) {
                primitive("triangles", triangles);
            }
        }));
    }

    function source(id, rows) {
        element(`source id="${id}"`, () => {
            line(`<float_array id="${id}-array" count="${rows.length * 3}">${rows.join(" ")}</float_array>`);
            element("technique_common", () =>
                element(`accessor source="#${id}-array" count="${rows.length}" stride="3"`, () =>
                    ["X", "Y", "Z"].forEach(param => line(`<param name="${param}" type="float"/>`))));
        });
    }

    function pose(steps) {
        for (const { element: kind, values, matrix } of steps) {
            const numbers = {
                translate: () => axis.vector(values),
                rotate: () => [...axis.vector(values.slice(0, 3)), values[3]],
                scale: () => axis.scale(values),
                matrix: () => axis.matrix([...matrix, 0, 0, 0, 1]),
            }[kind]();
            line(`<${kind}>${decimals(numbers)}</${kind}>`);
        }
    }

    function node(it, path) {
        const names = [...path, it.name];
        element(`node id="${slug(names)}" name="${it.name}"`, () => contents(it, names));
    }

    function contents(it, names) {
        pose(it.pose);
        if (it.mesh) {
            element(`instance_geometry url="#${meshes.get(it.mesh)}"`, () =>
                element("bind_material", () => element("technique_common", () =>
                    line(`<instance_material symbol="paint" target="#${it.colour}-material"/>`))));
            return;
        }
        // The schema puts instances before nodes.
        for (const child of it.children.filter(child => groups.has(child))) {
            line(`<instance_node url="#${groups.get(child)}"/>`);
        }
        for (const child of it.children.filter(child => !groups.has(child))) {
            node(child, names);
        }
    }

    out.push(`<?xml version="1.0" encoding="utf-8"?>`, `<!-- ${LICENCE} -->`);
    element(`COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"`, () => {
        element("asset", () => {
            line(`<created>${WRITTEN}</created>`);
            line(`<modified>${WRITTEN}</modified>`);
            line(`<unit name="${unit.name}" meter="${unit.meter}"/>`);
            line(`<up_axis>${upAxis}</up_axis>`);
        });
        element("library_effects", () => colours.forEach(colour =>
            element(`effect id="${colour}-effect"`, () => element("profile_COMMON", () =>
                element(`technique sid="common"`, () => element("lambert", () => element("diffuse", () =>
                    line(`<color>${decimals([...channels(colour), 1], 3)}</color>`))))))));
        element("library_materials", () => colours.forEach(colour =>
            element(`material id="${colour}-material" name="${colour}"`, () =>
                line(`<instance_effect url="#${colour}-effect"/>`))));
        element("library_geometries", () => meshes.forEach((id, mesh) => geometry(mesh, id)));
        if (groups.size > 0) {
            element("library_nodes", () => groups.forEach((id, it) =>
                element(`node id="${id}" name="${it.name}"`, () => contents(it, [id]))));
        }
        element("library_visual_scenes", () => element(`visual_scene id="scene" name="${name}"`, () =>
            element(`node id="${name}" name="${name}"`, () => contents({ pose: [], children: nodes }, []))));
        element("scene", () => line(`<instance_visual_scene url="#scene"/>`));
    });
    return out.join("\n") + "\n";
}

const slug = names => names.join("-").replaceAll(" ", "-");

/** The distinct meshes, the groups that appear more than once, each with an id, and the colours. */
function inventory(nodes) {
    const meshes = new Map();
    const groups = new Map();
    const visited = new Set();
    const colours = new Set();
    const ids = new Set();
    const newId = (name, kind) => {
        let id = `${slug([name])}-${kind}`;
        for (let number = 2; ids.has(id); number++) {
            id = `${slug([name])}-${number}-${kind}`;
        }
        ids.add(id);
        return id;
    };
    const visit = node => {
        if (node.mesh) {
            colours.add(node.colour);
            if (!meshes.has(node.mesh)) {
                meshes.set(node.mesh, newId(node.name, "mesh"));
            }
        } else if (!visited.has(node)) {
            visited.add(node);
            node.children.forEach(visit);
        } else if (!groups.has(node)) {
            groups.set(node, newId(node.name, "node"));
        }
    };
    nodes.forEach(visit);
    return { meshes, groups, colours: [...colours] };
}
