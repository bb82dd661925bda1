#pragma once
// The key "timelines" of a launch.

#include <nlohmann/json_fwd.hpp>

#include "core/json_reader.hpp"
#include "profiler/timeline.hpp"

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const profiler::WarpTimeline& timeline);
// Throws InputError for blocks that the launch has not and for masks wider than the warp.
profiler::WarpTimeline timeline_from(const JsonReader& place, std::size_t n_blocks, std::uint32_t warp_width);

}  // namespace warpgrain::reports
