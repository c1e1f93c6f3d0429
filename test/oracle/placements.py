#!/usr/bin/env python3
"""Makes the test vectors of whole agents: placements of pairs of real models, and whether their surfaces meet.

    python3 placements.py [--prepared ../../bin/test-models] [--out ../fixtures/placements] [--count 7000] [--processes 2]

Writes placements.bin, fixed-length little-endian records, and manifest.json, which describes them (LAYOUT below).

Truth: coal's and FCL's triangle trees, asked in different ways (coal in the frame of the larger mesh, FCL with both
meshes transformed into the world). A placement is dropped where the two disagree, and where the answer is delicate:
surfaces that meet but no longer do when one model moves by MARGIN along some axis, or that do not meet but are less
than MARGIN apart. So the answers stand for any engine that places vertices to better than that.
"""
import argparse
import collections
import math
import multiprocessing
import os
import struct
import time

import coal
import fcl
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull
import trimesh

from manifest import write_manifest
from models import PREPARED, load

SEED = 20150605
HERE = os.path.dirname(os.path.abspath(__file__))
MARGIN = 1e-4
FAMILIES = (("any rotation", 0.45), ("heading only", 0.25), ("on the ground", 0.2), ("nested", 0.1))
RECORD = "<BB14fBB"

LAYOUT = {
    "version": 1,
    "file": "placements.bin",
    "byteOrder": "little-endian, no header, no padding",
    "recordBytes": struct.calcsize(RECORD),
    "record": "index of model A and of model B in models, a byte each; for A and then for B x y z, heading, pitch, roll in"
              " degrees, size, float32 each; surfacesMeet, a byte, 0 or 1; inside, a byte, 0 or 1",
    "fields": {
        "transform": "scale by size, rotate by roll about x, by pitch about y, by heading about z (right-handed), translate",
        "surfacesMeet": "some triangle of A meets some triangle of B",
        "inside": "the surfaces do not meet, but a connected piece of one model lies inside the other (its winding number"
                  " is above 1/2 there): a collision of solids, not of surfaces",
        "margin": "no record's answer changes when a model moves by %g along an axis; surfaces that do not meet are at"
                  " least that far apart" % MARGIN,
        "families": "in the order of the records: [name, index of the first record, number of records]",
        "models": "normalised: x and y centred, the larger of their extents 1, the lowest point at z = 0; an OBJ file with"
                  " up y is turned by z' = y, y' = -z first; source assimp: a file of Debian's assimp-testmodels; source"
                  " prepared: written by test/models/prepare.mjs",
        "dropped": "placements that were drawn but have no record",
    },
}


# ------------------------------------------------------------------------------------------------------ geometry
def rotation(heading, pitch, roll):
    """roll about x, then pitch about y, then heading about z; degrees, right-handed"""
    (ch, sh), (cp, sp), (cr, sr) = [(math.cos(math.radians(d)), math.sin(math.radians(d)))
                                    for d in (heading, pitch, roll)]
    about_z = np.array([[ch, -sh, 0], [sh, ch, 0], [0, 0, 1]])
    about_y = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    about_x = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    return about_z @ about_y @ about_x


class Placed:
    """traits: x y z heading pitch roll size, as stored"""

    def __init__(self, model, traits):
        self.model = model
        self.traits = np.array(traits, np.float32).astype(float)
        self.position, self.size = self.traits[:3], self.traits[6]
        self.rotation = rotation(*self.traits[3:6])

    def world(self, points):
        return self.size * (points @ self.rotation.T) + self.position

    def local(self, points):
        return (points - self.position) @ self.rotation / self.size


def boxes_overlap(a, b):
    p, q = a.world(a.model.hull), b.world(b.model.hull)
    return bool((p.min(0) <= q.max(0) + MARGIN).all() and (q.min(0) <= p.max(0) + MARGIN).all())


