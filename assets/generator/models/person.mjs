import { group, move, pair, part, scale, turn } from "../scene.mjs";
import { ellipsoid, loft, rounded } from "../shapes.mjs";

const FRONT = { front: [1, 0, 0] };

/** A child with its arms held out, as tall as its arms span; lengths in decimetres (14.6 tall). */
export function person() {
    const shirt = loft(12, [
        [0, 0, 6.3, 1.35, 0.95], [0, 0, 7.2, 1.3, 0.92], [0, 0, 8.6, 1.4, 0.95], [0, 0, 9.8, 1.65, 1],
        [0, 0, 10.6, 1.5, 0.9],
        [0, 0, 11.1, 0.7, 0.6], [0, 0, 11.3, 0, 0],
    ], { ...FRONT, square: 0.4 });
    const hips = loft(12, [
        [0, 0, 5.1, 0.5, 0.5], [0, 0, 5.5, 1.25, 0.9], [0, 0, 6.5, 1.3, 0.92],
    ], { ...FRONT, square: 0.4 });
    const neck = loft(8, [[0, 0, 10.8, 0.5, 0.5], [0.05, 0, 11.9, 0.48, 0.48]], FRONT);
    const head = loft(12, [
        [0.15, 0, 11.3, 0, 0], [0.15, 0, 11.45, 0.6, 0.62], [0.1, 0, 11.9, 1.05, 1.08], [0.05, 0, 12.7, 1.25, 1.27],
        [0, 0, 13.5, 1.2, 1.24], [0, 0, 14.1, 0.85, 0.88], [0, 0, 14.4, 0, 0],
    ], FRONT);
    const hair = loft(12, [
        [-0.75, 0, 11.9, 0.85, 0.5], [-0.5, 0, 12.6, 1.35, 0.95], [-0.3, 0, 13.3, 1.42, 1.15],
        [-0.12, 0, 13.9, 1.25, 1.22], [-0.05, 0, 14.4, 0.8, 0.85], [0, 0, 14.6, 0, 0],
    ], FRONT);
    const fringe = ellipsoid(10, 3, 0.45, 1.05, 0.42);

    const sleeve = loft(8, [
        [0, 0, 0, 0.5, 0.6], [0.3, 0, 0, 0.68, 0.68], [1.1, 0, -0.05, 0.66, 0.66], [2, 0, -0.1, 0.7, 0.7],
    ]);
    const arm = loft(6, [
        [1.8, 0, -0.1, 0.45, 0.45], [2.8, 0, -0.1, 0.43, 0.43], [4.2, 0, -0.1, 0.34, 0.34], [4.7, 0, -0.1, 0.3, 0.3],
    ]);
    const palm = loft(6, rounded([[4.7, 0, -0.1, 0.4, 0.3], [5.3, 0, -0.12, 0.45, 0.28]]));
    const finger = loft(4, [[5.2, 0, -0.12, 0.13, 0.16], [5.9, 0, -0.16, 0.12, 0.14], [6.1, 0, -0.18, 0, 0]]);
    const thumb = loft(4, [[4.8, 0.2, -0.1, 0.16, 0.16], [5.3, 0.62, -0.12, 0.14, 0.14], [5.5, 0.7, -0.14, 0, 0]]);

    const trouserLeg = loft(8, [
        [0, 0.72, 6, 0.6, 0.75], [0, 0.8, 5, 0.76, 0.84], [0.05, 0.95, 3.2, 0.68, 0.74], [0, 1.1, 1, 0.66, 0.74],
    ], { ...FRONT, square: 0.2 });
    const shoe = loft(8, [
        [-0.85, 0, 0.5, 0, 0], [-0.75, 0, 0.55, 0.5, 0.5], [0.1, 0, 0.62, 0.62, 0.62], [1, 0, 0.42, 0.68, 0.42],
        [1.75, 0, 0.32, 0.52, 0.3], [1.95, 0, 0.28, 0, 0],
    ], { square: 0.4 });

    return [
        part("shirt", "shirt", shirt),
        part("hips", "trousers", hips),
        part("neck", "skin", neck),
        part("head", "skin", head),
        part("hair", "hair", hair),
        part("fringe", "hair", fringe, move(0.85, 0, 13.85), turn("y", 35)),
        part("nose", "skin", ellipsoid(6, 2, 0.22, 0.18, 0.22), move(1.3, 0, 12.5)),
        part("mouth", "trim", ellipsoid(8, 1, 0.12, 0.42, 0.1), move(1.12, 0, 11.97)),
        ...pair("face",
            part("eye", "reflective", ellipsoid(8, 2, 0.14, 0.24, 0.26), move(1.16, 0.45, 12.88), turn("z", 18)),
            part("pupil", "black", ellipsoid(6, 1, 0.1, 0.13, 0.15), move(1.27, 0.46, 12.86), turn("z", 18)),
            part("ear", "skin", ellipsoid(6, 2, 0.3, 0.15, 0.38), move(0, 1.27, 12.6)),
        ),
        ...pair("arm",
            group("limb", [move(0, 1.15, 10.2), turn("z", 90), turn("y", 17)],
                part("sleeve", "shirt", sleeve),
                part("forearm", "skin", arm),
                part("palm", "skin", palm),
                part("thumb", "skin", thumb, scale(1, -1, 1)),
                ...[-0.33, -0.11, 0.11, 0.33].map((y, i) => part(`finger ${i + 1}`, "skin", finger, move(0, y, 0))),
            ),
        ),
        ...pair("leg",
            part("trouser leg", "trousers", trouserLeg),
            part("shoe", "shoe", shoe, move(0, 1.15, 0), turn("z", 10)),
        ),
    ];
}
