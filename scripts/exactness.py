#!/usr/bin/python3
"""Counts of the replay over machine code beside an NVIDIA GPU's, launch by launch.

Replays every launch of a reading (reports/measured/exactness/, made by scripts/measure_exactness.sh) in the simulator, for
the architecture that it was read on, and compares. Needs no GPU; without ptxas there is nothing to replay, and the status
is 77.

    scripts/exactness.py                     the table, to stdout
    scripts/exactness.py --write             docs/exactness.md, and tests/exactness/exact.json: what is exact now, and which launches keep the bound
    scripts/exactness.py --check             status 1 when something in exact.json no longer is
    scripts/exactness.py NAME...             these launches alone, with every number
"""

import argparse
import concurrent.futures
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIP = 77

# A report's key, Nsight Compute's metric, the table's heading.
METRICS = [
    ("warp_instructions", "smsp__inst_executed.sum", "warp instr."),
    ("thread_instructions", "smsp__thread_inst_executed.sum", "thread instr."),
    ("thread_instructions_pred_on", "smsp__thread_inst_executed_pred_on.sum", "of these pred. on"),
    ("sfu_instructions", "smsp__inst_executed_pipe_xu.sum", "SFU"),
    ("divergent_branches", "smsp__sass_branch_targets_threads_divergent.sum", "div. branches"),
    ("global_load_requests", "l1tex__t_requests_pipe_lsu_mem_global_op_ld.sum", "load req."),
    ("global_load_sectors", "l1tex__t_sectors_pipe_lsu_mem_global_op_ld.sum", "load sect."),
    ("global_store_requests", "l1tex__t_requests_pipe_lsu_mem_global_op_st.sum", "store req."),
    ("global_store_sectors", "l1tex__t_sectors_pipe_lsu_mem_global_op_st.sum", "store sect."),
]
# The columns of ncu's table of machine instructions that add up to a launch's.
SOURCE_VIEW = [
    ("warp_instructions", "Instructions Executed", "warp, by table"),
    ("thread_instructions", "Thread Instructions Executed", "thread, by table"),
]
INSTRUCTION_BOUND = 0.5  # percent, of warp and thread instructions and of efficiency
WITHIN = "within_bound"  # in exact.json, of launches that keep it


def skip(reason):
    print(f"skipped: {reason}", file=sys.stderr)
    sys.exit(SKIP)


def counted_by_gpu(file):
    """Metric -> number, of ncu's raw page: a heading, a row of units, the launch."""
    with open(file, newline="", encoding="utf-8") as lines:
        heading, _, launch = list(csv.reader(line for line in lines if line.startswith('"')))
    values = dict(zip(heading, launch))
    return {key: float(values[name].replace(",", "")) for key, name, _ in METRICS if name in values}


def summed_by_table(file):
    """Key -> number, of ncu's page of machine instructions."""
    with open(file, newline="", encoding="utf-8") as lines:
        rows = list(csv.reader(lines))
    at = next(k for k, row in enumerate(rows) if "Source" in row)
    return {key: sum(int(row[rows[at].index(name)]) for row in rows[at + 1:] if len(row) == len(rows[at]))
            for key, name, _ in SOURCE_VIEW}


