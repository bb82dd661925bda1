// Sorts the map by counting: how many particles each cell has, where each cell begins by an exclusive scan of
// the counts, and each key to a place of its cell. Which place of its cell a key gets depends on the order of
// atomics, so that the few keys of a cell are sorted at the end: the map is the same as the bitonic sort's.
// Cells get their ranges on the way.

#include "prelude.h"

// The second number of a cell's range counts its particles, then the keys placed.
KERNEL void count_cells(const StepParameters p, GLOBAL const ulong* keys, GLOBAL uint* cell_ranges) {
  const uint particle = work_item();
  if (particle >= p.n_particles) return;  // branch: beyond the last particle
  atomic_inc(&cell_ranges[2 * (uint)(keys[particle] >> 32) + 1]);
}

// Exclusive scan of one number a work-item in local memory [SCAN_WORK_GROUP] (Hillis and Steele 1986); the
// sum of all in *total.
DEVICE_FUNCTION uint scan_of_group(uint value, LOCAL_POINTER uint* sums, uint* total) {
  const uint item = work_item_in_group();
  sums[item] = value;
  work_group_barrier_local();
  for (uint stride = 1; stride < SCAN_WORK_GROUP; stride *= 2) {
    const uint before = item >= stride ? sums[item - stride] : 0;
    work_group_barrier_local();
    sums[item] += before;
    work_group_barrier_local();
  }
  const uint inclusive = sums[item];
  *total = sums[SCAN_WORK_GROUP - 1];
  work_group_barrier_local();
  return inclusive - value;
}

// Where cells begin within their block of SCAN_BLOCK cells, and the sum of each block.
KERNEL WORK_GROUP_OF(SCAN_WORK_GROUP) void scan_blocks(const StepParameters p, GLOBAL uint* cell_ranges,
                                                       GLOBAL uint* block_sums) {
  LOCAL uint sums[SCAN_WORK_GROUP];
  const uint first = work_group() * SCAN_BLOCK + work_item_in_group() * SCAN_CELLS;
  uint counts = 0;
  for (uint k = 0; k < SCAN_CELLS; ++k)
    counts += first + k < p.n_cells ? cell_ranges[2 * (first + k) + 1] : 0;
  uint total;
  uint begin = scan_of_group(counts, sums, &total);
  for (uint k = 0; k < SCAN_CELLS; ++k) {
    if (first + k >= p.n_cells) break;  // branch: beyond the last cell
    cell_ranges[2 * (first + k)] = begin;
    begin += cell_ranges[2 * (first + k) + 1];
  }
  if (work_item_in_group() == 0) block_sums[work_group()] = total;
}

// The sums of blocks become where they begin: one work-group goes through them.
KERNEL WORK_GROUP_OF(SCAN_WORK_GROUP) void scan_sums(const uint n_blocks, GLOBAL uint* block_sums) {
  LOCAL uint sums[SCAN_WORK_GROUP];
  uint before = 0;
  for (uint first = 0; first < n_blocks; first += SCAN_WORK_GROUP) {
    const uint block = first + work_item_in_group();
    uint total;
    const uint begin = scan_of_group(block < n_blocks ? block_sums[block] : 0, sums, &total);
    if (block < n_blocks) block_sums[block] = before + begin;
    before += total;
  }
}

KERNEL void place_cells(const StepParameters p, GLOBAL const uint* block_sums, GLOBAL uint* cell_ranges) {
  const uint cell = work_item();
  if (cell >= p.n_cells) return;  // branch: beyond the last cell
  const uint begin = cell_ranges[2 * cell] + block_sums[cell / SCAN_BLOCK];
  cell_ranges[2 * cell] = begin;
  cell_ranges[2 * cell + 1] = begin;
}

KERNEL void place_keys(const StepParameters p, GLOBAL const ulong* keys, GLOBAL uint* cell_ranges,
                       GLOBAL ulong* sorted_keys) {
  const uint particle = work_item();
  if (particle >= p.n_particles) return;  // branch: beyond the last particle
  const ulong key = keys[particle];
  sorted_keys[atomic_inc(&cell_ranges[2 * (uint)(key >> 32) + 1])] = key;
}

// By insertion: a cell has a few particles.
KERNEL void sort_cells(const StepParameters p, GLOBAL const uint2* cell_ranges, GLOBAL ulong* sorted_keys) {
  const uint cell = work_item();
  if (cell >= p.n_cells) return;  // branch: beyond the last cell
  const uint2 range = cell_ranges[cell];
  for (uint next = range.x + 1; next < range.y; ++next) {  // branch: next key
    const ulong key = sorted_keys[next];
    uint place = next;
    for (; place > range.x && sorted_keys[place - 1] > key; --place)  // branch: greater key before
      sorted_keys[place] = sorted_keys[place - 1];
    sorted_keys[place] = key;
  }
}
