"""What other programs read from the models of Debian's package assimp-testmodels: test/fixtures/models/expected.json.

Needs the command assimp (Debian: assimp-utils) and, from PyPI, trimesh with networkx, numpy, pycollada, lxml, scipy,
shapely and charset-normalizer. Run from the project's folder: python3 test/oracle/model_files.py

A file's entry has what the first of assimp and trimesh reads that can: the number of distinct positions that its
triangles use (of points and lines where there are no triangles), the number of triangles, the extents in x, y and z
(z up, the larger of the first two 1) and the triangles' area in the same unit. Where the project reads a file in
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
OUTPUT = Path(__file__).resolve().parent.parent / 'fixtures' / 'models' / 'expected.json'
PATTERNS = ['OBJ/*.obj', 'invalid/*.obj', 'Collada/*.dae', 'Collada/*.DAE', 'Collada/*.zae', 'Collada/*.xml']

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
    corners = (vertices[faces] - low) / scale
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
    return {
        'by': by,
        'positions': len(np.unique(np.round((used - low) / scale, 5), axis=0)),
        'triangles': len(faces),
        'extents': [round(float(extent), 5) for extent in (high - low) / scale],
        'area': round(float(area), 5),
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


def main():
    logging.disable(logging.CRITICAL)
    paths = sorted(path for pattern in PATTERNS for path in MODELS.glob(pattern))
    entries = [json.dumps(entry(path)) for path in paths]
    OUTPUT.parent.mkdir(parents=True, exist_ok=True)
    OUTPUT.write_text('[\n' + ',\n'.join('    ' + line for line in entries) + '\n]\n')


if __name__ == '__main__':
    main()
