#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/benchmark_json.hpp"
#include "sample.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(BenchmarkJson, OursIsReadBack) {
  const TemporaryFolder folder;
  const MeasuredReport measured = sample::measured();
  write_file_atomically(folder / "b.json", benchmark_json(measured));
  const auto times = read_benchmark_json(folder / "b.json");
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].name, "step");
  EXPECT_THAT(times[0].seconds, ElementsAre(DoubleEq(1e-3), DoubleEq(1.5e-3), DoubleEq(1.25e-3)));
  EXPECT_EQ(times[1].name, "force");
}

// As Google Benchmark 1.7 writes them.
TEST(BenchmarkJson, OthersAreRead) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "b.json", R"({"context": {"date": "2026"}, "benchmarks": [
    {"name": "BM_a/8_mean", "run_name": "BM_a/8", "run_type": "aggregate", "aggregate_name": "mean",
     "real_time": 9, "time_unit": "us"},
    {"name": "BM_a/8_median", "run_name": "BM_a/8", "run_type": "aggregate", "aggregate_name": "median",
     "real_time": 3, "time_unit": "us"},
    {"name": "BM_b", "run_name": "BM_b", "run_type": "iteration", "real_time": 2, "time_unit": "ms"},
    {"name": "BM_b_median", "run_name": "BM_b", "run_type": "aggregate", "aggregate_name": "median",
     "real_time": 5, "time_unit": "ms"},
    {"name": "BM_c", "error_occurred": true, "error_message": "no device"}]})");
  const auto times = read_benchmark_json(folder / "b.json");
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].name, "BM_b");
  EXPECT_THAT(times[0].seconds, ElementsAre(DoubleEq(2e-3)));
  EXPECT_EQ(times[1].name, "BM_a/8");
  EXPECT_THAT(times[1].seconds, ElementsAre(DoubleEq(3e-6)));
  write_file_atomically(folder / "b.json",
                        R"({"benchmarks": [{"name": "x", "real_time": 1, "time_unit": "h"}]})");
  EXPECT_THROW(read_benchmark_json(folder / "b.json"), InputError);
}

}  // namespace
}  // namespace warpgrain::reports
