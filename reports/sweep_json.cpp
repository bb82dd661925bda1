#include <array>
#include <nlohmann/json.hpp>

#include "reports/json_place.hpp"
#include "reports/json_text.hpp"
#include "reports/provenance_json.hpp"
#include "reports/sweep_index.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> status_names{"done", "failed", "skipped"};

Json to_json(const Headline& headline) {
  Json json{{"warp_instructions", headline.warp_instructions},
            {"thread_instructions", headline.thread_instructions},
            {"active_lanes", headline.active_lanes},
            {"simt_efficiency", headline.simt_efficiency},
            {"branches", headline.branches},
            {"divergent_branches", headline.divergent_branches},
            {"sfu_instructions", headline.sfu_instructions}};
  if (headline.sectors_per_load) json["sectors_per_load"] = *headline.sectors_per_load;
  return json;
}

Headline headline_from(const JsonPlace& place) {
  return {.warp_instructions = place["warp_instructions"].count(),
          .thread_instructions = place["thread_instructions"].count(),
          .active_lanes = place["active_lanes"].number(),
          .simt_efficiency = place["simt_efficiency"].number(),
          .branches = place["branches"].count(),
          .divergent_branches = place["divergent_branches"].count(),
          .sfu_instructions = place["sfu_instructions"].count(),
          .sectors_per_load = place.optional_number("sectors_per_load")};
}

Json to_json(const BackendReading& reading) {
  Json json{{"backend", reading.backend}, {"device", reading.device}, {"steps", reading.steps}};
  if (reading.seconds_per_step) json["seconds_per_step"] = *reading.seconds_per_step;
  if (reading.force_error)
    json["force_error"] = {{"maximum", reading.force_error->maximum},
                           {"root_mean_square", reading.force_error->root_mean_square}};
  return json;
}

BackendReading reading_from(const JsonPlace& place) {
  BackendReading reading{.backend = place["backend"].text(),
                         .device = place["device"].text(),
                         .steps = place["steps"].count(),
                         .seconds_per_step = place.optional_number("seconds_per_step"),
                         .force_error = {}};
  if (const auto error = place.find("force_error"))
    reading.force_error = {(*error)["maximum"].number(), (*error)["root_mean_square"].number()};
  return reading;
}

Json to_json(const SweepCase& sweep_case) {
  Json json{{"variant", sweep_case.variant}, {"axes", Json::object()}};
  for (const auto& [axis, value] : sweep_case.axes) json["axes"][axis] = value;
  json["status"] = case_status_name(sweep_case.status);
  if (!sweep_case.message.empty()) json["message"] = sweep_case.message;
  if (sweep_case.report_file) json["report_file"] = *sweep_case.report_file;
  if (sweep_case.headline) json["headline"] = to_json(*sweep_case.headline);
  json["backends"] = Json::array();
  for (const BackendReading& reading : sweep_case.backends) json["backends"].push_back(to_json(reading));
  return json;
}

SweepCase case_from(const JsonPlace& place) {
  SweepCase sweep_case;
  sweep_case.variant = place["variant"].text();
  for (const auto& [axis, value] : place["axes"].members()) sweep_case.axes[axis] = value.text();
  sweep_case.status = static_cast<CaseStatus>(place["status"].one_of(status_names, "status"));
  sweep_case.message = place.optional_text("message").value_or("");
  sweep_case.report_file = place.optional_text("report_file");
  if (const auto headline = place.find("headline")) sweep_case.headline = headline_from(*headline);
  for (const JsonPlace& reading : place["backends"].elements())
    sweep_case.backends.push_back(reading_from(reading));
  return sweep_case;
}

}  // namespace

std::string_view case_status_name(CaseStatus status) {
  return status_names[static_cast<std::size_t>(status)];
}

std::string sweep_json(const SweepIndex& index) {
  Json json = document_head(sweep_format, index.generator, index.command_line);
  json["scene"] = index.scene;
  json["particles"] = index.particles;
  json["step"] = index.step;
  json["cases"] = Json::array();
  for (const SweepCase& sweep_case : index.cases) json["cases"].push_back(to_json(sweep_case));
  return json_text(json, "sweep");
}

SweepIndex read_sweep(const std::filesystem::path& file) {
  const Json document = read_json(file);
  const JsonPlace root = document_of_format(document, file.string(), sweep_format);
  SweepIndex index;
  index.generator = generator_from(root);
  index.command_line = root["command_line"].text();
  index.scene = root["scene"].text();
  index.particles = root["particles"].count();
  index.step = root["step"].count();
  for (const JsonPlace& sweep_case : root["cases"].elements()) index.cases.push_back(case_from(sweep_case));
  return index;
}

}  // namespace warpgrain::reports
