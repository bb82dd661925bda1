#pragma once
// A small report whose numbers follow from each other: warps of four lanes run a kernel in which a branch
// parts two lanes from the other two.

#include "reports/accuracy_report.hpp"
#include "reports/comparison.hpp"
#include "reports/measured_report.hpp"
#include "reports/paper_report.hpp"
#include "reports/report.hpp"
#include "reports/run_report.hpp"
#include "reports/stability_report.hpp"
#include "reports/sweep_index.hpp"

namespace warpgrain::reports::sample {

inline constexpr std::uint32_t warp_width = 4;

// `full` warp instructions with four lanes and `half` with two.
profiler::Totals totals(std::uint64_t full, std::uint64_t half);

// One launch of `kernel` over 8 work-items: two warps.
profiler::LaunchProfile launch(const std::string& kernel);

ModelledParts modelled();
// Of two states, the second of which has one kernel less.
std::vector<StateSample> state_samples();
Report report();  // of two launches of "force" and one of "sort"
RunReport run();
MeasuredReport measured();  // a step and its one kernel
SweepIndex sweep();         // one case that is done, one that failed

PaperReport paper();
AccuracyReport accuracy();
StabilityReport stability();
Comparison comparison();

}  // namespace warpgrain::reports::sample
