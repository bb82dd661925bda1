// `warpgrain stability` as a user calls it, and its probes against what is known of the models.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "../reports/run_python.hpp"
#include "cli/probes/probes.hpp"
#include "cli/stability_atlas.hpp"
#include "command_fixture.hpp"
#include "core/error.hpp"
#include "reports/stability_report.hpp"
#include "tests/paths.hpp"

namespace warpgrain::cli {
namespace {

using Stability = CommandTest;
using reports::Verdict;
using testing::HasSubstr;

ProbeBench host_bench(std::string_view precision, std::string_view law = "branchy") {
  Variant variant;
  variant.set("contact", law);
  variant.set("precision", precision);
  return {backend("host"), variant, {}, 200};
}

// Every row begins where everything is right, in both models and precisions that have it: else its limits
// would say nothing.
TEST(StabilityProbes, BeginWhereTheDoubleReferenceIsRight) {
  for (const Probe& probe : probes())
    for (std::string_view law : {"branchy", "simple"}) {
      if (probe.needs_friction && law == "simple") continue;
      const ProbeReading reading = probe.read(host_bench("fp64", law), probe.from);
      EXPECT_LE(reading.error, probe.right_within) << probe.name << ", " << law << ": " << reading.what;
    }
}

TEST(StabilityProbes, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Probe& probe : probes()) EXPECT_TRUE(names.insert(probe.name).second) << probe.name;
  EXPECT_THROW(probe_named("no_such"), InputError);
}

// No probe of the reference may end in anything but a number or a line, at the extreme of its range either.
TEST(StabilityProbes, EndInNumbersOrLines) {
  for (const Probe& probe : probes()) {
    if (probe.to_rest_steps) continue;
    for (std::string_view precision : {"fp32", "fp64"}) {
      const auto cell = find_cell(probe, host_bench(precision), {2, 0});
      ASSERT_EQ(cell.samples.size(), 2U) << probe.name;
      for (const auto& sample : cell.samples) {
        EXPECT_EQ(sample.verdict == Verdict::refused, !sample.error) << probe.name << ": " << sample.text;
        EXPECT_EQ(sample.text.find('\n'), std::string::npos) << probe.name;
        EXPECT_FALSE(sample.text.empty()) << probe.name;
      }
    }
  }
}

// E = 1e11 Pa, r = 1 mm: an overlap of 1.6 nm, which floats do not resolve 1 m from the origin; doubles do.
TEST(StabilityProbes, TellsFloatsFromDoublesByTheOverlapOfRest) {
  const Probe& probe = probe_named("static_overlap_at_1_m");
  EXPECT_THAT(probe.read(host_bench("fp64"), 1e11).what, HasSubstr("expected 1.578 nm"));
  EXPECT_EQ(find_cell(probe, host_bench("fp64"), {3, 0}).verdict, Verdict::right);
  const auto floats = find_cell(probe, host_bench("fp32"), {4, 4});
  EXPECT_NE(floats.verdict, Verdict::right);
  ASSERT_TRUE(floats.right_until);
  EXPECT_GT(*floats.right_until, 3e5);
  EXPECT_LT(*floats.right_until, 1e8);
}

// The same on a device, and 100 m away; `mixed` holds both.
TEST(StabilityProbes, MixedResolvesTheOverlapOfRestFarFromTheOrigin) {
  if (!backend("opencl").lacks().empty()) GTEST_SKIP() << backend("opencl").lacks();
  const auto verdict = [](std::string_view precision, std::string_view probe) {
    Variant variant;
    variant.set("precision", precision);
    return find_cell(probe_named(probe), {backend("opencl"), variant, {}, 200}, {2, 0}).verdict;
  };
  for (const char* probe : {"static_overlap_at_1_m", "static_overlap_at_100_m"}) {
    EXPECT_EQ(verdict("mixed", probe), Verdict::right) << probe;
    EXPECT_GE(verdict("fp32", probe), Verdict::refused) << probe;  // or wrong
  }
}

// What the flushing of subnormal floats takes away: all of the forces at once.
TEST(StabilityProbes, TellsWhereSubnormalFloatsAreFlushed) {
  if (!backend("opencl").lacks().empty()) GTEST_SKIP() << backend("opencl").lacks();
  const auto cell = [](std::string_view denormals) {
    Variant variant;
    variant.set("denormals", denormals);
    return find_cell(probe_named("subnormal"), {backend("opencl"), variant, {}, 200}, {3, 6});
  };
  const auto kept = cell("keep"), flushed = cell("flush");
  ASSERT_TRUE(kept.right_until && flushed.right_until);
  EXPECT_LT(*kept.right_until, *flushed.right_until);
}

TEST(StabilityProbes, RefusesMoreContactsThanSlots) {
  const auto cell = find_cell(probe_named("contacts"), host_bench("fp32"), {3, 6});
  EXPECT_EQ(cell.verdict, Verdict::refused);
  ASSERT_NE(first_not_right(cell), nullptr);
  EXPECT_THAT(first_not_right(cell)->text, HasSubstr("contact slots"));
}

TEST_F(Stability, WritesAnAtlasOfADevice) {
  ASSERT_EQ(call({"stability", "--backend", "opencl,host", "--axis", "precision=fp32", "--probe",
                  "overlap_large,contacts", "--samples", "3", "--halvings", "1", "--json", path("a.json"),
                  "--html", path("a.html")}),
            0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("4 refused"));
  EXPECT_THAT(read("a.html"), HasSubstr("overlap_large"));
  EXPECT_EQ(nlohmann::json::parse(read("a.json"))["cells"].size(), 4U);
  EXPECT_THAT(reports::run_python("validate.py",
                                  {source_path("docs/schemas/stability-1.schema.json"), path("a.json")}),
              testing::ElementsAre("valid"));
}

TEST_F(Stability, RefusesWrongCallsInOneLine) {
  const std::vector<std::vector<std::string>> calls{{"--probe", "no_such"},       {"--backend", "no_such"},
                                                    {"--axis", "precision=fp31"}, {"--rest-steps", "3"},
                                                    {"--samples", "1"},           {"--halvings", "-1"}};
  for (const auto& words : calls) {
    std::vector<std::string> whole{"stability"};
    whole.insert(whole.end(), words.begin(), words.end());
    EXPECT_EQ(call(whole), 2) << words[0] << " " << words[1];
    EXPECT_EQ(error_lines(), 1U) << err_;
  }
}

}  // namespace
}  // namespace warpgrain::cli
