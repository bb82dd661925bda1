#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

#include "core/error.hpp"
#include "random_bed.hpp"
#include "variants/combinations.hpp"
#include "variants/simt_device.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain {
namespace {

using profiler::LaunchProfile;

class StepProfile : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string lack = simulator_lacks(); !lack.empty()) GTEST_SKIP() << lack;
  }
  static std::vector<LaunchProfile> profile(const char* order, unsigned threads = 0) {
    Variant variant;
    variant.set("order", order);
    profiler::ProfileOptions options;
    options.threads = threads;
    return profile_step(random_bed({.n_particles = 2000}), variant, options);
  }
  static const LaunchProfile& force_launch(const std::vector<LaunchProfile>& launches) {
    return *std::ranges::find_if(launches, [](const LaunchProfile& launch) {
      return launch.counters.kernel == "force_between_particles";
    });
  }
};

TEST_F(StepProfile, ListsTheLaunchesOfTheFlowInOrder) {
  std::vector<std::string> kernels;
  for (const LaunchProfile& launch : profile("cell")) {
    kernels.push_back(launch.counters.kernel);
    const profiler::Totals& totals = launch.counters.totals;
    EXPECT_GE(totals.thread_instructions, totals.warp_instructions) << kernels.back();
    EXPECT_LE(totals.thread_instructions, totals.warp_instructions * launch.counters.warp_width)
        << kernels.back();
    EXPECT_GE(launch.counters.warps, 2000u / 64) << kernels.back();  // the sort: two keys a work-item
  }
  EXPECT_THAT(kernels, testing::ElementsAre("integrate", "map_particles", "sort_blocks", "merge_stride",
                                            "merge_blocks", "reorder_particles", "clear_cells", "find_cells",
                                            "force_between_particles", "force_from_walls"));
}

TEST_F(StepProfile, NamesTheBranchesOfTheSource) {
  const auto launches = profile("cell");
  std::vector<std::string> labels;
  for (const profiler::BranchTotals& branch : force_launch(launches).counters.branches) {
    if (branch.divergent > 0) labels.push_back(branch.file + ": " + branch.label);
  }
  EXPECT_THAT(labels, testing::IsSupersetOf(
                          {"kernels/search/cells.cl: contact test", "kernels/search/cells.cl: next candidate",
                           "kernels/contact_history.h: history found", "kernels/contact/branchy.cl: slip"}));
}

TEST_F(StepProfile, SortedParticlesTouchFewerSectors) {
  const auto sectors_per_load = [](const std::vector<LaunchProfile>& launches) {
    const profiler::MemoryCounters& loads = force_launch(launches).counters.totals.global_load;
    return static_cast<double>(loads.sectors) / static_cast<double>(loads.requests);
  };
  EXPECT_LT(1.3 * sectors_per_load(profile("cell")), sectors_per_load(profile("unsorted")));
}

TEST_F(StepProfile, DoesNotDependOnThreads) {
  const auto one = profile("cell", 1), three = profile("cell", 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].counters.totals.thread_instructions, three[k].counters.totals.thread_instructions);
    EXPECT_EQ(one[k].counters.totals.lane_histogram, three[k].counters.totals.lane_histogram);
    EXPECT_EQ(one[k].counters.totals.global_load.sectors, three[k].counters.totals.global_load.sectors);
  }
}

