#!/usr/bin/env python3
"""The eleven real models of the tests, normalised as the engine normalises them.

    python3 models.py [--prepared ../../bin/test-models]

Prints one line per model. The other scripts call load(). Seven models are files of Debian's assimp-testmodels, four
are written by test/models/prepare.mjs into the folder given.

OBJ files are read here (polygons as fans), Collada by trimesh and pycollada, which hold coordinates in single
precision. Collada states its up axis; the OBJ files are taken as below. Vertices are those that the faces use, each
position once, in the order of first use in the file's list (in Collada: of first use by a triangle).
"""
import argparse
import os
import re
import zipfile

import numpy as np
import trimesh

HERE = os.path.dirname(os.path.abspath(__file__))
PREPARED = os.path.join(HERE, "..", "..", "bin", "test-models")
ASSIMP = "/usr/share/assimp/models"

# name, folder, file, up axis (None: as the file states)
MODELS = [
    ("spider", ASSIMP, "OBJ/spider.obj", "y"),
    ("wuson", ASSIMP, "OBJ/WusonOBJ.obj", "y"),
    ("box", ASSIMP, "OBJ/box.obj", "y"),
    ("duck", ASSIMP, "Collada/duck.dae", None),
    ("teapots2", ASSIMP, "Collada/teapot_instancenodes.DAE", None),
    ("sphere", ASSIMP, "Collada/sphere.dae", None),
    ("human", ASSIMP, "Collada/human.zae", None),
    ("bunny", None, "bunny.obj", "y"),
    ("teapot", None, "teapot.obj", "y"),
    ("dragon4", None, "dragon4.obj", "y"),
    ("dragon3", None, "dragon3.obj", "y"),
]

# rows: where the file's axes go
TO_Z_UP = {
    "x": np.array([[0.0, -1, 0], [0, 0, -1], [1, 0, 0]]),
    "y": np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]),
    "z": np.eye(3),
}


class Model:
    """name, source (folder kind and file), up, vertices (n, 3) and triangles (m, 3), normalised"""

    def __init__(self, name, prepared=PREPARED):
        _, folder, self.file, self.up = next(m for m in MODELS if m[0] == name)
        self.name = name
        self.source = "assimp" if folder else "prepared"
        path = os.path.join(folder or prepared, self.file)
        if self.up:
            vertices, triangles = read_obj(path)
        else:
            vertices, triangles = read_collada(path)
            self.up = collada_up(path)
        vertices, self.triangles = welded(vertices @ TO_Z_UP[self.up].T, triangles)
        self.vertices = normalised(vertices)

    @property
    def vertex_order_is_the_files(self):
        return self.file.endswith(".obj")


def read_obj(path):
    vertices, triangles = [], []
    with open(path, encoding="latin-1") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["v"]:
                vertices.append([float(x) for x in words[1:4]])
            elif words[:1] == ["f"]:
                corners = [int(w.split("/")[0]) for w in words[1:]]
                corners = [c - 1 if c > 0 else len(vertices) + c for c in corners]
                triangles += [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]
    return np.array(vertices), np.array(triangles)


def read_collada(path):
    scene = trimesh.load(path, process=False)
    mesh = scene.to_mesh() if isinstance(scene, trimesh.Scene) else scene       # with every node's transform applied
    return np.array(mesh.vertices, float), np.array(mesh.faces)


def collada_up(path):
    if path.endswith(".zae"):
        with zipfile.ZipFile(path) as archive:
            text = archive.read(next(n for n in archive.namelist() if n.endswith(".dae")))
    else:
        with open(path, "rb") as source:
            text = source.read()
    return re.search(rb"<up_axis>\s*([XYZ])_UP", text).group(1).decode().lower()


def welded(vertices, triangles):
    """Each position once; without the triangles that this collapses and the vertices that none uses."""
    _, first, inverse = np.unique(vertices, axis=0, return_index=True, return_inverse=True)
    triangles = first[inverse.reshape(-1)][triangles]
    a, b, c = triangles.T
    triangles = triangles[(a != b) & (b != c) & (c != a)]
    used = np.unique(triangles)
    number = np.full(len(vertices), -1)
    number[used] = np.arange(len(used))
    return vertices[used], number[triangles]


def normalised(vertices):
    low, high = vertices.min(0), vertices.max(0)
    centre = (low + high) / 2
    return (vertices - [centre[0], centre[1], low[2]]) / max(high[0] - low[0], high[1] - low[1])


def load(prepared=PREPARED):
    return [Model(m[0], prepared) for m in MODELS]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--prepared", default=PREPARED)
    for m in load(parser.parse_args().prepared):
        mesh = trimesh.Trimesh(m.vertices, m.triangles, process=False)
        print("%-9s vertices %6d  triangles %6d  up %s  watertight %-5s  pieces %3d  size %.6f %.6f %.6f" % (
            m.name, len(m.vertices), len(m.triangles), m.up, mesh.is_watertight, mesh.body_count,
            *np.ptp(m.vertices, axis=0)))


if __name__ == "__main__":
    main()
