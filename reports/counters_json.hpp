#pragma once
// Counters to JSON and back, in the keys of "warpgrain.report/1".

#include <nlohmann/json_fwd.hpp>

#include "profiler/counters.hpp"

namespace warpgrain {
class JsonReader;
}

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const profiler::Totals& totals, std::uint32_t warp_width);
nlohmann::ordered_json to_json(const profiler::LineTotals& line, std::uint32_t warp_width);
nlohmann::ordered_json to_json(const profiler::BranchTotals& branch);
nlohmann::ordered_json to_json(const profiler::BlockTotals& block);

// Throw InputError naming the place of what is missing or wrong. Derived keys (active_lanes, simt_efficiency)
// are not read: they follow from the counts.
profiler::Totals totals_from(const JsonReader& place, std::uint32_t warp_width);
profiler::LineTotals line_from(const JsonReader& place, std::uint32_t warp_width);
profiler::BranchTotals branch_from(const JsonReader& place);
profiler::BlockTotals block_from(const JsonReader& place, std::uint32_t warp_width);

}  // namespace warpgrain::reports
