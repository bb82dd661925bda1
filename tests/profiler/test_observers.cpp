// What the observers make of the sums over warps: totals, lines, blocks, branches.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/merge.hpp"
#include "profiler/observers/blocks.hpp"
#include "profiler/observers/branches.hpp"
#include "profiler/observers/lines.hpp"
#include "profiler/observers/totals.hpp"
#include "tests/profiler/hand_made.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;

// Eight lanes, of which three take an if; block b stands on line b + 1.
class Observers : public testing::Test {
 protected:
  Observers() : graph_(hand_made_graph({{2, 1}, {2}, {}}, {3, 4, 2})) {
    graph_.files = {"b.cl", "a.cl"};
    graph_.blocks[1].instructions[2] = {
        InstructionClass::special_function, 2, {1, 7}, "rcp.approx.f32 %f1, %f2;"};
    graph_.blocks[2].instructions[1] = {InstructionClass::exit, 0, {0, 0}, "ret;"};
    add_access(graph_, 1, InstructionClass::generic_load, 4);
    add_access(graph_, 1, InstructionClass::atomic, 4);
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
      if (lane < 3) {
        traces_.add_lane(graph_, {0, 1, 2}, {64 + 4 * lane, 1024});
      } else {
        traces_.add_lane(graph_, {0, 2}, {0});
      }
    }
    counters_ = std::make_unique<WarpCounters>(graph_, 8);
    make_counting_merger(graph_, MergePolicy::loop_postdom, *counters_)->merge(traces_.lanes());
  }

  KernelGraph graph_;
  HandMadeTraces traces_;
  std::unique_ptr<WarpCounters> counters_;
};

TEST_F(Observers, Totals) {
  const Totals totals = launch_totals(graph_, *counters_);
  EXPECT_EQ(totals.warp_instructions, 3U + 4 + 2);
  EXPECT_EQ(totals.thread_instructions, 8U * 3 + 3 * 4 + 8 * 2);
  EXPECT_THAT(totals.lane_histogram, ElementsAre(0, 0, 0, 4, 0, 0, 0, 0, 5));
  EXPECT_EQ(totals.branches, 1U);
  EXPECT_EQ(totals.divergent_branches, 1U);
  EXPECT_EQ(totals.sfu_instructions, 2U);
  const auto mix = [&](InstructionClass c) { return totals.instruction_mix[static_cast<std::size_t>(c)]; };
  EXPECT_EQ(mix(InstructionClass::special_function), (InstructionCount{1, 3}));
  EXPECT_EQ(mix(InstructionClass::branch), (InstructionCount{1, 8}));
  EXPECT_EQ(mix(InstructionClass::exit), (InstructionCount{1, 8}));
  EXPECT_EQ(mix(InstructionClass::integer), (InstructionCount{6, 2 * 8 + 3 * 3 + 8}));
  EXPECT_EQ(totals.global_load, (MemoryCounters{1, 1, 1, 12}));
  EXPECT_EQ(totals.atomic, (MemoryCounters{1, 1, 1, 12}));
  EXPECT_EQ(totals.active_lanes(), 52.0 / 9);
  EXPECT_EQ(totals.simt_efficiency(8), 52.0 / 9 / 8);
  EXPECT_EQ(Totals().simt_efficiency(8), 0);
}

TEST_F(Observers, LinesAreSortedAndSumUpToTheTotals) {
  const std::vector<LineTotals> lines = line_totals(graph_, *counters_);
  std::vector<std::pair<std::string, std::uint32_t>> places;
  Totals sum = empty_totals(8);
  for (const LineTotals& line : lines) {
    places.emplace_back(line.file, line.line);
    sum.add(line.totals);
  }
  using Place = std::pair<std::string, std::uint32_t>;
  EXPECT_THAT(places, ElementsAre(Place{"", 0}, Place{"a.cl", 7}, Place{"b.cl", 1}, Place{"b.cl", 2},
                                  Place{"b.cl", 3}));
  EXPECT_EQ(sum, launch_totals(graph_, *counters_));
  EXPECT_EQ(lines[1].totals.sfu_instructions, 2U);
  EXPECT_EQ(lines[2].totals.branches, 1U);
  EXPECT_EQ(lines[3].totals.global_load.requests, 1U);
}

TEST_F(Observers, Blocks) {
  const std::vector<BlockTotals> blocks = block_totals(graph_, *counters_);
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(blocks[1].label, "B1");
  EXPECT_EQ(blocks[1].executions, 1U);
  EXPECT_THAT(blocks[1].lane_histogram, ElementsAre(0, 0, 0, 1, 0, 0, 0, 0, 0));
}

TEST_F(Observers, Branches) {
  const std::vector<BranchTotals> branches =
      branch_totals(graph_, *counters_, SourceLines("if (x)  // branch: x"));
  ASSERT_EQ(branches.size(), 1U);
  EXPECT_EQ(branches[0].file, "b.cl");
  EXPECT_EQ(branches[0].line, 1U);
  EXPECT_EQ(branches[0].label, "x");
  EXPECT_EQ(branches[0].executions, 1U);
  EXPECT_EQ(branches[0].divergent, 1U);
  EXPECT_EQ(branches[0].lanes, 8U);
  EXPECT_EQ(branches[0].taken_lanes, 5U);
  EXPECT_EQ(branches[0].lane_slots_lost, 5U * 4);
  EXPECT_EQ(branch_totals(graph_, *counters_, SourceLines(""))[0].label, "@%p1 bra $L;");
}

}  // namespace
}  // namespace warpgrain::profiler
