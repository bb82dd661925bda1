// How a kernel says that the run cannot go on. The host reads `status` before it hands out any result.
#ifndef WARPGRAIN_STATUS_H
#define WARPGRAIN_STATUS_H

#include "prelude.h"

// Keeps the smallest rank, so that the message does not depend on the order of the work-items.
DEVICE_FUNCTION void report_error(GLOBAL uint* status, uint error, uint rank) {
  if (status[STATUS_STOPPED] == 0) atomic_min(&status[error], rank);
}

// One work-item calls this at the start of a step: the first failure freezes the count at its step.
DEVICE_FUNCTION void count_step(GLOBAL uint* status) {
  for (uint error = STATUS_OUT_OF_DOMAIN; error < STATUS_SIZE; ++error) {
    if (status[error] != NO_PARTICLE) status[STATUS_STOPPED] = 1;
  }
  if (status[STATUS_STOPPED] == 0) status[STATUS_STEPS] += 1;
}

#endif
