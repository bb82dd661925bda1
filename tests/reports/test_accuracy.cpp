// What a study of accuracy says: its front, its sentences, its JSON and its text.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file_io.hpp"
#include "reports/accuracy_report.hpp"
#include "run_python.hpp"
#include "tests/paths.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::HasSubstr;

AccuracyReport::Case accuracy_case(std::string variant, std::uint64_t warp_instructions, double error) {
  AccuracyReport::Case row;
  row.variant = std::move(variant);
  row.backend = "opencl";
  row.warp_instructions = warp_instructions;
  row.bytes = 64000;
  row.force = {2 * error, error, 20, 10};
  row.collision = {error, 10 * error, error};
  row.trajectory = {0.01, 0.05, 3};
  return row;
}

AccuracyReport study() {
  AccuracyReport report;
  report.generator = this_generator();
  report.scene = "bed";
  report.particles = 1000;
  report.time_step = 1e-5;
  report.seeds = 4;
  report.cost_particles = 2000;
  report.machine = "machine";
  report.measured = "device, bed, 1,000 particles";
  report.cases = {accuracy_case("plain", 1000, 1e-5), accuracy_case("double", 1500, 1e-13),
                  accuracy_case("worse", 1200, 1e-4), accuracy_case("plain", 1000, 1e-4)};
  report.cases[1].trajectory = {{}, 0.05, 1e-9};
  report.cases[1].seconds = 0.001;
  report.cases[1].predicted_seconds = 0.002;
  report.cases[1].measured_seconds = 0.004;
  report.cases[3].measured_seconds = 0.002;
  report.cases[1].ensemble = {{"packing fraction", "", 0.61, 0.01, 0.001, 0.002, false},
                              {"flow rate", "1/s", 110, 2, 10, 3, true}};
  report.cases[3].step_factor = 4;
  rank_cases(report);
  return report;
}

TEST(AccuracyReport, FrontIsWhatNothingBeats) {
  const AccuracyReport report = study();
  EXPECT_FALSE(report.cases[0].dominated_by);
  EXPECT_FALSE(report.cases[1].dominated_by);
  EXPECT_EQ(report.cases[2].dominated_by, "plain");
  EXPECT_FALSE(report.cases[3].dominated_by);
  EXPECT_DOUBLE_EQ(report.cases[1].relative_cost, 1.5);
  EXPECT_DOUBLE_EQ(report.cases[3].relative_cost, 0.25);
  EXPECT_EQ(report.cases[3].name(), "plain, 4 x step");
}

TEST(AccuracyReport, AnotherCostRanksOtherwise) {
  AccuracyReport report = study();
  report.cost = "measured_seconds";
  rank_cases(report);
  EXPECT_EQ(report.cases[0].relative_cost, 0);  // not measured
  EXPECT_DOUBLE_EQ(report.cases[1].relative_cost, 1);
  EXPECT_DOUBLE_EQ(report.cases[3].relative_cost, 0.125);  // half the time, steps four times as large
  EXPECT_THAT(text_accuracy(report), HasSubstr("cost is measured time; costs of 2,000 particles"));
}

TEST(AccuracyReport, ErrorsThatLookAlikeAreAlike) {
  AccuracyReport report = study();
  report.cases.push_back(accuracy_case("other sums", 1001, 0.9999e-5));
  rank_cases(report);
  EXPECT_EQ(report.cases.back().dominated_by, "plain");
}

TEST(AccuracyReport, WhatFailedIsOnNoFront) {
  AccuracyReport report = study();
  AccuracyReport::Case failed;
  failed.variant = "failed";
  failed.warp_instructions = 1000;
  failed.failure = "step 3: particle 0 left the domain";
  report.cases.push_back(failed);
  rank_cases(report);
  EXPECT_TRUE(report.cases.back().dominated_by);
  EXPECT_THAT(sentence_of(report.cases.back()), HasSubstr("left the domain"));
}

TEST(AccuracyReport, SentencesClaimOnlyWhatIsSignificant) {
  const std::string sentence = sentence_of(study().cases[1]);
  EXPECT_THAT(sentence, HasSubstr("costs 1.50 x"));
  EXPECT_THAT(sentence, HasSubstr("packing fraction unchanged within 0.49 %"));
  EXPECT_THAT(sentence, HasSubstr("flow rate higher by 10 % (+- 3 %)"));
  EXPECT_THAT(sentence, HasSubstr("trajectories together for 50 ms"));
}

TEST(AccuracyReport, JsonFollowsItsSchemaAndTextHasEveryCase) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a.json", accuracy_json(study()));
  EXPECT_THAT(
      run_python("validate.py", {source_path("docs/schemas/accuracy-1.schema.json"), folder / "a.json"}),
      testing::ElementsAre("valid"));
  const std::string text = text_accuracy(study());
  for (const char* name : {"plain", "double", "worse", "plain, 4 x step", "dominated by plain"})
    EXPECT_THAT(text, HasSubstr(name));
}

}  // namespace
}  // namespace warpgrain::reports