// Two operations in a contact, and two more in one that slips: the lines of the law and of the pair's
// geometry with special functions, as often as contacts came by.
TEST_F(StepProfile, SfuMinimisedNeedsTwoSpecialFunctionsAContact) {
  const auto special_functions = [](const char* law) {
    Variant variant;
    variant.set("contact", law);
    const auto launches = profile_step(random_bed({.n_particles = 2000}), variant, {});
    std::map<std::uint64_t, int> lines;  // by how often a warp came by
    for (const profiler::LineTotals& line : force_launch(launches).counters.lines) {
      const std::string& file = line.file;
      if (file.find("contact/") == std::string::npos && file.find("overlap.h") == std::string::npos &&
          file.find("pair.h") == std::string::npos && file.find("prelude.h") == std::string::npos)
        continue;
      if (line.totals.sfu_instructions > 0) ++lines[line.totals.sfu_instructions];
    }
    return lines;
  };
  const auto minimised = special_functions("sfu_minimised");
  ASSERT_EQ(minimised.size(), 2u);
  EXPECT_EQ(minimised.rbegin()->second, 2);  // every contact
  EXPECT_EQ(minimised.begin()->second, 2);   // those that slip
  int of_branchy = 0;
  for (const auto& [count, n_lines] : special_functions("branchy")) of_branchy += n_lines;
  EXPECT_GE(of_branchy, 8);
}

// All kernels, checked: accesses in bounds, no races, barriers that all reach.
TEST_F(StepProfile, NothingIsWrongWithTheKernels) {
  const Scene bed = random_bed({.n_particles = 300});
  for (const Variant& variant : one_value_at_a_time())
    for (const LaunchProfile& launch : profile_step(bed, variant, {})) {
      std::string found;
      for (const profiler::Diagnostic& d : launch.counters.diagnostics) found += diagnostic_text(d) + '\n';
      EXPECT_EQ(found, "") << variant.name() << ", " << launch.counters.kernel;
    }
}

// Two spheres on their way to each other, for which every step is like the one before.
TEST_F(StepProfile, SaysWhenListsAreMadeAnew) {
  const Scene scene = load_scene("head_on", {});
  for (const char* search : {"verlet", "cluster"}) {
    const Variant variant = Variant::parse(std::string("branchy/") + search + "/cell/fp64/default");
    ProfiledState left;
    const auto launches = profile_step(scene, variant, {}, {}, {}, &left);
    std::vector<std::string> kernels;
    for (const LaunchProfile& launch : left.list_launches) kernels.push_back(launch.counters.kernel);
    EXPECT_THAT(kernels,
                testing::Contains(std::string(search) == "verlet" ? "list_neighbours" : "list_groups"));
    EXPECT_THAT(kernels, testing::Contains("reorder_particles"));
    for (const LaunchProfile& launch : launches)
      EXPECT_THAT(kernels, testing::Not(testing::Contains(launch.counters.kernel))) << "of every step";

    // Steps until the lists are made a second time.
    const auto simulation = backend("opencl").create(scene, variant, {});
    const auto makings = [&] {
      std::uint64_t calls = 0;
      for (const KernelTiming& timing : simulation->timings())
        if (timing.kernel.starts_with("list_")) calls += timing.calls;
      return calls;
    };
    std::uint64_t steps = 1;
    simulation->step(1);
    EXPECT_EQ(makings(), 1U);
    for (; makings() == 1 && steps < 10000; ++steps) simulation->step(1);
    EXPECT_EQ(left.steps_between_lists, steps) << search;
  }
}

TEST_F(StepProfile, NoListsAreMadeAnewWhereNothingMovesOrNoneAreKept) {
  Scene still = load_scene("head_on", {});
  for (Vector3d& velocity : still.particles.velocity) velocity.setZero();
  ProfiledState left;
  profile_step(still, Variant::parse("branchy/verlet/cell/fp32/default"), {}, {}, {}, &left);
  EXPECT_TRUE(left.list_launches.empty());
  profile_step(load_scene("head_on", {}), Variant::parse("branchy/cells/cell/fp32/default"), {}, {}, {},
               &left);
  EXPECT_TRUE(left.list_launches.empty());
}

TEST_F(StepProfile, StopsWhereTheStepStops) {
  Scene bed = random_bed({.n_particles = 100});
  bed.particles.velocity[7] = {1e9, 0, 0};
  EXPECT_THROW(profile_step(bed, Variant(), {}), SimulationError);
}

}  // namespace
}  // namespace warpgrain
