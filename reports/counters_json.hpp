#pragma once
// Counters to JSON and back, in the keys of "warpgrain.report/1".

#include <nlohmann/json_fwd.hpp>

#include "profiler/counters.hpp"

namespace warpgrain {
class JsonReader;
}

namespace warpgrain::reports {

// What is known of totals beside the instructions.
struct TotalsParts {
  bool lanes = true;     // how many of them were active, and how they branched
  bool requests = true;  // to memory
};

nlohmann::ordered_json to_json(const profiler::Totals& totals, std::uint32_t warp_width,
                               TotalsParts parts = {});
nlohmann::ordered_json to_json(const profiler::LineTotals& line, std::uint32_t warp_width);
// `launch` is the branch's.
nlohmann::ordered_json to_json(const profiler::BranchTotals& branch, const profiler::LaunchCounters& launch);
nlohmann::ordered_json to_json(const profiler::BlockTotals& block);
nlohmann::ordered_json to_json(const profiler::WhatIfTotals& answer);

// Throw InputError naming the place of what is missing or wrong. Derived keys (active_lanes, loss_share, ...)
// are not read: they follow from the counts.
std::uint32_t warp_width_from(const JsonReader& place);
profiler::Totals totals_from(const JsonReader& place, std::uint32_t warp_width, TotalsParts parts = {});
profiler::LineTotals line_from(const JsonReader& place, std::uint32_t warp_width);
profiler::BranchTotals branch_from(const JsonReader& place);
profiler::BlockTotals block_from(const JsonReader& place, std::uint32_t warp_width);
profiler::WhatIfTotals what_if_from(const JsonReader& place);

}  // namespace warpgrain::reports
