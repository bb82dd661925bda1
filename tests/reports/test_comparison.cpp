#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/benchmark_json.hpp"
#include "reports/comparison.hpp"
#include "reports/report_json.hpp"
#include "sample.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const KernelQuantities& kernel(const std::vector<KernelQuantities>& all, const std::string& name) {
  return *std::ranges::find(all, name, &KernelQuantities::kernel);
}

TEST(Comparison, ReadsEveryKindOfDocument) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "r.json", report_json(sample::report()));
  write_file_atomically(folder / "m.json", measured_json(sample::measured()));
  write_file_atomically(folder / "b.json", benchmark_json(sample::measured()));
  write_file_atomically(folder / "n.csv",
                        "\"ID\",\"Kernel Name\",\"smsp__inst_executed.sum\"\n\"0\",\"force\",\"60\"\n\"1\","
                        "\"force\",\"40\"\n");
  const auto report = quantities_of(folder / "r.json"), measured = quantities_of(folder / "m.json");
  EXPECT_EQ(kernel(report, "force").values.at("launches"), 2);
  EXPECT_EQ(kernel(report, "force").values.count("active_lanes"), 1u);
  EXPECT_EQ(kernel(measured, "force").values.at("warp_instructions"), 12345);
  EXPECT_DOUBLE_EQ(kernel(measured, "force").values.at("seconds"), 1.5e-4);
  EXPECT_DOUBLE_EQ(kernel(measured, "step").values.at("seconds"), 1.25e-3);
  EXPECT_DOUBLE_EQ(kernel(quantities_of(folder / "b.json"), "step").values.at("seconds"), 1.25e-3);
  EXPECT_EQ(kernel(quantities_of(folder / "n.csv"), "force").values.at("warp_instructions"), 100);
  write_file_atomically(folder / "x.json", R"({"format": "warpgrain.scene/1"})");
  EXPECT_THROW(quantities_of(folder / "x.json"), InputError);
  write_file_atomically(folder / "y", "\n");
  EXPECT_THROW(quantities_of(folder / "y"), InputError);
}

TEST(Comparison, DifferencesAreThoseFromTheBase) {
  const Comparison comparison =
      compare({{"a", {{"warp_instructions", 100}, {"seconds", 2}, {"branches", 0}}}, {"b", {}}},
              {{"c", {}}, {"a", {{"warp_instructions", 110}, {"branches", 3}, {"sfu_instructions", 9}}}}, {});
  ASSERT_EQ(comparison.differences.size(), 2u);
  EXPECT_EQ(comparison.differences[0].metric, "warp_instructions");
  EXPECT_NEAR(*comparison.differences[0].relative(), 0.1, 1e-12);
  EXPECT_FALSE(comparison.differences[1].relative());
  EXPECT_THAT(comparison.only_in_base, ElementsAre("b"));
  EXPECT_THAT(comparison.only_in_other, ElementsAre("c"));
  EXPECT_TRUE(largest_difference(comparison) > 1e300);
  EXPECT_THAT(text_comparison(comparison), HasSubstr("+10.00 %"));
  EXPECT_THAT(comparison_json(comparison), HasSubstr("\"only_in_other\""));
}

TEST(Comparison, CountsOnlyWhatIsAskedFor) {
  const std::vector<KernelQuantities> a{{"k", {{"warp_instructions", 4}, {"branches", 1}}}},
      b{{"k", {{"warp_instructions", 4}, {"branches", 2}}}};
  const std::vector<std::string> wanted{"warp_instructions"};
  EXPECT_EQ(largest_difference(compare(a, b, wanted)), 0);
  EXPECT_EQ(largest_difference(compare(a, b, {})), 1);
  const std::vector<std::string> unknown{"warps"};
  EXPECT_THROW(compare(a, b, unknown), InputError);
}

TEST(Comparison, SweepsAreOrdered) {
  SweepIndex sweep;
  std::vector<MeasuredReport> measured;
  for (const auto& [variant, instructions, seconds] :
       {std::tuple{"x", 100u, 2e-3}, {"y", 200u, 1e-3}, {"z", 300u, 4e-3}, {"unmeasured", 7u, 0.0}}) {
    SweepCase& sweep_case = sweep.cases.emplace_back();
    sweep_case.variant = variant;
    sweep_case.headline.emplace().warp_instructions = instructions;
    if (seconds == 0) continue;
    MeasuredReport& m = measured.emplace_back(sample::measured());
    m.variant = variant;
    m.step->seconds = {seconds, 1.1 * seconds};
  }
  const OrderComparison order = compare_order(sweep, measured);
  ASSERT_EQ(order.rows.size(), 3u);
  EXPECT_NEAR(*order.tau, 1.0 / 3, 1e-12);
  EXPECT_NEAR(order.interval->lower, 1.0 / 3, 1e-12);
  Comparison comparison;
  comparison.order = order;
  EXPECT_THAT(text_comparison(comparison), HasSubstr("Kendall's tau of warp instructions: 0.333"));
  EXPECT_FALSE(order.error) << "counts are no times";

  for (const auto& [k, seconds] : {std::pair{0u, 2e-3}, {1u, 1.5e-3}, {2u, 5e-3}})
    sweep.cases[k].headline->predicted_seconds = seconds;
  comparison.order = compare_order(sweep, measured);
  EXPECT_DOUBLE_EQ(*comparison.order->tau, 1);
  EXPECT_NEAR(comparison.order->error->largest, 1.5 / 1.05 - 1, 1e-9) << "of the median reading, 1.05 ms";
  EXPECT_THAT(text_comparison(comparison), HasSubstr("Kendall's tau of predicted times: 1.000"));
  EXPECT_THAT(comparison_json(comparison), HasSubstr("\"median_time_error\""));
  measured.resize(1);
  EXPECT_THROW(compare_order(sweep, measured), InputError);
}

}  // namespace
}  // namespace warpgrain::reports
