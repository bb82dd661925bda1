#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/profiler/ptx_text.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using u32 = std::uint32_t;

constexpr std::string_view calls = R"(
.func (.param .b32 result) twice(.param .b32 x) {
  .reg .b32 %r<3>; .reg .pred %p<1>;
  ld.param.u32 %r0, [x];
  setp.gt.u32 %p0, %r0, 100;
  @%p0 bra $big;
  add.u32 %r1, %r0, %r0; st.param.b32 [result+0], %r1; ret;
$big:
  st.param.b32 [result+0], 0; ret;
}
.func (.param .b32 result) fourfold(.param .b32 x) {
  .reg .b32 %r<3>;
  ld.param.u32 %r0, [x];
  { .param .b32 p0; .param .b32 r0; st.param.b32 [p0+0], %r0; call.uni (r0), twice, (p0); ld.param.b32 %r1, [r0+0]; }
  { .param .b32 p0; .param .b32 r0; st.param.b32 [p0+0], %r1; call.uni (r0), twice, (p0); ld.param.b32 %r1, [r0+0]; }
  st.param.b32 [result+0], %r1; ret;
}
.func endless(.param .b32 x) {
  { .param .b32 p0; st.param.b32 [p0+0], 1; call.uni endless, (p0); }
  ret;
}
.extern .func outside();
.entry k(.param .u64 .ptr .global p) {
  .reg .b32 %r<3>; .reg .b64 %d<3>;
  ld.param.u64 %d0, [p]; mov.u32 %r0, %tid.x; mul.wide.u32 %d1, %r0, 4; add.s64 %d0, %d0, %d1;
  ld.global.u32 %r1, [%d0];
  { .param .b32 p0; .param .b32 r0; st.param.b32 [p0+0], %r1; call.uni (r0), fourfold, (p0); ld.param.b32 %r2, [r0+0]; }
  st.global.u32 [%d0], %r2; ret;
}
.entry recursive() { { .param .b32 p0; st.param.b32 [p0+0], 1; call.uni endless, (p0); } ret; }
.entry unlinked() { call.uni outside; ret; }
)";

TEST(InlineCalls, FunctionsRunInPlace) {
  const auto executable =
      Executable::compile(ptx_module(calls), "k", TraceMode::blocks_and_addresses, "c.ptx");
  std::vector<int> memory{1, 7, 60, 200};
  run_launch(*executable, line_of(4, 4), {buffer_of(memory)});
  EXPECT_THAT(memory, ElementsAre(4, 28, 0, 0));
  std::size_t n_calls = 0;
  for (const BasicBlock& block : executable->graph().blocks)
    for (const auto& instruction : block.instructions) n_calls += instruction.text.starts_with("call");
  EXPECT_EQ(n_calls, 3u);
}

TEST(InlineCalls, RefusesWhatCannotBePutInPlace) {
  const auto refused = [](std::string_view kernel) {
    return refusal([&] { Executable::compile(ptx_module(calls), kernel, TraceMode::none, "c.ptx"); });
  };
  EXPECT_THAT(refused("recursive"), HasSubstr("function 'endless' calls itself"));
  EXPECT_THAT(refused("unlinked"), HasSubstr("call of 'outside', which has no body here"));
}

// Functions of one number; `pick` calls one of two through a table.
const std::string functions = R"(
.func (.param .b32 result) twice(.param .b32 x) {
  .reg .b32 %r<2>; ld.param.u32 %r0, [x]; shl.b32 %r1, %r0, 1; st.param.b32 [result], %r1; ret; }
.func (.param .b32 result) square(.param .b32 x) {
  .reg .b32 %r<2>; ld.param.u32 %r0, [x]; mul.lo.u32 %r1, %r0, %r0; st.param.b32 [result], %r1; ret; }
.func (.param .b32 result) other(.param .b64 x) { st.param.b32 [result], 0; ret; }
.func (.param .b32 result) itself(.param .b32 x) {
  .reg .b32 %r<2>; .reg .b64 %d<1>; mov.u64 %d0, itself; ld.param.u32 %r0, [x];
  { .param .b32 a; .param .b32 b; st.param.b32 [a], %r0; call (b), %d0, (a), type; ld.param.b32 %r1, [b]; }
  type: .callprototype (.param .b32 _) _ (.param .b32 _);
  st.param.b32 [result], %r1; ret; }
.global .align 8 .u64 table[3] = {twice, square, other};
)";

std::string kernel(const std::string& call) {
  return ptx_module(functions + R"(.entry k(.param .u64 out) {
  .reg .pred %p<2>; .reg .b32 %r<4>; .reg .b64 %d<4>; .param .b32 a; .param .b32 b;
  ld.param.u64 %d0, [out]; mov.u32 %r0, %tid.x; mul.wide.u32 %d1, %r0, 4; add.u64 %d0, %d0, %d1;
  st.param.b32 [a], %r0; st.param.b32 [b], 77; and.b32 %r1, %r0, 1; setp.eq.u32 %p0, %r1, 0;
  mul.wide.u32 %d1, %r1, 8; mov.u64 %d2, table; add.u64 %d2, %d2, %d1; ld.global.u64 %d3, [%d2];
)" + call + R"(
  ld.param.b32 %r2, [b]; st.global.u32 [%d0], %r2; ret;
  type: .callprototype (.param .b32 _) _ (.param .b32 _);
  few: .calltargets twice;
})");
}

std::vector<u32> run(const std::string& call) {
  const auto executable = Executable::compile(kernel(call), "k", TraceMode::blocks, "k.ptx");
  std::vector<u32> out(4);
  run_launch(*executable, line_of(4, 4), {buffer_of(out)});
  return out;
}

