#pragma once
// What an instruction is in a report, in words.

#include <string>
#include <vector>

#include "reports/report.hpp"

namespace warpgrain::reports {

// "SASS: sm_90, ptxas 13.0.88", "PTX: ptxas is not installed", with the kernels where launches differ; each
// once.
std::vector<std::string> weights_lines(const Report& report);

}  // namespace warpgrain::reports
