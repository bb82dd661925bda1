#include "profiler/sass/replay_counters.hpp"

#include <numeric>

namespace warpgrain::profiler::sass {
namespace {

void add_to(std::vector<std::uint64_t>& sums, const std::vector<std::uint64_t>& values) {
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += values[k];
}

}  // namespace

ReplayCounters::ReplayCounters(const CodeGraph& code, const ReplayPlan& plan, const KernelGraph& graph)
    : block_executions(code.blocks.size() * (replayed_warp_width + 1)),
      issued_again(code.blocks.size() * (replayed_warp_width + 1)),
      divergent(code.blocks.size()),
      taken_lanes(code.blocks.size()),
      lane_slots_lost(graph.blocks.size() + 1),
      underived(plan.nodes.size()),
      requests(plan.memory.streams.size()) {}

void ReplayCounters::add(const ReplayCounters& other) {
  warps += other.warps;
  add_to(block_executions, other.block_executions);
  add_to(issued_again, other.issued_again);
  add_to(divergent, other.divergent);
  add_to(taken_lanes, other.taken_lanes);
  add_to(lane_slots_lost, other.lane_slots_lost);
  add_to(underived, other.underived);
  out_of_step += other.out_of_step;
  stuck += other.stuck;
  requests.add(other.requests);
  turns_assumed += other.turns_assumed;
  trips_assumed += other.trips_assumed;
  fast_paths += other.fast_paths;
}

std::uint64_t ReplayCounters::unresolved() const {
  return std::accumulate(underived.begin(), underived.end(), out_of_step + stuck);
}

}  // namespace warpgrain::profiler::sass
