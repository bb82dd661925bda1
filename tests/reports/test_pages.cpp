#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file_io.hpp"
#include "reports/html/accuracy_page.hpp"
#include "reports/html/comparison_page.hpp"
#include "reports/html/page.hpp"
#include "reports/html/paper_page.hpp"
#include "reports/html/report_page.hpp"
#include "reports/html/sweep_page.hpp"
#include "reports/metrics.hpp"
#include "run_python.hpp"
#include "sample.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Pages, EscapeWhatHtmlTakesForItself) {
  EXPECT_EQ(html::escape("<a href='x'>\"&\""), "&lt;a href=&#39;x&#39;&gt;&quot;&amp;&quot;");
  EXPECT_EQ(html::escape("a\tb\x01"), "a\tb\xEF\xBF\xBD");
}

TEST(Pages, AreWellFormedWhateverNamesHold) {
  Report report = sample::report();
  report.variant = "<script>alert('&')</script>";
  for (LaunchReport& launch : report.launches) {
    launch.counters.kernel += "<&>";
    launch.counters.branches[0].label = "a < b && \"c\" \x02";
    launch.counters.lines.push_back({"</td>.h", 7, sample::totals(1, 0)});
  }
  SweepIndex sweep = sample::sweep();
  sweep.cases[1].message = "<&>";
  const TemporaryFolder folder;
  write_file_atomically(folder / "report.html", report_page(report));
  write_file_atomically(folder / "sweep.html", sweep_page(sweep));
  Comparison comparison = sample::comparison();
  comparison.only_in_base = {"<&>"};
  write_file_atomically(folder / "comparison.html", comparison_page(comparison));
  write_file_atomically(folder / "paper.html", paper_page(sample::paper()));
  write_file_atomically(folder / "accuracy.html", accuracy_page(sample::accuracy()));
  write_file_atomically(folder / "stability.html", stability_page(sample::stability()));
  write_file_atomically(folder / "changes.html", sweep_page(sweep, &sweep));
  EXPECT_THAT(
      run_python("well_formed.py", {folder / "report.html", folder / "sweep.html", folder / "comparison.html",
                                    folder / "paper.html", folder / "accuracy.html",
                                    folder / "stability.html", folder / "changes.html"}),
      testing::Each("well-formed"));
}

TEST(Pages, NeedNothingFromOutside) {
  for (std::string page :
       {report_page(sample::report()), sweep_page(sample::sweep()), comparison_page(sample::comparison()),
        paper_page(sample::paper()), accuracy_page(sample::accuracy())}) {
    // ECharts names the namespace of SVG, and has functions that load pictures, which its charts here do not
    // have.
    if (const std::size_t scripts = page.rfind("<script>//<![CDATA["); scripts != std::string::npos)
      page.erase(page.find("<script>//<![CDATA["), scripts - page.find("<script>//<![CDATA["));
    EXPECT_THAT(page, AllOf(Not(HasSubstr("http:")), Not(HasSubstr("https:")), Not(HasSubstr("src=")),
                            Not(HasSubstr("url(")), Not(HasSubstr("@import")), Not(HasSubstr("<link"))));
  }
}

TEST(Pages, SayHeadlineNumbersWithDefinitionsAndNcuNames) {
  const std::string page = report_page(sample::report());
  for (const char* key : {"simt_efficiency", "active_lanes", "divergent_branches", "sfu_instructions"}) {
    EXPECT_THAT(page, HasSubstr(html::escape(metric(key).definition)));
    EXPECT_THAT(page, HasSubstr(std::string(metric(key).ncu_metric)));
  }
  EXPECT_THAT(page, HasSubstr("<div class=\"value\">0.812</div>"));
}

// Every heading of a profile's tables says what its column holds, and those that Nsight Compute counts, too,
// what it calls them.
TEST(Pages, HeadingsOfAProfileAreExplained) {
  const std::string page = report_page(sample::report());
  EXPECT_THAT(page, Not(HasSubstr("<th>")));
  EXPECT_THAT(page, Not(HasSubstr("title=\"\"")));
  const std::size_t source = page.find("<table class=\"source\"");
  const std::string head = page.substr(source, page.find("</thead>", source) - source);
  for (const char* key : {"warp_instructions", "active_lanes", "sfu_instructions", "global_load_sectors",
                          "global_store_sectors"})
    EXPECT_THAT(head, HasSubstr(std::string(metric(key).ncu_metric)));
}

