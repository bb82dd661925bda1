// Diagnostics in every form of a report.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file_io.hpp"
#include "reports/diagnostic_summary.hpp"
#include "reports/html/report_page.hpp"
#include "reports/report_json.hpp"
#include "reports/text_report.hpp"
#include "run_python.hpp"
#include "sample.hpp"
#include "tests/paths.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using profiler::Diagnostic;
using profiler::DiagnosticKind;
using testing::ElementsAre;
using testing::HasSubstr;

// One of every kind, with every part that a kind can have.
std::vector<Diagnostic> one_of_each() {
  std::vector<Diagnostic> all;
  for (std::size_t k = 0; k < static_cast<std::size_t>(DiagnosticKind::count); ++k) {
    Diagnostic d;
    d.kind = static_cast<DiagnosticKind>(k);
    d.place = {"contact/law.cl", 3, static_cast<std::uint32_t>(40 + k)};
    d.work_item = {k, 2, 1};
    d.work_group = {0, 1, 0};
    d.count = k + 1;
    if (k < static_cast<std::size_t>(DiagnosticKind::barrier_divergence)) {
      d.access = "store";
      d.space = "global";
      d.bytes = 4;
      d.buffer = "force <&>";
      d.offset = -4;
      d.buffer_bytes = 256;
    } else {
      d.detail = "it ran the trap";
    }
    if (d.kind == DiagnosticKind::data_race) d.other = {{"law.cl", 9, 12}, "load", {{1, 2, 3}}};
    if (d.kind == DiagnosticKind::subvector_race) d.other = {{"", 0, 12}, "atomic", std::nullopt};
    all.push_back(d);
  }
  return all;
}

Report wrong_report() {
  Report report = sample::report();
  report.launches[1].counters.diagnostics = one_of_each();
  report.launches[2].counters.diagnostics = {one_of_each()[0]};
  report.launches[2].counters.given_up = true;
  return report;
}

TEST(Diagnostics, ComeBackFromJsonAndFitTheSchema) {
  const Report report = wrong_report();
  const TemporaryFolder folder;
  write_file_atomically(folder / "r.json", report_json(report));
  const Report read = read_report(folder / "r.json");
  for (std::size_t k = 0; k < report.launches.size(); ++k) {
    EXPECT_EQ(read.launches[k].counters.diagnostics, report.launches[k].counters.diagnostics);
    EXPECT_EQ(read.launches[k].counters.given_up, report.launches[k].counters.given_up);
  }
  EXPECT_THAT(
      run_python("validate.py", {source_path("docs/schemas/report-1.schema.json"), folder / "r.json"}),
      ElementsAre("valid"));
}

TEST(Diagnostics, LinesAddUpOverLaunches) {
  const auto lines = diagnostic_lines(wrong_report());
  ASSERT_EQ(lines.size(), static_cast<std::size_t>(DiagnosticKind::count) + 1);
  EXPECT_EQ(
      lines[0],
      "contact/law.cl:3 (PTX line 40): out_of_bounds: store of 4 bytes to global memory, 'force <&>' at byte "
      "-4 of 256, work-item (0, 2, 1) in work-group (0, 1, 0); 2 times");
  EXPECT_THAT(
      lines, testing::Contains(HasSubstr("after the load by work-item (1, 2, 3) at law.cl:9 (PTX line 12)")));
  EXPECT_THAT(lines, testing::Contains(HasSubstr("after the atomic by another one at PTX line 12")));
  EXPECT_EQ(lines.back(), "kernel 'force': the launch was given up, too many work-items had to be stopped");
  EXPECT_TRUE(diagnostic_lines(sample::report()).empty());
}

TEST(Diagnostics, StandInTextAndPage) {
  const Report report = wrong_report();
  EXPECT_THAT(text_report(report),
              HasSubstr("\nWhat is wrong with the kernels\n  contact/law.cl:3 (PTX line 40)"));
  const std::string page = report_page(report);
  EXPECT_THAT(page,
              HasSubstr("out_of_bounds: store of 4 bytes to global memory, &#39;force &lt;&amp;&gt;&#39;"));
  const TemporaryFolder folder;
  write_file_atomically(folder / "r.html", page);
  EXPECT_THAT(run_python("well_formed.py", {folder / "r.html"}), ElementsAre("well-formed"));
  EXPECT_THAT(text_report(sample::report()), testing::Not(HasSubstr("What is wrong")));
}

}  // namespace
}  // namespace warpgrain::reports
