#include <cmath>
#include <gtest/gtest.h>

#include "analysis/cost_model.hpp"

namespace warpgrain {
namespace {

// A machine of round numbers: one multiprocessor of 1 GHz that issues one instruction a clock.
Machine round_machine() {
  Machine machine;
  machine.warp_width = {32, ""};
  machine.multiprocessors = {1, ""};
  machine.lanes = {32, ""};
  machine.sfu_lanes = {16, ""};
  machine.issue_rate = {1, ""};
  machine.clock = {1e9, ""};
  CostConstants& cost = machine.cost.emplace();
  for (const CostKey& key : cost_keys) cost.*key.value = {1, ""};
  cost.warps = {64, ""};
  cost.work_groups = {32, ""};
  cost.registers = {65536, ""};
  cost.shared_bytes = {100 * 1024, ""};
  cost.launch = {3e-6, ""};
  cost.next_launch = {2e-6, ""};
  cost.cached_bytes = {1e6, ""};
  return machine;
}

profiler::LaunchCounters launch_of(std::uint64_t groups, std::uint32_t group_size) {
  profiler::LaunchCounters launch;
  launch.shape = {{groups * group_size, 1, 1}, {group_size, 1, 1}};
  launch.warps = groups * ((group_size + 31) / 32);
  launch.footprint.emplace();
  return launch;
}

TEST(CostModel, NothingToDoTakesItsStart) {
  const auto alone = predict_time(launch_of(1000, 64), round_machine(), 0, LaunchPlace::alone);
  EXPECT_DOUBLE_EQ(alone->seconds, 3e-6 + 1000e-9);
  EXPECT_DOUBLE_EQ(alone->start, alone->seconds);
  EXPECT_DOUBLE_EQ(predict_time(launch_of(1000, 64), round_machine(), 0, LaunchPlace::next)->seconds,
                   2e-6 + 1000e-9);
}

TEST(CostModel, PartsAddUpOrOverlap) {
  Machine machine = round_machine();
  profiler::LaunchCounters launch = launch_of(1, 32);
  launch.totals.warp_instructions = 1000;
  launch.totals.sfu_instructions = 100;
  const auto sum = predict_time(launch, machine, 0, LaunchPlace::alone);
  EXPECT_DOUBLE_EQ(sum->issue, 1000e-9);
  EXPECT_DOUBLE_EQ(sum->sfu, 200e-9) << "16 units for 32 lanes";
  EXPECT_DOUBLE_EQ(sum->latency, 1000e-9) << "one warp, one clock an instruction";
  EXPECT_NEAR(sum->seconds - sum->start, 2200e-9, 1e-15);
  machine.cost->overlap.value = 2;
  const auto overlapped = predict_time(launch, machine, 0, LaunchPlace::alone);
  EXPECT_NEAR(overlapped->seconds - overlapped->start, std::sqrt(2.04) * 1e-6, 1e-15);
}

TEST(CostModel, MemoryIsWhatCachesDoNotServe) {
  Machine machine = round_machine();
  profiler::LaunchCounters launch = launch_of(1, 32);
  launch.footprint->group_load_sectors = 300;
  launch.footprint->load_sectors = 100;
  const auto in_cache = predict_time(launch, machine, 1e6, LaunchPlace::alone);
  EXPECT_DOUBLE_EQ(in_cache->memory, 300e-9);
  const auto beyond = predict_time(launch, machine, 2e6, LaunchPlace::alone);
  EXPECT_DOUBLE_EQ(beyond->memory, 300e-9 + 0.5 * 100e-9) << "half of what is used in turn is lost";
}

TEST(CostModel, StoresInPartCostMore) {
  Machine machine = round_machine();
  machine.cost->part_store_sector.value = 10;
  profiler::LaunchCounters launch = launch_of(1, 32);
  launch.totals.global_store = {.requests = 4, .sectors = 16, .lines = 0, .useful_bytes = 16 * 32};
  EXPECT_DOUBLE_EQ(predict_time(launch, machine, 0, LaunchPlace::alone)->memory, 16e-9);
  launch.totals.global_store.useful_bytes = 16 * 16;  // half of each sector
  EXPECT_DOUBLE_EQ(predict_time(launch, machine, 0, LaunchPlace::alone)->memory, 160e-9);
}

TEST(CostModel, WarpsThatAreResident) {
  const Machine machine = round_machine();
  const auto resident = [&](const profiler::LaunchCounters& launch) {
    return resident_warps(launch, *machine.cost, machine.multiprocessors.value);
  };
  EXPECT_EQ(resident(launch_of(1000, 128)), 64) << "as many as a multiprocessor holds";
  EXPECT_EQ(resident(launch_of(3, 64)), 6) << "as many as there are";
  EXPECT_EQ(resident(launch_of(1000, 32)), 32) << "as many as work-groups";
  profiler::LaunchCounters launch = launch_of(1000, 128);
  launch.weights.registers = 65;
  EXPECT_EQ(resident(launch), 28) << "72 registers a lane: 28 warps, 7 work-groups of 4";
  launch.shared_bytes = 19 * 1024;
  EXPECT_EQ(resident(launch), 20) << "5 work-groups of 20 KiB";
  launch.shared_bytes = 1 << 20;
  EXPECT_EQ(resident(launch), 4) << "one work-group, or nothing would run";
}

TEST(CostModel, SaysNothingWithoutConstantsOrFootprint) {
  Machine machine = round_machine();
  profiler::LaunchCounters launch = launch_of(1, 32);
  launch.footprint.reset();
  EXPECT_FALSE(predict_time(launch, machine, 0, LaunchPlace::alone));
  launch.footprint.emplace();
  machine.cost.reset();
  EXPECT_FALSE(predict_time(launch, machine, 0, LaunchPlace::alone));
}

}  // namespace
}  // namespace warpgrain
