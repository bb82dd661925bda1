#pragma once
// Runs the lanes of a work-group one after another, in turns where they wait for each other.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "profiler/lane_buffers.hpp"
#include "profiler/lane_scheduler.hpp"
#include "profiler/shared_memory.hpp"
#include "profiler/translated_kernel.hpp"

namespace warpgrain::profiler {

class GroupRunner final : public WorkGroupRunner {
 public:
  // A lane may record this many blocks and as many addresses. At a few blocks a pass of a loop that is
  // millions of passes; what needs more is taken for endless.
  static constexpr std::size_t max_recorded = std::size_t{1} << 24;

  // Shape and arguments have been checked.
  GroupRunner(const TranslatedKernel& kernel, const LaunchShape& shape,
              std::span<const KernelArgument> arguments);

  std::span<const LaneTrace> run(const std::array<std::uint64_t, 3>& group) override;
  std::string take_printed() override { return std::exchange(printed_, {}); }

 private:
  void lay_out_parameters(std::span<const KernelArgument> arguments);
  void place_lane(std::size_t lane);  // what is the same in every work-group
  void prepare_lane(std::size_t lane, const std::array<std::uint64_t, 3>& group);
  [[noreturn]] void refuse_status(const LaneContext& lane, const std::array<std::uint64_t, 3>& group) const;
  void release_long_traces();

  const TranslatedKernel& kernel_;
  LaunchShape shape_;
  std::vector<std::byte> parameters_;
  std::optional<SharedMemory> shared_;
  std::string printed_;
  std::vector<LaneContext> lanes_;
  std::vector<LaneTrace> traces_;
  std::optional<LaneBuffers> blocks_;
  std::optional<LaneBuffers> addresses_;
  std::optional<LaneScheduler> scheduler_;  // where lanes wait for each other
};

}  // namespace warpgrain::profiler
