import { asMatrix, group, move, pair, part, turn } from "../scene.mjs";
import { box, ellipsoid, extrusion, lathe, loft, rounded, smooth } from "../shapes.mjs";

const FRONT = { front: [1, 0, 0] };

/** A firefighter with helmet, air cylinder, axe and hose; lengths in decimetres. */
export function fireman() {
    const coat = loft(14, [
        [0, 0, 8.6, 2.75, 1.95], [0, 0, 10.2, 2.6, 1.85], [0, 0, 12, 2.5, 1.75], [0, 0, 14, 2.7, 1.8],
        [0, 0, 15.8, 2.9, 1.85],
        [0, 0, 17, 2.6, 1.6], [0, 0, 17.6, 1.4, 1.1],
    ], { ...FRONT, square: 0.4 });
    // A ring that stands out a little from the coat.
    const band = (name, colour, z, width, depth, height) => part(name, colour,
        loft(14, [[0, 0, z, width, depth], [0, 0, z + height, width, depth]], { ...FRONT, square: 0.4, crease: 40 }));

    return [
        part("coat", "coat", coat),
        band("hem stripe", "reflective", 8.9, 2.84, 2.02, 0.5),
        band("chest stripe", "reflective", 14.2, 2.84, 1.92, 0.5),
        band("belt", "boot", 11.4, 2.66, 1.9, 0.6),
        part("buckle", "steel", box(0.25, 0.9, 0.8), move(1.9, 0, 11.3)),
        part("collar", "boot", loft(10, [[0, 0, 17.1, 1.5, 1.3], [0.05, 0, 18.1, 1.2, 1.15]], FRONT)),
        group("head", [move(0.1, 0, 17.6)], ...head()),
        group("air cylinder", [move(-2.55, 0, 11.9)], ...airCylinder()),
        ...pair("arm", arm()),
        ...pair("leg", leg()),
        group("axe", [move(2.75, 3.95, 12.6), turn("z", -12), turn("x", -4)], ...axe()),
        group("hose", [], ...hose()),
    ];
}

/** The head with its helmet, from the neck at the origin. */
function head() {
    const face = loft(14, [
        [0.15, 0, 0, 0, 0], [0.15, 0, 0.15, 0.75, 0.75], [0.12, 0, 0.7, 1.15, 1.15], [0.05, 0, 1.6, 1.3, 1.32],
        [0, 0, 2.5, 1.3, 1.35], [0, 0, 3, 1.2, 1.25],
    ], FRONT);
    const dome = loft(14, [
        [-0.1, 0, 2.5, 1.5, 1.6], [-0.1, 0, 3.3, 1.5, 1.6], [-0.1, 0, 4, 1.2, 1.35], [-0.1, 0, 4.45, 0.7, 0.8],
        [-0.1, 0, 4.6, 0, 0],
    ], FRONT);
    const brim = loft(14, [
        [-0.4, 0, 2.3, 1.5, 1.8], [-0.4, 0, 2.35, 1.95, 2.4], [-0.4, 0, 2.6, 1.95, 2.4], [-0.3, 0, 2.8, 1.5, 1.7],
    ], FRONT);
    const crest = extrusion([
        [-1.55, 3.2], [-1.2, 3.2], [-0.9, 4], [0, 4.5], [0.9, 4], [1.3, 3.2], [1.6, 3.2], [1.2, 4.3], [0, 4.9],
        [-1.2, 4.3],
    ], 0.3);
    const badge = extrusion([[0, 0], [0.55, 0.5], [0.5, 1.2], [0, 1.45], [-0.5, 1.2], [-0.55, 0.5]], 0.25);
    return [
        part("face", "skin", face),
        part("dome", "helmet", dome),
        part("brim", "helmet", brim),
        part("crest", "helmet", crest, move(-0.1, -0.15, 0), turn("z", -90)),
        part("badge", "beak", badge, move(1.62, 0, 2.75), turn("y", -12)),
        part("nose", "skin", ellipsoid(8, 2, 0.28, 0.22, 0.3), move(1.38, 0, 1.35)),
        part("moustache", "hair", ellipsoid(10, 2, 0.22, 0.62, 0.2), move(1.25, 0, 0.95)),
        ...pair("face",
            part("eye", "reflective", ellipsoid(8, 2, 0.14, 0.25, 0.24), move(1.2, 0.48, 1.85), turn("z", 18)),
            part("pupil", "black", ellipsoid(5, 1, 0.12, 0.12, 0.14), move(1.31, 0.48, 1.85), turn("z", 18)),
            part("ear", "skin", ellipsoid(8, 2, 0.32, 0.18, 0.42), move(0.05, 1.33, 1.4)),
        ),
    ];
}

