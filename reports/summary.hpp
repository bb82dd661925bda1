#pragma once
// What a reader of a report asks first: its headline numbers, and its launches taken together kernel by
// kernel (a bitonic sort alone is a hundred launches of two kernels).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/cost_model.hpp"
#include "reports/report.hpp"

namespace warpgrain::reports {

// Counters of launches taken together; the names are the metrics of reports/metrics.hpp.
struct Headline {
  std::uint64_t warp_instructions = 0;
  std::uint64_t thread_instructions = 0;
  double active_lanes = 0;
  double simt_efficiency = 0;
  std::uint64_t branches = 0;
  std::uint64_t divergent_branches = 0;
  std::uint64_t sfu_instructions = 0;
  std::optional<double> sectors_per_load;   // none when there was no global load
  std::optional<double> predicted_seconds;  // by the cost model, where the machine has constants for it
  // The kernel with the most warp instructions: the means over a step hide where it spends its time.
  struct Heaviest {
    std::string kernel;
    double share = 0;  // of the warp instructions
    double simt_efficiency = 0;
  } heaviest_kernel;
};

Headline headline_of(const profiler::LaunchCounters& counters);

// All launches of one kernel: the same name, source, warp width and policy.
struct KernelSummary {
  std::size_t launches = 0;
  profiler::LaunchCounters counters;   // summed; `shape` is the first launch's
  const SourceText* source = nullptr;  // in the report
  // Of all launches together, the parts too; resident warps are the first launch's. Where there is a
  // prediction.
  std::optional<PredictedTime> predicted;

  // Lane slots in which a lane idled: warp_width * warp_instructions - thread_instructions.
  std::uint64_t lane_slots_lost() const;
};

// Largest number of warp instructions first. The summaries point into the report, which must outlive them.
std::vector<KernelSummary> kernels_of(const Report& report);

// Of all launches together.
Headline headline_of(const std::vector<KernelSummary>& kernels);
// The same of a report's; the predicted time has a step's share of making lists.
Headline headline_of(const Report& report);

// "min_pc", or of a pool "bound, pools of 128".
std::string policy_text(const profiler::WhatIfTotals& answer);
// What to know of the answers, each remark once.
std::vector<std::string> remarks_of(const std::vector<profiler::WhatIfTotals>& answers);

// Sectors a request of one kind of access touched on average; none without requests.
std::optional<double> sectors_per_request(const profiler::MemoryCounters& access);

}  // namespace warpgrain::reports
