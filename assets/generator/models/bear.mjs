import { move, pair, part, turn } from "../scene.mjs";
import { ellipsoid, loft, rounded, spike } from "../shapes.mjs";

/** A brown bear that has risen on its hind legs, about 2 m tall; lengths in decimetres. */
export function bear() {
    const trunk = loft(12, [
        [-0.6, 0, 3.9, 0, 0], [-0.6, 0, 4.2, 1.9, 1.7], [-0.4, 0, 5.3, 3.3, 3.0], [-0.1, 0, 7.2, 3.9, 3.6],
        [-0.1, 0, 9.6, 3.6, 3.4], [-0.3, 0, 12, 3.1, 2.9], [-0.4, 0, 13.8, 2.4, 2.3], [-0.2, 0, 15, 1.5, 1.7],
        [-0.1, 0, 15.6, 0, 0],
    ], { front: [1, 0, 0] });
    const belly = ellipsoid(8, 3, 1.2, 2.7, 3.5);

    const skull = loft(12, [
        [-2.3, 0, 17, 0, 0], [-2, 0, 17, 1.4, 1.2], [-0.9, 0, 17, 2.2, 1.95], [0.4, 0, 16.9, 2.2, 1.9],
        [1.5, 0, 16.6, 1.6, 1.4], [2, 0, 16.4, 0, 0],
    ]);
    const muzzle = loft(8, [
        [0.8, 0, 16.2, 1.4, 1.2], [2.6, 0, 16.1, 1.05, 0.9], [3.6, 0, 16.1, 0.8, 0.7], [3.9, 0, 16.1, 0, 0],
    ]);

    const arm = loft(8, rounded([
        [-0.3, 2.5, 13.2, 1.3, 1.3], [0.6, 3.5, 11.6, 1.3, 1.3], [2.2, 3.9, 10.6, 1.1, 1.1], [3.3, 3.8, 11, 0.9, 1.1],
    ]), { front: [0, 0.4, 1] });
    const leg = loft(8, [
        [-0.6, 1.9, 7, 0, 0], [-0.5, 2, 6.4, 1.5, 1.7], [-0.2, 2.4, 4.4, 1.75, 2],
        [-0.3, 2.6, 2.2, 1.3, 1.4], [-0.4, 2.7, 0.3, 1.2, 1.2],
    ], { front: [1, 0, 0] });
    const foot = loft(8, [
        [-2.5, 2.8, -0.1, 0, 0], [-2.1, 2.8, 0.05, 1, 0.75], [0.6, 3, 0.2, 1.35, 0.9],
        [2.9, 3.3, 0.05, 1.5, 0.75], [3.7, 3.4, -0.1, 0, 0],
    ]);
    const claw = spike(3, 0.3, [0.95, 0, -0.3]);

    return [
        part("trunk", "brown_fur", trunk),
        part("belly", "light_fur", belly, move(2.62, 0, 8.5), turn("y", -4)),
        part("skull", "brown_fur", skull),
        part("muzzle", "light_fur", muzzle),
        part("nose", "black", ellipsoid(6, 2, 0.45, 0.55, 0.4), move(3.75, 0, 16.6)),
        part("tail", "brown_fur", ellipsoid(5, 2, 0.9, 0.7, 0.7), move(-3.4, 0, 5.5)),
        ...pair("eye", part("ball", "black", ellipsoid(6, 1, 0.4, 0.34, 0.4), move(1.55, 0.88, 17.65))),
        ...pair("ear",
            part("shell", "brown_fur", ellipsoid(8, 3, 0.45, 0.95, 0.95), move(-0.7, 1.75, 18.6), turn("x", -20)),
        ),
        ...pair("arm",
            part("sleeve", "brown_fur", arm),
            ...[-0.6, 0, 0.6].map((y, i) => part(`claw ${i + 1}`, "ivory", claw, move(4, 3.8 + y, 11.2))),
        ),
        ...pair("leg",
            part("thigh", "brown_fur", leg),
            part("foot", "brown_fur", foot),
            ...[-0.8, 0, 0.8].map((y, i) => part(`claw ${i + 1}`, "ivory", claw, move(3.3, 3.35 + y, -0.2))),
        ),
    ];
}
