import { move, part, turn } from "../scene.mjs";
import { box, extrusion, frustum, spike } from "../shapes.mjs";

/** A square castle: four walls, a tower at each corner, a gatehouse to the front and a keep with a flag; metres. */
export function fortress() {
    const wall = extrusion(battlement(30, 9, 5), 2.4);
    const gatehouse = extrusion(battlement(11, 12.5, 3), 4.5);
    const gate = extrusion(arch(5.6, 5, 7), 0.6);
    const merlon = box(2.6, 2.6, 2);

    const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]];
    const towers = corners.flatMap(([x, y], i) => [
        part(`tower ${i + 1}`, "stone", frustum(9, 9, 12.5, 7.4, 7.4), move(15.5 * x, 15.5 * y, 0)),
        part(`tower ${i + 1} platform`, "dark_stone", box(8.8, 8.8, 1.5), move(15.5 * x, 15.5 * y, 12.5)),
        ...corners.map(([dx, dy], k) => part(`tower ${i + 1} merlon ${k + 1}`, "stone", merlon,
            move(15.5 * x + 3 * dx, 15.5 * y + 3 * dy, 14))),
    ]);
    return [
        ...[0, 90, 180, 270].map((heading, i) =>
            part(`wall ${i + 1}`, "stone", wall, turn("z", heading), move(16.5, 0, 0))),
        ...towers,
        part("gatehouse", "dark_stone", gatehouse, move(19, 0, 0)),
        part("gate", "wood", gate, move(19.3, 0, 0)),
        part("keep", "stone", frustum(13, 13, 13.5, 11.4, 11.4)),
        part("keep platform", "dark_stone", box(12.8, 12.8, 1.2), move(0, 0, 13.5)),
        ...corners.map(([x, y], i) => part(`keep merlon ${i + 1}`, "stone", merlon, move(5 * x, 5 * y, 14.7))),
        ...[-3, 3].map((y, i) => part(`keep window ${i + 1}`, "wood", box(0.6, 1.2, 2.6), move(6.1, y, 9.2))),
        part("flag pole", "wood", spike(4, 0.35, [0, 0, 5.3]), move(0, 0, 14.7)),
        part("flag", "trim", extrusion([[0, 0], [4.6, 1.1], [0, 2.2]], 0.25), move(0.12, 0.1, 17.2)),
    ];
}

/** The outline of a wall that ends in merlons, from (0, 0) in its middle. */
function battlement(width, height, merlons) {
    const step = width / (2 * merlons - 1);
    const top = [];
    for (let i = 0; i < merlons; i++) {
        const right = width / 2 - 2 * i * step;
        if (i > 0) {
            top.push([right, height]);
        }
        top.push([right, height + 2], [right - step, height + 2]);
        if (i + 1 < merlons) {
            top.push([right - step, height]);
        }
    }
    return [[-width / 2, 0], [width / 2, 0], ...top];
}

/** The outline of a round arch with so many points along its curve. */
function arch(width, height, points) {
    const curve = [];
    for (let i = 0; i < points; i++) {
        const angle = Math.PI * i / (points - 1);
        curve.push([Math.cos(angle) * width / 2, height + Math.sin(angle) * width / 2]);
    }
    return [[-width / 2, 0], [width / 2, 0], ...curve];
}
