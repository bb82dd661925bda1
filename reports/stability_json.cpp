#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"
#include "reports/stability_report.hpp"

namespace warpgrain::reports {
namespace {

using OrderedJson = nlohmann::ordered_json;

void put_if_there(OrderedJson& json, const char* key, const std::optional<double>& value) {
  if (value) json[key] = *value;
}

OrderedJson cell_json(const StabilityReport::Cell& cell) {
  OrderedJson json{{"probe", cell.probe},
                   {"variant", cell.variant},
                   {"backend", cell.backend},
                   {"verdict", verdict_name(cell.verdict)}};
  put_if_there(json, "right_until", cell.right_until);
  put_if_there(json, "right_beyond", cell.right_beyond);
  put_if_there(json, "degraded_until", cell.degraded_until);
  put_if_there(json, "degraded_beyond", cell.degraded_beyond);
  if (const auto* sample = first_not_right(cell)) json["reason"] = sample->text;
  json["samples"] = OrderedJson::array();
  for (const StabilityReport::Sample& sample : cell.samples) {
    json["samples"].push_back({{"x", sample.x}, {"verdict", verdict_name(sample.verdict)}});
    put_if_there(json["samples"].back(), "error", sample.error);
    json["samples"].back()["text"] = sample.text;
  }
  return json;
}

}  // namespace

std::string stability_json(const StabilityReport& report) {
  OrderedJson json = document_head(stability_format, report.generator, report.command_line);
  for (const char* key : {"probes", "cells"}) json[key] = OrderedJson::array();
  for (const StabilityReport::Probe& probe : report.probes) {
    json["probes"].push_back({{"name", probe.name},
                              {"summary", probe.summary},
                              {"parameter", probe.parameter},
                              {"unit", probe.unit},
                              {"invariant", probe.invariant},
                              {"from", probe.from},
                              {"to", probe.to},
                              {"right_within", probe.right_within},
                              {"degraded_within", probe.degraded_within}});
    if (probe.other_unit.empty()) continue;
    json["probes"].back()["other_unit"] = probe.other_unit;
    json["probes"].back()["others_in_unit"] = probe.others_in_unit;
  }
  for (const StabilityReport::Cell& cell : report.cells) json["cells"].push_back(cell_json(cell));
  return json_text(json, "stability");
}

}  // namespace warpgrain::reports
