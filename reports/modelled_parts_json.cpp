#include "reports/modelled_parts_json.hpp"

#include "reports/json_fields.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* full_model = "/model=full";

}  // namespace

void add_modelled_parts(Json& document, const ModelledParts& parts) {
  if (!parts.features.empty()) {
    document["features"] = Json::array();
    for (const FeatureRow& row : parts.features)
      document["features"].push_back(
          {{"name", row.name}, {"needed", row.needed}, {"modelled", row.modelled}, {"why", row.why}});
  }
  if (parts.device_bytes_per_particle)
    document["device_bytes_per_particle"] = *parts.device_bytes_per_particle;
  if (parts.against_full.empty()) return;
  document["against_full"] = Json::array();
  for (const Saving& saving : parts.against_full)
    document["against_full"].push_back(
        {{"quantity", saving.quantity}, {"value", saving.value}, {"full", saving.full}});
  if (parts.position_difference) document["position_difference"] = *parts.position_difference;
}

ModelledParts modelled_parts_from(const JsonReader& document) {
  ModelledParts parts;
  if (const auto features = document.maybe("features"))
    for (const JsonReader& row : features->elements())
      parts.features.push_back({row.at("name").string(), row.at("needed").boolean(),
                                row.at("modelled").boolean(), row.at("why").string()});
  parts.device_bytes_per_particle = optional_number(document, "device_bytes_per_particle");
  if (const auto savings = document.maybe("against_full"))
    for (const JsonReader& row : savings->elements())
      parts.against_full.push_back(
          {row.at("quantity").string(), row.at("value").number(), row.at("full").number()});
  parts.position_difference = optional_number(document, "position_difference");
  return parts;
}

std::string variant_from(const JsonReader& document) {
  const std::string name = document.at("variant").string();
  const bool says_so = document.maybe("features").has_value() || name.ends_with(full_model);
  return says_so ? name : name + full_model;
}

std::string variant_of_case_from(const JsonReader& sweep_case) {
  const std::string name = sweep_case.at("variant").string();
  return sweep_case.at("axes").maybe("model") ? name : name + full_model;
}

}  // namespace warpgrain::reports
