import { group, move, pair, part, scale, turn } from "../scene.mjs";
import { blade, ellipsoid, loft, rounded, smooth, spike } from "../shapes.mjs";

/** A dragon in flight: wings like a bat's, a long neck and tail, spikes along its back; lengths in metres. */
export function dragon() {
    // From the tip of the tail to the head: x, y, z, half width, half height.
    const spine = smooth([
        [-4.05, 0.2, 0.15, 0.05, 0.05], [-3.55, 0.05, -0.08, 0.1, 0.1], [-2.9, -0.15, -0.2, 0.18, 0.18],
        [-2.1, -0.1, -0.15, 0.3, 0.3], [-1.3, 0, 0, 0.5, 0.5], [-0.4, 0, 0.05, 0.66, 0.66], [0.5, 0, 0.1, 0.7, 0.72],
        [1.3, 0, 0.25, 0.52, 0.58], [1.9, 0, 0.58, 0.34, 0.4], [2.4, 0, 1, 0.28, 0.3], [2.95, 0, 1.3, 0.27, 0.27],
        [3.4, 0, 1.35, 0.24, 0.25],
    ], 54);
    const body = loft(16, spine);
    const below = row => [row[0], row[1], row[2] - 0.16 * row[4], 0.72 * row[3], 0.9 * row[4]];
    const belly = loft(12, spine.slice(14, 52).filter((_, i) => i % 2 === 0).map(below));

    const tailTip = blade([
        [[-4, 0.2, 0.12]],
        [[-4.05, 0.6, 0.14], [-4.1, 0.2, 0.16], [-4.05, -0.2, 0.14]],
        [[-4.28, 0.42, 0.2], [-4.28, 0.2, 0.22], [-4.28, -0.02, 0.2]],
        [[-4.5, 0.2, 0.28]],
    ], 0.12);
    const backSpike = spike(4, 0.1, [-0.13, 0, 0.32], 20);
    const spikes = spine.slice(4, 52).filter((_, i) => i % 2 === 0).map((row, i) =>
        part(`back spike ${i + 1}`, "horn", backSpike,
            move(row[0], row[1], row[2] + 0.94 * row[4]), scale(0.7 + row[4], 0.6 + row[4], 0.6 + 1.1 * row[4])));

    const limb = leg();
    return [
        part("body", "dragon", body),
        part("belly", "dragon_belly", belly),
        part("tail tip", "membrane", tailTip),
        ...spikes,
        group("head", [move(3.35, 0, 1.36), turn("y", 8)], ...head()),
        ...pair("wing", wing()),
        ...pair("foreleg", group("hip", [move(0.95, 0.4, -0.15)], limb)),
        ...pair("hind leg", group("hip", [move(-0.95, 0.42, -0.2), scale(1.15)], limb)),
    ];
}

/** The head, looking along x from the end of the neck. */
function head() {
    const skull = loft(14, smooth([
        [-0.3, 0, 0.02, 0, 0], [-0.2, 0, 0.03, 0.22, 0.2], [0.05, 0, 0.07, 0.33, 0.27], [0.35, 0, 0.05, 0.29, 0.22],
        [0.65, 0, 0, 0.2, 0.13], [0.95, 0, -0.01, 0.19, 0.12], [1.1, 0, -0.02, 0.11, 0.07], [1.14, 0, -0.02, 0, 0],
    ], 15));
    const jaw = loft(10, smooth([
        [-0.1, 0, -0.14, 0, 0], [0, 0, -0.16, 0.22, 0.1], [0.5, 0, -0.28, 0.16, 0.07], [0.9, 0, -0.34, 0.12, 0.05],
        [1, 0, -0.35, 0, 0],
    ], 9));
    const horn = loft(8, smooth([
        [0, 0.16, 0.22, 0.09, 0.09], [-0.25, 0.22, 0.42, 0.075, 0.075], [-0.55, 0.27, 0.5, 0.045, 0.045],
        [-0.85, 0.27, 0.62, 0, 0],
    ], 7));
    const ear = blade([
        [[0, 0.28, 0.06]],
        [[-0.12, 0.42, 0.16], [-0.16, 0.42, 0.06], [-0.2, 0.4, -0.04]],
        [[-0.5, 0.6, 0.12]],
    ], 0.05);
    const tooth = spike(4, 0.035, [0.01, 0, -0.13], 20);
    return [
        part("skull", "dragon", skull),
        part("jaw", "dragon_belly", jaw),
        ...pair("face",
            part("horn", "horn", horn),
            part("ear", "membrane", ear),
            part("eye", "glow", ellipsoid(8, 3, 0.09, 0.05, 0.07), move(0.34, 0.235, 0.15)),
            part("pupil", "black", ellipsoid(6, 1, 0.035, 0.03, 0.06), move(0.37, 0.275, 0.155)),
            part("brow", "dragon", ellipsoid(8, 3, 0.17, 0.07, 0.05), move(0.3, 0.22, 0.235), turn("y", 14)),
            part("nostril", "black", ellipsoid(6, 1, 0.045, 0.03, 0.03), move(1.02, 0.09, 0.07)),
            ...[0.95, 0.8, 0.65, 0.5].map((x, i) =>
                part(`tooth ${i + 1}`, "ivory", tooth, move(x, 0.2 - 0.09 * (x - 0.5), -0.06))),
        ),
    ];
}

