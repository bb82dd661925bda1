#include "reports/provenance_json.hpp"

#include <nlohmann/json.hpp>

#include "reports/json_place.hpp"

namespace warpgrain::reports {

nlohmann::ordered_json document_head(std::string_view format, const Generator& generator,
                                     const std::string& command_line) {
  return {{"format", format},
          {"generator", {{"version", generator.version}, {"git_revision", generator.git_revision}}},
          {"command_line", command_line}};
}

Generator generator_from(const JsonPlace& document) {
  const JsonPlace generator = document["generator"];
  return {generator["version"].text(), generator["git_revision"].text()};
}

}  // namespace warpgrain::reports
