#include <fmt/format.h>

#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/html/views.hpp"

namespace warpgrain::reports::html {
namespace {

Table table_of(Table::Column second) {
  return Table({{"kernel", "its name in the source", true},
                std::move(second),
                Table::of_metric("simt_efficiency"),
                Table::of_metric("active_lanes"),
                Table::of_metric("warp_instructions"),
                {"share", "of the warp instructions of all launches"},
                Table::of_metric("branches"),
                Table::of_metric("divergent_branches"),
                Table::of_metric("sfu_instructions"),
                Table::of_metric("sectors_per_load")});
}

std::vector<Cell> row_of(const std::string& name, Cell second, const Headline& headline, double all) {
  return {text_cell(name),
          std::move(second),
          number_cell(headline.simt_efficiency, 3),
          number_cell(headline.active_lanes, 1),
          count_cell(headline.warp_instructions),
          share_cell(static_cast<double>(headline.warp_instructions), all),
          count_cell(headline.branches),
          count_cell(headline.divergent_branches),
          count_cell(headline.sfu_instructions),
          optional_cell(headline.sectors_per_load, 2)};
}

std::string launches_table(const Report& report, double all) {
  Table table = table_of({"work-items", "global size and work-group size"});
  for (const LaunchReport& launch : report.launches) {
    const auto& [global, local] = launch.counters.shape;
    Cell size = count_cell(global[0] * global[1] * global[2]);
    size.html += fmt::format(" / {}", local[0] * local[1] * local[2]);
    table.add_row(row_of(launch.counters.kernel, size, headline_of(launch.counters), all));
  }
  return table.html();
}

}  // namespace

std::string kernels_view(const Report& report, const std::vector<KernelSummary>& kernels) {
  const Headline headline = headline_of(kernels);
  const auto all = static_cast<double>(headline.warp_instructions);
  Table table = table_of({"launches", "launches of this kernel, taken together"});
  for (const KernelSummary& kernel : kernels)
    table.add_row(
        row_of(kernel.counters.kernel, count_cell(kernel.launches), headline_of(kernel.counters), all));
  table.set_footer(row_of("all", count_cell(report.launches.size()), headline, all));
  std::string html = "<h2>Kernels</h2>\n" + table.html();
  if (report.launches.size() > kernels.size())
    html += fmt::format(
        "<details><summary>Launch by launch <span class=\"soft\">{} "
        "launches</span></summary>\n{}</details>\n",
        report.launches.size(), launches_table(report, all));
  return html;
}

}  // namespace warpgrain::reports::html
