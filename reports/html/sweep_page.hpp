#pragma once
// A sweep's index as one self-contained page: the table of its cases. A variant links to the page of its
// report, which lies beside the report with the extension .html.

#include <string>

#include "reports/sweep_index.hpp"

namespace warpgrain::reports {

// With what changed from `baseline`, where there is one.
std::string sweep_page(const SweepIndex& index, const SweepIndex* baseline = nullptr);

}  // namespace warpgrain::reports
