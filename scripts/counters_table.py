#!/usr/bin/env python3
"""What the simulator counts of a step beside what a GPU counted, variant by variant.

    scripts/counters_table.py --write | --check

Writes the tables of docs/counters.md from the readings in reports/measured/h100-variants, or exits with 1 where the page says
anything else: sums over all kernels of a step (`headline` in the index of a sweep with --weights sass, `counters` of `measure
--counters` documents), and how far the simulator's are off in percent of the GPU's. "-": no sweep has that variant.
"""
import json
import pathlib
import re
import statistics
import sys

from page_block import write_or_check

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "counters.md"
READINGS = ROOT / "reports" / "measured" / "h100-variants"
SETS = (("bed131072", "A settled bed"), ("earlier_bed131072", "The same, counted earlier on a bed of its own"), ("shear131072", "Flowing grains"),
        ("bed16384", "A settled bed of 16,384 particles"), ("shear16384", "Flowing grains, 16,384"),
        ("bed1048576", "A settled bed of 1,048,576 particles"), ("shear1048576", "Flowing grains, 1,048,576"))
METRICS = ("warp_instructions", "thread_instructions", "simt_efficiency", "sfu_instructions", "branches", "divergent_branches")


def counted(document):
    sums = {m: sum(k["counters"][m] for k in document["kernels"]) for m in METRICS if m != "simt_efficiency"}
    sums["simt_efficiency"] = sums["thread_instructions"] / (32 * sums["warp_instructions"])
    return sums


def makes_lists(document):
    return any(k["kernel"].startswith("list_") for k in document["kernels"] if k["counters"].get("warp_instructions"))


def difference(counters, gpu, metric):
    return 100 * (counters[metric] / gpu[metric] - 1)


def table(name, title):
    sweep = READINGS / f"sweep-{name}.json"
    simulated = {c["variant"]: c["headline"] for c in json.loads(sweep.read_text())["cases"]} if sweep.exists() else {}
    documents = [json.loads(f.read_text()) for f in READINGS.glob(f"counters-{name}-*.json")]
    rows, differences = [], {m: [] for m in METRICS}
    for document in sorted(documents, key=lambda d: d["variant"]):
        gpu, headline = counted(document), simulated.get(document["variant"])
        if headline is None:
            off = ["-"] * len(METRICS)
        elif makes_lists(document):
            off = ["another step"] * len(METRICS)
        else:
            off = [f"{difference(headline, gpu, m):+.2f} %" for m in METRICS]
            for m in METRICS:
                differences[m].append(abs(difference(headline, gpu, m)))
        rows.append(f'| `{document["variant"]}` | {gpu["warp_instructions"]:,.0f} | {gpu["simt_efficiency"]:.3f} | ' + " | ".join(off) + " |")
    lines = [
        f"## {title}",
        "",
        f'{documents[0]["particles"]:,} particles, {len(rows)} variants.',
        "",
        "| variant | warp instructions | SIMT efficiency | " + " | ".join(f'{m.replace("_", " ")}, off by' for m in METRICS) + " |",
        "|---|" + "---:|" * (len(METRICS) + 2),
        *rows,
    ]
    if differences["branches"]:
        lines.append("| median, largest | | | " + " | ".join(f"{statistics.median(d):.2f} %, {max(d):.2f} %" for d in differences.values()) + " |")
    return "\n".join(lines) + "\n"


def main():
    if sys.argv[1:] not in (["--write"], ["--check"]):
        sys.exit(__doc__)
    write_or_check(sys.argv[1], PAGE, "tables", "\n".join(table(*s) for s in SETS))


if __name__ == "__main__":
    main()