TEST(InlineCalls, OfAFunctionByName) { EXPECT_THAT(run("call (b), square, (a);"), ElementsAre(0, 1, 4, 9)); }

TEST(InlineCalls, WithAPredicateIsABranch) {
  EXPECT_THAT(run("@%p0 call (b), twice, (a);"), ElementsAre(0, 77, 4, 77));
  EXPECT_THAT(run("@!%p0 call.uni (b), twice, (a);"), ElementsAre(77, 2, 77, 6));
  const auto executable =
      Executable::compile(kernel("@%p0 call (b), twice, (a);"), "k", TraceMode::blocks, "k.ptx");
  const BasicBlock& entry = executable->graph().blocks[0];
  EXPECT_EQ(entry.instructions.back().text, "@%p0 call (b), twice, (a);");
  EXPECT_EQ(entry.instructions.back().instruction_class, InstructionClass::branch);
  EXPECT_EQ(entry.successors.size(), 2u);
}

TEST(InlineCalls, ThroughAPointerBranchesToWhatFits) {
  EXPECT_THAT(run("call (b), %d3, (a), type;"), ElementsAre(0, 1, 4, 9));
  const auto executable =
      Executable::compile(kernel("call (b), %d3, (a), type;"), "k", TraceMode::blocks, "k.ptx");
  const BasicBlock& entry = executable->graph().blocks[0];
  EXPECT_EQ(entry.instructions.back().text, "call (b), %d3, (a), type;");
  // twice, square and itself, not `other`, whose parameter is of 8 bytes
  EXPECT_EQ(entry.successors.size(), 3u);
}

TEST(InlineCalls, ThroughAPointerToNoFunctionStops) {
  EXPECT_THAT(
      refusal([] { run("call (b), %d3, (a), few;"); }),
      HasSubstr(
          "PTX line 21: invalid_call: it called through a pointer to no function that fits the call and is "
          "not running, work-item (1, 0, 0)"));
  EXPECT_THAT(refusal([] { run("mov.u64 %d3, 0; call (b), %d3, (a), type;"); }), HasSubstr("to no function"));
  EXPECT_THAT(refusal([] { run("mov.u64 %d3, itself; call (b), %d3, (a), type;"); }),
              HasSubstr("to no function that fits the call and is not running"));
}

TEST(InlineCalls, RefusesWhatItCannotPlace) {
  EXPECT_THAT(refusal([] { run("call (b), gone, (a);"); }),
              HasSubstr("call of 'gone', which has no body here"));
  EXPECT_THAT(refusal([] { run("call (b), other, (a);"); }),
              HasSubstr("a .param variable for each parameter of the function"));
  EXPECT_THAT(refusal([] { run("@%p0 call (b), %d3, (a), type;"); }),
              HasSubstr("a call through a pointer without a predicate"));
  EXPECT_THAT(refusal([] { run("call %d3, (a), type;"); }), HasSubstr("whose parameters fit"));
}

TEST(InlineCalls, AFailedAssertionStops) {
  const auto executable =
      Executable::compile(ptx_module(".extern .func __assertfail(.param .b64 text);\n.entry k() { .reg .pred "
                                     "%p; .reg .b32 %r; .param .b64 "
                                     "a; mov.u32 %r, %tid.x; setp.ne.u32 %p, %r, 2; @%p bra FINE;\ncall "
                                     "__assertfail, (a);\nFINE: ret; }"),
                          "k", TraceMode::blocks, "k.ptx");
  run_launch(*executable, line_of(2, 2), {});
  EXPECT_THAT(refusal([&] { run_launch(*executable, line_of(3, 3), {}); }),
              HasSubstr("PTX line 6: trap: it ran the trap, work-item (2, 0, 0)"));
}

TEST(InlineCalls, AnAliasIsTheFunction) {
  const auto executable = Executable::compile(
      ptx_module(
          ".func (.param .b32 r) f() { st.param.b32 [r], 6; ret; }\n.func (.param .b32 r) g();\n.alias g, "
          "f;\n"
          ".entry k(.param .u64 out) { .reg .b64 %d; .reg .b32 %r; .param .b32 a; ld.param.u64 %d, [out];"
          "call (a), g; ld.param.b32 %r, [a]; st.global.u32 [%d], %r; ret; }"),
      "k", TraceMode::none, "k.ptx");
  std::vector<u32> out(1);
  run_launch(*executable, line_of(1, 1), {buffer_of(out)});
  EXPECT_EQ(out[0], 6u);
}

TEST(InlineCalls, TablesOfLabelsWithAPredicate) {
  const auto executable = Executable::compile(ptx_module(R"(.entry k(.param .u64 out) {
  .reg .pred %p<2>; .reg .b32 %r<4>; .reg .b64 %d<2>;
  ld.param.u64 %d0, [out]; mov.u32 %r0, %tid.x; mul.wide.u32 %d1, %r0, 4; add.u64 %d0, %d0, %d1;
  setp.lt.u32 %p0, %r0, 3; mov.u32 %r1, 50;
  ways: .branchtargets A, B, A;
  @%p0 brx.idx %r0, ways;
  add.u32 %r1, %r1, 1;
  A: add.u32 %r1, %r1, 10;
  B: st.global.u32 [%d0], %r1; ret; })"),
                                              "k", TraceMode::blocks, "k.ptx");
  std::vector<u32> out(5);
  run_launch(*executable, line_of(5, 5), {buffer_of(out)});
  EXPECT_THAT(out, ElementsAre(60, 50, 60, 61, 61));
}

}  // namespace
}  // namespace warpgrain::profiler
