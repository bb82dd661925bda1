#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>

#include "tests/profiler/ptx_text.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Runs one kernel named k, whose one parameter is a buffer, with `lanes` work-items in one work-group.
template <class T>
void run_ptx(const std::string& text, std::vector<T>& memory, std::uint32_t lanes = 1) {
  const auto executable =
      Executable::compile(ptx_module(text), "k", TraceMode::blocks_and_addresses, "k.ptx");
  run_launch(*executable, line_of(lanes, lanes), {buffer_of(memory)});
}

TEST(EmitMemory, LoadsExtendByTheirType) {
  std::vector<std::uint32_t> memory{0x8081ff7f, 0, 0, 0, 0, 0};
  run_ptx(R"(.entry k(.param .u64 .ptr .global p) {
    .reg .b64 %d<2>; .reg .b32 %r<8>; .reg .b16 %h<2>;
    ld.param.u64 %d0, [p];
    ld.global.u8 %r0, [%d0+1]; st.global.u32 [%d0+4], %r0;
    ld.global.s8 %r0, [%d0+1]; st.global.u32 [%d0+8], %r0;
    ld.global.u16 %r0, [%d0+2]; st.global.u32 [%d0+12], %r0;
    ld.global.s16 %r0, [%d0+2]; st.global.u32 [%d0+16], %r0;
    ld.global.b8 %h0, [%d0+3]; st.global.b16 [%d0+20], %h0;
    mov.u64 %d1, 0x1122334455667788; st.global.u8 [%d0+23], %d1;
    ret; })",
          memory);
  EXPECT_THAT(memory, ElementsAre(0x8081ff7f, 0xff, 0xffffffff, 0x8081, 0xffff8081, 0x88000080));
}

TEST(EmitMemory, VectorsAndNegativeOffsets) {
  std::vector<float> memory{1, 2, 3, 4, 0, 0, 0, 0, 0, 0};
  run_ptx(R"(.entry k(.param .u64 .ptr .global p) {
    .reg .b64 %d<2>; .reg .f32 %f<4>;
    ld.param.u64 %d0, [p];
    add.s64 %d1, %d0, 32;
    ld.global.v4.f32 {%f0, %f1, %f2, %f3}, [%d0];
    st.global.v2.f32 [%d1+-16], {%f3, %f2};
    ld.global.nc.L1::no_allocate.v2.f32 {%f0, _}, [%d1-28];
    st.volatile.global.f32 [%d1], %f0;
    ret; })",
          memory);
  EXPECT_THAT(memory, ElementsAre(1, 2, 3, 4, 4, 3, 0, 0, 2, 0));
}

TEST(EmitMemory, EverySpaceByNameAndByAddress) {
  std::vector<std::uint64_t> memory(8);
  run_ptx(R"(
.const .align 4 .u32 table[3] = {10, 20, 0x1E};
.global .align 8 .u64 counter = 7;
.global .u64 places[2] = {generic(table)+8, counter};
.shared .align 8 .b8 scratch[16];
.entry k(.param .u64 .ptr .global p) {
    .local .align 8 .b8 stack[16];
    .shared .u32 own;
    .reg .b64 %d<4>; .reg .b32 %r<4>;
    ld.param.u64 %d0, [p];
    ld.const.u32 %r0, [table+4]; st.global.u32 [%d0], %r0;
    ld.global.u64 %d1, [counter]; st.global.u64 [%d0+8], %d1;
    mov.u64 %d1, stack; cvta.local.u64 %d2, %d1; st.u32 [%d2+4], 40; ld.local.u32 %r0, [stack+4]; st.global.u32 [%d0+16], %r0;
    st.shared.u32 [scratch+12], 50; mov.u64 %d1, scratch; ld.shared.u32 %r0, [%d1+12]; st.global.u32 [%d0+24], %r0;
    cvta.shared.u64 %d2, %d1; ld.u32 %r0, [%d2+12]; st.global.u32 [%d0+32], %r0;
    ld.shared.u32 %r0, [own]; st.global.u32 [%d0+40], %r0;
    ld.global.u64 %d1, [places]; ld.const.u32 %r0, [%d1]; st.global.u32 [%d0+48], %r0;
    ld.global.u64 %d1, [places+8]; ld.global.u64 %d2, [%d1]; st.global.u64 [%d0+56], %d2;
    ret; })",
          memory);
  EXPECT_THAT(memory, ElementsAre(20, 7, 40, 50, 50, 0, 30, 7));
}

