#include "reports/replay_json.hpp"

#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const profiler::WeightsUsed& weights) {
  nlohmann::ordered_json json{{"used", weights.sass}};
  if (!weights.arch.empty()) json["arch"] = weights.arch;
  if (!weights.ptxas.empty()) json["ptxas"] = weights.ptxas;
  if (!weights.reason.empty()) json["reason"] = weights.reason;
  json["underived_choices"] = weights.underived;
  if (weights.registers != 0) json["registers"] = weights.registers;
  json["fast_paths_assumed"] = weights.fast_paths;
  json["predicates_assumed"] = weights.predicates_assumed;
  json["turns_assumed"] = weights.turns_assumed;
  json["trips_assumed"] = weights.trips_assumed;
  json["requests_of_ptx"] = weights.requests_of_ptx;
  return json;
}

profiler::WeightsUsed weights_from(const JsonReader& place) {
  return {.sass = place.at("used").boolean(),
          .asked = true,
          .arch = optional_string(place, "arch").value_or(""),
          .ptxas = optional_string(place, "ptxas").value_or(""),
          .reason = optional_string(place, "reason").value_or(""),
          .underived = place.at("underived_choices").whole_number(),
          .registers = place.has("registers") ? place.at("registers").whole_number() : 0,
          .fast_paths = place.at("fast_paths_assumed").whole_number(),
          .requests_of_ptx = optional_whole_number(place, "requests_of_ptx").value_or(0),
          .predicates_assumed = optional_whole_number(place, "predicates_assumed").value_or(0),
          .turns_assumed = optional_whole_number(place, "turns_assumed").value_or(0),
          .trips_assumed = optional_whole_number(place, "trips_assumed").value_or(0)};
}

}  // namespace warpgrain::reports
