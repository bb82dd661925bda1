// Pages in a browser: headless Chromium loads each, a script does what a reader does, and what it finds
// stands in the document that is printed. Skipped where there is no Chromium, or the build had no ECharts.

#include <cstdio>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "reports/html/accuracy_page.hpp"
#include "reports/html/charts.hpp"
#include "reports/html/comparison_page.hpp"
#include "reports/html/paper_page.hpp"
#include "reports/html/report_page.hpp"
#include "reports/html/sweep_page.hpp"
#include "reports/stability_report.hpp"
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
    page.insert(
        page.rfind("</body>"),
        "<script>if (typeof warpgrain !== 'undefined' && warpgrain.draw_charts) warpgrain.draw_charts();\n"
        "document.body.dataset.found = (function () {" +
            script + "})();</script>");
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
  EXPECT_THAT(dom, HasSubstr("data-found=\"3 1 9 true\""));
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

TEST_F(Browser, ProfilesDrawTheWayFromFallingToRest) {
  const std::string dom = dom_after(report_page(sample::report()), R"(
    const charts = Array.from(document.querySelectorAll("div.chart[data-kind=xy]"));
    const chart = charts.find(c => c.dataset.title.startsWith("SIMT efficiency of the kernels"));
    const buttons = Array.from(chart.nextElementSibling.querySelectorAll("button")).map(b => b.textContent).join("");
    const texts = Array.from(chart.querySelectorAll("svg text")).map(t => t.textContent);
    return [charts.length, chart.rows.length, chart.rows[2].join("/"), buttons, texts.includes("time [s]")].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"2 3 force/step 100/0.1/0.3// SVGPNGCSV true\""));
}

TEST_F(Browser, SweepsDrawEachCaseFromFallingToRest) {
  SweepIndex sweep = sample::sweep();
  sweep.cases.push_back(sweep.cases[0]);
  sweep.cases[2].variant = "other";
  const std::string dom = dom_after(sweep_page(sweep), R"(
    const chart = document.querySelector("div.chart[data-kind=xy]");
    return [chart.rows.length, chart.rows[4].join("/"), chart.querySelectorAll("svg path").length > 3].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"5 other/step 4,000/0.04/0.25// true\""));
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

// What a canvas shows: how many of its points have a colour, and that they change.
constexpr const char* canvas_tools = R"(
  const shown = canvas => { const d = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    let sum = 0; for (let k = 0; k < d.length; k += 4) sum += d[k + 3] > 0 ? d[k] + 2 * d[k + 1] + 3 * d[k + 2] : 0; return sum; };
  const point = (canvas, type, x, y) => { const at = canvas.getBoundingClientRect();
    canvas.dispatchEvent(new PointerEvent(type, {clientX: at.left + x, clientY: at.top + y, bubbles: true, pointerId: 1})); };
)";

