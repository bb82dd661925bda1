#pragma once
// Which instructions a launch's counts are of, to JSON and back, in the keys of "warpgrain.report/1".

#include <nlohmann/json_fwd.hpp>

#include "profiler/counters.hpp"

namespace warpgrain {
class JsonReader;
}

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const profiler::WeightsUsed& weights);
// Throws InputError naming the place of what is missing or wrong.
profiler::WeightsUsed weights_from(const JsonReader& place);

}  // namespace warpgrain::reports
