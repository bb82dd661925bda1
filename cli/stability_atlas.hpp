#pragma once
// One cell of the atlas: a probe's limits for one variant on one back end.

#include "cli/probes/probes.hpp"
#include "reports/stability_report.hpp"

namespace warpgrain::cli {

// How finely limits are looked for (analysis/limit_search.hpp).
struct AtlasOptions {
  int samples = 5;
  int halvings = 6;
};

reports::StabilityReport::Probe described(const Probe& probe, std::uint64_t rest_steps);

// A probe never fails: what a back end refuses is a sample with its line.
reports::StabilityReport::Cell find_cell(const Probe& probe, const ProbeBench& bench,
                                         const AtlasOptions& options);

}  // namespace warpgrain::cli
