#pragma once
// One state between falling and at rest: how close the particles lie, and how well the warps of a step there
// run.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/candidate_census.hpp"
#include "profiler/counters.hpp"

namespace warpgrain::reports {

struct StateSample {
  struct Kernel {
    std::string kernel;
    std::uint64_t warp_instructions = 0;
    double simt_efficiency = 0;
  };
  std::uint64_t step = 0;
  double time = 0;  // s
  double mean_candidates = 0, mean_contacts = 0;
  std::uint32_t most_candidates = 0, most_contacts = 0;
  std::vector<Kernel> kernels;  // of the step, largest first

  // Of all kernels together.
  std::uint64_t warp_instructions() const;
  double simt_efficiency() const;
  // Null where the step has none of that name.
  const Kernel* kernel_named(std::string_view name) const;
};

// `launches` are those of the step that begins at the state, all of one warp width.
StateSample state_sample(std::uint64_t step, double time, const CandidateCensus& census,
                         std::span<const profiler::LaunchCounters> launches);

// Names of the kernels that have a hundredth of some step's warp instructions, those of the first state
// first.
std::vector<std::string> heavy_kernels(std::span<const StateSample> samples);

}  // namespace warpgrain::reports
