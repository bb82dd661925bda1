#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/metrics.hpp"
#include "reports/report_json.hpp"
#include "sample.hpp"
#include "tests/paths.hpp"

namespace warpgrain::reports {
namespace {

TEST(Metrics, StandInTheDocsAsInTheTable) {
  const std::string docs = read_text_file(source_path("docs/report-format.md"), 1 << 20);
  for (const Metric& m : metrics()) {
    const std::string row = fmt::format("| `{}` | {} | {} | {} |\n", m.key, m.unit, m.definition,
                                        m.ncu_metric.empty() ? "" : fmt::format("`{}`", m.ncu_metric));
    EXPECT_NE(docs.find(row), std::string::npos) << row;
  }
}

TEST(Metrics, CoverEveryTotalOfAReport) {
  std::set<std::string> keys;
  for (const Metric& m : metrics()) EXPECT_TRUE(keys.emplace(m.key).second) << m.key << " twice";
  const auto report = nlohmann::ordered_json::parse(report_json(sample::report()));
  for (const auto& [key, value] : report["launches"][0]["totals"].items())
    EXPECT_TRUE(keys.count(key)) << key;
}

TEST(Metrics, UnknownOnesAreNamedWithTheValidOnes) {
  try {
    metric("occupancy");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("unknown metric 'occupancy'; valid: warp_instructions, "));
  }
}

}  // namespace
}  // namespace warpgrain::reports
