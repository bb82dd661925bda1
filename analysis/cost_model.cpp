#include "analysis/cost_model.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace warpgrain {
namespace {

constexpr double sector_bytes = 32;
// Registers are given to warps in pieces of this many for each lane; a work-group takes this much shared
// memory beside its own (CUDA C++ Programming Guide, compute capabilities 8.x and 9.0).
constexpr std::uint64_t register_piece = 8;
constexpr double reserved_shared_bytes = 1024;

double number(std::uint64_t count) { return static_cast<double>(count); }

double power_sum(std::initializer_list<double> parts, double exponent) {
  double sum = 0;
  for (double part : parts) sum += std::pow(part, exponent);
  return std::pow(sum, 1 / exponent);
}

struct StoredSectors {
  double full, part;
};

// A request that stores `useful` bytes of its sectors: sectors that are stored in part are taken to be half
// stored, or less.
StoredSectors stored_sectors(const profiler::MemoryCounters& store) {
  const double sectors = number(store.sectors);
  const double part = std::clamp(2 * (sectors - number(store.useful_bytes) / sector_bytes), 0.0, sectors);
  return {sectors - part, part};
}

}  // namespace

double resident_warps(const profiler::LaunchCounters& launch, const CostConstants& cost,
                      double multiprocessors) {
  const double warps_a_group =
      std::ceil(static_cast<double>(launch.shape.work_group_size()) / launch.warp_width);
  double warps = cost.warps.value;
  if (const std::uint64_t registers = launch.weights.registers; registers != 0) {
    const std::uint64_t given = (registers + register_piece - 1) / register_piece * register_piece;
    warps = std::min(warps, std::floor(cost.registers.value / (number(given) * launch.warp_width)));
  }
  double groups = std::min(cost.work_groups.value, std::floor(warps / warps_a_group));
  if (launch.shared_bytes != 0)
    groups = std::min(
        groups, std::floor(cost.shared_bytes.value / (number(launch.shared_bytes) + reserved_shared_bytes)));
  const double at_most = std::max(1.0, groups) * warps_a_group;
  return std::min(at_most, std::max(1.0, number(launch.warps) / multiprocessors));
}

std::optional<PredictedTime> predict_time(const profiler::LaunchCounters& launch, const Machine& machine,
                                          double working_set, LaunchPlace place) {
  if (!machine.cost || !launch.footprint) return std::nullopt;
  const CostConstants& cost = *machine.cost;
  const profiler::Totals& totals = launch.totals;
  const profiler::FootprintCounters& footprint = *launch.footprint;
  const double multiprocessors = machine.multiprocessors.value;
  const double miss = working_set > 0 ? std::max(0.0, 1 - cost.cached_bytes.value / working_set) : 0;
  const StoredSectors stored = stored_sectors(totals.global_store);
  const double loads = number(totals.global_load.requests), group_load = number(footprint.group_load_sectors);

  PredictedTime time;
  time.resident_warps = resident_warps(launch, cost, multiprocessors);
  const double issue = number(totals.warp_instructions) / machine.issue_rate.value;
  const double sfu = number(totals.sfu_instructions) * launch.warp_width / machine.sfu_lanes.value;
  const double lines = cost.line.value * number(totals.global_load.lines + totals.global_store.lines);
  const double part_share =
      totals.global_store.sectors == 0 ? 0 : stored.part / number(totals.global_store.sectors);
  const double memory =
      cost.far_sector.value * group_load + cost.memory_sector.value * miss * number(footprint.load_sectors) +
      cost.store_sector.value * (1 + miss) * stored.full + cost.part_store_sector.value * stored.part +
      cost.memory_part_sector.value * miss * number(footprint.store_sectors) * part_share +
      cost.atomic_sector.value * number(totals.atomic.sectors);
  const double shared = number(totals.shared_load.requests + totals.shared_store.requests);
  const double latency =
      (cost.instruction.value * number(totals.warp_instructions) + cost.load.value * (loads + shared) +
       cost.far_load.value * std::min(loads, group_load)) /
      time.resident_warps;

  const double clocks_a_second = multiprocessors * machine.clock.value;
  const double groups = number(launch.shape.group_count()[0]) * number(launch.shape.group_count()[1]) *
                        number(launch.shape.group_count()[2]);
  time.issue = issue / clocks_a_second;
  time.sfu = sfu / clocks_a_second;
  time.lines = lines / clocks_a_second;
  time.memory = memory / clocks_a_second;
  time.latency = latency / clocks_a_second;
  time.start = (place == LaunchPlace::alone ? cost.launch.value : cost.next_launch.value) +
               cost.group_start.value * groups / clocks_a_second;
  time.seconds = time.start +
                 power_sum({time.issue, time.sfu, time.lines, time.memory, time.latency}, cost.overlap.value);
  return time;
}

}  // namespace warpgrain
