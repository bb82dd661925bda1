#pragma once
// What Nsight Compute prints with `--csv --page raw`: a row of metrics a kernel launch.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace warpgrain::reports {

struct NcuLaunch {
  std::string kernel;                     // its name without parameters
  std::map<std::string, double> metrics;  // by ncu's names; what is not a number is left out
};

// In the order of the launches. Lines that other programs printed between are passed over. Throws InputError
// when there is no table of the raw page in the file, or a row does not fit its heading.
std::vector<NcuLaunch> read_ncu_csv(const std::filesystem::path& file);

// Those of a kernel's metrics that a report has too and that add up, by the keys of reports/metrics.hpp.
std::map<std::string, double> counters_of(const NcuLaunch& launch);

// ncu's names of all such metrics, each once.
std::vector<std::string> ncu_metrics();

}  // namespace warpgrain::reports
