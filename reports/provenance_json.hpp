#pragma once
// What every format opens with.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "reports/generator.hpp"

namespace warpgrain::reports {

class JsonPlace;

// {"format": ..., "generator": {...}, "command_line": ...}
nlohmann::ordered_json document_head(std::string_view format, const Generator& generator,
                                     const std::string& command_line);
Generator generator_from(const JsonPlace& document);

}  // namespace warpgrain::reports
