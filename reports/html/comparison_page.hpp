#pragma once

#include <string>

#include "reports/comparison.hpp"

namespace warpgrain::reports {

// Two documents side by side: differences kernel by kernel, or the order of a sweep's variants beside the
// measured one.
std::string comparison_page(const Comparison& comparison);

}  // namespace warpgrain::reports
