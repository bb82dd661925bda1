#!/usr/bin/env python3
"""Counts the particles below a height in each VTK file of `warpgrain run --vtk DIR`.

    scripts/flow.py DIR --below 0 --time-step 1.73e-5

prints a line a file: step, time [s], particles below, particles in all, lowest and highest centre [m].
"""
import argparse
import array
import pathlib
import re
import struct
import sys


def positions(path):
    """x, y, z of every particle, one after the other, as the file's raw appended block holds them."""
    data = path.read_bytes()
    header, _, blocks = data.partition(b'<AppendedData encoding="raw">\n_')
    entry = re.search(rb'Name="position"[^>]*offset="(\d+)"', header)
    if not entry or not blocks:
        sys.exit(f"{path}: no raw appended array 'position'; expected a file of warpgrain run --vtk")
    offset = int(entry.group(1))
    (n_bytes,) = struct.unpack_from("<Q", blocks, offset)
    values = array.array("f")
    values.frombytes(blocks[offset + 8 : offset + 8 + n_bytes])
    return values


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--below", type=float, default=0.0, help="height z [m]")
    parser.add_argument("--time-step", type=float, default=0.0, help="seconds a step")
    arguments = parser.parse_args()
    files = sorted(arguments.folder.glob("particles_*.vtp"))
    if not files:
        sys.exit(f"{arguments.folder}: no particles_*.vtp; expected the folder of warpgrain run --vtk")
    print("step,time,below,particles,lowest,highest")
    for path in files:
        step = int(path.stem.split("_")[1])
        heights = positions(path)[2::3]
        below = sum(1 for z in heights if z < arguments.below)
        print(f"{step},{step * arguments.time_step:.6g},{below},{len(heights)},{min(heights):.6g},{max(heights):.6g}")


if __name__ == "__main__":
    main()
