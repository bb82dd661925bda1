// The atlas of a stability run: its JSON, its text and its page.

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/stability_report.hpp"
#include "run_python.hpp"
#include "tests/paths.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::HasSubstr;

StabilityReport atlas() {
  StabilityReport report;
  report.generator = this_generator();
  report.probes.push_back({"speed", "two spheres meet", "speed", "m/s", "restitution", 1, 1e-4, 0.01, 0.05});
  const auto cell = [&](std::string variant, Verdict verdict) -> StabilityReport::Cell& {
    report.cells.push_back({"speed", std::move(variant), "opencl", verdict, {}, {}, {}, {}, {}});
    return report.cells.back();
  };
  StabilityReport::Cell& right = cell("a", Verdict::right);
  right.right_until = right.degraded_until = 1e-4;
  right.samples = {{1, Verdict::right, 0.001, "fine"}, {1e-4, Verdict::right, 0.002, "fine"}};
  StabilityReport::Cell& wrong = cell("b<i>", Verdict::wrong);
  wrong.right_until = 0.1;
  wrong.right_beyond = wrong.degraded_until = 0.05;
  wrong.degraded_beyond = 0.02;
  wrong.samples = {{1, Verdict::right, 0.001, "fine"},
                   {0.05, Verdict::degraded, 0.03, "0.77"},
                   {0.02, Verdict::wrong, 0.5, "0.4, expected 0.8"}};
  StabilityReport::Cell& refused = cell("c", Verdict::refused);
  refused.right_beyond = refused.degraded_beyond = 1;
  refused.samples = {{1, Verdict::refused, {}, "step 3: particle 0 left"}};
  cell("d", Verdict::not_applicable);
  return report;
}

TEST(StabilityReport, SaysHowFarItIsRight) {
  const StabilityReport report = atlas();
  const auto text = [&](std::size_t k) { return limits_text(report.probes[0], report.cells[k]); };
  EXPECT_EQ(text(0), "right to 0.0001");
  EXPECT_EQ(text(1), "right to 0.1, degraded to 0.05, then wrong: 0.4, expected 0.8");
  EXPECT_EQ(text(2), "nowhere right, then refused: step 3: particle 0 left");
  EXPECT_EQ(text(3), "not applicable");
  EXPECT_EQ(share_of_range(report.probes[0], report.cells[0]), 1);
  EXPECT_DOUBLE_EQ(share_of_range(report.probes[0], report.cells[1]), 0.25);
  EXPECT_EQ(share_of_range(report.probes[0], report.cells[2]), 0);
}

TEST(StabilityReport, LimitsAreToldInASecondUnit) {
  StabilityReport report = atlas();
  report.probes[0].other_unit = "km/h";
  report.probes[0].others_in_unit = 3.6;
  EXPECT_EQ(limits_text(report.probes[0], report.cells[1]),
            "right to 0.1 (0.36 km/h), degraded to 0.05 (0.18 km/h), then wrong: 0.4, expected 0.8");
  EXPECT_THAT(stability_json(report), HasSubstr("others_in_unit"));
}

TEST(StabilityReport, MarkdownHasARowForEveryLimit) {
  const std::string text = markdown_stability(atlas());
  EXPECT_THAT(text, HasSubstr("| speed | 1 to 0.0001 m/s | all of it | all of it |  | a |"));
  EXPECT_THAT(text, HasSubstr("| speed | 1 to 0.0001 m/s | 0.1 | 0.05 | wrong: 0.4, expected 0.8 | b<i> |"));
  EXPECT_THAT(text, HasSubstr("| - | - | refused: step 3: particle 0 left | c |"));
  EXPECT_THAT(text, HasSubstr("not applicable | d |"));
}

// As scripts/generated_blocks.py has it drawn.
TEST(StabilityReport, HasAFigure) {
  if (!std::filesystem::exists(source_path("reports/html/node_modules/echarts")))
    GTEST_SKIP() << "no ECharts: scripts/install_dependencies.sh";
  const TemporaryFolder folder;
  write_file_atomically(folder / "atlas.json", stability_json(atlas()));
  ASSERT_EQ(std::system(fmt::format("node {}/scripts/figures.mjs {} {}", source_path(""),
                                    folder.path().string(), (folder / "atlas.json").string())
                            .c_str()),
            0);
  const std::string figure = read_text_file(folder / "atlas.svg", 1 << 20);
  EXPECT_THAT(figure, HasSubstr("prefers-color-scheme"));
  EXPECT_THAT(figure, HasSubstr("speed [m/s]"));
}

TEST(StabilityReport, JsonFollowsItsSchemaAndThePageIsWellFormed) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "atlas.json", stability_json(atlas()));
  EXPECT_THAT(
      run_python("validate.py", {source_path("docs/schemas/stability-1.schema.json"), folder / "atlas.json"}),
      testing::ElementsAre("valid"));
  const std::string page = stability_page(atlas());
  write_file_atomically(folder / "atlas.html", page);
  EXPECT_THAT(run_python("well_formed.py", {folder / "atlas.html"}), testing::ElementsAre("well-formed"));
  EXPECT_THAT(page, HasSubstr("b&lt;i&gt;"));
}

TEST(StabilityReport, TextGroupsWhatIsAlike) {
  StabilityReport report = atlas();
  report.cells.push_back(report.cells[0]);
  report.cells.back().variant = "e";
  EXPECT_THAT(text_stability(report), HasSubstr("right to 0.0001\n      a, e"));
  EXPECT_THAT(text_stability(report), HasSubstr("2 right, 1 refused, 1 wrong, 1 not_applicable"));
}

TEST(StabilityReport, RefusesACellOfNoProbe) {
  StabilityReport report = atlas();
  report.cells[0].probe = "size";
  EXPECT_THROW(probe_of(report, report.cells[0]), InputError);
}

}  // namespace
}  // namespace warpgrain::reports
