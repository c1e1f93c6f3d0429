#!/usr/bin/env python3
"""Makes the reference answers for the fits: the minima, and what the thesis's algorithms give.

    python3 fits.py [--prepared ../../bin/test-models] [--fixtures ../fixtures] [--only NAME ...] [--processes 2]

Writes fits.json and pointsets/*.txt ("x y z" lines; read back before anything is computed). fits.json says itself what
its fields are (FIELDS below). Prints, per set, the thesis's volumes over the smallest ones.
"""
import argparse
import itertools
import json
import math
import multiprocessing
import os
import time

import miniball
import numpy as np

from minima import (ball_volume, box_along, capsule_volume, distance_to_segment, hull_points, min_ball, min_box,
                    min_capsule, min_rectangle, min_z_box, rank_of, unit)
from models import MODELS, PREPARED, Model

SEED = 20150701
HERE = os.path.dirname(os.path.abspath(__file__))

FIELDS = {
    "source": "points: a file of pointsets/; formula: computed; model: one of the placements' models, normalised",
    "rank": "0 a point, 1 on a line, 2 in a plane, 3 in space; below 3 the smallest box's volume is 0, below 2 the"
            " smallest capsule's",
    "smallest.sphere": "exact; certificate: how far the farthest point sticks out and how far the centre is from the"
                       " hull of the points on the sphere, relative to the radius: 0 and 0 prove it the smallest",
    "smallest.box": "volume: the smallest found; lowerBound: certified, no box is smaller",
    "smallest.zBox": "the smallest box with one axis along z, exact",
    "smallest.capsule": "the smallest known; lowerBound: a sampled estimate, not a proof",
    "thesis": "degrees in steps of 10 from 0 to 80",
    "thesis.ritterSphere": "starts from the two extreme vertices of the longest coordinate range (the first of equal"
                           " ones), then one pass in order; null where the order of the vertices is not the file's",
    "thesis.orientedBox": "xyz: the points turned about x, then y, then z; zyx: about z, then y, then x; volume"
                          " smallest over all 729",
    "thesis.capsule": "of the oriented box (xyz); z: of the z-aligned box. Axis: the box's longest, through its centre;"
                      " radius: the farthest vertex from it; ends: from where the caps touch the box's ends inside,"
                      " moved out until each vertex is covered. low and high: over all boxes of the smallest volume and"
                      " all of their longest axes, to 1e-9, for which one is taken is up to rounding",
    "thesis.cylinder": "of the same boxes' axes, radius as the capsule's, from end to end of the box",
}


# ---------------------------------------------------------------------------------------------------- the point sets
def ring(n, radius, z, start=0.0):
    angles = start + 2 * math.pi * np.arange(n) / n
    return np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.full(n, float(z))])


def corners(x, y, z):
    return np.array(list(itertools.product((-x, x), (-y, y), (-z, z))), float)


