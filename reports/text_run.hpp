#pragma once
// A run on a terminal: what ran where, how fast, the energies at both ends, the contacts.

#include <string>

#include "reports/run_report.hpp"

namespace warpgrain::reports {

std::string text_run(const RunReport& run);

}  // namespace warpgrain::reports