/** The left wing: an arm to the wrist, fingers spread from there, and a skin between fingers and flank. */
function wing() {
    const shoulder = [0.8, 0.35, 0.5];
    const elbow = [0.35, 1.3, 0.95];
    const wrist = [1.2, 2.3, 1.3];
    const tips = [[-0.9, 5, 1.3], [-2.1, 4, 0.75], [-2.35, 2.75, 0.5], [-1.9, 1.5, 0.35], [-1.2, 0.35, 0.25]];

    // The skin is a fan about the wrist. Between two fingers its edge is drawn in and it sags.
    const perGap = 8;
    const rim = [...tips, shoulder];
    const edge = rim.slice(1).flatMap((tip, gap) => Array.from({ length: perGap }, (_, i) => {
        const t = i / perGap;
        const drawn = gap < tips.length - 1 ? 1 - 0.9 * t * (1 - t) : 1;
        return { t, drawn, at: rim[gap].map((value, axis) => value + t * (tip[axis] - value)) };
    }));
    edge.push({ t: 0, drawn: 1, at: shoulder });
    const steps = 7;
    const grid = [[wrist]];
    for (let step = 1; step <= steps; step++) {
        const r = step / steps;
        grid.push(edge.map(({ t, drawn, at }) => {
            const point = wrist.map((value, axis) => value + r * drawn * (at[axis] - value));
            point[2] -= 0.7 * t * (1 - t) * r;
            return point;
        }));
    }

    const between = (a, b, t, rise) => a.map((value, axis) => value + t * (b[axis] - value) + (axis === 2 ? rise : 0));
    const finger = tip => loft(5, smooth([
        [...wrist, 0.1, 0.1], [...between(wrist, tip, 0.5, 0.06), 0.07, 0.07], [...tip, 0.02, 0.02],
    ], 8));
    return group("limb", [],
        part("skin", "membrane", blade(grid, 0.04)),
        part("upper arm", "dragon", loft(8, smooth([
            [...shoulder, 0.24, 0.24], [...between(shoulder, elbow, 0.5, 0), 0.2, 0.2], [...elbow, 0.15, 0.15],
        ], 7))),
        part("forearm", "dragon", loft(8, rounded(smooth([[...elbow, 0.15, 0.15], [...wrist, 0.12, 0.12]], 6)))),
        ...tips.slice(0, 4).map((tip, i) => part(`finger ${i + 1}`, "dragon", finger(tip))),
        part("thumb", "horn", spike(6, 0.09, [0.4, 0.12, 0.1]), move(1.28, 2.34, 1.22)),
    );
}

/** A left leg, drawn up as in flight, from the hip at the origin. */
function leg() {
    const thigh = loft(8, rounded(smooth([
        [0.05, 0.05, 0.05, 0.24, 0.34], [-0.05, 0.16, -0.3, 0.2, 0.26], [0.12, 0.2, -0.62, 0.13, 0.15],
    ], 6)), { front: [1, 0, 0] });
    const shin = loft(8, smooth([
        [0.15, 0.2, -0.58, 0.12, 0.13], [-0.12, 0.21, -0.84, 0.1, 0.1], [-0.3, 0.22, -1.02, 0.09, 0.09],
    ], 6), { front: [1, 0, 0] });
    const toe = loft(6, [
        [-0.06, 0, 0, 0, 0], [0, 0, 0, 0.07, 0.06], [0.16, 0, -0.02, 0.065, 0.055], [0.25, 0, -0.06, 0, 0],
    ]);
    const claw = spike(4, 0.045, [0.16, 0, -0.07], 20);
    return group("limb", [],
        part("thigh", "dragon", thigh),
        part("shin", "dragon", shin),
        ...[-28, 0, 28].map((heading, i) => group(`toe ${i + 1}`, [move(-0.3, 0.22, -1.06), turn("z", heading)],
            part("joint", "dragon", toe),
            part("claw", "horn", claw, move(0.19, 0, -0.03)),
        )),
    );
}
