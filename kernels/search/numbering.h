// Numbering through what the work-items of a group have several of each, so that each number goes to one of
// them, whoever's it is.
#ifndef WARPGRAIN_NUMBERING_H
#define WARPGRAIN_NUMBERING_H

#include "prelude.h"

// Inclusive sums over the first n work-items, a power of two, in place.
DEVICE_FUNCTION void sum_up(LOCAL_POINTER uint* ends, uint item, uint n) {
  for (uint stride = 1; stride < n; stride *= 2) {
    const uint before = item >= stride ? ends[item - stride] : 0;
    work_group_barrier_local();
    ends[item] += before;
    work_group_barrier_local();
  }
}

// Whose number it is: the first whose numbers end behind it.
DEVICE_FUNCTION uint owner_of(uint number, LOCAL_POINTER const uint* ends, uint n) {
  uint owner = 0;
  for (uint step = n / 2; step > 0; step /= 2) owner += ends[owner + step - 1] <= number ? step : 0;
  return owner;
}
DEVICE_FUNCTION uint number_within(uint number, uint owner, LOCAL_POINTER const uint* ends) {
  return number - (owner > 0 ? ends[owner - 1] : 0);
}

#endif
