#!/usr/bin/env python3
"""Writes a sparse matrix whose rows have very different lengths, as the launch files beside this take it."""
import array
import random

random.seed(1)
N_ROWS = 4096
lengths = [max(1, int(random.paretovariate(1.2))) % 200 for _ in range(N_ROWS)]
starts = [0]
for length in lengths:
    starts.append(starts[-1] + length)
n_entries = starts[-1]
arrays = {
    "starts": array.array("I", starts),
    "columns": array.array("I", (random.randrange(N_ROWS) for _ in range(n_entries))),
    "values": array.array("f", (random.random() for _ in range(n_entries))),
    "order": array.array("I", sorted(range(N_ROWS), key=lambda row: lengths[row])),
}
for name, values in arrays.items():
    with open(f"{name}.bin", "wb") as file:
        values.tofile(file)
print(f"{n_entries} entries in {N_ROWS} rows, {max(lengths)} in the longest")
