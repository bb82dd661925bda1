#include <nlohmann/json.hpp>

#include "reports/comparison.hpp"
#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Difference& difference) {
  Json json{{"kernel", difference.kernel},
            {"metric", difference.metric},
            {"base", difference.base},
            {"other", difference.other}};
  if (const auto relative = difference.relative()) json["relative"] = *relative;
  return json;
}

Json to_json(const OrderComparison& order) {
  Json json;
  json["variants"] = Json::array();
  for (const OrderComparison::Row& row : order.rows) {
    Json variant{{"variant", row.variant}, {"warp_instructions", row.warp_instructions}};
    if (row.predicted_seconds) variant["predicted_seconds"] = *row.predicted_seconds;
    variant["seconds"] = row.seconds;
    json["variants"].push_back(std::move(variant));
  }
  json["by"] = order.by_time ? "predicted_seconds" : "warp_instructions";
  if (order.tau) json["kendall_tau"] = *order.tau;
  if (order.interval) json["interval"] = {order.interval->lower, order.interval->upper};
  if (order.error) json["time_error"] = {{"median", order.error->median}, {"largest", order.error->largest}};
  if (order.left_out) {
    const auto& [tau, error] = *order.left_out;
    json["left_out"] = {{"kendall_tau", {tau.lower, tau.upper}},
                        {"median_time_error", {error.lower, error.upper}}};
  }
  return json;
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json json = document_head(comparison_format, comparison.generator, comparison.command_line);
  json["base"] = comparison.base;
  json["other"] = comparison.other;
  json["differences"] = Json::array();
  for (const Difference& difference : comparison.differences)
    json["differences"].push_back(to_json(difference));
  json["only_in_base"] = comparison.only_in_base;
  json["only_in_other"] = comparison.only_in_other;
  if (comparison.order) json["order"] = to_json(*comparison.order);
  return json_text(json, "comparison");
}

}  // namespace warpgrain::reports