/** The cylinder of breathing air on the back, standing on the origin. */
function airCylinder() {
    const bottle = lathe(10, [
        [0, 0], [0.7, 0.2], [0.95, 0.7], [0.95, 4], [0.7, 4.6], [0.3, 4.9], [0.3, 5.2], [0, 5.2],
    ]);
    return [
        part("bottle", "beak", bottle),
        part("valve", "steel", box(0.4, 1.2, 0.35), move(0, 0, 5.1)),
        ...[1.2, 3.3].map((z, i) => part(`strap ${i + 1}`, "boot", lathe(10, [[1.03, 0], [1.03, 0.4]]), move(0, 0, z))),
    ];
}

/** The left arm, bent forward with the fist closed. */
function arm() {
    const sleeve = loft(10, smooth([
        [0, 2.3, 16.6, 0.9, 1], [0.05, 3, 15.9, 1.05, 1.1], [0.1, 3.75, 14.3, 0.95, 1], [0.35, 4.1, 12.8, 0.9, 0.9],
        [1.1, 4.1, 12.1, 0.82, 0.85], [2, 4, 12.3, 0.8, 0.8],
    ], 7), { front: [0.8, 0.2, 0.6] });
    const cuff = loft(10, [[1.6, 4.05, 12.2, 0.9, 0.9], [1.95, 4, 12.28, 0.9, 0.9]], { crease: 40 });
    const glove = loft(8, rounded([[1.9, 4, 12.3, 0.6, 0.6], [2.6, 3.95, 12.5, 0.8, 0.78]]));
    const finger = ellipsoid(6, 2, 0.2, 0.34, 0.22);
    return group("limb", [],
        part("sleeve", "coat", sleeve),
        part("cuff", "reflective", cuff),
        part("glove", "boot", glove),
        ...[-0.5, -0.15, 0.2].map((z, i) => part(`finger ${i + 1}`, "boot", finger, move(3.1, 3.8, 12.65 + z))),
    );
}

/** The left leg with its boot. */
function leg() {
    const trouser = loft(10, [
        [0, 1.2, 9.4, 1.2, 1.5], [0, 1.35, 8, 1.35, 1.5], [0.1, 1.7, 5.4, 1.2, 1.3], [0, 2, 2.6, 1.2, 1.3],
    ], { ...FRONT, square: 0.2 });
    const band = loft(10, [[0.05, 1.9, 3.7, 1.3, 1.38],
        [0.05, 1.83, 4.2, 1.3, 1.38]], { ...FRONT, square: 0.2, crease: 40 });
    const shaft = loft(10, [[0, 0, 0.3, 1.1, 1.2], [0, 0, 1.6, 1.1, 1.15], [0, 0, 3, 1.3, 1.4]], FRONT);
    const toe = loft(8, [
        [-1.3, 0, 0.8, 0, 0], [-1.2, 0, 0.8, 0.9, 0.7], [0.3, 0, 0.85, 1.1, 0.85], [1.9, 0, 0.65, 1.15, 0.65],
        [2.7, 0, 0.55, 0.8, 0.5], [2.9, 0, 0.5, 0, 0],
    ], { square: 0.4 });
    return group("limb", [],
        part("trouser", "coat", trouser),
        part("band", "reflective", band),
        group("boot", [asMatrix(move(0, 2.1, 0), turn("z", 14))],
            part("shaft", "boot", shaft),
            part("toe", "boot", toe),
        ),
    );
}

/** An axe, upright, held at the origin. */
function axe() {
    const haft = loft(8, rounded([[0, 0, -4, 0.2, 0.26], [0, 0, 6, 0.18, 0.22]]), FRONT);
    const bit = extrusion([[-0.3, 4.9], [0.3, 4.9], [1.5, 4.3], [1.7, 5.4], [1.5, 6.5], [0.3, 5.9],
        [-0.3, 5.9]], 0.36);
    const pick = extrusion([[-0.2, 5.1], [-0.2, 5.7], [-1.5, 5.2]], 0.26);
    return [
        part("haft", "wood", haft),
        part("bit", "steel", bit, move(0, -0.18, 0), turn("z", -90)),
        part("pick", "trim", pick, move(0, -0.13, 0), turn("z", -90)),
    ];
}

/** The hose: a nozzle in the right hand, and a tube that falls to the ground and trails behind. */
function hose() {
    const tube = loft(8, smooth([
        [3.1, -3.95, 12.5, 0.34, 0.34], [1.9, -4.4, 11.2, 0.34, 0.34], [0.9, -4.65, 8, 0.34, 0.34],
        [0.6, -4.55, 3.5, 0.34, 0.34],
        [-0.2, -4.3, 0.8, 0.34, 0.34], [-1.6, -4.1, 0.34, 0.34, 0.34], [-3.1, -4.1, 0.34, 0.34, 0.34],
    ], 14), { front: [0, 1, 0] });
    const nozzle = lathe(10, [[0.42, -0.4], [0.42, 0.6], [0.28, 0.9], [0.3, 1.3], [0.5, 1.8]], { crease: 40 });
    return [
        part("tube", "helmet", tube),
        part("nozzle", "steel", nozzle, move(2.8, -3.95, 12.55), turn("y", 84)),
    ];
}
