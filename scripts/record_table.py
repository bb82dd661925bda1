#!/usr/bin/env python3
"""Records OpenCL programs of Debian and writes the tables of docs/record.md.

    scripts/record_table.py --warpgrain build/release/cli/warpgrain docs/record.md

writes, between the page's lines <!-- begin tables --> and <!-- end tables -->, the kernels of each program that is
installed, and what recording cost. Without a page the tables go to stdout. The programs (Debian 12):

    apt-get install --no-install-recommends clpeak clblast-utils clfft-client python3-pyopencl python-pyopencl-doc \\
        python3-imageio python3-pil.imagetk darktable

Cost is processor time, which other programs on the machine disturb less than the clock: of the program alone, of
record as a whole, and of `warpgrain profile` on each of the launch files that record has saved, one by one.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile

from page_block import with_block

EXAMPLES = "/usr/share/doc/python-pyopencl-doc/examples"
# What is recorded, with the options of record. Debian's python3, whatever else is in PATH.
PROGRAMS = (
    ("", f"/usr/bin/python3 {EXAMPLES}/demo_array.py"),
    ("", f"/usr/bin/python3 {EXAMPLES}/demo_elementwise.py"),
    ("", f"/usr/bin/python3 {EXAMPLES}/demo-struct-reduce.py"),
    ("", f"/usr/bin/python3 {EXAMPLES}/median-filter.py"),
    ("", f"/usr/bin/python3 {EXAMPLES}/demo_mandelbrot.py"),
    ("--first 1 --largest 300000", f"/usr/bin/python3 {EXAMPLES}/n-body.py"),
    ("--first 1", "clFFT-client -x 1024 -b 16"),
    ("--first 1", "clFFT-client -x 243 -y 125"),
    ("--first 1", "clblast_tuner_xdot -n 65536 -runs 1 -fraction 8"),
    ("--first 1", "clblast_tuner_xger -n 128 -m 128 -runs 1 -fraction 16"),
    ("--first 1", "clblast_tuner_copy_fast -n 256 -m 256 -runs 1 -fraction 8"),
    ("--first 1 --largest 300000", "clpeak --kernel-latency --compute-integer"),
    ("--first 2", "darktable-cli noisyImage.jpg lowpass.xmp out.png --core --configdir config --cachedir cache --library :memory: --conf opencl=TRUE"),
)
ENVIRONMENT = {"PYOPENCL_NO_CACHE": "1", "PYOPENCL_CTX": "0"}
LEFT_BEHIND = ("cache", "out.png")  # darktable's programs as binaries, which record has no source of; its picture
DARKTABLE_KERNELS = "/usr/share/darktable/kernels"
# One module, whose Gaussian blur works on buffers: order, radius, contrast, brightness, saturation, algorithm, unbound.
LOWPASS = """<?xml version="1.0" encoding="UTF-8"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description xmlns:darktable="http://darktable.sf.net/" darktable:xmp_version="4" darktable:auto_presets_applied="1"
 darktable:history_end="1"><darktable:history><rdf:Seq><rdf:li darktable:num="0" darktable:operation="lowpass"
 darktable:enabled="1" darktable:modversion="4" darktable:params="%s" darktable:multi_priority="0"/>
