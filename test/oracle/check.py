#!/usr/bin/env python3
"""Reads the committed vectors back, by what their manifests say alone, and verifies them again.

    python3 check.py [--fixtures ../fixtures] [--prepared ../../bin/test-models] [--sample 300]

Pairs: lengths, counts and families of every file; every record with a sphere by the textbook formula; of each file a
sample in 60 digits. Motion: lengths and counts; of each file a sample by coal's distances at 100 moments of the way, and in 60 digits
shortly before and after the touch. Placements: a sample by FCL, with rotations from SciPy. Fits: that each structure contains its
points, and that no bound and no volume contradicts another. Exits with 1 at the first that is wrong.
"""
import argparse
import json
import math
import os
import struct

import fcl
import numpy as np
from scipy.spatial.transform import Rotation

from fits import by_formula, read_points
from geometry import SHAPES, exact_signed_distance
from manifest import read_manifest
from minima import distance_to_segment
from models import PREPARED, Model
from motion import exact_at, read_pairs
from pairs import ask_coal, scaled

HERE = os.path.dirname(os.path.abspath(__file__))


def sphere_distance(sphere, other):
    """Signed distance of a sphere to any shape, by the textbook."""
    if other.kind == "sphere":
        return np.linalg.norm(sphere.centre - other.centre) - sphere.radius - other.radius
    if other.kind == "capsule":
        to_axis = distance_to_segment(sphere.centre[None, :], other.start, other.end)[0][0]
        return to_axis - sphere.radius - other.radius
    w, x, y, z = other.quaternion
    local = Rotation.from_quat([x, y, z, w]).inv().apply(sphere.centre - other.centre)
    beyond = np.abs(local) - other.half
    outside = np.linalg.norm(np.maximum(beyond, 0))
    return (outside if (beyond > 0).any() else beyond.max()) - sphere.radius


def check_pairs(folder, sample):
    manifest = read_manifest(folder)
    for entry in manifest["files"]:
        with open(os.path.join(folder, entry["file"]), "rb") as source:
            payload = source.read()
        a_type, b_type = (SHAPES[k] for k in entry["shapes"])
        n = a_type.count_of_numbers + b_type.count_of_numbers
        layout = "<%d%sd" % (n, {"float32": "f", "float64": "d"}[entry["numbers"]])
        assert struct.calcsize(layout) == entry["recordBytes"]
        assert len(payload) == entry["recordBytes"] * entry["count"]
        records = list(struct.iter_unpack(layout, payload))
        assert sum(r[-1] <= 0 for r in records) == entry["colliding"]
        following = 0
        for name, first, count in entry["families"]:
            assert first == following and count > 0
            following += count
            if name not in entry["float64Families"]:
                assert all(struct.unpack("<f", struct.pack("<f", x))[0] == x
                           for r in records[first:following] for x in r[:-1])
        assert following == entry["count"]
        worst = 0.0
        for i, r in enumerate(records):
            a, b = a_type.of_numbers(r[:a_type.count_of_numbers]), b_type.of_numbers(r[a_type.count_of_numbers:n])
            size = max(a.bounding_radius(), b.bounding_radius())
            assert abs(r[-1]) > 1e-9 * size
            if a.kind == "sphere":
                error = abs(sphere_distance(a, b) - r[-1]) / (size + np.abs(a.centre).max())
                worst = max(worst, error)
                assert error < 1e-14, (entry["file"], i)
        chosen = np.linspace(0, len(records) - 1, sample).astype(int)
        for i in chosen:
            r = records[i]
            a, b = a_type.of_numbers(r[:a_type.count_of_numbers]), b_type.of_numbers(r[a_type.count_of_numbers:n])
            assert exact_signed_distance(a, b) == r[-1], (entry["file"], i)
        print("%-20s %5d records, %4.1f %% collide; %d again in 60 digits%s" % (
            entry["file"], len(records), 100 * entry["colliding"] / len(records), len(chosen),
            "; all by the textbook, to %.0e" % worst if a_type.kind == "sphere" else ""))


def check_motion(folder, pairs, sample):
    manifest = read_manifest(folder)
    entries = read_manifest(pairs)["files"]
    for entry, of in zip(manifest["files"], entries):
        with open(os.path.join(folder, entry["file"]), "rb") as source:
            records = list(struct.iter_unpack("<6f2d3f", source.read()))
        assert len(records) == entry["count"] == of["count"]
        assert sum(r[6] <= 1 for r in records) == entry["touching"]
        chosen = set(np.linspace(0, len(records) - 1, sample).astype(int))
        asked = 0
        for i, (a, b) in enumerate(read_pairs(pairs, of)):
            if i not in chosen:
                continue
            offset, way, t = np.array(records[i][:3]), np.array(records[i][3:6]), records[i][6]
            if 0 < t <= 1:
                assert exact_at(a, b, offset, way, t - 1e-9) > 0 >= exact_at(a, b, offset, way, t + 1e-9), (entry["file"], i)
            # coal's tolerances are absolute, and it errs where scales are mixed
            large, small = sorted((a.bounding_radius(), b.bounding_radius()), reverse=True)
            if small < 1e-2 * large:
                continue
            asked += 1
            middle = b.core()[0]
            for moment in np.linspace(0, 1, 101):
                _, distance = ask_coal(*(scaled(s, middle, 1 / large) for s in (a.moved(offset + moment * way), b)))
                assert distance > -1e-5 or t <= moment, (entry["file"], i, moment)
        print("motion/%-20s %5d ways, %4.1f %% touch; %d again in 60 digits, %d of them by coal" % (
            entry["file"], len(records), 100 * entry["touching"] / len(records), len(chosen), asked))


