#pragma once
// The rows of a paper report, from what was counted and timed.

#include <optional>
#include <string>
#include <vector>

#include "analysis/machine.hpp"
#include "profiler/counters.hpp"
#include "reports/paper_report.hpp"

namespace warpgrain::reports {

// One time step of a model in the simulator.
struct PaperStep {
  std::uint32_t warp_width = 32;
  std::vector<profiler::LaunchCounters> launches;
  const profiler::LaunchCounters& forces() const;  // the launch with the most warp instructions
};

// A run of one of the models on a device.
struct PaperTiming {
  bool practical = true;
  std::string backend;  // host, opencl, cuda
  double particle_steps_per_second = 0;
  std::string on;
};

struct PaperFacts {
  std::uint64_t particles = 0;
  PaperStep simple, practical;  // the same state, the last sample's
  std::vector<PaperTiming> timings;
  Machine paper_machine;           // the paper's GPU
  std::optional<Machine> machine;  // another, for predicted times
};

// Fills in `report.rows` from the facts, and from its samples and paths.
void add_paper_rows(PaperReport& report, const PaperFacts& facts);

}  // namespace warpgrain::reports
