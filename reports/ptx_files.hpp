#pragma once
// The PTX modules of a report as files beside it.

#include <filesystem>
#include <span>

#include "profiler/profile.hpp"
#include "reports/report.hpp"

namespace warpgrain::reports {

// Writes each module that the launches ran once: STEM.ptx beside `report_file` STEM.json, then STEM-2.ptx and
// so on. Notes the files' names at the launches of `report`, which was made of `launches`. Throws InputError
// when a file cannot be written.
void keep_ptx(Report& report, std::span<const profiler::LaunchProfile> launches,
              const std::filesystem::path& report_file);

}  // namespace warpgrain::reports
