#pragma once
// The key "samples" of reports and of the paper's document.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/json_reader.hpp"
#include "reports/state_sample.hpp"

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const StateSample& sample);
// Throws InputError naming the place of what is missing or wrong.
std::vector<StateSample> state_samples_from(const JsonReader& place);

}  // namespace warpgrain::reports
