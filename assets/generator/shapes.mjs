// Shapes are closed surfaces: { points, faces, crease }. A face lists its corners counter-clockwise seen from outside.
// Edges sharper than the crease, in degrees, are drawn sharp.

import { add, cross, dot, length, radians, subtract, times, unit } from "./vectors.mjs";

const SMOOTH = 60;
const SHARP = 20;

/** A box of these edge lengths, standing on the origin. */
export const box = (x, y, z) => frustum(x, y, z, x, y);

/** A box whose top is of another size than its bottom. */
export function frustum(x, y, z, topX, topY) {
    const rectangle = (width, depth, height) => [
        [-width / 2, -depth / 2, height], [width / 2, -depth / 2, height],
        [width / 2, depth / 2, height], [-width / 2, depth / 2, height],
    ];
    return closed([...rectangle(x, y, 0), ...rectangle(topX, topY, z)], [
        [3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7],
    ], SHARP);
}

/** A cone or, with few sides, a pyramid, from its base's centre at the origin to its tip. */
export function spike(sides, radius, tip, crease = SMOOTH) {
    return loft(sides, [[0, 0, 0, radius, radius], [...tip, 0, 0]],
        { front: Math.abs(tip[2]) > Math.hypot(tip[0], tip[1]) ? [1, 0, 0] : [0, 0, 1], crease });
}

/** An ellipsoid about the origin with its poles on the z axis. */
export function ellipsoid(sides, rings, x, y, z) {
    return lathe(sides, arc(rings), { stretch: [x, y, z] });
}

/** The profile of a half circle from the south pole to the north pole. */
function arc(rings) {
    const profile = [];
    for (let ring = 0; ring <= rings + 1; ring++) {
        const angle = Math.PI * ring / (rings + 1);
        const pole = ring === 0 || ring === rings + 1;
        profile.push([pole ? 0 : Math.sin(angle), -Math.cos(angle)]);
    }
    return profile;
}

/** A profile of [radius, height] turned about the z axis, then stretched. */
export function lathe(sides, profile, { stretch: [x, y, z] = [1, 1, 1], crease = SMOOTH } = {}) {
    return loft(sides, profile.map(([radius, height]) => [0, 0, height * z, radius * y, radius * x]),
        { front: [1, 0, 0], crease });
}

/**
 * A skin over elliptic rings along a curve. A station is [x, y, z, half width, half height]: the height is measured
 * towards "front", the width across it. The first and the last station may be points (width 0); otherwise they
 * are closed by a flat face. "square" between 0 (ellipse) and 1 fills the corners of the rings.
 */
export function loft(sides, stations, { front = [0, 0, 1], square = 0, crease = SMOOTH } = {}) {
    const points = [];
    const rings = stations.map((station, index) => {
        const centre = station.slice(0, 3);
        const [width, height] = station.slice(3);
        if (width === 0) {
            points.push(centre);
            return Array(sides).fill(points.length - 1);
        }
        const along = unit(subtract(
            stations[Math.min(index + 1, stations.length - 1)].slice(0, 3),
            stations[Math.max(index - 1, 0)].slice(0, 3)));
        const up = unit(subtract(front, times(along, dot(front, along))));
        const across = cross(up, along);
        const exponent = 1 - 0.5 * square;
        const bend = value => Math.sign(value) * Math.abs(value) ** exponent;
        const ring = [];
        for (let side = 0; side < sides; side++) {
            const angle = 2 * Math.PI * (side + 0.5) / sides;
            ring.push(points.length);
            points.push(add(centre, add(
                times(across, width * bend(cleaned(Math.cos(angle)))),
                times(up, height * bend(cleaned(Math.sin(angle)))))));
        }
        return ring;
    });
    const faces = [[...rings[0]].reverse(), rings[rings.length - 1]];
    for (let i = 0; i + 1 < rings.length; i++) {
        for (let side = 0; side < sides; side++) {
            const next = (side + 1) % sides;
            faces.push([rings[i][side], rings[i][next], rings[i + 1][next], rings[i + 1][side]]);
        }
    }
    return closed(points, faces, crease);
}

const cleaned = value => Math.abs(value) < 1e-12 ? 0 : value;

/** Stations of a tube with a shoulder and a tip added at both ends: a sausage. */
export function rounded(stations) {
    const end = (last, previous) => {
        const direction = unit(subtract(last.slice(0, 3), previous.slice(0, 3)));
        const radius = (last[3] + last[4]) / 2;
        const at = (distance, size) =>
            [...add(last.slice(0, 3), times(direction, distance * radius)), last[3] * size, last[4] * size];
        return [at(0.65, 0.74), at(0.95, 0)];
    };
    return [
        ...end(stations[0], stations[1]).reverse(),
        ...stations,
        ...end(stations[stations.length - 1], stations[stations.length - 2]),
    ];
}

/** A smooth curve (Catmull-Rom) through rows of numbers, as so many rows; the first and the last row stay. */
export function smooth(rows, count) {
    const result = [];
    for (let i = 0; i < count; i++) {
        const place = (rows.length - 1) * i / (count - 1);
        const k = Math.min(Math.floor(place), rows.length - 2);
        const t = place - k;
        const [b, c] = [rows[k], rows[k + 1]];
        if (t === 1) {
            result.push(c);
            continue;
        }
        const a = rows[k - 1] ?? b;
        const d = rows[k + 2] ?? c;
        result.push(b.map((_, n) => b[n] + t * ((c[n] - a[n]) / 2 + t * (a[n] - 2.5 * b[n] + 2 * c[n] - d[n] / 2
            + t * (1.5 * (b[n] - c[n]) + (d[n] - a[n]) / 2)))));
    }
    return result;
}

