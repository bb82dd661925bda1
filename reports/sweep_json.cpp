#include <array>
#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"
#include "reports/modelled_parts_json.hpp"
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
  if (headline.predicted_seconds) json["predicted_seconds"] = *headline.predicted_seconds;
  json["heaviest_kernel"] = {{"kernel", headline.heaviest_kernel.kernel},
                             {"share", headline.heaviest_kernel.share},
                             {"simt_efficiency", headline.heaviest_kernel.simt_efficiency}};
  return json;
}

Headline headline_from(const JsonReader& place) {
  const JsonReader heaviest = place.at("heaviest_kernel");
  return {.warp_instructions = place.at("warp_instructions").whole_number(),
          .thread_instructions = place.at("thread_instructions").whole_number(),
          .active_lanes = place.at("active_lanes").number(),
          .simt_efficiency = place.at("simt_efficiency").number(),
          .branches = place.at("branches").whole_number(),
          .divergent_branches = place.at("divergent_branches").whole_number(),
          .sfu_instructions = place.at("sfu_instructions").whole_number(),
          .sectors_per_load = optional_number(place, "sectors_per_load"),
          .predicted_seconds = optional_number(place, "predicted_seconds"),
          .heaviest_kernel = {heaviest.at("kernel").string(), heaviest.at("share").number(),
                              heaviest.at("simt_efficiency").number()}};
}

Json to_json(const BackendReading& reading) {
  Json json{{"backend", reading.backend}, {"device", reading.device}, {"steps", reading.steps}};
  if (reading.seconds_per_step) json["seconds_per_step"] = *reading.seconds_per_step;
  if (reading.force_error)
    json["force_error"] = {{"maximum", reading.force_error->maximum},
                           {"root_mean_square", reading.force_error->root_mean_square}};
  return json;
}

BackendReading reading_from(const JsonReader& place) {
  BackendReading reading{.backend = place.at("backend").string(),
                         .device = place.at("device").string(),
                         .steps = place.at("steps").whole_number(),
                         .seconds_per_step = optional_number(place, "seconds_per_step"),
                         .force_error = {}};
  if (const auto error = place.maybe("force_error"))
    reading.force_error = {error->at("maximum").number(), error->at("root_mean_square").number()};
  return reading;
}

Json to_json(const SweepCase& sweep_case) {
  Json json{{"variant", sweep_case.variant}, {"axes", Json::object()}};
  for (const auto& [axis, value] : sweep_case.axes) json["axes"][axis] = value;
  json["status"] = case_status_name(sweep_case.status);
  if (!sweep_case.message.empty()) json["message"] = sweep_case.message;
  if (sweep_case.report_file) json["report_file"] = *sweep_case.report_file;
  if (sweep_case.headline) json["headline"] = to_json(*sweep_case.headline);
  for (const SweepCase::Sample& sample : sweep_case.samples)
    json["samples"].push_back(
        {{"step", sample.step}, {"time", sample.time}, {"simt_efficiency", sample.simt_efficiency}});
  if (sweep_case.device_bytes_per_particle)
    json["device_bytes_per_particle"] = *sweep_case.device_bytes_per_particle;
  json["backends"] = Json::array();
  for (const BackendReading& reading : sweep_case.backends) json["backends"].push_back(to_json(reading));
  return json;
}

SweepCase case_from(const JsonReader& place) {
  SweepCase sweep_case;
  sweep_case.variant = variant_of_case_from(place);
  const JsonReader axes = place.at("axes");
  for (const std::string& axis : axes.keys()) sweep_case.axes[axis] = axes.at(axis).string();
  sweep_case.status = static_cast<CaseStatus>(place.at("status").one_of(status_names, "status"));
  sweep_case.message = optional_string(place, "message").value_or("");
  sweep_case.report_file = optional_string(place, "report_file");
  if (const auto headline = place.maybe("headline")) sweep_case.headline = headline_from(*headline);
  if (const auto samples = place.maybe("samples"))
    for (const JsonReader& sample : samples->elements())
      sweep_case.samples.push_back({sample.at("step").whole_number(), sample.at("time").number(),
                                    sample.at("simt_efficiency").number()});
  sweep_case.device_bytes_per_particle = optional_number(place, "device_bytes_per_particle");
  for (const JsonReader& reading : place.at("backends").elements())
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
  if (index.seed) json["seed"] = *index.seed;
  json["step"] = index.step;
  json["cases"] = Json::array();
  for (const SweepCase& sweep_case : index.cases) json["cases"].push_back(to_json(sweep_case));
  return json_text(json, "sweep");
}

SweepIndex read_sweep(const std::filesystem::path& file) {
  const JsonReader root = read_document(file, sweep_format);
  SweepIndex index;
  index.generator = generator_from(root);
  index.command_line = root.at("command_line").string();
  index.scene = root.at("scene").string();
  index.particles = root.at("particles").whole_number();
  index.seed = optional_whole_number(root, "seed");
  index.step = root.at("step").whole_number();
  for (const JsonReader& sweep_case : root.at("cases").elements())
    index.cases.push_back(case_from(sweep_case));
  return index;
}

}  // namespace warpgrain::reports