TEST_F(Browser, TimelinesAreDrawnAndSayWhatIsPointedAt) {
  const std::string dom = dom_after(report_page(sample::report()), canvas_tools + std::string(R"(
    const element = document.querySelector("div.timeline"), canvas = element.querySelector("canvas");
    const text = () => element.querySelector(".readout").textContent;
    const cut = text().startsWith("Cut: the first 3 of 5");
    const whole = shown(canvas);
    point(canvas, "pointermove", canvas.clientWidth * 0.5, 60);
    const said = text().includes("2 of 3: 2 of 4 lanes") && text().includes("then") && text().includes("law.cl:3");
    element.querySelector("select[aria-label='width of a column']").value = "1";
    element.querySelector("select[aria-label='width of a column']").dispatchEvent(new Event("change"));
    const wider = shown(canvas);
    point(canvas, "click", canvas.clientWidth * 0.9, 60);
    const found = document.querySelector("table.source tr.found");
    return [cut, whole > 0, said, wider !== whole, found && found.querySelector(".number").textContent].join(" ");)"));
  EXPECT_THAT(dom, HasSubstr("data-found=\"true true true true 3\""));
}

TEST_F(Browser, TheBedIsTurnedCutAndAsked) {
  const std::string dom = dom_after(report_page(sample::report()), canvas_tools + std::string(R"(
    const element = document.querySelector("div.bed"), canvas = element.querySelector("canvas");
    const text = () => element.querySelector(".readout").textContent;
    const whole = shown(canvas);
    const choice = element.querySelector("select[aria-label=colour]");
    choice.value = "contacts";
    choice.dispatchEvent(new Event("change"));
    const recoloured = shown(canvas);
    const legend = element.querySelector(".legend").textContent.includes("coordination");
    const axis = element.querySelector("select[aria-label='cut along']");
    axis.value = "0";
    axis.dispatchEvent(new Event("change"));
    // Somewhere on the way across the canvas stands a particle.
    let said = "";
    for (let y = 0; y < canvas.clientHeight && !said.includes("candidates"); y += 4)
      for (let x = 0; x < canvas.clientWidth && !said.includes("candidates"); x += 4) { point(canvas, "pointermove", x, y); said = text(); }
    return [whole > 0, recoloured !== whole, legend, /[012] contacts, [345] candidates; warp [01] of force/.test(said)].join(" ");)"));
  EXPECT_THAT(dom, HasSubstr("data-found=\"true true true true\""));
}

TEST_F(Browser, ComparisonsAreDrawnByMetricAndOrder) {
  Comparison comparison = sample::comparison();
  const std::string dom = dom_after(comparison_page(comparison), R"(
    const chart = () => Array.from(document.querySelectorAll("div.chart svg text")).map(t => t.textContent);
    const before = chart().includes("sort");
    const choice = document.querySelector("select[aria-label=metric]");
    choice.value = "branches";
    choice.dispatchEvent(new Event("change"));
    const named = document.querySelector("td span[title*='smsp__']") !== null;
    return [before, chart().includes("sort"), chart().includes("force"), named].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"true false true true\""));
  comparison.order.emplace();
  comparison.order->by_time = true;
  comparison.order->rows = {{"a/b", 100, 1e-3, 1.1e-3}, {"c/d", 300, 3e-3, 2.5e-3}};
  EXPECT_THAT(dom_after(comparison_page(comparison),
                        R"(return document.querySelectorAll("div.chart svg path").length > 2;)"),
              HasSubstr("data-found=\"true\""));
}

TEST_F(Browser, ThePaperIsDrawnOverTime) {
  const std::string dom = dom_after(paper_page(sample::paper()), R"(
    const charts = Array.from(document.querySelectorAll("div.chart")).filter(c => c.querySelector("svg path")).length;
    return [charts, document.body.textContent.includes("here: a device"), document.querySelectorAll("p.exports button").length].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"4 true 12\""));
}

TEST_F(Browser, AccuracyIsDrawnAsAFrontAndAsIntervals) {
  const std::string dom = dom_after(accuracy_page(sample::accuracy()), R"(
    const charts = Array.from(document.querySelectorAll("div.chart")).filter(c => c.querySelector("svg path")).length;
    const select = document.querySelector("select[aria-label='y axis']");
    const chosen = select.options[select.selectedIndex].textContent;
    return [charts, chosen, document.querySelectorAll("li").length].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"2 force error, rms 3\""));
}

TEST_F(Browser, SweepsSayWhatChanged) {
  SweepIndex before = sample::sweep(), now = before;
  now.cases[0].headline->warp_instructions *= 2;
  const std::string dom = dom_after(sweep_page(now, &before), R"(
    const table = Array.from(document.querySelectorAll("h2")).find(h => h.textContent === "What changed").parentElement;
    return [table.textContent.includes("+100.00 %"), table.textContent.includes("same")].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"true true\""));
}

TEST_F(Browser, StabilityIsSortedByAProbe) {
  const std::string dom = dom_after(stability_page(sample::stability()), R"(
    const heading = Array.from(document.querySelectorAll("th")).find(h => h.textContent === "speed");
    heading.click();
    const first = document.querySelector("table.sortable tbody tr td").textContent;
    return [first, document.querySelector("td span[title]").title.length > 0].join(" ");)");
  EXPECT_THAT(dom, HasSubstr("data-found=\"case/2 true\""));
}

}  // namespace
}  // namespace warpgrain::reports
