"""The file that describes a folder of vectors."""
import json
import os

NAME = "manifest.json"


def read_manifest(folder):
    """What write_manifest wrote into a folder."""
    with open(os.path.join(folder, NAME)) as file:
        return json.load(file)


def write_manifest(folder, manifest):
    """Writes manifest.json, the same bytes for the same description."""
    with open(os.path.join(folder, NAME), "w") as file:
        json.dump(manifest, file, indent=1)
        file.write("\n")
