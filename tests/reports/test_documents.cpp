// The formats, written and read back, and what their readers refuse.

#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/report_json.hpp"
#include "sample.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

// Writes `text`, reads it with `read` and writes what was read: the same bytes.
template <class Read, class Write>
std::string round_trip(const std::string& text, Read read, Write write) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "document.json", text);
  return write(read(folder / "document.json"));
}

TEST(Documents, ReportsSurviveARoundTrip) {
  const std::string text = report_json(sample::report());
  EXPECT_EQ(round_trip(text, read_report, report_json), text);
}

TEST(Documents, RunsSurviveARoundTrip) {
  const std::string text = run_json(sample::run());
  EXPECT_EQ(round_trip(text, read_run, run_json), text);
}

TEST(Documents, MeasurementsSurviveARoundTrip) {
  const std::string text = measured_json(sample::measured());
  EXPECT_EQ(round_trip(text, read_measured, measured_json), text);
}

TEST(Documents, SweepsSurviveARoundTrip) {
  const std::string text = sweep_json(sample::sweep());
  EXPECT_EQ(round_trip(text, read_sweep, sweep_json), text);
}

TEST(Documents, PapersSurviveARoundTrip) {
  const std::string text = paper_json(sample::paper());
  EXPECT_EQ(round_trip(text, read_paper, paper_json), text);
}

TEST(Documents, ComparisonsSurviveARoundTrip) {
  Comparison comparison = sample::comparison();
  EXPECT_EQ(round_trip(comparison_json(comparison), read_comparison, comparison_json),
            comparison_json(comparison));
  comparison.order.emplace();
  comparison.order->by_time = true;
  comparison.order->rows = {{"a/b", 100, 1e-3, 1.1e-3}};
  comparison.order->tau = 0.5;
  comparison.order->interval = {0.25, 0.75};
  comparison.order->error = {0.125, 0.5};
  comparison.order->left_out = {{0.25, 0.5}, {0.125, 0.25}};
  EXPECT_EQ(round_trip(comparison_json(comparison), read_comparison, comparison_json),
            comparison_json(comparison));
}

TEST(Documents, TheTextOfASourceStandsOnce) {
  const Json report = Json::parse(report_json(sample::report()));
  EXPECT_TRUE(report["launches"][0]["source"].contains("text"));
  EXPECT_FALSE(report["launches"][1]["source"].contains("text"));
  EXPECT_EQ(report["launches"][1]["source"]["hash"], report["launches"][0]["source"]["hash"]);
}

