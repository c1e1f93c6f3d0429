#!/usr/bin/env python3
"""Makes the test vectors of the six pair tests: pairs of shapes, easy and hard, with their exact signed distance.

    python3 pairs.py [--out ../fixtures/pairs] [--scale 1] [--processes 2]

Writes one file of fixed-length little-endian records per pair of types, and manifest.json, which describes them (see
LAYOUT below). Prints, per family, the share of colliding pairs and what the cross-checks say.

The truth is exact_signed_distance of the numbers as stored, for every record. Checked against it: the
double-precision method with its certificate, coal and FCL. Nothing depends on those three.
"""
import argparse
import collections
import math
import multiprocessing
import os
import struct
import time
import warnings

import coal
import fcl
import numpy as np

from geometry import Box, Capsule, Sphere, exact_signed_distance, quaternion_product, signed_distance, unit
from manifest import write_manifest

SEED = 20150522
HERE = os.path.dirname(os.path.abspath(__file__))
GRAZING = 1e-9          # of the larger shape's bounding radius: nearer to contact than this, no record is written

LAYOUT = {
    "version": 1,
    "byteOrder": "little-endian, no header, no padding",
    "record": "numbers of shape A, numbers of shape B, each of the file's number type; then the signed distance, a float64",
    "shapes": {
        "sphere": "centre x y z, radius",
        "capsule": "start x y z, end x y z, radius",
        "box": "centre x y z, quaternion w x y z, half-extents along the box's x y z axes",
    },
    "quaternion": "divide w x y z by sqrt(w*w + x*x + y*y + z*z) in double precision; then"
                  " axisX = (1-2(yy+zz), 2(xy+wz), 2(xz-wy)),"
                  " axisY = (2(xy-wz), 1-2(xx+zz), 2(yz+wx)),"
                  " axisZ = (2(xz+wy), 2(yz-wx), 1-2(xx+yy))",
    "signedDistance": "above 0: the gap; below 0: the depth, the shortest translation that separates the two",
    "grazing": "accept either answer where |signed distance| <= %g * the larger shape's bounding radius (sphere: radius;"
               " capsule: half its length + radius; box: length of its half-extents); no record is that near" % GRAZING,
    "families": "in the order of the records: [name, index of the first record, number of records]; in those named under"
                " float64Families the numbers need double precision, in all others they are exact in single precision",
}


# --------------------------------------------------------------------------------------------- random ingredients
def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def direction(rng):
    return unit(rng.normal(size=3))


def across(rng, d):
    """A random unit vector perpendicular to d."""
    return unit(np.cross(d, rng.normal(size=3)))


def axis_or_direction(rng, i):
    """One of the six axis directions for a third of the i, else any direction."""
    return direction(rng) if i % 3 else np.eye(3)[rng.integers(3)] * rng.choice((-1, 1))


def random_shape(rng, kind, size=1.0):
    """A shape about the origin; size bounds its reach (a box's, its half-extents)."""
    if kind == "sphere":
        return Sphere(np.zeros(3), size * rng.uniform(0.2, 1))
    if kind == "box":
        return Box(np.zeros(3), rng.normal(size=4), size * rng.uniform(0.1, 1, 3))
    d = direction(rng) * size * rng.uniform(0.05, 1)
    return Capsule(-d, d, size * rng.uniform(0.1, 0.6))


def sign(i):
    """-1 to collide, 1 not to: by turns, so that no family drifts to one side."""
    return -1 if i % 2 else 1


def touch(rng, i, size=1.0):
    return sign(i) * size * log_uniform(rng, 1e-6, 1e-3)


def touch_or_more(rng, i, size=1.0, most=0.2):
    return touch(rng, i, size) if i // 2 % 2 else sign(i) * size * log_uniform(rng, 1e-3, most)


def slid(a, b, target):
    """a moved along the shortest way between the two, by what is missing to the signed distance target."""
    distance, _, u = signed_distance(a, b)
    return a.moved(u * (target - distance))


