#pragma once
// Runs a launch as a device would that issues one instruction at a time for all active lanes of a warp, and
// counts what it issues. Warps of a work-group take turns at barriers, work-groups run one after another.

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "profiler/launch.hpp"
#include "tests/profiler/oracle/schedule.hpp"

namespace warpgrain::oracle {

struct AccessCount {
  std::uint64_t requests = 0, sectors = 0, useful_bytes = 0;
  bool sectors_known = true;  // all accesses went to buffers
};

struct Counts {
  std::vector<std::vector<std::uint64_t>> executions;  // [steps][warp_width + 1]: by number of active lanes
  std::vector<std::uint64_t> divergent;                // [steps]: executions after which lanes parted
  std::vector<std::uint64_t> taken_lanes;              // [steps]: that took a conditional branch
  std::map<Place, AccessCount> accesses;               // of the steps that were executed
  std::uint64_t issued = 0;                            // warp instructions
};

// Runs the whole launch; buffers end up as the kernel leaves them. Throws std::runtime_error for what a sound
// kernel does not do: accesses out of bounds, barriers that only some lanes reach, an endless run.
Counts run_lockstep(const Program& program, const Flow& flow, const Policy& policy, std::uint32_t warp_width,
                    const profiler::LaunchShape& shape, std::span<const profiler::KernelArgument> arguments);

}  // namespace warpgrain::oracle
