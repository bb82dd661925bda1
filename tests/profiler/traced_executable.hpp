#pragma once
// An executable whose work-groups leave the traces that a test gives, for launches without a compiler.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "profiler/executable.hpp"
#include "profiler/safety/launch_monitor.hpp"
#include "tests/profiler/hand_made.hpp"

namespace warpgrain::profiler {

class TracedExecutable : public Executable {
 public:
  // `groups` are the lanes of each work-group, in the order of launching; what they point to outlives this.
  TracedExecutable(KernelGraph graph, std::vector<std::vector<LaneTrace>> groups)
      : groups_(std::move(groups)) {
    kernel_.graph = std::move(graph);
  }

  const KernelGraph& graph() const override { return kernel_.graph; }
  std::span<const KernelParameter> parameters() const override { return {}; }
  std::unique_ptr<LaunchMonitor> monitor(const LaunchShape& shape, std::span<const KernelArgument> arguments,
                                         const RunLimits& limits) const override {
    return std::make_unique<LaunchMonitor>(kernel_, shape, arguments, limits);
  }
  std::unique_ptr<WorkGroupRunner> runner(LaunchMonitor&) const override {
    return std::make_unique<Runner>(groups_);
  }
  LaunchShape shape() const {
    const auto size = static_cast<std::uint32_t>(groups_.front().size());
    return {{groups_.size() * size, 1, 1}, {size, 1, 1}};
  }
  const std::vector<std::vector<LaneTrace>>& groups() const { return groups_; }

 private:
  class Runner : public WorkGroupRunner {
   public:
    explicit Runner(const std::vector<std::vector<LaneTrace>>& groups) : groups_(groups) {}
    std::span<const LaneTrace> run(const std::array<std::uint64_t, 3>& group) override {
      return groups_[group[0]];
    }
    std::string take_printed() override { return {}; }

   private:
    const std::vector<std::vector<LaneTrace>>& groups_;
  };

  TranslatedKernel kernel_;
  std::vector<std::vector<LaneTrace>> groups_;
};

}  // namespace warpgrain::profiler
