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

StabilityReport::Probe probe_from(const JsonReader& place) {
  StabilityReport::Probe probe;
  probe.name = place.at("name").string();
  probe.summary = place.at("summary").string();
  probe.parameter = place.at("parameter").string();
  probe.unit = place.at("unit").string();
  probe.invariant = place.at("invariant").string();
  probe.from = place.at("from").number();
  probe.to = place.at("to").number();
  probe.right_within = place.at("right_within").number();
  probe.degraded_within = place.at("degraded_within").number();
  probe.other_unit = optional_string(place, "other_unit").value_or("");
  if (!probe.other_unit.empty()) probe.others_in_unit = place.at("others_in_unit").number();
  return probe;
}

Verdict verdict_from(const JsonReader& place) {
  return static_cast<Verdict>(place.at("verdict").one_of(verdict_names, "verdict"));
}

StabilityReport::Cell cell_from(const JsonReader& place) {
  StabilityReport::Cell cell;
  cell.probe = place.at("probe").string();
  cell.variant = place.at("variant").string();
  cell.backend = place.at("backend").string();
  cell.verdict = verdict_from(place);
  cell.right_until = optional_number(place, "right_until");
  cell.right_beyond = optional_number(place, "right_beyond");
  cell.degraded_until = optional_number(place, "degraded_until");
  cell.degraded_beyond = optional_number(place, "degraded_beyond");
  for (const JsonReader& sample : place.at("samples").elements())
    cell.samples.push_back({sample.at("x").number(), verdict_from(sample), optional_number(sample, "error"),
                            sample.at("text").string()});
  return cell;
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

StabilityReport read_stability(const std::filesystem::path& file) {
  const JsonReader root = read_document(file, stability_format);
  StabilityReport report;
  report.generator = generator_from(root);
  report.command_line = root.at("command_line").string();
  for (const JsonReader& probe : root.at("probes").elements()) report.probes.push_back(probe_from(probe));
  for (const JsonReader& cell : root.at("cells").elements()) report.cells.push_back(cell_from(cell));
  return report;
}

}  // namespace warpgrain::reports
