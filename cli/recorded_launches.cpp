#include "cli/recorded_launches.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>
#include <set>
#include <utility>

#include "cli/interrupt.hpp"
#include "cli/record_settings.hpp"
#include "core/error.hpp"
#include "profiler/compiled_launches.hpp"
#include "profiler/launch_file.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {
namespace {

// Counts launches that something is to be said of, by kernel and by what it is.
class Remarks {
 public:
  void add(const std::string& kernel, std::string remark) {
    for (auto& [known, count] : counts_)
      if (known.first == kernel && known.second == remark) {
        ++count;
        return;
      }
    counts_.push_back({{kernel, std::move(remark)}, 1});
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const auto& [what, count] : counts_)
      lines.push_back(
          fmt::format("{} launch{} of {}: {}", count, count == 1 ? "" : "es", what.first, what.second));
    return lines;
  }

 private:
  std::vector<std::pair<std::pair<std::string, std::string>, std::size_t>> counts_;
};

}  // namespace

// Launch files that the index lacks, and bytes of buffers under the names that they have until they are
// whole.
void remove_unfinished(const std::filesystem::path& folder) {
  std::set<std::string> whole;
  for (const RecordedLaunch& launch : read_index(folder)) whole.insert(launch.file);
  std::vector<std::filesystem::path> unfinished;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& path = entry.path();
    const bool is_launch = path.extension() == ".sim" && !whole.contains(path.filename().string());
    const bool is_buffer = path.filename().string().starts_with("buffer-") && path.has_extension();
    if (is_launch || is_buffer) unfinished.push_back(path);
  }
  for (const std::filesystem::path& path : unfinished) std::filesystem::remove(path);
}

RecordedProfiles profile_recorded(const std::filesystem::path& folder, profiler::ProfileOptions options,
                                  Progress& progress) {
  const std::vector<RecordedLaunch> recorded = read_index(folder);
  options.skip_unknown_keys = true;  // each kernel has branches of its own
  profiler::CompiledLaunches compiled;
  std::ostream nowhere(nullptr);  // the program has printed that already
  RecordedProfiles profiles;
  Remarks remarks;
  for (std::size_t k = 0; k < recorded.size(); ++k) {
    const RecordedLaunch& launch = recorded[k];
    if (launch.file.empty()) {
      remarks.add(launch.kernel, fmt::format("not profiled: {}", launch.remark));
      continue;
    }
    if (interrupted()) {
      profiles.interrupted = true;
      remarks.add(launch.kernel, "not profiled: interrupted");
      continue;
    }
    options.progress = [&](double fraction) {
      progress.update(fmt::format("simulating launch {} of {}", k + 1, recorded.size()), fraction);
    };
    try {
      profiler::LaunchFile file = profiler::read_launch_file(folder / launch.file);
      file.program_name = file.program.filename().string();
      profiles.launches.push_back(profile_launch_file(file, "", options, nowhere, compiled).profile);
      if (!launch.remark.empty()) remarks.add(launch.kernel, launch.remark);
    } catch (const InputError& error) {
      remarks.add(launch.kernel, fmt::format("not profiled: {}", error.what()));
    }
  }
  profiles.remarks = remarks.lines();
  try {
    if (!profiles.launches.empty()) require_answers(options.what_if, profiles.launches);
  } catch (const InputError& error) {  // the program has run, and what there is of it is worth showing
    profiles.remarks.emplace_back(error.what());
  }
  return profiles;
}

}  // namespace warpgrain::cli
