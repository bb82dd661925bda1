#pragma once
// Runs the lanes of a work-group one after another, in turns where they wait for each other.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "profiler/lane_buffers.hpp"
#include "profiler/lane_scheduler.hpp"
#include "profiler/safety/access_checker.hpp"
#include "profiler/safety/launch_monitor.hpp"
#include "profiler/shared_memory.hpp"
#include "profiler/translated_kernel.hpp"

namespace warpgrain::profiler {

class GroupRunner final : public WorkGroupRunner, private LaneEvents {
 public:
  // A lane may record this many blocks and as many addresses.
  static constexpr std::size_t max_recorded = std::size_t{1} << 24;
  // The lanes of a work-group together may leave as many bytes of each.
  static constexpr std::size_t max_trace_bytes = std::size_t{1} << 31;

  explicit GroupRunner(LaunchMonitor& monitor);

  std::span<const LaneTrace> run(const std::array<std::uint64_t, 3>& group) override;
  std::string take_printed() override { return std::exchange(printed_, {}); }

 private:
  void lay_out_parameters(std::span<const std::size_t> shared_offsets);
  // What is the same in every work-group of a local size.
  void place_lanes(const std::array<std::uint32_t, 3>& local_size);
  void place_lane(std::size_t lane);
  void prepare_lane(std::size_t lane, const std::array<std::uint64_t, 3>& group);
  void limit_traces(std::size_t lane);
  void run_lanes();
  void run_in_turns();
  void lane_ended(std::size_t lane) override;
  bool given_up() const override { return monitor_.given_up(); }
  void lanes_met(std::span<const std::size_t> lanes, bool of_warp) override;
  void lanes_stuck(std::size_t lane, const std::string& who) override;
  void release_long_traces();

  LaunchMonitor& monitor_;
  const TranslatedKernel& kernel_;
  LaunchShape shape_;
  std::array<std::uint32_t, 3> local_size_{};  // of the group that runs
  std::vector<std::byte> parameters_;
  std::optional<SharedMemory> shared_;
  std::string printed_;
  std::optional<AccessChecker> checker_;  // of a checked kernel
  std::vector<LaneContext> all_lanes_;    // of the largest group
  std::span<LaneContext> lanes_;          // of the one that runs, its first
  std::vector<LaneTrace> traces_;
  std::optional<LaneBuffers> blocks_;
  std::optional<LaneBuffers> addresses_;
  std::optional<LaneBuffers> local_;                  // one lane's, or every lane's where they run in turns
  std::optional<LaneScheduler> scheduler_;            // where lanes wait for each other
  std::uint64_t first_item_ = 0;                      // number of the group's first work-item in the launch
  std::size_t blocks_used_ = 0, addresses_used_ = 0;  // bytes that the group's lanes left
};

}  // namespace warpgrain::profiler
