// What a bitonic sort in local memory is made of.
#ifndef WARPGRAIN_EXCHANGE_H
#define WARPGRAIN_EXCHANGE_H

#include "prelude.h"

// The first of the two elements that comparator `comparator` of a stride exchanges.
DEVICE_FUNCTION uint first_of_pair(uint comparator, uint stride) {
  return 2 * comparator - (comparator & (stride - 1));
}

DEVICE_FUNCTION void exchange_in_block(LOCAL_POINTER ulong* block, uint base, uint size, uint stride) {
  const uint first = first_of_pair(work_item_in_group(), stride);
  const bool ascending = ((base + first) & size) == 0;
  const ulong a = block[first];
  const ulong b = block[first + stride];
  block[first] = ascending ? min(a, b) : max(a, b);
  block[first + stride] = ascending ? max(a, b) : min(a, b);
}

// Sorts a block of two keys a work-item; `base` keys lie before it. Every other block descends, so that it
// and the one before are a bitonic sequence.
DEVICE_FUNCTION void sort_block(LOCAL_POINTER ulong* block, uint base, uint n_in_block) {
  for (uint size = 2; size <= n_in_block; size *= 2) {
    for (uint stride = size / 2; stride > 0; stride /= 2) {
      work_group_barrier_local();
      exchange_in_block(block, base, size, stride);
    }
  }
  work_group_barrier_local();
}

#endif
