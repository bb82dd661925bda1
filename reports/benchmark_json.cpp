#include "reports/benchmark_json.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/file_io.hpp"
#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

void append(Json& benchmarks, const std::string& name, const std::vector<double>& seconds) {
  for (std::size_t k = 0; k < seconds.size(); ++k)
    benchmarks.push_back({{"name", name},
                          {"run_name", name},
                          {"run_type", "iteration"},
                          {"repetitions", seconds.size()},
                          {"repetition_index", k},
                          {"threads", 1},
                          {"iterations", 1},
                          {"real_time", 1e9 * seconds[k]},
                          {"cpu_time", 1e9 * seconds[k]},
                          {"time_unit", "ns"}});
}

// In the order of the names.
constexpr std::array<double, 4> units{1e-9, 1e-6, 1e-3, 1};
constexpr std::array<std::string_view, 4> unit_names{"ns", "us", "ms", "s"};

}  // namespace

std::string benchmark_json(const MeasuredReport& measured) {
  Json json;
  json["context"] = {{"executable", measured.command_line},
                     {"library_version", measured.generator.version},
                     {"device", measured.device.name},
                     {"driver", measured.device.driver},
                     {"backend", measured.backend}};
  if (measured.scene) json["context"]["scene"] = *measured.scene;
  if (measured.variant) json["context"]["variant"] = *measured.variant;
  if (measured.particles) json["context"]["particles"] = *measured.particles;
  json["benchmarks"] = Json::array();
  if (measured.step) append(json["benchmarks"], "step", measured.step->seconds);
  for (const MeasuredReport::Kernel& kernel : measured.kernels)
    append(json["benchmarks"], kernel.kernel, kernel.seconds);
  return json_text(json, "benchmark");
}

std::vector<BenchmarkTimes> read_benchmark_json(const std::filesystem::path& file) {
  const JsonReader root = JsonReader::parse(read_text_file(file, document_size_limit), file.string());
  std::vector<BenchmarkTimes> repetitions, medians;
  for (const JsonReader& place : root.at("benchmarks").elements()) {
    if (place.has("error_occurred") && place.at("error_occurred").boolean()) continue;
    const bool is_aggregate = optional_string(place, "run_type") == "aggregate";
    if (is_aggregate && place.at("aggregate_name").string() != "median") continue;
    const std::string name = optional_string(place, "run_name").value_or(place.at("name").string());
    const double unit =
        place.has("time_unit") ? units[place.at("time_unit").one_of(unit_names, "unit of time")] : 1e-9;
    std::vector<BenchmarkTimes>& list = is_aggregate ? medians : repetitions;
    auto found = std::ranges::find(list, name, &BenchmarkTimes::name);
    if (found == list.end()) found = list.insert(list.end(), {name, {}});
    found->seconds.push_back(unit * place.at("real_time").number());
  }
  for (BenchmarkTimes& median : medians)
    if (std::ranges::find(repetitions, median.name, &BenchmarkTimes::name) == repetitions.end())
      repetitions.push_back(std::move(median));
  return repetitions;
}

}  // namespace warpgrain::reports
