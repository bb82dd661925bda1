#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/comparison.hpp"
#include "reports/number_text.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {
namespace {

std::string value_text(const std::string& metric, double value) {
  if (metric == "seconds") return seconds_text(value);
  return value == static_cast<double>(static_cast<std::uint64_t>(value))
             ? count_text(static_cast<std::uint64_t>(value))
             : fmt::format("{:.4g}", value);
}

std::string relative_text(const Difference& difference) {
  const auto relative = difference.relative();
  return relative ? fmt::format("{:+.2f} %", 100 * *relative) : "from 0";
}

std::string order_text(const OrderComparison& order) {
  TextTable table({{"variant", TextTable::Align::left},
                   {"warp instructions"},
                   {"predicted step"},
                   {"step"},
                   {"difference"}});
  for (const OrderComparison::Row& row : order.rows)
    table.add_row(
        {row.variant, value_text("", row.warp_instructions),
         row.predicted_seconds ? seconds_text(*row.predicted_seconds) : "-", seconds_text(row.seconds),
         row.predicted_seconds ? fmt::format("{:+.1f} %", 100 * (*row.predicted_seconds / row.seconds - 1))
                               : "-"});
  std::string text = table.text();
  text += fmt::format("Kendall's tau of {}: ", order.by_time ? "predicted times" : "warp instructions");
  text += order.tau ? fmt::format("{:.3f}", *order.tau) : std::string("none");
  if (order.interval)
    text += fmt::format(", 95 % of draws of the readings from {:.3f} to {:.3f}", order.interval->lower,
                        order.interval->upper);
  if (order.left_out)
    text += fmt::format("; without any one variant {:.3f} to {:.3f}", order.left_out->tau.lower,
                        order.left_out->tau.upper);
  text += '\n';
  if (order.error) {
    text += fmt::format("error of predicted times: median {:.1f} %, largest {:.1f} %",
                        100 * order.error->median, 100 * order.error->largest);
    if (order.left_out)
      text += fmt::format("; median without any one variant {:.1f} to {:.1f} %",
                          100 * order.left_out->median_error.lower, 100 * order.left_out->median_error.upper);
    text += '\n';
  }
  return text;
}

}  // namespace

std::string text_comparison(const Comparison& comparison) {
  if (comparison.order) return order_text(*comparison.order);
  TextTable table({{"kernel", TextTable::Align::left},
                   {"metric", TextTable::Align::left},
                   {comparison.base},
                   {comparison.other},
                   {"difference"}});
  for (const Difference& d : comparison.differences)
    table.add_row(
        {d.kernel, d.metric, value_text(d.metric, d.base), value_text(d.metric, d.other), relative_text(d)});
  std::string text = table.text();
  if (!comparison.only_in_base.empty())
    text += fmt::format("only in {}: {}\n", comparison.base, fmt::join(comparison.only_in_base, ", "));
  if (!comparison.only_in_other.empty())
    text += fmt::format("only in {}: {}\n", comparison.other, fmt::join(comparison.only_in_other, ", "));
  return text;
}

}  // namespace warpgrain::reports
