#pragma once
// What is wrong with the kernels of a report, a line each.

#include <string>
#include <vector>

#include "reports/report.hpp"

namespace warpgrain::reports {

// The same finding in several launches of a kernel stands once, with the sum of its counts. Empty when
// nothing is wrong.
std::vector<std::string> diagnostic_lines(const Report& report);

}  // namespace warpgrain::reports
