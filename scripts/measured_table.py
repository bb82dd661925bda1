#!/usr/bin/env python3
"""Table of `warpgrain measure --scene --json` documents: a row a variant, a column a set of readings.

    scripts/measured_table.py FOLDER               prints it
    scripts/measured_table.py --write | --check    that of reports/measured/h100-variants in reports/measured/README.md

--check exits with 1 where the page says anything else. A file's name says its set: BACKEND-SET-VARIANT.json. Whole steps in
ms; of the set with most variants (the first of them) also the kernels of forces between particles, in us. Rows by the steps
of that set.
"""
import json
import pathlib
import sys

from page_block import write_or_check

READINGS = pathlib.Path(__file__).resolve().parent.parent / "reports" / "measured"
PAGE = READINGS / "README.md"
FORCES = ("force_between_particles", "force_of_pairs")


def table(folder):
    sets, rows = [], {}
    for file in sorted(folder.glob("*.json")):
        document = json.loads(file.read_text())
        if document["format"] != "warpgrain.measured/1" or "counters" in document["kernels"][0]:
            continue
        name = "-".join(file.stem.split("-")[:2])
        if name not in sets:
            sets.append(name)
        forces = [k["seconds"]["median"] for k in document["kernels"] if k["kernel"] in FORCES]
        rows.setdefault(document["variant"], {})[name] = (document["step"]["seconds"]["median"], sum(forces))
    if not sets:
        sys.exit(f"{folder}: no documents of `warpgrain measure --scene --json`")
    main_set = max(sets, key=lambda name: sum(name in row for row in rows.values()))
    lines = [
        "| variant | " + " | ".join(f"{s}: step [ms]" + (", forces [us]" if s == main_set else "") for s in sets) + " |",
        "|---|" + "---:|" * len(sets),
    ]
    for variant in sorted(rows, key=lambda v: rows[v].get(main_set, (9e9,))[0]):
        cells = []
        for s in sets:
            if s not in rows[variant]:
                cells.append("")
                continue
            step, forces = rows[variant][s]
            cells.append(f"{step * 1e3:.3f}" + (f", {forces * 1e6:.0f}" if s == main_set else ""))
        lines.append(f"| `{variant}` | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main(word):
    if not word.startswith("--"):
        print(table(pathlib.Path(word)), end="")
        return
    if word not in ("--write", "--check"):
        sys.exit(__doc__)
    write_or_check(word, PAGE, "table", table(READINGS / "h100-variants"))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
