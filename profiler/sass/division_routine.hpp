#pragma once
// The routine that ptxas adds for divisions of doubles whose numbers are rare.

#include <cstdint>
#include <optional>
#include <vector>

#include "profiler/division_path.hpp"
#include "profiler/sass/code_graph.hpp"

namespace warpgrain::profiler::sass {

// Its six guards, in the order of the code:
//   0  a number is 0, infinite or none           3  the dividend is none
//   1  the quotient is normal                    4  the divisor is none
//   2  a denormal quotient is exact              5  both are 0, or both infinite
inline constexpr std::size_t division_guards = 6;

// The blocks that end in them, if that is what a call to `entry` leads to.
std::optional<std::vector<std::uint32_t>> find_division_guards(const CodeGraph& code, std::uint32_t entry);

// Whether a lane on that path takes the guard.
bool takes_division_guard(std::size_t guard, DivisionPath path);

}  // namespace warpgrain::profiler::sass
