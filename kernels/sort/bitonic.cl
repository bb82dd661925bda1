// Bitonic sort of the map, ascending. n_keys is a power of two and a multiple of the block (the map
// pads it with largest keys). Strides that fit a block run in local memory; longer ones are a launch each.

#include "prelude.h"
#include "sort/exchange.h"

#define SORT_BLOCK (2 * SORT_WORK_GROUP)

// Sorts each block: the sequences of size 2 to SORT_BLOCK, whose direction alternates with their place.
KERNEL WORK_GROUP_OF(SORT_WORK_GROUP) void sort_blocks(GLOBAL ulong* cell_keys) {
  LOCAL ulong block[SORT_BLOCK];
  const uint item = work_item_in_group();
  const uint base = work_group() * SORT_BLOCK;
  block[item] = cell_keys[base + item];
  block[item + SORT_WORK_GROUP] = cell_keys[base + item + SORT_WORK_GROUP];
  sort_block(block, base, SORT_BLOCK);
  cell_keys[base + item] = block[item];
  cell_keys[base + item + SORT_WORK_GROUP] = block[item + SORT_WORK_GROUP];
}

// One stride of the merge to sequences of `size`, for strides of a block and more. One work-item a
// comparator.
KERNEL WORK_GROUP_OF(SORT_WORK_GROUP) void merge_stride(GLOBAL ulong* cell_keys, const uint size,
                                                        const uint stride) {
  const uint first = first_of_pair(work_item(), stride);
  const bool ascending = (first & size) == 0;
  const ulong a = cell_keys[first];
  const ulong b = cell_keys[first + stride];
  if ((a > b) == ascending) {  // branch: exchange
    cell_keys[first] = b;
    cell_keys[first + stride] = a;
  }
}

// The remaining strides of the merge to sequences of `size`, all inside blocks.
KERNEL WORK_GROUP_OF(SORT_WORK_GROUP) void merge_blocks(GLOBAL ulong* cell_keys, const uint size) {
  LOCAL ulong block[SORT_BLOCK];
  const uint item = work_item_in_group();
  const uint base = work_group() * SORT_BLOCK;
  block[item] = cell_keys[base + item];
  block[item + SORT_WORK_GROUP] = cell_keys[base + item + SORT_WORK_GROUP];
  for (uint stride = SORT_BLOCK / 2; stride > 0; stride /= 2) {
    work_group_barrier_local();
    exchange_in_block(block, base, size, stride);
  }
  work_group_barrier_local();
  cell_keys[base + item] = block[item];
  cell_keys[base + item + SORT_WORK_GROUP] = block[item + SORT_WORK_GROUP];
}
