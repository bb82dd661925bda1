// Launch files from the file to counters: the errors on the way, PTX programs, and what does not depend on
// threads.

#include <bit>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "core/error.hpp"
#include "profiler/compiled_launches.hpp"
#include "profiler/launch_file.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::profiler {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ProfileLaunchFile : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  LaunchFileResult profile(const std::string& launch, const ProfileOptions& options = {}) {
    write("x.sim", launch);
    return profile_launch_file(read_launch_file(folder_ / "x.sim"), "", options, dump_);
  }
  std::string error_of(const std::string& launch) {
    try {
      profile(launch);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  TemporaryFolder folder_;
  std::ostringstream dump_;
};

// Lanes go down a tree of five branches, by the bits of their number, to 32 leaves; each writes its leaf's
// number.
std::string leaves_ptx() {
  std::string ptx = R"(.version 7.0
.target sm_70
.address_size 64
.visible .entry leaves(.param .u64 out) {
  .reg .pred %p<2>;
  .reg .b32 %r<4>;
  .reg .b64 %rd<4>;
  ld.param.u64 %rd1, [out];
  mov.u32 %r1, %tid.x;
)";
  for (int node = 0; node < 31; ++node) {
    const int level = std::bit_width(static_cast<unsigned>(node + 1)) - 1;
    ptx += fmt::format(
        "N{}:\n  and.b32 %r2, %r1, {};\n  setp.ne.s32 %p1, %r2, 0;\n  @%p1 bra N{};\n  bra.uni N{};\n", node,
        16 >> level, 2 * node + 2, 2 * node + 1);
  }
  for (int leaf = 31; leaf < 63; ++leaf)
    ptx += fmt::format("N{}:\n  mov.u32 %r3, {};\n  bra.uni END;\n", leaf, leaf - 31);
  return ptx + R"(END:
  mul.wide.u32 %rd2, %r1, 4;
  add.s64 %rd3, %rd1, %rd2;
  st.global.u32 [%rd3], %r3;
  ret;
}
)";
}

TEST_F(ProfileLaunchFile, FiveNestedBranchesOfPtxToTheInstruction) {
  write("leaves.ptx", leaves_ptx());
  const LaunchFileResult result = profile("leaves.ptx leaves 32 1 1 32 1 1 <size=128 uint noinit dump>");
  const LaunchCounters& counters = result.profile.counters;
  // Node: 3 instructions for both ways and 1 for the way that does not branch; leaf: 2; 2 before and 4 behind
  // the tree.
  EXPECT_EQ(counters.totals.warp_instructions, 2U + 31 * 4 + 32 * 2 + 4);
  EXPECT_EQ(counters.totals.thread_instructions, 32U * (2 + 4) + 5 * (32 * 3 + 16) + 32 * 2);
  EXPECT_EQ(counters.totals.branches, 31U);
  EXPECT_EQ(counters.totals.divergent_branches, 31U);
  // Level d has 2^d branches, each of which keeps half of its 32 / 2^d lanes waiting while the other half is
  // below.
  std::vector<std::uint64_t> lost_of_level(5);
  ASSERT_EQ(counters.branches.size(), 31U);
  for (const BranchTotals& branch : counters.branches)
    lost_of_level.at(static_cast<std::size_t>(std::countr_zero(32 / branch.lanes))) += branch.lane_slots_lost;
  for (std::uint64_t level = 0; level < 5; ++level) {
    const std::uint64_t half = 16 >> level, leaves_below = half, nodes_below = half - 1;
    // Each side runs `nodes_below` nodes and `leaves_below` leaves; one side also runs the `bra.uni`.
    const std::uint64_t slots = half * (2 * (nodes_below * 4 + leaves_below * 2) + 1);
    EXPECT_EQ(lost_of_level[level], (std::uint64_t{1} << level) * slots) << "level " << level;
  }
  EXPECT_THAT(dump_.str(), StartsWith("\nArgument 'out': 128 bytes\n  out[0] = 0\n  out[1] = 1\n"));
  EXPECT_THAT(dump_.str(), HasSubstr("out[31] = 31\n"));
  EXPECT_EQ(result.profile.compiler, "");
}

