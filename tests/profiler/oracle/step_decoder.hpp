#pragma once
// One statement of PTX -> one step, but for where it leads.

#include <limits>

#include "tests/profiler/oracle/symbols.hpp"

namespace warpgrain::oracle {

// Stands for the place behind the last step while their number is not known.
inline constexpr Place end_of_lane = std::numeric_limits<Place>::max();

Step decode_step(const ptx::Statement& statement, const Names& names);

}  // namespace warpgrain::oracle
