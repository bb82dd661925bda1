#include "profiler/counters.hpp"

#include <algorithm>

namespace warpgrain::profiler {

void MemoryCounters::add(const MemoryCounters& other) {
  requests += other.requests;
  sectors += other.sectors;
  lines += other.lines;
  useful_bytes += other.useful_bytes;
}

double Totals::active_lanes() const {
  if (warp_instructions == 0) return 0;
  return static_cast<double>(thread_instructions) / static_cast<double>(warp_instructions);
}

double Totals::simt_efficiency(std::uint32_t warp_width) const { return active_lanes() / warp_width; }

void Totals::add(const Totals& other) {
  warp_instructions += other.warp_instructions;
  thread_instructions += other.thread_instructions;
  lane_histogram.resize(std::max(lane_histogram.size(), other.lane_histogram.size()));
  for (std::size_t i = 0; i < other.lane_histogram.size(); ++i) lane_histogram[i] += other.lane_histogram[i];
  branches += other.branches;
  divergent_branches += other.divergent_branches;
  sfu_instructions += other.sfu_instructions;
  for (std::size_t i = 0; i < n_instruction_classes; ++i) {
    instruction_mix[i].warp += other.instruction_mix[i].warp;
    instruction_mix[i].thread += other.instruction_mix[i].thread;
  }
  global_load.add(other.global_load);
  global_store.add(other.global_store);
  shared_load.add(other.shared_load);
  shared_store.add(other.shared_store);
  atomic.add(other.atomic);
}

}  // namespace warpgrain::profiler
