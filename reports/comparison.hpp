#pragma once
// Two documents side by side, kernel by kernel and metric by metric; and a sweep's order of variants beside
// the measured one. Format "warpgrain.comparison/1".

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/prediction_error.hpp"
#include "analysis/rank_correlation.hpp"
#include "reports/generator.hpp"
#include "reports/measured_report.hpp"
#include "reports/sweep_index.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view comparison_format = "warpgrain.comparison/1";

// What a document says of a kernel: metrics by the keys of reports/metrics.hpp, `launches` of it that they
// are the sums of, and `seconds`: measured ones (median), of a report those predicted.
struct KernelQuantities {
  std::string kernel;
  std::map<std::string, double> values;
};

// Of "warpgrain.report/1" or "warpgrain.measured/1", Google Benchmark's JSON (each benchmark a kernel) or
// `ncu --csv --page raw`: by what is in the file. The whole step of a measurement is the kernel "step".
// Throws InputError for other files.
std::vector<KernelQuantities> quantities_of(const std::filesystem::path& file);

struct Difference {
  std::string kernel, metric;
  double base = 0, other = 0;
  // other / base - 1; nothing where the base alone is 0.
  std::optional<double> relative() const;
};

// The order of a sweep's variants by what the simulator says, and by measured time. By predicted time where
// every variant has one, else by the warp instructions of a step.
struct OrderComparison {
  struct Row {
    std::string variant;
    double warp_instructions = 0;
    std::optional<double> predicted_seconds;
    double seconds = 0;  // of a step, median
  };
  std::vector<Row> rows;
  bool by_time = false;
  std::optional<double> tau;
  std::optional<TauInterval> interval;  // where every variant has several readings
  // Of predicted times.
  std::optional<PredictionError> error;
  std::optional<LeftOut> left_out;
};

struct Comparison {
  Generator generator;
  std::string command_line;
  std::string base, other;  // files
  std::vector<Difference> differences;
  std::vector<std::string> only_in_base, only_in_other;  // kernels
  std::optional<OrderComparison> order;
};

// Kernels in the order of `other`, metrics in that of the table. `metrics`: those that count; none: all that
// both have.
Comparison compare(const std::vector<KernelQuantities>& base, const std::vector<KernelQuantities>& other,
                   std::span<const std::string> metrics);

// The variants of the sweep that one of the measurements is of. Throws InputError when there are fewer than
// two.
OrderComparison compare_order(const SweepIndex& sweep, std::span<const MeasuredReport> measured);

// The largest relative difference there is, and infinity where one has no number; 0 for none.
double largest_difference(const Comparison& comparison);

// Throws InputError naming a number that is not finite.
std::string comparison_json(const Comparison& comparison);

// Throws InputError naming the file and the place of what is missing, wrong or of another format or version.
Comparison read_comparison(const std::filesystem::path& file);
std::string text_comparison(const Comparison& comparison);

}  // namespace warpgrain::reports
