#pragma once
// Hardware counters: the measurement once more, under Nsight Compute.

#include <string>
#include <vector>

#include "reports/measured_report.hpp"

namespace warpgrain::cli {

// Runs `warpgrain` with these words, which make it mark what to count, under ncu. The sums over the launches
// of each kernel go into `report`. Throws InputError when there is no ncu on PATH or in /usr/local/cuda/bin,
// and with its messages when it fails.
void count_with_ncu(const std::vector<std::string>& words, reports::MeasuredReport& report);

}  // namespace warpgrain::cli
