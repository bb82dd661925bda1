#!/usr/bin/python3
"""The replay's rules of which lanes run together against an NVIDIA GPU's counts of kernels of known control flow.

reports/measured/exactness/reconvergence.tar.xz holds 103 kernels, 813 launches of one warp each, and of every launch what an
H100 counted and in which order groups of lanes passed the places that its lanes wrote down. Replays the launches and says,
by kernel, of how many warp and thread instructions are exact. Kernels `yield_...` are left out: YIELD was put into their
machine code, which their PTX does not say. Needs no GPU; without ptxas the status is 77.

    scripts/reconvergence.py [--every N] [KERNEL...]      each N-th launch, all without
    scripts/reconvergence.py --check | --write            holds a part of the launches against tests/exactness/reconvergence.json
"""

import argparse
import concurrent.futures
import csv
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIP = 77
EXACT = ROOT / "tests/exactness/reconvergence.json"  # of each kernel: launches, replayed, warps exact, threads exact
CHECKED_EVERY = 4


def write_launch(folder, row, choices):
    """A launch file: what each lane chooses, in turn and again from the first; room for its log."""
    name = f"{row['launch']}.{row['kernel']}"
    lanes, n_choices, n_log = int(row["lanes"]), int(row["choices"]), int(row["log"])
    (folder / f"{name}.choices").write_bytes(struct.pack(f"<{len(choices)}I", *choices))
    launch = folder / f"{name}.sim"
    launch.write_text(f"kernels/{row['kernel']}.ptx\n{row['kernel']}\n{lanes} 1 1\n{lanes} 1 1\n"
                      f"<size={4 * len(choices)} uint file={name}.choices>\n<size={lanes * n_log * 16} uint fill=0>\n"
                      f"<size=4 uint> {n_choices}\n<size=4 uint> {n_log}\n", encoding="utf-8")
    return launch


def replayed(warpgrain, launch):
    """Warp and thread instructions, or None where the traces do not tell all decisions."""
    report = launch.with_suffix(".json")
    run = subprocess.run([warpgrain, "profile", launch, "--weights", "auto", "--arch", "sm_90", "--unchecked", "--threads", "1",
                          "--quiet", "--json", report], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    if run.returncode != 0:
        sys.exit(run.stderr.strip())
    found = json.loads(report.read_text(encoding="utf-8"))["launches"][0]
    if not found.get("replay", {}).get("used"):
        return None
    return found["totals"]["warp_instructions"], found["totals"]["thread_instructions"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kernels", nargs="*", metavar="KERNEL")
    parser.add_argument("--warpgrain", default=ROOT / "build/release/cli/warpgrain")
    parser.add_argument("--every", type=int, default=1, metavar="N")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    if arguments.check or arguments.write:
        arguments.every = CHECKED_EVERY
    if not shutil.which("ptxas") and not os.access("/usr/local/cuda/bin/ptxas", os.X_OK):
        print("skipped: no ptxas on PATH or in /usr/local/cuda/bin", file=sys.stderr)
        sys.exit(SKIP)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        with tarfile.open(ROOT / "reports/measured/exactness/reconvergence.tar.xz") as archive:
            archive.extractall(folder)
        with open(folder / "launches.csv", newline="", encoding="utf-8") as lines:
            rows = list(csv.DictReader(lines))
        choices, at, launches = (folder / "choices.bin").read_bytes(), 0, []
        for k, row in enumerate(rows):
            size = int(row["lanes"]) * int(row["choices"])
            wanted = not row["kernel"].startswith("yield_") and k % arguments.every == 0
            if wanted and (not arguments.kernels or row["kernel"] in arguments.kernels):
                launches.append((row, write_launch(folder, row, choices[at:at + size])))
            at += size
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            counts = list(pool.map(lambda launch: replayed(arguments.warpgrain, launch[1]), launches))
    sums = {}
    for (row, _), count in zip(launches, counts):
        has_yield = row["kernel"].endswith("_y") or row["kernel"] in ("random19", "random21")
        for key in (row["kernel"], "all with a YIELD" if has_yield else "all without a YIELD"):
            found = sums.setdefault(key, [0, 0, 0, 0])
            found[0] += 1
            found[1] += count is not None
            found[2] += count is not None and count[0] == int(row["warp_instructions"])
            found[3] += count is not None and count[1] == int(row["thread_instructions"])
    if arguments.write:
        EXACT.write_text("{\n" + ",\n".join(f'"{key}": {json.dumps(sums[key])}' for key in sorted(sums)) + "\n}\n", encoding="utf-8")
    if arguments.check:
        less = [f"{key}: {sums.get(key)}, expected {known}" for key, known in json.loads(EXACT.read_text(encoding="utf-8")).items()
                if key not in sums or any(now < before for now, before in zip(sums[key], known))]
        if less:
            sys.exit("\n".join(less))
        print(f"{len(launches)} launches are as exact as they were")
        return
    print(f"{'kernel':20} launches replayed warps exact threads exact")
    for key in sorted(sums, key=lambda key: (key.startswith("all"), key)):
        print(f"{key:20} {sums[key][0]:8} {sums[key][1]:8} {sums[key][2]:11} {sums[key][3]:13}")


if __name__ == "__main__":
    main()