TEST(EmitMemory, AtomicsReturnWhatWasThere) {
  std::vector<std::uint32_t> memory{5, 5, 5, 5, 5, 12, 10, 5, 3, 0, 0, 0};
  std::vector<std::uint32_t> old(9);
  const std::string text = ptx_module(R"(.entry k(.param .u64 .ptr .global p, .param .u64 .ptr .global q) {
    .reg .b64 %d<2>; .reg .b32 %r<9>; .reg .f32 %f<2>;
    ld.param.u64 %d0, [p]; ld.param.u64 %d1, [q];
    atom.global.add.u32 %r0, [%d0], -2; st.global.u32 [%d1], %r0;
    atom.relaxed.gpu.global.min.s32 %r1, [%d0+4], -1; st.global.u32 [%d1+4], %r1;
    atom.global.max.u32 %r2, [%d0+8], 9; st.global.u32 [%d1+8], %r2;
    atom.global.exch.b32 %r3, [%d0+12], 77; st.global.u32 [%d1+12], %r3;
    atom.global.cas.b32 %r4, [%d0+16], 5, 6; st.global.u32 [%d1+16], %r4;
    atom.global.and.b32 %r5, [%d0+20], 9; st.global.u32 [%d1+20], %r5;
    atom.or.b32 %r6, [%d0+24], 5; st.global.u32 [%d1+24], %r6;
    atom.global.inc.u32 %r7, [%d0+28], 5; st.global.u32 [%d1+28], %r7;
    atom.global.dec.u32 %r8, [%d0+32], 8; st.global.u32 [%d1+32], %r8;
    red.global.xor.b32 [%d0+36], 3;
    red.global.add.f32 [%d0+40], 0f3FC00000;
    membar.gl; fence.acq_rel.gpu;
    ret; })");
  const auto executable = Executable::compile(text, "k", TraceMode::blocks_and_addresses, "k.ptx");
  run_launch(*executable, line_of(1, 1), {buffer_of(memory), buffer_of(old)});
  EXPECT_THAT(memory, ElementsAre(3, 0xffffffff, 9, 77, 6, 8, 15, 0, 2, 3, 0x3FC00000, 0));
  EXPECT_THAT(old, ElementsAre(5, 5, 5, 5, 5, 12, 10, 5, 3));
}

TEST(EmitMemory, AtomicCountersOfAGroupInSharedMemory) {
  std::vector<std::uint32_t> memory(65);
  run_ptx(R"(.entry k(.param .u64 .ptr .global p) {
    .shared .u32 count; .reg .b64 %d<3>; .reg .b32 %r<3>;
    ld.param.u64 %d0, [p];
    atom.shared.add.u32 %r0, [count], 1;
    mul.wide.u32 %d1, %r0, 4; add.s64 %d1, %d1, %d0; st.global.u32 [%d1+4], 1;
    bar.sync 0;
    ld.shared.u32 %r1, [count]; st.global.u32 [%d0], %r1;
    ret; })",
          memory, 64);
  EXPECT_EQ(memory[0], 64u);
  EXPECT_EQ(std::accumulate(memory.begin() + 1, memory.end(), 0u), 64u);
}

// The trace has a place for each access, also for one that a predicate kept from happening.
TEST(EmitMemory, TracesAddressesInOrder) {
  std::vector<std::uint32_t> memory(64);
  const auto executable = Executable::compile(ptx_module(R"(.entry k(.param .u64 .ptr .global p) {
    .reg .pred %p<2>; .reg .b64 %d<3>; .reg .b32 %r<3>;
    ld.param.u64 %d0, [p];
    mov.u32 %r0, %tid.x; setp.eq.u32 %p0, %r0, 1;
    mul.wide.u32 %d1, %r0, 16; add.s64 %d1, %d1, %d0;
    @%p0 ld.global.v2.u32 {%r1, %r2}, [%d1+8];
    @!%p0 st.global.u32 [%d1], 9;
    red.global.add.u32 [%d0+128], 1;
    ret; })"),
                                              "k", TraceMode::blocks_and_addresses, "k.ptx");
  const auto& accesses = executable->graph().blocks[0].accesses;
  ASSERT_EQ(accesses.size(), 3u);
  EXPECT_EQ(accesses[0].access, InstructionClass::global_load);
  EXPECT_EQ(accesses[0].bytes, 8);
  EXPECT_EQ(executable->graph().blocks[0].instructions[accesses[1].instruction].text,
            "@!%p0 st.global.u32 [%d1], 9;");
  EXPECT_EQ(accesses[2].access, InstructionClass::atomic);
  const auto runner = executable->runner(line_of(2, 2), std::vector{buffer_of(memory)});
  const auto traces = runner->run({0, 0, 0});
  const auto base = reinterpret_cast<std::uint64_t>(memory.data());
  EXPECT_THAT(std::span(traces[0].addresses, 3), ElementsAre(no_address, base, base + 128));
  EXPECT_THAT(std::span(traces[1].addresses, 3), ElementsAre(base + 24, no_address, base + 128));
  EXPECT_EQ(memory[0], 9u);
  EXPECT_EQ(memory[4], 0u);
}

