#pragma once
// The times that the cost model gives a report's launches, where its machine has constants for that.

#include <optional>
#include <string>
#include <vector>

#include "analysis/cost_model.hpp"
#include "reports/report.hpp"
#include "reports/summary.hpp"

namespace warpgrain::reports {

// Of one launch. Those of a scene's step follow each other; one of a launch file stands alone.
std::optional<PredictedTime> predicted_time(const Report& report, const LaunchReport& launch);

// A table of kernels, what their launches take together and what of it each part would take alone; empty
// where there is no prediction.
std::string predicted_table(const Report& report, const std::vector<KernelSummary>& kernels);

}  // namespace warpgrain::reports