def random_rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def point_sets():
    """name -> points, those that a file is written of"""
    rng = np.random.default_rng(SEED)

    def turned(points):
        return points @ random_rotation(rng).T

    def on_sphere(n):
        v = rng.normal(size=(n, 3))
        return v / np.linalg.norm(v, axis=1)[:, None]

    helix = 2 * math.pi * 9 * np.linspace(0, 1, 361)
    tetrahedron = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1.0]]) * 0.5
    corner_shape = [(0, 0), (1, 0), (1, .25), (.25, .25), (.25, .8), (0, .8)]
    i, j = np.mgrid[-3:4, -2:3].reshape(2, -1)
    return {
        # as the built-in models: in a unit square, on the ground
        "cube": np.repeat(corners(.5, .5, .5) + [0, 0, .5], 3, axis=0),
        "cylinder": np.vstack([ring(32, .5, 0), ring(32, .5, 1.131)]),
        "sphere 32x16": np.vstack([[[0, 0, 0]]] + [ring(32, .5 * math.sin(math.pi * k / 16),
                                                       .5 - .5 * math.cos(math.pi * k / 16)) for k in range(1, 16)]
                                  + [[[0, 0, 1.0]]]),
        # degenerate
        "one point": np.array([[0.25, -1.5, 3.0]]),
        "one point, repeated": np.array([[0.25, -1.5, 3.0]] * 6),
        "two points": np.array([[-0.5, 0.25, 0.125], [0.75, -0.5, 1.0]]),
        "line along x": np.column_stack([np.linspace(-0.5, 0.5, 9), np.zeros(9), np.zeros(9)]),
        "line": np.outer([-8, -5, -1, 0, 3, 4, 7, 8], [3, -2, 1]) / 16.0 + [0.5, 0, 1],
        "plane": (np.outer(i, [2, 1, -1]) + np.outer(j, [1, -1, 3])) / 16.0 + [0, 0, 1],
        "coplanar polygon": ring(7, .5, 0.25, 0.3),
        "duplicates": np.repeat(turned(tetrahedron), 5, axis=0)[rng.permutation(20)],
        "nearly coplanar": turned(np.column_stack([rng.uniform(-.5, .5, 200), rng.uniform(-.3, .3, 200),
                                                   rng.normal(size=200) * 1e-4])),
        "nearly collinear": turned(np.column_stack([rng.uniform(-.5, .5, 200), rng.normal(size=(200, 2)) * 1e-4])),
        # shapes
        "turned cube": turned(corners(.5, .5, .5)),
        "thin turned box": turned(np.vstack([corners(.5, .15, .01), rng.uniform(-1, 1, (200, 3)) * [.5, .15, .01]])),
        "tetrahedron": turned(tetrahedron),
        "cone": turned(np.vstack([ring(64, .4, 0), [[0, 0, 1.0]]])),
        "long helix": turned(np.column_stack([.2 * np.cos(helix), .2 * np.sin(helix), np.linspace(-1.5, 1.5, 361)])),
        "L": turned(np.array([[x, y, z] for x, y in corner_shape for z in (0, .25)])),
        "cross": turned(np.vstack([corners(.5, .1, .1), corners(.1, .5, .1), corners(.1, .1, .5)])),
        "capsule": turned(np.vstack([p * .2 + np.sign(p[2]) * np.array([0, 0, .4]) for p in on_sphere(500)])),
        # clouds
        "points on a sphere": on_sphere(300) * .5,
        "uniform cloud": rng.uniform(-.5, .5, (400, 3)),
        "normal cloud": turned(rng.normal(size=(400, 3)) * [.3, .12, .05]),
        "clusters": np.vstack([rng.uniform(-1, 1, 3) + rng.normal(size=(60, 3)) * .05 for _ in range(6)]),
        "tiny": turned(rng.uniform(-1, 1, (60, 3)) * [3e-4, 2e-4, 1e-4]),
        "huge": turned(rng.uniform(-1, 1, (60, 3)) * [3e4, 2e4, 1e4]),
        "far from the origin": turned(rng.uniform(-.5, .5, (60, 3)) * [1, .6, .3]) + [7e3, -6e3, 2e3],
    }


FORMULA = ("point i of n = 100000: u = fraction(i * 0.8191725133961645), v = fraction(i * 0.6710436067037893),"
           " w = fraction(i * 0.5497004779019703); x = u - 0.5, y = 0.6 * (v - 0.5) + 0.2 * x, z = 0.3 * (w - 0.5)")


def by_formula():
    i = np.arange(100000.0)
    u, v, w = (i * a - np.floor(i * a) for a in (0.8191725133961645, 0.6710436067037893, 0.5497004779019703))
    x = u - 0.5
    return np.column_stack([x, 0.6 * (v - 0.5) + 0.2 * x, 0.3 * (w - 0.5)])


def file_of(name):
    return "pointsets/%s.txt" % "".join(c if c.isalnum() else "-" for c in name).replace("--", "-")


def read_points(path):
    return np.loadtxt(path, ndmin=2)


# --------------------------------------------------------------------------------------------- the thesis's algorithms
def naive_sphere(points):
    centre = (points.min(0) + points.max(0)) / 2
    return centre, np.linalg.norm(points - centre, axis=1).max()


def ritter_sphere(points):
    k = int(np.argmax(np.ptp(points, axis=0)))
    a, b = points[np.argmin(points[:, k])], points[np.argmax(points[:, k])]
    centre, radius = (a + b) / 2, np.linalg.norm(a - b) / 2
    for p in points:
        distance = np.linalg.norm(p - centre)
        if distance > radius:
            radius, centre = (radius + distance) / 2, centre + (p - centre) * ((distance - radius) / (2 * distance))
    return centre, radius


