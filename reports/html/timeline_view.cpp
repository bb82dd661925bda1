#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/html/page.hpp"
#include "reports/html/views.hpp"

namespace warpgrain::reports::html {
namespace {

using TimelineData = nlohmann::ordered_json;

// Blocks by number, with the text of the line that each begins with.
TimelineData blocks_of(const KernelSummary& kernel) {
  std::vector<bool> used(kernel.counters.blocks.size(), false);
  for (const profiler::WarpTimeline& timeline : kernel.counters.timelines)
    for (const std::uint32_t block : timeline.blocks) used.at(block) = true;
  const SourceIndex source(*kernel.source);
  TimelineData blocks = TimelineData::array();
  for (const profiler::BlockTotals& block : kernel.counters.blocks) {
    blocks.push_back({{"label", block.label},
                      {"file", block.file},
                      {"line", block.line},
                      {"text", source.text_of(block.file, block.line)},
                      {"instructions", block.instructions},
                      {"used", bool{used[block.block]}}});
  }
  return blocks;
}

// Masks in base 16: a script's numbers hold no 64 bits.
TimelineData warp_of(const profiler::WarpTimeline& timeline, std::uint32_t warp_width) {
  std::string lanes;
  for (const std::uint64_t mask : timeline.lanes)
    lanes += fmt::format("{}{:x}", lanes.empty() ? "" : " ", mask);
  const auto slots = static_cast<double>(timeline.sums.warp_instructions) * warp_width;
  return {{"warp", timeline.warp},
          {"chosen_as", timeline.chosen_as},
          {"efficiency", slots == 0 ? 0 : static_cast<double>(timeline.sums.thread_instructions) / slots},
          {"executions", timeline.executions},
          {"blocks", timeline.blocks},
          {"lanes", lanes}};
}

}  // namespace

std::string timeline_view(const KernelSummary& kernel) {
  const profiler::LaunchCounters& counters = kernel.counters;
  if (counters.timelines.empty()) return {};
  TimelineData data{
      {"width", counters.warp_width}, {"blocks", blocks_of(kernel)}, {"warps", TimelineData::array()}};
  for (const profiler::WarpTimeline& timeline : counters.timelines)
    data["warps"].push_back(warp_of(timeline, counters.warp_width));
  return fmt::format(
      "<h3>What a warp did</h3>\n<p class=\"soft\">A column is an execution of a basic block of the PTX, in "
      "the order of "
      "issuing under {}; a row is a lane, coloured while it was active by the file that the block begins in. "
      "Above, the number "
      "of active lanes.{} median: the warp nearest to the median efficiency of a sample of 32; worst: the "
      "lowest efficiency; "
      "costliest: the most idle lane slots.</p>\n<div class=\"timeline\" data-timeline=\"{}\"></div>\n",
      escape(counters.policy), kernel.launches > 1 ? " Of the first launch." : "",
      escape(data.dump(-1, ' ', false, TimelineData::error_handler_t::replace)));
}

}  // namespace warpgrain::reports::html
