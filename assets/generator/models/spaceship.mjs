import { move, pair, part, turn } from "../scene.mjs";
import { ellipsoid, lathe, loft, spike } from "../shapes.mjs";

/** A small space fighter with swept wings, two engines and a bubble of a cockpit; metres. */
export function spaceship() {
    const fuselage = loft(10, [
        [5, 0, -0.1, 0, 0], [4.6, 0, -0.08, 0.2, 0.16], [3.5, 0, -0.03, 0.5, 0.38], [2.3, 0, 0.02, 0.75, 0.55],
        [1, 0, 0.06, 0.9, 0.67],
        [-0.6, 0, 0.08, 0.95, 0.72], [-2.6, 0, 0.08, 0.9, 0.7], [-4.2, 0, 0.06, 0.65, 0.5],
    ]);
    const nose = loft(10, [[5.06, 0, -0.1, 0, 0], [4.55, 0, -0.08, 0.27, 0.22], [4.2, 0, -0.07, 0.36, 0.28]]);
    // Wings and fins are thin lofts from root to tip: [.., half chord, half thickness].
    const wing = loft(6, [
        [-1.2, 0.5, -0.05, 2.1, 0.16], [-2.2, 1.8, -0.15, 1.35, 0.11], [-3.1, 3.0, -0.25, 0.7, 0.06],
    ]);
    const cannon = loft(6, [
        [-4.1, 3.05, -0.25, 0, 0], [-3.9, 3.05, -0.25, 0.17, 0.17], [-1.9, 3.05, -0.25, 0.17, 0.17],
        [-1.1, 3.05, -0.25, 0, 0],
    ]);
    const fin = loft(6, [
        [-3, 0.75, 0.4, 0.1, 1.1], [-3.6, 1.05, 1.2, 0.08, 0.75], [-4.1, 1.3, 1.72, 0.05, 0.45],
    ], { front: [1, 0, 0] });
    const engine = lathe(8, [[0.42, 0], [0.6, 0.5], [0.55, 2.2], [0.3, 2.9]], { crease: 40 });

    return [
        part("fuselage", "hull", fuselage),
        part("nose", "trim", nose),
        part("cockpit", "glass", ellipsoid(9, 3, 1.25, 0.52, 0.55), move(1.5, 0, 0.55), turn("y", 4)),
        ...pair("wing",
            part("panel", "hull", wing),
            part("cannon", "trim", cannon),
        ),
        ...pair("fin", part("panel", "trim", fin)),
        ...pair("engine",
            part("nacelle", "engine", engine, move(-4.7, 0.85, 0.05), turn("y", 90)),
            part("flame", "glow", spike(8, 0.36, [-0.35, 0, 0]), move(-4.65, 0.85, 0.05)),
        ),
    ];
}
