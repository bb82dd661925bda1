// Orders of threads: their names, the counts that sort them, and the traces that they need.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "profiler/thread_permutation.hpp"
#include "tests/profiler/hand_made.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ThreadOrder, NamesAreReadAsWritten) {
  for (const char* name :
       {"launched", "shuffled:1", "shuffled:77", "sorted:thread_instructions", "sorted:a: b"})
    EXPECT_EQ(ThreadOrder::from_name(name, "").name(), name);
  EXPECT_EQ(ThreadOrder::from_name("shuffled", "").name(), "shuffled:1");
  EXPECT_EQ(ThreadOrder::from_name("sorted", "").name(), "sorted:thread_instructions");
  for (const char* name : {"", "launched:1", "shuffled:", "shuffled:x", "shuffled:1x", "sorted:", "random"})
    EXPECT_THAT(refusal([&] { ThreadOrder::from_name(name, "--what-if"); }),
                HasSubstr("expected launched, shuffled, shuffled:SEED, sorted or sorted:KEY"))
        << name;
}

// 1 is a loop that goes on to an unrecorded block; line b + 1 of hand.cl is block b's.
struct Loop {
  KernelGraph graph = hand_made_graph({{1}, {1, 2}, {3}, {}}, {2, 10, 3, 4});
  HandMadeTraces traces;
  Loop() {
    for (const std::size_t rounds : {3U, 1U, 2U, 1U}) {
      std::vector<std::uint32_t> path(rounds + 1, 1);
      path.front() = 0;
      path.insert(path.end(), {2, 3});
      traces.add_lane(graph, path);
    }
  }
  std::uint64_t count(std::string_view key, std::size_t lane) const {
    return ThreadKey::find(graph, SourceLines("\nwhile (more)  // branch: rounds\n", "hand.cl"), key)
        .value()
        .count(traces.lanes()[lane].blocks);
  }
};

TEST(ThreadKey, CountsInstructionsBranchesAndLines) {
  const Loop loop;
  EXPECT_EQ(loop.count("thread_instructions", 0), 2U + 3 * 10 + 3 + 4);
  EXPECT_EQ(loop.count("thread_instructions", 1), 2U + 10 + 3 + 4);
  EXPECT_EQ(loop.count("rounds", 0), 3U);
  EXPECT_EQ(loop.count("2", 2), 2U) << "line 2 is the loop's";
  EXPECT_EQ(loop.count("hand.cl:4", 0), 1U) << "a block that is not recorded";
}

TEST(ThreadKey, UnknownOnesAreAnsweredWithTheValidOnes) {
  const Loop loop;
  const SourceLines source("\nwhile (more)  // branch: rounds\n", "hand.cl");
  for (const char* key : {"trips", "9", "other.cl:2", "and.cl:2", ""})
    EXPECT_FALSE(ThreadKey::find(loop.graph, source, key)) << key;
  EXPECT_THAT(refusal([&] { throw_unknown_thread_key(loop.graph, source, "trips"); }),
              HasSubstr("unknown thread count 'trips'; valid: thread_instructions, rounds, a line with "
                        "instructions, hand.cl:1 to 4"));
}

TEST(ThreadKey, ALineOfTwoFilesNeedsItsFile) {
  KernelGraph graph = hand_made_graph({{1, 2}, {2}, {}});
  graph.files = {"src/a.cl", "src/b.cl"};
  graph.blocks[1].instructions[0].location = {1, 1};  // as line 1 of a.cl
  const SourceLines no_source("", "");
  EXPECT_THAT(refusal([&] { ThreadKey::find(graph, no_source, "1"); }),
              HasSubstr("line 1 stands in src/a.cl and src/b.cl; expected FILE:LINE"));
  EXPECT_TRUE(ThreadKey::find(graph, no_source, "b.cl:1"));
  EXPECT_TRUE(ThreadKey::find(graph, no_source, "src/a.cl:1"));
}

TEST(ThreadPermutation, SortsWithinStretchesAndKeepsMissingThreadsInPlace) {
  Loop loop;
  loop.traces.add_missing_lane();
  loop.traces.add_lane(loop.graph, {0, 1, 2, 3});
  TraceStore store(6, 1 << 20);
  TraceStore::Writer(store).keep(0, loop.traces.lanes());
  const auto key = ThreadKey::find(loop.graph, SourceLines("", ""), "thread_instructions");
  const ThreadOrder sorted = ThreadOrder::from_name("sorted", "");
  EXPECT_THAT(permuted_threads(sorted, &*key, store, 6), ElementsAre(1, 3, 5, 2, 4, 0));
  EXPECT_THAT(permuted_threads(sorted, &*key, store, 3), ElementsAre(1, 2, 0, 3, 4, 5));
  EXPECT_THAT(permuted_threads(ThreadOrder{}, nullptr, store, 6), ElementsAre(0, 1, 2, 3, 4, 5));
  const ThreadOrder shuffled = ThreadOrder::from_name("shuffled:4", "");
  const auto once = permuted_threads(shuffled, nullptr, store, 6);
  EXPECT_EQ(once, permuted_threads(shuffled, nullptr, store, 6));
  EXPECT_EQ(once[4], 4U);
  EXPECT_THAT(once, testing::UnorderedElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(TraceStore, KeepsEqualTracesOnce) {
  const KernelGraph graph = hand_made_graph({{1, 2}, {2}, {}});
  HandMadeTraces traces;
  for (int lane = 0; lane < 5; ++lane)
    traces.add_lane(graph, lane < 3 ? std::vector{0U, 1U, 2U} : std::vector{0U, 2U});
  const std::vector<LaneTrace> lanes = traces.lanes();
  TraceStore store(10, 1 << 20);
  TraceStore::Writer writer(store);
  writer.keep(0, lanes);
  writer.keep(5, lanes);
  EXPECT_EQ(store.trace(0).blocks, store.trace(7).blocks);
  EXPECT_NE(store.trace(0).blocks, lanes[0].blocks) << "a copy";
  EXPECT_NE(store.trace(0).blocks, store.trace(4).blocks);
  EXPECT_TRUE(std::equal(lanes[4].blocks, lanes[4].blocks + 3, store.trace(9).blocks));
  EXPECT_LT(store.bytes(), 1U << 20);
}

TEST(TraceStore, RefusesWhatIsAboveTheLimit) {
  EXPECT_THAT(refusal([] { TraceStore(1 << 20, 5 << 20); }), HasSubstr("more than 5 MiB"));
  const KernelGraph graph = hand_made_graph({{1}, {1, 2}, {}});
  TraceStore store(1, 1 << 20);
  HandMadeTraces traces;
  std::vector<std::uint32_t> path(1 << 20, 1);
  path.front() = 0;
  path.back() = 2;
  traces.add_lane(graph, path);
  EXPECT_THAT(refusal([&] { TraceStore::Writer(store).keep(0, traces.lanes()); }),
              HasSubstr("the traces of the launch's threads take more than 1 MiB; expected fewer threads"));
}

}  // namespace
}  // namespace warpgrain::profiler
