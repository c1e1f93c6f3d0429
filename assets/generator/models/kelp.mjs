import { move, part } from "../scene.mjs";
import { ellipsoid, loft } from "../shapes.mjs";

/** Kelp adrift on the water: two long wavy fronds that grow from one holdfast; lengths in centimetres. */
export function kelp() {
    // Half widths from root to tip.
    const widths = [0, 1.4, 2.7, 3.5, 3.9, 4, 3.9, 3.6, 3.1, 2.2, 0];
    const frond = (length, waves, phase) => loft(3, widths.map((width, i) => {
        const t = i / (widths.length - 1);
        const angle = phase + 2 * Math.PI * waves * t;
        const swing = Math.min(1, 3.5 * t);
        return [length * t, 5 * swing * Math.sin(angle), 2.6 * swing * Math.cos(angle + phase), width / 3.5, width];
    }), { front: [0, 1, 0], crease: 30 });

    return [
        part("holdfast", "bark", ellipsoid(8, 1, 3.6, 3.6, 2.6), move(-46.6, 0, 0)),
        part("long frond", "bright_kelp", frond(97, 1.9, 0.3), move(-46, 0, 0)),
        part("short frond", "kelp", frond(84, 1.7, 3.4), move(-46, 0, 0)),
    ];
}