</rdf:Seq></darktable:history></rdf:Description></rdf:RDF></x:xmpmeta>
""" % struct.pack("<iffffii", 0, 10, 1, 0, 1, 0, 1).hex()


def prepare_darktable(words, folder):
    """Lets it take PoCL's device, which it turns away for being a CPU, and lets PoCL find its headers: darktable says -I"FOLDER",
    PoCL 3.1 keeps the quotes, but looks beside the source, too, which stands in its cache."""
    pathlib.Path(folder, "lowpass.xmp").write_text(LOWPASS)
    shutil.copytree(DARKTABLE_KERNELS, f"{folder}/pocl", dirs_exist_ok=True)
    run(words, folder)
    settings = pathlib.Path(folder, "config", "darktablerc")
    disabled = r"^(cldevice_v4_pthread\w*=(?:\S+ ){7})1 "
    settings.write_text(re.sub(disabled, r"\g<1>0 ", settings.read_text(), flags=re.M))


def run(words, folder):
    """Runs a program in a folder; its processor time in seconds, with that of what it started, and what it said on stderr."""
    for name in LEFT_BEHIND:
        path = pathlib.Path(folder, name)
        shutil.rmtree(path) if path.is_dir() else path.unlink(missing_ok=True)
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(
            words, cwd=folder, env={**os.environ, **ENVIRONMENT, "POCL_CACHE_DIR": f"{folder}/pocl"},
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors,
        )
        _, status, usage = os.wait4(process.pid, 0)
        code = os.waitstatus_to_exitcode(status)
        process.returncode = code if code >= 0 else 128 - code  # as a shell and record say it
        errors.seek(0)
        return usage.ru_utime + usage.ru_stime, process.returncode, errors.read().decode(errors="replace")


def worst_branch(launches):
    """Where most lane slots are lost, with its share of all that are lost."""
    lost = collections.Counter()
    for launch in launches:
        lost["warps that are not full from the start"] += launch["lane_slots_never_used"]
        for branch in launch["branches"]:
            label = " ".join(branch["label"].split())
            lost[f'`{label[:60]}`' if label else f'{branch["file"]}:{branch["line"]}'] += branch["lane_slots_lost"]
    (label, slots), = lost.most_common(1)
    if slots == 0:
        return "none"
    return f"{label.replace('|', chr(92) + '|')} {100 * slots / sum(lost.values()):.0f} %"


def kernel_rows(program, report):
    by_kernel = collections.defaultdict(list)
    for launch in report["launches"]:
        by_kernel[launch["kernel"]].append(launch)
    for kernel, launches in by_kernel.items():
        threads = sum(l["totals"]["thread_instructions"] for l in launches)
        slots = sum(l["totals"]["warp_instructions"] * l["warp_width"] for l in launches)
        warps = sum(l["totals"]["warp_instructions"] for l in launches)
        yield (program, f"`{kernel}`", len(launches), f"{threads / slots:.3f}", f"{warps:,}", worst_branch(launches))


def record(warpgrain, options, command):
    """The report, the rows of its kernels, and the row of its cost."""
    words = shlex.split(command)
    name = " ".join([os.path.basename(words[0]), *(os.path.basename(w) for w in words[1:])])
    name = name.partition(" --core ")[0]  # behind it only where darktable keeps its things
    name = f"`{name}`" + (f" ({options})" if options else "")
    with tempfile.TemporaryDirectory() as folder:
        if os.path.exists(f"{EXAMPLES}/noisyImage.jpg"):
            shutil.copy(f"{EXAMPLES}/noisyImage.jpg", folder)  # which an example asks for
        if words[0] == "darktable-cli":
            prepare_darktable(words, folder)
        run(words, folder)  # so that PoCL has its kernels in its cache
        alone, status_alone, _ = run(words, folder)
        saved, json_file = pathlib.Path(folder, "saved"), pathlib.Path(folder, "r.json")
        call = [warpgrain, "record", *shlex.split(options), "--quiet", "--save", saved, "--json", json_file, "--", *words]
        recorded, status, errors = run(call, folder)
        if status != status_alone:
            raise RuntimeError(f"{command}: status {status}, alone {status_alone}\n{errors}")
        if not json_file.exists():
            raise RuntimeError(f"{command}: {errors}")
        report = json.loads(json_file.read_text())
        files = sorted(saved.glob("launch-*.sim"))
        profiled = sum(run([warpgrain, "profile", "--quiet", f], folder)[0] for f in files)
    remarks = [line.removeprefix("warpgrain record: ") for line in errors.splitlines() if line.startswith("warpgrain record: ")]
    cost = (name, len(files), f"{alone:.1f}", f"{recorded:.1f}", f"{profiled:.1f}", f"{(recorded - alone) / profiled:.2f}" if files else "-")
    return list(kernel_rows(name, report)), cost, remarks


def table(headings, rows):
    lines = [" | ".join(headings), "|".join("---" for _ in headings), *(" | ".join(map(str, row)) for row in rows)]
    return "\n".join(f"| {line} |" if set(line) != {"-", "|"} else f"|{line}|" for line in lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--warpgrain", default="build/release/cli/warpgrain")
    parser.add_argument("page", nargs="?")
    arguments = parser.parse_args()
    kernels, costs, remarks = [], [], []
    for options, command in PROGRAMS:
        program = shlex.split(command)
        if not shutil.which(program[0]) or not all(os.path.exists(w) for w in program[1:] if w.startswith("/")):
            print(f"not installed: {command}", file=sys.stderr)
            continue
        print(command, file=sys.stderr)
        rows, cost, notes = record(os.path.abspath(arguments.warpgrain), options, command)
        kernels += rows
        costs.append(cost)
        print("  " + ", ".join(map(str, cost[1:])), file=sys.stderr)
        remarks += [f"* {cost[0]}: {note}" for note in notes]
    text = table(("program", "kernel", "launches", "SIMT efficiency", "warp instructions", "lane slots lost most at"), kernels)
    text += "\n" + table(
        ("program", "launches", "alone, CPU s", "record, CPU s", "profile of the saved files, CPU s", "(record - alone) / profile"), costs
    )
    if remarks:
        text += "\nWhat record said of them:\n\n" + "\n".join(remarks) + "\n"
    if not arguments.page:
        sys.stdout.write(text)
        return
    page = pathlib.Path(arguments.page)
    page.write_text(with_block(page, "tables", text))


if __name__ == "__main__":
    main()
