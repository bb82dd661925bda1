#pragma once

#include <string>

#include "reports/sweep_index.hpp"

namespace warpgrain::reports::html {

// What is different from an earlier sweep: variant by variant those columns that both have. HTML, a section
// of the page.
std::string sweep_changes(const SweepIndex& index, const SweepIndex& baseline);

}  // namespace warpgrain::reports::html