def coal_tree(vertices, triangles):
    tree = coal.BVHModelOBBRSS()
    tree.beginModel(len(triangles), len(vertices))
    tree.addVertices(np.ascontiguousarray(vertices))
    tree.addTriangles(np.ascontiguousarray(triangles, dtype=np.int64))
    tree.endModel()
    return tree


def coal_answer(a, b):
    """(do the surfaces meet, is that delicate), in the frame of the model with more triangles"""
    if len(a.model.triangles) < len(b.model.triangles):
        a, b = b, a
    turn = a.rotation.T @ b.rotation
    shift = a.rotation.T @ (b.position - a.position) / a.size
    tree = coal_tree(b.model.vertices * (b.size / a.size), b.model.triangles)

    def meet(offset=0.0, margin=0.0):
        request = coal.CollisionRequest()
        request.security_margin = margin
        return coal.collide(a.model.tree, coal.Transform3s(), tree, coal.Transform3s(turn, shift + offset), request,
                            coal.CollisionResult()) > 0
    step = MARGIN / a.size
    if meet():
        return True, not all(meet(offset) for offset in np.vstack([np.eye(3), -np.eye(3)]) * step)
    return False, meet(margin=step)


def fcl_answer(a, b):
    """Do the surfaces meet, in the world?"""
    objects = []
    for p in (a, b):
        tree = fcl.BVHModel()
        tree.beginModel(len(p.model.vertices), len(p.model.triangles))
        tree.addSubModel(np.ascontiguousarray(p.world(p.model.vertices)), np.ascontiguousarray(p.model.triangles))
        tree.endModel()
        objects.append(fcl.CollisionObject(tree))
    return fcl.collide(*objects, fcl.CollisionRequest(), fcl.CollisionResult()) > 0


def winding_number(point, vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] - point for k in range(3))
    la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
    solid = np.arctan2((a * np.cross(b, c)).sum(1),
                       la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb)
    return solid.sum() / (2 * math.pi)


def one_inside_the_other(a, b):
    """For surfaces that do not meet: then a piece of one is inside the other whole or not at all."""
    for inner, outer in ((a, b), (b, a)):
        points = outer.local(inner.world(inner.model.piece_points))
        low, high = outer.model.vertices.min(0), outer.model.vertices.max(0)
        for p in points[((points > low) & (points < high)).all(1)]:
            if abs(winding_number(p, outer.model.vertices, outer.model.triangles)) > 0.5:
                return True
    return False


# ------------------------------------------------------------------------------------------------------ placements
def prepare(models):
    for m in models:
        m.hull = m.vertices[ConvexHull(m.vertices).vertices]
        m.tree = coal_tree(m.vertices, m.triangles)
        m.watertight = bool(trimesh.Trimesh(m.vertices, m.triangles, process=False).is_watertight)
        edges = np.vstack([m.triangles[:, [0, 1]], m.triangles[:, [1, 2]]])
        graph = coo_matrix((np.ones(len(edges)), edges.T), shape=(len(m.vertices),) * 2)
        piece = connected_components(graph, directed=False)[1]
        m.piece_points = m.vertices[np.unique(piece, return_index=True)[1]]
    return models


def random_pair(rng, family, models):
    """Two placed models, their world boxes mostly overlapping."""
    a, b = rng.integers(len(models), size=2)
    sizes = np.exp(rng.uniform(math.log(0.3), math.log(5), 2))
    if family == "nested":                                    # a small one near the middle of a large closed one
        b = rng.choice([i for i, m in enumerate(models) if m.watertight])
        sizes = rng.uniform(0.3, 0.8), rng.uniform(3, 5)
    traits = np.zeros((2, 7))
    traits[:, 3] = rng.uniform(0, 360, 2)
    if family in ("any rotation", "nested"):
        traits[:, 4:6] = rng.uniform(-180, 180, (2, 2))
    traits[:, 6] = sizes
    extents = [(w.min(0), w.max(0)) for w in (Placed(models[k], t).world(models[k].hull)
                                              for k, t in zip((a, b), traits))]
    middles = [(low + high) / 2 for low, high in extents]
    halves = [(high - low) / 2 for low, high in extents]
    if family == "nested":
        offset = rng.uniform(-0.5, 0.5, 3) * halves[1]
    else:
        offset = rng.uniform(-1, 1, 3) * (halves[0] + halves[1]) * rng.uniform(0.3, 1.2)
    traits[0, :2] = rng.uniform(-45, 45, 2)
    traits[0, 2] = rng.uniform(0, 10)
    traits[1, :3] = traits[0, :3] + middles[0] - middles[1] + offset
    if family == "on the ground":
        traits[:, 2] = 0.0
    return int(a), int(b), Placed(models[a], traits[0]), Placed(models[b], traits[1])


