#include "reports/report_json.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "reports/counters_json.hpp"
#include "reports/json_place.hpp"
#include "reports/json_text.hpp"
#include "reports/provenance_json.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

template <class T, class... Options>
Json array_of(const std::vector<T>& values, Options... options) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(to_json(value, options...));
  return array;
}

Json launch_json(const LaunchReport& launch, bool with_text) {
  const profiler::LaunchCounters& counters = launch.counters;
  Json source{{"name", launch.source.name},
              {"hash", launch.source.hash},
              {"compiler", launch.source.compiler},
              {"command", launch.source.command}};
  if (with_text) source["text"] = launch.source.text;
  return {{"kernel", counters.kernel},
          {"global_size", counters.shape.global_size},
          {"local_size", counters.shape.local_size},
          {"warp_width", counters.warp_width},
          {"policy", counters.policy},
          {"warps", counters.warps},
          {"totals", to_json(counters.totals, counters.warp_width)},
          {"lane_slots_never_used", counters.lane_slots_never_used},
          {"branches", array_of(counters.branches)},
          {"lines", array_of(counters.lines, counters.warp_width)},
          {"blocks", array_of(counters.blocks)},
          {"what_if", Json::array()},
          {"source", source}};
}

template <class Integer>
std::array<Integer, 3> size_from(const JsonPlace& place) {
  const std::vector<std::uint64_t> sizes = place.counts();
  if (sizes.size() != 3 || std::any_of(sizes.begin(), sizes.end(), [](std::uint64_t size) {
        return size == 0 || size > std::numeric_limits<Integer>::max();
      }))
    place.refuse("three sizes of at least 1");
  return {static_cast<Integer>(sizes[0]), static_cast<Integer>(sizes[1]), static_cast<Integer>(sizes[2])};
}

// Sources of earlier launches by hash; texts stand once in a report.
using Texts = std::map<std::string, std::string>;

SourceText source_from(const JsonPlace& place, Texts& texts) {
  SourceText source{.name = place["name"].text(),
                    .text = {},
                    .hash = place["hash"].text(),
                    .compiler = place["compiler"].text(),
                    .command = place["command"].text()};
  if (const auto text = place.optional_text("text")) texts[source.hash] = *text;
  const auto found = texts.find(source.hash);
  if (found == texts.end()) place.refuse("a text, as no launch before it has a source of this hash");
  source.text = found->second;
  return source;
}

LaunchReport launch_from(const JsonPlace& place, Texts& texts) {
  LaunchReport launch;
  profiler::LaunchCounters& counters = launch.counters;
  counters.kernel = place["kernel"].text();
  counters.shape.global_size = size_from<std::uint64_t>(place["global_size"]);
  counters.shape.local_size = size_from<std::uint32_t>(place["local_size"]);
  counters.warp_width = place["warp_width"].count32();
  if (counters.warp_width == 0 || counters.warp_width > 64) place["warp_width"].refuse("1 to 64 lanes");
  counters.policy = place["policy"].text();
  counters.warps = place["warps"].count();
  counters.totals = totals_from(place["totals"], counters.warp_width);
  counters.lane_slots_never_used = place["lane_slots_never_used"].count();
  for (const JsonPlace& branch : place["branches"].elements())
    counters.branches.push_back(branch_from(branch));
  for (const JsonPlace& line : place["lines"].elements())
    counters.lines.push_back(line_from(line, counters.warp_width));
  for (const JsonPlace& block : place["blocks"].elements())
    counters.blocks.push_back(block_from(block, counters.warp_width));
  launch.source = source_from(place["source"], texts);
  return launch;
}

}  // namespace

std::string report_json(const Report& report) {
  Json json = document_head(report_format, report.generator, report.command_line);
  if (report.scene) json["scene"] = *report.scene;
  if (report.variant) json["variant"] = *report.variant;
  if (report.particles) json["particles"] = *report.particles;
  if (report.step) json["step"] = *report.step;
  if (report.machine) json["machine"] = *report.machine;
  json["weights"] = report.weights;
  json["limits"] = report.limits;
  json["launches"] = Json::array();
  std::set<std::string> written;
  for (const LaunchReport& launch : report.launches)
    json["launches"].push_back(launch_json(launch, written.insert(launch.source.hash).second));
  return json_text(json, "report");
}

Report read_report(const std::filesystem::path& file) {
  const Json document = read_json(file);
  const JsonPlace root = document_of_format(document, file.string(), report_format);
  Report report;
  report.generator = generator_from(root);
  report.command_line = root["command_line"].text();
  report.scene = root.optional_text("scene");
  report.variant = root.optional_text("variant");
  report.particles = root.optional_count("particles");
  report.step = root.optional_count("step");
  report.machine = root.optional_text("machine");
  report.weights = root["weights"].text();
  for (const JsonPlace& limit : root["limits"].elements()) report.limits.push_back(limit.text());
  Texts texts;
  for (const JsonPlace& launch : root["launches"].elements())
    report.launches.push_back(launch_from(launch, texts));
  return report;
}

}  // namespace warpgrain::reports
