"""What other programs read from models: test/fixtures/models/expected.json, of the files of Debian's package
assimp-testmodels, and scenes.json, of random COLLADA scenes, which are in it.

Needs the command assimp (Debian: assimp-utils) and, from PyPI, trimesh with networkx, numpy, pycollada, lxml, scipy,
shapely and charset-normalizer. Run from the project's folder: python3 test/oracle/model_files.py

A file's entry has what the first of assimp and trimesh reads that can: the number of distinct positions that its
triangles use (of points and lines where there are no triangles), the number of triangles, the extents in x, y and z
(z up, the larger of the first two 1), and, in the same frame, the triangles' area and its centroid. Where the project reads a file in
another way, DIFFERENCES says why; such an entry has what is expected instead, or only the reason.
"""

import json
import logging
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import trimesh

MODELS = Path(os.environ.get('ASSIMP_MODELS', '/usr/share/assimp/models'))
OUTPUT = Path(__file__).resolve().parent.parent / 'fixtures' / 'models'
PATTERNS = ['OBJ/*.obj', 'invalid/*.obj', 'Collada/*.dae', 'Collada/*.DAE', 'Collada/*.xml']

NO_GEOMETRY = 'has no geometry, only cameras or lights: assimp draws a skeleton for its nodes'
DIFFERENCES = {
    'Collada/cameras.dae': {'fails': NO_GEOMETRY},
    'Collada/lights.dae': {'fails': NO_GEOMETRY},
    'Collada/library_animation_clips.dae': {
        'note': 'assimp stumbles over the white space around its numbers, trimesh does not read polygons'},
    'OBJ/number_formats.obj': {'fails': '"3.1+e2" is no number: strtod() stops at 3.1, and so do assimp and trimesh'},
    'OBJ/box_longline.obj': {
        'note': 'one face goes round the same four corners 250 times: the others make a fan of it'},
    'invalid/empty.obj': {'fails': 'is empty'},
    'invalid/malformed.obj': {'fails': 'has a face with a vertex that does not exist'},
}


def describe(vertices, faces, by):
    """The entry of a file, z up."""
    vertices = np.asarray(vertices, float)
    faces = np.asarray(faces, int).reshape(-1, 3)
    used = vertices[np.unique(faces)] if len(faces) else vertices
    low, high = used.min(axis=0), used.max(axis=0)
    scale = max(high[0] - low[0], high[1] - low[1])
    origin = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    corners = (vertices[faces] - origin) / scale
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    area = areas.sum()
    centroid = (corners.mean(axis=1) * areas[:, None]).sum(axis=0) / area if area > 0 else np.zeros(3)
    return {
        'by': by,
        'positions': len(np.unique(np.round((used - low) / scale, 5), axis=0)),
        'triangles': len(faces),
        'extents': [round(float(extent), 5) for extent in (high - low) / scale],
        'area': round(float(area), 5),
        'centroid': [round(float(coordinate), 5) for coordinate in centroid],
    }


def read_with_assimp(path):
    """None where assimp can't read it. A COLLADA document's up axis becomes y there."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder, 'model.ply')
        subprocess.run(['assimp', 'export', str(path), str(output), '-fply', '-ptv', '-tri'], capture_output=True, check=False)
        if not output.exists():
            return None
        model = trimesh.load(output, process=False)
    if not hasattr(model, 'vertices'):
        return None
    vertices = np.asarray(model.vertices)
    if 'OBJ' not in path.parts and 'invalid' not in path.parts:
        vertices = np.stack([vertices[:, 0], -vertices[:, 2], vertices[:, 1]], axis=1)
    return describe(vertices, getattr(model, 'faces', []), 'assimp')


def read_with_trimesh(path):
    """None where trimesh can't read it."""
    try:
        model = trimesh.load(path, process=False)
        if isinstance(model, trimesh.Scene):
            model = model.to_geometry()
        return describe(model.vertices, getattr(model, 'faces', []), 'trimesh')
    except (ValueError, IndexError, NotImplementedError, UnicodeDecodeError):
        return None


