#pragma once
// A report as one self-contained page: headline numbers, kernels, and for each kernel its histogram,
// branches, source and instruction mix; provenance and limits at the end.

#include <string>

#include "reports/report.hpp"

namespace warpgrain::reports {

std::string report_page(const Report& report);

}  // namespace warpgrain::reports
