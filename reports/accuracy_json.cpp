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

}  // namespace

std::string accuracy_json(const AccuracyReport& report) {
  AccuracyJson json = document_head(accuracy_format, report.generator, report.command_line);
  json["scene"] = report.scene;
  json["particles"] = report.particles;
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

}  // namespace warpgrain::reports