def replayed(warpgrain, launch, arch, folder):
    """Metric -> number, and why it is not of the machine code where it is not."""
    report = folder / (launch.name + ".json")
    run = subprocess.run(
        [warpgrain, "profile", launch, "--weights", "auto", "--arch", arch, "--unchecked", "--threads", "1", "--quiet",
         "--json", report], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    if run.returncode != 0:
        return {}, run.stderr.strip().split("\n")[0]
    launch_report = json.loads(report.read_text(encoding="utf-8"))["launches"][0]
    replay = launch_report.get("replay", {})
    why = "" if replay.get("used") else replay.get("reason", "counted by its PTX")
    return {key: launch_report["totals"][key] for key, _, _ in METRICS if key in launch_report["totals"]}, why


class Row:
    """A launch, counted twice."""

    def __init__(self, name, gpu, table, ours, why):
        self.name, self.gpu, self.table, self.ours, self.why = name, gpu, table, ours, why

    def difference(self, key, gpu=None):
        """In percent of the GPU's; None where one of both has not counted it."""
        gpu = self.gpu if gpu is None else gpu
        if key not in gpu or key not in self.ours:
            return None
        if gpu[key] == self.ours[key]:
            return 0.0
        return 100 * (self.ours[key] / gpu[key] - 1) if gpu[key] else float("inf")

    def efficiency_difference(self):
        warps, threads = self.difference("warp_instructions"), self.difference("thread_instructions")
        if warps is None or threads is None:
            return None
        return 100 * ((1 + threads / 100) / (1 + warps / 100) - 1)

    def exact(self):
        return [] if self.why else [key for key, _, _ in METRICS if self.difference(key) == 0]

    def is_within(self):
        differences = [self.difference("warp_instructions"), self.difference("thread_instructions"),
                       self.efficiency_difference()]
        return not self.why and all(d is not None and abs(d) <= INSTRUCTION_BOUND for d in differences)

    def held(self):
        """What must not become worse."""
        return self.exact() + ([WITHIN] if self.is_within() else [])


def cell(difference):
    if difference is None:
        return "-"
    if difference == 0:
        return "="
    if difference == float("inf"):
        return "from 0"
    return f"{difference:+.2f} %" if abs(difference) >= 0.005 else f"{difference:+.0e} %"


def document(rows, machine, archives):
    lines = [
        "# Exactness", "",
        "Written by `scripts/exactness.py --write` from " + " and ".join(
            f"[{archive.name}](../{archive.resolve().relative_to(ROOT)})" for archive in archives) + ": what the replay",
        "over machine code counts of each launch, beside the hardware counters of", "", "```", *machine, "```", "",
        "Launches `nvidia_opencl-…` are of PTX that NVIDIA's OpenCL compiler made, `nvcc-…` and `shuffles` of nvcc's, the others of clang's.", "",
        "`=` is equal to the last instruction; else the difference in percent of the GPU's count. `-`: not counted.", ""]
    within = [row for row in rows if row.is_within()]
    lines.append(f"* {len(within)} of {len(rows)} launches have warp instructions, thread instructions and SIMT efficiency "
                 f"within {INSTRUCTION_BOUND} %.")
    for key, _, heading in METRICS:
        counted = [row for row in rows if row.difference(key) is not None]
        if counted:
            exact = sum(key in row.exact() for row in counted)
            lines.append(f"* {heading}: exact in {exact} of {len(counted)}.")
    headings = [heading for _, _, heading in METRICS]
    headings.insert(2, "efficiency")
    for key, _, heading in SOURCE_VIEW:
        exact = sum(row.difference(key, row.table) == 0 for row in rows)
        lines.append(f"* {heading} of machine instructions: exact in {exact} of {len(rows)}.")
    headings += [heading for _, _, heading in SOURCE_VIEW]
    lines += ["", "| launch | " + " | ".join(headings) + " |", "|---|" + "---:|" * len(headings)]
    for row in rows:
        cells = [cell(row.difference(key)) for key, _, _ in METRICS]
        cells.insert(2, cell(row.efficiency_difference()))
        cells += [cell(row.difference(key, row.table)) for key, _, _ in SOURCE_VIEW]
        lines.append(f"| {row.name}{'' if not row.why else ' (1)' } | " + " | ".join(cells) + " |")
    by_ptx = [row for row in rows if row.why]
    if by_ptx:
        lines += ["", "(1) Not replayed; these counts are of the PTX:", ""]
        lines += [f"* {row.name}: {row.why}" for row in by_ptx]
    lines += ["", (ROOT / "tests/exactness/reasons.md").read_text(encoding="utf-8").rstrip()]
    return "\n".join(lines) + "\n"


def measured_rows(arguments, folder):
    for readings in arguments.readings:
        with tarfile.open(readings) as archive:
            archive.extractall(folder)
    launches = sorted((folder / "launches").rglob("*.sim"))
    names = ["-".join(launch.relative_to(folder / "launches").with_suffix("").parts) for launch in launches]
    chosen = [(n, l) for n, l in zip(names, launches) if not arguments.names or n in arguments.names]
    if not chosen:
        sys.exit("no such launch; there are: " + ", ".join(names))

    def row(name_and_launch):
        name, launch = name_and_launch
        times = json.loads((folder / "times" / f"{name}.json").read_text(encoding="utf-8"))
        with tempfile.TemporaryDirectory() as own:
            ours, why = replayed(arguments.warpgrain, launch, times["device"]["architecture"], pathlib.Path(own))
        return Row(name, counted_by_gpu(folder / "counters" / f"{name}.csv"),
                   summed_by_table(folder / "instructions" / f"{name}.csv"), ours, why)

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        rows = list(pool.map(row, chosen))
    machine = [line.strip() for line in (folder / "machine.txt").read_text(encoding="utf-8").splitlines()
               if "Product Name" in line or "Driver Version" in line or "Version 2" in line or "release" in line]
    return rows, machine


def check(rows, expected):
    failures = []
    for row in rows:
        for key in expected.get(row.name, []):
            if key not in row.held():
                what = (f"was within {INSTRUCTION_BOUND} %" if key == WITHIN
                        else f"{key} was exact and is {cell(row.difference(key))} off")
                failures.append(f"{row.name}: {what}"
                                + (f" ({row.why})" if row.why else ""))
    missing = set(expected) - {row.name for row in rows}
    failures += [f"{name}: not in the readings" for name in sorted(missing)]
    print("\n".join(failures) if failures else f"{sum(map(len, expected.values()))} counts of {len(rows)} launches are as exact as they were")
    return 1 if failures else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--warpgrain", default=ROOT / "build/release/cli/warpgrain")
    measured = ROOT / "reports/measured/exactness"
    parser.add_argument("--readings", type=pathlib.Path, nargs="+",
                        default=[measured / "h100.tar.xz", measured / "h100_variants.tar.xz", measured / "nvidia_opencl.tar.xz"])
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    if not shutil.which("ptxas") and not os.access("/usr/local/cuda/bin/ptxas", os.X_OK):
        skip("no ptxas on PATH or in /usr/local/cuda/bin")
    usage = subprocess.run([arguments.warpgrain, "profile", "--help"], capture_output=True, text=True, check=False)
    if "--weights" not in usage.stdout:
        skip(f"{arguments.warpgrain} replays no machine code")
    exact_file = ROOT / "tests/exactness/exact.json"
    with tempfile.TemporaryDirectory() as folder:
        rows, machine = measured_rows(arguments, pathlib.Path(folder))
    if arguments.check:
        if not exact_file.exists():
            skip("no tests/exactness/exact.json yet: scripts/exactness.py --write")
        sys.exit(check(rows, json.loads(exact_file.read_text(encoding="utf-8"))))
    if arguments.names:
        for row in rows:
            print(row.name, row.why)
            for key, _, _ in METRICS:
                print(f"  {key:30} {row.gpu.get(key, '-'):>12} {row.ours.get(key, '-'):>12} {cell(row.difference(key)):>10}")
        return
    text = document(rows, machine, arguments.readings)
    if not arguments.write:
        print(text, end="")
        return
    (ROOT / "docs/exactness.md").write_text(text, encoding="utf-8")
    exact = ",\n".join(f'  "{row.name}": {json.dumps(row.held())}' for row in rows)
    exact_file.write_text("{\n" + exact + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