TEST(Documents, RunRateIsThePapersParticlesPerSecond) {
  EXPECT_DOUBLE_EQ(sample::run().particle_steps_per_second(), 200'000);
  RunReport run;
  EXPECT_EQ(run.particle_steps_per_second(), 0) << "no steps";
}

TEST(Documents, ReportsSayWhatFollowsFromTheirCounts) {
  const Json launch = Json::parse(report_json(sample::report()))["launches"][0];
  EXPECT_EQ(launch["branches"][0]["loss_share"], 1.0);
  EXPECT_EQ(launch["branches"][0]["lane_histogram"], launch["blocks"][0]["lane_histogram"]);
  EXPECT_EQ(launch["blocks"][1]["lane_slots_idle"], 2 * 2 * 3);
  EXPECT_EQ(launch["lines"][1]["lane_slots_idle"], 12);
  const Json& totals = launch["totals"];
  EXPECT_EQ(totals["global_load_sectors_per_request"], 3.0);
  EXPECT_EQ(totals["global_load_lines_per_request"], 2.0);
  EXPECT_DOUBLE_EQ(totals["global_load_efficiency"], 16.0 / (3 * 32));
  EXPECT_FALSE(totals.contains("global_store_efficiency")) << "there are no stores";
}

TEST(Documents, ReportsSayWhatSpecialFunctionsCostOnTheMachine) {
  Report report = sample::report();
  const Json json = Json::parse(report_json(report));
  EXPECT_EQ(json["machine"]["name"], "fermi_c2050");
  EXPECT_EQ(json["machine"]["sfu_lanes"]["value"], 4);
  const Json& sfu = json["launches"][0]["sfu"];
  EXPECT_EQ(sfu["instructions"], 6);
  EXPECT_EQ(sfu["serialisation"], 8);
  EXPECT_EQ(sfu["cycles"], 6 * sample::warp_width / 4);
  EXPECT_EQ(sfu["issue_cycles"], 16);
  report.machine.reset();
  EXPECT_FALSE(Json::parse(report_json(report))["launches"][0].contains("sfu"));
}

TEST(Documents, ReportsPredictTimesOnMachinesWithConstants) {
  Report report = sample::report();
  EXPECT_FALSE(Json::parse(report_json(report))["launches"][0].contains("predicted"));
  EXPECT_FALSE(headline_of(kernels_of(report)).predicted_seconds);
  report.machine = load_machine("hopper_h100");
  const Json json = Json::parse(report_json(report));
  double sum = 0;
  for (const Json& launch : json["launches"]) sum += launch["predicted"]["seconds"].get<double>();
  EXPECT_GT(json["launches"][0]["predicted"]["seconds"], json["launches"][0]["predicted"]["start"]);
  EXPECT_DOUBLE_EQ(*headline_of(kernels_of(report)).predicted_seconds, sum);
  // A launch of its own has nothing before it that hides its start.
  report.scene.reset();
  EXPECT_GT(Json::parse(report_json(report))["launches"][0]["predicted"]["start"],
            json["launches"][0]["predicted"]["start"]);
  const TemporaryFolder folder;
  write_file_atomically(folder / "r.json", report_json(report));
  EXPECT_EQ(report_json(read_report(folder / "r.json")), report_json(report));
}

TEST(Documents, AnswersHoldWhatIsKnown) {
  const Json what_if = Json::parse(report_json(sample::report()))["launches"][0]["what_if"];
  EXPECT_TRUE(what_if[0]["totals"].contains("global_load_sectors"));
  EXPECT_FALSE(what_if[0].contains("pool"));
  EXPECT_FALSE(what_if[1]["totals"].contains("global_load_sectors"));
  EXPECT_EQ(what_if[1]["order"], "sorted:contact test");
  EXPECT_FALSE(what_if[2].contains("policy"));
  EXPECT_FALSE(what_if[2]["totals"].contains("lane_histogram"));
  EXPECT_EQ(what_if[2]["totals"]["simt_efficiency"], 1.0);
}

TEST(Documents, NanIsAnErrorNotNull) {
  RunReport run = sample::run();
  run.energy[1].elastic = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(run_json(run), InputError);
}

// The message with which read_report refuses the sample after `damage`.
std::string refusal(const std::function<void(Json&)>& damage) {
  Json document = Json::parse(report_json(sample::report()));
  damage(document);
  const TemporaryFolder folder;
  write_file_atomically(folder / "document.json", document.dump());
  try {
    read_report(folder / "document.json");
  } catch (const InputError& e) {
    return e.what();
  }
  return "not refused";
}

TEST(Documents, ReadersNameThePlaceOfWhatIsWrong) {
  EXPECT_THAT(refusal([](Json& d) { d["launches"][1]["totals"].erase("branches"); }),
              HasSubstr("document.json: launches[1].totals: 'branches' is missing"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["warps"] = -1; }),
              HasSubstr("launches[0].warps: -1; expected a whole number"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["totals"]["lane_histogram"].push_back(1); }),
              HasSubstr("lane_histogram: 6 entries; expected 5"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["totals"]["instruction_mix"].erase("fp32"); }),
              HasSubstr("instruction_mix: adds up to 6 warp and 12 thread instructions; expected 16 and 52"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["totals"]["lane_histogram"][0] = 1; }),
              HasSubstr("lane_histogram: adds up to 17 warp and 52 thread instructions; expected 16 and 52"));
  EXPECT_THAT(refusal([](Json& d) {
                d["launches"][0]["local_size"] = {8, 1, 0};
              }),
              HasSubstr("launches[0].local_size: no size; expected three sizes of at least 1"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["branches"][0]["line"] = 1ull << 32; }),
              HasSubstr("branches[0].line: 4294967296; expected less than 2^32"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["warp_width"] = 65; }),
              HasSubstr("launches[0].warp_width: 65; expected 1 to 64"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["what_if"][0].erase("policy"); }),
              HasSubstr("launches[0].what_if[0]: 'policy' is missing"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["what_if"][1]["totals"]["thread_instructions"] = 1; }),
              HasSubstr("what_if[1].totals.lane_histogram: adds up to"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["branches"][0]["block"] = 2; }),
              HasSubstr("launches[0].branches: a branch of block 2; expected less than 2 blocks"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"][0]["source"].erase("text"); }),
              HasSubstr("launches[0].source: 'text' is missing"));
  EXPECT_THAT(refusal([](Json& d) { d["launches"] = 7; }), HasSubstr("launches: 7; expected an array"));
}

TEST(Documents, ReadersTellFormatsAndVersionsApart) {
  EXPECT_THAT(refusal([](Json& d) { d.erase("format"); }), HasSubstr("document.json: 'format' is missing"));
  EXPECT_THAT(refusal([](Json& d) { d["format"] = "warpgrain.report/2"; }),
              HasSubstr("format: 'warpgrain.report/2'; expected 'warpgrain.report/1'"));
}

TEST(Documents, WhatIsNoJsonIsRefusedWithItsLine) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "cut.json", "{\n \"format\": \"warpgrain.run/1\",\n");
  try {
    read_run(folder / "cut.json");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("cut.json: line 3"));
  }
  EXPECT_THROW(read_sweep(folder / "absent.json"), InputError);
}

TEST(Documents, SweepStatusesAreThree) {
  Json document = Json::parse(sweep_json(sample::sweep()));
  document["cases"][0]["status"] = "fine";
  const TemporaryFolder folder;
  write_file_atomically(folder / "index.json", document.dump());
  try {
    read_sweep(folder / "index.json");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("cases[0].status: unknown status 'fine'; valid: done, failed, skipped"));
  }
}

}  // namespace
}  // namespace warpgrain::reports