def entry(path):
    name = path.relative_to(MODELS).as_posix()
    difference = DIFFERENCES.get(name)
    if difference is not None:
        return {'file': name, **difference}
    found = read_with_assimp(path) or read_with_trimesh(path)
    return {'file': name, **(found or {'note': 'neither assimp nor trimesh reads it'})}


class RandomScene:
    """A COLLADA document with nested nodes, instances of a library's node and all transformations but skew, which
    assimp passes over."""

    BOX = '0 0 0 1 0 0 1 2 0 0 2 0 0 0 4 1 0 4 1 2 4 0 2 4'
    SIDES = '0 3 2 1 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7'

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)
        up_axis = 'XYZ'[seed % 3]
        self.document = (
            '<?xml version="1.0"?>'
            '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
            f'<asset><unit meter="1" name="meter"/><up_axis>{up_axis}_UP</up_axis></asset>'
            '<library_geometries><geometry id="box"><mesh>'
            f'<source id="positions"><float_array id="numbers" count="24">{self.BOX}</float_array>'
            '<technique_common><accessor source="#numbers" count="8" stride="3">'
            '<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>'
            '</accessor></technique_common></source>'
            '<vertices id="vertices"><input semantic="POSITION" source="#positions"/></vertices>'
            '<polylist count="6"><input semantic="VERTEX" source="#vertices" offset="0"/>'
            f'<vcount>4 4 4 4 4 4</vcount><p>{self.SIDES}</p></polylist></mesh></geometry></library_geometries>'
            f'<library_nodes><node id="part">{self.transformation()}{self.transformation()}'
            '<instance_geometry url="#box"/></node></library_nodes>'
            f'<library_visual_scenes><visual_scene id="scene">{self.node(0)}{self.node(0)}</visual_scene>'
            '</library_visual_scenes><scene><instance_visual_scene url="#scene"/></scene></COLLADA>')

    def node(self, depth):
        text = '<node>' + ''.join(self.transformation() for _ in range(self.random.integers(4)))
        text += '<instance_geometry url="#box"/>'
        if depth < 2:
            text += ''.join(self.node(depth + 1) for _ in range(self.random.integers(3)))
        if self.random.random() < 0.4:
            text += '<instance_node url="#part"/>'
        return text + '</node>'

    def transformation(self):
        kind = self.random.choice(['translate', 'rotate', 'scale', 'matrix', 'lookat'])
        if kind == 'rotate':
            values = [*self.direction(), self.random.uniform(-360, 360)]  # assimp does not normalise the axis
        elif kind == 'lookat':
            eye, forward = self.random.normal(size=3), self.direction()
            up = np.cross(forward, self.direction())  # assimp does not straighten it
            values = [*eye, *(eye + forward), *(up / np.linalg.norm(up))]
        elif kind == 'matrix':
            values = [*self.random.uniform(-2, 2, size=12), 0, 0, 0, 1]
        else:
            values = self.random.uniform(-2, 2, size=3)
        return f'<{kind}>' + ' '.join(f'{value:.9g}' for value in values) + f'</{kind}>'

    def direction(self):
        vector = self.random.normal(size=3)
        return vector / np.linalg.norm(vector)


def scene_entry(seed):
    document = RandomScene(seed).document
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, 'scene.dae')
        path.write_text(document)
        return {'file': f'scene {seed}', **read_with_assimp(path), 'document': document}


def write(name, entries):
    path = OUTPUT / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text('[\n' + ',\n'.join('    ' + json.dumps(item) for item in entries) + '\n]\n')


def main():
    logging.disable(logging.CRITICAL)
    write('expected.json', [entry(path) for path in sorted(path for pattern in PATTERNS for path in MODELS.glob(pattern))])
    write('scenes.json', [scene_entry(seed) for seed in range(12)])


if __name__ == '__main__':
    main()
