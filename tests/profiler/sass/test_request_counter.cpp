#include <gtest/gtest.h>
#include <numeric>

#include "profiler/observers/totals.hpp"
#include "profiler/sass/replay_totals.hpp"
#include "profiler/sass/request_counter.hpp"
#include "tests/profiler/sass/replayed_kernel.hpp"

namespace warpgrain::profiler::sass {
namespace {

class RequestCounterTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!find_ptxas()) GTEST_SKIP() << no_ptxas;
    in_.resize(64);
    std::iota(in_.begin(), in_.end(), 0);
    out_.assign(8192, 1.5F);
  }

  ReplayedKernel replay(const std::string& body) {
    ReplayedKernel replayed(
        "kernel void k(global const int* restrict in, global float* restrict out) {\n"
        "  const int i = get_global_id(0);\n  const int v = in[i];\n" +
            body + "}\n",
        "k", line_of(64, 64), {buffer_of(in_), buffer_of(out_)});
    replayed.expect_complete();
    return replayed;
  }

  static LaunchCounters totals(const ReplayedKernel& r) {
    LaunchCounters launch;
    put_replay(r.kernel(), r.replay(), r.of_ptx(), SourceLines("", ""), launch);
    return launch;
  }

  std::vector<int> in_;
  std::vector<float> out_;
};

TEST_F(RequestCounterTest, CountsCopiesOfAnUnrolledLoopWhereTheyStand) {
  const ReplayedKernel r =
      replay("float s = 0; for (int k = 0; k < v % 6; ++k) s += out[k * 64 + i];\nout[i + 5000] = s;\n");
  const LaunchCounters launch = totals(r);
  const MemoryCounters of_ptx = launch_totals(r.kernel().decisions.graph(), r.of_ptx()).global_load;
  EXPECT_EQ(launch.totals.global_load.requests, r.warps_at("LDG"));
  EXPECT_EQ(launch.totals.global_load.useful_bytes, (64U + 10 * 15 + 0 + 1 + 2 + 3) * sizeof(float));
  EXPECT_EQ(of_ptx.useful_bytes, launch.totals.global_load.useful_bytes);
  EXPECT_EQ(launch.weights.requests_of_ptx, 0U);
}

TEST_F(RequestCounterTest, WithoutBranchesRequestsAreThoseOfThePtx) {
  const ReplayedKernel r = replay("out[i + 64] = out[3 * v] + out[i + 7];\n");
  const Totals of_ptx = launch_totals(r.kernel().decisions.graph(), r.of_ptx());
  EXPECT_EQ(totals(r).totals.global_load, of_ptx.global_load);
  EXPECT_EQ(totals(r).totals.global_store, of_ptx.global_store);
}

// ptxas puts the store under a predicate: lanes that do not store ask for nothing.
TEST_F(RequestCounterTest, AccessesUnderAPredicateAreOfTheLanesThatMakeThem) {
  const ReplayedKernel r = replay("if (v % 4 == 1) out[i] = 7;\nout[i + 64] = 1;\n");
  const LaunchCounters launch = totals(r);
  EXPECT_EQ(launch.totals.global_store.requests, 2U + 2U);
  EXPECT_EQ(launch.totals.global_store.useful_bytes, (16U + 64) * sizeof(float));
  EXPECT_EQ(launch.weights.requests_of_ptx, 0U);
}

TEST_F(RequestCounterTest, LinesHaveTheRequestsOfTheCode) {
  const ReplayedKernel r =
      replay("float s = 0;\nfor (int k = 0; k < v; ++k) s += out[k * 64 + i];\nout[i + 5000] = s;\n");
  const LaunchCounters launch = totals(r);
  std::uint64_t requests = 0;
  for (const LineTotals& line : launch.lines) requests += line.totals.global_load.requests;
  EXPECT_EQ(requests, launch.totals.global_load.requests);
}

}  // namespace
}  // namespace warpgrain::profiler::sass
