#pragma once
// Measured times as a table for a terminal:
//
//   NVIDIA H100 80GB HBM3 (sm_90), driver 580.159.04, CUDA 13.0
//   kernel       calls  readings   median   spread   registers
//   ----------------------------------------------------------
//   find_cells       1        20   3.2 us    2.1 %          18

#include <string>

#include "reports/measured_report.hpp"

namespace warpgrain::reports {

std::string text_measured(const MeasuredReport& measured);

}  // namespace warpgrain::reports
