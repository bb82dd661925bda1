#pragma once
// How long a time step takes.

#include <cstdint>

#include "variants/backend.hpp"

namespace warpgrain::cli {

// Median of five readings of equal length, together about `timed_steps`: the median resists the neighbours of
// a shared machine.
double median_seconds_per_step(Simulation& simulation, std::uint64_t timed_steps);

}  // namespace warpgrain::cli
