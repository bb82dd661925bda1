#!/usr/bin/env python3
"""A bed between walls, repeated: mirror images of it side by side, so that a settled bed gives a larger settled one.

    scripts/tile_bed.py SCENE.json NX NY OUT.json

SCENE.json takes its particles from a state file and stands between four planes whose normals are along x and y, the first
of each pair through the origin, as scenes/settled_bed.json does. OUT.json and OUT.csv are written; velocities are left out.
"""
import csv
import json
import pathlib
import sys


def mirrored(x, width, k):
    return k * width + (x if k % 2 == 0 else width - x)


def main(scene_file, nx, ny, out):
    scene = json.loads(scene_file.read_text())
    planes = [wall["plane"] for wall in scene["walls"]]
    far = [next(p for p in planes if p["normal"][axis] == -1) for axis in (0, 1)]
    width = [far[axis]["point"][axis] for axis in (0, 1)]
    with (scene_file.parent / scene["particles"]["file"]).open() as states:
        particles = list(csv.DictReader(states))
    with out.with_suffix(".csv").open("w") as states:
        print("id,x,y,z,radius", file=states)
        for k in range(nx * ny):
            for number, p in enumerate(particles):
                x = mirrored(float(p["x"]), width[0], k % nx)
                y = mirrored(float(p["y"]), width[1], k // nx)
                print(f"{k * len(particles) + number},{x!r},{y!r},{p['z']},{p['radius']}", file=states)
    for axis, n in ((0, nx), (1, ny)):
        far[axis]["point"][axis] *= n
        scene["domain"]["upper"][axis] *= n
    scene["particles"]["file"] = out.with_suffix(".csv").name
    scene["name"] = f"{scene['name']}_{nx}x{ny}"
    out.write_text(json.dumps(scene, indent=1) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), pathlib.Path(sys.argv[4]))
