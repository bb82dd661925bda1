#pragma once
// States from falling to rest on a page: efficiency, candidates and contacts against time.

#include <span>
#include <string>

#include "reports/state_sample.hpp"

namespace warpgrain::reports::html {

// With a heading; empty without samples.
std::string samples_view(std::span<const StateSample> samples);

}  // namespace warpgrain::reports::html
