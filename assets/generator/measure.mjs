import { flatten } from "./scene.mjs";

/** What the table of the README says about a model. */
export function measure(nodes) {
    const parts = flatten(nodes).map(part => part.mesh);
    const points = parts.flatMap(mesh => mesh.points);
    const low = [0, 1, 2].map(axis => points.reduce((least, point) => Math.min(least, point[axis]), Infinity));
    const high = [0, 1, 2].map(axis => points.reduce((most, point) => Math.max(most, point[axis]), -Infinity));
    const size = low.map((value, axis) => high[axis] - value);
    const unit = Math.max(size[0], size[1]);
    const extents = size.map(value => value / unit);
    const centre = low.map((value, axis) => (value + high[axis]) / 2);
    const radius = points.reduce((most, point) =>
        Math.max(most, Math.hypot(...point.map((value, axis) => value - centre[axis]))), 0) / unit;
    return {
        vertices: points.length,
        triangles: parts.reduce((sum, mesh) => sum + mesh.faces.reduce((n, face) => n + face.length - 2, 0), 0),
        extents,
        boxVolume: extents[0] * extents[1] * extents[2],
        sphereVolume: 4 / 3 * Math.PI * radius ** 3,
    };
}
