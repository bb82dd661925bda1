#pragma once
// A sweep on a terminal: a row a case, aligned; below it what did not run and why.

#include <string>

#include "reports/sweep_index.hpp"

namespace warpgrain::reports {

std::string text_sweep(const SweepIndex& index);

}  // namespace warpgrain::reports
