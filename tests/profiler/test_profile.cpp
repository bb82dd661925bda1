#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>

#include "core/error.hpp"
#include "profiler/profile.hpp"
#include "profiler/safety/launch_monitor.hpp"
#include "tests/profiler/hand_made.hpp"

namespace warpgrain::profiler {
namespace {

// An executable whose lanes take paths of our choice: lane l of group g rounds (g + l) % 5 times through a
// loop.
class PretendedExecutable : public Executable {
 public:
  PretendedExecutable() : graph_(hand_made_graph({{1}, {1, 2}, {}}, {2, 3, 4})) {
    add_access(graph_, 1, InstructionClass::global_load, 4);
  }
  const KernelGraph& graph() const override { return graph_; }
  std::span<const KernelParameter> parameters() const override { return {}; }
  std::unique_ptr<LaunchMonitor> monitor(const LaunchShape& shape, std::span<const KernelArgument> arguments,
                                         const RunLimits& limits) const override {
    return std::make_unique<LaunchMonitor>(kernel_, shape, arguments, limits);
  }
  std::unique_ptr<WorkGroupRunner> runner(LaunchMonitor& monitor) const override {
    return std::make_unique<Runner>(graph_, monitor.shape(), failing_group, n_groups_run);
  }

  std::uint64_t failing_group = ~std::uint64_t{0};
  mutable std::atomic<std::uint64_t> n_groups_run = 0;

 private:
  class Runner : public WorkGroupRunner {
   public:
    Runner(const KernelGraph& graph, const LaunchShape& shape, std::uint64_t failing_group,
           std::atomic<std::uint64_t>& n_groups_run)
        : graph_(graph), shape_(shape), failing_group_(failing_group), n_groups_run_(n_groups_run) {}
    std::span<const LaneTrace> run(const std::array<std::uint64_t, 3>& group) override {
      const auto count = shape_.group_count();
      const std::uint64_t number = group[0] + count[0] * (group[1] + count[1] * group[2]);
      if (number == failing_group_) throw InputError("group fails");
      ++n_groups_run_;
      traces_ = {};
      for (std::uint32_t lane = 0; lane < shape_.work_group_size(); ++lane) {
        std::vector<std::uint32_t> path{0};
        path.resize(2 + (number + lane) % 5, 1);
        const std::vector<std::uint64_t> addresses(path.size(), 4096 + 64 * lane);
        path.push_back(2);
        traces_.add_lane(graph_, path, addresses);
      }
      lanes_ = traces_.lanes();
      return lanes_;
    }
    std::string take_printed() override { return {}; }

   private:
    const KernelGraph& graph_;
    LaunchShape shape_;
    std::uint64_t failing_group_;
    std::atomic<std::uint64_t>& n_groups_run_;
    HandMadeTraces traces_;
    std::vector<LaneTrace> lanes_;
  };

  KernelGraph graph_;
  TranslatedKernel kernel_;  // of no instruction, for the monitor
};

const LaunchShape two_warps_a_group{{40, 30, 2},
                                    {8, 5, 1}};  // 60 work-groups of 40: a full warp of 32 and one of 8

TEST(Profile, CountsEveryWarpOfEveryGroup) {
  const PretendedExecutable executable;
  const LaunchCounters counters = profile_launch(executable, two_warps_a_group, {}, "", {});
  EXPECT_EQ(executable.n_groups_run, 60U);
  EXPECT_EQ(counters.kernel, "hand_made");
  EXPECT_EQ(counters.policy, "loop_postdom");
  EXPECT_EQ(counters.warp_width, 32U);
  EXPECT_EQ(counters.warps, 120U);
  EXPECT_EQ(counters.totals.warp_instructions, 120U * (2 + 5 * 3 + 4));
  // Every five groups each lane makes 1 + 2 + 3 + 4 + 5 rounds.
  EXPECT_EQ(counters.totals.thread_instructions, 60U * 40 * (2 + 4) + 12U * 40 * 15 * 3);
  EXPECT_EQ(counters.lane_slots_never_used, 60U * 24 * (2 + 5 * 3 + 4));
  std::uint64_t lost = counters.lane_slots_never_used;
  for (const BranchTotals& branch : counters.branches) lost += branch.lane_slots_lost;
  EXPECT_EQ(lost, 32 * counters.totals.warp_instructions - counters.totals.thread_instructions);
  EXPECT_EQ(
      std::accumulate(counters.totals.lane_histogram.begin(), counters.totals.lane_histogram.end(), 0ULL),
      counters.totals.warp_instructions);
}

TEST(Profile, ThreadsAndObserversDoNotChangeTheCounters) {
  const PretendedExecutable executable;
  WarpObserver nobody;
  for (const MergePolicy policy : {MergePolicy::loop_postdom, MergePolicy::ipdom, MergePolicy::min_pc}) {
    const auto counted = [&](unsigned threads, WarpObserver* observer) {
      return profile_launch(executable, two_warps_a_group, {}, "",
                            {.policy = policy, .warp_width = 16, .threads = threads, .observer = observer});
    };
    const LaunchCounters one = counted(1, nullptr);
    for (const LaunchCounters& other : {counted(3, nullptr), counted(0, nullptr), counted(2, &nobody)}) {
      EXPECT_EQ(one.totals, other.totals);
      EXPECT_EQ(one.warps, other.warps);
      EXPECT_EQ(one.lane_slots_never_used, other.lane_slots_never_used);
      ASSERT_EQ(one.branches.size(), other.branches.size());
      EXPECT_EQ(one.branches[0].lane_slots_lost, other.branches[0].lane_slots_lost);
    }
  }
}

TEST(Profile, ProgressEndsAtOne) {
  const PretendedExecutable executable;
  std::vector<double> seen;
  ProfileOptions options{.threads = 1, .progress = [&](double fraction) { seen.push_back(fraction); }};
  profile_launch(executable, two_warps_a_group, {}, "", options);
  ASSERT_FALSE(seen.empty());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(Profile, AFailingGroupEndsTheLaunchWithItsError) {
  PretendedExecutable executable;
  executable.failing_group = 17;
  for (const unsigned threads : {1U, 3U})
    EXPECT_THROW(profile_launch(executable, two_warps_a_group, {}, "", {.threads = threads}), InputError);
}

TEST(Profile, RefusesShapesAndWidthsThatCannotBe) {
  const PretendedExecutable executable;
  const auto message = [&](const LaunchShape& bad, std::uint32_t width) {
    try {
      profile_launch(executable, bad, {}, "", {.warp_width = width});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message({{0, 1, 1}, {1, 1, 1}}, 32), testing::HasSubstr("dimension 0"));
  EXPECT_THAT(message(two_warps_a_group, 24), testing::HasSubstr("power of two from 4 to 64"));
  EXPECT_THAT(message(two_warps_a_group, 128), testing::HasSubstr("128"));
}

}  // namespace
}  // namespace warpgrain::profiler
