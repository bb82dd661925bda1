#include "profiler/counters.hpp"

#include <algorithm>

#include "profiler/coalescing.hpp"

namespace warpgrain::profiler {

namespace {

double ratio(std::uint64_t numerator, std::uint64_t denominator) {
  return denominator == 0 ? 0 : static_cast<double>(numerator) / static_cast<double>(denominator);
}

}  // namespace

double MemoryCounters::sectors_per_request() const { return ratio(sectors, requests); }

double MemoryCounters::lines_per_request() const { return ratio(lines, requests); }

double MemoryCounters::efficiency() const { return ratio(useful_bytes, sectors * sector_bytes); }

void MemoryCounters::add(const MemoryCounters& other) {
  requests += other.requests;
  sectors += other.sectors;
  lines += other.lines;
  useful_bytes += other.useful_bytes;
}

double Totals::active_lanes() const { return ratio(thread_instructions, warp_instructions); }

double Totals::simt_efficiency(std::uint32_t warp_width) const { return active_lanes() / warp_width; }

std::uint64_t Totals::lane_slots_idle(std::uint32_t warp_width) const {
  return warp_width * warp_instructions - thread_instructions;
}

std::uint64_t BlockTotals::lane_slots_idle() const {
  std::uint64_t idle = 0;
  for (std::size_t lanes = 0; lanes < lane_histogram.size(); ++lanes)
    idle += (lane_histogram.size() - 1 - lanes) * lane_histogram[lanes] * instructions;
  return idle;
}

void Totals::add(const Totals& other) {
  warp_instructions += other.warp_instructions;
  thread_instructions += other.thread_instructions;
  thread_instructions_pred_on += other.thread_instructions_pred_on;
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