def check_placements(folder, prepared, sample):
    manifest = read_manifest(folder)
    with open(os.path.join(folder, manifest["file"]), "rb") as source:
        payload = source.read()
    assert len(payload) == manifest["recordBytes"] * manifest["count"]
    records = list(struct.iter_unpack("<2B14f2B", payload))
    assert sum(r[-2] for r in records) == manifest["meeting"]
    assert sum(r[-1] for r in records) == manifest["inside"]
    assert not any(r[-2] and r[-1] for r in records)
    models = [Model(m["name"], prepared) for m in manifest["models"]]
    chosen = np.linspace(0, len(records) - 1, sample).astype(int)
    for i in chosen:
        r = records[i]
        objects = []
        for index, (x, y, z, heading, pitch, roll, size) in ((r[0], r[2:9]), (r[1], r[9:16])):
            turn = Rotation.from_euler("xyz", [roll, pitch, heading], degrees=True)     # about fixed axes, x first
            tree = fcl.BVHModel()
            tree.beginModel(len(models[index].vertices), len(models[index].triangles))
            tree.addSubModel(models[index].vertices * size, models[index].triangles)
            tree.endModel()
            objects.append(fcl.CollisionObject(tree, fcl.Transform(turn.as_matrix(), np.array([x, y, z]))))
        meets = fcl.collide(*objects, fcl.CollisionRequest(), fcl.CollisionResult()) > 0
        assert meets == bool(r[-2]), i
    print("%-20s %5d records, %4.1f %% meet, %d inside; %d again" % (
        manifest["file"], len(records), 100 * manifest["meeting"] / len(records), manifest["inside"], len(chosen)))


def check_fits(fixtures, prepared):
    with open(os.path.join(fixtures, "fits.json")) as source:
        sets = json.load(source)["sets"]
    for e in sets:
        points = (read_points(os.path.join(fixtures, e["file"])) if e["source"] == "points" else
                  by_formula() if e["source"] == "formula" else Model(e["model"], prepared).vertices)
        assert len(points) == e["vertices"]
        size = max(np.ptp(points, axis=0).max(), 1e-12 * np.abs(points).max())
        slack = 1e-9 * size + 1e-12 * np.abs(points).max()
        small, thesis = e["smallest"], e["thesis"]
        for s in (small["sphere"], thesis["naiveSphere"], thesis["ritterSphere"]):
            if s:
                assert np.linalg.norm(points - s["centre"], axis=1).max() <= s["radius"] + slack, e["name"]
                assert s["volume"] >= small["sphere"]["volume"] * (1 - 1e-9)
        assert max(small["sphere"]["certificate"]) < 1e-8, e["name"]
        for b in (small["box"], small["zBox"]):
            axes, half = np.array(b["axes"]), np.array(b["half"])
            assert np.abs(axes @ axes.T - np.eye(3)).max() < 1e-12
            assert (np.abs((points - b["centre"]) @ axes.T) <= half + slack).all(), e["name"]
            assert abs(8 * half.prod() - b["volume"]) <= 1e-9 * b["volume"] + 1e-15 * size ** 3
        assert small["box"]["lowerBound"] <= small["box"]["volume"] <= small["zBox"]["volume"] + 1e-12 * size ** 3
        if e["rank"] == 3:
            assert small["box"]["lowerBound"] >= small["box"]["volume"] * (1 - 1.1e-5), e["name"]
        least = small["box"]["lowerBound"] * (1 - 1e-12)
        for v in (thesis["axisAlignedBox"]["volume"], thesis["zAlignedBox"]["volume"], *thesis["orientedBox"].values()):
            assert v >= least, e["name"]
        assert thesis["zAlignedBox"]["volume"] >= small["zBox"]["volume"] * (1 - 1e-12) - 1e-15 * size ** 3
        c = small["capsule"]
        far = distance_to_segment(points, np.array(c["start"]), np.array(c["end"]))[0].max()
        assert far <= c["radius"] * (1 + 1e-9) + slack, e["name"]
        length = math.dist(c["start"], c["end"])
        volume = math.pi * c["radius"] ** 2 * (length + 4 / 3 * c["radius"])
        assert abs(volume - c["volume"]) <= 1e-6 * volume + 1e-15 * size ** 3, e["name"]
        assert min(thesis["capsule"]["oriented"]["low"], thesis["capsule"]["z"]["low"]) >= c["volume"] * (1 - 1e-9)
    print("%-20s %5d sets" % ("fits.json", len(sets)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--fixtures", default=os.path.join(HERE, "..", "fixtures"))
    parser.add_argument("--prepared", default=PREPARED)
    parser.add_argument("--sample", type=int, default=300)
    arguments = parser.parse_args()
    check_pairs(os.path.join(arguments.fixtures, "pairs"), arguments.sample)
    check_motion(os.path.join(arguments.fixtures, "motion"), os.path.join(arguments.fixtures, "pairs"), arguments.sample)
    check_placements(os.path.join(arguments.fixtures, "placements"), arguments.prepared, arguments.sample)
    check_fits(arguments.fixtures, arguments.prepared)


if __name__ == "__main__":
    main()
