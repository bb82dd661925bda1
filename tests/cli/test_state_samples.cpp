// Efficiency against time, as profiles and sweeps count it.

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command_fixture.hpp"
#include "reports/report_json.hpp"
#include "reports/sweep_index.hpp"

namespace warpgrain::cli {
namespace {

using StateSamples = CommandTest;
using testing::HasSubstr;

TEST_F(StateSamples, ProfilesSampleTheWayFromFallingToRest) {
  const std::vector<std::string> scene{"profile", "--scene", "settled_bed", "--particles",
                                       "20",      "--seed",  "5",           "--weights",
                                       "ptx",     "--quiet", "--json",      path("p.json")};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), scene.begin(), scene.end());
    return call(more);
  };
  ASSERT_EQ(with({"--at-step", "25", "--sample-every", "10", "--html", path("p.html")}), 0) << err_;
  const auto report = nlohmann::json::parse(read("p.json"));
  EXPECT_EQ(report["seed"], 5);
  std::vector<int> steps;
  for (const auto& sample : report["samples"]) steps.push_back(sample["step"]);
  EXPECT_THAT(steps, testing::ElementsAre(0, 10, 20, 25));
  // The last is the state that is profiled.
  const auto& kernels = report["samples"][3]["kernels"];
  for (const auto& launch : report["launches"]) {
    const auto same = std::ranges::find_if(
        kernels, [&](const auto& kernel) { return kernel["kernel"] == launch["kernel"]; });
    ASSERT_NE(same, kernels.end()) << launch["kernel"];
    if (std::ranges::count_if(report["launches"],
                              [&](const auto& other) { return other["kernel"] == launch["kernel"]; }) == 1) {
      EXPECT_EQ((*same)["warp_instructions"], launch["totals"]["warp_instructions"]);
    }
  }
  EXPECT_THAT(read("p.html"), HasSubstr("From falling to rest"));

  ASSERT_EQ(call({"profile", "--scene", "settled_bed", "--particles", "1", "--until-rest", "--weights", "ptx",
                  "--quiet", "--json", path("p.json")}),
            0)
      << err_;
  const auto at_rest = nlohmann::json::parse(read("p.json"));
  EXPECT_GT(at_rest["step"].get<int>(), 0);
  EXPECT_FALSE(at_rest.contains("samples"));
  EXPECT_EQ(with({"--sample-every", "10"}), 2);
  EXPECT_THAT(err_, HasSubstr("--sample-every: no steps to sample on the way"));
  EXPECT_EQ(with({"--until-rest", "--at-step", "5"}), 2);
}

TEST_F(StateSamples, SweepsSampleEveryCaseAtTheSameStates) {
  ASSERT_EQ(call({"sweep", "--scene", "settled_bed", "--particles", "64", "--axis", "search=cells,verlet",
                  "--at-step", "20", "--sample-every", "10", "--steps", "0", "--quiet", "--out", path("s")}),
            0)
      << err_;
  const reports::SweepIndex index = reports::read_sweep(folder_ / "s" / "index.json");
  EXPECT_EQ(index.seed, 1u);
  ASSERT_EQ(index.cases.size(), 2u);
  for (const reports::SweepCase& row : index.cases) {
    ASSERT_EQ(row.samples.size(), 3u) << row.variant;
    EXPECT_EQ(row.samples[1].step, 10u);
    const reports::Report report = reports::read_report(folder_ / "s" / *row.report_file);
    ASSERT_EQ(report.samples.size(), 3u);
    EXPECT_DOUBLE_EQ(report.samples[2].simt_efficiency(), row.samples[2].simt_efficiency);
    EXPECT_EQ(report.samples[2].mean_contacts,
              reports::read_report(folder_ / "s" / *index.cases[0].report_file).samples[2].mean_contacts);
  }
  EXPECT_EQ(call({"sweep", "--scene", "settled_bed", "--particles", "64", "--sample-every", "10", "--out",
                  path("t")}),
            2);
}

}  // namespace
}  // namespace warpgrain::cli
