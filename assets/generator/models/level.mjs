import { group, move, part, turn } from "../scene.mjs";
import { box, ellipsoid, extrusion, frustum, lathe } from "../shapes.mjs";

const HALF_WIDTH = 40;
const CELL = 0.5;
/** Between these distances from the middle the plaza becomes hills. */
const [PLAZA, HILLS] = [24, 34];

/** A level to walk in: a plaza among hills, with stairs, ramps, a spiral, a house with a ridge, pillars, gates and walls; patches. */
export function level() {
    const pillar = lathe(32, Array.from({ length: 12 }, (_, ring) => [0.55 - 0.1 * Math.sin(ring / 11 * Math.PI), 0.4 * ring]));
    const gate = extrusion(frame(3, 2.2, 2.5, 24), 1);
    const dome = ellipsoid(32, 15, 2.5, 2.5, 2);
    const turns = count => Array.from({ length: count }, (_, i) => 360 * i / count);
    return [
        part("land", "bright_leaf", land()),
        ...turns(32).map((heading, i) => part(`pillar ${i + 1}`, "ivory", pillar, turn("z", heading), move(23, 0, -0.1))),
        ...turns(4).map((heading, i) => part(`gate ${i + 1}`, "stone", gate, turn("z", heading + 5.6), move(26, 0, -0.5))),
        ...turns(6).map((heading, i) => part(`dome ${i + 1}`, "roof", dome, turn("z", heading + 20), move(34, 0, heightAt(...around(heading + 20, 34))))),
        group("stairs", [move(4, 4, 0)], ...Array.from({ length: 12 }, (_, i) => part(`step ${i + 1}`, "stone", box(0.4, 3, 0.25 * (i + 1)), move(0.4 * i, 0, 0)))),
        part("landing", "dark_stone", box(3, 3, 3), move(10.1, 4, 0)),
        part("ramp", "light_fur", extrusion([[0, 0], [6, 0], [6, 3]], 3), turn("z", 180), move(-8.6, -11.5, 0)),
        part("steep ramp", "light_fur", extrusion([[0, 0], [2, 0], [2, 3]], 3), turn("z", 90), move(5.5, 10, 0)),
        ...Array.from({ length: 24 }, (_, i) => part(`spiral ${i + 1}`, "stone", box(3, 1.2, 0.25), move(-6, 6, 0.25 * i), turn("z", 15 * i), move(1.9, 0, 0))),
        part("spiral's post", "dark_stone", lathe(16, [[0.5, 0], [0.5, 7]]), move(-6, 6, 0)),
        group("house", [move(-6, -6, 0)],
            part("walls", "shirt", box(6, 4, 2)),
            part("roof", "roof", extrusion([[-2.4, 0], [2.4, 0], [0, 1.4]], 6.6), move(3.3, 0, 2))),
        ...[-1, 1].map((side, i) => part(`post ${i + 1}`, "steel", box(0.5, 0.5, 3), move(0, 10 + 0.8 * side, 0))),
        ...turns(12).map((heading, i) => part(`wall ${i + 1}`, "dark_stone", box(0.6, 5, 2.5), turn("z", heading + 15), move(19, 0, -0.1))),
        ...turns(8).map((heading, i) => part(`block ${i + 1}`, "horn", frustum(3, 3, 3.5, 2, 2), turn("z", heading + 40), move(37, 0, heightAt(...around(heading + 40, 37)) - 1), turn("z", 25 * i))),
    ];
}

/** The ground, a surface without an underside. */
function land() {
    const count = 2 * HALF_WIDTH / CELL + 1;
    const points = [];
    const faces = [];
    for (let row = 0; row < count; row++) {
        for (let column = 0; column < count; column++) {
            const [x, y] = [column * CELL - HALF_WIDTH, row * CELL - HALF_WIDTH];
            points.push([x, y, heightAt(x, y)]);
            if (row > 0 && column > 0) {
                const here = row * count + column;
                faces.push([here - count - 1, here - count, here], [here - count - 1, here, here - 1]);
            }
        }
    }
    return { points, faces, crease: 60 };
}

function heightAt(x, y) {
    const out = Math.min(1, Math.max(0, (Math.hypot(x, y) - PLAZA) / (HILLS - PLAZA)));
    return out * out * (3 - 2 * out) * (2 * Math.sin(x / 6) * Math.cos(y / 7) + 0.7 * Math.sin(y / 2.5 + x / 4));
}

function around(heading, radius) {
    const angle = heading * Math.PI / 180;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
}

/** The outline of a gate: two posts with a round arch between an outer and an inner radius, with so many steps along its curves. */
function frame(outer, inner, height, steps) {
    const curve = radius => Array.from({ length: steps + 1 }, (_, i) => [radius * Math.cos(Math.PI * i / steps), height + radius * Math.sin(Math.PI * i / steps)]);
    return [[outer, 0], ...curve(outer), [-outer, 0], [-inner, 0], ...curve(inner).reverse(), [inner, 0]];
}
