#pragma once
// Which way a division of doubles goes through the machine code that ptxas makes of div.rn.f64: the numbers
// say it, so a trace records it. Conditions are those of the code for sm_75 to sm_90 by ptxas 13.0:
// reciprocal and Newton steps in line where exponents are far from their ends, else a routine.

#include <cstdint>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler {

enum class DivisionPath : std::uint8_t {
  none,  // no_address: the instruction was switched off
  in_line,
  scaled,          // the routine, with a normal quotient
  denormal,        // with one that is none, rounded
  denormal_exact,  // or not rounded
  nan_dividend,
  nan_divisor,
  undefined,        // 0 / 0, infinity / infinity
  zero_or_infinite  // another division of or by 0 or infinity
};

// It stands among the accesses of a block, with the path in the place of an address; no bytes are touched.
inline bool is_path(const MemoryAccess& access) { return access.bytes == 0; }

}  // namespace warpgrain::profiler
