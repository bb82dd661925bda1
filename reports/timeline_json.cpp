#include "reports/timeline_json.hpp"

#include <bit>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const profiler::WarpTimeline& timeline) {
  return {{"warp", timeline.warp},
          {"chosen_as", timeline.chosen_as},
          {"warp_instructions", timeline.sums.warp_instructions},
          {"thread_instructions", timeline.sums.thread_instructions},
          {"executions", timeline.executions},
          {"blocks", timeline.blocks},
          {"lanes", timeline.lanes}};
}

profiler::WarpTimeline timeline_from(const JsonReader& place, std::size_t n_blocks,
                                     std::uint32_t warp_width) {
  profiler::WarpTimeline timeline;
  timeline.warp = place.at("warp").whole_number();
  for (const JsonReader& reason : place.at("chosen_as").elements())
    timeline.chosen_as.push_back(reason.string());
  timeline.sums = {place.at("warp_instructions").whole_number(),
                   place.at("thread_instructions").whole_number()};
  timeline.executions = place.at("executions").whole_number();
  for (const JsonReader& block : place.at("blocks").elements()) {
    timeline.blocks.push_back(whole_number32(block));
    if (timeline.blocks.back() >= n_blocks)
      block.fail(fmt::format("block {}", timeline.blocks.back()), fmt::format("less than {}", n_blocks));
  }
  timeline.lanes = whole_numbers(place.at("lanes"));
  if (timeline.lanes.size() != timeline.blocks.size() || timeline.executions < timeline.blocks.size())
    place.fail(fmt::format("{} blocks, {} masks, {} executions", timeline.blocks.size(),
                           timeline.lanes.size(), timeline.executions),
               "a mask for each block, and as many executions or more");
  for (const std::uint64_t lanes : timeline.lanes)
    if (lanes == 0 || static_cast<std::uint32_t>(std::bit_width(lanes)) > warp_width)
      place.at("lanes").fail(fmt::format("the mask {}", lanes),
                             fmt::format("one to {} lanes of the warp", warp_width));
  return timeline;
}

}  // namespace warpgrain::reports
