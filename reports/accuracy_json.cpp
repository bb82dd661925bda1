#include <nlohmann/json.hpp>

#include "reports/accuracy_report.hpp"
#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"

namespace warpgrain::reports {
namespace {

using AccuracyJson = nlohmann::ordered_json;

AccuracyJson ensemble_json(const AccuracyReport::Ensemble& quantity) {
  AccuracyJson json{{"quantity", quantity.quantity}, {"unit", quantity.unit}, {"mean", quantity.mean}};
  if (quantity.half_width) json["half_width"] = *quantity.half_width;
  if (quantity.difference) json["difference"] = *quantity.difference;
  if (quantity.difference_half_width) json["difference_half_width"] = *quantity.difference_half_width;
  json["significant"] = quantity.significant;
  return json;
}

AccuracyJson case_json(const AccuracyReport::Case& row) {
  AccuracyJson json{{"variant", row.variant}, {"step_factor", row.step_factor},
                    {"backend", row.backend}, {"warp_instructions", row.warp_instructions},
                    {"bytes", row.bytes},     {"relative_cost", row.relative_cost}};
  if (row.seconds) json["seconds"] = *row.seconds;
  if (row.predicted_seconds) json["predicted_seconds"] = *row.predicted_seconds;
  if (row.measured_seconds) json["measured_seconds"] = *row.measured_seconds;
  if (row.force)
    json["force"] = {{"maximum", row.force->maximum},
                     {"root_mean_square", row.force->root_mean_square},
                     {"maximum_ulps", row.force->maximum_ulps},
                     {"root_mean_square_ulps", row.force->root_mean_square_ulps}};
  if (row.collision)
    json["collision"] = {{"restitution", row.collision->restitution},
                         {"rebound_angle", row.collision->rebound_angle},
                         {"spin", row.collision->spin}};
  if (row.trajectory) {
    json["trajectory"] = {{"compared", row.trajectory->compared}, {"distance", row.trajectory->distance}};
    if (row.trajectory->parted_at) json["trajectory"]["parted_at"] = *row.trajectory->parted_at;
  }
  json["ensemble"] = AccuracyJson::array();
  for (const auto& quantity : row.ensemble) json["ensemble"].push_back(ensemble_json(quantity));
  json["on_front"] = !row.dominated_by;
  if (row.dominated_by) json["dominated_by"] = *row.dominated_by;
  if (!row.failure.empty()) json["failure"] = row.failure;
  json["sentence"] = sentence_of(row);
  return json;
}

AccuracyReport::Ensemble ensemble_from(const JsonReader& place) {
  return {place.at("quantity").string(),
          place.at("unit").string(),
          place.at("mean").number(),
          optional_number(place, "half_width"),
          optional_number(place, "difference"),
          optional_number(place, "difference_half_width"),
          place.at("significant").boolean()};
}

AccuracyReport::Case case_from(const JsonReader& place) {
  AccuracyReport::Case row;
  row.variant = place.at("variant").string();
  row.step_factor = place.at("step_factor").number();
  row.backend = place.at("backend").string();
  row.warp_instructions = place.at("warp_instructions").whole_number();
  row.bytes = place.at("bytes").whole_number();
  row.relative_cost = place.at("relative_cost").number();
  row.seconds = optional_number(place, "seconds");
  row.predicted_seconds = optional_number(place, "predicted_seconds");
  row.measured_seconds = optional_number(place, "measured_seconds");
  if (const auto force = place.maybe("force"))
    row.force = {force->at("maximum").number(), force->at("root_mean_square").number(),
                 force->at("maximum_ulps").number(), force->at("root_mean_square_ulps").number()};
  if (const auto collision = place.maybe("collision"))
    row.collision = {collision->at("restitution").number(), collision->at("rebound_angle").number(),
                     collision->at("spin").number()};
  if (const auto trajectory = place.maybe("trajectory"))
    row.trajectory = {optional_number(*trajectory, "parted_at"), trajectory->at("compared").number(),
                      trajectory->at("distance").number()};
  for (const JsonReader& quantity : place.at("ensemble").elements())
    row.ensemble.push_back(ensemble_from(quantity));
  row.dominated_by = optional_string(place, "dominated_by");
  row.failure = optional_string(place, "failure").value_or("");
  return row;
}

}  // namespace

std::string accuracy_json(const AccuracyReport& report) {
  AccuracyJson json = document_head(accuracy_format, report.generator, report.command_line);
  json["scene"] = report.scene;
  json["particles"] = report.particles;
  if (report.seed) json["seed"] = *report.seed;
  json["step"] = report.step;
  json["time_step"] = report.time_step;
  json["seeds"] = report.seeds;
  json["cost"] = report.cost;
  json["cost_particles"] = report.cost_particles;
  if (!report.machine.empty()) json["machine"] = report.machine;
  if (!report.measured.empty()) json["measured"] = report.measured;
  json["cases"] = AccuracyJson::array();
  for (const AccuracyReport::Case& row : report.cases) json["cases"].push_back(case_json(row));
  return json_text(json, "accuracy");
}

AccuracyReport read_accuracy(const std::filesystem::path& file) {
  const JsonReader root = read_document(file, accuracy_format);
  AccuracyReport report;
  report.generator = generator_from(root);
  report.command_line = root.at("command_line").string();
  report.scene = root.at("scene").string();
  report.particles = root.at("particles").whole_number();
  report.seed = optional_whole_number(root, "seed");
  report.step = root.at("step").whole_number();
  report.time_step = root.at("time_step").number();
  report.seeds = root.at("seeds").whole_number();
  report.cost = root.at("cost").string();
  report.cost_particles = root.at("cost_particles").whole_number();
  report.machine = optional_string(root, "machine").value_or("");
  report.measured = optional_string(root, "measured").value_or("");
  for (const JsonReader& row : root.at("cases").elements()) report.cases.push_back(case_from(row));
  return report;
}

}  // namespace warpgrain::reports
