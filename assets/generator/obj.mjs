import { decimals } from "./numbers.mjs";
import { channels, palette } from "./palette.mjs";
import { flatten } from "./scene.mjs";
import { cornerNormals } from "./shapes.mjs";

export const LICENCE = "CC0 1.0: dedicated to the public domain by the StarLogo Nova collision project.";

/** Wavefront OBJ: one object, a group for each part; z is up. */
export function obj({ name, nodes, withNormals }) {
    const lines = [`# ${LICENCE}`, "# z up, facing +x", "mtllib palette.mtl", `o ${name}`];
    let firstPoint = 1;
    let normalCount = 0;
    let colour = null;
    for (const part of flatten(nodes)) {
        lines.push(`g ${part.name.replaceAll(" ", "_")}`);
        lines.push(...part.mesh.points.map(point => `v ${decimals(point)}`));
        const corners = part.mesh.faces.map(face => face.map(corner => String(corner + firstPoint)));
        if (withNormals) {
            const seen = new Map();
            cornerNormals(part.mesh).forEach((normals, face) => normals.forEach((normal, corner) => {
                const text = decimals(normal, 3);
                if (!seen.has(text)) {
                    seen.set(text, ++normalCount);
                    lines.push(`vn ${text}`);
                }
                corners[face][corner] += `//${seen.get(text)}`;
            }));
        }
        if (part.colour !== colour) {
            colour = part.colour;
            lines.push(`usemtl ${colour}`);
        }
        lines.push(...corners.map(face => `f ${face.join(" ")}`));
        firstPoint += part.mesh.points.length;
    }
    return lines.join("\n") + "\n";
}

/** The material library that all OBJ files share. */
export function mtl(colours) {
    const lines = [`# ${LICENCE}`];
    for (const colour of Object.keys(palette).filter(name => colours.has(name))) {
        lines.push(`newmtl ${colour}`, `Kd ${decimals(channels(colour), 3)}`);
    }
    return lines.join("\n") + "\n";
}