def one_placement(job):
    """(record or None, what happened)"""
    family, i = job
    rng = np.random.default_rng([SEED, [f[0] for f in FAMILIES].index(family), i])
    ia, ib, a, b = random_pair(rng, family, MODELS)
    meets = inside = False
    overlap = boxes_overlap(a, b)
    if overlap:
        meets, delicate = coal_answer(a, b)
        if fcl_answer(a, b) != meets:
            return None, "coal and FCL disagree" + (", delicate too" if delicate else "")
        if delicate:
            return None, "delicate"
        inside = not meets and one_inside_the_other(a, b)
    record = struct.pack(RECORD, ia, ib, *a.traits, *b.traits, meets, inside)
    return record, "meet" if meets else "inside" if inside else "boxes overlap" if overlap else "apart"


def load_models(prepared):
    global MODELS
    MODELS = prepare(load(prepared))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--prepared", default=PREPARED)
    parser.add_argument("--out", default=os.path.join(HERE, "..", "fixtures", "placements"))
    parser.add_argument("--count", type=int, default=7000)
    parser.add_argument("--processes", type=int, default=2)
    arguments = parser.parse_args()
    started = time.time()
    load_models(arguments.prepared)
    manifest = dict(LAYOUT, seed=SEED, count=0, meeting=0, inside=0, dropped={}, families=[], models=[
        dict(name=m.name, source=m.source, file=m.file, up=m.up, vertices=len(m.vertices),
             triangles=len(m.triangles), size=[round(x, 6) for x in np.ptp(m.vertices, axis=0)]) for m in MODELS])
    outcomes = ("meet", "boxes overlap", "apart", "inside", "delicate", "coal and FCL disagree",
                "coal and FCL disagree, delicate too")
    print("| family | kept | %s |" % " | ".join(outcomes))
    print("|" + "---|" * (len(outcomes) + 2))
    payload, totals = bytearray(), collections.Counter()
    with multiprocessing.Pool(arguments.processes, initializer=load_models, initargs=(arguments.prepared,)) as pool:
        for family, share in FAMILIES:
            jobs = [(family, i) for i in range(round(arguments.count * share))]
            results = pool.map(one_placement, jobs, chunksize=8)
            kept = [record for record, _ in results if record]
            counts = collections.Counter(what for _, what in results)
            print("| %s | %d | %s |" % (family, len(kept), " | ".join(str(counts[o]) for o in outcomes)), flush=True)
            manifest["families"].append([family, manifest["count"], len(kept)])
            manifest["count"] += len(kept)
            totals += counts
            payload += b"".join(kept)
    print("| all | %d | %s |" % (manifest["count"], " | ".join(str(totals[o]) for o in outcomes)))
    manifest.update(meeting=totals["meet"], inside=totals["inside"],
                    dropped={o: totals[o] for o in outcomes[4:]})
    os.makedirs(arguments.out, exist_ok=True)
    with open(os.path.join(arguments.out, "placements.bin"), "wb") as out:
        out.write(payload)
    write_manifest(arguments.out, manifest)
    print("%.0f s" % (time.time() - started))


if __name__ == "__main__":
    main()
