#pragma once
// Diagnostics to JSON and back, in the keys of "warpgrain.report/1".

#include <nlohmann/json_fwd.hpp>

#include "profiler/diagnostic.hpp"

namespace warpgrain {
class JsonReader;
}

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const profiler::Diagnostic& diagnostic);
// Throws InputError naming the place of what is missing or wrong.
profiler::Diagnostic diagnostic_from(const JsonReader& place);

}  // namespace warpgrain::reports
