#include "analysis/sfu_cost.hpp"

namespace warpgrain {

SfuCost sfu_cost(const profiler::Totals& totals, std::uint32_t warp_width, const Machine& machine) {
  SfuCost cost;
  cost.instructions = totals.sfu_instructions;
  cost.serialisation = machine.lanes.value / machine.sfu_lanes.value;
  cost.cycles = static_cast<double>(totals.sfu_instructions) * warp_width / machine.sfu_lanes.value;
  cost.issue_cycles = static_cast<double>(totals.warp_instructions) / machine.issue_rate.value;
  return cost;
}

}  // namespace warpgrain
