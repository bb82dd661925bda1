#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "profiler/control_flow.hpp"
#include "tests/profiler/hand_made.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;

// Blocks that `root` reaches without passing `without`.
std::vector<bool> reached(const SuccessorLists& successors, std::uint32_t root, std::uint32_t without) {
  std::vector<bool> seen(successors.size());
  std::vector<std::uint32_t> open;
  if (root != without) open.push_back(root);
  while (!open.empty()) {
    const std::uint32_t block = open.back();
    open.pop_back();
    if (seen[block]) continue;
    seen[block] = true;
    for (std::uint32_t to : successors[block])
      if (to != without) open.push_back(to);
  }
  return seen;
}

SuccessorLists random_graph(std::mt19937_64& random) {
  SuccessorLists successors(2 + random() % 10);
  for (auto& to : successors)
    for (auto n = random() % 3; n > 0; --n)
      to.push_back(static_cast<std::uint32_t>(random() % successors.size()));
  return successors;
}

TEST(ControlFlow, DominatorsAreThoseWithoutWhichABlockIsNotReached) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const SuccessorLists successors = random_graph(random);
    const auto dominator = immediate_dominators(successors, 0);
    const auto from_root = reached(successors, 0, no_block);
    for (std::uint32_t block = 1; block < successors.size(); ++block) {
      if (!from_root[block]) {
        EXPECT_EQ(dominator[block], no_block);
        continue;
      }
      // The strict dominators are exactly the chain of immediate ones.
      std::vector<bool> expected(successors.size()), chain(successors.size());
      for (std::uint32_t d = 0; d < successors.size(); ++d)
        expected[d] = d != block && from_root[d] && !reached(successors, 0, d)[block];
      for (std::uint32_t d = block; d != 0;) chain[d = dominator[d]] = true;
      EXPECT_EQ(chain, expected) << "block " << block;
    }
  }
}

TEST(ControlFlow, PostDominatorsAreDominatorsFromTheEnd) {
  // 0 -> 1 | 2; 1 -> 3; 2 -> 3 | 4 (returns); 3 -> 5 (returns)
  const ControlFlow flow(hand_made_graph({{1, 2}, {3}, {3, 4}, {5}, {}, {}}));
  EXPECT_THAT(flow.immediate_post_dominators(no_loop),
              ElementsAre(no_block, 3, no_block, 5, no_block, no_block));
}

TEST(ControlFlow, FindsNestedLoops) {
  // 0 -> 1 (outer header) -> 2 (inner header) -> 3 -> 2 | 4; 4 -> 1 | 5
  const ControlFlow flow(hand_made_graph({{1}, {2}, {3}, {2, 4}, {1, 5}, {}}));
  ASSERT_EQ(flow.loops().size(), 2U);
  EXPECT_EQ(flow.loops()[0].header, 1U);
  EXPECT_EQ(flow.loops()[0].parent, no_loop);
  EXPECT_THAT(flow.loops()[0].blocks, ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(flow.loops()[1].header, 2U);
  EXPECT_EQ(flow.loops()[1].parent, 0U);
  EXPECT_THAT(flow.loops()[1].blocks, ElementsAre(2, 3));
  EXPECT_THAT(std::vector(flow.loop_of().begin(), flow.loop_of().end()),
              ElementsAre(no_loop, 0, 1, 1, 0, no_loop));
}

TEST(ControlFlow, LoopOfOneBlock) {
  const ControlFlow flow(hand_made_graph({{1}, {1, 2}, {}}));
  ASSERT_EQ(flow.loops().size(), 1U);
  EXPECT_THAT(flow.loops()[0].blocks, ElementsAre(1));
  EXPECT_THAT(flow.loop_contiguous_order(), ElementsAre(0, 1, 2));
}

TEST(ControlFlow, BlocksBehindALoopComeAfterAllOfIt) {
  // Plain reverse post-order puts 4, which is behind the loop, before 2: header 1 -> 2 | 3; 2 -> 1; 3 -> 4
  // | 1.
  const ControlFlow flow(hand_made_graph({{1}, {2, 3}, {1}, {4, 1}, {}}));
  EXPECT_THAT(flow.loop_contiguous_order(), ElementsAre(0, 1, 3, 2, 4));
}

TEST(ControlFlow, OrderOfRandomKernelsKeepsLoopsTogetherAndGoesForward) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    RandomKernel kernel(seed);
    const ControlFlow flow(kernel.graph());
    const auto order = flow.loop_contiguous_order();
    std::vector<std::uint32_t> rank(order.size(), no_block);
    for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    EXPECT_EQ(std::count(rank.begin(), rank.end(), no_block), 0) << "each block once";
    for (const Loop& loop : flow.loops()) {
      std::uint32_t last = 0;
      for (std::uint32_t block : loop.blocks) last = std::max(last, rank[block]);
      EXPECT_EQ(last - rank[loop.header] + 1, loop.blocks.size());
    }
    const auto from_entry = reached(flow.successors(), 0, no_block);
    for (std::uint32_t block = 0; block < order.size(); ++block)
      for (std::uint32_t to : flow.successors()[block]) {
        const auto is_back_edge = [&] {
          for (std::uint32_t l = flow.loop_of()[block]; l != no_loop; l = flow.loops()[l].parent)
            if (flow.loops()[l].header == to) return true;
          return false;
        };
        if (from_entry[block] && !is_back_edge()) {
          EXPECT_LT(rank[block], rank[to]);
        }
      }
  }
}

TEST(ControlFlow, IrreducibleAndUnreachableFlowIsCarried) {
  // The cycle 1 <-> 2 is entered at both; 4 is reached from nowhere.
  const ControlFlow flow(hand_made_graph({{1, 2}, {2, 3}, {1, 3}, {}, {3}}));
  EXPECT_TRUE(flow.loops().empty());
  const auto order = flow.loop_contiguous_order();
  EXPECT_THAT(order, testing::UnorderedElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(order.back(), 4U);
  EXPECT_THAT(flow.immediate_post_dominators(no_loop), ElementsAre(3, 3, 3, no_block, 3));
}

}  // namespace
}  // namespace warpgrain::profiler
