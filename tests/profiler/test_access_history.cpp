// Data races: those that are there, and those that are not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/profiler/checked_launch.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> races(std::string_view source, const LaunchShape& shape, unsigned threads = 1,
                               bool with_local = false) {
  std::vector<int> a(256), b(256);
  std::vector<KernelArgument> arguments{buffer_of(a), buffer_of(b)};
  if (with_local) arguments.push_back(KernelArgument::local(1024));
  return findings(run_checked(source, shape, arguments, threads));
}

TEST(AccessHistory, TwoWorkItemsWriteTheSameWord) {
  EXPECT_THAT(
      races(R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  a[i / 2] = i + 1;
})",
            line_of(8, 8)),
      ElementsAre("kernel.cl:3: data_race: store of 4 bytes to global memory, 'a' at byte 0 of 1024, "
                  "work-item (1, 0, 0) in work-group (0, 0, 0), after the store by work-item (0, 0, 0) "
                  "at kernel.cl:3; 4 times"));
}

TEST(AccessHistory, OneReadsWhatAnotherWrites) {
  const std::string source = R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  b[i] = a[(i + 1) % 8];
  a[i] = i + 1;
})";
  EXPECT_THAT(
      races(source, line_of(8, 8)),
      ElementsAre(HasSubstr("kernel.cl:3: data_race: load of 4 bytes from global memory, 'a' at byte 0 of "
                            "1024, work-item (7, 0, 0) in work-group (0, 0, 0), after the store by "
                            "work-item (0, 0, 0) at kernel.cl:4"),
                  HasSubstr("kernel.cl:4: data_race: store of 4 bytes to global memory, 'a' at byte 4 of "
                            "1024, work-item (1, 0, 0) in work-group (0, 0, 0), after the load by "
                            "work-item (0, 0, 0) at kernel.cl:3; 7 times")));
  // Of two groups it is one all the same.
  EXPECT_EQ(races(source, line_of(8, 4)).size(), 2u);
}

TEST(AccessHistory, BarriersOrderAGroup) {
  const std::string ordered = R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0), l = get_local_id(0), n = get_local_size(0), g = i - l;
  a[i] = i;
  barrier(CLK_GLOBAL_MEM_FENCE);
  b[i] = a[g + (l + 1) % n];
  barrier(CLK_GLOBAL_MEM_FENCE);
  a[g + (l + 2) % n] = i + 1;
})";
  EXPECT_THAT(races(ordered, line_of(64, 16)), IsEmpty());
  // But no other group.
  EXPECT_THAT(races(R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  a[i] = i + 1;
  barrier(CLK_GLOBAL_MEM_FENCE);
  b[i] = a[(i + 16) % 64];
})",
                    line_of(64, 16)),
              ElementsAre(HasSubstr("kernel.cl:3: data_race"), HasSubstr("kernel.cl:5: data_race")));
}

TEST(AccessHistory, LocalMemory) {
  EXPECT_THAT(
      races(R"(kernel void k(global int* a, global int* b, local int* c) {
  int l = get_local_id(0);
  c[l] = l + 1;
  a[get_global_id(0)] = c[l ^ 1];
})",
            line_of(32, 16), 1, true),
      ElementsAre(HasSubstr("kernel.cl:3: data_race: store of 4 bytes to shared memory, 'c'"),
                  HasSubstr("kernel.cl:4: uninitialized_read: load of 4 bytes from shared memory, 'c'"),
                  HasSubstr("kernel.cl:4: data_race: load of 4 bytes from shared memory, 'c'")));
  EXPECT_THAT(races(R"(kernel void k(global int* a, global int* b, local int* c) {
  int l = get_local_id(0), n = get_local_size(0);
  c[l] = l + 1;
  for (int rest = n / 2; rest > 0; rest /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (l < rest) c[l] += c[l + rest];
  }
  if (l == 0) a[get_group_id(0)] = c[0];
})",
                    line_of(256, 64), 1, true),
              IsEmpty());
}

// Who has set a place to zero may count there with the others after the barrier, in every work-group.
TEST(AccessHistory, AtomicsAfterAPlainWriteAndABarrierAreNoRace) {
  std::vector<int> data(256, 3);
  EXPECT_THAT(findings(run_checked(R"(
kernel void k(global int* a) {
  local int own[64];
  const int l = get_local_id(0);
  if (l < 64) own[l] = 0;
  barrier(CLK_LOCAL_MEM_FENCE);
  for (int trip = 0; trip < 3; ++trip) atomic_inc(own + (l * 7 + trip) % 64);
  barrier(CLK_LOCAL_MEM_FENCE);
  if (l < 64) atomic_add(a + l, own[l]);
})",
                                   line_of(512, 128), {buffer_of(data)})),
              IsEmpty());
}

