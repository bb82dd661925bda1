// Each kind of wrong access: what is said of it, and that the run goes on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

#include "tests/profiler/checked_launch.hpp"
#include "tests/profiler/ptx_text.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AccessChecker : public testing::Test {
 protected:
  std::vector<int> a_ = std::vector<int>(64, 7), b_ = std::vector<int>(64, 1);

  KernelArgument a() { return buffer_of(a_); }
  KernelArgument b() { return buffer_of(b_); }
};

TEST_F(AccessChecker, OutOfBoundsOfGlobalMemory) {
  const auto counters = run_checked(R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  a[i] = 2;
  if (i < 10) b[i] = a[i + 64];
  a[-1] = 3;
})",
                                    line_of(128, 32), {a(), b()});
  EXPECT_THAT(
      findings(counters),
      ElementsAre("kernel.cl:3: out_of_bounds: store of 4 bytes to global memory, 'a' at byte 256 of "
                  "256, work-item (64, 0, 0) in work-group (2, 0, 0); 64 times",
                  "kernel.cl:4: out_of_bounds: load of 4 bytes from global memory, 'a' at byte 256 of "
                  "256, work-item (0, 0, 0) in work-group (0, 0, 0); 10 times",
                  "kernel.cl:5: out_of_bounds: store of 4 bytes to global memory, 'a' at byte -4 of "
                  "256, work-item (0, 0, 0) in work-group (0, 0, 0); 128 times"));
  // Bad loads give 0, bad stores are dropped, the others happen.
  EXPECT_EQ(a_, std::vector<int>(64, 2));
  EXPECT_EQ(b_[9], 0);
  EXPECT_EQ(b_[10], 1);
}

// The address comes from `a`, wherever it leads.
TEST_F(AccessChecker, IntoAnotherBuffer) {
  std::vector<int> both(128);
  const auto memory = std::as_writable_bytes(std::span(both));
  const auto counters =
      run_checked("kernel void k(global int* a, global int* b) { a[70] = b[3]; }", line_of(1, 1),
                  {KernelArgument::buffer(memory.first(256)), KernelArgument::buffer(memory.last(256))});
  EXPECT_THAT(findings(counters), ElementsAre(HasSubstr("'a' at byte 280 of 256")));
  EXPECT_EQ(both, std::vector<int>(128));
}

TEST_F(AccessChecker, OutOfBoundsOfLocalAndPrivateMemory) {
  const auto counters = run_checked(R"(kernel void k(global int* a, local int* given) {
  local int own[4];
  int mine[8];
  int n = a[0];
  for (int i = 0; i < 8; ++i) mine[i] = a[i];
  own[n] = 1;
  given[n + 9] = 2;
  mine[n * 2] += 3;
  a[1] = mine[a[2] & 7];
  a[3] = own[0];
})",
                                    line_of(1, 1), {a(), KernelArgument::local(16)});
  EXPECT_THAT(
      findings(counters),
      ElementsAre(HasSubstr("kernel.cl:6: out_of_bounds: store of 4 bytes to shared memory, 'own' at "
                            "byte 28 of 16"),
                  HasSubstr("kernel.cl:7: out_of_bounds: store of 4 bytes to shared memory, 'given' at "
                            "byte 64 of 16"),
                  HasSubstr("kernel.cl:8: out_of_bounds: load of 4 bytes from local memory, 'private "
                            "variables' at byte 56 of 32"),
                  HasSubstr("kernel.cl:8: out_of_bounds: store of 4 bytes to local memory, 'private "
                            "variables' at byte 56 of 32"),
                  HasSubstr("kernel.cl:10: uninitialized_read: load of 4 bytes from shared memory")));
}

TEST_F(AccessChecker, OutOfBoundsOfConstants) {
  const auto counters = run_checked(R"(constant int table[4] = {1, 2, 3, 4};
kernel void k(global int* a, constant int* given) {
  int i = get_global_id(0);
  a[i] = table[i] + given[i * 2];
})",
                                    line_of(8, 8), {a(), b()});
  EXPECT_THAT(
      findings(counters),
      ElementsAre(HasSubstr("out_of_bounds: load of 4 bytes from constant memory, 'table' at byte 16 of "
                            "16, work-item (4, 0, 0) in work-group (0, 0, 0); 4 times")));
  EXPECT_EQ(a_[3], 5);
  EXPECT_EQ(a_[4], 1);
}

