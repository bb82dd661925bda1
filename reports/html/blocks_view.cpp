#include <algorithm>
#include <fmt/format.h>

#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/html/views.hpp"
#include "reports/metrics.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {
namespace {

// Blocks by what they idle: most kernels have many that hardly count.
std::vector<const profiler::BlockTotals*> by_idle_slots(const profiler::LaunchCounters& counters) {
  std::vector<const profiler::BlockTotals*> blocks;
  for (const profiler::BlockTotals& block : counters.blocks)
    if (block.executions != 0) blocks.push_back(&block);
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](const auto* a, const auto* b) { return a->lane_slots_idle() > b->lane_slots_idle(); });
  return blocks;
}

}  // namespace

std::string lanes_bars(const std::vector<std::uint64_t>& lane_histogram) {
  const auto most = std::max_element(lane_histogram.begin(), lane_histogram.end());
  if (most == lane_histogram.end() || *most == 0) return {};
  std::string svg = fmt::format(
      "<svg class=\"lanes\" data-lanes=\"{}\" viewBox=\"0 0 {} 16\" "
      "preserveAspectRatio=\"none\"><title>executions "
      "by active lanes, 0 to {}</title>",
      fmt::join(lane_histogram, ","), lane_histogram.size(), lane_histogram.size() - 1);
  for (std::size_t lanes = 0; lanes < lane_histogram.size(); ++lanes) {
    const double height = 16 * static_cast<double>(lane_histogram[lanes]) / static_cast<double>(*most);
    if (height > 0)
      svg += fmt::format("<rect x=\"{}\" y=\"{:.2f}\" width=\"0.9\" height=\"{:.2f}\"/>", lanes, 16 - height,
                         height);
  }
  return svg + "</svg>";
}

std::string blocks_view(const KernelSummary& kernel) {
  const profiler::LaunchCounters& counters = kernel.counters;
  Table table({{"block", "label in the PTX", true},
               {"instructions", "of the PTX, in the block"},
               {"executions", "how often warps ran the block"},
               {"active lanes", explanation("mean of the executions", "active_lanes")},
               {"by active lanes", "executions by number of active lanes, each block to its own largest"},
               {"lanes disagreed", explanation("share of the executions from which lanes went different ways",
                                               "divergent_branches")},
               {"idle lane slots", std::string(metric("lane_slots_idle").definition)},
               {"share", "of all idle lane slots"}});
  const auto all = static_cast<double>(kernel.lane_slots_lost());
  for (const profiler::BlockTotals* block : by_idle_slots(counters)) {
    double lanes = 0;
    for (std::size_t k = 0; k < block->lane_histogram.size(); ++k)
      lanes += static_cast<double>(k) * static_cast<double>(block->lane_histogram[k]);
    const auto executions = static_cast<double>(block->executions);
    table.add_row({text_cell(block->label),
                   count_cell(block->instructions),
                   count_cell(block->executions),
                   number_cell(lanes / executions, 1),
                   {lanes_bars(block->lane_histogram), {}, {}},
                   share_cell(static_cast<double>(block->divergent), executions),
                   count_cell(block->lane_slots_idle()),
                   share_cell(static_cast<double>(block->lane_slots_idle()), all)});
  }
  return fmt::format(
      "<details><summary>Basic blocks <span class=\"soft\">{} of the PTX</span></summary>\n{}</details>\n",
      counters.blocks.size(), table.html());
}

}  // namespace warpgrain::reports::html
