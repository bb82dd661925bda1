#include <fmt/format.h>

#include "reports/html/charts.hpp"
#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/html/views.hpp"

namespace warpgrain::reports::html {
namespace {

std::vector<Cell> row_of(const profiler::WhatIfTotals& answer, const profiler::Totals& run) {
  const profiler::Totals& totals = answer.totals;
  const bool has_loads = answer.has_requests && totals.global_load.requests != 0;
  const Cell unknown{"-", {}, {}};
  return {
      count_cell(answer.warp_width),
      text_cell(policy_text(answer)),
      text_cell(answer.order),
      number_cell(totals.simt_efficiency(answer.warp_width), 3),
      number_cell(totals.active_lanes(), 1),
      count_cell(totals.warp_instructions),
      share_cell(static_cast<double>(totals.warp_instructions), static_cast<double>(run.warp_instructions)),
      answer.pool == 0 ? count_cell(totals.divergent_branches) : unknown,
      count_cell(totals.sfu_instructions),
      has_loads ? number_cell(totals.global_load.sectors_per_request(), 2) : unknown};
}

}  // namespace

std::string what_if_view(const KernelSummary& kernel) {
  if (kernel.counters.what_if.empty()) return {};
  Table table({{"warp width", "lanes of a warp"},
               {"policy",
                "how parted lanes come together again; bound: what no regrouping of the threads of a pool at "
                "each block can beat",
                true},
               {"thread order", "in which order the threads fill the warps", true},
               Table::of_metric("simt_efficiency"),
               Table::of_metric("active_lanes"),
               Table::of_metric("warp_instructions"),
               {"against the run", "warp instructions over those of the run itself"},
               Table::of_metric("divergent_branches"),
               Table::of_metric("sfu_instructions"),
               Table::of_metric("sectors_per_load")});
  for (const profiler::WhatIfTotals& answer : kernel.counters.what_if)
    table.add_row(row_of(answer, kernel.counters.totals));
  std::string html =
      fmt::format("<h3>What if</h3>\n<p>The run: {} lanes a warp, {}, threads as launched.{}</p>\n{}",
                  kernel.counters.warp_width, escape(kernel.counters.policy),
                  kernel.counters.weights.sass
                      ? " Its instructions are those of the machine code, those of the answers the PTX's."
                      : "",
                  table.html());
  html += what_if_chart(kernel.counters);
  for (const std::string& remark : remarks_of(kernel.counters.what_if))
    html += fmt::format("<p class=\"soft\">{}</p>\n", escape(remark));
  return html;
}

}  // namespace warpgrain::reports::html