/**
 * A thin solid, thickest in its middle and sharp at its rim: a leaf, a wing, a fin. The grid holds rows of points of
 * its middle surface; a first or last row may be a single point.
 */
export function blade(grid, thickness, crease = SMOOTH) {
    const columns = Math.max(...grid.map(row => row.length));
    const at = (row, column) => grid[row][Math.min(column, grid[row].length - 1)];
    const last = grid.length - 1;
    const points = [];
    const top = [];
    const bottom = [];
    for (let row = 0; row <= last; row++) {
        top.push([]);
        bottom.push([]);
        for (let column = 0; column < columns; column++) {
            const point = at(row, column);
            if (column > 0 && grid[row].length === 1) {
                top[row].push(top[row][0]);
                bottom[row].push(top[row][0]);
            } else if (row === 0 || row === last || column === 0 || column === columns - 1) {
                points.push(point);
                top[row].push(points.length - 1);
                bottom[row].push(points.length - 1);
            } else {
                const normal = unit(cross(
                    subtract(at(row + 1, column), at(row - 1, column)),
                    subtract(at(row, column + 1), at(row, column - 1))));
                points.push(add(point, times(normal, thickness / 2)), add(point, times(normal, -thickness / 2)));
                top[row].push(points.length - 2);
                bottom[row].push(points.length - 1);
            }
        }
    }
    const faces = [];
    for (let row = 0; row < last; row++) {
        for (let column = 0; column + 1 < columns; column++) {
            const quad = layer => [layer[row][column], layer[row + 1][column],
                layer[row + 1][column + 1], layer[row][column + 1]];
            faces.push(quad(top), quad(bottom).reverse());
        }
    }
    return closed(points, faces, crease);
}

/** An outline in the y-z plane (counter-clockwise seen from +x), made solid from x = 0 back to x = -depth. */
export function extrusion(outline, depth) {
    const n = outline.length;
    const points = [
        ...outline.map(([y, z]) => [0, y, z]),
        ...outline.map(([y, z]) => [-depth, y, z]),
    ];
    const faces = [];
    for (const triangle of convexPieces(outline)) {
        faces.push(triangle, triangle.map(i => i + n).reverse());
    }
    for (let i = 0; i < n; i++) {
        const next = (i + 1) % n;
        faces.push([next, i, i + n, next + n]);
    }
    return closed(points, faces, SHARP);
}

/** The outline itself when it is convex, otherwise triangles (by clipping ears). */
function convexPieces(outline) {
    const turning = (a, b, c) => (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
    const corners = outline.map((_, i) => i);
    const isConvex = corners.every(i =>
        turning(outline[i], outline[(i + 1) % outline.length], outline[(i + 2) % outline.length]) > 0);
    if (isConvex) {
        return [corners];
    }
    const triangles = [];
    while (corners.length > 3) {
        const ear = corners.findIndex((corner, k) => {
            const a = corners[(k + corners.length - 1) % corners.length];
            const c = corners[(k + 1) % corners.length];
            const [pa, pb, pc] = [outline[a], outline[corner], outline[c]];
            return turning(pa, pb, pc) > 1e-9 && corners.every(other => other === a || other === corner || other === c
                || turning(pa, pb, outline[other]) < 0 || turning(pb, pc, outline[other]) < 0
                || turning(pc, pa, outline[other]) < 0);
        });
        triangles.push([
            corners[(ear + corners.length - 1) % corners.length], corners[ear], corners[(ear + 1) % corners.length],
        ]);
        corners.splice(ear, 1);
    }
    triangles.push(corners);
    return triangles;
}

/** The same shape with soft bumps, each phase giving other ones: foliage, for example. */
export function lumpy(mesh, depth, phase) {
    const points = mesh.points.map(([x, y, z]) => {
        const bump = Math.sin(2.1 * x + phase) * Math.cos(1.7 * y + 2 * phase) + Math.sin(1.9 * z + 3 * phase) / 2;
        return times([x, y, z], 1 + depth * bump);
    });
    return { ...mesh, points };
}

/** Drops the faces that poles have folded away, and turns the surface inside out if it faces inwards. */
function closed(points, faces, crease) {
    const kept = faces
        .map(face => face.filter((corner, i) => corner !== face[(i + 1) % face.length]))
        .filter(face => face.length > 2);
    const volume = kept.reduce((sum, face) => {
        for (let i = 1; i + 1 < face.length; i++) {
            sum += dot(points[face[0]], cross(points[face[i]], points[face[i + 1]]));
        }
        return sum;
    }, 0);
    return { points, faces: volume < 0 ? kept.map(face => face.reverse()) : kept, crease };
}

/** A unit normal for each corner of each face, smooth except across edges sharper than the crease. */
export function cornerNormals({ points, faces, crease }) {
    const areas = faces.map(face => {
        let sum = [0, 0, 0];
        for (let i = 1; i + 1 < face.length; i++) {
            sum = add(sum, cross(
                subtract(points[face[i]], points[face[0]]),
                subtract(points[face[i + 1]], points[face[0]])));
        }
        return sum;
    });
    const around = points.map(() => []);
    faces.forEach((face, index) => face.forEach(corner => around[corner].push(index)));
    const limit = Math.cos(radians(crease));
    return faces.map((face, index) => {
        const own = unit(areas[index]);
        return face.map(corner => unit(around[corner]
            .filter(other => dot(own, areas[other]) >= limit * length(areas[other]))
            .reduce((sum, other) => add(sum, areas[other]), [0, 0, 0])));
    });
}
