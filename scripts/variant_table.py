#!/usr/bin/env python3
"""Turns folders of `warpgrain sweep` into the tables of docs/variants.md.

    scripts/variant_table.py docs/variants.md TITLE=FOLDER[=READINGS]...

writes, for each folder, a row a variant between the page's lines <!-- begin tables --> and <!-- end tables -->: what the force
evaluation between particles costs (its kernels are those whose names begin with force_ or list_, walls aside), what the whole
step costs, and how exact it is. READINGS is what the names of `warpgrain measure` documents of the same scene begin with, whose
median step stands beside. Without a page the tables go to stdout.
"""
import collections
import json
import pathlib
import re
import sys

from page_block import with_block

HEADINGS = (
    "variant",
    "efficiency between particles",
    "of the step",
    "warp instructions a particle, between particles",
    "of the step",
    "SFU operations a contact",
    "sectors a load",
    "bytes moved a particle",
    "device memory a particle",
    "PoCL time a step",
    "measured",
    "largest error",
    "rms error",
    "lane slots lost most at",
)


def finds_forces(kernel):
    return kernel.startswith(("force_", "list_")) and kernel != "force_from_walls"


def ratio(numerator, denominator):
    return numerator / denominator if denominator else 0.0


def efficiency(launches):
    issued = sum(l["totals"]["warp_instructions"] * l["warp_width"] for l in launches)
    return ratio(sum(l["totals"]["thread_instructions"] for l in launches), issued)


def special_functions(launch):
    """Operations of single lanes on the special-function unit: a line's instructions times its active lanes."""
    return sum(
        line["totals"]["sfu_instructions"] * ratio(line["totals"]["thread_instructions"], line["totals"]["warp_instructions"])
        for line in launch["lines"]
    )


def losses(launches):
    """The three branches that cost most, with their shares of the lane slots lost."""
    lost = collections.Counter()
    for launch in launches:
        for branch in launch["branches"]:
            lost[branch["label"] or f'{branch["file"]}:{branch["line"]}'] += branch["lane_slots_lost"]
    everything = sum(lost.values())
    # A branch without a name is its source text, which may hold Markdown's column mark.
    return ", ".join(f"{label} {100 * ratio(slots, everything):.0f} %" for label, slots in lost.most_common(3)).replace("|", "\\|")


def contacts_of(reports):
    """Contacts between particles, counted from both sides: how often a lane came to the branchy laws' branch `slip`.
    All cases of a sweep begin at one state, and searches that evaluate a pair once come by half as often."""
    counts = [
        sum(b["lanes"] for l in report["launches"] if finds_forces(l["kernel"]) for b in l["branches"] if b["label"] == "slip")
        for report in reports
    ]
    if not any(counts):
        sys.exit("no case with a branch 'slip'; sweep contact=branchy or sfu_minimised beside the others")
    return max(counts)


def bytes_moved(launches):
    keys = ("global_load_sectors", "global_store_sectors")
    return 32 * sum(l["totals"][key] for l in launches for key in keys)


def measured_step(readings, variant):
    file = pathlib.Path(f'{readings}{re.sub("[/=]", "-", variant)}.json')
    if not readings or not file.exists():
        return "-"
    return f'{1e6 * json.loads(file.read_text())["step"]["seconds"]["median"]:.0f} us'


def row(case, report, particles, contacts, readings):
    launches = report["launches"]
    between = [l for l in launches if finds_forces(l["kernel"])]
    sectors = sum(l["totals"]["global_load_sectors"] for l in between)
    requests = sum(l["totals"]["global_load_requests"] for l in between)
    device = next(b for b in case["backends"] if b["backend"] == "opencl")
    seconds, error = device.get("seconds_per_step"), device["force_error"]
    return (
        f'`{case["variant"]}`',
        f"{efficiency(between):.3f}",
        f"{efficiency(launches):.3f}",
        f'{ratio(sum(l["totals"]["warp_instructions"] for l in between), particles):.1f}',
        f'{ratio(sum(l["totals"]["warp_instructions"] for l in launches), particles):.1f}',
        f"{ratio(sum(map(special_functions, between)), contacts):.1f}",
        f"{ratio(sectors, requests):.1f}",
        f"{ratio(bytes_moved(launches), particles):,.0f}",
        f'{report["device_bytes_per_particle"]:,.0f}',
        f"{1e3 * seconds:.2f} ms" if seconds else "-",
        measured_step(readings, case["variant"]),
        f'{error["maximum"]:.1e}',
        f'{error["root_mean_square"]:.1e}',
        losses(between),
    )


def table(title, folder, readings):
    index = json.loads((folder / "index.json").read_text())
    # The grid of laws and searches first, then one value of another axis after the other.
    done = sorted((case for case in index["cases"] if case["status"] == "done"), key=lambda case: not case["variant"].endswith("/cell/fp32/default"))
    if not done:
        sys.exit(f"{folder}: no case that is done")
    reports = [json.loads((folder / case["report_file"]).read_text()) for case in done]
    contacts = contacts_of(reports)
    lines = [
        f"### {title}",
        "",
        f'{index["particles"]:,} particles, {contacts / index["particles"]:.2f} contacts with others each.',
        "",
        "| " + " | ".join(HEADINGS) + " |",
        "|---|" + "---:|" * (len(HEADINGS) - 2) + "---|",
    ]
    for case, report in zip(done, reports):
        lines.append("| " + " | ".join(row(case, report, index["particles"], contacts, readings)) + " |")
    return "\n".join(lines) + "\n"


def main():
    pages = [argument for argument in sys.argv[1:] if "=" not in argument]
    sweeps = [(argument.split("=") + [""])[:3] for argument in sys.argv[1:] if "=" in argument]
    if len(pages) > 1 or not sweeps:
        sys.exit(__doc__)
    text = "\n".join(table(title, pathlib.Path(folder), readings) for title, folder, readings in sweeps)
    if not pages:
        print(text)
        return
    page = pathlib.Path(pages[0])
    page.write_text(with_block(page, "tables", text))


if __name__ == "__main__":
    main()
