#!/usr/bin/env python3
"""What scenes save that need not all of the model: the table of docs/variants.md.

    scripts/savings_table.py [--warpgrain PROGRAM] [--particles N] [--page docs/variants.md] [variant options]

Sheared grains (scenes/shear_box.json), changed so that they need less and less of the model, are profiled with
`warpgrain profile --against-full`. Every scene begins at the same places, those of the shear box after 500 steps.
With --page the table goes between its lines <!-- begin savings --> and <!-- end savings -->, else to stdout.
"""
import argparse
import copy
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

from page_block import with_block

QUANTITIES = (
    ("bytes of device memory a particle", ",.0f"),
    ("bytes moved a particle and step", ",.0f"),
    ("warp instructions a particle and step", ".1f"),
    ("SFU instructions a particle and step", ".2f"),
)


def without_friction(scene):
    for contact in scene["contacts"]:
        contact["friction"] = 0


def without_damping(scene):
    for contact in scene["contacts"]:
        contact["restitution"] = 1


def without_gravity(scene):
    scene["gravity"] = [0, 0, 0]


def without_walls(scene):
    """In a domain that has room for what flies off in the profiled step."""
    scene["walls"] = []


def without_springs(scene):
    for contact in scene["contacts"]:
        contact["tangential_parameter"] = 0


def of_everything(scene):
    """Two kinds of walls, of two materials; the state's radii differ."""
    first = scene["materials"][0]
    scene["materials"].append({**first, "name": "rubber", "youngs_modulus": first["youngs_modulus"] / 2})
    scene["contacts"].append({"between": [first["name"], "rubber"], "restitution": 0.6, "friction": 0.8})
    plate = {"corner": [0, 0, 0.03], "edges": [[0.02, 0, 0], [0, 0.02, 0]]}
    scene["walls"].append({"material": "rubber", "rectangle": plate})
    scene["particles"]["file"] = "two_radii.csv"
    del scene["particles"]["radius"]


SCENES = (
    ("all features", (of_everything,)),
    ("one material, one radius, planes", ()),
    ("... without tangential springs", (without_springs,)),
    ("... without gravity", (without_gravity,)),
    ("... without friction", (without_friction,)),
    ("... without friction and damping", (without_friction, without_damping)),
    ("... and without gravity and walls", (without_friction, without_damping, without_gravity, without_walls)),
)


def called(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return done.stdout


def write_two_radii(folder):
    rows = list(csv.reader((folder / "bed.csv").open()))
    column = rows[0].index("radius")
    for k, row in enumerate(rows[1:]):
        if k % 2:
            row[column] = repr(0.97 * float(row[column]))
    csv.writer((folder / "two_radii.csv").open("w")).writerows(rows)


def table(program, particles, options):
    scenes = pathlib.Path(__file__).resolve().parent.parent / "scenes"
    base = json.loads((scenes / "shear_box.json").read_text())
    lines = ["| scene | left out | " + " | ".join(name for name, _ in QUANTITIES) + " |", "|---|---|" + "---:|" * len(QUANTITIES)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        called([program, "run", "--scene", "shear_box", "--particles", str(particles), "--steps", "500", "--quiet",
                "--state", folder / "bed.csv"])
        write_two_radii(folder)
        # The box of as many particles.
        scale = (particles / base["particles"]["fill"]["count"]) ** (1 / 3)
        base["particles"] = {"material": base["particles"]["material"], "radius": 0.002, "file": "bed.csv"}
        for wall in base["walls"]:
            wall["plane"]["point"] = [scale * x for x in wall["plane"]["point"]]
        base["domain"] = {"lower": [-0.05] * 3, "upper": [0.15 * max(scale, 1)] * 3}
        for title, changes in SCENES:
            scene = copy.deepcopy(base)
            for change in changes:
                change(scene)
            file = folder / "scene.json"
            file.write_text(json.dumps(scene))
            report = json.loads(called([program, "profile", "--scene", file, "--against-full", "--weights", "ptx", "--unchecked",
                                        "--json", "-", *options]))
            rows = {row["quantity"]: row for row in report["against_full"]}
            left_out = [f["name"] for f in report["features"] if not f["modelled"] and f["name"] != "repulsion"]
            cells = [f'{format(rows[q]["value"], form)} of {format(rows[q]["full"], form)}' for q, form in QUANTITIES]
            lines.append(f"| {title} | {', '.join(left_out) or 'nothing'} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--warpgrain", default="build/release/cli/warpgrain")
    parser.add_argument("--particles", type=int, default=4096)
    parser.add_argument("--page", type=pathlib.Path)
    arguments, options = parser.parse_known_args()
    text = table(arguments.warpgrain, arguments.particles, options)
    if not arguments.page:
        print(text, end="")
        return
    arguments.page.write_text(with_block(arguments.page, "savings", text))


if __name__ == "__main__":
    main()
