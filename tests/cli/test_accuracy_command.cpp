// `warpgrain accuracy` as a user calls it.

#include <algorithm>
#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../reports/run_python.hpp"
#include "cli/accuracy/collision_level.hpp"
#include "cli/accuracy/ensemble_level.hpp"
#include "command_fixture.hpp"
#include "core/time_step.hpp"
#include "tests/paths.hpp"

namespace warpgrain::cli {
namespace {

using Accuracy = CommandTest;
using testing::HasSubstr;

// The double reference in small steps rebounds as the material says, and slides less the steeper it comes. In
// so hard a material that the line of centres does not turn while an oblique collision lasts.
TEST(AccuracyCollisions, KeepTheRestitutionOfTheMaterial) {
  Scene scene = load_scene("settled_bed", {8, {}});
  ContactParameters hard = scene.contacts.at(0, 0);
  hard.normal_parameter *= 1e8;
  hard.tangential_parameter *= 1e8;
  scene.contacts.set(0, 0, hard);
  Variant reference;
  reference.set("precision", "fp64");
  const auto exact =
      collisions(scene, backend("host"), reference, {}, 0.01 * automatic_time_step(time_step_limits(scene)));
  ASSERT_EQ(exact.size(), 4U);
  for (const CollisionOutcome& outcome : exact) EXPECT_NEAR(outcome.restitution, 0.8, 1e-3) << outcome.angle;
  EXPECT_NEAR(exact[0].rebound_angle, 0, 1e-9);
  EXPECT_NEAR(exact[0].surface_spin, 0, 1e-9);
  EXPECT_GT(exact[3].rebound_angle, exact[2].rebound_angle);
  const CollisionError none = collision_error(exact, exact);
  EXPECT_EQ(none.restitution + none.spin + none.rebound_angle, 0);
}

TEST(AccuracyEnsemble, GivesWhatHeapsAreLike) {
  const auto quantities = ensemble(2, backend("host"), Variant(), {}, 2);
  ASSERT_EQ(quantities.size(), 5U);
  const std::array<std::pair<double, double>, 5> ranges{
      {{100, 10000}, {0, 0.5}, {0, 0.8}, {0, 8}, {-60, 60}}};
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    ASSERT_EQ(quantities[k].values.size(), 2U);
    const bool is_count = quantities[k].name == "packing fraction";  // of a few grains
    EXPECT_TRUE(is_count || quantities[k].values[0] != quantities[k].values[1]) << quantities[k].name;
    for (const double value : quantities[k].values) {
      EXPECT_GE(value, ranges[k].first) << quantities[k].name;
      EXPECT_LT(value, ranges[k].second) << quantities[k].name;
    }
  }
}

TEST_F(Accuracy, StudiesEveryLevelAndMarksTheFront) {
  ASSERT_EQ(call({"accuracy", "--particles", "64", "--at-step", "50", "--trajectory-steps", "80", "--steps",
                  "5", "--axis", "precision=fp32,fp64", "--step-factor", "1,0.5", "--json", path("a.json")}),
            0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("restitution off by"));
  const auto json = nlohmann::json::parse(read("a.json"));
  ASSERT_EQ(json["cases"].size(), 4U);
  const auto& floats = json["cases"][0];
  const auto& doubles = json["cases"][1];
  EXPECT_GT(floats["force"]["maximum"], doubles["force"]["maximum"]);
  EXPECT_LT(doubles["force"]["maximum"], 1e-10);
  EXPECT_EQ(floats["relative_cost"], 1.0);
  EXPECT_EQ(json["cases"][2]["relative_cost"], 2.0);
  EXPECT_LT(json["cases"][3]["collision"]["restitution"], doubles["collision"]["restitution"]);
  EXPECT_THAT(reports::run_python("validate.py",
                                  {source_path("docs/schemas/accuracy-1.schema.json"), path("a.json")}),
              testing::ElementsAre("valid"));
}

TEST_F(Accuracy, RanksByPredictedAndByMeasuredTimes) {
  const std::string readings =
      source_path("reports/measured/h100-variants/cuda-bed131072-branchy-cells-cell-");
  std::vector<std::string> words{"accuracy",
                                 "--particles",
                                 "64",
                                 "--at-step",
                                 "50",
                                 "--level",
                                 "force",
                                 "--steps",
                                 "0",
                                 "--axis",
                                 "precision=fp32,fp64,fp16_history",
                                 "--machine",
                                 "hopper_h100",
                                 "--measured",
                                 readings + "fp32-default.json," + readings + "fp64-default.json",
                                 "--json",
                                 path("a.json")};
  ASSERT_EQ(call(words), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("measured: NVIDIA H100"));
  auto cases = nlohmann::json::parse(read("a.json"))["cases"];
  EXPECT_GT(cases[1]["predicted_seconds"], 1e-6);
  EXPECT_GT(cases[1]["measured_seconds"], cases[0]["measured_seconds"]);
  EXPECT_FALSE(cases[2].contains("measured_seconds"));
  EXPECT_LT(cases[1]["relative_cost"], 1.1);  // fp64 has as many instructions, and takes longer
  words.insert(words.end(), {"--cost", "measured_seconds"});
  ASSERT_EQ(call(words), 0) << err_;
  cases = nlohmann::json::parse(read("a.json"))["cases"];
  EXPECT_GT(cases[1]["relative_cost"], 1.2);
  EXPECT_FALSE(cases[2]["on_front"]);
  EXPECT_THAT(out_, HasSubstr("cost not known"));
  EXPECT_THAT(reports::run_python("validate.py",
                                  {source_path("docs/schemas/accuracy-1.schema.json"), path("a.json")}),
              testing::ElementsAre("valid"));
}

// A number of a row of a table by the row's first cells.
double cell_of(const nlohmann::json& table, const std::vector<nlohmann::json>& key, std::size_t column) {
  for (const auto& row : table["rows"])
    if (std::equal(key.begin(), key.end(), row.begin())) return row[column].get<double>();
  ADD_FAILURE() << "no such row";
  return 0;
}

TEST_F(Accuracy, ReproducesChungAndOoisImpacts) {
  ASSERT_EQ(call({"accuracy", "--study", "impacts", "--json", path("i.json")}), 0) << err_;
  const auto tables = nlohmann::json::parse(read("i.json"))["tables"];
  ASSERT_EQ(tables.size(), 9U);
  for (const auto& [table, scene] : {std::pair{0, "impact_1_glass"}, std::pair{1, "impact_2_magnesium"}})
    for (const std::size_t column : {2, 3, 5})
      for (const char* by : {"double reference", "branchy/cells/cell/fp32/default"})
        EXPECT_NEAR(
            cell_of(tables[table], {scene, by}, column) / cell_of(tables[table], {scene, "Hertz"}, column), 1,
            2e-3)
            << scene << ", " << by << ", column " << column;
  for (const std::size_t table : {2, 5})  // force over time
    for (const auto& row : tables[table]["rows"])
      for (const std::size_t column : {2, 3})
        EXPECT_NEAR(row[column].get<double>(), row[1].get<double>(), 0.2) << tables[table]["title"];
  EXPECT_NEAR(cell_of(tables[6], {"impact_3_alumina", 0.6}, 2), 0.6, 2e-3);
  for (const std::size_t column : {2, 4})
    EXPECT_NEAR(
        cell_of(tables[7], {60.0, "double reference"}, column) / cell_of(tables[7], {60.0, "theory"}, column),
        1, 2e-3);
  EXPECT_NEAR(cell_of(tables[7], {15.0, "double reference"}, 4), 378, 10);  // published, physics of test 4
  EXPECT_THAT(
      reports::run_python("validate.py", {source_path("docs/schemas/study-1.schema.json"), path("i.json")}),
      testing::ElementsAre("valid"));
}

TEST_F(Accuracy, MeasuresHowSlipHistoriesConverge) {
  ASSERT_EQ(call({"accuracy", "--study", "convergence", "--markdown", "--json", path("c.json")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("| clip |"));
  const auto tables = nlohmann::json::parse(read("c.json"))["tables"];
  for (const auto& table : tables)
    EXPECT_GT(cell_of(table, {"clip"}, table["columns"].size() - 1), 0.5) << table["title"];
}

TEST_F(Accuracy, RefusesWrongCallsInOneLine) {
  const std::vector<std::vector<std::string>> calls{
      {"--level", "no_such"},          {"--study", "no_such"},        {"--step-factor", "0"},
      {"--step-factor", "nan"},        {"--trajectory-steps", "0"},   {"--scene", "no_such"},
      {"--axis", "math=no_such"},      {"--cost", "no_such"},         {"--cost", "measured_seconds"},
      {"--cost", "predicted_seconds"}, {"--measured", "no_such.json"}};
  for (const auto& words : calls) {
    std::vector<std::string> whole{"accuracy"};
    whole.insert(whole.end(), words.begin(), words.end());
    EXPECT_EQ(call(whole), 2) << words[0] << " " << words[1];
    EXPECT_EQ(error_lines(), 1U) << err_;
  }
}

}  // namespace
}  // namespace warpgrain::cli
