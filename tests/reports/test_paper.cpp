// The rows of a paper report, its JSON and its text.

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/paper_rows.hpp"
#include "run_python.hpp"
#include "tests/paths.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

PaperReport report_of_facts() {
  PaperReport report;
  report.generator = this_generator();
  report.scene = "slit";
  report.particles = 1000;
  report.samples.push_back({0, 0, 20, 0.1, 30, 3, {{"force", 1000, 0.9}}});
  report.samples.push_back({100, 0.5, 25, 5, 45, 13, {{"force", 2000, 0.25}, {"sort", 10, 1}}});
  report.paths.push_back({"force", "law.cl", 12, 5, 4000, 9, 0.75});
  PaperFacts facts;
  facts.particles = 1000;
  facts.paper_machine = load_machine("fermi_c2050");
  facts.machine = load_machine("hopper_h100");
  profiler::LaunchCounters force;
  force.kernel = "force";
  force.totals.warp_instructions = 161'000;  // 10 us on 14 multiprocessors of 1.15 GHz
  force.totals.thread_instructions = 161'000 * 8;
  force.totals.sfu_instructions = 1'610;
  force.totals.instruction_mix[static_cast<std::size_t>(profiler::InstructionClass::special_function)]
      .thread = 40'000;
  facts.practical = {32, {force}};
  force.totals.warp_instructions /= 2;
  facts.simple = {32, {force}};
  facts.timings = {
      {true, "opencl", 2e6, "here: a"}, {true, "host", 1e6, "here: b"}, {false, "opencl", 6e6, "x.json: c"}};
  add_paper_rows(report, facts);
  return report;
}

const PaperReport::Row& row(const PaperReport& report, std::string_view quantity) {
  return *std::ranges::find(report.rows, quantity, &PaperReport::Row::quantity);
}

TEST(PaperReport, RowsFollowFromTheFacts) {
  const PaperReport report = report_of_facts();
  const auto& practical = row(report, "practical model, OpenCL");
  EXPECT_EQ(*practical.paper, 2.96e6);
  EXPECT_NEAR(*practical.simulated, 1e8, 1);  // 1000 particles in 10 us
  ASSERT_EQ(practical.measured.size(), 1U);
  EXPECT_EQ(practical.measured[0].value, 2e6);
  EXPECT_NEAR(*row(report, "simple / practical, OpenCL").simulated, 2, 1e-9);
  EXPECT_EQ(row(report, "simple / practical, OpenCL").measured[0].value, 3);
  EXPECT_EQ(row(report, "practical, OpenCL / C++").measured[0].value, 2);
  EXPECT_TRUE(row(report, "simple, OpenCL / CUDA").measured.empty());
  EXPECT_EQ(*row(report, "candidates, worst case").simulated, 45);
  EXPECT_EQ(*row(report, "share of candidates that touch").simulated, 0.2);
  EXPECT_EQ(*row(report, "loss to contacts that are not there").simulated, 4);
  EXPECT_EQ(*row(report, "speed-up of a warp, 32 / M").simulated, 8);
  EXPECT_EQ(*row(report, "paths through N branches, 2^N").model, 32);
  EXPECT_EQ(*row(report, "paths through N branches, 2^N").simulated, 9);
  EXPECT_EQ(*row(report, "SFU calls a contact").simulated, 8);  // 40,000 over 5 contacts of 1000 particles
  EXPECT_NEAR(*row(report, "practical model on fermi_c2050").simulated, 0.01, 1e-12);
}

TEST(PaperReport, JsonFollowsItsSchemaAndTextNamesEveryRow) {
  const PaperReport report = report_of_facts();
  const TemporaryFolder folder;
  write_file_atomically(folder / "paper.json", paper_json(report));
  EXPECT_THAT(
      run_python("validate.py", {source_path("docs/schemas/paper-1.schema.json"), folder / "paper.json"}),
      testing::ElementsAre("valid"));
  const std::string text = text_paper(report);
  for (const PaperReport::Row& each : report.rows) EXPECT_THAT(text, testing::HasSubstr(each.quantity));
  EXPECT_THAT(text, testing::HasSubstr("law.cl:12"));
}

TEST(PaperReport, RefusesNumbersThatAreNone) {
  PaperReport report = report_of_facts();
  report.samples[0].mean_contacts = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(paper_json(report), InputError);
}

}  // namespace
}  // namespace warpgrain::reports
