#include <fmt/format.h>

#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/html/views.hpp"
#include "reports/metrics.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {
namespace {

std::string introduction(const KernelSummary& kernel) {
  const profiler::LaunchCounters& counters = kernel.counters;
  const auto slots = static_cast<double>(counters.totals.warp_instructions) * counters.warp_width;
  const auto lost = static_cast<double>(kernel.lane_slots_lost());
  std::string text = fmt::format("{} of {} lane slots were lost ({}).", count_text(kernel.lane_slots_lost()),
                                 count_text(static_cast<std::uint64_t>(slots)), percent_text(lost, slots));
  if (counters.lane_slots_never_used > 0)
    text += fmt::format(" {} of the loss are warps that are not full from the start.",
                        percent_text(static_cast<double>(counters.lane_slots_never_used), lost));
  return text;
}

}  // namespace

std::string branches_view(const KernelSummary& kernel) {
  Table table({{"branch", "the // branch: comment of the source line, else the line", true},
               {"place", "file and line of the branch", true},
               {"share of the loss", explanation(metric("loss_share"))},
               {"lost lane slots", explanation(metric("lane_slots_lost"))},
               {"executions", explanation("how often warps came to it", "branches")},
               {"lanes disagreed",
                explanation("share of the executions whose lanes disagreed", "divergent_branches")},
               {"lanes that took it", "share of the lanes that executed it"},
               {"by active lanes", "executions by number of active lanes, each branch to its own largest"}});
  const auto lost = static_cast<double>(kernel.lane_slots_lost());
  for (const profiler::BranchTotals& branch : kernel.counters.branches)
    table.add_row({{fmt::format("<span class=\"mono\">{}</span>", escape(branch.label)), {}, {}},
                   text_cell(fmt::format("{}:{}", branch.file, branch.line)),
                   share_cell(static_cast<double>(branch.lane_slots_lost), lost),
                   count_cell(branch.lane_slots_lost),
                   count_cell(branch.executions),
                   share_cell(static_cast<double>(branch.divergent), static_cast<double>(branch.executions)),
                   share_cell(static_cast<double>(branch.taken_lanes), static_cast<double>(branch.lanes)),
                   {lanes_bars(kernel.counters.blocks.at(branch.block).lane_histogram), {}, {}}});
  return fmt::format(
      "<h3>Branches by loss</h3>\n<p>{}</p>\n{}", escape(introduction(kernel)),
      kernel.counters.branches.empty() ? "<p class=\"soft\">No conditional branch.</p>\n" : table.html());
}

}  // namespace warpgrain::reports::html
