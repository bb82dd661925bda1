#pragma once

#include <string>

#include "reports/accuracy_report.hpp"

namespace warpgrain::reports {

// What each variant costs against how far it is off, level by level.
std::string accuracy_page(const AccuracyReport& report);

}  // namespace warpgrain::reports
