#pragma once
// Timings in the JSON of Google Benchmark's --benchmark_out, which many tools read.

#include <filesystem>
#include <string>
#include <vector>

#include "reports/measured_report.hpp"

namespace warpgrain::reports {

// "step" and each kernel by its name, a repetition a reading. Throws InputError naming a number that is not
// finite.
std::string benchmark_json(const MeasuredReport& measured);

struct BenchmarkTimes {
  std::string name;             // without aggregates' suffixes
  std::vector<double> seconds;  // real time of an iteration, a repetition each
};

// Any program's; aggregates are left out where repetitions are there. Throws InputError naming the place of
// what is missing or wrong.
std::vector<BenchmarkTimes> read_benchmark_json(const std::filesystem::path& file);

}  // namespace warpgrain::reports
