#!/usr/bin/env python3
"""Makes the test vectors of structures that move: when they touch for the first time, and where.

    python3 motion.py [--pairs ../fixtures/pairs] [--out ../fixtures/motion] [--every 1]

The structures are the pairs of pairs.py; a way is drawn for each, of the first past the second. Writes one file of fixed-length
little-endian records per pair of types, in the order of that pair's file, and manifest.json (see LAYOUT below).

The signed distance along a straight way is a convex function of time. Its first zero is found by cutting planes in double precision
and then proved in 60-digit arithmetic, for every record: it is above 0 1e-9 before the time, and not above 0 1e-9 after. A way
without a touch is proved by a plane with its whole on one side, and the second structure on the other.
"""
import argparse
import collections
import math
import os
import struct
import time

import mpmath
import numpy as np

from geometry import SHAPES, _dot, _exact_core, exact_signed_distance, signed_distance, unit
from manifest import read_manifest, write_manifest
from pairs import across, direction, log_uniform, sign

SEED = 20261120
HERE = os.path.dirname(os.path.abspath(__file__))
BAND = 1e-9             # of the sum of the bounding radii: ways that come as near to grazing are drawn again
PRECISION = 1e-9        # of a time
NORMAL_CLEAR = 1e-5     # how much another face must be off for the normal to be certain, of the sum of the bounding radii

LAYOUT = {
    "version": 1,
    "byteOrder": "little-endian, no header, no padding",
    "record": "offset x y z, way x y z, each a float32; time, depth, each a float64; normal x y z, each a float32",
    "offset": "from where the first structure of the pair stands to where it is at time 0",
    "way": "from there to where it is at time 1",
    "time": "of the first touch, within %g; 2 if there is none" % PRECISION,
    "depth": "at time 0, of structures that then touch: the length of the shortest translation that separates them; otherwise 0",
    "normal": "from the second to the first structure at that time, a unit vector; NaN where it is not unique, or hardly",
    "band": "no way comes nearer to grazing than %g of the sum of the bounding radii (sphere: radius; capsule: half its length + radius;"
            " box: length of its half-extents), nor is one as near to a touch at either end" % BAND,
    "families": "record i is of the family i modulo their number",
}


# --------------------------------------------------------------------------------------------------- the families
# Each returns where the first structure is to be at time 0, from where it stands, and its way.

def size_of(a, b):
    """What the ways go by: the sum of the bounding radii, or what counts of it where one is far smaller."""
    small, large = sorted((a.bounding_radius(), b.bounding_radius()))
    return small + large if small > 1e-3 * large else max(10 * small, 1e-6 * large)


def through(rng, at, way):
    """The way that is at a displacement at some time."""
    return at - rng.uniform(0.1, 0.9) * way, way


def near(a, b, rng, most):
    """A displacement of a to a place near b."""
    distance, _, u = signed_distance(a, b)
    return u * (rng.uniform(-1, 1) * most - distance)


def fam_random(rng, a, b, i):
    size = size_of(a, b)
    way = direction(rng) * size * log_uniform(rng, 0.1, 10)
    return near(a, b, rng, 0.7 * size) + direction(rng) * size * rng.uniform(0, 0.5) - rng.uniform(-0.3, 1.3) * way, way


def grazing(rng, a, b, target):
    size = size_of(a, b)
    distance, _, u = signed_distance(a, b)
    return through(rng, u * (target * size - distance), across(rng, u) * size * log_uniform(rng, 0.3, 10))


def fam_grazing_outside(rng, a, b, i):
    return grazing(rng, a, b, log_uniform(rng, 1e-8, 1e-6))


def fam_grazing_inside(rng, a, b, i):
    return grazing(rng, a, b, -log_uniform(rng, 1e-8, 1e-6))


def fam_starting_inside(rng, a, b, i):
    size = size_of(a, b)
    return near(a, b, rng, 0)  - signed_distance(a, b)[2] * size * log_uniform(rng, 1e-6, 0.1), \
        direction(rng) * size * log_uniform(rng, 0.1, 10)


def fam_ending_inside(rng, a, b, i):
    at, way = fam_starting_inside(rng, a, b, i)
    return at - way, way


