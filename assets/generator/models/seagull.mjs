import { group, move, pair, part, turn } from "../scene.mjs";
import { blade, ellipsoid, loft, smooth, spike } from "../shapes.mjs";

/** A gull about to land: wings raised and swept back, legs let down, toes spread; lengths in inches (wings 50). */
export function seagull() {
    const body = loft(14, smooth([
        [-13.5, 0, 0.6, 0, 0], [-12.5, 0, 0.5, 1.6, 0.8], [-8, 0, -0.3, 3.2, 2.4], [-2, 0, -0.8, 4.2, 3.9],
        [4, 0, -0.2, 4, 4], [8, 0, 1.6, 3, 3.2], [10.6, 0, 3, 2.4, 2.4], [12.3, 0, 3.6, 0, 0],
    ], 18));
    const head = loft(14, smooth([
        [8.4, 0, 3.2, 0, 0], [8.9, 0, 3.3, 1.6, 1.6], [11, 0, 4, 2.45, 2.4], [13, 0, 4, 1.9, 1.8],
        [14.2, 0, 3.7, 0.9, 0.9],
        [14.5, 0, 3.7, 0, 0],
    ], 11));
    const bill = loft(8, [
        [12.8, 0, 3.7, 0, 0], [13.3, 0, 3.7, 1, 0.85], [15, 0, 3.6, 0.7, 0.65], [16.8, 0, 3.4, 0.5, 0.6],
        [17.7, 0, 2.9, 0.25, 0.3], [18, 0, 2.3, 0, 0],
    ]);
    const tailRow = (x, half, height, arch, round) => [1, 0.5, 0, -0.5, -1].map(side =>
        [x + round * Math.abs(side), half * side, height - arch * Math.abs(side)]);
    const tail = blade([
        tailRow(-10, 2, 0.8, 0.3, 0), tailRow(-13, 2.9, 0.8, 0.12, 0), tailRow(-16, 3.8, 1.1, 0.15, 0),
        tailRow(-17.4, 3.4, 1.1, 0, 0.4),
    ], 0.7);

    return [
        part("body", "white_feather", body),
        part("head", "white_feather", head),
        part("bill", "beak", bill),
        part("bill spot", "trim", ellipsoid(6, 2, 0.5, 0.55, 0.3), move(16.7, 0, 3)),
        part("tail", "white_feather", tail),
        ...pair("eye",
            part("ring", "beak", ellipsoid(8, 2, 0.48, 0.2, 0.48), move(12.3, 1.98, 4.6), turn("z", -14)),
            part("pupil", "black", ellipsoid(6, 2, 0.32, 0.2, 0.32), move(12.33, 2.08, 4.62), turn("z", -14)),
        ),
        ...pair("wing", ...wing()),
        ...pair("leg", group("limb", [move(-2.5, 1.9, -4), turn("x", 3)], ...leg())),
    ];
}

/** The left wing: grey to the wrist and beyond, black at the tip; broad at the body and narrow at its end. */
function wing() {
    // Leading edge, trailing edge, from the shoulder outwards.
    const front = [[6, 2, 1.5], [7.6, 7, 5.6], [7, 12, 8.8], [2.6, 17.5, 10.6], [-4.8, 22, 12], [-13, 25, 13.4]];
    const back = [[-7, 2, 0.4], [-5.8, 7, 3.6], [-5.4, 12, 6.6], [-6.2, 17, 9], [-9.4, 21.4, 11], [-14, 24.8, 13.1]];
    const strip = (from, to, rows, columns) => Array.from({ length: rows }, (_, i) => {
        const place = from + (to - from) * i / (rows - 1);
        const f = smooth(front, 101)[Math.round(place * 100)];
        const b = smooth(back, 101)[Math.round(place * 100)];
        return Array.from({ length: columns }, (__, k) => {
            const t = k / (columns - 1);
            const camber = 3.2 * t * (1 - t) * (1 - 0.6 * place);
            return f.map((value, axis) => value + t * (b[axis] - value) + (axis === 2 ? camber : 0));
        });
    });
    const vane = strip(0, 0.8, 12, 7);
    const tip = strip(0.78, 1, 6, 7);
    const bone = loft(6, smooth(front.map((point, i) => [...point, 0.75 - 0.11 * i, 0.7 - 0.1 * i]), 9));
    return [
        part("vane", "grey_feather", blade(vane, 0.9)),
        part("tip", "black_feather", blade(tip, 0.8)),
        part("edge", "white_feather", bone),
    ];
}

/** A leg and a webbed foot, from the hip at the origin. */
function leg() {
    const shank = loft(6, smooth([
        [0.4, 0, 1, 1.1, 1.2], [0, 0, -1.2, 0.7, 0.8], [-0.8, 0, -2.6, 0.4, 0.4], [0, 0, -5.6, 0.34, 0.34],
        [0.3, 0, -6.6, 0.3, 0.3],
    ], 7), { front: [1, 0, 0] });
    const web = blade([
        [[-0.2, 0, -6.6]],
        [[1.3, 1, -6.75], [1.4, 0, -6.6], [1.3, -1, -6.75]],
        [[3.2, 2, -7], [2.9, 0, -6.9], [3.2, -2, -7]],
    ], 0.5);
    const toe = loft(4, [[0, 0, 0, 0.25, 0.25], [2.2, 0, -0.25, 0.22, 0.22], [3.9, 0, -0.5, 0, 0]]);
    return [
        part("shank", "beak", shank),
        part("web", "beak", web),
        ...[-32, 0, 32].map((heading, i) =>
            part(`toe ${i + 1}`, "beak", toe, move(-0.1, 0, -6.55), turn("z", heading))),
        part("hind toe", "beak", spike(3, 0.25, [-1.5, 0, -0.2]), move(0, 0, -6.5)),
    ];
}