TEST(Pages, NameTheSeed) {
  const std::string seed = "<dt>seed</dt><dd><code>7</code></dd>";
  for (const std::string& page : {report_page(sample::report()), sweep_page(sample::sweep()),
                                  paper_page(sample::paper()), accuracy_page(sample::accuracy())})
    EXPECT_THAT(page, HasSubstr(seed));
  Report without = sample::report();
  without.seed.reset();
  EXPECT_THAT(report_page(without), Not(HasSubstr("<dt>seed</dt>")));
}

TEST(Pages, ShowTheWayFromFallingToRest) {
  Report report = sample::report();
  EXPECT_THAT(report_page(report),
              AllOf(HasSubstr("<h2>From falling to rest</h2>"), HasSubstr("<td data-v=\"100\">100</td>")));
  report.samples.clear();
  EXPECT_THAT(report_page(report), Not(HasSubstr("From falling to rest")));
}

TEST(Pages, ShadeTheSourceAndLeaveOutWhatMadeNoInstruction) {
  Report report = sample::report();
  for (LaunchReport& launch : report.launches) launch.source.text += std::string(20, '\n');
  const std::string page = report_page(report);
  EXPECT_THAT(page,
              HasSubstr("<tr><td class=\"heat\" style=\"--h:0.600\">12</td>"
                        "<td class=\"heat\" style=\"--h:0.500\">2.0</td>"
                        "<td><svg class=\"lanes\" data-lanes=\"0,0,12,0,0\" viewBox=\"0 0 5 16\" "
                        "preserveAspectRatio=\"none\"><title>executions "
                        "by active lanes, 0 to 4</title><rect x=\"2\" y=\"0.00\" width=\"0.9\" "
                        "height=\"16.00\"/></svg></td>"
                        "<td class=\"heat\" style=\"--h:1.000\">24</td>"
                        "<td class=\"heat\" style=\"--h:1.000\">12</td><td></td>"
                        "<td class=\"number\">3</td>"
                        "<td class=\"code\">    force[i] = sqrt(overlap) /* &lt;&amp;&gt; */;</td></tr>"));
  EXPECT_THAT(page, HasSubstr("19 lines without instructions"));
}

TEST(Pages, TabulateTheAnswers) {
  const std::string page = report_page(sample::report());
  EXPECT_THAT(page, AllOf(HasSubstr("<h3>What if</h3>"), HasSubstr("sorted:contact test"),
                          HasSubstr("bound, pools of 64"), HasSubstr("the &lt;kernel&gt; has barriers")));
  Report report = sample::report();
  for (LaunchReport& launch : report.launches) launch.counters.what_if.clear();
  EXPECT_THAT(report_page(report), Not(HasSubstr("What if")));
}

TEST(Pages, ShowBasicBlocksAndTheMachine) {
  const std::string page = report_page(sample::report());
  EXPECT_THAT(page, AllOf(HasSubstr("2 of the PTX"), HasSubstr("<td class=\"text\">then</td>"),
                          HasSubstr("<h2>On fermi_c2050</h2>"), HasSubstr("takes 8 times the cycles"),
                          HasSubstr("report.ptx")));
}

TEST(Pages, PredictTimesOnMachinesWithConstants) {
  Report report = sample::report();
  EXPECT_THAT(report_page(report), Not(HasSubstr("Predicted time")));
  report.machine = load_machine("hopper_h100");
  EXPECT_THAT(report_page(report), HasSubstr("Predicted time of all launches: "));
}

TEST(Pages, ShowLinesOfNoSource) {
  Report report = sample::report();
  report.launches.resize(1);
  report.launches[0].counters.lines.push_back({"builtin.h", 70, sample::totals(1, 0)});
  report.launches[0].counters.lines.push_back({"", 0, sample::totals(1, 0)});
  EXPECT_THAT(report_page(report), AllOf(HasSubstr("not in this source"), HasSubstr("builtin.h"),
                                         HasSubstr("instructions without a line")));
}

TEST(Pages, StateTheLimits) {
  const std::string page = report_page(sample::report());
  for (const std::string& limit : simulator_limits()) EXPECT_THAT(page, HasSubstr(html::escape(limit)));
}

TEST(Pages, SweepsLinkToTheirReportsAndSayWhatFailed) {
  const std::string page = sweep_page(sample::sweep());
  EXPECT_THAT(page, HasSubstr("href=\"branchy_cells_cell_fp32_default.html\""));
  EXPECT_THAT(page, HasSubstr("failed: step 12: particle 7 left the domain"));
}

}  // namespace
}  // namespace warpgrain::reports
