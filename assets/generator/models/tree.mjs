import { move, part, scale, turn } from "../scene.mjs";
import { ellipsoid, loft, lumpy } from "../shapes.mjs";

/** An apple tree: a trunk with roots and boughs under a crown of leafy clumps; lengths in feet. */
export function tree() {
    const trunk = loft(8, [
        [0, 0, 0, 2, 2], [0, 0, 0.9, 1.45, 1.45], [0.1, 0, 3, 1.1, 1.1], [0.2, 0.1, 6.5, 0.95, 0.95],
        [0, 0.1, 10, 0.85, 0.85], [-0.1, 0, 15, 0, 0],
    ], { front: [1, 0, 0] });
    const root = loft(5, [[0.5, 0, 1.1, 0.6, 0.8], [1.9, 0, 0.45, 0.5, 0.45], [3.4, 0, 0, 0, 0]]);
    const bough = loft(5, [
        [0, 0, 6.5, 0.5, 0.5], [1.4, 0, 8.4, 0.5, 0.5], [2.6, 0, 10.6, 0.35, 0.35], [3, 0, 12, 0, 0],
    ], { front: [1, 0, 0] });

    const clump = (size, phase) => lumpy(ellipsoid(10, 3, size, size, size * 0.85), 0.07, phase);
    const apple = ellipsoid(4, 1, 0.5, 0.5, 0.5);

    return [
        part("trunk", "bark", trunk),
        ...[20, 95, 165, 235, 300].map((heading, i) => part(`root ${i + 1}`, "bark", root, turn("z", heading))),
        ...[60, 180, 300].map((heading, i) => part(`bough ${i + 1}`, "bark", bough, turn("z", heading))),
        part("crown", "leaf", lumpy(ellipsoid(10, 5, 3.9, 3.9, 5.2), 0.04, 1), move(0, 0, 15.6)),
        ...[[0, 2.2, 11.4], [72, 2.1, 12.4], [144, 2.2, 11.2], [216, 2.1, 12.2], [288, 2.2, 11.6]]
            .map(([heading, out, z], i) => part(`lower clump ${i + 1}`, i % 2 ? "bright_leaf" : "leaf",
                clump(2.9, i), turn("z", heading), move(out, 0, z), scale(1, 1, 0.9))),
        ...[[40, 2.1, 16.2], [160, 2.1, 17], [280, 2.1, 15.8]]
            .map(([heading, out, z], i) => part(`upper clump ${i + 1}`, i % 2 ? "leaf" : "bright_leaf",
                clump(2.75, i + 6), turn("z", heading), move(out, 0, z))),
        part("top", "bright_leaf", clump(2.9, 9), move(0.2, 0.1, 19.4)),
        ...[[10, 4.6, 11.4], [50, 4.3, 15.6], [85, 4.3, 12.8], [130, 4.2, 11.4], [165, 4.4, 15.9], [215, 4.6, 12],
            [255, 4.1, 15.2], [320, 4.1, 13.4]]
            .map(([heading, out, z], i) => part(`apple ${i + 1}`, "trim", apple, turn("z", heading), move(out, 0, z))),
    ];
}