TEST_F(AccessChecker, NullPointers) {
  const auto counters = run_checked("kernel void k(global int* a, global int* b) { a[0] = b[5]; }",
                                    line_of(1, 1), {a(), KernelArgument::buffer({})});
  EXPECT_THAT(
      findings(counters),
      ElementsAre("kernel.cl:1: null_pointer: load of 4 bytes from global memory, 'b' at byte 0 of 0, "
                  "work-item (0, 0, 0) in work-group (0, 0, 0)"));
  EXPECT_EQ(a_[0], 0);
}

TEST_F(AccessChecker, MisalignedAccesses) {
  const auto counters = run_checked(R"(kernel void k(global char* a, global float4* b) {
  *(global int*)(a + 6) = 5;
  b[0] = *(global float4*)(a + 8);
})",
                                    line_of(1, 1), {a(), b()});
  EXPECT_THAT(
      findings(counters),
      ElementsAre(
          HasSubstr("kernel.cl:2: misaligned: store of 4 bytes to global memory, 'a' at byte 6 of 256"),
          HasSubstr("kernel.cl:3: misaligned: load of 16 bytes from global memory, 'a' at byte 8")));
}

TEST_F(AccessChecker, RightsOfBuffers) {
  KernelArgument read_only = a(), write_only = b();
  read_only.read_only = true;
  write_only.write_only = true;
  const auto counters = run_checked(R"(kernel void k(global int* a, global int* b) {
  a[0] = 3;
  b[1] = a[1];
  b[2] += 5;
  atomic_add(a + 3, 1);
})",
                                    line_of(1, 1), {read_only, write_only});
  EXPECT_THAT(
      findings(counters),
      ElementsAre(HasSubstr("kernel.cl:2: read_only_write: store of 4 bytes to global memory, 'a'"),
                  HasSubstr("kernel.cl:4: write_only_read: load of 4 bytes from global memory, 'b'"),
                  HasSubstr("kernel.cl:5: read_only_write: atomic of 4 bytes on global memory, 'a'")));
  EXPECT_EQ(a_, std::vector<int>(64, 7));
  EXPECT_EQ(b_[1], 7);
}

TEST_F(AccessChecker, UninitializedBytes) {
  KernelArgument fresh = a();
  fresh.uninitialized = true;
  const auto counters = run_checked(R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  if (i < 10) a[i] = i;
  b[i] = a[i];
})",
                                    line_of(16, 16), {fresh, b()});
  EXPECT_THAT(
      findings(counters),
      ElementsAre("kernel.cl:4: uninitialized_read: load of 4 bytes from global memory, 'a' at byte 40 of "
                  "256, work-item (10, 0, 0) in work-group (0, 0, 0); 6 times"));
}

TEST_F(AccessChecker, WildAddresses) {
  const auto executable = Executable::compile(ptx_module(R"(.entry k(.param .u64 out) {
.reg .b64 %d<3>; .reg .b32 %r<2>;
ld.param.u64 %d0, [out];
mov.u64 %d1, 0xdead0000beef0000;
ld.global.u32 %r0, [%d1];
st.u32 [0], %r0;
atom.global.add.u32 %r1, [%d1+8], 1;
st.shared.u32 [%d0], %r0;
add.s64 %d2, %d0, %d1;
st.global.v4.u32 [%d2], {%r0, %r0, %r0, %r0};
ret; })"),
                                              "k", TraceMode::blocks, "k.ptx", Checks::on);
  EXPECT_THAT(
      findings(run_checked(*executable, line_of(1, 1), {a()})),
      ElementsAre(HasSubstr("PTX line 8: out_of_bounds: load of 4 bytes from global memory, at an address "
                            "in no buffer"),
                  HasSubstr("PTX line 9: null_pointer: store of 4 bytes to generic memory"),
                  HasSubstr("PTX line 10: out_of_bounds: atomic of 4 bytes on global memory"),
                  HasSubstr("PTX line 11: out_of_bounds: store of 4 bytes to global memory, 'out'"),
                  HasSubstr("PTX line 13: out_of_bounds: store of 16 bytes")));
  EXPECT_EQ(a_, std::vector<int>(64, 7));
}

