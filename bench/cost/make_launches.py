#!/usr/bin/env python3
"""Launch files of the kernels of bench/cost/kernels.cl at several sizes: what the cost model's constants are fitted on.

    bench/cost/make_launches.py FOLDER

A file's name is KERNEL[-WHAT]-LOG2 OF THE WORK-ITEMS-WORK-GROUP SIZE.
"""
import pathlib
import shutil
import sys

UINT_OUTPUT = {"integers", "chase", "chase_uniform", "add_atomically", "few_groups"}


def uint(value):
    return f"<size=4 uint> {value}"


def number(value):
    return f"<size=4 float> {value}"


def uints(n):
    return f"<size={4 * n} uint range=0:1:{n - 1}>"


def floats(n):
    return f"<size={4 * n} float fill=1>"


def local(size):
    return f"<size={size}>"


class Launches:
    def __init__(self, folder):
        self.folder = folder

    def add(self, kernel, log2_items, arguments, what="", group=128, element=4, elements=None):
        """A launch whose first argument is its output, of `elements` (one a work-item) of `element` bytes."""
        items = 1 << log2_items
        kind = "uint" if kernel in UINT_OUTPUT else "double" if element == 8 else "float"
        lines = ["kernels.cl", kernel, f"{items} 1 1", f"{group} 1 1",
                 f"<size={element * (elements or items)} {kind} fill=0>", *arguments]
        name = f"{kernel}{what}-{log2_items}-{group}.sim"
        (self.folder / name).write_text("\n".join(lines) + "\n")


def of_every_size(launches, log2_items):
    n = 1 << log2_items
    trips = uint(64 if log2_items < 20 else 16)
    add = launches.add
    add("nothing", log2_items, [uint(1)])
    for kernel in ("multiply_add_chain", "multiply_adds"):
        add(kernel, log2_items, [trips, number(0.5)])
    for kernel in ("integers", "root_chain", "roots"):
        add(kernel, log2_items, [trips])
    add("doubles", log2_items, [trips, "<size=8 double> 0.5"], element=8)
    add("divisions", log2_items, [trips, number(3)])
    for table in (10, 17, 20):
        add("chase", log2_items, [uints(1 << table), uint((1 << table) - 1), uint(16)], what=f"-{table}")
    add("chase_uniform", log2_items, [uints(1 << 17), uint((1 << 17) - 1), uint(16)])
    for table in (14, 19):
        add("gather", log2_items, [floats(4 << table), uint((1 << table) - 1), uint(4)], what=f"-{table}")
    add("copy", log2_items, [floats(n), uint(n)])
    add("neighbours", log2_items, [floats(4 * n), uint(n - 1), uint(16)])
    add("scatter", log2_items, [uint(n - 1), uint(4)])
    add("add_atomically", log2_items, [uint(n - 1), uint(4)])
    add("exchange", log2_items, [uint(16), local(4 * 128)])
    add("few_groups", log2_items, [uints(1 << 17), uint((1 << 17) - 1), uint(16), local(40960)])
    add("uneven_lanes", log2_items, [floats(4 * n), uint(n - 1), uint(16)])
    add("uneven_warps", log2_items, [floats(4 * n), uint(n - 1), uint(64)])
    if log2_items < 20:
        add("neighbours", log2_items, [floats(4 * n), uint(n - 1), uint(64)], what="-long")
        add("rows", log2_items, [floats(32 * n), uint(32)])


def of_other_groups(launches):
    n = 1 << 17
    for group in (64, 256):
        launches.add("nothing", 17, [uint(1)], group=group)
        launches.add("neighbours", 17, [floats(4 * n), uint(n - 1), uint(64)], group=group)
        launches.add("uneven_lanes", 17, [floats(4 * n), uint(n - 1), uint(16)], group=group)


def beyond_the_cache(launches):
    slots_a_lane = 12
    for log2_items in (17, 18, 20):
        n = 1 << log2_items
        rows = floats(4 * slots_a_lane * n)
        output = {"element": 16, "elements": slots_a_lane * n}
        for trips in (4, 8, 12) if log2_items < 20 else (6,):
            launches.add("slots", log2_items, [rows, uint(slots_a_lane), uint(trips)], what=f"-{trips}", **output)
        launches.add("uneven_slots", log2_items, [rows, uint(slots_a_lane), uint(slots_a_lane)], **output)
        launches.add("moved_slots", log2_items, [rows, uint(slots_a_lane), uint(6), uint(n - 1)], **output)
    for table in (20, 22, 24):
        launches.add("fill", 18 if table == 20 else 20, [uint(1 << table)], what=f"-{table}", element=16,
                     elements=1 << table)
        launches.add("copy", 20, [floats(4 << table), uint(4 << table)], what=f"-{table + 2}", elements=4 << table)
    launches.add("rows", 20, [floats(32 << 20), uint(32)])
    launches.add("rows", 20, [floats(32 << 20), uint(8)], what="-short")


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(pathlib.Path(__file__).parent / "kernels.cl", folder)
    launches = Launches(folder)
    for log2_items in (12, 14, 17, 20):
        of_every_size(launches, log2_items)
    of_other_groups(launches)
    beyond_the_cache(launches)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]))
