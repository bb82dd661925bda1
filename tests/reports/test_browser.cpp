// Pages in a browser: headless Chromium loads each, a script does what a reader does, and what it finds
// stands in the document that is printed. Skipped where there is no Chromium, or the build had no ECharts.

#include <cstdio>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "reports/html/charts.hpp"
#include "reports/html/report_page.hpp"
#include "reports/html/sweep_page.hpp"
#include "sample.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

class Browser : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium >/dev/null 2>&1") != 0) GTEST_SKIP() << "no chromium";
    if (html::echarts_script().empty()) GTEST_SKIP() << "no ECharts in this build";
  }

  // The document after `script` has run in it; its title says of errors before.
  std::string dom_after(std::string page, const std::string& script) const {
    const TemporaryFolder folder;
    page.insert(page.rfind("</body>"),
                "<script>document.body.dataset.found = (function () {" + script + "})();</script>");
    page.insert(
        page.find("<title>"),
        "<script>window.onerror = function (message) { document.title = 'error: ' + message; };</script>");
    std::ofstream(folder / "page.html") << page;
    const std::string command =
        "timeout 60 chromium --headless --no-sandbox --disable-gpu --user-data-dir='" +
        (folder / "profile").string() + "' --dump-dom 'file://" + (folder / "page.html").string() +
        "' 2>/dev/null";
    std::string dom;
    FILE* output = popen(command.c_str(), "r");
    if (output == nullptr) return dom;
    for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output)) dom += static_cast<char>(c);
    EXPECT_EQ(pclose(output), 0) << command;
    EXPECT_THAT(dom, Not(HasSubstr("<title>error"))) << dom.substr(0, dom.find("</title>"));
    return dom;
  }
};

TEST_F(Browser, SweepsAreDrawnFilteredAndSorted) {
  SweepIndex sweep = sample::sweep();
  for (int k = 0; k < 9; ++k) {
    SweepCase other = sweep.cases[0];
    other.variant = "case/" + std::to_string(k);
    other.axes["contact"] = k % 2 == 0 ? "even" : "odd";
    other.headline->warp_instructions = static_cast<std::uint64_t>(100 + 10 * ((k * 7) % 9));
    sweep.cases.push_back(other);
  }
  const std::string dom = dom_after(sweep_page(sweep), R"(
    const charts = Array.from(document.querySelectorAll("div.chart")).filter(c => c.querySelector("svg path")).length;
    const field = document.querySelector("input[type=search]");
    field.value = "case/3";
    field.dispatchEvent(new Event("input"));
    const rows = Array.from(document.querySelectorAll("table.sortable tbody tr")).filter(r => !r.hidden).length;
    field.value = "case";
    field.dispatchEvent(new Event("input"));
    const heading = Array.from(document.querySelectorAll("th")).find(h => h.textContent.includes("warp instructions"));
    heading.click();
    const cells = Array.from(document.querySelectorAll("table.sortable tbody tr")).filter(r => !r.hidden)
      .map(r => Number(r.cells[heading.cellIndex].dataset.v));
    const sorted = cells.every((v, k) => k === 0 || cells[k - 1] >= v);
    const select = document.querySelector("select[aria-label='x axis']");
    select.selectedIndex = 0;
    select.dispatchEvent(new Event("change"));
    return [charts, rows, cells.length, sorted].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"2 1 9 true\""));
}

TEST_F(Browser, ReportsShowTheLanesOfALineThatIsClicked) {
  const std::string dom = dom_after(report_page(sample::report()), R"(
    const row = document.querySelector("table.source tr.opens");
    row.click();
    const opened = row.nextElementSibling.querySelectorAll("svg path").length > 0;
    row.click();
    return [opened, row.nextElementSibling.classList.contains("lanes")].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"true false\""));
}

TEST_F(Browser, WhatIfAnswersAreDrawnByWidth) {
  Report report = sample::report();
  for (LaunchReport& launch : report.launches) {
    profiler::WhatIfTotals answer;
    answer.warp_width = 8;
    answer.policy = "loop_postdom";
    answer.order = "launched";
    answer.totals = launch.counters.totals;
    launch.counters.what_if.push_back(answer);
  }
  const std::string dom =
      dom_after(report_page(report), R"(return document.querySelectorAll("div.chart svg path").length > 0;)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"true\""));
}

}  // namespace
}  // namespace warpgrain::reports