TEST(AccessHistory, AtomicsDoNotRaceWithEachOther) {
  EXPECT_THAT(races(R"(kernel void k(global int* a, global int* b) {
  atomic_add(a + get_global_id(0) % 4, 1);
})",
                    line_of(64, 16), 2),
              IsEmpty());
  EXPECT_THAT(
      races(R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  atomic_add(a, 1);
  b[i] = a[0];
})",
            line_of(4, 4)),
      ElementsAre(HasSubstr(
          "kernel.cl:3: data_race: atomic of 4 bytes on global memory, 'a' at byte 0 of 1024, work-item (1, "
          "0, 0) in work-group (0, 0, 0), after the load by work-item (0, 0, 0) at kernel.cl:4")));
}

// The last group to come sums up what the others left, behind fences.
TEST(AccessHistory, FencesAndAtomicsOrderGroups) {
  EXPECT_THAT(races(R"(kernel void k(global int* a, global int* b, local int* last) {
  int g = get_group_id(0), l = get_local_id(0);
  if (l == 0) {
    a[g] = g + 1;
    mem_fence(CLK_GLOBAL_MEM_FENCE);
    last[0] = atomic_inc(a + 100) == (int)get_num_groups(0) - 1;
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  if (last[0]) b[l] = a[l % 4] + a[(l + 1) % 4];
})",
                    line_of(64, 16), 1, true),
              IsEmpty());
}

TEST(AccessHistory, EqualValuesDoNoHarm) {
  EXPECT_THAT(races("kernel void k(global int* a, global int* b) { a[0] = 1; }", line_of(64, 16)), IsEmpty());
}

TEST(AccessHistory, BytesBesideEachOther) {
  EXPECT_THAT(races(R"(kernel void k(global char* a, global short* b) {
  int i = get_global_id(0);
  a[i] = i;
  b[i] = a[i];
})",
                    line_of(64, 16)),
              IsEmpty());
}

// Met on an H100: two work-items stored one component each, and NVIDIA's compiler stored a half by loading
// and storing the whole.
TEST(AccessHistory, ComponentsOfOneVector) {
  EXPECT_THAT(
      races(R"(kernel void k(global uint2* a, global int* b) {
  uint i = get_global_id(0);
  if (i & 1) a[i / 2].y = i;
  else a[i / 2].x = i + 1;
})",
            line_of(64, 32)),
      ElementsAre(HasSubstr("subvector_race: store of 4 bytes to global memory, 'a' at byte 4 of 1024, "
                            "work-item (1, 0, 0) in work-group (0, 0, 0), after the store by work-item "
                            "(0, 0, 0) at kernel.cl:4; 32 times")));
  EXPECT_THAT(races(R"(kernel void k(global float4* a, global float* b) {
  uint i = get_global_id(0);
  if (i == 0) a[3].w = 2;
  if (i == 40) b[0] = a[3].x;
})",
                    line_of(64, 32)),
              ElementsAre(HasSubstr("kernel.cl:4: subvector_race: load of 4 bytes")));
  // One component of each work-item's own, and numbers that are no vectors.
  EXPECT_THAT(races(R"(kernel void k(global uint2* a, global uint* b) {
  uint i = get_global_id(0);
  a[i].x = i;
  a[i].y = i;
  b[i] = i;
})",
                    line_of(64, 32)),
              IsEmpty());
}

TEST(AccessHistory, SeveralThreadsFindTheSamePlaces) {
  const std::string source = R"(kernel void k(global int* a, global int* b) {
  int i = get_global_id(0);
  a[i % 128] = i;
  b[i % 256] = a[(i + 1) % 128];
})";
  for (const unsigned threads : {1u, 4u}) {
    const auto found = races(source, line_of(4096, 16), threads);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_THAT(found[0], HasSubstr("kernel.cl:3: data_race: store"));
    EXPECT_THAT(found[1], HasSubstr("kernel.cl:4: data_race: load"));
    EXPECT_THAT(found[2], HasSubstr("kernel.cl:4: data_race: store"));
  }
}

}  // namespace
}  // namespace warpgrain::profiler
