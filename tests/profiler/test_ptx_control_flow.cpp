#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/ptx/control_flow.hpp"
#include "profiler/ptx/inline_calls.hpp"
#include "profiler/ptx/parser.hpp"
#include "tests/profiler/ptx_text.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Block> blocks_of(const std::string& body) {
  const Module module =
      parse(ptx_module(".entry k() { .reg .pred %p<2>; .reg .b32 %r<2>;\n" + body + "}"), "k.ptx");
  return cut_blocks(*module.find_entry("k"), "k.ptx");
}

TEST(PtxControlFlow, CutsAtBranchesAndTheirTargets) {
  const auto blocks = blocks_of(R"(
  mov.u32 %r0, 1;
$debug_label:
  mov.u32 %r1, 1;
$loop:
  add.u32 %r0, %r0, 1;
  @%p0 bra $out;
  add.u32 %r0, %r0, 2;
  @!%p1 bra $loop;
  bra.uni $out;
$out:
  ret;)");
  ASSERT_EQ(blocks.size(), 5u);
  EXPECT_EQ(blocks[0].label, "entry");
  EXPECT_EQ(blocks[0].last, 2u);
  EXPECT_EQ(blocks[1].label, "$loop");
  EXPECT_EQ(blocks[2].label, "$loop.1");
  EXPECT_THAT(blocks[0].successors, ElementsAre(1));
  EXPECT_THAT(blocks[1].successors, ElementsAre(4, 2));  // taken, then fall-through
  EXPECT_THAT(blocks[2].successors, ElementsAre(1, 3));
  EXPECT_THAT(blocks[3].successors, ElementsAre(4));
  EXPECT_THAT(blocks[4].successors, IsEmpty());
  std::vector<bool> recorded, headers;
  for (const Block& block : blocks) recorded.push_back(block.recorded), headers.push_back(block.loop_header);
  EXPECT_THAT(recorded, ElementsAre(true, true, true, true, true));
  EXPECT_THAT(headers, ElementsAre(false, true, false, false, false));
}

TEST(PtxControlFlow, OnlyBlocksBehindADecisionAreRecorded) {
  const auto blocks =
      blocks_of("@%p0 bra $a;\n bra $b;\n$a: mov.u32 %r0, 1;\n$b: mov.u32 %r0, 2; bra $c;\n$c: ret;");
  std::vector<bool> recorded;
  for (const Block& block : blocks) recorded.push_back(block.recorded);
  EXPECT_THAT(recorded, ElementsAre(true, true, true, false, false));
}

TEST(PtxControlFlow, APredicatedExitGetsAnEndOfItsOwn) {
  const auto blocks = blocks_of("@%p0 ret;\n mov.u32 %r0, 1;\n @%p1 exit;");
  ASSERT_EQ(blocks.size(), 4u);
  EXPECT_THAT(blocks[0].successors, ElementsAre(1, 2));
  EXPECT_EQ(blocks[1].label, "entry.end");
  EXPECT_EQ(blocks[1].first, blocks[1].last);
  EXPECT_THAT(blocks[1].successors, IsEmpty());
}

TEST(PtxControlFlow, TablesListEachTargetOnce) {
  const auto blocks = blocks_of("$t: .branchtargets $a, $b, $a;\n brx.idx %r0, $t;\n$a: ret;\n$b: ret;");
  EXPECT_THAT(blocks[0].successors, ElementsAre(1, 2));
}

TEST(PtxControlFlow, RefusesMissingLabels) {
  EXPECT_EQ(refusal([] { blocks_of("bra $nowhere;"); }),
            "k.ptx, PTX line 5: label '$nowhere'; expected a label of the function");
  EXPECT_THAT(refusal([] { blocks_of("brx.idx %r0, $t;"); }), HasSubstr("the label of a .branchtargets"));
}

TEST(PtxControlFlow, TableBranchesRun) {
  const auto executable = Executable::compile(ptx_module(R"(.entry k(.param .u64 .ptr .global p) {
    .reg .b32 %r<3>; .reg .b64 %d<3>;
    ld.param.u64 %d0, [p]; mov.u32 %r0, %tid.x; mul.wide.u32 %d1, %r0, 4; add.s64 %d0, %d0, %d1;
    $t: .branchtargets $a, $b, $a;
    brx.idx %r0, $t;
    $a: st.global.u32 [%d0], 5; ret;
    $b: st.global.u32 [%d0], 6; ret; })"),
                                              "k", TraceMode::blocks, "k.ptx");
  std::vector<int> out(3);
  run_launch(*executable, line_of(3, 3), {buffer_of(out)});
  EXPECT_THAT(out, ElementsAre(5, 6, 5));
}

}  // namespace
}  // namespace warpgrain::profiler::ptx
