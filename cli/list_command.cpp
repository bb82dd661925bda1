// `warpgrain list`: what there is, one a line with a summary.

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/machine.hpp"
#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "core/scene.hpp"
#include "reports/metrics.hpp"
#include "variants/axes.hpp"
#include "variants/backend.hpp"
#include "variants/combinations.hpp"

namespace warpgrain::cli {
namespace {

using Json = nlohmann::ordered_json;

Json list_scenes() {
  Json rows = Json::array();
  for (const SceneSummary& scene : named_scenes())
    rows.push_back({{"name", scene.name}, {"summary", scene.summary}});
  return rows;
}

Json list_variants() {
  Json rows = Json::array();
  for (const Variant& variant : all_variants()) {
    std::string summary;
    for (std::size_t a = 0; a < n_axes; ++a) {
      const auto value = variant.value(static_cast<AxisId>(a));
      for (const AxisValue& candidate : axes()[a].values)
        if (candidate.name == value)
          summary += fmt::format("{}{}", summary.empty() ? "" : "; ", candidate.summary);
    }
    rows.push_back({{"name", variant.name()}, {"summary", summary}});
  }
  return rows;
}

Json list_axes() {
  Json rows = Json::array();
  for (const Axis& axis : axes()) {
    Json values = Json::array();
    for (const AxisValue& value : axis.values)
      values.push_back({{"name", value.name}, {"summary", value.summary}});
    rows.push_back({{"name", axis.name},
                    {"summary", axis.summary},
                    {"default", axis.values[axis.default_value].name},
                    {"values", values}});
  }
  return rows;
}

Json list_backends() {
  Json rows = Json::array();
  for (const Backend& backend : backends())
    rows.push_back({{"name", backend.name}, {"summary", backend.summary}, {"lacks", backend.lacks()}});
  return rows;
}

Json list_machines() {
  Json rows = Json::array();
  for (const Machine& machine : named_machines()) {
    Json row{{"name", machine.name}, {"summary", machine.description}};
    for (const MachineKey& key : machine_keys) {
      const MachineValue& value = machine.*key.value;
      row[std::string(key.key)] = {{"value", value.value}, {"source", value.source}};
    }
    rows.push_back(row);
  }
  return rows;
}

Json list_metrics() {
  Json rows = Json::array();
  for (const reports::Metric& metric : reports::metrics())
    rows.push_back({{"name", metric.key},
                    {"summary", metric.definition},
                    {"unit", metric.unit},
                    {"ncu", metric.ncu_metric}});
  return rows;
}

struct Listing {
  std::string_view name;
  Json (*rows)();
};
constexpr std::array<Listing, 6> listings{{{"scenes", list_scenes},
                                           {"variants", list_variants},
                                           {"axes", list_axes},
                                           {"machines", list_machines},
                                           {"backends", list_backends},
                                           {"metrics", list_metrics}}};

void print_row(const Json& row, std::size_t width) {
  std::string line =
      fmt::format("{:<{}}  {}", row["name"].get<std::string>(), width, row["summary"].get<std::string>());
  if (row.contains("ncu") && !row["ncu"].get<std::string>().empty())
    line += fmt::format(" [{}]", row["ncu"].get<std::string>());
  if (row.contains("lacks") && !row["lacks"].get<std::string>().empty())
    line += fmt::format(" (not here: {})", row["lacks"].get<std::string>());
  if (row.contains("values")) {
    line += fmt::format("; default {}", row["default"].get<std::string>());
    for (const Json& value : row["values"])
      line += fmt::format("\n{:<{}}    {}: {}", "", width, value["name"].get<std::string>(),
                          value["summary"].get<std::string>());
  }
  std::cout << line << '\n';
}

void print_listing(const Json& rows) {
  std::size_t width = 0;
  for (const Json& row : rows) width = std::max(width, row["name"].get<std::string>().size());
  for (const Json& row : rows) print_row(row, width);
}

int list(const std::string& what, const OutputOptions& output) {
  std::vector<std::string_view> names;
  for (const Listing& listing : listings) names.push_back(listing.name);
  if (!what.empty() && std::find(names.begin(), names.end(), what) == names.end())
    throw_unknown_name("warpgrain list", "kind", what, names);

  Json document{{"format", "warpgrain.list/1"}};
  for (const Listing& listing : listings)
    if (what.empty() || what == listing.name) document[std::string(listing.name)] = listing.rows();
  if (!output.json.empty()) write_output(output.json, document.dump(2) + "\n");
  if (output.json == "-") return 0;
  for (const Listing& listing : listings) {
    const std::string name(listing.name);
    if (!document.contains(name)) continue;
    if (what.empty()) std::cout << name << '\n';
    print_listing(document[name]);
  }
  return 0;
}

}  // namespace

void add_list_command(CLI::App& app, Action& chosen) {
  struct ListOptions {
    std::string what;
    OutputOptions output;
  };
  auto options = std::make_shared<ListOptions>();
  CLI::App& command = *app.add_subcommand("list", help_text().summary("list"));
  add_option(command, "what", options->what);
  options->output.add_to(command);
  command.callback(
      [options, &chosen] { chosen = [options] { return list(options->what, options->output); }; });
}

}  // namespace warpgrain::cli
