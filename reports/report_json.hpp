#pragma once
// "warpgrain.report/1" as text and back.

#include <filesystem>
#include <string>

#include "reports/report.hpp"

namespace warpgrain::reports {

// The text of a source stands once, at the first launch that has it; later launches of the same source give
// its name and hash alone. Throws InputError naming a number that is not finite.
std::string report_json(const Report& report);

// Throws InputError naming the file and the place of what is missing, wrong or of another format or version.
Report read_report(const std::filesystem::path& file);

}  // namespace warpgrain::reports