# ---------------------------------------------------------------------------------------------------- the families
# Each returns (a, b, target): two shapes and the signed distance to bring them to, or None to leave them.

def fam_random(rng, kinds, i, size=1.0):
    a = random_shape(rng, kinds[0], size).moved(rng.normal(size=3) * size)
    b = random_shape(rng, kinds[1], size)
    a = slid(a, b, size * rng.uniform(-0.5, 0.5))
    shift = rng.normal(size=3) * size * 3
    return a.moved(shift), b.moved(shift), None


def fam_touching(rng, kinds, i, size=1.0):
    a, b, _ = fam_random(rng, kinds, i, size)
    return a, b, touch(rng, i, size)


def fam_tiny(rng, kinds, i):
    return (fam_random, fam_touching)[i // 2 % 2](rng, kinds, i, 1e-4)


def fam_huge(rng, kinds, i):
    return (fam_random, fam_touching)[i // 2 % 2](rng, kinds, i, 1e4)


def fam_mixed_scales(rng, kinds, i):
    """A shape of size 1e4 against one of 1e-4 at the origin, near contact by the small one's size."""
    large_first = i // 2 % 2 == 0
    large, small = kinds if large_first else kinds[::-1]
    small = random_shape(rng, small, 1e-4)
    large = random_shape(rng, large, 1e4).moved(direction(rng) * 4e4)
    large = slid(large, small, 0.0)
    target = sign(i) * 1e-4 * log_uniform(rng, 0.3, 1.5)
    return (large, small, target) if large_first else (small, large, target)


def fam_far(rng, kinds, i):
    """Shapes of size 1, 1e4 away from the origin."""
    a, b, target = (fam_random, fam_touching)[i // 2 % 2](rng, kinds, i)
    shift = direction(rng) * 1e4
    return a.moved(shift), b.moved(shift), target


def fam_containing(rng, kinds, i):
    """One wholly inside the other."""
    outer_first = i % 2 == 0
    outer, inner = kinds if outer_first else kinds[::-1]
    outer = random_shape(rng, outer, 2.0)
    _, g, r = outer.core()
    room = min(outer.half) if outer.kind == "box" else r
    inner = random_shape(rng, inner, room * 0.25)
    inner = inner.moved(rng.uniform(-0.5, 0.5, len(g)) @ g + direction(rng) * r * rng.uniform(0, 0.5))
    shift = rng.normal(size=3) * 2
    outer, inner = outer.moved(shift), inner.moved(shift)
    return (outer, inner, None) if outer_first else (inner, outer, None)


def fam_concentric(rng, kinds, i):
    shift = rng.normal(size=3)
    return random_shape(rng, kinds[0]).moved(shift), random_shape(rng, kinds[1]).moved(shift), None


def fam_zero_length(rng, kinds, i):
    """A capsule that is a point (one in four: of length 1e-12) against any shape, or against another such capsule."""
    def point():
        return Capsule(np.zeros(3), np.zeros(3) if i % 4 else 1e-12 * direction(rng), rng.uniform(0.1, 0.8))
    shapes = [point() if k == "capsule" else random_shape(rng, k) for k in kinds]
    if kinds == ("capsule", "capsule") and i // 4 % 3:
        shapes[i // 12 % 2] = random_shape(rng, "capsule")
    return shapes[0].moved(rng.normal(size=3) * 2), shapes[1], touch_or_more(rng, i)


def fam_zero_radius(rng, kinds, i):
    """A sphere that is a point, or a capsule that is a line; of two capsules or spheres one keeps its radius."""
    shapes = [random_shape(rng, k) for k in kinds]
    thin = i // 4 % 2 if kinds[1] != "box" else 0
    core = shapes[thin]
    shapes[thin] = (Sphere(core.centre, 0.0) if core.kind == "sphere" else Capsule(core.start, core.end, 0.0))
    return shapes[0].moved(rng.normal(size=3)), shapes[1], touch_or_more(rng, i, most=0.1)


# spheres and capsules

def fam_sphere_beside(rng, kinds, i):
    """A sphere nearest to the side of a capsule."""
    d, r, capsule_r = axis_or_direction(rng, i), rng.uniform(0.1, 1), rng.uniform(0.05, 0.6)
    low, high = rng.uniform(0.05, 1.5, 2)
    target = touch_or_more(rng, i, most=0.1)
    return (Sphere(across(rng, d) * (r + capsule_r + target), r), Capsule(-low * d, high * d, capsule_r), target)


def fam_sphere_past_end(rng, kinds, i):
    """A sphere nearest to an end of a capsule, from there to straight ahead of it."""
    d, r, capsule_r = axis_or_direction(rng, i), rng.uniform(0.1, 1), rng.uniform(0.05, 0.6)
    u = unit(d * rng.uniform(0.01, 1) + across(rng, d) * (rng.uniform(0, 1) if i % 5 else 0))
    target = touch_or_more(rng, i, most=0.1)
    return (Sphere(u * (r + capsule_r + target), r), Capsule(-rng.uniform(0.1, 2) * d, np.zeros(3), capsule_r), target)


def fam_through(rng, kinds, i):
    """A capsule whose segment passes through the other's core."""
    d, length = axis_or_direction(rng, i), rng.uniform(0.3, 2)
    capsule = Capsule(-length * d, length * d, rng.uniform(0.02, 0.5)).moved(d * length * rng.uniform(-0.9, 0.9))
    if kinds[0] == "capsule":
        return capsule, random_shape(rng, kinds[1]), None
    return random_shape(rng, kinds[0]), capsule, None


def _capsules_along(rng, i, d, e):
    """Two capsules with the directions d and e, side by side or past each other's end."""
    la, lb, ra, rb = *rng.uniform(0.1, 1, 2), *rng.uniform(0.1, 0.6, 2)
    shift = d * rng.uniform(-1.2, 1.2) * (la + lb) + across(rng, d) * rng.uniform(0, 1.5) * (ra + rb)
    s = sign(i // 2)
    return Capsule(-la * d, la * d, ra), Capsule(shift - s * lb * e, shift + s * lb * e, rb), touch_or_more(rng, i)


def fam_parallel_capsules(rng, kinds, i):
    d = axis_or_direction(rng, i)
    return _capsules_along(rng, i, d, d)


def fam_nearly_parallel_capsules(rng, kinds, i):
    """At an angle of 1e-9 to 1e-4."""
    d = axis_or_direction(rng, i)
    return _capsules_along(rng, i, d, d + across(rng, d) * log_uniform(rng, 1e-9, 1e-4))


def fam_collinear_capsules(rng, kinds, i):
    d = axis_or_direction(rng, i)
    la, lb, ra, rb = *rng.uniform(0, 1, 2), *rng.uniform(0.1, 0.6, 2)
    reach, s = la + lb + ra + rb, sign(i // 2)
    middle = d * (reach + (touch(rng, i) if i % 4 < 2 else rng.uniform(-1, 0.8) * reach))
    return Capsule(-la * d, la * d, ra), Capsule(middle - s * lb * d, middle + s * lb * d, rb), None


def fam_end_to_end(rng, kinds, i):
    """Two capsules nearest to each other at an end of each, where the lines through them may be nearest elsewhere."""
    return _capsules_at(rng, i, lambda u: unit(across(rng, u) + u * rng.uniform(0.01, 1.5)))


def fam_end_to_side(rng, kinds, i):
    return _capsules_at(rng, i, lambda u: across(rng, u))


def _capsules_at(rng, i, away):
    u, ra, rb, target = direction(rng), *rng.uniform(0.05, 0.6, 2), touch_or_more(rng, i)
    d, e = unit(across(rng, u) + u * rng.uniform(0.01, 1.5)), away(-u)
    p = u * (ra + rb + target)
    before = rng.uniform(0.1, 1) if abs(e @ u) < 1e-9 else 0.0
    a, b = Capsule(p, p + d * rng.uniform(0.1, 2), ra), Capsule(-before * e, e * rng.uniform(0.1, 2), rb)
    return (a, b, target) if i // 4 % 2 else (b, a, target)


# spheres and capsules at the features of a box

def _feature(rng, fixed_axes):
    """(box, point of it, outward direction): a point on a corner (3 fixed axes), an edge (2) or a face (1) of the box,
    and a unit direction in which the box has nothing farther out."""
    box = Box(np.zeros(3), rng.normal(size=4), rng.uniform(0.2, 1, 3))
    fixed = rng.permutation(3)[:fixed_axes]
    x = rng.uniform(-0.95, 0.95, 3)
    x[fixed] = rng.choice((-1, 1), fixed_axes)
    weight = np.zeros(3)
    weight[fixed] = x[fixed] * rng.uniform(0.15, 1, fixed_axes)
    return box, (x * box.half) @ box.axes(), unit(weight @ box.axes())


def _at_feature(rng, kinds, i, fixed_axes):
    box, point, u = _feature(rng, fixed_axes)
    r, target = rng.uniform(0.15, 0.6), touch_or_more(rng, i, most=0.1)
    centre = point + u * (r + target)
    if kinds[0] == "sphere":
        return Sphere(centre, r), box, target
    if i // 4 % 2:                              # the end of the capsule is the nearest
        d = rng.normal(size=3)
        return Capsule(centre, centre + (d if d @ u > 0 else -d), r), box, target
    d = across(rng, u)                          # its side
    return Capsule(centre - d * rng.uniform(0.2, 1), centre + d * rng.uniform(0.2, 1), r), box, target


def fam_box_corner(rng, kinds, i):
    return _at_feature(rng, kinds, i, 3)


def fam_box_edge(rng, kinds, i):
    return _at_feature(rng, kinds, i, 2)


def fam_box_face(rng, kinds, i):
    return _at_feature(rng, kinds, i, 1)


def fam_capsule_along_box(rng, kinds, i, tilt=0.0):
    """A capsule parallel to an axis of the box: beside an edge, a face or ahead of an end."""
    box = random_shape(rng, "box")
    if i % 3 == 0:
        box = Box(box.centre, np.eye(4)[rng.integers(4)], box.half)
    d = box.axes()[rng.integers(3)]
    d = d + across(rng, d) * tilt
    length = rng.uniform(0.1, 1)
    a = Capsule(-length * d, length * d, rng.uniform(0.05, 0.5)).moved(rng.normal(size=3))
    return a, box, touch_or_more(rng, i)


def fam_capsule_nearly_along_box(rng, kinds, i):
    """At an angle of 1e-9 to 1e-4 to an axis of the box."""
    return fam_capsule_along_box(rng, kinds, i, log_uniform(rng, 1e-9, 1e-4))


def fam_zero_extents(rng, kinds, i):
    """A box with one, two or three half-extents of zero: a rectangle, a line, a point."""
    h = rng.uniform(0.3, 1, 3)
    h[rng.permutation(3)[:1 + i // 4 % 3]] = 0.0
    return _with_box(rng, kinds, i, h)


def fam_thin_box(rng, kinds, i):
    """One or two half-extents of 1e-9 to 1e-3."""
    h = rng.uniform(0.3, 1, 3)
    for k in rng.permutation(3)[:1 + i // 4 % 2]:
        h[k] = log_uniform(rng, 1e-9, 1e-3)
    return _with_box(rng, kinds, i, h)


def _with_box(rng, kinds, i, half):
    box = Box(np.zeros(3), rng.normal(size=4), half)
    other = random_shape(rng, kinds[0])
    target = touch_or_more(rng, i, most=0.05)
    # two rectangles can cut through each other; with a line or a point instead, they could only touch
    if other.kind == "box" and np.count_nonzero(half) >= 2 and i // 12 % 3 == 0:
        other = Box(other.centre, other.quaternion, np.roll(half, rng.integers(3)) * rng.uniform(0.5, 1.5))
        target = touch(rng, i)
    return other.moved(rng.normal(size=3)), box, target


# two boxes

def fam_edge_to_edge(rng, kinds, i):
    """Edge against edge: only the cross product of the two separates."""
    while True:
        a, b = random_shape(rng, "box"), random_shape(rng, "box")
        ea, eb = rng.integers(3, size=2)
        axes_a, axes_b = a.axes(), b.axes()
        n = np.cross(axes_a[ea], axes_b[eb])
        if np.linalg.norm(n) < 0.05:
            continue
        n = unit(n)
        target = touch(rng, i) if i // 2 % 2 else sign(i) * log_uniform(rng, 1e-3, 0.05)
        sides_a, sides_b = -np.sign(axes_a @ n), np.sign(axes_b @ n)
        sides_a[ea], sides_b[eb] = rng.uniform(-0.9, 0.9, 2)
        a = a.moved((sides_b * b.half) @ axes_b + n * target - (sides_a * a.half) @ axes_a)
        g = np.vstack([a.core()[1], b.core()[1]])
        faces = g / np.linalg.norm(g, axis=1)[:, None]
        over_faces = (np.abs(faces @ a.centre) - np.abs(faces @ g.T).sum(1)).max()
        if over_faces < min(target, 0) - 2e-3:
            return a, b, target


def _box_at(rng, i, fixed_axes_a, fixed_axes_b):
    """Box a with a corner, edge or face at one of b, the outward directions opposite."""
    a, p, u = _feature(rng, fixed_axes_a)
    b, q, v = _feature(rng, fixed_axes_b)
    n = np.cross(u, -v)
    s, c = np.linalg.norm(n), u @ -v
    turn = unit(np.r_[1 + c, n]) if s > 1e-6 else np.array([1.0, 0, 0, 0])
    turned = Box(a.centre, quaternion_product(turn, unit(a.quaternion)), a.half)
    p = (p @ a.axes().T) @ turned.axes()
    target = touch_or_more(rng, i, most=0.1)
    return turned.moved(q + v * target - p), b, target


def fam_corner_to_face(rng, kinds, i):
    a, b, target = _box_at(rng, i, 3, 1)
    return (a, b, target) if i // 4 % 2 else (b, a, target)


def fam_edge_to_face(rng, kinds, i):
    a, b, target = _box_at(rng, i, 2, 1)
    return (a, b, target) if i // 4 % 2 else (b, a, target)


def fam_corner_to_corner(rng, kinds, i):
    return _box_at(rng, i, 3, 3)


def _boxes_turned(rng, i, turn):
    """A random box and one turned against it by the given quaternion."""
    a, b = random_shape(rng, "box"), random_shape(rng, "box")
    q = unit(b.quaternion) if i % 3 else np.array([1.0, 0, 0, 0])
    b = Box(b.centre, q, b.half)
    return Box(a.centre, quaternion_product(q, turn), a.half).moved(rng.normal(size=3)), b, touch_or_more(rng, i)


def fam_aligned_boxes(rng, kinds, i):
    return _boxes_turned(rng, i, np.array([1.0, 0, 0, 0]))


def _quarter_turns(rng):
    q = np.array([1.0, 0, 0, 0])
    for k in rng.integers(3, size=2):
        q = quaternion_product(unit(np.r_[1.0, np.eye(3)[k]]), q)
    return q


def fam_permuted_boxes(rng, kinds, i):
    """The same axes in another order, as exactly as double precision has it."""
    return _boxes_turned(rng, i, _quarter_turns(rng))


def fam_nearly_parallel_boxes(rng, kinds, i):
    """The same axes, some in another order, turned by 1e-9 to 1e-4."""
    tilt = unit(np.r_[1.0, direction(rng) * log_uniform(rng, 1e-9, 1e-4) / 2])
    return _boxes_turned(rng, i, tilt if i % 4 else quaternion_product(tilt, _quarter_turns(rng)))


ALL = [("random", fam_random, 18), ("touching", fam_touching, 16), ("tiny", fam_tiny, 6), ("huge", fam_huge, 6),
       ("mixed scales", fam_mixed_scales, 5), ("far from the origin", fam_far, 6), ("containing", fam_containing, 4),
       ("concentric", fam_concentric, 2)]
WITH_BOX = [("zero half-extents", fam_zero_extents, 7), ("thin box", fam_thin_box, 4)]
AT_BOX = [("at a box's corner", fam_box_corner, 8), ("at a box's edge", fam_box_edge, 8),
          ("at a box's face", fam_box_face, 5)]
# name of the pair: (records, its families with their weights)
PAIRS = {
    ("sphere", "sphere"): (2000, ALL + [("zero radius", fam_zero_radius, 4)]),
    ("sphere", "capsule"): (3500, ALL + [
        ("beside", fam_sphere_beside, 10), ("past the end", fam_sphere_past_end, 10), ("through", fam_through, 3),
        ("zero length", fam_zero_length, 7), ("zero radius", fam_zero_radius, 4)]),
    ("sphere", "box"): (4000, ALL + AT_BOX + WITH_BOX + [("zero radius", fam_zero_radius, 4)]),
    ("capsule", "capsule"): (4000, ALL + [
        ("parallel", fam_parallel_capsules, 12), ("nearly parallel", fam_nearly_parallel_capsules, 12),
        ("collinear", fam_collinear_capsules, 8), ("end to end", fam_end_to_end, 10),
        ("end to side", fam_end_to_side, 8), ("through", fam_through, 3), ("zero length", fam_zero_length, 7),
        ("zero radius", fam_zero_radius, 4)]),
    ("capsule", "box"): (5000, ALL + AT_BOX + WITH_BOX + [
        ("parallel", fam_capsule_along_box, 8), ("nearly parallel", fam_capsule_nearly_along_box, 8),
        ("through", fam_through, 3), ("zero length", fam_zero_length, 6), ("zero radius", fam_zero_radius, 4)]),
    ("box", "box"): (5500, ALL + WITH_BOX + [
        ("edge to edge", fam_edge_to_edge, 14), ("corner to face", fam_corner_to_face, 8),
        ("edge to face", fam_edge_to_face, 6), ("corner to corner", fam_corner_to_corner, 5),
        ("aligned", fam_aligned_boxes, 8), ("permuted", fam_permuted_boxes, 5),
        ("nearly parallel", fam_nearly_parallel_boxes, 12)]),
}
FLOAT64 = {("capsule", "capsule"): ["parallel", "nearly parallel", "collinear"],
           ("capsule", "box"): ["parallel", "nearly parallel"],
           ("box", "box"): ["permuted", "nearly parallel"]}


# ------------------------------------------------------------------------------------------ bringing into contact
def stored(shape, dtype):
    """The shape that is read back when this one's numbers are stored as dtype."""
    return type(shape).of_numbers(np.array(shape.numbers(), dtype=dtype).astype(float))


def resized(shape, u, by):
    """The shape grown so that the distance along u shrinks by the given amount; what is 0 stays 0."""
    if shape.kind == "sphere":
        return Sphere(shape.centre, max(0.0, shape.radius + by)) if shape.radius else shape
    if shape.kind == "capsule":
        return Capsule(shape.start, shape.end, max(0.0, shape.radius + by)) if shape.radius else shape
    share = np.abs(shape.axes() @ u) * (shape.half > 0)
    return Box(shape.centre, shape.quaternion,
               np.maximum(0.0, shape.half + by * share / (share @ share))) if share.any() else shape


def settled(a, b, target, dtype):
    """The pair as stored, at about the target distance: the smaller shape is moved, then, where its coordinates are
    too coarse for that, a shape is resized. None when that fails."""
    a, b = stored(a, dtype), stored(b, dtype)
    for attempt in range(10):
        distance, _, u = signed_distance(a, b)
        missing = target - distance
        if abs(missing) <= 0.3 * abs(target):
            return a, b
        a_is_smaller = a.bounding_radius() < b.bounding_radius()
        if attempt < 5:
            a, b = (a.moved(u * missing), b) if a_is_smaller else (a, b.moved(-u * missing))
        else:
            a, b = (resized(a, u, -missing), b) if attempt % 2 else (a, resized(b, u, -missing))
        a, b = stored(a, dtype), stored(b, dtype)
    return None


# --------------------------------------------------------------------------------------------------- cross-checks
def library_pose(shape):
    """(rotation with the shape's axes as columns, centre)"""
    centre, g, _ = shape.core()
    if shape.kind == "box":
        return shape.axes().T.copy(), centre
    if shape.kind == "capsule" and np.linalg.norm(g[0]) > 0:
        z = unit(g[0])
        x = unit(np.cross(z, np.eye(3)[int(np.argmin(np.abs(z)))]))
        return np.column_stack([x, np.cross(z, x), z]), centre
    return np.eye(3), centre


def library_shape(library, shape):
    if shape.kind == "sphere":
        return library.Sphere(shape.radius)
    if shape.kind == "box":
        return library.Box(*(2 * shape.half))
    return library.Capsule(shape.radius, 2 * float(np.linalg.norm(shape.core()[1])))


def scaled(shape, middle, factor):
    """The libraries have absolute tolerances: give them every pair about the origin and at size 1."""
    shape = shape.moved(-middle)
    if shape.kind == "sphere":
        return Sphere(shape.centre * factor, shape.radius * factor)
    if shape.kind == "capsule":
        return Capsule(shape.start * factor, shape.end * factor, shape.radius * factor)
    return Box(shape.centre * factor, shape.quaternion, shape.half * factor)


def ask_coal(a, b):
    """(do they collide, signed distance)"""
    arguments = []
    for s in (a, b):
        arguments += [library_shape(coal, s), coal.Transform3s(*library_pose(s))]
    request = coal.DistanceRequest()
    request.enable_signed_distance = True
    request.gjk_tolerance = request.epa_tolerance = 1e-10
    request.gjk_max_iterations, request.epa_max_iterations = 1000, 2000
    distance = coal.distance(*arguments, request, coal.DistanceResult())
    request = coal.CollisionRequest()
    request.gjk_tolerance, request.gjk_max_iterations = 1e-10, 1000
    return coal.collide(*arguments, request, coal.CollisionResult()) > 0, distance


def ask_fcl(a, b):
    """(do they collide, distance); the distance only says something where they do not"""
    objects = [fcl.CollisionObject(library_shape(fcl, s), fcl.Transform(*library_pose(s))) for s in (a, b)]
    return (fcl.collide(*objects, fcl.CollisionRequest(), fcl.CollisionResult()) > 0,
            fcl.distance(*objects, fcl.DistanceRequest(), fcl.DistanceResult()))


def cross_check(a, b, truth, counts):
    larger = max(a.bounding_radius(), b.bounding_radius())
    distance, open_gap, _ = signed_distance(a, b)
    counts["worst double"] = max(counts["worst double"], abs(distance - truth) / larger)
    counts["double yes/no"] += (distance <= 0) != (truth <= 0)
    counts["uncertified"] += open_gap > 1e-9 * larger
    middle = (a.core()[0] + b.core()[0]) / 2
    scaled_pair = [scaled(s, middle, 1 / larger) for s in (a, b)]
    for name, ask, allowed, signed in (("coal", ask_coal, 1e-6, True), ("fcl", ask_fcl, 1e-4, False)):
        try:
            hit, distance = ask(*scaled_pair)
        except Exception:
            counts[name + " raised"] += 1
            continue
        counts[name + " yes/no"] += hit != (truth <= 0)
        if signed or truth > 0:
            counts[name + " distance"] += not abs(distance - truth / larger) <= allowed


# ------------------------------------------------------------------------------------------------------ the driver
def family_records(job):
    """(records, counts) of one family: each record (numbers of a, numbers of b, signed distance)."""
    kinds, index, name, make, count = job
    warnings.simplefilter("error")
    rng = np.random.default_rng([SEED, list(PAIRS).index(kinds), index])
    dtype = np.float64 if name in FLOAT64.get(kinds, ()) else np.float32
    records, counts = [], collections.Counter()
    while len(records) < count:
        i = len(records)
        a, b, target = make(rng, kinds, i)
        pair = (stored(a, dtype), stored(b, dtype)) if target is None else settled(a, b, target, dtype)
        if pair is None:
            counts["redrawn"] += 1
            assert counts["redrawn"] < 10 * count + 100, name
            continue
        a, b = pair
        if kinds[0] == kinds[1] and rng.integers(2):
            a, b = b, a
        truth = exact_signed_distance(a, b)
        if abs(truth) <= GRAZING * max(a.bounding_radius(), b.bounding_radius()):
            counts["grazing"] += 1
            continue
        assert (a.kind, b.kind) == kinds
        counts["yes"] += truth <= 0
        cross_check(a, b, truth, counts)
        records.append((a.numbers(), b.numbers(), truth))
    return records, counts


COLUMNS = ("redrawn", "grazing", "double yes/no", "uncertified", "coal yes/no", "coal distance", "coal raised",
           "fcl yes/no", "fcl distance", "fcl raised")


def print_row(name, n, counts):
    print("| %s | %d | %.0f | %s | %.0e |" % (
        name, n, 100 * counts["yes"] / n, " | ".join(str(int(counts[c])) for c in COLUMNS), counts["worst double"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", default=os.path.join(HERE, "..", "fixtures", "pairs"))
    parser.add_argument("--scale", type=float, default=1.0, help="of the number of records")
    parser.add_argument("--processes", type=int, default=2)
    arguments = parser.parse_args()
    started = time.time()
    os.makedirs(arguments.out, exist_ok=True)
    jobs = []
    for kinds, (total, families) in PAIRS.items():
        weights = sum(w for _, _, w in families)
        share = [max(4, round(total * arguments.scale * w / weights)) for _, _, w in families]
        if arguments.scale >= 1:                  # the first family takes what rounding left over
            share[0] += round(total * arguments.scale) - sum(share)
        jobs += [(kinds, i, f[0], f[1], n) for i, (f, n) in enumerate(zip(families, share))]
    with multiprocessing.Pool(arguments.processes) as pool:
        results = pool.map(family_records, jobs, chunksize=1)

    print("| family | records | yes %% | %s | worst double |" % " | ".join(COLUMNS))
    print("|" + "---|" * (len(COLUMNS) + 4))
    manifest = dict(LAYOUT, seed=SEED, files=[])
    totals = collections.Counter()
    for kinds in PAIRS:
        number = "float64" if kinds in FLOAT64 else "float32"
        entry = dict(name="%s-%s" % kinds, file="%s-%s.bin" % kinds, shapes=list(kinds), numbers=number,
                     float64Families=FLOAT64.get(kinds, []), recordBytes=0, count=0, colliding=0, families=[])
        payload, sums = bytearray(), collections.Counter()
        for job, (records, counts) in zip(jobs, results):
            if job[0] != kinds:
                continue
            entry["families"].append([job[2], entry["count"], len(records)])
            for a, b, truth in records:
                record = struct.pack("<%d%s" % (len(a) + len(b), "d" if number == "float64" else "f"), *a, *b)
                record += struct.pack("<d", truth)
                entry["recordBytes"] = len(record)
                payload += record
            entry["count"] += len(records)
            entry["colliding"] += int(counts["yes"])
            print_row("%s: %s" % (entry["name"], job[2]), len(records), counts)
            worst = max(sums["worst double"], counts["worst double"])
            sums += counts
            sums["worst double"] = worst
        print_row("**%s**" % entry["name"], entry["count"], sums)
        worst = max(totals["worst double"], sums["worst double"])
        totals += sums
        totals["worst double"] = worst
        totals["records"] += entry["count"]
        manifest["files"].append(entry)
        with open(os.path.join(arguments.out, entry["file"]), "wb") as out:
            out.write(payload)
    print_row("**all**", totals["records"], totals)
    write_manifest(arguments.out, manifest)
    print("%.0f s" % (time.time() - started))


if __name__ == "__main__":
    main()