TEST(EmitMemory, RefusesWhatItDoesNotCarry) {
  const auto compile = [](const std::string& statement) {
    return refusal([&] {
      Executable::compile(
          ptx_module(".entry k() {\n.reg .b32 %r<4>; .reg .b64 %d<4>; .reg .f32 %f<4>; .reg .b16 %h<4>;\n" +
                     statement + "\nret; }"),
          "k", TraceMode::none, "k.ptx");
    });
  };
  EXPECT_EQ(compile("add.rn.f32 %f0, %f1, %f2;"), "");
  EXPECT_THAT(compile("shfl.sync.b32 %r0, %r1, 1, 31, -1;"),
              HasSubstr("k.ptx, PTX line 6: instruction 'shfl.sync.b32 %r0, %r1, 1, 31, -1;' is not carried; "
                        "expected .up, .down, .bfly or .idx"));
  EXPECT_THAT(compile("min.rz.f32 %f0, %f1, %f2;"), HasSubstr("without '.rz'"));
  EXPECT_THAT(compile("frobnicate.u32 %r0;"), HasSubstr("'frobnicate.u32 %r0;' is not carried"));
  EXPECT_THAT(compile("add.bf16 %h0, %h1, %h2;"), HasSubstr("'add.bf16 %h0, %h1, %h2;' is not carried"));
  EXPECT_THAT(compile("mov.u32 %r0;"), HasSubstr("more operands"));
  EXPECT_THAT(compile("add.u32 7, %r0, %r1;"), HasSubstr("a register to write"));
  EXPECT_THAT(compile("shl.f32 %f0, %f1, 2;"), HasSubstr("an integer type"));
  EXPECT_THAT(compile("sqrt.approx.u32 %r0, %r1;"), HasSubstr("a float type"));
  EXPECT_THAT(compile("ld.global.pred %r0, [%d0];"), HasSubstr("a number's type"));
  EXPECT_THAT(compile("prmt.b64 %d0, %d1, %d2, 0;"), HasSubstr("b32"));
  EXPECT_THAT(compile("atom.global.add.f16 %h0, [%d0], %h1;"), HasSubstr("is not carried"));
  EXPECT_THAT(compile("ld.global.v4.u32 {%r0, %r1}, [%d0];"), HasSubstr("a vector of that width"));
}

// .extern .shared: all such variables at one place, behind those of a fixed size.
TEST(EmitMemory, SharedMemoryOfTheLaunchsSize) {
  const auto executable = Executable::compile(ptx_module(R"(.extern .shared .align 4 .b8 dynamic[];
.extern .shared .align 8 .b8 same[];
.entry k(.param .u64 out) {
  .shared .align 4 .b8 own[20]; .reg .b32 %r<3>; .reg .b64 %d<2>;
  ld.param.u64 %d0, [out]; mov.u32 %r0, %tid.x; mul.wide.u32 %d1, %r0, 4; add.u64 %d0, %d0, %d1;
  st.shared.u32 [own+16], 5; st.shared.u32 [dynamic], 7; st.shared.u32 [dynamic+60], 8;
  ld.shared.u32 %r1, [own+16]; ld.shared.u32 %r2, [same]; mad.lo.u32 %r1, %r1, 10, %r2;
  ld.shared.u32 %r2, [same+60]; mad.lo.u32 %r1, %r1, 10, %r2; st.global.u32 [%d0], %r1; ret; })"),
                                              "k", TraceMode::none, "k.ptx");
  ASSERT_EQ(executable->parameters().size(), 2u);
  EXPECT_EQ(executable->parameters()[1].pointer, KernelParameter::Pointer::shared);
  std::vector<std::uint32_t> out(2);
  run_launch(*executable, line_of(2, 2), {buffer_of(out), KernelArgument::local(64)});
  EXPECT_THAT(out, ElementsAre(578, 578));
  EXPECT_THAT(refusal([&] { run_launch(*executable, line_of(2, 2), {buffer_of(out)}); }),
              HasSubstr("1 arguments; expected 2"));
}

}  // namespace
}  // namespace warpgrain::profiler
