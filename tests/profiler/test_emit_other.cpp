#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/profiler/warp_bench.hpp"

namespace warpgrain::profiler {
namespace {

using testing::Each;
using testing::HasSubstr;

// Bits: shared, local, param, const, global, of an address in each of the spaces.
TEST(EmitOther, TheSpaceOfAGenericAddress) {
  const std::string text = ptx_module(R"(
.const .align 4 .u32 table[2] = {1, 2};
.global .align 4 .u32 counter;
.entry k(.param .u64 out) {
  .local .align 4 .b8 stack[8]; .shared .align 4 .b8 tile[16];
  .reg .pred %p<2>; .reg .b32 %r<4>; .reg .b64 %d<4>;
  ld.param.u64 %d0, [out];
  mov.u64 %d1, tile; cvta.shared.u64 %d1, %d1; bra ASK0;
  ASK0: )" + [] {
    std::string ask;
    const char* const addresses[] = {"mov.u64 %d1, tile; cvta.shared.u64 %d1, %d1; add.u64 %d1, %d1, 15;",
                                     "mov.u64 %d1, stack; cvta.local.u64 %d1, %d1; add.u64 %d1, %d1, 4;",
                                     "mov.u64 %d1, out; cvta.param.u64 %d1, %d1;",
                                     "mov.u64 %d1, table; cvta.const.u64 %d1, %d1; add.u64 %d1, %d1, 7;",
                                     "mov.u64 %d1, counter; cvta.global.u64 %d1, %d1;",
                                     "mov.u64 %d1, %d0;"};
    int place = 0;
    for (const char* address : addresses) {
      ask += address;
      ask += "mov.u32 %r0, 0;\n";
      int bit = 1;
      for (const char* space : {"shared", "local", "param", "const", "global"}) {
        ask += fmt::format("isspacep.{} %p0, %d1; selp.u32 %r1, {}, 0, %p0; or.b32 %r0, %r0, %r1;\n", space,
                           bit);
        bit *= 2;
      }
      ask += fmt::format("st.global.u32 [%d0+{}], %r0;\n", place);
      place += 4;
    }
    return ask;
  }() + "ret; }");
  const auto executable = Executable::compile(text, "k", TraceMode::none, "k.ptx");
  std::vector<std::uint32_t> out(6);
  run_launch(*executable, line_of(1, 1), {buffer_of(out)});
  // Constants are reached through global memory's window, too.
  EXPECT_THAT(out, testing::ElementsAre(1, 2, 4, 24, 16, 16));
}

TEST(EmitOther, ClocksGoOnAndWaitingEnds) {
  EXPECT_THAT(run_warp_snippet(R"(
    mov.u32 %r1, %clock; mov.u32 %r2, %clock; setp.gt.u32 %p0, %r2, %r1;
    mov.u64 %d1, %clock64; WAIT: mov.u64 %d2, %globaltimer; nanosleep.u32 20; sub.u64 %d3, %d2, %d1;
    setp.lt.u64 %p1, %d3, 10000; @%p1 bra WAIT;
    mov.u32 %r3, %smid; mov.u32 %r4, %nsmid; add.u32 %r3, %r3, %r4; pmevent 7;
    selp.u32 %r9, %r3, 0, %p0;)"),
              Each(1u));
}

TEST(EmitOther, RefusesFamiliesByName) {
  const auto refused = [](const std::string& code) { return refused_warp_snippet(code); };
  EXPECT_THAT(
      refused("tex.2d.v4.f32.s32 {%r1, %r2, %r3, %r4}, [image, {%r5, %r6}];"),
      HasSubstr("k.ptx, PTX line 8: instruction 'tex.2d.v4.f32.s32 {%r1, %r2, %r3, %r4}, [image, {%r5, "
                "%r6}];' is not carried; expected a kernel without textures"));
  EXPECT_THAT(refused("sust.b.2d.b32.trap [image, {%r1, %r2}], {%r3};"), HasSubstr("without surfaces"));
  EXPECT_THAT(refused("mma.sync.aligned.m8n8k4.row.col.f32.f16.f16.f32 {%r1}, {%r2}, {%r3}, {%r4};"),
              HasSubstr("without matrix instructions"));
  EXPECT_THAT(refused("wmma.load.a.sync.aligned.row.m16n16k16.f16 {%r1}, [%d1], %r2;"),
              HasSubstr("without matrix instructions"));
  EXPECT_THAT(refused("cp.async.ca.shared.global [%r1], [%d1], 16;"),
              HasSubstr("without asynchronous copies"));
  EXPECT_THAT(refused("mbarrier.init.shared.b64 [%r1], 32;"), HasSubstr("without mbarrier objects"));
  EXPECT_THAT(refused("tcgen05.wait::ld.sync.aligned;"), HasSubstr("without matrix instructions"));
  EXPECT_THAT(refused("vadd.u32.u32.u32 %r1, %r2, %r3;"), HasSubstr("without video instructions"));
  EXPECT_THAT(refused("mapa.u64 %d1, %d2, %r1;"), HasSubstr("without thread-block clusters"));
  EXPECT_THAT(refused("add.rn.bf16x2 %r1, %r2, %r3;"), HasSubstr("a type other than '.bf16x2'"));
  EXPECT_THAT(refused("cvt.rn.bf16.f32 %r1, %r2;"), HasSubstr("a type other than '.bf16'"));
  EXPECT_THAT(refused("atom.global.exch.b128 %r1, [%d1], %r2;"), HasSubstr("a type other than '.b128'"));
  EXPECT_THAT(refused("mov.u32 %r1, %pm0;"), HasSubstr("'%pm0' in 'mov.u32 %r1, %pm0;'"));
}

TEST(EmitOther, RefusesOperandsThatAnInstructionDoesNotHave) {
  EXPECT_THAT(refused_warp_snippet("min.u32 %r1, %r2, %r3, %r4;"), HasSubstr("expected 3 operands"));
  EXPECT_EQ(refused_warp_snippet("ld.param.u64 %d0, [out]; ld.global.L2::cache_hint.u32 %r1, [%d0], %d1;"),
            "");
}

}  // namespace
}  // namespace warpgrain::profiler
