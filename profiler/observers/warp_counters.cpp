#include "profiler/observers/warp_counters.hpp"

#include <array>
#include <bit>

#include "profiler/coalescing.hpp"
#include "profiler/control_flow.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {
namespace {

void add_each(std::vector<std::uint64_t>& to, const std::vector<std::uint64_t>& from) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
}

}  // namespace

WarpCounters::WarpCounters(const KernelGraph& graph, std::uint32_t width)
    : warp_width(width),
      block_executions(graph.blocks.size() * (width + 1)),
      divergent(graph.blocks.size()),
      taken_lanes(graph.blocks.size()),
      lane_slots_lost(graph.blocks.size() + 1) {
  std::size_t n_accesses = 0;
  for (const BasicBlock& block : graph.blocks) {
    first_access.push_back(static_cast<std::uint32_t>(n_accesses));
    n_accesses += block.accesses.size();
  }
  accesses.resize(n_accesses);
}

void WarpCounters::add(const WarpCounters& other) {
  warps += other.warps;
  issued.warp_instructions += other.issued.warp_instructions;
  issued.thread_instructions += other.issued.thread_instructions;
  add_each(block_executions, other.block_executions);
  add_each(divergent, other.divergent);
  add_each(taken_lanes, other.taken_lanes);
  add_each(lane_slots_lost, other.lane_slots_lost);
  for (std::size_t i = 0; i < accesses.size(); ++i) accesses[i].add(other.accesses[i]);
}

void count_request(MemoryCounters& counters, std::span<const std::uint64_t> addresses, std::uint32_t bytes) {
  if (addresses.empty() || bytes == 0) return;  // a recorded path is no access
  const RequestFootprint footprint =
      addresses.size() == 1 ? access_footprint(addresses[0], bytes) : request_footprint(addresses, bytes);
  ++counters.requests;
  counters.sectors += footprint.sectors;
  counters.lines += footprint.lines;
  counters.useful_bytes += addresses.size() * bytes;
}

void WarpCounterObserver::warp_begins(std::uint64_t) { ++counters_.warps; }

void WarpCounterObserver::block_issued(const LaneGroup& group,
                                       std::span<const std::uint64_t* const> addresses) {
  const auto n_lanes = static_cast<std::size_t>(std::popcount(group.lanes));
  ++counters_.executions(group.block)[n_lanes];
  counters_.issued.warp_instructions += graph_.blocks[group.block].instructions.size();
  counters_.issued.thread_instructions += graph_.blocks[group.block].instructions.size() * n_lanes;
  if (addresses.empty()) return;
  const auto& accesses = graph_.blocks[group.block].accesses;
  std::array<std::uint64_t, max_request_lanes> of_lanes;
  for (std::size_t k = 0; k < accesses.size(); ++k) {
    std::size_t n = 0;
    for (const std::uint64_t* of_lane : addresses)
      if (of_lane[k] != no_address) of_lanes[n++] = of_lane[k];
    count_request(counters_.accesses[counters_.first_access[group.block] + k], std::span(of_lanes).first(n),
                  accesses[k].bytes);
  }
}

void WarpCounterObserver::branch_executed(const LaneGroup& group, std::uint64_t taken,
                                          std::span<const LaneGroup> parts) {
  counters_.divergent[group.block] += parts.size() > 1 ? 1 : 0;
  counters_.taken_lanes[group.block] += static_cast<std::uint64_t>(std::popcount(taken));
}

void WarpCounterObserver::lanes_idled(const LaneGroup& group, std::uint32_t branch, std::uint64_t idle) {
  counters_.lane_slots_lost[branch == no_block ? counters_.never_used() : branch] +=
      graph_.blocks[group.block].instructions.size() * static_cast<std::uint64_t>(std::popcount(idle));
}

}  // namespace warpgrain::profiler
