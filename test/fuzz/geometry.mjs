/** Plain geometry for the fuzzer's checks. Nothing here is taken from the engine, and nothing is fast. Points are arrays of three numbers. */

export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const along = (a, way, part) => [a[0] + part * way[0], a[1] + part * way[1], a[2] + part * way[2]];
export const length = (a) => Math.hypot(...a);
export const pointOf = ({ x, y, z }) => [x, y, z];
const clamp = (value, low, high) => Math.min(high, Math.max(low, value));

/** Turns by roll about x, then by pitch about y, then by heading about z. */
export function turned([x, y, z], { roll, pitch, heading }) {
	const turn = (a, b, degrees) => {
		const quarter = degrees % 360 / 90;
		const [cosine, sine] = Number.isInteger(quarter) ? [[1, 0], [0, 1], [-1, 0], [0, -1]][(quarter + 4) % 4] : [Math.cos(degrees * Math.PI / 180), Math.sin(degrees * Math.PI / 180)];
		return [cosine * a - sine * b, sine * a + cosine * b];
	};
	[y, z] = turn(y, z, roll);
	[z, x] = turn(z, x, pitch);
	[x, y] = turn(x, y, heading);
	return [x, y, z];
}

/** A point of a model, where an agent has it. */
export const placed = (point, agent) => {
	const [x, y, z] = turned(point, agent);
	return [agent.x + agent.size * x, agent.y + agent.size * y, agent.z + agent.size * z];
};

/** How often closed triangles wind around a point: the sum of their solid angles. */
export function windingOf(triangles, point) {
	let angle = 0;
	for (const corners of triangles) {
		const [a, b, c] = corners.map((corner) => sub(corner, point));
		const [la, lb, lc] = [length(a), length(b), length(c)];
		angle += 2 * Math.atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
	}
	return angle / (4 * Math.PI);
}

export function toSegment(point, a, b) {
	const way = sub(b, a);
	const whole = dot(way, way);
	const nearest = along(a, way, whole > 0 ? clamp(dot(sub(point, a), way) / whole, 0, 1) : 0);
	return length(sub(point, nearest));
}

export function toTriangle(point, [a, b, c]) {
	const edges = Math.min(toSegment(point, a, b), toSegment(point, b, c), toSegment(point, c, a));
	const normal = cross(sub(b, a), sub(c, a));
	const size = length(normal);
	if (size === 0) return edges;
	const isAbove = [[a, b], [b, c], [c, a]].every(([p, q]) => dot(cross(sub(q, p), sub(point, p)), normal) >= 0);
	return isAbove ? Math.abs(dot(sub(point, a), normal)) / size : edges;
}

/** A convex body: its corners, and the directions of its faces' normals and of its edges. */
export const triangleBody = (corners) => {
	const edges = [sub(corners[1], corners[0]), sub(corners[2], corners[1]), sub(corners[0], corners[2])];
	return { corners, edges, normals: [cross(edges[0], edges[1])] };
};

export function boxBody(center, axes, halves) {
	const corners = [];
	for (let i = 0; i < 8; i++) corners.push(axes.reduce((at, axis, k) => along(at, axis, i & 1 << k ? halves[k] : -halves[k]), center));
	return { corners, edges: axes, normals: axes };
}

/** @param {number[][]} corners @param {number[]} faces three corners each */
export function hullBody(corners, faces) {
	const triangles = Array.from({ length: faces.length / 3 }, (_, i) => triangleBody([0, 1, 2].map((k) => corners[faces[3 * i + k]])));
	return { corners, edges: triangles.flatMap(({ edges }) => edges), normals: triangles.flatMap(({ normals }) => normals) };
}

/** How far two convex bodies are apart on the axis that separates them most: less than 0 if they overlap. The true distance is no less. */
export function gapOf(a, b) {
	let widest = -Infinity;
	const crossed = a.edges.flatMap((edge) => b.edges.map((other) => cross(edge, other)));
	// of two triangles in one plane the axes lie in the plane
	const inPlane = [...a.edges.flatMap((edge) => a.normals.map((normal) => cross(edge, normal))), ...b.edges.flatMap((edge) => b.normals.map((normal) => cross(edge, normal)))];
	for (const axis of [...a.normals, ...b.normals, ...crossed, ...inPlane]) {
		const size = length(axis);
		if (size < 1e-12) continue;
		const [p, q] = [a, b].map(({ corners }) => corners.map((corner) => dot(corner, axis) / size));
		widest = Math.max(widest, Math.min(...q) - Math.max(...p), Math.min(...p) - Math.max(...q));
	}
	return widest;
}

