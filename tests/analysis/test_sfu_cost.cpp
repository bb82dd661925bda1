#include <gtest/gtest.h>

#include "analysis/sfu_cost.hpp"

namespace warpgrain {
namespace {

profiler::Totals totals(std::uint64_t warp_instructions, std::uint64_t sfu_instructions) {
  profiler::Totals t;
  t.warp_instructions = warp_instructions;
  t.sfu_instructions = sfu_instructions;
  return t;
}

TEST(SfuCost, OnTheC2050AnInstructionCostsEightTimesAnother) {
  const SfuCost cost = sfu_cost(totals(100, 10), 32, load_machine("fermi_c2050"));
  EXPECT_EQ(cost.serialisation, 8);
  EXPECT_EQ(cost.cycles, 80);
  EXPECT_EQ(cost.issue_cycles, 100);
  EXPECT_EQ(cost.share(), 0.8);
}

TEST(SfuCost, LaterMachines) {
  EXPECT_EQ(sfu_cost({}, 32, load_machine("turing_t4")).serialisation, 4);
  EXPECT_EQ(sfu_cost({}, 32, load_machine("ampere_a100")).serialisation, 4);
  const SfuCost cost = sfu_cost(totals(400, 10), 32, load_machine("hopper_h100"));
  EXPECT_EQ(cost.serialisation, 8);
  EXPECT_EQ(cost.cycles, 20);         // two an instruction
  EXPECT_EQ(cost.issue_cycles, 100);  // four instructions a cycle
  EXPECT_EQ(cost.share(), 0.2);
}

TEST(SfuCost, NarrowWarpsPassFaster) {
  EXPECT_EQ(sfu_cost(totals(100, 10), 8, load_machine("fermi_c2050")).cycles, 20);
}

TEST(SfuCost, OfNothingIsNothing) { EXPECT_EQ(sfu_cost({}, 32, load_machine("fermi_c2050")).share(), 0); }

}  // namespace
}  // namespace warpgrain
