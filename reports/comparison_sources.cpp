#include <algorithm>

#include "analysis/statistics.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/benchmark_json.hpp"
#include "reports/comparison.hpp"
#include "reports/json_fields.hpp"
#include "reports/ncu_csv.hpp"
#include "reports/report_json.hpp"
#include "reports/summary.hpp"

namespace warpgrain::reports {
namespace {

constexpr const char* launches = "launches";
constexpr const char* seconds = "seconds";

KernelQuantities& of_kernel(std::vector<KernelQuantities>& all, const std::string& kernel) {
  const auto found = std::ranges::find(all, kernel, &KernelQuantities::kernel);
  return found == all.end() ? all.emplace_back(KernelQuantities{kernel, {}}) : *found;
}

std::vector<KernelQuantities> of_report(const Report& report) {
  std::vector<KernelQuantities> all;
  for (const KernelSummary& kernel : kernels_of(report)) {
    const profiler::Totals& t = kernel.counters.totals;
    std::map<std::string, double>& values = of_kernel(all, kernel.counters.kernel).values;
    const auto add = [&values](const char* key, std::uint64_t count) {
      values[key] += static_cast<double>(count);
    };
    add(launches, kernel.launches);
    if (kernel.predicted) values[seconds] += kernel.predicted->seconds;
    add("warp_instructions", t.warp_instructions);
    add("thread_instructions", t.thread_instructions);
    if (t.thread_instructions_pred_on != 0) add("thread_instructions_pred_on", t.thread_instructions_pred_on);
    add("branches", t.branches);
    add("divergent_branches", t.divergent_branches);
    add("sfu_instructions", t.sfu_instructions);
    add("global_load_requests", t.global_load.requests);
    add("global_load_sectors", t.global_load.sectors);
    add("global_store_requests", t.global_store.requests);
    add("global_store_sectors", t.global_store.sectors);
    add("shared_load_requests", t.shared_load.requests);
    add("shared_store_requests", t.shared_store.requests);
  }
  return all;
}

std::vector<KernelQuantities> of_measured(const MeasuredReport& measured) {
  std::vector<KernelQuantities> all;
  if (measured.step) all.push_back({"step", {{seconds, median(measured.step->seconds)}}});
  for (const MeasuredReport::Kernel& kernel : measured.kernels) {
    std::map<std::string, double>& values = of_kernel(all, kernel.kernel).values;
    values[launches] += static_cast<double>(kernel.calls);
    values[seconds] += median(kernel.seconds);
    for (const auto& [key, value] : kernel.counters) values[key] += value;
  }
  return all;
}

std::vector<KernelQuantities> of_benchmarks(const std::filesystem::path& file) {
  std::vector<KernelQuantities> all;
  for (const BenchmarkTimes& times : read_benchmark_json(file))
    all.push_back({times.name, {{seconds, median(times.seconds)}}});
  return all;
}

std::vector<KernelQuantities> of_ncu(const std::filesystem::path& file) {
  std::vector<KernelQuantities> all;
  for (const NcuLaunch& launch : read_ncu_csv(file)) {
    std::map<std::string, double>& values = of_kernel(all, launch.kernel).values;
    values[launches] += 1;
    for (const auto& [key, value] : counters_of(launch)) values[key] += value;
  }
  return all;
}

// What follows from sums.
void add_efficiency(std::vector<KernelQuantities>& all) {
  for (KernelQuantities& kernel : all) {
    const auto warps = kernel.values.find("warp_instructions"),
               threads = kernel.values.find("thread_instructions");
    if (warps != kernel.values.end() && threads != kernel.values.end() && warps->second > 0)
      kernel.values["active_lanes"] = threads->second / warps->second;
  }
}

std::vector<KernelQuantities> of_any(const std::filesystem::path& file) {
  const std::string text = read_text_file(file, document_size_limit);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw_input_error(file.string(), "an empty file",
                      "a report, a measurement, Google Benchmark's JSON or ncu's CSV");
  if (text[text.find_first_not_of(" \t\r\n")] != '{') return of_ncu(file);
  const JsonReader root = JsonReader::parse(text, file.string());
  if (root.has("benchmarks")) return of_benchmarks(file);
  const JsonReader format = root.at("format");
  if (format.string() == report_format) return of_report(read_report(file));
  if (format.string() == measured_format) return of_measured(read_measured(file));
  format.fail("'" + format.string() + "'", "'" + std::string(report_format) + "', '" +
                                               std::string(measured_format) +
                                               "', Google Benchmark's JSON or ncu --csv --page raw");
}

}  // namespace

std::vector<KernelQuantities> quantities_of(const std::filesystem::path& file) {
  std::vector<KernelQuantities> all = of_any(file);
  add_efficiency(all);
  return all;
}

}  // namespace warpgrain::reports