const DEEP = 50;

/**
 * The solid below a ground as upright prisms, which end far below: of each column one, of each cell of slopes two. The heights are row by row.
 */
export function prismsOf({ columns, rows, cellWidth, x, y, isBlocky }, heights) {
	const prisms = [];
	const prism = (top) => {
		const bottom = top.map(([px, py]) => [px, py, Math.min(...heights) - DEEP]);
		const walls = top.flatMap((corner, i) => {
			const next = (i + 1) % top.length;
			return [[corner, bottom[i], top[next]], [top[next], bottom[i], bottom[next]]];
		});
		const tops = top.slice(2).map((_, i) => [top[0], top[i + 1], top[i + 2]]);
		const sides = top.map((corner, i) => sub(top[(i + 1) % top.length], corner));
		prisms.push({
			top, surface: [...tops, ...walls], left: Math.min(...top.map((at) => at[0])), right: Math.max(...top.map((at) => at[0])), low: Math.min(...top.map((at) => at[1])), high: Math.max(...top.map((at) => at[1])),
			corners: [...top, ...bottom], edges: [...sides, [0, 0, 1], ...sides.map(([sx, sy]) => [sx, sy, 0])], normals: [cross(sides[0], sides[1]), [0, 0, 1], ...sides.map(([sx, sy]) => [sy, -sx, 0])],
		});
	};
	const at = (column, row) => [x + cellWidth * column, y + cellWidth * row, heights[row * columns + column]];
	const half = cellWidth / 2;
	for (let row = 0; row < (isBlocky ? rows : rows - 1); row++) {
		for (let column = 0; column < (isBlocky ? columns : columns - 1); column++) {
			const [cx, cy, h] = at(column, row);
			if (isBlocky) prism([[cx - half, cy - half, h], [cx + half, cy - half, h], [cx + half, cy + half, h], [cx - half, cy + half, h]]);
			else {
				prism([at(column, row), at(column + 1, row), at(column + 1, row + 1)]);
				prism([at(column, row), at(column + 1, row + 1), at(column, row + 1)]);
			}
		}
	}
	return prisms;
}

/** The distance of a point from a prism, 0 inside. */
export function toPrism(point, { top, surface }) {
	const isBelow = top.every((corner, i) => {
		const [sx, sy] = sub(top[(i + 1) % top.length], corner);
		return sx * (point[1] - corner[1]) - sy * (point[0] - corner[0]) >= 0;
	});
	const normal = cross(sub(top[1], top[0]), sub(top[2], top[0]));
	if (isBelow && dot(sub(point, top[0]), normal) <= 0) return 0;
	return Math.min(...surface.map((triangle) => toTriangle(point, triangle)));
}

/** The least value of a convex function from 0 to 1. */
export function leastOf(f) {
	let [low, high] = [0, 1];
	for (let i = 0; i < 60; i++) {
		const [a, b] = [low + (high - low) / 3, high - (high - low) / 3];
		if (f(a) <= f(b)) high = b;
		else low = a;
	}
	return Math.min(f(0), f(1), f((low + high) / 2));
}

/** The bodies near a prism, and how far it is from them at least: less than 0 if one reaches into it. */
export function gapToPrism(piece, prism) {
	const far = (low, high, from, to) => low > to || high < from;
	const { minX, maxX, minY, maxY } = piece.extents;
	if (far(minX, maxX, prism.left, prism.right) || far(minY, maxY, prism.low, prism.high)) {
		// too far beside it to touch: the gap on the ground plane is a bound
		return Math.max(minX - prism.right, prism.left - maxX, minY - prism.high, prism.low - maxY);
	}
	if (piece.radius === undefined) return gapOf(piece, prism);
	if (piece.corners.length === 1) return toPrism(piece.corners[0], prism) - piece.radius;
	const [a, b] = piece.corners;
	return leastOf((part) => toPrism(along(a, sub(b, a), part), prism)) - piece.radius;
}

/** With its extents: least and greatest x, y and z. */
export function withExtents(piece) {
	const by = piece.radius ?? 0;
	const least = [0, 1, 2].map((k) => Math.min(...piece.corners.map((corner) => corner[k])) - by);
	const most = [0, 1, 2].map((k) => Math.max(...piece.corners.map((corner) => corner[k])) + by);
	return { ...piece, extents: { minX: least[0], maxX: most[0], minY: least[1], maxY: most[1], minZ: least[2], maxZ: most[2] } };
}
