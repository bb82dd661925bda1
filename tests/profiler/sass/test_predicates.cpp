#include <gtest/gtest.h>

#include "profiler/sass/predicated_lanes.hpp"
#include "profiler/sass/predicates.hpp"
#include "tests/profiler/sass/replayed_kernel.hpp"

namespace warpgrain::profiler::sass {
namespace {

Instruction plain() { return {}; }

Instruction under(std::uint8_t guard, bool negated = false) {
  Instruction i;
  i.guard = guard;
  i.guard_negated = negated;
  return i;
}

Instruction writing(std::uint8_t predicate, int constant = -1) {
  Instruction i;
  i.predicates_written = static_cast<std::uint8_t>(1U << predicate);
  i.constant_predicate = static_cast<std::int8_t>(constant);
  return i;
}

// Blocks of so many instructions each; each goes on with the next one, the last ends.
CodeGraph graph_of(const std::vector<std::vector<Instruction>>& blocks) {
  CodeGraph code;
  for (const auto& of_block : blocks) {
    CodeBlock block;
    block.first = static_cast<std::uint32_t>(code.instructions.size());
    code.instructions.insert(code.instructions.end(), of_block.begin(), of_block.end());
    block.last = static_cast<std::uint32_t>(code.instructions.size());
    block.next = static_cast<std::uint32_t>(code.blocks.size() + 1);
    code.blocks.push_back(block);
  }
  code.blocks.back().end = End::exit;
  code.blocks.back().next = no_code;
  return code;
}

void make_branch(CodeGraph& code, std::uint32_t block, std::uint32_t target) {
  code.blocks[block].end = End::guard;
  code.blocks[block].guarded = Flow::branch;
  code.blocks[block].target = target;
}

TEST(Predicates, AreThoseOfTheGuardBehindThem) {
  CodeGraph code =
      graph_of({{writing(0), under(0), under(0, true), under(1), under(0, true)}, {}, {plain()}});
  make_branch(code, 0, 2);
  const auto rules = find_predicates(code);
  EXPECT_EQ(rules[0], PredicateRule::on);
  EXPECT_EQ(rules[1], PredicateRule::not_taken);
  EXPECT_EQ(rules[2], PredicateRule::taken);
  EXPECT_EQ(rules[3], PredicateRule::unknown);
  EXPECT_EQ(rules[4], PredicateRule::taken) << "the guard itself";
}

TEST(Predicates, AreLostWhereSomethingWritesThem) {
  CodeGraph code = graph_of({{under(0), writing(0), under(0)}, {plain()}, {plain()}});
  make_branch(code, 0, 2);
  EXPECT_EQ(find_predicates(code)[0], PredicateRule::unknown);
}

TEST(Predicates, AreTheSameForAllLanesBehindAGuard) {
  CodeGraph code = graph_of({{under(3)}, {under(3), writing(3), under(3)}, {under(3), under(3, true)}});
  code.blocks[1].end = End::exit;
  make_branch(code, 0, 2);
  const auto rules = find_predicates(code);
  EXPECT_EQ(rules[1], PredicateRule::off);
  EXPECT_EQ(rules[3], PredicateRule::unknown);
  EXPECT_EQ(rules[4], PredicateRule::on);
  EXPECT_EQ(rules[5], PredicateRule::off);
}

TEST(Predicates, OfTwoWaysThatDifferAreNotKnown) {
  CodeGraph code = graph_of({{under(2)}, {plain()}, {under(2)}});
  make_branch(code, 0, 2);
  EXPECT_EQ(find_predicates(code)[2], PredicateRule::unknown);
}

TEST(Predicates, MayBeConstants) {
  const auto rules = find_predicates(graph_of({{writing(0, 1), under(0), writing(0, 0), under(0), plain()}}));
  EXPECT_EQ(rules[1], PredicateRule::on);
  EXPECT_EQ(rules[3], PredicateRule::off);
}

class PredicatedLanesTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!find_ptxas()) GTEST_SKIP() << no_ptxas;
    for (int k = 0; k < 32; ++k) in_.push_back(k);
    out_.assign(4096, 1.5F);
  }

  // Lanes with a true predicate of all stores, and what had to be assumed.
  std::pair<std::uint64_t, std::uint64_t> stores(const std::string& body) {
    const ReplayedKernel r(
        "kernel void k(global const int* restrict in, global float* restrict out) {\n"
        "  const int i = get_global_id(0);\n  const int v = in[i];\n" +
            body + "}\n",
        "k", line_of(32, 32), {buffer_of(in_), buffer_of(out_)});
    r.expect_complete();
    const PredicatedLanes lanes = count_predicated(r.kernel(), r.replay(), r.of_ptx());
    std::uint64_t on = 0;
    for (std::size_t k = 0; k < lanes.on.size(); ++k)
      if (r.kernel().code.instructions[k].instruction_class == InstructionClass::global_store)
        on += lanes.on[k];
    return {on, lanes.assumed};
  }

  std::vector<int> in_;
  std::vector<float> out_;
};

TEST_F(PredicatedLanesTest, AStoreUnderAPredicateIsThatOfItsBlock) {
  const auto [on, assumed] = stores("if (v % 4 == 1) out[i] = 7;\nout[i + 64] = 1;\n");
  EXPECT_EQ(on, 8U + 32U);
  EXPECT_EQ(assumed, 0U);
}

TEST_F(PredicatedLanesTest, LanesThatReturnAreNotOn) {
  const auto [on, assumed] = stores("if (v < 5) return;\nout[i] = 7;\n");
  EXPECT_EQ(on, 27U);
  EXPECT_EQ(assumed, 0U);
}

TEST_F(PredicatedLanesTest, ScalingOfDenormalsIsAssumedToBeOff) {
  const auto [on, assumed] = stores("out[i] = native_sqrt(out[i]);\n");
  EXPECT_EQ(on, 32U);
  EXPECT_EQ(assumed % 32, 0U);
  EXPECT_GT(assumed, 0U);
}

}  // namespace
}  // namespace warpgrain::profiler::sass
