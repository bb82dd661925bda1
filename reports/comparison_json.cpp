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

TauInterval interval_from(const JsonReader& place) {
  const std::vector<JsonReader> ends = place.elements(2, "lower and upper end");
  return {ends[0].number(), ends[1].number()};
}

OrderComparison order_from(const JsonReader& place) {
  OrderComparison order;
  for (const JsonReader& variant : place.at("variants").elements())
    order.rows.push_back({variant.at("variant").string(), variant.at("warp_instructions").number(),
                          optional_number(variant, "predicted_seconds"), variant.at("seconds").number()});
  order.by_time = place.at("by").string() == "predicted_seconds";
  for (const OrderComparison::Row& row : order.rows)
    if (order.by_time && !row.predicted_seconds)
      place.at("variants").fail("'" + row.variant + "' without predicted_seconds", "them, as 'by' says");
  order.tau = optional_number(place, "kendall_tau");
  if (const auto interval = place.maybe("interval")) order.interval = interval_from(*interval);
  if (const auto error = place.maybe("time_error"))
    order.error = {error->at("median").number(), error->at("largest").number()};
  if (const auto left_out = place.maybe("left_out"))
    order.left_out = {interval_from(left_out->at("kendall_tau")),
                      interval_from(left_out->at("median_time_error"))};
  return order;
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

Comparison read_comparison(const std::filesystem::path& file) {
  const JsonReader root = read_document(file, comparison_format);
  Comparison comparison;
  comparison.generator = generator_from(root);
  comparison.command_line = root.at("command_line").string();
  comparison.base = root.at("base").string();
  comparison.other = root.at("other").string();
  for (const JsonReader& difference : root.at("differences").elements())
    comparison.differences.push_back({difference.at("kernel").string(), difference.at("metric").string(),
                                      difference.at("base").number(), difference.at("other").number()});
  for (const JsonReader& kernel : root.at("only_in_base").elements())
    comparison.only_in_base.push_back(kernel.string());
  for (const JsonReader& kernel : root.at("only_in_other").elements())
    comparison.only_in_other.push_back(kernel.string());
  if (const auto order = root.maybe("order")) comparison.order = order_from(*order);
  return comparison;
}

}  // namespace warpgrain::reports