TEST_F(ProfileLaunchFile, AtomicsOfAllThreadsArriveAndCountersDoNotDependOnThreads) {
  write("sum.cl", R"(kernel void sum(global uint* total, global uint* histogram) {
  const uint i = get_global_id(0);
  atomic_add(total, i);
  if (i % 3 == 0) atomic_inc(&histogram[i % 7]);  // branch: every third
})");
  const std::string launch = "sum.cl sum 100000 1 1 50 1 1 <size=4> 0 <size=28 fill=0>";
  const LaunchFileResult one = profile(launch, {.threads = 1}), four = profile(launch, {.threads = 4});
  std::uint32_t total = 0;
  std::memcpy(&total, four.buffers.at(0).bytes().data(), sizeof total);
  EXPECT_EQ(total, static_cast<std::uint32_t>(99999ULL * 100000 / 2));
  std::array<std::uint32_t, 7> histogram{};
  std::memcpy(histogram.data(), four.buffers.at(1).bytes().data(), sizeof histogram);
  EXPECT_EQ(std::accumulate(histogram.begin(), histogram.end(), 0U), 33334U);
  EXPECT_EQ(one.profile.counters.totals, four.profile.counters.totals);
  EXPECT_EQ(one.profile.counters.totals.atomic.requests, 2U * 4000);
  EXPECT_EQ(one.profile.counters.branches.at(0).label, "every third");
  EXPECT_EQ(one.profile.counters.branches.at(0).lane_slots_lost,
            four.profile.counters.branches.at(0).lane_slots_lost);
}

TEST_F(ProfileLaunchFile, ProvenanceIsKept) {
  write("k.cl", "kernel void k(global int* a) { a[get_global_id(0)] = 1; }");
  const LaunchProfile profile = this->profile("k.cl k 4 1 1 2 1 1 <size=16 noinit>").profile;
  EXPECT_THAT(profile.source, StartsWith("kernel void k"));
  EXPECT_EQ(profile.source_name, (folder_ / "k.cl").string());
  EXPECT_THAT(profile.ptx, HasSubstr(".entry k"));
  EXPECT_THAT(profile.compiler, HasSubstr("15."));
  EXPECT_THAT(profile.compile_command, HasSubstr("-O2"));
  EXPECT_EQ(profile.counters.lines.at(0).file, profile.source_name);
}

TEST_F(ProfileLaunchFile, LaunchesOfOneProgramAreCompiledOnce) {
  write("k.cl", "kernel void k(global int* a) { a[get_global_id(0)] = VALUE; }");
  write("k.cl.options", "-DVALUE=3");
  write("x.sim", "k.cl k 8 1 1 4 1 1 <size=32 noinit>");
  LaunchFile file = read_launch_file(folder_ / "x.sim");
  file.program_name = "short.cl";
  CompiledLaunches compiled;
  const auto run = [&] { return profile_launch_file(file, "", {}, dump_, compiled); };
  const LaunchFileResult first = run();
  EXPECT_EQ(std::to_integer<int>(first.buffers.at(0).bytes()[0]), 3);
  EXPECT_EQ(first.profile.counters.lines.at(0).file, "short.cl");
  std::filesystem::remove(folder_ / "k.cl");
  EXPECT_EQ(run().profile.counters.totals, first.profile.counters.totals);
  file.shape.local_size[0] = 3;  // whose last work-group is smaller: another PTX
  EXPECT_THROW(run(), InputError);
}

TEST_F(ProfileLaunchFile, ThreeVectorsMayBeGivenWithoutRoomForAFourth) {
  write("k.cl", "kernel void k(global float* a, float3 v) { a[0] = v.x + 10 * v.y + 100 * v.z; }");
  profile("k.cl k 1 1 1 1 1 1 <size=4 noinit dump> <size=12> 1 2 3");
  EXPECT_THAT(dump_.str(), HasSubstr("a[0] = 321\n"));
}

TEST_F(ProfileLaunchFile, ErrorsNameThePlace) {
  const std::string tail = " 4 1 1 2 1 1 <size=16 noinit>";
  EXPECT_THAT(error_of("gone.cl k" + tail), HasSubstr("gone.cl': cannot be read"));
  write("bad.cl", "kernel void k(global int* a) {\n  a[0] = b;\n}");
  EXPECT_THAT(error_of("bad.cl k" + tail), HasSubstr("bad.cl:2"));
  write("k.cl",
        "kernel void first(global int* a) { a[get_global_id(0)] = 1; }\nkernel void second(int n) {}");
  EXPECT_THAT(error_of("k.cl third" + tail), HasSubstr("valid: first, second"));
  EXPECT_THAT(error_of("k.cl first 4 1 1 2 1 1"), HasSubstr("0 arguments for kernel 'first'; expected 1: a"));
  EXPECT_THAT(error_of("k.cl first" + tail + "\n<size=4> 7"),
              HasSubstr("x.sim:2: 2 arguments for kernel 'first'"));
  EXPECT_THAT(error_of("k.cl second 4 1 1 2 1 1\n<size=8> 1 2"),
              HasSubstr("x.sim:2: argument 0 'n': size=8; expected size=4"));
}

}  // namespace
}  // namespace warpgrain::profiler
