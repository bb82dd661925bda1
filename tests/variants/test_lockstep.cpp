// Every kernel of the step in the simulator and in the independent lockstep interpreter
// (tests/profiler/oracle): the same counts under every policy, the same bytes in every array.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "covering_variants.hpp"
#include "random_bed.hpp"
#include "variants/combinations.hpp"
#include "variants/device_simulation.hpp"

#ifdef WARPGRAIN_HAS_SIMULATOR

#include "profiler/opencl_frontend.hpp"
#include "tests/profiler/oracle/comparison.hpp"
#include "variants/simulator_arrays.hpp"

namespace warpgrain {
namespace {

// Runs launches in both. The arrays go on as the simulator leaves them.
class ComparedDevice : public OverSimulatorArrays<ComputeDevice> {
 public:
  void build(const std::vector<SourceUnit>& units) override {
    for (const SourceUnit& unit : units)
      ptx_.push_back(profiler::compile_opencl(unit.text, "kernels", unit.build_options).ptx);
  }

  void launch(const KernelLaunch& launch) override {
    const auto found =
        oracle::differences(ptx_[launch.unit], launch.kernel, shape_of(launch), arguments_of(launch));
    EXPECT_TRUE(found.empty()) << launch.kernel << ":\n" << fmt::format("{}", fmt::join(found, "\n"));
  }

  void finish() override {}
  std::vector<KernelTiming> timings() const override { return {}; }
  std::string name() const override { return "simulator and interpreter"; }

 private:
  std::vector<std::string> ptx_;
};

class Lockstep : public testing::TestWithParam<Variant> {};

TEST_P(Lockstep, EveryKernelOfTheStepAgrees) {
  // The construction evaluates the forces of a bed with a random history.
  const Scene bed = random_bed({.n_particles = 150});
  DeviceSimulation(bed, GetParam(), {}, std::make_unique<ComparedDevice>()).step(1);
}

// Pairs of half shells take their places in the order in which lanes come, which is not the same in both.
std::vector<Variant> variants_without_order() {
  std::vector<Variant> variants = one_value_at_a_time();
  std::erase_if(variants, [](const Variant& v) { return v.value(AxisId::search) == "half_shell"; });
  return variants;
}

INSTANTIATE_TEST_SUITE_P(Variants, Lockstep, testing::ValuesIn(variants_without_order()),
                         [](const auto& parameter) { return test_name(parameter.param); });

}  // namespace
}  // namespace warpgrain

#endif
