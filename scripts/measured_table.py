#!/usr/bin/env python3
"""Table of `warpgrain measure --scene --json` documents: a row a variant, a column a set of readings.

    scripts/measured_table.py reports/measured/h100-variants

A file's name says its set: BACKEND-SET-VARIANT.json. Whole steps in ms; the kernel of forces between particles in us.
"""
import json
import pathlib
import sys

FORCES = ("force_between_particles", "force_of_pairs")


def main(folder):
    sets, rows = [], {}
    for file in sorted(pathlib.Path(folder).glob("*.json")):
        document = json.loads(file.read_text())
        if document["format"] != "warpgrain.measured/1" or "counters" in document["kernels"][0]:
            continue
        name = "-".join(file.stem.split("-")[:2])
        if name not in sets:
            sets.append(name)
        forces = [k["seconds"]["median"] for k in document["kernels"] if k["kernel"] in FORCES]
        rows.setdefault(document["variant"], {})[name] = (document["step"]["seconds"]["median"], sum(forces))
    print("| variant | " + " | ".join(f"{s}: step [ms]" + (", forces [us]" if s == sets[0] else "") for s in sets) + " |")
    print("|---|" + "---:|" * len(sets))
    for variant in sorted(rows, key=lambda v: rows[v].get(sets[0], (9e9,))[0]):
        cells = []
        for s in sets:
            if s not in rows[variant]:
                cells.append("")
                continue
            step, forces = rows[variant][s]
            cells.append(f"{step * 1e3:.3f}" + (f", {forces * 1e6:.0f}" if s == sets[0] else ""))
        print(f"| `{variant}` | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
