#include "cli/measure_counters.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "profiler/subprocess.hpp"
#include "reports/ncu_csv.hpp"

namespace warpgrain::cli {
namespace {

std::string find_ncu() {
  if (const std::filesystem::path on_path = profiler::find_program("ncu"); !on_path.empty()) return on_path;
  const std::filesystem::path usual = "/usr/local/cuda/bin/ncu";
  if (std::filesystem::exists(usual)) return usual;
  throw_input_error("--counters", "no ncu on PATH and none in /usr/local/cuda/bin", "Nsight Compute");
}

}  // namespace

void count_with_ncu(const std::vector<std::string>& words, reports::MeasuredReport& report) {
  const profiler::TemporaryFolder folder;
  const std::string csv = folder.path() / "counters.csv";
  std::vector<std::string> call{find_ncu(),
                                "--csv",
                                "--page",
                                "raw",
                                "--clock-control",
                                "none",
                                "--profile-from-start",
                                "off",
                                "--metrics",
                                fmt::format("{}", fmt::join(reports::ncu_metrics(), ",")),
                                "--log-file",
                                csv,
                                std::filesystem::read_symlink("/proc/self/exe")};
  call.insert(call.end(), words.begin(), words.end());
  const profiler::ProcessResult result = profiler::run_process(call);
  if (result.exit_status != 0)
    throw InputError(fmt::format("--counters: ncu ended with status {}\n{}{}", result.exit_status,
                                 result.errors, profiler::read_text(csv)));
  for (const reports::NcuLaunch& launch : reports::read_ncu_csv(csv)) {
    const auto kernel =
        std::ranges::find(report.kernels, launch.kernel, &reports::MeasuredReport::Kernel::kernel);
    if (kernel == report.kernels.end()) continue;
    for (const auto& [key, value] : counters_of(launch)) kernel->counters[key] += value;
  }
}

}  // namespace warpgrain::cli