def rotation_about(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    m = np.eye(3)
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    m[i, i], m[i, j], m[j, i], m[j, j] = c, -s, s, c
    return m


def stepped_boxes(points, order, step=10):
    """All boxes of the points turned by multiples of step in [0, 90) about the axes, in the given order."""
    turns = [np.eye(3)]
    for axis in order:
        about = [rotation_about("xyz".index(axis), d) for d in range(0, 90, step)]
        turns = [r @ m for m in turns for r in about]
    return [box_along(points, m) for m in turns]


def smallest_boxes(boxes, size):
    """Those of the smallest volume, to rounding."""
    least = min(b[0] for b in boxes)
    return [b for b in boxes if b[0] <= least * (1 + 1e-9) + 1e-13 * size ** 3]


def longest_axes(box):
    return [k for k in range(3) if box[3][k] >= box[3].max() * (1 - 1e-9)]


def grown_capsule(points, box, k):
    _, centre, axes, half = box
    along = (points - centre) @ axes[k]
    off2 = ((points - centre - np.outer(along, axes[k])) ** 2).sum(1)
    radius = math.sqrt(off2.max())
    inner = max(0.0, half[k] - radius)
    cap = np.sqrt(np.maximum(radius * radius - off2, 0))
    low, high = min(-inner, (along + cap).min()), max(inner, (along - cap).max())
    start, end = centre + low * axes[k], centre + high * axes[k]
    assert distance_to_segment(points, start, end)[0].max() <= radius * (1 + 1e-9) + 1e-12 * np.abs(points).max()
    return capsule_volume(high - low, radius)


def cylinder_of(points, box, k):
    _, centre, axes, half = box
    q = points - centre
    off2 = (q * q).sum(1) - (q @ axes[k]) ** 2
    return math.pi * max(0.0, off2.max()) * 2 * half[k]


def low_and_high(measure, points, boxes):
    volumes = [measure(points, b, k) for b in boxes for k in longest_axes(b)]
    return dict(low=min(volumes), high=max(volumes))


# --------------------------------------------------------------------------------------------------------- one set
def sphere_json(centre, radius):
    return dict(centre=np.asarray(centre).tolist(), radius=float(radius), volume=ball_volume(float(radius)))


def box_json(box):
    return dict(volume=float(box[0]), centre=np.asarray(box[1]).tolist(), axes=np.asarray(box[2]).tolist(),
                half=np.asarray(box[3]).tolist())


def flat_box(points, rank):
    """A box of volume 0 about points of a rank below 3."""
    directions = rank_of(points)[1] if rank else np.eye(3)
    if rank == 2:
        q = points @ directions.T
        angle = min_rectangle(np.ascontiguousarray(q[:, 0]), np.ascontiguousarray(q[:, 1]))[1]
        u = unit(math.cos(angle) * directions[0] + math.sin(angle) * directions[1])
        directions = np.array([u, np.cross(directions[2], u), directions[2]])
    _, centre, axes, half = box_along(points, directions)
    half[rank:] = 0.0
    return 0.0, centre, axes, half


def smallest(hull, rank):
    centre, radius, certificate = min_ball(hull)
    sphere = dict(sphere_json(centre, radius), certificate=[float(c) for c in certificate])
    try:
        sphere["miniball"] = math.sqrt(miniball.get_bounding_ball(hull - hull.mean(0), rng=np.random.default_rng(0))[1]) / radius
    except (np.linalg.LinAlgError, ZeroDivisionError):        # it gives up on points on one sphere
        sphere["miniball"] = None
    best = min_box(hull) if rank == 3 else (*flat_box(hull, rank), 0.0)
    if rank >= 2:
        capsule = min_capsule(hull, axes=best[2])
        assert distance_to_segment(hull, capsule[1], capsule[2])[0].max() <= capsule[3] * (1 + 1e-9)
    else:
        capsule = (0.0, hull[0], hull[-1], 0.0, 0.0)
    return dict(sphere=sphere, box=dict(box_json(best), lowerBound=float(best[4])), zBox=box_json(min_z_box(hull)),
                capsule=dict(volume=float(capsule[0]), start=capsule[1].tolist(), end=capsule[2].tolist(),
                             radius=float(capsule[3]), lowerBound=float(capsule[4])))


def thesis(points, hull, in_order):
    size = np.ptp(points, axis=0).max()
    oriented = {order: smallest_boxes(stepped_boxes(hull, order), size) for order in ("xyz", "zyx")}
    z_aligned = smallest_boxes(stepped_boxes(hull, "z"), size)
    return dict(
        naiveSphere=sphere_json(*naive_sphere(points)),
        ritterSphere=sphere_json(*ritter_sphere(points)) if in_order else None,
        axisAlignedBox=dict(volume=box_along(hull, np.eye(3))[0], low=points.min(0).tolist(),
                            high=points.max(0).tolist()),
        zAlignedBox=dict(volume=z_aligned[0][0]),
        orientedBox={order: boxes[0][0] for order, boxes in oriented.items()},
        capsule=dict(oriented=low_and_high(grown_capsule, hull, oriented["xyz"]),
                     z=low_and_high(grown_capsule, hull, z_aligned)),
        cylinder=dict(oriented=low_and_high(cylinder_of, hull, oriented["xyz"]),
                      z=low_and_high(cylinder_of, hull, z_aligned)))


def one_set(job):
    name, source, points, in_order = job
    started = time.time()
    hull = hull_points(points)
    rank = rank_of(hull)[0] if len(hull) > 1 else 0
    entry = dict(name=name, **source, vertices=len(points), hullVertices=len(hull), rank=rank,
                 smallest=smallest(hull, rank), thesis=thesis(points, hull, in_order))
    return entry, time.time() - started


def print_row(e, seconds):
    s, t = e["smallest"], e["thesis"]

    def over(a, b, size=max(e["thesis"]["naiveSphere"]["radius"], 1e-300)):
        return "%.4f" % (a / b) if b > 1e-12 * size ** 3 else "-"
    print("| %s | %d | %d | %d | %s | %.0f |" % (e["name"], e["vertices"], e["hullVertices"], e["rank"], " | ".join((
        over(t["naiveSphere"]["volume"], s["sphere"]["volume"]),
        over(t["ritterSphere"]["volume"], s["sphere"]["volume"]) if t["ritterSphere"] else "-",
        over(t["axisAlignedBox"]["volume"], s["box"]["volume"]),
        over(t["zAlignedBox"]["volume"], s["zBox"]["volume"]),
        over(t["orientedBox"]["xyz"], s["box"]["volume"]),
        over(t["capsule"]["oriented"]["low"], s["capsule"]["volume"]),
        over(s["box"]["volume"], s["box"]["lowerBound"]),
        over(s["capsule"]["volume"], s["capsule"]["lowerBound"]))), seconds), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--prepared", default=PREPARED)
    parser.add_argument("--fixtures", default=os.path.join(HERE, "..", "fixtures"))
    parser.add_argument("--only", nargs="*", help="compute and print these sets, write nothing")
    parser.add_argument("--processes", type=int, default=2)
    arguments = parser.parse_args()
    started = time.time()
    os.makedirs(os.path.join(arguments.fixtures, "pointsets"), exist_ok=True)
    jobs = []
    for name, points in point_sets().items():
        path = os.path.join(arguments.fixtures, file_of(name))
        if not arguments.only:
            np.savetxt(path, points + 0.0, fmt="%.9g")
        jobs.append((name, dict(source="points", file=file_of(name)), path, True))
    jobs.append(("100,000 points", dict(source="formula", formula=FORMULA), by_formula, True))
    for name, *_ in MODELS:
        jobs.append((name + " (model)", dict(source="model", model=name), name, None))
    loaded = []
    for name, source, where, in_order in jobs:
        if arguments.only and name not in arguments.only:
            continue
        if source["source"] == "model":
            model = Model(where, arguments.prepared)
            loaded.append((name, source, model.vertices, model.vertex_order_is_the_files))
        else:
            loaded.append((name, source, where() if callable(where) else read_points(where), in_order))
    print("| set | vertices | of the hull | rank | naive sphere / smallest | Ritter / smallest | axis-aligned box /"
          " smallest | z-aligned 10° / smallest z-aligned | oriented 10° / smallest | capsule of it / smallest known |"
          " smallest box / its bound | smallest capsule / its bound | s |")
    print("|" + "---|" * 13)
    entries = []
    with multiprocessing.Pool(arguments.processes) as pool:
        for entry, seconds in pool.imap(one_set, loaded):
            entries.append(entry)
            print_row(entry, seconds)
    if not arguments.only:
        with open(os.path.join(arguments.fixtures, "fits.json"), "w") as out:
            json.dump(dict(version=1, fields=FIELDS, sets=entries), out, indent=1)
            out.write("\n")
    print("%.0f s" % (time.time() - started))


if __name__ == "__main__":
    main()
