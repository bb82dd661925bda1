#include "reports/ptx_files.hpp"

#include <fmt/format.h>
#include <map>
#include <string>

#include "core/file_io.hpp"

namespace warpgrain::reports {

void keep_ptx(Report& report, std::span<const profiler::LaunchProfile> launches,
              const std::filesystem::path& report_file) {
  std::map<std::string, std::string> files;  // by hash
  for (std::size_t k = 0; k < launches.size(); ++k) {
    PtxModule& module = report.launches[k].ptx;
    const auto [place, is_new] = files.try_emplace(module.hash);
    if (is_new) {
      const std::string number = files.size() == 1 ? "" : fmt::format("-{}", files.size());
      place->second = fmt::format("{}{}.ptx", report_file.stem().string(), number);
      write_file_atomically(report_file.parent_path() / place->second, launches[k].ptx);
    }
    module.file = place->second;
  }
}

}  // namespace warpgrain::reports