TEST_F(AccessChecker, DoesNotDependOnThreads) {
  const std::string source = R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  atomic_add(b + i % 64, a[i]);
})";
  std::vector<std::vector<std::string>> found;
  for (const unsigned threads : {1u, 4u})
    found.push_back(findings(run_checked(source, line_of(8192, 32), {a(), b()}, threads)));
  EXPECT_EQ(found[0], found[1]);
  EXPECT_THAT(found[0], ElementsAre(HasSubstr("work-item (64, 0, 0) in work-group (2, 0, 0); 8128 times")));
}

// Pointers that take different ways are followed as they run.
TEST_F(AccessChecker, PointersToSeveralBuffers) {
  const auto counters = run_checked(R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  global int* p = i & 1 ? a : b;
  p[i] = 3;
  local int own[16];
  int mine[2];
  mine[0] = i;
  own[i] = 1;
  a[32 + i] = mine[own[i] - 1];
})",
                                    line_of(16, 16), {a(), b()});
  EXPECT_THAT(findings(counters), IsEmpty());
  EXPECT_EQ(a_[1], 3);
  EXPECT_EQ(b_[2], 3);
  EXPECT_EQ(a_[37], 5);
}

// What printf is given is the kernel's, too.
TEST_F(AccessChecker, PrintsThroughWildPointers) {
  const auto executable = Executable::compile(ptx_module(R"(
.extern .func (.param .b32 done) vprintf(.param .b64 format, .param .b64 arguments);
.global .align 1 .b8 text[7] = {37, 115, 32, 37, 100, 33, 0};
.entry k() { .local .align 8 .b8 packed[8]; .reg .b64 %d<4>; .reg .b32 %r<1>;
.param .b64 p0; .param .b64 p1; .param .b32 back;
mov.u64 %d0, text; mov.u64 %d1, packed; mov.u64 %d2, 0x123456; st.local.u64 [packed], %d2;
st.param.b64 [p0+0], %d0; st.param.b64 [p1+0], %d1; call.uni (back), vprintf, (p0, p1);
st.param.b64 [p0+0], %d2; call.uni (back), vprintf, (p0, p1);
ret; })"),
                                              "k", TraceMode::blocks, "k.ptx", Checks::on);
  std::ostringstream printed;
  ProfileOptions options;
  options.printed = &printed;
  profile_launch(*executable, line_of(1, 1), {}, "", options);
  EXPECT_EQ(printed.str(), "(no text) %d!(no text)");
}

// Found by mutated PTX: constant loads of memory that is written, through a pointer that may be any.
TEST_F(AccessChecker, ConstantLoadsOfWrittenMemory) {
  const auto executable = Executable::compile(
      ptx_module(R"(.entry k(.param .u64 .ptr .global out, .param .u64 .ptr .global other) {
.reg .b64 %d<3>; .reg .b32 %r<2>; .reg .pred %p<1>;
ld.param.u64 %d0, [out]; ld.param.u64 %d1, [other]; mov.u32 %r0, %tid.x;
st.global.u32 [%d0], %r0;
setp.eq.u32 %p0, %r0, 7; selp.b64 %d2, %d1, %d0, %p0;
ld.const.u32 %r1, [%d2];
ret; })"),
      "k", TraceMode::blocks, "k.ptx", Checks::on);
  EXPECT_THAT(findings(run_checked(*executable, line_of(2, 2), {a(), b()})),
              ElementsAre(HasSubstr("PTX line 7: data_race: store of 4 bytes to global memory, 'out'")));
}

TEST_F(AccessChecker, DivisionsGoOn) {
  const auto counters = run_checked(R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  b[i] = a[i] / (i - 3) + (int)0x80000000 / (i - 2) + a[i] % (i - 3) + (a[i] << (i * 9)) + (a[i] >> (i * 40));
})",
                                    line_of(8, 8), {a(), b()});
  EXPECT_THAT(findings(counters), IsEmpty());
}

}  // namespace
}  // namespace warpgrain::profiler
