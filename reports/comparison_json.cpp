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
  for (const OrderComparison::Row& row : order.rows)
    json["variants"].push_back(
        {{"variant", row.variant}, {"warp_instructions", row.predicted}, {"seconds", row.seconds}});
  if (order.tau) json["kendall_tau"] = *order.tau;
  if (order.interval) json["interval"] = {order.interval->lower, order.interval->upper};
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
