// Launches whose counters are known by hand, and whose output oclgrind-kernel printed: tests/profiler/data
// holds for each a program, NAME.sim, NAME.dump (oclgrind-kernel 21.10's standard output) and NAME.counters.
//
// A counters file has one fact a line, `#` begins a comment:
//   total NAME VALUE                                   a counter of the launch
//   line N load|store|shared_load|shared_store|atomic REQUESTS SECTORS BYTES     of one source line
//   branch LABEL EXECUTIONS DIVERGENT LANES            the label's blanks written as _
// Requests and bytes of a line say how often warps came there and with how many lanes, whatever instructions
// the compiler chose.

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

#include "profiler/launch_file.hpp"
#include "tests/paths.hpp"

namespace warpgrain::profiler {
namespace {

const std::filesystem::path known_answers_files = source_path("tests/profiler/data");

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  text << in.rdbuf();
  return text.str();
}

std::uint64_t total(const LaunchCounters& counters, const std::string& name) {
  const std::map<std::string, std::uint64_t> totals{
      {"warps", counters.warps},
      {"branches", counters.totals.branches},
      {"divergent_branches", counters.totals.divergent_branches},
      {"global_load_requests", counters.totals.global_load.requests},
      {"global_load_sectors", counters.totals.global_load.sectors},
      {"global_store_requests", counters.totals.global_store.requests},
      {"global_store_sectors", counters.totals.global_store.sectors},
      {"shared_load_requests", counters.totals.shared_load.requests},
      {"shared_store_requests", counters.totals.shared_store.requests},
      {"atomic_requests", counters.totals.atomic.requests}};
  return totals.at(name);
}

const MemoryCounters& of_kind(const Totals& totals, const std::string& kind) {
  const std::map<std::string, const MemoryCounters*> kinds{{"load", &totals.global_load},
                                                           {"store", &totals.global_store},
                                                           {"shared_load", &totals.shared_load},
                                                           {"shared_store", &totals.shared_store},
                                                           {"atomic", &totals.atomic}};
  return *kinds.at(kind);
}

void check_fact(const LaunchCounters& counters, const std::string& fact) {
  std::istringstream in(fact);
  std::string subject, name;
  in >> subject >> name;
  if (subject == "total") {
    std::uint64_t value = 0;
    in >> value;
    EXPECT_EQ(total(counters, name), value) << fact;
  } else if (subject == "line") {
    std::string kind;
    MemoryCounters expected;
    in >> kind >> expected.requests >> expected.sectors >> expected.useful_bytes;
    const auto line = std::find_if(counters.lines.begin(), counters.lines.end(),
                                   [&](const LineTotals& l) { return std::to_string(l.line) == name; });
    ASSERT_NE(line, counters.lines.end()) << fact;
    const MemoryCounters& found = of_kind(line->totals, kind);
    EXPECT_EQ(found.requests, expected.requests) << fact;
    EXPECT_EQ(found.sectors, expected.sectors) << fact;
    EXPECT_EQ(found.useful_bytes, expected.useful_bytes) << fact;
  } else if (subject == "branch") {
    std::replace(name.begin(), name.end(), '_', ' ');
    std::uint64_t executions = 0, divergent = 0, lanes = 0;
    in >> executions >> divergent >> lanes;
    const auto branch = std::find_if(counters.branches.begin(), counters.branches.end(),
                                     [&](const BranchTotals& b) { return b.label == name; });
    ASSERT_NE(branch, counters.branches.end()) << fact;
    EXPECT_EQ(branch->executions, executions) << fact;
    EXPECT_EQ(branch->divergent, divergent) << fact;
    EXPECT_EQ(branch->lanes, lanes) << fact;
  } else {
    FAIL() << "no fact: " << fact;
  }
  EXPECT_TRUE(in) << fact;
}

void expect_invariants(const LaunchCounters& counters) {
  const Totals& totals = counters.totals;
  std::uint64_t warp = 0, thread = 0, lost = counters.lane_slots_never_used, branches = 0;
  for (std::size_t lanes = 0; lanes < totals.lane_histogram.size(); ++lanes) {
    warp += totals.lane_histogram[lanes];
    thread += totals.lane_histogram[lanes] * lanes;
  }
  EXPECT_EQ(warp, totals.warp_instructions);
  EXPECT_EQ(thread, totals.thread_instructions);
  EXPECT_EQ(totals.lane_histogram[0], 0U);
  for (const BranchTotals& branch : counters.branches) {
    lost += branch.lane_slots_lost;
    branches += branch.executions;
  }
  EXPECT_EQ(lost, counters.warp_width * totals.warp_instructions - totals.thread_instructions);
  EXPECT_EQ(branches, totals.branches);
  Totals sum;
  for (const LineTotals& line : counters.lines) sum.add(line.totals);
  EXPECT_EQ(sum, totals);
}

class KnownAnswers : public testing::TestWithParam<std::string> {};

TEST_P(KnownAnswers, CountersByHandAndOutputByOclgrind) {
  const LaunchFile file = read_launch_file(known_answers_files / (GetParam() + ".sim"));
  std::ostringstream dump;
  const LaunchCounters counters = profile_launch_file(file, "", {}, dump).profile.counters;
  EXPECT_EQ(dump.str(), text_of(known_answers_files / (GetParam() + ".dump")));
  expect_invariants(counters);
  std::istringstream facts(text_of(known_answers_files / (GetParam() + ".counters")));
  for (std::string fact; std::getline(facts, fact);) {
    fact.resize(std::min(fact.find('#'), fact.size()));
    if (!fact.empty()) check_fact(counters, fact);
  }
}

TEST_P(KnownAnswers, WidthPolicyAndThreadsLeaveTheOutputAlone) {
  const ProfileOptions options{
      .policy = MergePolicy::ipdom, .warp_width = 8, .addresses = false, .threads = 2};
  std::ostringstream dump;
  const LaunchFile file = read_launch_file(known_answers_files / (GetParam() + ".sim"));
  const LaunchCounters counters = profile_launch_file(file, "", options, dump).profile.counters;
  EXPECT_EQ(dump.str(), text_of(known_answers_files / (GetParam() + ".dump")));
  expect_invariants(counters);
  EXPECT_EQ(counters.totals.global_load, MemoryCounters{});
}

INSTANTIATE_TEST_SUITE_P(Launches, KnownAnswers,
                         testing::Values("half_and_half", "trip_count", "early_return", "break_and_continue",
                                         "switch", "bitonic_sort", "sectors", "every_type"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace warpgrain::profiler
