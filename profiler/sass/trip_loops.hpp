#pragma once
// Loops whose body stands several times in the machine code with no test between: the assembler has unrolled
// them, and their guards ask how many trips are left, which no branch of the PTX does.

#include <cstdint>
#include <vector>

#include "profiler/sass/code_graph.hpp"
#include "profiler/sass/guard_links.hpp"
#include "profiler/sass/ptx_decisions.hpp"

namespace warpgrain::profiler::sass {

struct TripLoop {
  std::uint32_t decision = no_decision;  // that makes another trip or leaves the loop
  std::vector<bool> inside;              // [blocks of the PTX]
  // [blocks of the PTX]: how many trips' worth of the body a straight run from the block holds, 0 or 1. Where
  // a trip is counted does not matter, as long as code and trace count it at the same place.
  std::vector<bool> counts;
  std::vector<std::uint32_t> copies;  // [blocks of the code]: trips that the block makes
  // [blocks of the code]: whether it makes them under a predicate, if so many are left.
  std::vector<bool> predicated;
  // [blocks of the code]: between the first and the last of the loop's copies and guards.
  std::vector<bool> region;
};

// One for each loop of the PTX of which some block of the code makes two trips or more, or a straight way of
// blocks does. Guards that choose between ways into such a loop, which stand behind the guard of another
// decision and were taken for its, get the loop's decision.
std::vector<TripLoop> find_trip_loops(const CodeGraph& code, const PtxDecisions& decisions,
                                      std::vector<GuardLink>& links);

}  // namespace warpgrain::profiler::sass