def fam_parallel(rng, a, b, i):
    """Along an axis of either."""
    size = size_of(a, b)
    _, g, _ = (a, b)[i // 2 % 2].core()
    g = [v for v in g if np.linalg.norm(v) > 0]
    d = unit(g[rng.integers(len(g))]) if g else direction(rng)
    return through(rng, near(a, b, rng, 0.2 * size), d * size * log_uniform(rng, 0.3, 10) * sign(i))


def fam_edge_on(rng, a, b, i):
    """In the plane of the second's two longest axes, at its middle."""
    size = size_of(a, b)
    cb, g, _ = b.core()
    g = sorted(g, key=np.linalg.norm)[-2:]
    d = sum((rng.normal() * unit(v) for v in g if np.linalg.norm(v) > 0), np.zeros(3))
    if np.linalg.norm(d) == 0:
        d = direction(rng)
    return through(rng, cb - a.core()[0], unit(d) * size * log_uniform(rng, 3, 30))


def fam_fast(rng, a, b, i):
    """A hundred to a thousand sizes, into the midst of the second or just past."""
    size = size_of(a, b)
    return through(rng, near(a, b, rng, 0.1 * size), direction(rng) * size * log_uniform(rng, 100, 1000))


def fam_head_on(rng, a, b, i):
    """Up to the second, across what is nearest, as far as the touch or a little less or more."""
    size = size_of(a, b)
    distance, _, u = signed_distance(a, b)
    way = -u * size * log_uniform(rng, 0.1, 3)
    return -u * (distance - sign(i) * size * log_uniform(rng, 1e-6, 1e-2)) - way, way


def fam_no_motion(rng, a, b, i):
    return np.zeros(3), np.zeros(3)


FAMILIES = [("random", fam_random), ("grazing outside", fam_grazing_outside), ("grazing inside", fam_grazing_inside),
            ("starting inside", fam_starting_inside), ("ending inside", fam_ending_inside), ("parallel", fam_parallel),
            ("edge-on", fam_edge_on), ("fast", fam_fast), ("head-on", fam_head_on), ("random again", fam_random),
            ("no motion", fam_no_motion)]


# ------------------------------------------------------------------------------------------------------ the truth
def first_zero(at, slope_of):
    """(time, None) of the first zero in [0, 1] of a convex function that is above 0 at 0; (None, where it is least) without one.

    at(t) gives a value and the normal there; slope_of(normal) the slope. Cutting planes: the zero of the tangent from the left,
    and where the tangents of both sides meet."""
    low, (value, normal) = 0.0, at(0.0)
    slope, high = slope_of(normal), None
    for _ in range(200):
        if slope >= 0:
            return None, low
        step = low - value / slope
        if step > 1:
            if high is None:
                end_value, end_normal = at(1.0)
                if end_value > 0 and slope_of(end_normal) <= 0:
                    return None, 1.0
            return None, _least(at, slope_of, low, 1.0)
        if step <= low or value <= 0:
            return low, None
        middle = step
        new_value, new_normal = at(middle)
        new_slope = slope_of(new_normal)
        if new_value <= 0:
            return middle, None
        if new_slope >= 0:
            return None, _least(at, slope_of, low, middle)
        low, value, slope = middle, new_value, new_slope
    return low, None


def _least(at, slope_of, low, high):
    for _ in range(60):
        middle = (low + high) / 2
        if slope_of(at(middle)[1]) > 0:
            high = middle
        else:
            low = middle
    return high


def exact_support(shapes, u):
    """Over which c lies along u, where the two touch: the sum of the generators' projections and the radii."""
    total = mpmath.mpf(0)
    for s in shapes:
        _, g, r = _exact_core(s)
        total += r * mpmath.sqrt(_dot(u, u)) + sum(abs(_dot(u, v)) for v in g)
    return total


def is_separated(a, b, offset, way, u, margin):
    """Whether a plane across u is between b and the whole way of a, with a margin."""
    with mpmath.workdps(40):
        u = [mpmath.mpf(float(x)) for x in u]
        length = mpmath.sqrt(_dot(u, u))
        c = [x - y for x, y in zip(_exact_core(a)[0], _exact_core(b)[0])]
        start = [x + float(o) for x, o in zip(c, offset)]
        end = [x + float(w) for x, w in zip(start, way)]
        return min(_dot(u, start), _dot(u, end)) > exact_support((a, b), u) + margin * length


def exact_at(a, b, offset, way, t):
    """The signed distance at a time; the displacement is rounded once, far below what it is asked for."""
    return exact_signed_distance(Displaced(a, offset, way, t), b)


class Displaced:
    """A structure at a time of its way, for _exact_core: its centre is not rounded to a double."""
    def __init__(self, shape, offset, way, t):
        self.shape, self.kind = shape, shape.kind
        self.by = [mpmath.mpf(float(o)) + mpmath.mpf(float(t)) * mpmath.mpf(float(w)) for o, w in zip(offset, way)]

    def __getattr__(self, name):
        value = getattr(self.shape, name)
        if name in ("centre", "start", "end"):
            return [mpmath.mpf(float(x)) + y for x, y in zip(value, self.by)]
        return value


def normal_at(a, b, moved):
    """The normal where it is unique, else NaN."""
    distance, _, u = signed_distance(moved, b)
    (ca, ga, ra), (cb, gb, rb) = moved.core(), b.core()
    c, g = ca - cb, np.vstack([ga, gb])
    size = a.bounding_radius() + b.bounding_radius()
    if distance + ra + rb > NORMAL_CLEAR * size:
        return u                                                    # outside of the core
    faces = []
    for i in range(len(g)):
        for j in range(i):
            n = np.cross(g[i], g[j])
            length = np.linalg.norm(n)
            if length > 1e-9 * np.linalg.norm(g[i]) * np.linalg.norm(g[j]) and length > 0:
                n = n / length
                faces.append((abs(n @ c) - np.abs(g @ n).sum(), n * (1 if n @ c >= 0 else -1)))
    faces.sort(key=lambda f: -f[0])
    if not faces or max(np.abs(g @ f[1]).sum() for f in faces) < NORMAL_CLEAR * size:
        return np.full(3, np.nan)
    best, n = faces[0]
    unclear = abs(n @ c) < NORMAL_CLEAR * size                      # in the middle, either side will do
    for value, other in faces[1:]:
        unclear |= value > best - NORMAL_CLEAR * size and np.linalg.norm(other - n) > 1e-6
    return np.full(3, np.nan) if unclear else n


def truth(a, b, offset, way):
    """(time, depth, normal), or None if it is too near to grazing."""
    size = a.bounding_radius() + b.bounding_radius()
    band = BAND * size
    at_start = exact_at(a, b, offset, way, 0)
    if abs(at_start) <= band or abs(exact_at(a, b, offset, way, 1)) <= band:
        return None
    if at_start < 0:
        return 0.0, -at_start, normal_at(a, b, a.moved(offset))
    if not way.any():
        return 2.0, 0.0, np.full(3, np.nan)

    def at(t):
        distance, _, u = signed_distance(a.moved(offset + t * way), b)
        return distance, u
    t, least = first_zero(at, lambda u: u @ way)
    if t is None:
        for u in (at(least)[1], at(max(0.0, least - 1e-7))[1], at(0.0)[1], at(1.0)[1]):
            if is_separated(a, b, offset, way, u, band):
                return 2.0, 0.0, np.full(3, np.nan)
        return None
    if t > 1 - 1e-8:
        return None
    before, after = max(t - PRECISION, 0.0), t + PRECISION
    if not (exact_at(a, b, offset, way, before) > 0 or t == 0) or exact_at(a, b, offset, way, after) > 0:
        return None
    # how deep it gets, at least: half way to the end of the touch is not far from the deepest
    deepest = min(at(s)[0] for s in np.linspace(t, min(1.0, t + 4 * size / max(np.linalg.norm(way), 1e-300)), 12))
    if deepest > -band:
        return None
    return t, 0.0, normal_at(a, b, a.moved(offset + t * way))


# ------------------------------------------------------------------------------------------------------ the driver
def read_pairs(folder, entry):
    first, second = (SHAPES[s] for s in entry["shapes"])
    dtype = np.dtype("<f8" if entry["numbers"] == "float64" else "<f4")
    n, m = first.count_of_numbers, second.count_of_numbers
    data = open(os.path.join(folder, entry["file"]), "rb").read()
    for i in range(entry["count"]):
        numbers = np.frombuffer(data, dtype, n + m, i * entry["recordBytes"]).astype(float)
        yield first.of_numbers(numbers[:n]), second.of_numbers(numbers[n:])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--pairs", default=os.path.join(HERE, "..", "fixtures", "pairs"))
    parser.add_argument("--out", default=os.path.join(HERE, "..", "fixtures", "motion"))
    parser.add_argument("--every", type=int, default=1, help="only every so manieth record, for a try: writes nothing")
    arguments = parser.parse_args()
    started = time.time()
    os.makedirs(arguments.out, exist_ok=True)
    manifest = dict(LAYOUT, seed=SEED, families=[name for name, _ in FAMILIES], files=[])
    print("| pair | records | drawn again | " + " | ".join(name for name, _ in FAMILIES) + " |")
    for k, entry in enumerate(read_manifest(arguments.pairs)["files"]):
        payload, counts = bytearray(), collections.Counter()
        for i, (a, b) in enumerate(read_pairs(arguments.pairs, entry)):
            if i % arguments.every:
                continue
            name, make = FAMILIES[i % len(FAMILIES)]
            rng = np.random.default_rng([SEED, k, i])
            found = None
            for attempt in range(30):
                offset, way = ([float(x) for x in np.asarray(v, np.float32)] for v in make(rng, a, b, i))
                offset, way = np.array(offset), np.array(way)
                found = truth(a, b, offset, way)
                if found is not None:
                    break
                counts["drawn again"] += 1
                if attempt > 9:
                    make = fam_random
            t, depth, normal = found
            counts["records"] += 1
            counts[name] += t <= 1
            counts[name, "all"] += 1
            counts["normals"] += t <= 1 and not np.isnan(normal[0])
            payload += struct.pack("<6f2d3f", *offset, *way, t, depth, *normal)
        print("| %s | %d | %d | %s |" % (entry["name"], counts["records"], counts["drawn again"], " | ".join(
            "%d" % round(100 * counts[name] / max(1, counts[name, "all"])) for name, _ in FAMILIES)), flush=True)
        manifest["files"].append(dict(name=entry["name"], file=entry["file"], count=counts["records"],
                                      touching=int(sum(counts[name] for name, _ in FAMILIES)), normals=int(counts["normals"])))
        if arguments.every == 1:
            with open(os.path.join(arguments.out, entry["file"]), "wb") as out:
                out.write(payload)
    if arguments.every == 1:
        write_manifest(arguments.out, manifest)
    print("%.0f s" % (time.time() - started))


if __name__ == "__main__":
    main()
