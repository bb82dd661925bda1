#pragma once

#include <string>

#include "reports/paper_report.hpp"

namespace warpgrain::reports {

// The paper's tables in four columns, and how candidates, contacts and efficiency change from falling to
// rest.
std::string paper_page(const PaperReport& report);

}  // namespace warpgrain::reports
