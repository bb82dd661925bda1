#pragma once
// States from falling to rest as a table for a terminal.

#include <span>
#include <string>

#include "reports/state_sample.hpp"

namespace warpgrain::reports {

// With a heading; empty without samples.
std::string text_state_samples(std::span<const StateSample> samples);

}  // namespace warpgrain::reports
