#include "analysis/least_time.hpp"

#include "analysis/sfu_cost.hpp"

namespace warpgrain {

LeastTime least_time(const profiler::Totals& totals, std::uint32_t warp_width, const Machine& machine) {
  const SfuCost cost = sfu_cost(totals, warp_width, machine);
  const double clocks_a_second = machine.multiprocessors.value * machine.clock.value;
  return {cost.issue_cycles / clocks_a_second, cost.cycles / clocks_a_second};
}

}  // namespace warpgrain
