#pragma once
// The parts of a report's page, one a file. Each returns HTML.

#include <cstdint>
#include <string>
#include <vector>

#include "reports/report.hpp"
#include "reports/summary.hpp"

namespace warpgrain::reports::html {

// The numbers that are asked for first, each with its definition and Nsight Compute's name.
std::string headline_view(const std::vector<KernelSummary>& kernels);

// What checked launches found wrong; empty when nothing.
std::string diagnostics_view(const Report& report);

// Totals of every kernel, and of every launch when there are more launches than kernels.
std::string kernels_view(const Report& report, const std::vector<KernelSummary>& kernels);

// Warp instructions by number of active lanes, a bar each, as SVG.
std::string histogram_view(const profiler::LaunchCounters& counters);

// Branches by lost lane slots.
std::string branches_view(const KernelSummary& kernel);

// The launch under other widths, policies and thread orders; empty when nothing was asked.
std::string what_if_view(const KernelSummary& kernel);

// What chosen warps did, block by block, on a canvas; empty when none was followed.
std::string timeline_view(const KernelSummary& kernel);

// The source, line by line, with what each line cost. Stretches that made no instruction are left out.
std::string source_view(const KernelSummary& kernel);

// The basic blocks of the PTX, with their histograms of active lanes.
std::string blocks_view(const KernelSummary& kernel);

// A small drawing of a histogram of active lanes; empty when it is.
std::string lanes_bars(const std::vector<std::uint64_t>& lane_histogram);

// What the special-function units cost on the report's machine; empty without one.
std::string machine_view(const Report& report, const std::vector<KernelSummary>& kernels);

// The particles on a canvas; empty without.
std::string bed_view(const Report& report);

// Which parts of the model the kernels have, and what that saves; empty for a launch file.
std::string model_view(const ModelledParts& parts);

std::string instruction_mix_view(const profiler::Totals& totals);

// Where the numbers come from and what they do not say.
std::string provenance_view(const Report& report);

}  // namespace warpgrain::reports::html
